#include "share_text.hpp"

#include <atlax/base64.hpp>
#include <atlax/compression.hpp>
#include <atlax/error.hpp>
#include <charconv>
#include <optional>
#include <span>
#include <stdexcept>

#include "words.hpp"

namespace sulfurchamber {
namespace {

constexpr std::string_view sharePrefix = "sulfur-scene-";
constexpr int shareVersion = 1;
constexpr std::size_t mostShared = std::size_t{64} << 20;  // bytes of the scene's text

[[noreturn]] void refuseShared(const std::string& why) {
    throw std::runtime_error(tr("the text holds no scene that can be used: {}", {tr(why)}));
}

// What stands after the prefix: the version and a colon; nothing where it is no such word.
struct SharedPlace {
    int version = 0;
    std::size_t begin = 0;
};
std::optional<SharedPlace> findShared(std::string_view text) {
    for (std::size_t at = text.find(sharePrefix); at != std::string_view::npos;
         at = text.find(sharePrefix, at + 1)) {
        const char* first = text.data() + at + sharePrefix.size();
        SharedPlace place;
        const auto [end, error] = std::from_chars(first, text.data() + text.size(), place.version);
        if (error != std::errc{} || end == text.data() + text.size() || *end != ':') continue;
        place.begin = static_cast<std::size_t>(end - text.data()) + 1;
        return place;
    }
    return std::nullopt;
}

}  // namespace

// The length stands first, so that what was cut off is told apart from what was changed.
std::string shareText(const sulfur::scene::Scene& scene) {
    const std::string text = sulfur::scene::format(scene);
    const auto packed = atlax::compress(std::as_bytes(std::span(text)), 19);
    return std::string(sharePrefix) + std::to_string(shareVersion) + ":" +
           std::to_string(packed.size()) + ":" + atlax::toBase64(packed);
}

bool isShareText(std::string_view text) {
    return findShared(text).has_value();
}

sulfur::scene::Scene parseShareText(std::string_view text) {
    const auto place = findShared(text);
    if (!place) refuseShared("\"sulfur-scene-1:\" is missing at its beginning");
    if (place->version != shareVersion)
        refuseShared(tr("it is of version {}; this program reads version 1",
                        {std::to_string(place->version)}));
    const std::string_view rest = text.substr(place->begin);
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), length);
    if (error != std::errc{} || end == rest.data() + rest.size() || *end != ':')
        refuseShared("its length is missing");
    auto packed = atlax::fromBase64(rest.substr(static_cast<std::size_t>(end - rest.data()) + 1));
    if (packed.size() < length)
        refuseShared(tr("it is cut short: {} of {} bytes are there",
                        {std::to_string(packed.size()), std::to_string(length)}));
    packed.resize(length);  // words that follow look like it
    std::vector<std::byte> bytes;
    try {
        bytes = atlax::decompress(packed, mostShared);
    } catch (const atlax::Error&) {
        refuseShared("it was changed on its way");
    }
    return sulfur::scene::parse({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                                tr("the shared scene"));
}

}  // namespace sulfurchamber
