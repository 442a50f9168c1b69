// Several impacts at once: they pass momentum on and never gain energy.
#include <algorithm>

#include "battery/random/momenta.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr int count = 5;
const Material lively{.staticFriction = 0, .kineticFriction = 0, .restitution = 1};

Blueprint disc() {
    return shapes::ball({.radius = Real(0.25), .material = lively});
}
Blueprint crate() {
    return shapes::box({.size = {Real(0.5), Real(0.5)}, .material = lively});
}

struct Kind {
    const char* name;
    Blueprint plan;
};
const std::vector<Kind>& kinds() {
    static const std::vector<Kind> both{{"discs", disc()}, {"crates", crate()}};
    return both;
}

/// A row in free space. The first is struck by nobody: it comes at 2 m/s.
class Row {
public:
    Row(const Blueprint& plan, double gap, int rate, bool sleeping)
        : world({.gravity = {0, 0}, .tickRate = rate, .sleeping = sleeping}) {
        for (int i = 0; i < count; ++i) {
            const double x = i * (0.5 + gap) - (i == 0 ? 0.2 : 0);
            bodies.push_back(world.add(plan, {.position = {x, 0}}));
        }
        if (sleeping) test::run(world, 2);
        world.setVelocity(bodies[0], {speed, 0});
    }
    double energy() const { return lab::momentaOf(world, {0, 0}).kinetic; }

    static constexpr Real speed = 2;
    World world;
    std::vector<Body> bodies;
};

TEST(Cradle, ARowPassesTheBlowOnAndGainsNothing) {
    for (const Kind& kind : kinds())
        for (const int rate : {60, 120, 500, 2000})
            for (const double gap : {0.0, 0.001, 0.005})
                for (const bool sleeping : {true, false}) {
                    Row row(kind.plan, gap, rate, sleeping);
                    const double before = row.energy();
                    double most = 0;
                    for (int i = 0; i < rate; ++i) {
                        row.world.step();
                        most = std::max(most, row.energy());
                    }
                    const auto what = testing::Message() << kind.name << ", " << rate << " Hz, gap "
                                                         << gap << ", sleeping " << sleeping;
                    EXPECT_LT(most, 1.01 * before) << what;
                    EXPECT_GT(row.energy(), 0.9 * before) << what;
                    const auto last =
                        static_cast<double>(row.world.meanVelocity(row.bodies.back())[0]);
                    EXPECT_GT(last, 0.9 * static_cast<double>(Row::speed)) << what;
                }
}

/// A cradle. A disc hangs by one thread, a crate by two, so that it stays upright. The first one is
/// struck away from the others at 2 m/s.
class Cradle {
public:
    Cradle(const Blueprint& plan, bool crates, double gap, int rate, bool sleeping)
        : world({.tickRate = rate, .sleeping = sleeping}) {
        Blueprint frame{.name = "frame", .kind = BodyKind::fixed, .filter = {.mask = 0}};
        const std::vector<double> sides =
            crates ? std::vector<double>{-0.23, 0.23} : std::vector<double>{0};
        for (int i = 0; i < count; ++i)
            for (const double side : sides)
                frame.particles.push_back(
                    {.position = {static_cast<Real>(i * (0.5 + gap) + side), length}});
        const Body pegs = world.add(frame);
        std::size_t peg = 0;
        for (int i = 0; i < count; ++i) {
            bodies.push_back(world.add(plan, {.position = {i * (0.5 + gap), 0}}));
            for (const double side : sides)
                world.connect(pegs[peg++], crates ? upper(bodies.back(), side) : bodies.back()[0]);
        }
        if (sleeping) test::run(world, 2);
        rest = energy();
        world.setVelocity(bodies[0], {-speed, 0});
    }
    /// Kinetic and gravitational, J.
    double energy() const { return world.energy(); }
    double speedOf(std::size_t i) const {
        return static_cast<double>(world.meanVelocity(bodies[i]).norm());
    }

