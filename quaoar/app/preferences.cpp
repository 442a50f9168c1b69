#include "preferences.hpp"

#include <array>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cctype>
#include <quaoar/view/player_actions.hpp>

namespace quaoar {
namespace {

struct ChoiceKey {
    const char* key;
    bool atFirst;
};

/// In the order of Choice.
constexpr std::array<ChoiceKey, 9> choiceKeys{{{"window.fullscreen", false},
                                               {"window.vsync", true},
                                               {"picture.shake", true},
                                               {"picture.flashes", true},
                                               {"picture.high_contrast", false},
                                               {"play.toggle_rope", false},
                                               {"play.aim_assist", false},
                                               {"play.count_in", true},
                                               {"play.unlock_all", false}}};

const ChoiceKey& keyOf(Choice choice) {
    return choiceKeys[static_cast<std::size_t>(choice)];
}

const char* volumeKey(atlax::Bus bus) {
    switch (bus) {
        case atlax::Bus::Music:
            return "sound.music";
        case atlax::Bus::Interface:
            return "sound.interface";
        case atlax::Bus::Effects:
        case atlax::Bus::Ambience:
            break;
    }
    return "sound.volume";
}

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

bool Preferences::on(Choice choice) const {
    return settings_.get(keyOf(choice).key, keyOf(choice).atFirst);
}

void Preferences::set(Choice choice, bool on) {
    settings_.set(keyOf(choice).key, on);
}

int Preferences::volume(atlax::Bus bus) const {
    return settings_.get(volumeKey(bus), 100, 0, 100);
}

void Preferences::setVolume(atlax::Bus bus, int percent) {
    settings_.set(volumeKey(bus), percent);
}

GhostChoice Preferences::ghost() const {
    return static_cast<GhostChoice>(settings_.get("play.ghost", 1, 0, 2));
}

double Preferences::formerBest(const std::string& level) const {
    constexpr double longest = 1e6;
    return settings_.get(bestKey(level), 0.0, 0.0, longest);
}

void Preferences::readBindings(PlayerActions& actions) const {
    for (const std::string& problem : actions.all.load(settings_))
        atlax::log(atlax::LogLevel::Warning, problem);
    actions.mend();
}

void Preferences::setBindings(const PlayerActions& actions) {
    actions.all.save(settings_);
}

}  // namespace quaoar
