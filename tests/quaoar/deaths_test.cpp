// What kills, and what becomes of the hero then: checkpoints, pick-ups, countdown, a cut rope.
#include <gtest/gtest.h>
#include <unistd.h>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

/// A plate on the floor under the spawn.
std::string withSpikes(const std::string& text) {
    return withBody(replaced(text, "\"radius\": 0.4}", "\"radius\": 0.4}"), "spikes",
                    R"("shape": "box", "size": [1, 0.1], "kind": "fixed")", "[0, 0.1]");
}

const std::string deadly = R"("surfaces": {"spikes": {"deadly": true}})";
const std::string checkpoint =
    R"("checkpoints": [{"id": "first", "position": [-1, 1], "radius": 0.6}])";

/// Ticks until he dies, or -1.
int ticksToDeath(Session& session, int most, const TickInput& input = {}) {
    for (int n = 0; n < most; ++n) {
        session.tick(input);
        if (session.events().died) return n;
    }
    return -1;
}

TEST(Deaths, TouchingSpikesKills) {
    Session session(room(withSpikes(roomWith(deadly))));
    EXPECT_GE(ticksToDeath(session, 500), 0);
    EXPECT_TRUE(session.events().restarted);  // there is no checkpoint
    EXPECT_EQ(session.events().death, Death::touched);
    EXPECT_NEAR((session.events().diedAt - sulfur::Point(0, 0.3)).norm(), 0, 0.1);
    EXPECT_EQ(session.restarts(), 1);
    Session harmless(room(withSpikes(roomText)));
    EXPECT_EQ(ticksToDeath(harmless, 500), -1);
}

TEST(Deaths, PiecesOfSomethingDeadlyAreDeadly) {
    const std::string wall =
        withBody(roomWith(R"("surfaces": {"wall": {"deadly": true, "sticky": false}})"), "wall",
                 R"("shape": "wall", "size": [0.8, 0.4], "columns": 4, "rows": 2, "mass": 4,
                    "strength": 400)",
                 R"([-2, 2], "angle": 0.2)");
    Session session(room(wall));
    play(session, {}, 750);
    int pieces = 0;
    for (const sulfur::BodyId body : session.world().bodies()) {
        if (session.world().name(body) != "wall") continue;
        ++pieces;
        EXPECT_TRUE(session.surface(body).deadly);
        EXPECT_FALSE(session.surface(body).sticky);
        ASSERT_TRUE(session.origin(body).has_value());
        EXPECT_EQ(session.level().scene.bodies[*session.origin(body)].id, "wall");
    }
    EXPECT_GE(pieces, 2);  // it has broken
    EXPECT_FALSE(session.origin(session.hero()).has_value());
}

TEST(Deaths, ACheckpointKeepsTheWorldAndTheTimer) {
    Session session(room(withSpikes(roomWith(deadly + "," + checkpoint))));
    EXPECT_FALSE(session.checkpoint().has_value());
    put(session, 1.5, 0.3);
    play(session, {}, 300);
    put(session, -1, 1.2);
    session.tick(fireAt(1, 1));
    EXPECT_TRUE(session.events().checkpoint);
    EXPECT_EQ(session.checkpoint(), 0u);
    EXPECT_TRUE(session.reached(0));
    play(session, {}, 200);
    const sulfur::BodyId box = session.instance().body("box-1");
    const sulfur::Point lay = session.world().centreOfMass(box);
    session.world().applyImpulse(box, {1, 2}, lay);
    play(session, {}, 200);
    EXPECT_GT((session.world().centreOfMass(box) - lay).norm(), 0.2);
    const auto timer = session.timerTicks();
    put(session, 0, 0.4);
    ASSERT_GE(ticksToDeath(session, 500), 0);
    EXPECT_FALSE(session.events().restarted);
    EXPECT_EQ(session.deaths(), 1);
    EXPECT_EQ(session.restarts(), 0);
    EXPECT_GT(session.timerTicks(), timer);
    EXPECT_NEAR((session.heroPosition() - sulfur::Point(-1, 1)).norm(), 0, 1e-6);
    EXPECT_EQ(session.heroVelocity().norm(), 0);
    EXPECT_NEAR((session.world().centreOfMass(box) - lay).norm(), 0, 0.02);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
    EXPECT_EQ(session.world().validate(), "");
    play(session, {}, 20);
    put(session, -1, 1);
    session.tick({});
    EXPECT_FALSE(session.events().checkpoint);  // only the first time
}

