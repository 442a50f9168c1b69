// The game's program without a window: settings, words, menus, and what a reset driver leaves.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>
#include <atlax/image.hpp>
#include <atlax/offscreen.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <regex>
#include <set>

#include "../atlax/lost_driver.hpp"
#include "game.hpp"
#include "helpers.hpp"
#include "share.hpp"

namespace quaoar::test {
namespace {

TEST(Preferences, areKeptAndSurviveRubbish) {
    const Folder folder("preferences");
    const auto file = folder / "settings.json";
    const std::vector keys{atlax::Binding::key(atlax::Key::F),
                           atlax::Binding::pad(atlax::PadButton::South)};
    {
        Preferences preferences(file);
        EXPECT_EQ(preferences.windowSize(), (atlax::PixelSize{1280, 720}));
        PlayerActions actions;
        actions.all.rebind(actions.fire, keys);
        preferences.setBindings(actions);
        preferences.setVolume(atlax::Bus::Music, 25);
        preferences.setWindowSize({800, 600});
        preferences.set(Choice::aimAssist, true);
        preferences.setSpeed(80);
        preferences.setGhost(GhostChoice::gold);
        preferences.save();
    }
    const Preferences again(file);
    EXPECT_EQ(again.volume(atlax::Bus::Music), 25);
    EXPECT_EQ(again.volume(atlax::Bus::Effects), 100);
    EXPECT_EQ(again.windowSize(), (atlax::PixelSize{800, 600}));
    EXPECT_TRUE(again.on(Choice::aimAssist));
    EXPECT_TRUE(again.on(Choice::shake));
    EXPECT_EQ(again.speed(), 80);
    EXPECT_EQ(again.ghost(), GhostChoice::gold);
    PlayerActions actions;
    again.readBindings(actions);
    EXPECT_EQ(actions.all.bindings(actions.fire), keys);

    writeText(file, R"({"version": 1, "settings": {"sound.volume": 4000, "input.fire": "F",
                        "play.speed": 5, "play.ghost": 9}})");
    const Preferences odd(file);
    EXPECT_EQ(odd.volume(atlax::Bus::Effects), 100);
    EXPECT_EQ(odd.speed(), 100);
    EXPECT_EQ(odd.ghost(), GhostChoice::best);
    PlayerActions fresh;
    odd.readBindings(fresh);
    EXPECT_EQ(fresh.all.bindings(fresh.fire).size(), 2u) << "as at first";
}

TEST(Preferences, thatCannotBeWrittenStopNothing) {
    Preferences preferences("/proc/no/such/place/settings.json");
    preferences.setVolume(atlax::Bus::Effects, 50);
    preferences.save();
    EXPECT_EQ(preferences.volume(atlax::Bus::Effects), 50);
}

TEST(Texts, changeTheirLanguageAndFillTheirGaps) {
    Texts texts;
    EXPECT_EQ(texts("Options"), "Options");
    EXPECT_EQ(texts("Effects: {}", {"75 %"}), "Effects: 75 %");
    EXPECT_EQ(texts.nextLanguage(), "de");
    EXPECT_EQ(texts.nextLanguage(-1), "it");
    texts.setLanguage("de");
    EXPECT_EQ(texts("Options"), "Einstellungen");
    EXPECT_EQ(texts("Effects: {}", {"75 %"}), "Geräusche: 75 %");
    EXPECT_EQ(texts("what no catalog has"), "what no catalog has");
    EXPECT_EQ(texts(""), "");
    EXPECT_EQ(texts.nextLanguage(), "it");
    texts.setLanguage("en");
    EXPECT_EQ(texts("Options"), "Options");
}

/// The texts in string literals of what stands in brackets after a name, as `texts_(`.
void collectTexts(const std::string& source, const std::string& call,
                  std::vector<std::string>& out) {
    const std::regex literal("\"((?:[^\"\\\\]|\\\\.)*)\"(\\s*\")?");
    for (std::size_t at = source.find(call); at != std::string::npos;
         at = source.find(call, at + 1)) {
        std::size_t end = at + call.size();
        for (int depth = 1; depth > 0 && end < source.size(); ++end)
            depth += source[end] == '(' || source[end] == '{'   ? 1
                     : source[end] == ')' || source[end] == '}' ? -1
                                                                : 0;
        std::string inside = source.substr(at + call.size(), end - at - call.size());
        // Values that are put into the text are no texts of their own.
        inside = inside.substr(0, inside.find(", {"));
        inside = std::regex_replace(inside, std::regex("\"\\s+\""), "");
        for (std::sregex_iterator it(inside.begin(), inside.end(), literal), none; it != none; ++it)
            if ((*it)[1].length() > 0) out.push_back((*it)[1]);
    }
}

