// The solver: intentions and their text, a player with slips, searches, the robust bot.
#include <gtest/gtest.h>

#include <cmath>

#include "fairness.hpp"
#include "helpers.hpp"
#include "ideas.hpp"
#include "shorten.hpp"
#include "solve.hpp"

namespace quaoar::test {
namespace {

/// The message of what `act` throws.
template <class Act>
std::string problemOf(const Act& act) {
    try {
        act();
    } catch (const WayError& error) {
        return error.what();
    }
    ADD_FAILURE() << "was not refused";
    return "";
}

Intention swing() {
    Intention intention;
    intention.hook = Intention::Hook::shoot;
    intention.aim = {1.23456789, 2.9};
    intention.reel = -1;
    intention.boost = true;
    intention.push = -2;
    intention.until.kind = Until::Kind::line;
    intention.until.place = {-0.5, 0.25};
    intention.until.across = {0.6, -0.8};
    intention.until.earliest = 77;
    intention.until.latest = 401;
    makeExact(intention);
    return intention;
}

TEST(Intention, TheTextGivesTheSameBack) {
    EXPECT_EQ(parseIntention(format(swing())), swing());
    Intention rest;
    rest.until.kind = Until::Kind::calm;
    rest.until.latest = 1500;
    EXPECT_EQ(format(rest), "loose until calm to 3.000");
    EXPECT_EQ(parseIntention(format(rest)), rest);
    std::mt19937_64 random(5);
    Session session(room());
    const Ground ground(room());
    for (int n = 0; n < 200; ++n) {
        const Intention idea = randomIdea(session, ground.field, random);
        EXPECT_EQ(parseIntention(format(idea)), idea) << format(idea);
    }
}

TEST(Intention, WhatIsWrongIsNamed) {
    const auto refusal = [](const char* text) {
        return problemOf([text] { parseIntention(text); });
    };
    EXPECT_NE(refusal("jump until after 1").find("\"jump\""), std::string::npos);
    EXPECT_NE(refusal("shoot 1 nan until after 1").find("\"nan\""), std::string::npos);
    EXPECT_NE(refusal("keep reel up until after 1").find("\"reel up\""), std::string::npos);
    EXPECT_NE(refusal("keep until noon").find("\"line\""), std::string::npos);
    EXPECT_NE(refusal("keep").find("until"), std::string::npos);
    EXPECT_NE(refusal("loose until after 1 please").find("please"), std::string::npos);
    EXPECT_NE(refusal("loose until line 0 0 1 0 from 2 to 1").find("before"), std::string::npos);
}

TEST(Slips, HaveTheSpreadThatTheSkillSays) {
    Nerves nerves(Skill{}, 3);
    double sum = 0, squares = 0, reaction = 0;
    constexpr int count = 4000;
    for (int n = 0; n < count; ++n) {
        const Slip slip = nerves.next();
        sum += slip.aim;
        squares += slip.aim * slip.aim;
        reaction += slip.reaction;
        EXPECT_LE(std::abs(slip.aim), 2.5 * Skill{}.aimSpread);
    }
    EXPECT_NEAR(sum / count, 0, 0.002);
    EXPECT_NEAR(std::sqrt(squares / count), 0.0349, 0.002);
    EXPECT_NEAR(reaction / count / Session::tickRate, 0.2, 0.005);
    EXPECT_EQ(Nerves(Skill::perfect(), 3).next().aim, 0);
    EXPECT_LT(Skill::level(5).aimSpread, Skill::level(1).aimSpread);
}

/// A swing under the ceiling of the room, ended by a clock.
Intention clockwork() {
    Intention intention;
    intention.hook = Intention::Hook::shoot;
    intention.aim = {1, 2.95};
    intention.reel = -1;
    intention.until.latest = 400;
    return intention;
}

TEST(Player, ALineMeansTheSameTickAsTheClock) {
    Session first(room()), second(room());
    Player one(first), other(second);
    ASSERT_EQ(one.carryOut(clockwork()), Ending::done);
    const Intention seen = endedBySight(clockwork(), one.trace());
    EXPECT_EQ(seen.until.kind, Until::Kind::line);
    ASSERT_EQ(other.carryOut(parseIntention(format(seen))), Ending::done);
    EXPECT_EQ(one.ticks(), other.ticks());
    EXPECT_EQ(first.hash(), second.hash());
}

TEST(Player, SlipsChangeWhatHappens) {
    Session first(room()), second(room()), third(room());
    Player(first).carryOut(clockwork());
    Player(second).carryOut(clockwork(), {0.03, 0, 0, 0});
    Player(third).carryOut(clockwork(), {0, 0, 20, 0});
    EXPECT_NE(first.hash(), second.hash());
    EXPECT_EQ(third.ticks(), first.ticks() + 20);
}

TEST(Player, AShotIntoNothingIsAMiss) {
    Session session(room());
    Intention shot = clockwork();
    shot.aim = {3.9, 1.6};  // beyond the rope's reach
    Player player(session);
    EXPECT_EQ(player.carryOut(shot), Ending::missed);
    EXPECT_LT(player.ticks(), 200u);
}

SolveOptions quick() {
    SolveOptions options;
    options.searches = 2;
    options.budget = 300;
    options.polish = 20;
    options.rounds = 0;
    options.quiet = true;
    return options;
}

TEST(Solver, ARoomIsSolvedAndSurvived) {
    const Ground ground(room());
    SolveOptions options = quick();
    options.rounds = 1;
    options.games = 4;
    const Solution solution = solve(ground, options, nullptr);
    const Verdict verdict = verify(ground.level, solution.proof);
    EXPECT_TRUE(verdict.finished);
    EXPECT_TRUE(verdict.sameAsRecorded);
    EXPECT_GE(solution.survival.share(), 0.9) << "nothing in this room can kill";
    EXPECT_GT(solution.policy.places().size(), 0u);
}

TEST(Solver, ThreadsDoNotChangeTheResult) {
    const Ground ground(room());
    SolveOptions options = quick();
    options.rounds = 1;
    options.games = 4;
    const auto textOf = [](const Solution& solution) {
        return WayFile{"room", 1, solution.searched, solution.survival, solution.policy}.format();
    };
    const Solution alone = solve(ground, options, nullptr);
    options.jobs = 3;
    const Solution together = solve(ground, options, nullptr);
    EXPECT_EQ(alone.proof.format(), together.proof.format());
    EXPECT_EQ(alone.simulated, together.simulated);
    EXPECT_EQ(textOf(alone), textOf(together));
}

TEST(Solver, ASteadyWayThroughTheRoomIsFound) {
    const Ground ground(room());
    Solution solution;
    EXPECT_FALSE(searchSteadyWays(ground, quick(), solution).empty());
}

TEST(Policy, ACheckpointIsAGoal) {
    // A bold choice comes to a checkpoint four times of five and falls right behind it; a cautious
    // one always comes to where every second attempt gets on.
    Situation start, later;
    later.place = {5, 0};
    const Intention bold = swing(), cautious;
    Policy policy;
    const int before = policy.add({start, nullptr, {}});
    const int behind = policy.add({later, nullptr, {}});
    const int end = policy.addChoice(behind, cautious);
    for (const Ending ending : {Ending::finished, Ending::died})
        policy.addTry(behind, end, {ending, later, 0});
    const int first = policy.addChoice(before, bold), second = policy.addChoice(before, cautious);
    for (int n = 0; n < 5; ++n) {
        policy.addTry(before, first, {Ending::died, start, 0, n > 0});
        policy.addTry(before, second, {Ending::done, later, 0});
    }
    policy.weigh();
    EXPECT_EQ(policy.place(before).best, first);
    EXPECT_NEAR(policy.place(before).value, 0.8 * 0.75, 1e-9);
    // Who gets on behind the checkpoint, too, is better off than who falls.
    policy.addTry(before, second, {Ending::done, later, 0, true});
    EXPECT_NEAR(policy.worth(policy.place(before).choices[1].tries.back()), 0.75 + 0.25 * 0.5,
                1e-9);
}

TEST(Bot, WhoDoesNotKnowWhatToDoUsesUpHisLives) {
    const Ground ground(room());
    Session session(ground.level);
    const PlayedGame game = playGame(session, ground, Policy(), {});
    EXPECT_FALSE(game.finished);
    EXPECT_EQ(game.tries, 3);
}

/// Practice takes snapshots of one session into others.
TEST(Solver, ASnapshotFitsEverySessionOfTheLevel) {
    const auto level = room();
    Session one(level), other(level);
    play(one, fireAt(0.4, 1), 300);
    play(other, fireAt(-1, 0.5), 100);
    other.restore(*one.snapshot());
    EXPECT_EQ(one.hash(), other.hash());
    play(one, fireAt(0.4, 1), 300);
    play(other, fireAt(0.4, 1), 300);
    EXPECT_EQ(one.hash(), other.hash());
}

TEST(Solver, AKnownWayIsMendedWithoutASearch) {
    const Ground ground(room());
    const Solution first = solve(ground, quick(), nullptr);
    const Ground lighter(room(replaced(roomText, "\"version\": 1,",
                                       "\"version\": 1, \"world\": {\"gravity\": [0, -9.5]},")));
    const Solution mended = solve(lighter, quick(), &first.policy);
    EXPECT_EQ(mended.searched, 0);
    EXPECT_TRUE(verify(lighter.level, mended.proof).finished);
}

/// A way that seldom lasts, here one that never does, is not searched for again.
TEST(Solver, WithAProofThatHoldsNothingIsSearched) {
    const Ground ground(room());
    SolveOptions options = quick();
    const Solution first = solve(ground, options, nullptr);
    options.polish = 0;
    const Policy knowsNothing;
    const Solution again = solve(ground, options, &knowsNothing, first.proof);
    EXPECT_EQ(again.simulated, 0);
    EXPECT_EQ(again.proof.format(), first.proof.format());
}

TEST(Solver, AWayBecomesQuicker) {
    const Ground ground(room());
    Solution solution;
    const std::vector<Way> ways = searchWays(ground, quick(), solution);
    ASSERT_FALSE(ways.empty());
    Session session(ground.level);
    const Way quicker = shortened(session, ways.back(), 1, 60);
    EXPECT_LT(quicker.ticks, ways.back().ticks);
    const auto proof = record(ground.level, quicker);
    ASSERT_TRUE(proof);
    EXPECT_EQ(proof->ticks(), quicker.ticks);
}

TEST(Solver, AWalledExitIsToldAtOnce) {
    const std::string text =
        replaced(replaced(roomText, "\"bodies\": [",
                          "\"bodies\": [\n    {\"id\": \"wall\", \"blueprint\": \"wall\"},"),
                 "\"box\": {",
                 "\"wall\": {\"shape\": \"ground\", \"kind\": \"fixed\", "
                 "\"points\": [[2, 0], [2, 3]]},\n    \"box\": {");
    const Ground ground(room(text));
    try {
        solve(ground, quick(), nullptr);
        FAIL() << "was not refused";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("no free space"), std::string::npos);
    }
}

TEST(Fairness, TheRoomHasAWayOnFromEverywhere) {
    const Ground ground(room());
    FairOptions options;
    options.states = 3;
    const FairReport report = checkFairness(ground, nullptr, options);
    EXPECT_EQ(report.goOn, 3);
    EXPECT_TRUE(report.stuck.empty());
}

/// A pit without anything in reach, from which nobody comes out and in which nobody dies.
TEST(Fairness, APitWithoutAWayOutIsFound) {
    const std::string pit = replaced(
        replaced(roomText, "\"points\": [[-4, 0], [4, 0], [4, 3], [-4, 3]]",
                 "\"points\": [[-4, 0], [4, 0], [4, 9], [-4, 9]]"),
        "\"position\": [3.2, 0.3], \"radius\": 0.4", "\"position\": [0, 8.5], \"radius\": 0.4");
    const std::string tall = replaced(pit, "\"max\": [4, 4]", "\"max\": [4, 9]");
    const std::string slick = replaced(tall, "\"killDepth\": -3,",
                                       "\"killDepth\": -3, \"surfaces\": {\"room\": {\"sticky\": "
                                       "false}, \"box-1\": {\"sticky\": false}},");
    FairOptions options;
    options.states = 2;
    options.budget = 30;
    const FairReport report = checkFairness(Ground(room(slick)), nullptr, options);
    EXPECT_EQ(report.stuck.size(), 2u);
}

TEST(WayFile, IsReadAsItWasWritten) {
    WayFile way;
    way.levelId = "room";
    way.levelHash = 0x1234;
    way.searched = 321;
    way.survival = {200, 181, 2, 14.5};
    Place place;
    place.here = {{0.5, 0.25}, {1, -2}, true, {0.5, 2.95}, 1.5, 5};
    place.value = 0.75;
    place.choices.push_back({swing(), {}, 0.75});
    place.best = 0;
    way.policy.add(place);
    place.here = {};
    way.policy.add(place);
    const WayFile read = WayFile::parse(way.format(), "room.way");
    EXPECT_EQ(read.format(), way.format());
    EXPECT_EQ(read.survival.finished, 181);
    EXPECT_EQ(read.policy.places()[0].here, way.policy.places()[0].here);
    EXPECT_EQ(read.policy.places()[0].choices[0].intention, swing());

    const std::string text = way.format();
    EXPECT_NE(problemOf([&] {
                  WayFile::parse(text.substr(0, text.size() - 5), "room.way");
              }).find("room.way:"),
              std::string::npos);
    EXPECT_NE(problemOf([&] {
                  WayFile::parse(replaced(text, "shoot", "shot"), "room.way");
              }).find("room.way:10: the intention begins with \"shot\""),
              std::string::npos);
}

}  // namespace
}  // namespace quaoar::test
