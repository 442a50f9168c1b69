// The game's program without a window: menus, play, and what a reset driver leaves.
#include <gtest/gtest.h>

#include <atlax/image.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "../atlax/lost_driver.hpp"
#include "game.hpp"
#include "helpers.hpp"
#include "played.hpp"
#include "share.hpp"

namespace quaoar::test {
namespace {

using Screen = Game::Screen;
using atlax::Key;

TEST(Game, theMenuChangesLanguageVolumeAndKeys) {
    const Folder folder("menus");
    Preferences preferences(folder / "settings.json");
    preferences.setLanguage("en");
    Game game({.level = firstLevel()}, preferences);
    Script script;
    script.keys({Key::Down, Key::Down, Key::Enter});                          // options
    script.keys({Key::Enter});                                                // the next language
    script.keys({Key::Down, Key::Enter, Key::Left});                          // sound, less of it
    script.keys({Key::Escape, Key::Down, Key::Down, Key::Down, Key::Enter});  // controls
    script.keys({Key::Down, Key::Enter, Key::Enter, Key::S});  // reeling in with S instead of W
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::conflict); });
    script.keys({Key::Enter});  // swap
    script.keys(
        {Key::Escape, Key::Escape, Key::Escape, Key::Up, Key::Up, Key::Up, Key::Enter});  // quit
    Played played(game, script);
    EXPECT_EQ(play(played), 0) << "by the menu's last entry";
    const Preferences kept(folder / "settings.json");
    EXPECT_EQ(kept.language(), "de");
    EXPECT_EQ(kept.volume(atlax::Bus::Effects), 90);
    PlayerActions actions;
    kept.readBindings(actions);
    EXPECT_EQ(actions.all.bindings(actions.reelIn).front(), atlax::Binding::key(Key::S));
    EXPECT_EQ(actions.all.bindings(actions.reelOut).front(), atlax::Binding::key(Key::W));
}

TEST(Game, firesLastKeyCannotBeTaken) {
    const Folder folder("last-key");
    Preferences preferences(folder / "settings.json");
    Game game({.level = firstLevel()}, preferences);
    Script script;
    script.keys({Key::Down, Key::Down, Key::Enter, Key::Up, Key::Up, Key::Enter});  // controls
    script.keys({Key::Enter, Key::Enter, Key::Space});        // fire: Space for the mouse
    script.keys({Key::Escape, Key::Down, Key::Enter});        // reel in
    script.keys({Key::Up, Key::Up, Key::Enter, Key::Space});  // another key: Space
    script.then([&](atlax::Platform&) {
        EXPECT_EQ(game.screen(), Screen::bindings) << "refused";
        const auto& fire = game.actions().all.bindings(game.actions().fire);
        EXPECT_EQ(fire.front(), atlax::Binding::key(Key::Space));
    });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
}

TEST(Game, everyPressOfAFrameMovesTheMenu) {
    const Folder folder("presses");
    Preferences preferences(folder / "settings.json");
    Game game({.level = firstLevel()}, preferences);
    Script script;
    script.then([](atlax::Platform& platform) {
        tap(platform, Key::Down);
        tap(platform, Key::Down);
        tap(platform, Key::Down);
    });
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.selected(), 3u); });
    script.then([](atlax::Platform& platform) {
        tap(platform, Key::Up);
        tap(platform, Key::Enter);
    });
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::options); });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
}

// It comes late or not at all; a press that was meant for another entry must not start it.
TEST(Game, theLevelOfTheDayHasItsPlaceBeforeItIsThere) {
    const Folder folder("daily");
    Preferences preferences(folder / "settings.json");
    Game game({.level = firstLevel(), .daily = std::pair("/proc/no/such/place", "2026-11-30")},
              preferences);
    Script script;
    script.then([](atlax::Platform& platform) {
        tap(platform, Key::Down);
        tap(platform, Key::Enter);
    });
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::title); });
    script.wait(200);
    script.then([](atlax::Platform& platform) {
        tap(platform, Key::Enter);
        tap(platform, Key::Down);
        tap(platform, Key::Down);
        tap(platform, Key::Enter);
    });
    script.then([&](atlax::Platform& platform) {
        EXPECT_EQ(game.screen(), Screen::options);
        tap(platform, Key::Escape);
    });
    script.then([&](atlax::Platform&) {
        EXPECT_EQ(game.screen(), Screen::title);
        EXPECT_EQ(game.selected(), 3u);
    });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
}

