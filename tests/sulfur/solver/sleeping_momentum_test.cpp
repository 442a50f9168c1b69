// What strikes a sleeper meets a body, not a wall: momentum is kept to the same bounds as among
// bodies that are awake.
#include <algorithm>

#include "battery/random/momenta.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

const Material slick{.staticFriction = 0, .kineticFriction = 0};
constexpr double share = 1e-5;  // of the momentum, that rounding may take

/// A row of crates of 1 m and 1 kg, which rest, and one more that comes from the left.
class Train {
public:
    Train(const WorldSettings& settings, int sleepers, double gap, bool floor) : world(settings) {
        if (floor) {
            Blueprint plan = shapes::floor({-20, 0}, {60, 0});
            plan.material = slick;
            world.add(plan);
        }
        const double height = floor ? 0.55 : 0;
        for (int i = 0; i < sleepers; ++i)
            crates_.push_back(world.add(crate(), {.position = {i * (1 + gap), height}}));
        striker_ = world.add(crate(), {.position = {-1.1, height}});
        if (settings.sleeping) {
            test::run(world, 3);
            for (const Body& body : crates_) EXPECT_TRUE(world.asleep(body));
        }
    }
    void shoot(Real speed) {
        world.setVelocity(striker_, {speed, 0});
        before_ = lab::momentumOf(world);
    }
    /// The largest change of the sum along x over `seconds`, as a share of what it was.
    double lost(double seconds) {
        double most = 0;
        const auto ticks = std::lround(seconds * world.settings().tickRate);
        for (long i = 0; i < ticks; ++i) {
            world.step();
            const double change = lab::momentumOf(world).sum.x() - before_.sum.x();
            most = std::max(most, std::abs(change) / before_.scale);
        }
        return most;
    }
    double speed(std::size_t i) const {
        return static_cast<double>(world.meanVelocity(crates_[i])[0]);
    }
    double strikersSpeed() const { return static_cast<double>(world.meanVelocity(striker_)[0]); }

    World world;

private:
    static Blueprint crate() { return shapes::box({.material = slick}); }
    std::vector<Body> crates_;
    Body striker_;
    lab::Momentum before_;
};

/// Without rebound all go on together, at speed / count, once all gaps are closed.
TEST(SleepingMomentum, DISABLED_ATrainOfSleepersTakesTheWholeBlow) {
    const Real speed = 5;
    for (const int rate : {60, 120, 240, 500, 2000})
        for (const double gap : {0.0005, 0.001, 0.002, 0.005, 0.01})
            for (const int sleepers : {1, 2, 5})
                for (const bool sleeping : {true, false}) {
                    Train train({.gravity = {0, 0}, .tickRate = rate, .sleeping = sleeping},
                                sleepers, gap, false);
                    train.shoot(speed);
                    const auto what = testing::Message()
                                      << rate << " Hz, gap " << gap << ", " << sleepers
                                      << " at rest, sleeping " << sleeping;
                    EXPECT_LT(train.lost(0.4), share) << what;
                    const double together = static_cast<double>(speed) / (sleepers + 1);
                    for (int i = 0; i < sleepers; ++i)
                        EXPECT_NEAR(train.speed(static_cast<std::size_t>(i)), together,
                                    0.05 * together)
                            << what << ", crate " << i;
                    EXPECT_NEAR(train.strikersSpeed(), together, 0.05 * together) << what;
                }
}

/// A slick floor carries and takes nothing along x.
TEST(SleepingMomentum, ASlickFloorTakesNothingOfABlow) {
    for (const int rate : {60, 240, 500, 2000})
        for (const double gap : {0.0005, 0.002, 0.01})
            for (const int sleepers : {1, 2, 5}) {
                Train train({.tickRate = rate}, sleepers, gap, true);
                train.shoot(Real(4.9));
                EXPECT_LT(train.lost(0.2), share)
                    << rate << " Hz, gap " << gap << ", " << sleepers << " asleep";
            }
}

/// Things of other kinds, struck at once by several.
TEST(SleepingMomentum, SleepersOfAllKindsTakeTheWholeBlow) {
    const std::vector<Blueprint> kinds{
        shapes::box({.size = {1, Real(0.5)}, .mass = 3}),
        shapes::ball({.radius = Real(0.5)}),
        shapes::wheel({.radius = Real(0.5)}),
        shapes::jelly({.stiffness = 4000, .damping = 10}),
        shapes::blob({.stiffness = 4000, .damping = 10}),
        shapes::rope({.from = {Real(-0.4), 0}, .to = {Real(0.4), 0}, .links = 8})};
    for (const int rate : {60, 500})
        for (const Blueprint& plan : kinds) {
            World world({.gravity = {0, 0}, .tickRate = rate});
            std::vector<Body> sleepers;
            for (int i = 0; i < 3; ++i)
                sleepers.push_back(world.add(plan, {.position = {1.003 * i, 0}}));
            const Body left =
                world.add(shapes::ball({.radius = Real(0.1), .mass = 2}), {.position = {-2, 0.1}});
            const Body right =
                world.add(shapes::ball({.radius = Real(0.1), .mass = 1}), {.position = {4, -0.1}});
            test::run(world, 3);
            for (const Body& body : sleepers) EXPECT_TRUE(world.asleep(body));
            world.setVelocity(left, {20, 0});
            world.setVelocity(right, {-12, 1});
            const lab::Momentum before = lab::momentumOf(world);
            for (int i = 0; i < rate / 2; ++i) world.step();
            EXPECT_LT((lab::momentumOf(world).sum - before.sum).norm(), share * before.scale)
                << plan.name << ' ' << plan.particles.size() << " particles, " << rate << " Hz";
        }
}

}  // namespace
}  // namespace sulfur