/// Every text that the source looks up, and those of the level files.
std::vector<std::string> allTexts() {
    std::vector<std::string> texts;
    for (const auto& file : std::filesystem::directory_iterator(QUAOAR_APP_SOURCES)) {
        if (file.path().extension() != ".cpp" || file.path().filename() == "prompts.cpp") continue;
        const std::string source = readText(file.path());
        for (const char* call : {"texts_(", "texts(", " toggle(", " volume("})
            collectTexts(source, call, texts);
    }
    const LevelList levels = LevelList::ofFolder(levelsFolder());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        texts.push_back(levels[i].name);
        for (const Hint& hint : levels[i].hints) texts.push_back(hint.text);
    }
    return texts;
}

/// Words that are the same in English and another language.
const std::set<std::string> sameWords{"LEVEL {}",  "Pause", "Levels",    "Text",
                                      "Menus: {}", "/",     "Film: {} %"};

TEST(Texts, noneIsLeftUntranslated) {
    Texts texts;
    const auto all = allTexts();
    EXPECT_GT(all.size(), 90u);
    EXPECT_EQ(texts.languages(), (std::vector<std::string>{"en", "de", "it"}));
    for (const char* language : {"de", "it"}) {
        texts.setLanguage(language);
        for (const std::string& text : all) {
            if (sameWords.contains(text)) continue;
            EXPECT_NE(texts(text), text) << "in " << language;
        }
    }
    texts.setLanguage("en");
}

TEST(Prompts, nameTheDeviceInHand) {
    Texts texts;
    PlayerActions actions;
    Prompts prompts(actions, texts);
    EXPECT_EQ(prompts.fill("{fire} or {reel_in} or {what}"), "left mouse button or W or {what}");
    prompts.event(atlax::PadButtonEvent{0, atlax::PadButton::South, true});
    EXPECT_EQ(prompts.fill("{fire}"), "right trigger");
    EXPECT_EQ(prompts.fill("{pause}, {aim}"), "pad Start, right stick");
    prompts.event(atlax::PadAxisEvent{0, atlax::PadAxis::LeftX, 0.1f});
    prompts.event(atlax::MouseMoved{{1, 1}});
    EXPECT_EQ(prompts.fill("{pause}"), "Escape");
    prompts.event(atlax::PadAxisEvent{0, atlax::PadAxis::LeftX, 0.1f});
    EXPECT_FALSE(prompts.pad()) << "a stick that trembles";
    actions.all.rebind(actions.fire, {});
    EXPECT_EQ(prompts.fill("{fire}"), "-");
}

TEST(Prompts, tellMouseFromKeyInEveryLanguage) {
    using atlax::Binding;
    std::vector<Binding> all;
    for (int key = 1; key < atlax::keyCount; ++key)
        all.push_back(Binding::key(static_cast<atlax::Key>(key)));
    for (int i = 0; i < atlax::mouseButtonCount; ++i)
        all.push_back(Binding::mouse(static_cast<atlax::MouseButton>(i)));
    for (int i = 0; i < atlax::padButtonCount; ++i)
        all.push_back(Binding::pad(static_cast<atlax::PadButton>(i)));
    for (int i = 0; i < atlax::padAxisCount; ++i)
        all.push_back(Binding::axis(static_cast<atlax::PadAxis>(i)));
    for (const char* language : {"en", "de", "it"}) {
        Texts texts;
        texts.setLanguage(language);
        std::set<std::string> names;
        for (const Binding& binding : all) {
            const std::string name = bindingName(binding, texts);
            EXPECT_TRUE(names.insert(name).second) << name << " is two things in " << language;
            EXPECT_EQ(name.find("key "), std::string::npos);
        }
        texts.setLanguage("en");
        if (std::string(language) != "en") {
            for (const Binding& binding : all) {
                if (binding.device == Binding::Device::Key) continue;
                const std::string english = bindingName(binding, texts);
                EXPECT_FALSE(names.contains(english)) << english << " in " << language;
            }
        }
    }
}

