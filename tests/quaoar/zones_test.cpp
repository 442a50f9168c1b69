// Zones: gravity, wind, liquid and death where they are, when they are on.
#include <gtest/gtest.h>
#include <unistd.h>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

std::shared_ptr<const Level> withZone(const std::string& members, const std::string& more = "",
                                      const std::string& text = roomText) {
    return room(roomWith("\"zones\": [{\"id\": \"z\", " + members + "}]" + more, text));
}

TEST(Zones, GravityIsThatOfTheZone) {
    Session session(withZone(R"("min": [0.5, -1], "max": [4, 4], "gravity": [0, 1])"));
    put(session, 1.5, 1);
    play(session, {}, 500);
    EXPECT_NEAR(session.heroPosition().y(), 1.5, 0.05);  // 1 m/s^2 upwards
    put(session, -1, 1);
    play(session, {}, 100);
    EXPECT_NEAR(session.heroPosition().y(), 1 - 0.5 * 9.81 * 0.04, 0.02);  // 0.2 s of free fall
}

TEST(Zones, NothingIsBlownFasterThanTheWind) {
    Session session(withZone(R"("min": [-4, -1], "max": [4, 4],
                               "gravity": [0, 0], "wind": {"velocity": [2, 0], "drag": 5})"));
    put(session, -3, 1.5);
    float fastest = 0;
    for (int n = 0; n < 500; ++n) {
        session.tick({});
        fastest = std::max(fastest, static_cast<float>(session.heroVelocity().x()));
    }
    EXPECT_GT(fastest, 1.9f);
    EXPECT_LT(fastest, 2.01f);
}

TEST(Zones, APulseComesAndGoes) {
    Session session(withZone(R"("min": [-4, -1], "max": [4, 4], "wind": {"velocity": [0, 5]},
                               "pulse": {"period": 2, "on": 1, "phase": 0.5})"));
    const auto strengthAt = [&](double seconds) {
        while (session.ticks() < static_cast<std::uint64_t>(seconds * 500)) session.tick({});
        return session.workings().zones.strength(0);
    };
    EXPECT_EQ(strengthAt(0), 1);    // half of its time has passed
    EXPECT_EQ(strengthAt(0.4), 1);  // still on
    EXPECT_NEAR(static_cast<double>(strengthAt(0.6)), 0.5, 0.02);
    EXPECT_EQ(strengthAt(1.0), 0);
    EXPECT_EQ(strengthAt(1.8), 1);  // on again since 1.5
    EXPECT_EQ(strengthAt(2.8), 0);
}

TEST(Zones, ASignalTurnsAZoneOn) {
    Session session(withZone(
        R"("min": [-4, 0.5], "max": [4, 4], "gravity": [0, 2], "needs": "lift")",
        R"(, "switches": [{"id": "s", "position": [-3, 1], "size": [0.4, 0.4], "mode": "once",
                           "signal": "lift"}])"));
    put(session, 1, 1);
    play(session, {}, 100);
    EXPECT_LT(session.heroVelocity().y(), -1.5f);
    EXPECT_FALSE(session.workings().signals.on(0));
    put(session, -3, 1);
    session.tick({});
    EXPECT_TRUE(session.events().switched);
    EXPECT_TRUE(session.workings().signals.on(0));
    put(session, 1, 1);
    play(session, {}, 450);
    EXPECT_GT(session.heroVelocity().y(), 0.3f);
}

TEST(Zones, DeadlyZonesKill) {
    Session session(withZone(R"("min": [1, -1], "max": [4, 4], "deadly": true)"));
    play(session, {}, 100);
    EXPECT_EQ(session.restarts(), 0);
    put(session, 2, 1);
    session.tick({});
    EXPECT_TRUE(session.events().died);
}

const std::string pool =
    R"("min": [-4, -1], "max": [4, 1.5], "liquid": {"density": 60, "drag": 2})";

/// Where something floats after ten seconds, and how much it still moves.
struct Floating {
    double height = 0;
    double speed = 0;
};
Floating floating(const std::string& blueprint) {
    Session session(withZone(pool, "", withBody(roomText, "float", blueprint, "[1.5, 1.8]")));
    play(session, {}, 5000);
    EXPECT_EQ(session.world().validate(), "");
    const sulfur::BodyId body = session.instance().body("float");
    return {session.world().centreOfMass(body).y(),
            static_cast<double>(session.world().meanVelocity(body).norm())};
}

TEST(Zones, ACrateFloatsAsDeepAsItWeighs) {
    // 1 m by 0.4 m with 12 kg: 30 kg/m^2, half of the liquid's density, so half of it is under.
    const Floating crate = floating(R"("shape": "box", "size": [1, 0.4], "mass": 12)");
    EXPECT_NEAR(crate.height, 1.5, 0.03);
    EXPECT_LT(crate.speed, 0.01);
    // With 18 kg three quarters are under.
    const Floating heavier = floating(R"("shape": "box", "size": [1, 0.4], "mass": 18)");
    EXPECT_LT(heavier.height, 1.47);
    EXPECT_GT(heavier.height, 1.3);
}

TEST(Zones, HeavyThingsSinkAndSoftOnesFloat) {
    const Floating stone = floating(R"("shape": "box", "size": [0.4, 0.4], "mass": 30)");
    EXPECT_NEAR(stone.height, 0.25, 0.02);  // on the floor
    const Floating jelly = floating(R"("shape": "jelly", "size": [0.6, 0.5], "mass": 9)");
    EXPECT_NEAR(jelly.height, 1.5, 0.05);  // 30 kg/m^2
    EXPECT_LT(jelly.speed, 0.02);
    const Floating ball = floating(R"("shape": "ball", "radius": 0.2, "mass": 3.77)");
    EXPECT_NEAR(ball.height, 1.5, 0.03);  // 30 kg/m^2
}

TEST(Zones, TheHeroFloatsAndARaftBearsHim) {
    Session session(withZone(pool));
    put(session, 0, 1.9);
    play(session, {}, 4000);
    EXPECT_GT(session.heroPosition().y(), 1.35);
    EXPECT_LT(session.heroPosition().y(), 1.52);
    EXPECT_LT(session.heroVelocity().norm(), 0.05f);
    const std::string raft =
        withBody(roomText, "raft", R"("shape": "box", "size": [1.6, 0.2], "mass": 4)", "[0, 1.5]");
    Session riding(withZone(pool, "", raft));
    play(riding, {}, 500);
    put(riding, 0, 1.9);
    play(riding, {}, 1500);
    EXPECT_GT(riding.heroPosition().y(), 1.55);  // dry
}

TEST(Zones, AComingTideWakesWhatSleeps) {
    Session session(withZone(
        R"("min": [-4, 0], "max": [4, 1.5], "liquid": {"density": 60},
           "pulse": {"period": 20, "on": 10, "phase": 17})"));
    put(session, 3, 0.3);
    play(session, {}, 1400);
    EXPECT_TRUE(session.world().asleep(session.instance().body("box-1")));
    play(session, {}, 1500);
    EXPECT_GT(placeOf(session, "box-1").y(), 1.2);
}

TEST(Zones, LiquidBrakesTheRope) {
    const auto swung = [](const std::string& zones) {
        Session session(room(zones.empty() ? roomText : roomWith(zones)));
        put(session, 0, 1.2);
        play(session, fireAt(1, 1), 60);
        EXPECT_EQ(session.rope().state(), Rope::State::attached);
        double farthest = -1e9;
        for (int n = 0; n < 700; ++n) {
            session.tick(fireAt(1, 1));
            farthest = std::max(farthest, session.heroPosition().x());
        }
        return farthest;
    };
    EXPECT_GT(swung(""), swung("\"zones\": [{\"id\": \"z\", \"min\": [-4, -1], \"max\": [4, 3], "
                               "\"liquid\": {\"density\": 60, \"drag\": 6}}]") +
                             0.2);
}

TEST(Zones, HashesAndSnapshots) {
    const auto level = withZone(
        R"("min": [-4, -1], "max": [4, 1], "liquid": {}, "wind": {"velocity": [1, 3]},
           "gravity": [0, -3], "pulse": {"period": 0.7, "on": 0.4})");
    const auto hashes = threeWays(level, [](Session& session) {
        play(session, fireAt(1, 1), 300);
        play(session, {}, 300);
    });
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace quaoar::test
