#include <algorithm>
#include <sulfur/scene/document.hpp>
#include <sulfur/scene/extra.hpp>

namespace sulfur::scene {

namespace {

auto hasKey(std::string_view key) {
    return [key](const ExtraMember& member) { return member.key == key; };
}

}  // namespace

const ExtraMember* findExtra(const Extra& extra, std::string_view key) {
    const auto found = std::find_if(extra.begin(), extra.end(), hasKey(key));
    return found == extra.end() ? nullptr : &*found;
}

void setExtra(Extra& extra, std::string_view key, std::string json) {
    const auto document =
        Document::parse(json, {.file = "value", .firstLine = 1, .object = std::string(key)});
    json = std::string(document.root().text());
    const auto found = std::find_if(extra.begin(), extra.end(), hasKey(key));
    if (found == extra.end()) {
        extra.push_back({std::string(key), std::move(json), 0});
    } else {
        *found = {std::string(key), std::move(json), 0};
    }
}

void eraseExtra(Extra& extra, std::string_view key) {
    std::erase_if(extra, hasKey(key));
}

}  // namespace sulfur::scene
