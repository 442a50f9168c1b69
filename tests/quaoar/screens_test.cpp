// The game's program without a window: settings, words, menus, and what a reset driver leaves.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>
#include <atlax/image.hpp>
#include <cmath>
#include <functional>
#include <regex>

#include "../atlax/lost_driver.hpp"
#include "game.hpp"
#include "helpers.hpp"

namespace quaoar::test {
namespace {

TEST(Preferences, areKeptAndSurviveRubbish) {
    const Folder folder("preferences");
    const auto file = folder / "settings.json";
    {
        Preferences preferences(file);
        EXPECT_EQ(preferences.windowSize(), (atlax::PixelSize{1280, 720}));
        PlayerActions actions;
        actions.all.rebind(actions.fire, {atlax::Binding::key(atlax::Key::F)});
        preferences.setBindings(actions);
        preferences.setVolume(25);
        preferences.setWindowSize({800, 600});
        preferences.setBest("01 Übung/..", 12.5);
        preferences.save();
    }
    const Preferences again(file);
    EXPECT_EQ(again.volume(), 25);
    EXPECT_EQ(again.windowSize(), (atlax::PixelSize{800, 600}));
    EXPECT_EQ(again.best("01 Übung/.."), 12.5);
    EXPECT_EQ(again.best("another"), 0);
    PlayerActions actions;
    again.readBindings(actions);
    EXPECT_EQ(actions.all.bindings(actions.fire), std::vector{atlax::Binding::key(atlax::Key::F)});

    writeText(file, R"({"version": 1, "settings": {"sound.volume": 4000, "input.fire": "F"}})");
    const Preferences odd(file);
    EXPECT_EQ(odd.volume(), 100);
    PlayerActions fresh;
    odd.readBindings(fresh);
    EXPECT_EQ(fresh.all.bindings(fresh.fire).size(), 2u) << "as at first";
}

TEST(Preferences, thatCannotBeWrittenStopNothing) {
    Preferences preferences("/proc/no/such/place/settings.json");
    preferences.setVolume(50);
    preferences.save();
    EXPECT_EQ(preferences.volume(), 50);
}

TEST(Texts, changeTheirLanguageAndFillTheirGaps) {
    Texts texts;
    EXPECT_EQ(texts("Options"), "Options");
    EXPECT_EQ(texts("Sound: {}", {"75 %"}), "Sound: 75 %");
    EXPECT_EQ(texts.nextLanguage(), "de");
    texts.setLanguage("de");
    EXPECT_EQ(texts("Options"), "Einstellungen");
    EXPECT_EQ(texts("Sound: {}", {"75 %"}), "Ton: 75 %");
    EXPECT_EQ(texts("what no catalog has"), "what no catalog has");
    EXPECT_EQ(texts(""), "");
    EXPECT_EQ(texts.nextLanguage(), "en");
    texts.setLanguage("en");
    EXPECT_EQ(texts("Options"), "Options");
}

/// Every text that the source looks up, and those of the level files.
std::vector<std::string> allTexts() {
    std::vector<std::string> texts;
    const std::regex call("texts_?\\(\"([^\"]+)\"");
    for (const char* name : {"game.cpp", "game_menus.cpp", "overlay.cpp"}) {
        const std::string source = readText(std::filesystem::path(QUAOAR_APP_SOURCES) / name);
        for (std::sregex_iterator it(source.begin(), source.end(), call), end; it != end; ++it)
            texts.push_back((*it)[1]);
    }
    const auto level = firstLevel();
    texts.push_back(level->name);
    for (const Hint& hint : level->hints) texts.push_back(hint.text);
    return texts;
}

TEST(Texts, noneIsLeftUntranslated) {
    Texts texts;
    texts.setLanguage("de");
    // Words that are the same in both languages.
    const std::vector<std::string> same{"LEVEL {}", "Pause"};
    const auto all = allTexts();
    EXPECT_GT(all.size(), 30u);
    for (const std::string& text : all) {
        const bool alike = std::find(same.begin(), same.end(), text) != same.end();
        EXPECT_EQ(texts(text) == text, alike) << text;
    }
    texts.setLanguage("en");
}

/// Runs a game and lets the test see and do what a player would, before each frame.
class Played : public atlax::Application {
public:
    Played(Game& game, std::function<void(atlax::Platform&, int)> hand)
        : game_(game), hand_(std::move(hand)) {}

    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        game_.start(platform);
    }
    void event(const atlax::Event& event) override { game_.event(event); }
    void tick() override { game_.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        hand_(*platform_, ++frames_);
        game_.draw(canvas, alpha);
    }
    bool restoreGraphics() override {
        ++restored;
        return game_.restoreGraphics();
    }
    void stop() override { game_.stop(); }

