// Movers and the switches that start them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

const std::string plank = withBody(
    roomText, "plank", R"("shape": "box", "size": [1, 0.2], "kind": "kinematic")", "[1, 0.5]");

std::shared_ptr<const Level> moving(const std::string& members, const std::string& more = "") {
    return room(roomWith("\"movers\": [{\"body\": \"plank\", " + members + "}]" + more, plank));
}

sulfur::Point after(Session& session, double seconds) {
    while (session.ticks() < static_cast<std::uint64_t>(std::lround(seconds * 500))) {
        session.tick({});
    }
    return placeOf(session, "plank");
}

TEST(Movers, PingpongGoesThereAndBackWithItsRests) {
    Session session(moving(R"("path": [[2, 0.5], [2, 1.5]], "seconds": 2, "secondsBack": 1,
                              "pauseStart": 0.5, "pauseEnd": 0.25, "ease": false)"));
    EXPECT_NEAR((after(session, 0.5) - sulfur::Point(1, 0.5)).norm(), 0, 0.01);
    EXPECT_NEAR((after(session, 1.5) - sulfur::Point(2, 0.5)).norm(), 0, 0.01);
    EXPECT_NEAR((after(session, 2.6) - sulfur::Point(2, 1.5)).norm(), 0, 0.01);
    EXPECT_EQ(session.workings().movers.along(0), 1);
    EXPECT_NEAR((after(session, 3.25) - sulfur::Point(2, 0.5)).norm(), 0, 0.01);
    EXPECT_NEAR((after(session, 3.75) - sulfur::Point(1, 0.5)).norm(), 0, 0.01);
    EXPECT_NEAR((after(session, 4.25 + 1) - sulfur::Point(2, 0.5)).norm(), 0, 0.01);
}

TEST(Movers, LoopGoesRoundAndPhaseIsAhead) {
    Session session(moving(R"("path": [[2, 0.5], [2, 1.5], [1, 1.5]], "seconds": 4,
                              "mode": "loop", "phase": 1)"));
    EXPECT_NEAR((placeOf(session, "plank") - sulfur::Point(2, 0.5)).norm(), 0, 0.01);
    EXPECT_NEAR((after(session, 1) - sulfur::Point(2, 1.5)).norm(), 0, 0.01);
    EXPECT_NEAR((after(session, 2.5) - sulfur::Point(1, 1)).norm(), 0, 0.01);
    EXPECT_NEAR((after(session, 5) - sulfur::Point(2, 1.5)).norm(), 0, 0.01);
}

TEST(Movers, SpinTurnsForEver) {
    Session session(moving(R"("spin": 2)"));
    after(session, 10);
    const double turned = session.world().angle(session.instance().body("plank"));
    EXPECT_NEAR(std::remainder(turned - 20, 2 * 3.14159265358979), 0, 0.01);
    EXPECT_NEAR((placeOf(session, "plank") - sulfur::Point(1, 0.5)).norm(), 0, 0.01);
}

TEST(Movers, EaseSetsOutGently) {
    Session hard(moving(R"("path": [[3, 0.5]], "seconds": 1, "ease": false)"));
    Session gentle(moving(R"("path": [[3, 0.5]], "seconds": 1)"));
    EXPECT_NEAR(after(hard, 0.1).x(), 1.2, 0.01);
    EXPECT_LT(after(gentle, 0.1).x(), 1.1);
    EXPECT_NEAR(after(gentle, 0.5).x(), 2, 0.01);
    EXPECT_NEAR(after(gentle, 1).x(), 3, 0.01);
}

TEST(Movers, ALiftCarriesTheHero) {
    Session session(moving(R"("path": [[1, 1.7]], "seconds": 2, "pauseStart": 0.5,
                              "pauseEnd": 9)"));
    put(session, 1, 0.75);
    after(session, 3);
    EXPECT_NEAR(session.heroPosition().y(), 1.7 + 0.22, 0.04);
    EXPECT_NEAR(session.heroPosition().x(), 1, 0.2);
}

TEST(Movers, TheRopeHoldsOnALift) {
    Session session(moving(R"("path": [[1, 2.4]], "seconds": 2, "pauseEnd": 9)"));
    put(session, 0, 0.3);
    play(session, fireAt(1, 0.3), 60);
    ASSERT_EQ(session.rope().state(), Rope::State::attached);
    const double low = session.heroPosition().y();
    play(session, fireAt(1, 0.3), 1200);
    EXPECT_GT(session.heroPosition().y(), low + 0.4);
}

TEST(Movers, ACrusherKills) {
    Session session(moving(R"("path": [[1, 0.1]], "seconds": 0.5, "pauseStart": 0.5)"));
    put(session, 1, 0.18);
    bool died = false;
    for (int n = 0; n < 600 && !died; ++n) {
        session.tick({});
        died = session.events().died;
    }
    EXPECT_TRUE(died);
}

const std::string door = R"("path": [[1, 1.5]], "seconds": 0.5, "mode": "door", "needs": "open",
                            "ease": false)";

std::string plate(const std::string& members) {
    return R"(, "switches": [{"id": "s", "position": [-3, 0.2], "size": [0.4, 0.3],
              "signal": "open", )" +
           members + "}]";
}

TEST(Movers, ADoorFollowsItsSignal) {
    Session session(moving(door, plate(R"("mode": "hold")")));
    play(session, {}, 300);
    EXPECT_NEAR(placeOf(session, "plank").y(), 0.5, 0.01);
    put(session, -3, 0.3);
    play(session, {}, 300);
    EXPECT_NEAR(placeOf(session, "plank").y(), 1.5, 0.01);
    EXPECT_TRUE(session.workings().switches.on(0));
    put(session, 0, 0.3);
    session.tick({});
    EXPECT_TRUE(session.events().switched);
    play(session, {}, 300);
    EXPECT_NEAR(placeOf(session, "plank").y(), 0.5, 0.01);
}

TEST(Movers, TogglesAndLatches) {
    for (const char* mode : {"toggle", "once"}) {
        Session session(moving(door, plate(std::string("\"mode\": \"") + mode + "\"")));
        const auto press = [&] {
            put(session, -3, 0.3);
            play(session, {}, 5);
            put(session, 0, 0.3);
            play(session, {}, 5);
            return session.workings().signals.on(0);
        };
        EXPECT_TRUE(press());
        EXPECT_EQ(press(), std::string(mode) == "once");
        EXPECT_TRUE(press());
    }
}

TEST(Movers, ASwitchMayLast) {
    Session session(moving(door, plate(R"("lasts": 0.4)")));
    put(session, -3, 0.3);
    play(session, {}, 5);
    put(session, 0, 0.3);
    play(session, {}, 190);
    EXPECT_TRUE(session.workings().signals.on(0));
    play(session, {}, 15);
    EXPECT_FALSE(session.workings().signals.on(0));
}

TEST(Movers, APickupIsAKey) {
    Session session(
        moving(door, R"(, "pickups": [{"id": "key", "position": [-3, 1], "signal": "open"}])"));
    play(session, {}, 10);
    EXPECT_FALSE(session.workings().signals.on(0));
    put(session, -3, 1);
    play(session, {}, 300);
    EXPECT_TRUE(session.workings().signals.on(0));
    EXPECT_NEAR(placeOf(session, "plank").y(), 1.5, 0.01);
}

TEST(Movers, SwitchesWeighWhatLiesOnThem) {
    // The box of the room weighs 1 kg and lies at x = -2.
    const auto on = [](const std::string& members) {
        const std::string switches =
            R"(, "switches": [{"id": "s", "position": [-2, 0.2], "size": [0.6, 0.3],
               "signal": "open", )" +
            members + "}]";
        Session session(moving(door, switches));
        play(session, {}, 300);
        return session.workings().switches.on(0);
    };
    EXPECT_TRUE(on(R"("by": "any")"));
    EXPECT_TRUE(on(R"("by": "any", "weight": 0.9)"));
    EXPECT_FALSE(on(R"("by": "any", "weight": 1.1)"));
    EXPECT_TRUE(on(R"("by": "box-1")"));
    EXPECT_FALSE(on(R"("by": "plank")"));
    EXPECT_FALSE(on(R"("by": "hero")"));
}