TEST(Game, everyPressOfAFrameFires) {
    const Folder folder("shots");
    Preferences preferences(folder / "settings.json");
    Game game({.level = firstLevel(), .skipTitle = true, .record = folder / "run"}, preferences);
    Script script;
    script.wait(5);
    script.then([](atlax::Platform& platform) {
        for (const bool down : {true, false, true, false}) {
            platform.post(atlax::MouseButtonEvent{.down = down, .position = {160, 5}});
        }
    });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
    int shots = 0;
    bool before = false;
    const Recording recording = Recording::read(folder / "run");
    for (const InputRun& run : recording.runs()) {
        shots += run.input.fire && !before ? 1 : 0;
        before = run.input.fire;
    }
    EXPECT_EQ(shots, 2);
}

/// Hangs the hero on the rope, straight up, by the gamepad's trigger.
void hang(Script& script, const Game& game) {
    script.then([](atlax::Platform& platform) {
        platform.post(atlax::PadConnected{0, "pad"});
        platform.post(atlax::PadAxisEvent{0, atlax::PadAxis::RightY, 1});
        platform.post(atlax::PadAxisEvent{0, atlax::PadAxis::RightTrigger, 1});
    });
    script.wait(30);
    script.then(
        [&](atlax::Platform&) { EXPECT_EQ(game.session().rope().state(), Rope::State::attached); });
}

TEST(Game, theRopeHoldsThroughPauseFocusAndOptions) {
    const Folder folder("pause");
    Preferences preferences(folder / "settings.json");
    Game game({.level = firstLevel(), .skipTitle = true}, preferences);
    Script script;
    const auto holds = [&](Screen screen) {
        script.then([&game, screen](atlax::Platform&) {
            EXPECT_EQ(game.screen(), screen);
            EXPECT_EQ(game.session().rope().state(), Rope::State::attached);
        });
    };
    hang(script, game);
    script.keys({Key::Escape, Key::Escape});
    holds(Screen::countIn);
    script.wait(90);
    holds(Screen::playing);
    script.keys({Key::Escape, Key::Down, Key::Down, Key::Enter, Key::Down, Key::Enter});
    holds(Screen::sound);
    script.keys({Key::Escape, Key::Escape, Key::Up, Key::Up, Key::Enter}).wait(90);
    holds(Screen::playing);
    script.then([](atlax::Platform& platform) { platform.post(atlax::FocusChanged{false}); });
    holds(Screen::paused);
    script.then([](atlax::Platform& platform) { platform.post(atlax::FocusChanged{true}); });
    script.keys({Key::Enter}).wait(120);
    holds(Screen::playing);
    for (const float pulled : {1.0f, 0.0f}) {
        script.then([pulled](atlax::Platform& platform) {
            platform.post(atlax::PadAxisEvent{0, atlax::PadAxis::RightTrigger, pulled});
        });
    }
    script.then(
        [&](atlax::Platform&) { EXPECT_EQ(game.session().rope().state(), Rope::State::idle); });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
}

TEST(Game, withoutCountInPlayGoesOnAtOnceAndALetGoButtonLetsGo) {
    const Folder folder("no-count-in");
    Preferences preferences(folder / "settings.json");
    preferences.set(Choice::countIn, false);
    Game game({.level = firstLevel(), .skipTitle = true}, preferences);
    Script script;
    hang(script, game);
    script.keys({Key::Escape, Key::Escape});
    script.then([&](atlax::Platform& platform) {
        EXPECT_EQ(game.screen(), Screen::playing);
        EXPECT_EQ(game.session().rope().state(), Rope::State::attached);
        platform.post(atlax::PadAxisEvent{0, atlax::PadAxis::RightTrigger, 0});
    });
    script.then(
        [&](atlax::Platform&) { EXPECT_EQ(game.session().rope().state(), Rope::State::idle); });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
}

