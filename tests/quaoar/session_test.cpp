// The rules: determinism, the rope's physics, restart, finish.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

/// A made-up player who does everything in turn.
TickInput lively(std::uint64_t tick) {
    TickInput input;
    const double angle = 0.3 + static_cast<double>(tick / 200 % 5) * 0.6;
    setAim(input, std::cos(angle), std::sin(angle));
    input.fire = tick % 400 > 60;
    input.reelIn = tick % 700 < 250;
    input.reelOut = tick % 700 > 600;
    input.boost = tick % 900 > 700;
    input.push = static_cast<std::int8_t>(static_cast<int>(tick / 150 % 3) * 127 - 127);
    return input;
}

/// Shoots straight up and waits until the rope holds.
void hang(Session& session, double x = 0, double y = 1) {
    play(session, fireAt(x, y), 100);
    ASSERT_EQ(session.rope().state(), Rope::State::attached);
}

double hangingLength(const Session& session) {
    return (session.heroPosition() - session.rope().head(session.world())).norm();
}

TEST(Session, TwoRunsGiveTheSameHash) {
    Session a(firstLevel()), b(firstLevel());
    EXPECT_EQ(a.hash(), b.hash());
    for (std::uint64_t n = 0; n < 3000; ++n) {
        a.tick(lively(n));
        b.tick(lively(n));
        ASSERT_EQ(a.hash(), b.hash()) << "tick " << n;
    }
}

TEST(Session, OtherInputsGiveAnotherHash) {
    Session a(firstLevel()), b(firstLevel());
    play(a, fireAt(0, 1), 300);
    play(b, fireAt(0.01, 1), 300);
    EXPECT_NE(a.hash(), b.hash());
}

TEST(Session, ASnapshotGoesOnAsIfNothingHadHappened) {
    Session session(firstLevel());
    for (std::uint64_t n = 0; n < 700; ++n) session.tick(lively(n));
    const auto snapshot = session.snapshot();
    const std::uint64_t before = session.hash();
    for (std::uint64_t n = 700; n < 1900; ++n) session.tick(lively(n));
    const std::uint64_t after = session.hash();
    session.restore(*snapshot);
    EXPECT_EQ(session.hash(), before);
    for (std::uint64_t n = 700; n < 1900; ++n) session.tick(lively(n));
    EXPECT_EQ(session.hash(), after);
}

TEST(Session, RestartIsANewSession) {
    const Session fresh(firstLevel());
    Session played(firstLevel());
    for (std::uint64_t n = 0; n < 900; ++n) played.tick(lively(n));
    TickInput restart;
    restart.restart = true;
    played.tick(restart);
    EXPECT_EQ(played.hash(), fresh.hash());
    EXPECT_EQ(played.ticks(), 0u);
    EXPECT_EQ(played.restarts(), 1);
    Session other(firstLevel());
    for (std::uint64_t n = 0; n < 900; ++n) {
        played.tick(lively(n));
        other.tick(lively(n));
    }
    EXPECT_EQ(played.hash(), other.hash());
}

TEST(Session, TheHeroComesToRestOnTheGround) {
    Session session(room());
    play(session, {}, 2500);
    const double height = session.heroPosition().y();
    EXPECT_GT(height, 0.05 + 0.08);  // the floor's half thickness, a squashed hero
    EXPECT_LT(height, 0.05 + 0.13);
    EXPECT_LT(session.heroVelocity().norm(), 0.25f);  // it breathes by a millimetre or two
}

/// All mechanics at once, with a lively player: the same in two sessions and after a snapshot.
TEST(Session, EverythingTogetherIsTheSameEveryTime) {
    const auto level = room(everythingText);
    const auto input = [](std::uint64_t tick) {
        TickInput lives = lively(tick);
        lives.retry = tick % 2000 == 1900;
        return lives;
    };
    Session a(level), b(level);
    std::shared_ptr<const Session::Snapshot> snapshot;
    int deaths = 0;
    for (std::uint64_t n = 0; n < 6000; ++n) {
        if (n == 3000) snapshot = a.snapshot();
        a.tick(input(n));
        b.tick(input(n));
        deaths += a.events().died ? 1 : 0;
        if (n % 100 != 0) continue;
        ASSERT_EQ(a.hash(), b.hash()) << "tick " << n;
        ASSERT_EQ(a.world().validate(), "") << "tick " << n;
    }
    EXPECT_GE(deaths, 3);
    b.restore(*snapshot);
    for (std::uint64_t n = 3000; n < 6000; ++n) b.tick(input(n));
    EXPECT_EQ(a.hash(), b.hash());
}

