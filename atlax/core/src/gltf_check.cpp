#include "gltf_check.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

namespace atlax::detail {

namespace {

using Json = nlohmann::json;

constexpr int deepest = 64;

[[noreturn]] void refuseGltf(const std::string& name, const std::string& reason) {
    throw Error(name + ": " + reason);
}

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    return word;
}

/// All of a plain file; of a binary one its first chunk.
std::string_view jsonOf(std::span<const std::byte> bytes, const std::string& name) {
    constexpr std::string_view magic = "glTF";
    constexpr std::size_t headers = 20;  // of the file and of its first chunk
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!text.starts_with(magic)) return text;
    if (bytes.size() < headers || wordAt(bytes, 12) > bytes.size() - headers)
        refuseGltf(name, "cannot be read: it is cut off");
    return text.substr(headers, wordAt(bytes, 12));
}

bool isBase64(std::string_view text) {
    const auto letter = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
               c == '+' || c == '/';
    };
    if (text.size() % 4 != 0) return false;
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    return std::all_of(text.begin(), text.end(), letter);
}

void checkUris(const Json& document, const char* list, const std::string& name) {
    const auto found = document.find(list);
    if (found == document.end() || !found->is_array()) return;
    for (const Json& entry : *found) {
        if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
        const std::string& uri = entry["uri"].get_ref<const std::string&>();
        constexpr std::string_view mark = ";base64,";
        const std::size_t at = uri.find(mark);
        if (!uri.starts_with("data:") || at == std::string::npos) continue;
        if (!isBase64(std::string_view(uri).substr(at + mark.size())))
            refuseGltf(name, std::string("has base64 in its \"") + list + "\" that is none");
    }
}

}  // namespace

void checkGltf(std::span<const std::byte> bytes, const std::string& name) {
    const auto bounded = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest)
            refuseGltf(name, "is nested deeper than " + std::to_string(deepest) + " levels");
        return true;
    };
    Json document;
    try {
        document = Json::parse(jsonOf(bytes, name), bounded);
    } catch (const Json::exception& error) {
        refuseGltf(name, std::string("cannot be read: ") + error.what());
    }
    if (!document.is_object()) refuseGltf(name, "cannot be read: it holds no JSON object");
    for (const char* list : {"buffers", "images"}) checkUris(document, list, name);
}

}  // namespace atlax::detail
