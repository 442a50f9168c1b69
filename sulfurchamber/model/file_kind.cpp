#include "file_kind.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

#include "words.hpp"

namespace sulfurchamber {
namespace {

constexpr std::size_t headBytes = 4096;

std::string_view withoutSpace(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // mark of UTF-8
    const auto first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

}  // namespace

FileKind kindOfBytes(std::string_view head) {
    if (head.starts_with("\x89PNG\r\n") || head.starts_with("\xFF\xD8\xFF"))
        return FileKind::picture;
    if (head.starts_with("\x1F\x8B")) return FileKind::drawing;  // svgz
    const std::string_view text = withoutSpace(head);
    const bool tags = text.starts_with('<') && text.find("<svg") != std::string_view::npos;
    // Comments and a document type may be longer than the head.
    if (tags || text.starts_with("<?xml")) return FileKind::drawing;
    if (!text.starts_with('{')) return FileKind::other;
    if (text.find("\"sulfur-blueprint\"") != std::string_view::npos) return FileKind::blueprint;
    if (text.find("\"sulfur-scene\"") != std::string_view::npos) return FileKind::scene;
    // Its members are in the order of the alphabet.
    if (text.find("\"allowSleep\"") != std::string_view::npos ||
        text.find("\"continuousPhysics\"") != std::string_view::npos)
        return FileKind::rube;
    return FileKind::other;
}

FileKind kindOfFile(const std::filesystem::path& file) {
    // Opening a pipe would wait for its other end.
    if (!std::filesystem::is_regular_file(file))
        throw std::runtime_error(file.string() + ": " + tr("is no file that can be read"));
    std::ifstream stream(file, std::ios::binary);
    std::string head(headBytes, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (stream.bad() || (!stream && !stream.eof()))
        throw std::runtime_error(file.string() + ": " + tr("cannot be read"));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return kindOfBytes(head);
}

}  // namespace sulfurchamber
