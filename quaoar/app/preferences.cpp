#include "preferences.hpp"

#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cctype>
#include <quaoar/view/player_actions.hpp>

namespace quaoar {
namespace {

/// Levels have any names, keys do not.
std::string bestKey(const std::string& level) {
    constexpr std::size_t longest = 50;
    std::string key = "best.";
    for (const char c : level.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        key += byte < 128 && std::isalnum(byte) != 0 ? static_cast<char>(std::tolower(byte)) : '-';
    }
    return key;
}

}  // namespace

Preferences::Preferences(const std::filesystem::path& file) : settings_({.file = file}) {
    settings_.load();
}

std::filesystem::path Preferences::settingsFile() {
    return atlax::configFolder("quaoar") / "settings.json";
}

atlax::PixelSize Preferences::windowSize() const {
    return {settings_.get("window.width", 1280, 64, 8192),
            settings_.get("window.height", 720, 64, 8192)};
}

void Preferences::setWindowSize(atlax::PixelSize size) {
    settings_.set("window.width", size.width);
    settings_.set("window.height", size.height);
}

double Preferences::best(const std::string& level) const {
    constexpr double longest = 1e6;
    return settings_.get(bestKey(level), 0.0, 0.0, longest);
}

void Preferences::setBest(const std::string& level, double seconds) {
    settings_.set(bestKey(level), seconds);
}

void Preferences::readBindings(PlayerActions& actions) const {
    for (const std::string& problem : actions.all.load(settings_))
        atlax::log(atlax::LogLevel::Warning, problem);
}

void Preferences::setBindings(const PlayerActions& actions) {
    actions.all.save(settings_);
}

}  // namespace quaoar