TEST(Deaths, RetryIsADeathAndRestartBeginsAnew) {
    Session session(room(roomWith(checkpoint)));
    const std::uint64_t fresh = session.hash();
    put(session, -1, 1);
    play(session, {}, 10);
    TickInput retry;
    retry.retry = true;
    session.tick(retry);
    EXPECT_TRUE(session.events().died);
    EXPECT_EQ(session.deaths(), 1);
    EXPECT_TRUE(session.checkpoint().has_value());
    TickInput restart;
    restart.restart = true;
    session.tick(restart);
    EXPECT_FALSE(session.checkpoint().has_value());
    EXPECT_EQ(session.deaths(), 0);
    EXPECT_EQ(session.hash(), fresh);
}

TEST(Deaths, TheRopeHangsNoLongerAfterDeath) {
    Session session(room(roomWith(checkpoint)));
    put(session, -1, 1);
    play(session, fireAt(0, 1), 100);
    ASSERT_EQ(session.rope().state(), Rope::State::attached);
    const std::size_t bodies = session.level().scene.bodies.size() + 1;
    TickInput retry = fireAt(0, 1);
    retry.retry = true;
    session.tick(retry);
    EXPECT_EQ(session.world().bodies().size(), bodies);
    play(session, fireAt(0, 1), 100);  // still held: it needs a new press
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
    play(session, {}, 1);
    play(session, fireAt(0, 1), 200);
    EXPECT_EQ(session.rope().state(), Rope::State::attached);
}