TEST(Game, isPlayedByTheGamepadAlone) {
    const Folder folder("pad");
    Preferences preferences(folder / "settings.json");
    Game game({.level = firstLevel()}, preferences);
    using atlax::PadAxis;
    using atlax::PadButton;
    Script script;
    const auto press = [&](PadButton button) {
        for (const bool down : {true, false}) {
            script.then([button, down](atlax::Platform& platform) {
                platform.post(atlax::PadButtonEvent{0, button, down});
            });
        }
    };
    const auto push = [&](PadAxis axis, float value) {
        script.then([axis, value](atlax::Platform& platform) {
            platform.post(atlax::PadAxisEvent{0, axis, value});
        });
    };
    double length = 0;
    script.then([](atlax::Platform& platform) { platform.post(atlax::PadConnected{0, "pad"}); });
    press(PadButton::South);  // play
    hang(script, game);
    script.then([&](atlax::Platform&) { length = game.session().rope().restLength(); });
    push(PadAxis::LeftTrigger, 1);
    script.wait(30);
    script.then([&](atlax::Platform&) {
        EXPECT_LT(game.session().rope().restLength(), length - 0.2) << "reeled in";
    });
    press(PadButton::Start);
    press(PadButton::DpadDown);
    push(PadAxis::LeftY, -1);  // and the stick
    push(PadAxis::LeftY, 0);
    press(PadButton::South);  // options
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::options); });
    press(PadButton::East);
    press(PadButton::East);  // back to the game
    script.wait(90);
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::playing); });
    press(PadButton::North);
    script.then([&](atlax::Platform&) { EXPECT_GT(game.session().restarts(), 1); });
    press(PadButton::Start);
    press(PadButton::DpadUp);
    press(PadButton::South);  // quit
    Played played(game, script);
    EXPECT_EQ(play(played), 0);
}

TEST(Game, isPlayedByTheMouseAlone) {
    const Folder folder("mouse");
    Preferences preferences(folder / "settings.json");
    Game game({.level = firstLevel()}, preferences);
    using atlax::MouseButton;
    std::vector<atlax::DrawnText> texts;
    Script script;
    const auto post = [&](MouseButton button, bool down, atlax::Vec2 at) {
        script.then([button, down, at](atlax::Platform& platform) {
            platform.post(atlax::MouseButtonEvent{.button = button, .down = down, .position = at});
        });
    };
    const auto clickOn = [&](const std::string& label) {
        script.then([&, label](atlax::Platform& platform) {
            for (const atlax::DrawnText& text : texts) {
                if (text.text != label) continue;
                const atlax::Vec2 at = text.box.min + text.box.size * 0.5f;
                for (const bool down : {true, false})
                    platform.post(atlax::MouseButtonEvent{.down = down, .position = at});
                return;
            }
            ADD_FAILURE() << "no \"" << label << "\" to click on";
        });
    };
    const atlax::Vec2 up{160, 3};
    double length = 0;
    script.wait(3);
    clickOn("Play");
    script.wait(10);
    post(MouseButton::Left, true, up);
    script.wait(30);
    script.then([&](atlax::Platform& platform) {
        length = game.session().rope().restLength();
        EXPECT_GT(length, 0) << "the rope sticks";
        platform.post(atlax::WheelEvent{{0, 2}, up});
    });
    script.wait(20);
    script.then([&](atlax::Platform&) {
        EXPECT_LT(game.session().rope().restLength(), length - 0.1) << "the wheel reels in";
    });
    post(MouseButton::Middle, true, up);
    post(MouseButton::Middle, false, up);
    post(MouseButton::Left, false, up);
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::paused); });
    clickOn("Options");
    clickOn("Back");
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::paused); });
    clickOn("Title screen");
    clickOn("Quit");
    Played played(game, script, [&](atlax::Canvas& canvas) { texts = canvas.recordedTexts(); });
    EXPECT_EQ(play(played), 0);
}