TEST(Movers, TheRopeSwitchesWhereItIsTied) {
    Session session(moving(door, R"(, "switches": [{"id": "s", "position": [0, 2.95],
        "size": [0.4, 0.3], "by": "rope", "signal": "open"}])"));
    play(session, fireAt(0, 1), 100);
    EXPECT_TRUE(session.workings().switches.on(0));
    play(session, {}, 2);
    EXPECT_FALSE(session.workings().switches.on(0));
}

TEST(Movers, OnceWaitsForItsSignalAndStays) {
    Session session(moving(R"("path": [[1, 1.5]], "seconds": 0.5, "mode": "once",
                              "needs": "open")",
                           plate(R"("mode": "hold")")));
    play(session, {}, 400);
    EXPECT_NEAR(placeOf(session, "plank").y(), 0.5, 0.01);
    put(session, -3, 0.3);
    play(session, {}, 5);
    put(session, 0, 0.3);
    play(session, {}, 600);
    EXPECT_NEAR(placeOf(session, "plank").y(), 1.5, 0.01);
}

TEST(Movers, TheExitOpensBySignal) {
    const std::string text =
        replaced(roomWith(R"("switches": [{"id": "s", "position": [-3, 0.2], "size": [0.4, 0.3],
                    "mode": "once", "signal": "open"}])"),
                 "\"radius\": 0.4}", "\"radius\": 0.4, \"needs\": \"open\"}");
    Session session(room(text));
    put(session, 3.2, 0.3);
    play(session, {}, 50);
    EXPECT_EQ(session.phase(), Session::Phase::playing);
    EXPECT_FALSE(session.exitOpen());
    put(session, -3, 0.3);
    play(session, {}, 5);
    EXPECT_TRUE(session.exitOpen());
    put(session, 3.2, 0.3);
    play(session, {}, 5);
    EXPECT_EQ(session.phase(), Session::Phase::finished);
}

TEST(Movers, HashesAndSnapshots) {
    const auto level = moving(door, plate(R"("mode": "toggle")"));
    const auto hashes = threeWays(level, [](Session& session) {
        put(session, -3, 0.3);
        play(session, {}, 77);
        play(session, fireAt(1, 1), 200);
    });
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Movers, ACheckpointBringsMoversBack) {
    Session session(
        moving(R"("path": [[1, 1.5]], "seconds": 1, "pauseEnd": 9, "ease": false)",
               R"(, "checkpoints": [{"id": "c", "position": [0, 0.3], "radius": 0.5}])"));
    session.tick({});
    ASSERT_TRUE(session.events().checkpoint);
    play(session, {}, 400);
    EXPECT_GT(placeOf(session, "plank").y(), 1.2);
    session.retry();
    play(session, {}, 50);
    EXPECT_NEAR(placeOf(session, "plank").y(), 0.6, 0.02);
}

}  // namespace
}  // namespace quaoar::test