    int restored = 0;

private:
    Game& game_;
    std::function<void(atlax::Platform&, int)> hand_;
    atlax::Platform* platform_ = nullptr;
    int frames_ = 0;
};

int play(Played& played) {
    atlax::WindowOptions window;
    window.size = {320, 180};
    window.tickRateHz = Session::tickRate;
    window.offscreen = true;
    return atlax::runOffscreen(played, window);
}

void tap(atlax::Platform& platform, atlax::Key key) {
    platform.post(atlax::KeyEvent{.key = key, .down = true});
    platform.post(atlax::KeyEvent{.key = key, .down = false});
}

TEST(Game, theMenuChangesLanguageVolumeAndKeys) {
    const Folder folder("menus");
    Preferences preferences(folder / "settings.json");
    preferences.setLanguage("en");
    Game game({.level = firstLevel()}, preferences);
    using atlax::Key;
    const Key keys[] = {Key::Down,   Key::Enter,               // options
                        Key::Enter,                            // the next language
                        Key::Down,   Key::Enter,               // the volume
                        Key::Down,   Key::Down,   Key::Enter,  // controls
                        Key::Down,   Key::Enter,  Key::S,      // reeling in with S
                        Key::Escape, Key::Escape,              // back to the title
                        Key::Up,     Key::Enter};              // quit
    Played played(game, [&](atlax::Platform& platform, int frame) {
        const auto at = static_cast<std::size_t>(frame / 4 - 1);
        if (frame % 4 == 0 && at < std::size(keys)) tap(platform, keys[at]);
        if (frame > 200) platform.quit(9);
    });
    EXPECT_EQ(play(played), 0) << "by the menu's last entry";
    const Preferences kept(folder / "settings.json");
    EXPECT_EQ(kept.language(), "de");
    EXPECT_EQ(kept.volume(), 75);
    PlayerActions actions;
    kept.readBindings(actions);
    EXPECT_EQ(actions.all.bindings(actions.reelIn).front(), atlax::Binding::key(Key::S));
    for (const auto& binding : actions.all.bindings(actions.reelOut))
        EXPECT_FALSE(binding == atlax::Binding::key(Key::S)) << "which reeled out before";
}

/// Mean difference of a colour's part, 0..255.
double difference(const atlax::Image& a, const atlax::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.bytes().size(); ++i)
        sum += std::abs(static_cast<double>(a.bytes()[i]) - static_cast<double>(b.bytes()[i]));
    return sum / static_cast<double>(a.bytes().size());
}

TEST(Game, goesOnAfterTheDriverWasReset) {
    const Folder folder("reset");
    Preferences preferences(folder / "settings.json");
    const LostDriver driver;
    Game game({.level = firstLevel(), .skipTitle = true}, preferences);
    Played played(game, [&](atlax::Platform& platform, int frame) {
        // Paused, so that both pictures show the same moment.
        if (frame == 5) tap(platform, atlax::Key::Escape);
        if (frame == 10) platform.requestScreenshot(folder / "before.png");
        if (frame == 12) LostDriver::lose();
        if (frame == 16) platform.requestScreenshot(folder / "after.png");
        if (frame == 18) platform.quit();
    });
    EXPECT_EQ(play(played), 0);
    EXPECT_EQ(played.restored, 1);
    const atlax::Image before = atlax::loadImage(folder / "before.png");
    const atlax::Image after = atlax::loadImage(folder / "after.png");
    ASSERT_EQ(before.size(), after.size());
    EXPECT_LT(difference(before, after), 0.5);
}

}  // namespace
}  // namespace quaoar::test