TEST(Progress, isKeptAndSurvivesDamage) {
    const Folder folder("progress");
    const auto level = room();
    Recording run(*level);
    run.append(fireAt(0, 1));
    {
        Progress progress(folder.path());
        EXPECT_FALSE(progress.of("01 Übung/..").finished);
        progress.set("01 Übung/..", {.finished = true,
                                     .best = 12.5,
                                     .attempts = 3,
                                     .deaths = 2,
                                     .pickups = 5,
                                     .splits = {1.25, 0}});
        progress.setTotals({.seconds = 60, .distance = 1.5, .shots = 7, .attempts = 3});
        progress.keepBestRun("room", run);
        progress.save();
        progress.set("other", {.best = 1});
        progress.save();
    }
    const Progress again(folder.path());
    EXPECT_TRUE(again.of("01 Übung/..").finished);
    EXPECT_EQ(again.of("01 Übung/..").best, 12.5);
    EXPECT_EQ(again.of("01 Übung/..").pickups, 5);
    EXPECT_EQ(again.of("01 Übung/..").splits, (std::vector<double>{1.25, 0}));
    EXPECT_EQ(again.totals().shots, 7);
    ASSERT_NE(again.bestRun("room", *level), nullptr);
    EXPECT_EQ(again.bestRun("room", *level)->format(), run.format());
    EXPECT_EQ(again.bestRun("room", *room(replaced(roomText, "0.4, 0.4", "0.5, 0.4"))), nullptr)
        << "of another version of the level";

    writeText(folder / "progress.json", "{ half");
    const Progress backup(folder.path());
    EXPECT_EQ(backup.of("01 Übung/..").best, 12.5) << "from the backup";
    EXPECT_TRUE(std::filesystem::exists(folder / "progress.json.damaged-1"));
    writeText(folder / "replays" / "room.recording", "rubbish");
    EXPECT_EQ(backup.bestRun("room", *level), nullptr);
}

/// A minute of a hand that aims with small movements, and fires and reels now and then.
Recording handRun(int seconds) {
    Recording run(*firstLevel());
    std::uint32_t dice = 7;
    const auto roll = [&](int sides) {
        dice = dice * 1664525u + 1013904223u;
        return static_cast<int>(dice >> 16) % sides;
    };
    TickInput input;
    double angle = 0.8;
    for (int tick = 0; tick < seconds * Session::tickRate; ++tick) {
        if (tick % 8 == 0) {
            angle += 0.004 * (roll(9) - 4);
            const double x = std::cos(angle), y = std::sin(angle);
            const double reach = std::max(std::abs(x), std::abs(y));
            input.aimX = static_cast<std::int16_t>(std::lround(512 * x / reach));
            input.aimY = static_cast<std::int16_t>(std::lround(512 * y / reach));
        }
        if (roll(300) == 0) input.fire = !input.fire;
        if (roll(400) == 0) input.reelIn = !input.reelIn;
        if (roll(600) == 0) input.push = static_cast<std::int8_t>(roll(3) * 127 - 127);
        run.append(input);
    }
    return run;
}

TEST(Share, aRunBecomesAShortTextAndComesBack) {
    Recording run = handRun(30);
    run.finalHash = 0x0123456789abcdefu;
    const std::string text = shareText(run);
    EXPECT_LT(text.size(), 3000u) << "of half a minute";
    EXPECT_EQ(parseShareText(text).format(), run.format());
    std::string wrapped = "look at this:\n " + text;
    for (std::size_t i = 40; i < wrapped.size(); i += 61) wrapped.insert(i, "\n");
    EXPECT_EQ(parseShareText(wrapped).format(), run.format()) << "as a mail makes it";

    const auto proof = LevelList::ofFolder(levelsFolder()).proof(0);
    ASSERT_NE(proof, nullptr);
    EXPECT_EQ(parseShareText(shareText(*proof)).format(), proof->format());
}