/// A roll over flat ice ends within a second, and where it ended he stays.
TEST(Session, RollingOnFlatIceEndsWithinASecond) {
    for (const double speed : {1.0, 3.0, 5.0}) {
        const std::string wide = replaced(replaced(roomText, "[-4, 0], [4, 0], [4, 3], [-4, 3]",
                                                   "[-40, 0], [40, 0], [40, 9], [-40, 9]"),
                                          "[0, 0.3]", "[-3, 0.17]");
        Session session(room(wide));
        play(session, {}, 500);
        session.world().setVelocity(session.hero(), {static_cast<sulfur::Real>(speed), 0},
                                    -speed / 0.12);
        play(session, {}, 500);
        const double stopped = session.heroPosition().x();
        EXPECT_GT(stopped, -3 + 0.05 * speed);  // he did roll
        play(session, {}, 2500);
        EXPECT_NEAR(session.heroPosition().x(), stopped, 0.05) << "from " << speed << " m/s";
        EXPECT_LT(session.heroVelocity().norm(), 0.02f) << "from " << speed << " m/s";
    }
}

TEST(Session, TheRopeSticksAndHangsTheHero) {
    Session session(room());
    hang(session, 0.4, 1);
    play(session, fireAt(0.4, 1), 4000);
    const double rest = session.rope().restLength();
    EXPECT_GT(rest, 2.4);
    EXPECT_LE(rest, 3.0);
    // Reeled up it hangs free: what it stretches by is its load over its spring constant. The hero
    // weighs 2 kg, the rope 0.4 kg a metre, of which on average half pulls.
    TickInput up = fireAt(0, 1);
    up.reelIn = true;
    play(session, up, 500);
    play(session, fireAt(0, 1), 5000);
    const double length = session.rope().restLength();
    EXPECT_NEAR(length, rest - 1.5 - 0.19, 0.02);  // it runs out in 0.3 s
    const double stretch = (2 + 0.4 * length / 2) * 9.81 * length / (5000 * 0.05);
    EXPECT_NEAR(hangingLength(session), length + stretch, 0.25 * stretch);
    EXPECT_GT(session.heroPosition().y(), 0.6);
}

TEST(Session, TheHangingHeroSettles) {
    Session session(room());
    hang(session);
    TickInput up = fireAt(0, 1);
    up.reelIn = true;
    play(session, up, 500);
    play(session, fireAt(0, 1), 2000);
    double low = 1e9, high = -1e9;
    for (int n = 0; n < 1000; ++n) {
        session.tick(fireAt(0, 1));
        low = std::min(low, session.heroPosition().y());
        high = std::max(high, session.heroPosition().y());
    }
    EXPECT_LT(high - low, 0.05);
}

TEST(Session, ReelingIsAsFastAsItSaysAndHasItsLimits) {
    Session session(room());
    hang(session);
    const double rest = session.rope().restLength();
    TickInput in = fireAt(0, 1);
    in.reelIn = true;
    play(session, in, 250);
    EXPECT_NEAR(session.rope().restLength(), rest - 0.75 + 0.04, 0.01);  // it begins in 0.05 s
    in.boost = true;
    play(session, in, 125);
    EXPECT_NEAR(session.rope().restLength(), rest - 1.5 + 0.07, 0.02);
    play(session, in, 1500);
    EXPECT_NEAR(session.rope().restLength(), 0.3, 0.01);
    TickInput out = fireAt(0, 1);
    out.reelOut = true;
    play(session, out, 2000);
    EXPECT_NEAR(session.rope().restLength(), 3.0, 0.01);
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Session, ReleaseTakesTheRopeOutOfTheWorld) {
    Session session(room());
    play(session, {}, 500);
    const std::size_t bodies = session.world().bodies().size();
    hang(session);
    EXPECT_GT(session.world().bodies().size(), bodies + 20);
    play(session, {}, 1);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
    EXPECT_EQ(session.world().bodies().size(), bodies);
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Session, OutOfReachNothingIsHit) {
    const std::string high = replaced(roomText, "[4, 3], [-4, 3]", "[4, 3.9], [-4, 3.9]");
    Session session(room(high));
    EXPECT_FALSE(session.preview({0, 1}).hits);
    bool missed = false;
    for (int n = 0; n < 100; ++n) {
        session.tick(fireAt(0, 1));
        missed = missed || session.events().missed;
    }
    EXPECT_TRUE(missed);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
}

TEST(Session, OnMirrorIceNothingHolds) {
    const std::string slippery =
        replaced(roomText, "\"killDepth\": -3,",
                 "\"killDepth\": -3, \"surfaces\": {\"room\": {\"sticky\": false}},");
    Session session(room(slippery));
    EXPECT_TRUE(session.preview({0, 1}).hits);
    EXPECT_FALSE(session.preview({0, 1}).sticks);
    bool slipped = false;
    for (int n = 0; n < 100; ++n) {
        session.tick(fireAt(0, 1));
        slipped = slipped || session.events().slipped;
    }
    EXPECT_TRUE(slipped);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
}

