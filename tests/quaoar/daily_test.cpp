// The level of the day: made of a date, and proven before it is offered.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <quaoar/level_check.hpp>
#include <set>
#include <thread>

#include "daily_course.hpp"
#include "helpers.hpp"
#include "played.hpp"
#include "search.hpp"

namespace quaoar::test {
namespace {

using Screen = Game::Screen;
using atlax::Key;

constexpr const char* aDay = "2026-11-29";

std::string dayOf(int number) {
    char text[32];
    std::snprintf(text, sizeof text, "2027-%02d-%02d", 1 + number / 28, 1 + number % 28);
    return text;
}

bool waitFor(const Daily& daily) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(4);
    while (!daily.ended() && std::chrono::steady_clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return daily.ready();
}

TEST(Daily, ADateIsALevel) {
    EXPECT_EQ(dailyCourse(aDay, 0), dailyCourse(aDay, 0));
    EXPECT_EQ(contentHash(dailyCourse(aDay, 0)), contentHash(dailyCourse(aDay, 0)));
    std::set<std::string> courses;
    for (int plan = 0; plan < Daily::mostPlans; ++plan)
        EXPECT_TRUE(courses.insert(dailyCourse(aDay, plan)).second);
    EXPECT_EQ(today().size(), 10u);
    EXPECT_EQ(dailyId(aDay), "daily-2026-11-29");
}

TEST(Daily, EveryDayHasAWayAndPlacesToRest) {
    std::set<Theme::World> worlds;
    for (int number = 0; number < 24; ++number) {
        const std::string date = dayOf(number * 5);
        const Level level = parseLevel(dailyCourse(date, 0), "daily.json");
        SCOPED_TRACE(date);
        EXPECT_EQ(level.name, "Level of the day");
        EXPECT_EQ(level.checkpoints.size(), 3u);
        EXPECT_GE(level.pickups.size(), 1u);
        const auto problem = checkLevel(level);
        EXPECT_FALSE(problem) << problem->object << problem->problem;
        const Ground ground(std::make_shared<const Level>(level));
        const double way = ground.field.at(level.spawn);
        EXPECT_GT(way, 15);
        EXPECT_LT(way, 50);
        worlds.insert(level.theme.world);
    }
    EXPECT_EQ(worlds.size(), 4u);
}

TEST(Daily, StopsAtOnceWhenTheGameEnds) {
    const Folder folder("daily-stop");
    const auto before = std::chrono::steady_clock::now();
    { const Daily daily(folder / "daily", aDay); }
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20));
}

TEST(Daily, IsNotOfferedWhereNothingCanBeWritten) {
    const Daily daily("/proc/no/such/place", aDay);
    EXPECT_FALSE(waitFor(daily));
}

TEST(Daily, IsProvenKeptAndOffered) {
    const Folder folder("daily");
    const auto place = folder / "daily";
    std::filesystem::create_directories(place);
    writeText(place / "daily-2020-01-01.json", "{}");
    writeText(place / "other.json", "{}");
    {
        const Daily daily(place, aDay);
        EXPECT_FALSE(daily.ready()) << "not before it is proven";
        ASSERT_TRUE(waitFor(daily));
        const auto level = std::make_shared<const Level>(readLevel(daily.file()));
        const Verdict verdict = verify(level, Recording::read(proofOf(daily.file())));
        EXPECT_TRUE(verdict.finished && verdict.sameAsRecorded);
        EXPECT_NEAR(level->medals.gold,
                    1.15 * static_cast<double>(verdict.ticks) / Session::tickRate, 0.01);
    }
    EXPECT_FALSE(std::filesystem::exists(place / "daily-2020-01-01.json"));
    EXPECT_TRUE(std::filesystem::exists(place / "other.json"));
    const std::string proof = readText(place / "daily-2026-11-29.proof");

    // The next time it is there at once, and can be chosen from the menu.
    writeEasyLevels(folder, 2);
    Preferences preferences(folder / "settings.json");
    Game game({.levels = LevelList::ofFolder(folder.path()),
               .progress = folder / "data",
               .daily = std::pair(std::filesystem::path(place), std::string(aDay))},
              preferences);
    int waits = 0;
    Script script;
    script.keys({Key::Down, Key::Down});  // the levels, whose place is the same when it comes
    for (int i = 0; i < 200; ++i)
        script.next([&](atlax::Platform&) {
            if (game.levels().size() == 3) return;
            ++waits;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        });
    script.then([&](atlax::Platform&) {
        ASSERT_EQ(game.levels().size(), 3u);
        EXPECT_EQ(game.selected(), 2u);
    });
    script.keys({Key::Up, Key::Enter});
    script.then([&](atlax::Platform&) {
        EXPECT_EQ(game.screen(), Screen::playing);
        EXPECT_EQ(game.session().level().id, "daily-2026-11-29");
    });
    Played played(game, script);
    EXPECT_EQ(play(played), 9);
    EXPECT_EQ(game.progress().of("daily-2026-11-29").attempts, 1);
    EXPECT_EQ(readText(place / "daily-2026-11-29.proof"), proof) << "not searched anew";
}

}  // namespace
}  // namespace quaoar::test