TEST(Game, levelsAreFinishedUnlockedAndKept) {
    const Folder folder("chain");
    writeEasyLevels(folder, 3);
    Preferences preferences(folder / "settings.json");
    const auto options = [&] {
        return GameOptions{.levels = LevelList::ofFolder(folder.path()),
                           .progress = folder / "data"};
    };
    {
        Game game(options(), preferences);
        Script script;
        script.keys({Key::Down, Key::Enter, Key::Right, Key::Enter});
        script.then(
            [&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::levels) << "locked"; });
        script.keys({Key::Escape, Key::Up, Key::Enter}).wait(80);
        script.then([&](atlax::Platform&) {
            EXPECT_EQ(game.screen(), Screen::finished);
            EXPECT_EQ(game.session().level().number, 1);
        });
        script.keys({Key::Enter});  // the next level, with one key
        script.then([&](atlax::Platform&) {
            EXPECT_EQ(game.screen(), Screen::playing);
            EXPECT_EQ(game.session().level().number, 2);
        });
        script.wait(80);
        Played played(game, script);
        EXPECT_EQ(play(played), 9);
    }
    Game again(options(), preferences);
    EXPECT_TRUE(again.progress().of("room-1").finished);
    EXPECT_TRUE(again.progress().of("room-2").finished);
    EXPECT_FALSE(again.progress().of("room-3").finished);
    EXPECT_EQ(again.progress().of("room-1").attempts, 1);
    Script script;
    script.then([&](atlax::Platform&) {
        EXPECT_EQ(again.session().level().number, 3) << "begins with the last unlocked";
    });
    script.keys({Key::Enter});
    script.then([&](atlax::Platform&) {
        EXPECT_EQ(again.screen(), Screen::playing);
        EXPECT_EQ(again.session().level().number, 3);
    });
    Played played(again, script);
    EXPECT_EQ(play(played), 9);
}

TEST(Game, aReplayGoesToTheClipboardAndBack) {
    const Folder folder("clipboard");
    writeEasyLevels(folder, 2);
    Preferences preferences(folder / "settings.json");
    Game game({.levels = LevelList::ofFolder(folder.path())}, preferences);
    Script script;
    script.keys({Key::Enter}).wait(80);
    script.keys({Key::Down, Key::Down, Key::Down, Key::Enter});
    script.then([&](atlax::Platform& platform) {
        EXPECT_EQ(platform.clipboard().find("quaoar-replay:"), 0u);
    });
    script.keys({Key::Escape});
    script.then([&](atlax::Platform& platform) {
        EXPECT_EQ(game.screen(), Screen::title);
        platform.post(
            atlax::KeyEvent{.key = Key::V, .down = true, .modifiers = atlax::Modifiers::Control});
    });
    script.then([&](atlax::Platform& platform) {
        EXPECT_EQ(game.screen(), Screen::playing) << "watching";
        writeText(folder / "dropped.txt", platform.clipboard());
        platform.setClipboard("nothing of ours");
    });
    script.wait(80);
    script.then([&](atlax::Platform& platform) {
        EXPECT_EQ(game.screen(), Screen::finished);
        platform.post(
            atlax::KeyEvent{.key = Key::V, .down = true, .modifiers = atlax::Modifiers::Control});
    });
    script.then([&](atlax::Platform& platform) {
        EXPECT_EQ(game.screen(), Screen::finished) << "said and left";
        platform.post(atlax::FileDropped{folder / "dropped.txt"});
    });
    script.then([&](atlax::Platform&) { EXPECT_EQ(game.screen(), Screen::playing); });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(Film, ofTheLastSecondsIsMadeBesideTheMenu) {
    const Folder folder("film");
    const LevelList levels = LevelList::ofFolder(levelsFolder());
    const auto file = folder / "film.png";
    atlax::OffscreenCanvas offscreen({64, 36});
    Art art(offscreen.canvas());
    const auto run = std::make_shared<const Recording>(handRun(11));
    Film film(art, levels.level(0), run, file);
    int frames = 0;
    for (bool done = false; !done && frames < 1000; ++frames) {
        EXPECT_FALSE(std::filesystem::exists(file)) << "written when it is whole";
        done = film.step(offscreen.begin());
        offscreen.finish();
    }
    const std::string bytes = readText(file);
    EXPECT_EQ(countOf(bytes, "acTL"), 1u);
    EXPECT_NEAR(static_cast<double>(countOf(bytes, "fcTL")), 120, 3) << "ten seconds";
    EXPECT_EQ(countOf(bytes, "fdAT"), countOf(bytes, "fcTL") - 1);
    EXPECT_EQ(atlax::loadImage(file).size(), Film::size) << "a picture for those who know no films";
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
    Game game({.level = firstLevel(), .skipTitle = true, .adapt = false}, preferences);
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
