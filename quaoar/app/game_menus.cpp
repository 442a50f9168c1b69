// Screens, what can be chosen on them, and what the player sets there.
#include <algorithm>
#include <array>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <cmath>

#include "game.hpp"
#include "overlay.hpp"

namespace quaoar {

using atlax::Binding;

namespace {

/// In the order of PlayerActions.
constexpr std::array<const char*, PlayerActions::changeable> actionNames{
    "Fire", "Reel in", "Reel out", "Reel fast", "Swing left", "Swing right", "Try again", "Pause"};

/// Each language in its own words, so that whoever is lost in another one finds it.
std::string languageName(const Texts& texts) {
    const std::string& code = texts.language();
    if (code.empty()) return texts("as the system has it");
    if (code == "en") return "English";
    if (code == "de") return "Deutsch";
    return code;
}

bool ofPad(const Binding& binding) {
    return binding.device == Binding::Device::PadButton ||
           binding.device == Binding::Device::PadAxis;
}

/// "W, Up, LeftTrigger+"
std::string bindingNames(const std::vector<Binding>& bindings) {
    std::string names;
    for (const Binding& binding : bindings) {
        const std::string text = binding.text();
        names += (names.empty() ? "" : ", ") + text.substr(text.find(':') + 1);
    }
    return names.empty() ? "-" : names;
}

}  // namespace

void Game::show(Screen screen, std::size_t selected) {
    if (screen == Screen::options && screen_ < Screen::options) below_ = screen_;
    screen_ = screen;
    menu_ = Menu(itemsOf(screen), selected);
    const bool playing = screen == Screen::playing;
    actions_.all.setContext(playing ? "play" : screen == Screen::capture ? "capture" : "menu");
    if (!playing) sounds_->hush();
    platform_->setCursorVisible(!playing);
}

std::vector<MenuItem> Game::itemsOf(Screen screen) {
    const MenuItem again{texts_("Play again"), [this] { play(); }};
    const MenuItem options{texts_("Options"), [this] { show(Screen::options); }};
    const MenuItem title{texts_("Title screen"), [this] { toTitle(); }};
    const MenuItem quit{texts_("Quit"), [this] { platform_->quit(); }};
    switch (screen) {
        case Screen::title:
            return {{texts_("Play"), [this] { play(); }}, options, quit};
        case Screen::paused:
            return {{texts_("Go on"), [this] { show(Screen::playing); }},
                    {texts_("Try again"), [this] { play(); }},
                    options,
                    title,
                    quit};
        case Screen::finished:
            return {again,
                    {texts_("Watch replay"),
                     [this] { watch(watching() ? options_.replay : lastRun_); }},
                    title,
                    quit};
        case Screen::options:
            return optionItems();
        case Screen::bindings:
            return bindingItems();
        case Screen::playing:
        case Screen::capture:
            break;
    }
    return {};
}

std::vector<MenuItem> Game::optionItems() {
    const std::string volume = std::to_string(preferences_.volume()) + " %";
    const std::string full = platform_->fullscreen() ? texts_("on") : texts_("off");
    return {{texts_("Language: {}", {languageName(texts_)}), [this] { nextLanguage(); }},
            {texts_("Sound: {}", {volume}), [this] { nextVolume(); }},
            {texts_("Fullscreen: {}", {full}), [this] { toggleFullscreen(); }},
            {texts_("Controls"), [this] { show(Screen::bindings); }},
            {texts_("Back"), [this] { show(below_); }}};
}

std::vector<MenuItem> Game::bindingItems() {
    std::vector<MenuItem> items;
    for (atlax::Action action = 0; action < PlayerActions::changeable; ++action) {
        const std::string label =
            texts_(actionNames[action]) + ": " + bindingNames(actions_.all.bindings(action));
        items.push_back({label, [this, action] {
                             captured_ = action;
                             show(Screen::capture);
                         }});
    }
    items.push_back({texts_("As at first"), [this] {
                         actions_.all.resetBindings();
                         savePreferences();
                         show(Screen::bindings, menu_.selected());
                     }});
    items.push_back({texts_("Back"), [this] { show(Screen::options); }});
    return items;
}

void Game::drawScreen(atlax::Canvas& canvas) {
    const OverlayTools tools{canvas, *art_, texts_};
    float top = 0;
    switch (screen_) {
        case Screen::playing:
            return;
        case Screen::title:
            top = drawTitle(tools, static_cast<double>(time_) / Session::tickRate);
            break;
        case Screen::paused:
            top = drawHeadline(tools, texts_("Paused"));
            break;
        case Screen::finished:
            top = drawFinish(tools, *session_, best_, watching());
            break;
        case Screen::options:
            top = drawHeadline(tools, texts_("Options"));
            break;
        case Screen::bindings:
            top = drawHeadline(tools, texts_("Controls"));
            break;
        case Screen::capture:
            drawHeadline(tools,
                         texts_("Press a key or button for: {}", {texts_(actionNames[captured_])}));
            return;
    }
    menu_.draw(canvas, art_->bold(), top);
}

void Game::chooseLanguage(const std::string& language) {
    try {
        texts_.setLanguage(language);
    } catch (const atlax::Error& error) {
        atlax::log(atlax::LogLevel::Warning, error.what());
    }
}

void Game::nextLanguage() {
    chooseLanguage(texts_.nextLanguage());
    preferences_.setLanguage(texts_.language());
    savePreferences();
    show(Screen::options, menu_.selected());
}

void Game::nextVolume() {
    const int now = preferences_.volume();
    preferences_.setVolume(now == 0 ? 100 : now - std::min(now, 25));
    applyVolume();
    savePreferences();
    show(Screen::options, menu_.selected());
}

void Game::applyVolume() {
    platform_->audio().setMasterVolume(static_cast<float>(preferences_.volume()) / 100);
}

void Game::toggleFullscreen() {
    platform_->setFullscreen(!platform_->fullscreen());
    preferences_.setFullscreen(platform_->fullscreen());
    if (screen_ == Screen::options) show(Screen::options, menu_.selected());
}

/// Escape keeps what there was. A wheel cannot be held, and these actions are.
void Game::capture(const atlax::Event& event) {
    const auto binding = Binding::captured(event);
    if (!binding || binding->device == Binding::Device::Wheel) return;
    if (!(*binding == Binding::key(atlax::Key::Escape))) bind(captured_, *binding);
    show(Screen::bindings, captured_);
}

/// In place of the keys and the mouse, or in place of the gamepad's; no other action that the
/// player may change keeps it.
void Game::bind(atlax::Action action, const Binding& binding) {
    for (const atlax::Action other : actions_.all.conflicts(action, binding)) {
        if (other >= PlayerActions::changeable) continue;
        std::vector<Binding> rest = actions_.all.bindings(other);
        std::erase(rest, binding);
        actions_.all.rebind(other, std::move(rest));
    }
    std::vector<Binding> bindings{binding};
    for (const Binding& b : actions_.all.bindings(action))
        if (ofPad(b) != ofPad(binding)) bindings.push_back(b);
    actions_.all.rebind(action, std::move(bindings));
    savePreferences();
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