TEST(Session, AnEarlyPressIsRememberedFor120Milliseconds) {
    const std::string high = replaced(roomText, "[4, 3], [-4, 3]", "[4, 3.9], [-4, 3.9]");
    const auto shotsAfterMiss = [&](int wait) {
        Session session(room(high));
        while (!session.events().missed) session.tick(fireAt(0, 1));
        play(session, {}, 1);  // let go, then press again while the arm still recovers
        play(session, {}, wait);
        int shots = 0;
        for (int n = 0; n < 60; ++n) {
            session.tick(fireAt(0, 1));
            shots += session.events().fired ? 1 : 0;
        }
        return shots;
    };
    EXPECT_EQ(shotsAfterMiss(0), 1);
    EXPECT_EQ(shotsAfterMiss(30), 1);
    Session session(room(high));
    while (!session.events().missed) session.tick(fireAt(0, 1));
    for (int n = 0; n < 300; ++n) {
        session.tick(fireAt(0, 1));
        EXPECT_FALSE(session.events().fired) << "holding must not fire by itself, tick " << n;
    }
}

TEST(Session, TheRopeTowsACrate) {
    Session session(room());
    play(session, {}, 500);
    const auto box = session.instance().body("box-1");
    const double start = session.world().centreOfMass(box).x();
    const double hero = session.heroPosition().x();
    TickInput pull = fireAt(-1, 0.03);
    play(session, pull, 120);
    ASSERT_EQ(session.rope().state(), Rope::State::attached);
    pull.reelIn = true;
    play(session, pull, 600);
    EXPECT_GT(session.world().centreOfMass(box).x(), start + 0.1);  // both give way
    EXPECT_LT(session.heroPosition().x(), hero - 0.1);
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Session, SpeedIsCapped) {
    const std::string shaft =
        replaced(replaced(replaced(roomText, "[4, 3], [-4, 3]", "[4, 60], [-4, 60]"),
                          "\"spawn\": [0, 0.3]", "\"spawn\": [0, 55]"),
                 "\"max\": [4, 4]", "\"max\": [4, 60]");
    Session session(room(shaft));
    double fastest = 0;
    for (int n = 0; n < 1500; ++n) {
        session.tick({});
        fastest = std::max(fastest, static_cast<double>(session.heroVelocity().norm()));
    }
    EXPECT_GT(fastest, 10.9);
    EXPECT_LT(fastest, 11.1);
}

TEST(Session, AHeroWhoBurstsEndsNoGame) {
    Session session(room());
    const auto particles = session.world().particles(session.hero());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        session.world().setVelocity(particles[i], {i == 3 ? -1900.0f : 1900.0f, 0});
    }
    EXPECT_NO_THROW(play(session, {}, 100));
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Session, TheHeroCannotLeaveThroughGround) {
    Session session(room());
    TickInput input;
    for (std::uint64_t n = 0; n < 15000; ++n) {
        // Shots in all directions, always reeling hard into what was hit.
        const double angle = static_cast<double>(n / 300) * 2.4;
        setAim(input, std::cos(angle), std::sin(angle));
        input.fire = n % 300 > 5;
        input.reelIn = true;
        input.boost = true;
        input.push = n % 600 < 300 ? 127 : -127;
        session.tick(input);
        if (session.phase() == Session::Phase::finished) session.restart();
        const sulfur::Point p = session.heroPosition();
        ASSERT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y())) << "tick " << n;
        ASSERT_TRUE(std::abs(p.x()) < 4 && p.y() > 0 && p.y() < 3)
            << "tick " << n << " at " << p.x() << ", " << p.y();
    }
    EXPECT_TRUE(std::isfinite(session.world().energy()));
    EXPECT_EQ(session.world().validate(), "");
}

TEST(Session, ReachingTheExitFinishes) {
    const std::string near =
        replaced(roomText, "\"position\": [3.2, 0.3]", "\"position\": [1.1, 2.5]");
    Session session(room(near));
    EXPECT_EQ(session.medal(), Medal::none);
    play(session, {}, 200);
    EXPECT_EQ(session.timerTicks(), 0u) << "the timer waits for the player";
    TickInput swing = fireAt(0.4, 1);
    swing.reelIn = true;
    for (int n = 0; n < 3000 && session.phase() == Session::Phase::playing; ++n) {
        session.tick(swing);
    }
    ASSERT_EQ(session.phase(), Session::Phase::finished);
    EXPECT_EQ(session.medal(), Medal::gold);
    EXPECT_EQ(session.rope().state(), Rope::State::idle);
    const double time = session.seconds();
    EXPECT_NEAR(time, static_cast<double>(session.ticks() - 200) / 500, 1e-9);
    play(session, swing, 100);
    EXPECT_EQ(session.seconds(), time) << "after the finish the timer stands";
    play(session, {}, 2000);
    EXPECT_LT((session.heroPosition() - session.level().exit.position).norm(), 0.1)
        << "the gate keeps the hero";
}

TEST(Session, FallingOutOfTheLevelStartsAgain) {
    const std::string open = replaced(roomText, "\"closed\": true", "\"closed\": false");
    const std::string pit =
        replaced(open, "[[-4, 0], [4, 0], [4, 3], [-4, 3]]", "[[-4, 3], [4, 3]]");
    Session session(room(pit));
    bool restarted = false;
    for (int n = 0; n < 1000; ++n) {
        session.tick({});
        restarted = restarted || session.events().restarted;
    }
    EXPECT_TRUE(restarted);
    EXPECT_GE(session.restarts(), 1);
}

}  // namespace
}  // namespace quaoar::test
