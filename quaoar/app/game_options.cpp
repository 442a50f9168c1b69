// What the player sets: language, sound, picture, play.
#include <algorithm>
#include <array>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <cmath>

#include "game.hpp"

namespace quaoar {

namespace {

/// Each language in its own words, so that whoever is lost in another one finds it.
std::string languageName(const Texts& texts) {
    const std::string& code = texts.language();
    if (code.empty()) return texts("as the system has it");
    if (code == "en") return "English";
    if (code == "de") return "Deutsch";
    if (code == "it") return "Italiano";
    return code;
}

/// The value one on or back in a round of values; the nearest counts as the present one.
template <std::size_t count>
int nextOf(const std::array<int, count>& values, int now, int way) {
    std::size_t here = 0;
    for (std::size_t i = 1; i < count; ++i)
        if (std::abs(values[i] - now) < std::abs(values[here] - now)) here = i;
    return values[(here + count + static_cast<std::size_t>(way > 0 ? 1 : count - 1)) % count];
}

constexpr std::array<int, 11> percents{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
constexpr std::array<int, 7> speedSteps{70, 75, 80, 85, 90, 95, 100};
constexpr std::array<int, 6> windowHeights{360, 540, 720, 900, 1080, 1440};

std::string percentText(int percent) {
    return std::to_string(percent) + " %";
}

/// An item that changes one on when it is chosen.
MenuItem changing(std::string label, std::function<void(int)> change) {
    return {std::move(label), [change] { change(1); }, change};
}

}  // namespace

std::vector<MenuItem> Game::optionItems() {
    return {changing(texts_("Language: {}", {languageName(texts_)}),
                     [this](int way) { nextLanguage(way); }),
            {texts_("Sound"), [this] { show(Screen::sound); }},
            {texts_("Picture"), [this] { show(Screen::picture); }},
            {texts_("Game"), [this] { show(Screen::play); }},
            {texts_("Controls"), [this] { show(Screen::controls); }},
            {texts_("Back"), [this] { leaveWithPause(); }}};
}

std::vector<MenuItem> Game::soundItems() {
    return {volume("Effects: {}", atlax::Bus::Effects),
            volume("Music: {}", atlax::Bus::Music),
            volume("Menus: {}", atlax::Bus::Interface),
            {texts_("Back"), [this] { leaveWithPause(); }}};
}

std::vector<MenuItem> Game::pictureItems() {
    const std::string full = platform_->fullscreen() ? texts_("on") : texts_("off");
    return {changing(texts_("Fullscreen: {}", {full}), [this](int) { toggleFullscreen(); }),
            windowSizes(),
            toggle("Wait for the screen (vsync): {}", Choice::vsync),
            toggle("Screen shake: {}", Choice::shake),
            toggle("Flashes: {}", Choice::flashes),
            toggle("High contrast: {}", Choice::highContrast),
            {texts_("Back"), [this] { leaveWithPause(); }}};
}

std::vector<MenuItem> Game::playItems() {
    return {speeds(),
            toggle("Rope by one press, off by the next: {}", Choice::toggleRope),
            toggle("Help with aiming: {}", Choice::aimAssist),
            toggle("Count-in after a pause: {}", Choice::countIn),
            ghosts(),
            toggle("All levels open: {}", Choice::unlockAll),
            {texts_("Back"), [this] { leaveWithPause(); }}};
}

MenuItem Game::toggle(const char* label, Choice choice) {
    const bool now = preferences_.on(choice);
    return changing(texts_(label, {now ? texts_("on") : texts_("off")}), [this, choice, now](int) {
        preferences_.set(choice, !now);
        redo();
    });
}

MenuItem Game::volume(const char* label, atlax::Bus bus) {
    const int now = preferences_.volume(bus);
    return changing(texts_(label, {percentText(now)}), [this, bus, now](int way) {
        preferences_.setVolume(bus, nextOf(percents, now, way));
        redo();
    });
}

MenuItem Game::speeds() {
    const int now = preferences_.speed();
    return changing(texts_("Speed of the game: {}", {percentText(now)}), [this, now](int way) {
        preferences_.setSpeed(nextOf(speedSteps, now, way));
        redo();
    });
}

MenuItem Game::windowSizes() {
    const atlax::Vec2 size = platform_->size().toVec() / platform_->scaleFactor();
    const int width = static_cast<int>(std::lround(size.x));
    const int height = static_cast<int>(std::lround(size.y));
    const std::string text = std::to_string(width) + " x " + std::to_string(height);
    return changing(texts_("Window: {}", {text}), [this, height](int way) {
        if (platform_->fullscreen()) return tell(texts_("The window has no size in fullscreen"));
        const int next = nextOf(windowHeights, height, way);
        platform_->setWindowSize({next * 16 / 9, next});
        redo();
    });
}

MenuItem Game::ghosts() {
    const GhostChoice now = preferences_.ghost();
    const char* name = now == GhostChoice::none   ? "none"
                       : now == GhostChoice::best ? "own best run"
                                                  : "gold";
    return changing(texts_("Ghost: {}", {texts_(name)}), [this, now](int way) {
        const int next = (static_cast<int>(now) + 3 + (way > 0 ? 1 : -1)) % 3;
        preferences_.setGhost(static_cast<GhostChoice>(next));
        redo();
    });
}

/// After a change: it takes effect, is kept, and is seen in the menu.
void Game::redo() {
    applyOptions();
    savePreferences();
    show(screen_, menu_.selected());
}

void Game::applyOptions() {
    const auto apply = [&](atlax::Bus bus) {
        platform_->audio().setBusVolume(bus, static_cast<float>(preferences_.volume(bus)) / 100);
    };
    apply(atlax::Bus::Effects);
    apply(atlax::Bus::Music);
    apply(atlax::Bus::Interface);
    platform_->audio().setBusVolume(
        atlax::Bus::Ambience, static_cast<float>(preferences_.volume(atlax::Bus::Effects)) / 100);
    platform_->setVsync(preferences_.on(Choice::vsync));
    controls_.setToggle(preferences_.on(Choice::toggleRope));
}

void Game::chooseLanguage(const std::string& language) {
    try {
        texts_.setLanguage(language);
    } catch (const atlax::Error& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
}

void Game::nextLanguage(int way) {
    chooseLanguage(texts_.nextLanguage(way));
    preferences_.setLanguage(texts_.language());
    redo();
}

void Game::toggleFullscreen() {
    platform_->setFullscreen(!platform_->fullscreen());
    preferences_.set(Choice::fullscreen, platform_->fullscreen());
    if (screen_ == Screen::picture) show(Screen::picture, menu_.selected());
}

void Game::savePreferences() {
    if (platform_ != nullptr && !platform_->fullscreen() && !platform_->minimised()) {
        const atlax::Vec2 size = platform_->size().toVec() / platform_->scaleFactor();
        preferences_.setWindowSize(
            {static_cast<int>(std::lround(size.x)), static_cast<int>(std::lround(size.y))});
    }
    preferences_.setBindings(actions_);
    preferences_.save();
}

}  // namespace quaoar