TEST(Share, everyAimAndButtonComesBack) {
    Recording run(*room());
    std::vector<std::array<int, 2>> aims{{32767, 0}, {-32767, 32767}, {0, 0}, {512, 511}, {3, 4}};
    for (int i = -512; i <= 512; i += 32)
        for (const int side : {-512, 512}) {
            aims.push_back({i, side});
            aims.push_back({side, i});
        }
    int n = 0;
    for (const auto& aim : aims) {
        TickInput input;
        input.aimX = static_cast<std::int16_t>(aim[0]);
        input.aimY = static_cast<std::int16_t>(aim[1]);
        input.fire = (n & 1) != 0;
        input.reelIn = (n & 2) != 0;
        input.reelOut = (n & 4) != 0;
        input.boost = (n & 8) != 0;
        input.restart = (n & 16) != 0;
        input.retry = (n & 32) != 0;
        input.push = static_cast<std::int8_t>(n % 255 - 127);
        ++n;
        run.append(input);
    }
    EXPECT_EQ(parseShareText(shareText(run)).format(), run.format());
}

TEST(Share, whatIsNoReplayIsRefused) {
    EXPECT_THROW(parseShareText(""), RecordingError);
    EXPECT_THROW(parseShareText("hello"), RecordingError);
    EXPECT_THROW(parseShareText("quaoar-replay:"), RecordingError);
    EXPECT_THROW(parseShareText("quaoar-replay:AAAA"), RecordingError);
    const std::string text = shareText(handRun(2));
    for (std::size_t length = 0; length + 4 < text.size(); length += 7)
        EXPECT_THROW(parseShareText(text.substr(0, length)), RecordingError) << length;
    for (std::size_t i = 20; i < text.size(); i += 5) {
        std::string damaged = text;
        damaged[i] = damaged[i] == 'A' ? 'B' : 'A';
        EXPECT_THROW(parseShareText(damaged), RecordingError) << i;
    }
}

TEST(LevelList, isInTheOrderOfNumbersAndLeavesOutWhatIsNone) {
    const Folder folder("levels");
    writeText(folder / "a.json", replaced(roomText, "\"number\": 1", "\"number\": 12"));
    writeText(folder / "b.json", replaced(roomText, "\"number\": 1", "\"number\": 3"));
    writeText(folder / "c.json", "{}");
    writeText(folder / "level.schema.json", "{}");
    const LevelList list = LevelList::ofFolder(folder.path());
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].id, "b");
    EXPECT_EQ(list[1].id, "a");
    EXPECT_EQ(list.proof(0), nullptr);
    std::size_t index = 9;
    EXPECT_EQ(LevelList::around(folder / "a.json", index).size(), 2u);
    EXPECT_EQ(index, 1u);
    EXPECT_EQ(LevelList::ofFolder(folder / "none").size(), 0u);

    std::filesystem::create_directories(folder / "own/pack");
    writeText(folder / "own/a.json", roomText);
    writeText(folder / "own/pack/a.json", roomText);
    LevelList all = list;
    all.addOwn(folder / "own");
    all.addOwn(folder / "none");
    ASSERT_EQ(all.size(), 4u);
    EXPECT_FALSE(all.own(1));
    EXPECT_TRUE(all.own(2));
    EXPECT_EQ((std::set<std::string>{all.key(0), all.key(1), all.key(2), all.key(3)}.size()), 4u)
        << "each has a progress of its own";
}

TEST(Hints, comeOneAtATimeAndGoWhenDone) {
    const auto level =
        room(replaced(roomText, "\"medals\"",
                      "\"hints\": [{\"position\": [0, 1], \"text\": \"{reel_in} reels in\"}, "
                      "{\"position\": [0.5, 1], \"text\": \"{fire} fires\"}], \"medals\""));
    Session session(level);
    Texts texts;
    PlayerActions actions;
    const Prompts prompts(actions, texts);
    Hints hints(actions, prompts, texts);
    hints.start(*level);
    atlax::ActionState state;
    const auto wait = [&](int ticks) {
        for (int n = 0; n < ticks; ++n) hints.tick(session, state);
    };
    wait(10);
    EXPECT_EQ(hints.text(), "W reels in") << "the nearer one";
    wait(20 * Session::tickRate);
    EXPECT_EQ(hints.text(), "W reels in") << "until it is done";
    state.down.set(actions.reelIn);
    wait(Session::tickRate);
    EXPECT_EQ(hints.text(), "left mouse button fires");
    Session shot(level);
    for (int n = 0; n < Session::tickRate * 3; ++n) {
        shot.tick(fireAt(0, 1));
        hints.tick(shot, state);
    }
    EXPECT_EQ(hints.text(), "");
    hints.start(*level);
    wait(10);
    EXPECT_EQ(hints.text(), "W reels in") << "another visit";
}

