// What the game keeps and says: settings, progress, words, prompts, hints, shared replays.
#include <gtest/gtest.h>

#include <atlax/backend.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <regex>
#include <set>

#include "game.hpp"
#include "helpers.hpp"
#include "played.hpp"
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
    texts.push_back("Level of the day");
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

TEST(LevelList, afterTheLastLevelNoneOfThePlayersOwnFollows) {
    const Folder folder("next");
    writeEasyLevels(folder, 2);
    std::filesystem::create_directories(folder / "own/pack");
    writeText(folder / "own/a.json", roomText);
    writeText(folder / "own/b.json", replaced(roomText, "\"number\": 1", "\"number\": 2"));
    writeText(folder / "own/pack/c.json", roomText);
    LevelList all = LevelList::ofFolder(folder.path());
    all.addOwn(folder / "own");
    writeText(folder / "daily-1.json", roomText);
    const std::size_t daily = all.addDaily(folder / "daily-1.json");
    ASSERT_EQ(all.size(), 6u);
    EXPECT_EQ(daily, 5u);
    EXPECT_TRUE(all.own(daily)) << "nothing need be finished before";
    EXPECT_EQ(all.key(daily), "daily-1");
    EXPECT_EQ(all.next(0), std::optional<std::size_t>(1));
    EXPECT_FALSE(all.next(1)) << "the last of the game";
    EXPECT_EQ(all.next(2), std::optional<std::size_t>(3)) << "of the same folder";
    EXPECT_FALSE(all.next(3)) << "another pack";
    EXPECT_FALSE(all.next(4)) << "the day's";
    EXPECT_FALSE(all.next(5));
}

TEST(LevelList, tellsHowHardALevelIsWhereThatWasMeasured) {
    const LevelList levels = LevelList::ofFolder(levelsFolder());
    ASSERT_EQ(levels[0].id, "01-cold-wake");
    EXPECT_EQ(levels.difficulty(0), std::optional<int>(1)) << "all of the bot's games";
    EXPECT_EQ(levels.difficulty(4), std::optional<int>(2)) << "78 %";
    const Folder folder("difficulty");
    writeEasyLevels(folder, 1);
    EXPECT_FALSE(LevelList::ofFolder(folder.path()).difficulty(0)) << "nobody has played it";
    // What was measured of another version is worth nothing.
    std::filesystem::copy_file(levelsFolder() / "01-cold-wake.way", folder / "room-1.way");
    EXPECT_FALSE(LevelList::ofFolder(folder.path()).difficulty(0));
    writeText(folder / "room-1.way", "rubbish");
    EXPECT_FALSE(LevelList::ofFolder(folder.path()).difficulty(0));
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

}  // namespace
}  // namespace quaoar::test
