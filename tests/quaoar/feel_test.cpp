// The rope as a toy: what a player can do with its elasticity, measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

/// A bolt in the middle of a space so wide that nothing else is met.
std::shared_ptr<const Level> bolt(double spawnX, double spawnY) {
    std::ostringstream text;
    text << R"({"format": "sulfur-scene", "version": 1, "world": {"airFriction": 0.05},
      "level": {"name": "Bolt", "number": 1, "spawn": [)"
         << spawnX << ", " << spawnY << R"(],
        "exit": {"position": [40, 0], "radius": 0.4},
        "bounds": {"min": [-50, -50], "max": [50, 50]}, "killDepth": -60,
        "medals": {"gold": 5, "silver": 10, "bronze": 20}},
      "blueprints": {"bolt": {"shape": "ground", "kind": "fixed", "closed": true, "radius": 0.03,
        "points": [[0.13, 0], [0.065, 0.11], [-0.065, 0.11], [-0.13, 0], [-0.065, -0.11], [0.065, -0.11]]}},
      "bodies": [{"id": "bolt", "blueprint": "bolt"}]})";
    return room(text.str());
}

TickInput towardsBolt(const Session& session, bool fire = true) {
    const sulfur::Point hero = session.heroPosition();
    TickInput input = fireAt(-hero.x(), -hero.y());
    input.fire = fire;
    return input;
}

double distance(const Session& session) {
    return (session.heroPosition() - session.rope().head(session.world())).norm();
}

void shoot(Session& session) {
    for (int n = 0; n < 100 && session.rope().state() != Rope::State::attached; ++n) {
        session.tick(towardsBolt(session));
    }
    ASSERT_EQ(session.rope().state(), Rope::State::attached);
}

TEST(Feel, AStretchedRopeThrowsTheHeroThreeMetresUp) {
    Session session(bolt(0.3, -2.6));
    shoot(session);
    play(session, fireAt(0, 1), 2000);
    const double rest = session.rope().restLength();
    // A hand draws the hero down, slowly, and holds him.
    for (int n = 0; n < 2500; ++n) {
        const double wanted = rest + 1.5 * std::min(1.0, n / 1500.0);
        const sulfur::Vec2 v = session.heroVelocity();
        const double pull = -8000 * (wanted - distance(session)) - 60 * static_cast<double>(v.y());
        for (const sulfur::ParticleId particle : session.world().particles(session.hero())) {
            const sulfur::Real share = session.world().info(particle).mass / 2;
            session.world().applyForce(
                particle, {-20 * v.x() * share, static_cast<sulfur::Real>(pull) * share});
        }
        session.tick(fireAt(0, 1));
    }
    EXPECT_NEAR(distance(session), rest + 1.5, 0.03);
    const double start = session.heroPosition().y();
    double top = start;
    bool held = true;
    for (int n = 0; n < 700; ++n) {
        held = held && distance(session) > rest;
        session.tick(towardsBolt(session, held));
        top = std::max(top, session.heroPosition().y());
    }
    EXPECT_GT(top - start, 3);
}

TEST(Feel, ReelingDoesNotMakeTheRopeSlack) {
    Session session(bolt(0.3, -2.6));
    shoot(session);
    play(session, fireAt(0, 1), 4000);
    const auto slackTicks = [&](TickInput input, int ticks) {
        int slack = 0;
        for (int n = 0; n < ticks; ++n) {
            session.tick(input);
            if (distance(session) < session.rope().restLength()) ++slack;
        }
        return slack;
    };
    TickInput in = fireAt(0, 1), out = fireAt(0, 1);
    in.reelIn = true;
    out.reelOut = true;
    EXPECT_EQ(slackTicks(in, 500), 0);
    EXPECT_EQ(slackTicks(fireAt(0, 1), 1000), 0);
    EXPECT_EQ(slackTicks(out, 500), 0);
    EXPECT_EQ(slackTicks(fireAt(0, 1), 1000), 0);
}

/// What a swing from 60 degrees on the right to the left has of energy in J for each kg, at the
/// end of the reeling in if there is any: that begins where the rope hangs straight down.
double swing(bool reel) {
    Session session(bolt(2.34, -1.35));
    shoot(session);
    int reeled = 0;
    while (reeled < 150) {
        TickInput input = fireAt(0, 1);
        if (session.heroPosition().x() < 0.3) ++reeled;
        input.reelIn = reel && reeled > 0;
        session.tick(input);
    }
    const double speed = static_cast<double>(session.heroVelocity().norm());
    return 0.5 * speed * speed + 9.81 * session.heroPosition().y();
}

TEST(Feel, ReelingInAtTheBottomOfASwingGainsWhatTheRopePulls) {
    // The rope bears the weight and what keeps the hero on his circle, g + v^2 / r with
    // v^2 = 2 g h and h = r / 2, so twice his weight, along the way that it is drawn in by.
    const double way = 1.5 * 0.3;
    EXPECT_NEAR(swing(true) - swing(false), 2 * 9.81 * way, 0.3 * 2 * 9.81 * way);
}

/// How far from the bolt, in the direction of the swing, the hero falls through 5 m below it when
/// he lets go at this angle after the bottom.
double flight(double degrees) {
    Session session(bolt(2.34, -1.35));
    shoot(session);
    bool held = true;
    for (int n = 0; n < 5000 && session.heroPosition().y() > -5; ++n) {
        const sulfur::Point hero = session.heroPosition();
        const double angle = std::atan2(-hero.x(), -hero.y()) * 57.29577951;
        if (session.heroVelocity().x() < 0 && angle > degrees) held = false;
        TickInput input = fireAt(-hero.x(), -hero.y());
        input.fire = held;
        session.tick(input);
    }
    return -session.heroPosition().x();
}

TEST(Feel, LettingGoInTimeDoublesTheFlight) {
    const double early = flight(-15), right = flight(30), late = flight(56);
    EXPECT_GT(right, 2 * early);
    EXPECT_GT(right, 2 * late);
}

}  // namespace
}  // namespace quaoar::test