TEST(Deaths, PickupsSinceTheCheckpointAreBack) {
    Session session(room(roomWith(checkpoint + R"(,
        "pickups": [{"id": "a", "position": [-1, 2]}, {"id": "b", "position": [2, 2]}])")));
    put(session, -1, 2);
    session.tick({});
    EXPECT_TRUE(session.events().pickedUp);
    EXPECT_TRUE(session.pickedUp(0));
    put(session, -1, 1);
    session.tick({});
    put(session, 2, 2);
    session.tick({});
    EXPECT_EQ(session.pickups(), 2);
    session.retry();
    EXPECT_EQ(session.pickups(), 1);
    EXPECT_FALSE(session.pickedUp(1));
    session.restart();
    EXPECT_EQ(session.pickups(), 0);
}

TEST(Deaths, SnapshotsHoldTheCheckpoint) {
    Session session(room(withSpikes(roomWith(deadly + "," + checkpoint))));
    put(session, -1, 1);
    play(session, fireAt(1, 1), 60);
    const auto saved = session.snapshot();
    const std::uint64_t before = session.hash();
    const auto goOn = [&] {
        play(session, {}, 100);
        put(session, 0, 0.4);
        play(session, {}, 400);
        EXPECT_GE(session.deaths(), 1);
        play(session, fireAt(-1, 1), 300);
        return session.hash();
    };
    const std::uint64_t after = goOn();
    session.restart();
    session.restore(*saved);
    EXPECT_EQ(session.hash(), before);
    EXPECT_EQ(goOn(), after);
}

TEST(Deaths, AHeavyWeightCrushesAndALightOneDoesNot) {
    const auto under = [](const char* mass) {
        Session session(room(withBody(
            roomText, "weight",
            std::string(R"("shape": "box", "size": [0.8, 0.8], "mass": )") + mass, "[0, 1.3]")));
        return ticksToDeath(session, 1000);
    };
    EXPECT_EQ(under("1"), -1);
    EXPECT_GE(under("60"), 0);
}

TEST(Deaths, NoLandingCrushes) {
    const std::string high =
        replaced(replaced(roomText, "[4, 3], [-4, 3]", "[4, 40], [-4, 40]"), "[4, 4]", "[4, 40]");
    Session session(room(replaced(high, "[0, 0.3]", "[0, 30]")));
    EXPECT_EQ(ticksToDeath(session, 4000), -1);
    EXPECT_LT(session.heroPosition().y(), 0.3);
}

TEST(Deaths, AFallingRockKillsAndALyingOneDoesNot) {
    const std::string text =
        withBody(roomWith(R"("surfaces": {"rock": {"deadlySpeed": 3}})"), "rock",
                 R"("shape": "box", "size": [0.3, 0.3], "mass": 2)", "[0, 2.5]");
    Session session(room(text));
    const int fell = ticksToDeath(session, 1000);
    EXPECT_GE(fell, 0);
    EXPECT_LT(fell, 400);
    Session other(room(text));
    put(other, -1, 0.3);
    play(other, {}, 1000);
    put(other, placeOf(other, "rock").x(), 2.5);  // now he falls on it, at more than 5 m/s
    EXPECT_EQ(ticksToDeath(other, 1000), -1);
}

TEST(Deaths, OutOfTheWorldHeDies) {
    Session session(room());
    put(session, 0, 13);
    play(session, {}, 1);
    EXPECT_EQ(session.restarts(), 0);
    put(session, 0, 15);
    play(session, {}, 1);
    EXPECT_EQ(session.restarts(), 1);
    put(session, 15, 1);
    play(session, {}, 1);
    EXPECT_EQ(session.restarts(), 2);
}

TEST(Deaths, WhatFellOutOfTheLevelIsOutOfTheGame) {
    const std::string text = replaced(roomText, "[-2, 0.3]", "[-9, 0.3]");
    Session session(room(text));
    const sulfur::BodyId box = session.instance().body("box-1");
    play(session, {}, 2000);
    EXPECT_FALSE(session.world().isEnabled(box));
    EXPECT_LT(placeOf(session, "box-1").y(), -8);
    EXPECT_GT(placeOf(session, "box-1").y(), -9);
}

TEST(Deaths, ABladeCutsTheRope) {
    const std::string text =
        withBody(roomWith(R"("surfaces": {"blade": {"cuts": true}})"), "blade",
                 R"("shape": "box", "size": [0.1, 0.1], "mass": 1)", "[-0.6, 2]");
    Session session(room(text));
    bool cut = false;
    play(session, fireAt(0, 1), 100);
    ASSERT_EQ(session.rope().state(), Rope::State::attached);
    for (int n = 0; n < 200 && !cut; ++n) {
        if (n == 0) {
            session.world().setVelocity(session.instance().body("blade"), {4, 2});
        }
        session.tick(fireAt(0, 1));
        cut = session.events().cut;
    }
    EXPECT_TRUE(cut);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Deaths, TheCountdownEndsTheAttempt) {
    Session session(room(roomWith(R"("countdown": 1)")));
    play(session, {}, 600);  // the timer waits for the player
    EXPECT_EQ(session.secondsLeft(), 1.0);
    const int ticks = ticksToDeath(session, 600, fireAt(0, 1));
    EXPECT_NEAR(ticks, 500, 2);
    EXPECT_EQ(session.events().death, Death::late);
    EXPECT_TRUE(session.events().restarted);
    EXPECT_FALSE(Session(room()).secondsLeft().has_value());
}

TEST(Deaths, TheLevelSetsSpeedLimitAndReach) {
    const std::string high =
        replaced(roomWith(R"("speedLimit": 3, "reach": 1)"), "[0, 0.3]", "[0, 2.7]");
    Session session(room(high));
    float fastest = 0;
    for (int n = 0; n < 400; ++n) {
        session.tick({});
        fastest = std::max(fastest, static_cast<float>(session.heroVelocity().norm()));
    }
    EXPECT_LT(fastest, 3.1f);
    EXPECT_GT(fastest, 2.5f);
    EXPECT_FALSE(session.preview({0, 1}).hits);  // the ceiling is at 3 m
    EXPECT_NEAR((session.preview({0, 1}).to - session.heroPosition()).norm(), 1, 1e-5);
}

/// The same stretch for each metre, whatever the links are long.
TEST(Deaths, ALongRopeIsTheSameRope) {
    const auto hang = [](double reach) {
        const std::string text = replaced(replaced(roomWith("\"reach\": " + std::to_string(reach)),
                                                   "[4, 3], [-4, 3]", "[4, 12], [-4, 12]"),
                                          "\"max\": [4, 4]", "\"max\": [4, 12]");
        Session session(room(text));
        put(session, 0, 12 - 0.95 * std::min(reach, 4.0));
        play(session, fireAt(0, 1), 5000);
        EXPECT_LE(session.rope().particles().size(), 81u);
        const double rest = session.rope().restLength();
        const double apart = (session.heroPosition() - session.rope().head(session.world())).norm();
        return (apart - rest) / rest;
    };
    EXPECT_NEAR(hang(4), hang(8), 0.1 * hang(4));
}

}  // namespace
}  // namespace quaoar::test