/// Runs a game and lets the test see and do what a player would, before and after each frame.
class Played : public atlax::Application {
public:
    using Hand = std::function<void(atlax::Platform&, int)>;
    explicit Played(Game& game, Hand hand, std::function<void(atlax::Canvas&)> look = {})
        : game_(game), hand_(std::move(hand)), look_(std::move(look)) {}

    void start(atlax::Platform& platform) override {
        platform_ = &platform;
        game_.start(platform);
    }
    void event(const atlax::Event& event) override { game_.event(event); }
    void tick() override { game_.tick(); }
    void draw(atlax::Canvas& canvas, double alpha) override {
        hand_(*platform_, ++frames_);
        if (look_) canvas.recordTexts(true);
        game_.draw(canvas, alpha);
        if (look_) look_(canvas);
    }
    bool restoreGraphics() override {
        ++restored;
        return game_.restoreGraphics();
    }
    void stop() override { game_.stop(); }

    int restored = 0;

private:
    Game& game_;
    Hand hand_;
    std::function<void(atlax::Canvas&)> look_;
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

/// What a player does, one after the other, a few frames apart.
class Script {
public:
    using Step = std::function<void(atlax::Platform&)>;
    Script& keys(std::initializer_list<atlax::Key> keys) {
        for (const atlax::Key key : keys)
            then([key](atlax::Platform& platform) { tap(platform, key); });
        return *this;
    }
    Script& then(Step step) {
        steps_.push_back({std::move(step), 4});
        return *this;
    }
    Script& next(Step step) {
        steps_.push_back({std::move(step), 1});
        return *this;
    }
    Script& wait(int frames) {
        steps_.push_back({[](atlax::Platform&) {}, frames});
        return *this;
    }
    void operator()(atlax::Platform& platform, int) {
        if (--rest_ > 0) return;
        if (next_ == steps_.size()) return platform.quit(9);
        steps_[next_].first(platform);
        rest_ = steps_[next_++].second;
    }

private:
    std::vector<std::pair<Step, int>> steps_;
    std::size_t next_ = 0;
    int rest_ = 0;
};

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

/// Rooms in which the hero stands in the exit from the start.
void writeEasyLevels(const Folder& folder, int count) {
    for (int i = 1; i <= count; ++i) {
        const std::string number = std::to_string(i);
        std::string text = replaced(roomText, "\"number\": 1", "\"number\": " + number);
        text = replaced(text, "\"Room\"", "\"Room " + number + "\"");
        text = replaced(text, "[3.2, 0.3], \"radius\": 0.4", "[0.3, 0.3], \"radius\": 0.4");
        writeText(folder / ("room-" + number + ".json"), text);
    }
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

/// Of all texts that can be read, those that overlap or leave the picture.
std::vector<std::string> textFaults(const atlax::Canvas& canvas) {
    std::vector<std::string> faults;
    std::vector<atlax::DrawnText> seen;
    const atlax::Vec2 screen = canvas.size().toVec();
    for (const atlax::DrawnText& text : canvas.recordedTexts()) {
        constexpr float invisible = 0.1f;
        if (text.alpha < invisible || text.text.empty()) continue;
        const atlax::Vec2 low = text.box.min, high = text.box.max();
        if (low.x < -1 || low.y < -1 || high.x > screen.x + 1 || high.y > screen.y + 1)
            faults.push_back("\"" + text.text + "\" leaves the picture");
        bool shadow = false;
        for (const atlax::DrawnText& other : seen) {
            const atlax::Vec2 a = other.box.min, b = other.box.max();
            const float width = std::min(high.x, b.x) - std::max(low.x, a.x);
            const float height = std::min(high.y, b.y) - std::max(low.y, a.y);
            if (other.text == text.text && width > 0 && height > 0)
                shadow = true;
            else if (width > 1 && height > 1)
                faults.push_back("\"" + text.text + "\" runs through \"" + other.text + "\"");
        }
        if (!shadow) seen.push_back(text);
    }
    return faults;
}

/// Walks through all screens and looks at each in all sizes.
void lookAtAllTexts(const std::string& language) {
    const Folder folder("texts-" + language);
    writeEasyLevels(folder, 26);
    Preferences preferences(folder / "settings.json");
    LevelList levels = LevelList::ofFolder(folder.path());
    std::filesystem::copy_file(levelsFolder() / "01-cold-wake.json", folder / "room-1.json",
                               std::filesystem::copy_options::overwrite_existing);
    Game game({.levels = LevelList::ofFolder(folder.path()),
               .language = language,
               .progress = folder / "data",
               .unlockAll = true},
              preferences);
    // What counts is the shape: 1280 x 540 is 2560 x 1080, 1920 x 540 is 3840 x 1080.
    std::vector<atlax::PixelSize> sizes{{500, 700}, {640, 360}, {1280, 540}, {1920, 540}};
    if (language == "en") sizes.push_back({3840, 1080});
    std::string place;
    bool looking = false;
    int looks = 0;
    Script script;
    const auto look = [&](const std::string& name) {
        for (const atlax::PixelSize size : sizes) {
            script.next([&, name, size](atlax::Platform& platform) {
                place = name + " in " + language + " at " + std::to_string(size.width) + "x" +
                        std::to_string(size.height);
                platform.setWindowSize(size);
            });
            script.next([&](atlax::Platform& platform) {
                looking = true;
                if (const char* pictures = std::getenv("QUAOAR_TEST_PICTURES"))
                    platform.requestScreenshot(std::filesystem::path(pictures) / (place + ".png"));
            });
        }
        script.next([](atlax::Platform& platform) { platform.setWindowSize({320, 180}); });
    };
    look("title");
    script.keys({Key::Down, Key::Enter}).wait(40);
    look("levels");
    script.keys({Key::Escape, Key::Down, Key::Down, Key::Enter});
    look("statistics");
    script.keys({Key::Enter});
    look("statistics with news");
    script.keys({Key::Escape, Key::Down, Key::Enter});
    look("credits");
    script.keys({Key::Escape, Key::Up, Key::Up, Key::Enter});
    look("options");
    for (const char* page : {"sound", "picture", "play", "controls"}) {
        script.keys({Key::Down, Key::Enter});
        look(page);
        if (page != std::string("controls")) script.keys({Key::Escape});
    }
    script.keys({Key::Enter});
    look("bindings");
    script.keys({Key::Enter});
    look("capture");
    script.keys({Key::W});
    look("conflict");
    script.keys({Key::Escape, Key::Escape, Key::Escape, Key::Escape});
    script.keys({Key::Up, Key::Up, Key::Enter}).wait(30);
    look("playing");
    script.keys({Key::Escape});
    look("paused");
    script.keys({Key::Enter});
    look("count-in");
    script
        .keys({Key::Escape, Key::Up, Key::Up, Key::Enter, Key::Down, Key::Enter, Key::Right,
               Key::Enter})
        .wait(80);
    look("finished");
    script.keys({Key::Down, Key::Down, Key::Enter});
    look("watching");
    Played played(game, script, [&](atlax::Canvas& canvas) {
        if (!looking) return;
        looking = false;
        ++looks;
        for (const std::string& fault : textFaults(canvas)) ADD_FAILURE() << place << ": " << fault;
    });
    EXPECT_EQ(play(played), 9);
    EXPECT_EQ(looks, 18 * static_cast<int>(sizes.size())) << "18 screens";
}

TEST(Texts, doNotOverlapOnAnyScreenInEnglish) {
    lookAtAllTexts("en");
}
TEST(Texts, doNotOverlapOnAnyScreenInGerman) {
    lookAtAllTexts("de");
}
TEST(Texts, doNotOverlapOnAnyScreenInItalian) {
    lookAtAllTexts("it");
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