    static constexpr Real length = 2, speed = 2;
    World world;
    std::vector<Body> bodies;
    double rest = 0;

private:
    /// The corner at the upper left (side < 0) or the upper right.
    ParticleId upper(const Body& body, double side) const {
        const Point centre = world.centreOfMass(body);
        const auto place = [&](ParticleId id) {
            const Point r = world.position(id) - centre;
            return (side < 0 ? -1 : 1) * r.x() + r.y();
        };
        return *std::max_element(body.particles().begin(), body.particles().end(),
                                 [&](ParticleId a, ParticleId b) { return place(a) < place(b); });
    }
};

TEST(Cradle, SwingsForTenSeconds) {
    for (const Kind& kind : kinds())
        for (const int rate : {120, 500})
            for (const double gap : {0.0, 0.001, 0.005})
                for (const bool sleeping : {true, false}) {
                    Cradle cradle(kind.plan, &kind == &kinds()[1], gap, rate, sleeping);
                    const double given = cradle.energy() - cradle.rest;
                    double most = 0, first = 0, last = 0;
                    for (int i = 0; i < 10 * rate; ++i) {
                        cradle.world.step();
                        most = std::max(most, cradle.energy() - cradle.rest);
                        // It comes back after half a period of 2.8 s and strikes.
                        if (i < 2 * rate) {
                            first = std::max(first, cradle.speedOf(0));
                            last = std::max(last, cradle.speedOf(count - 1));
                        }
                    }
                    const auto what = testing::Message() << kind.name << ", " << rate << " Hz, gap "
                                                         << gap << ", sleeping " << sleeping;
                    EXPECT_GT(last, 0.9 * first) << what;
                    EXPECT_LT(most, 1.01 * given) << what;
                    EXPECT_GT(cradle.energy() - cradle.rest, 0.9 * given) << what;
                }
}

/// Two come, two go: e = 1 and equal masses leave only this.
TEST(Cradle, TwoThatComeTogetherSendTwo) {
    for (const bool sleeping : {true, false}) {
        World world({.gravity = {0, 0}, .sleeping = sleeping});
        std::vector<Body> row;
        for (int i = 0; i < count; ++i)
            row.push_back(world.add(disc(), {.position = {i * 0.501 - (i < 2 ? 0.2 : 0), 0}}));
        if (sleeping) test::run(world, 2);
        for (const std::size_t i : {0u, 1u}) world.setVelocity(row[i], {2, 0});
        const double before = lab::momentaOf(world, {0, 0}).kinetic;
        test::run(world, 1);
        EXPECT_NEAR(lab::momentaOf(world, {0, 0}).kinetic, before, 0.01 * before) << sleeping;
        for (const std::size_t i : {3u, 4u})
            EXPECT_NEAR(static_cast<double>(world.meanVelocity(row[i])[0]), 2, 0.2) << sleeping;
    }
}

/// A rack of discs is struck by one: whatever becomes of them, there is no more energy than before.
TEST(Cradle, ARackGainsNoEnergy) {
    for (const int rate : {60, 240, 500, 2000})
        for (const double gap : {0.0, 0.001})
            for (const bool crates : {false, true}) {
                World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
                const double pitch = 0.5 + gap;
                for (int row = 0; row < 5; ++row)
                    for (int i = 0; i <= row; ++i)
                        world.add(crates ? crate() : disc(),
                                  {.position = {row * (crates ? pitch : pitch * 0.8660255),
                                                (i - row / 2.0) * pitch}});
                const Body cue = world.add(disc(), {.position = {-2, 0.01}});
                world.setVelocity(cue, {10, 0});
                const lab::Momentum before = lab::momentumOf(world);
                double most = 0;
                for (int i = 0; i < rate; ++i) {
                    world.step();
                    most = std::max(most, world.energy());
                }
                const auto what = testing::Message() << (crates ? "crates, " : "discs, ") << rate
                                                     << " Hz, gap " << gap;
                EXPECT_LT(most, 1.01 * 50) << what;
                EXPECT_LT((lab::momentumOf(world).sum - before.sum).norm(), 1e-5 * before.scale)
                    << what;
            }
}

}  // namespace
}  // namespace sulfur
