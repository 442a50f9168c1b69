// Springs that are changed while the world runs: only what is around them follows, and as if they
// had always been so.
#include <cmath>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// What springs may end at, all of it at rest and without gravity: a jelly, a rope of springs, a
/// net of rigid joints, crates, a beam with angular joints, and springs between them.
class Weightless {
public:
    Weightless() : world({.gravity = {0, 0}, .sleeping = false}) {
        add(shapes::jelly({.size = {2, 1}}), {0, 0});
        add(shapes::rope({.to = {2, 0}, .links = 8, .slack = 0, .bending = 0}), {4, 0});
        add(shapes::cloth({.size = {2, 2}, .columns = 5, .rows = 5}), {8, 0});
        add(shapes::box(), {12, 0});
        add(shapes::box(), {14, 0});
        add(shapes::rope({.to = {2, 0}, .links = 6, .slack = 0, .bending = 5}), {16, 0});
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Body& other = bodies_[(i + 1) % bodies_.size()];
            for (const bool back : {false, true}) {
                const ParticleId to = back ? other.back() : other.front();
                springs.push_back(world.connect(bodies_[i].back(), to, {.stiffness = 100}));
            }
        }
        for (const JointId id : bodies_[0].joints()) springs.push_back(id);
    }
    void change(JointId id, Real stiffness, Real damping) {
        world.setStiffness(id, stiffness);
        world.setDamping(id, damping);
    }
    /// Throws every particle in a direction of its own.
    void kick() {
        test::Random random(1);
        for (const Body& body : bodies_)
            for (const ParticleId p : body.particles())
                world.setVelocity(p, Vec2(static_cast<Real>(random.uniform(-1, 1)),
                                          static_cast<Real>(random.uniform(-1, 1))));
    }
    std::vector<Point> places() const {
        std::vector<Point> all;
        for (const Body& body : bodies_)
            for (const ParticleId p : body.particles()) all.push_back(world.position(p));
        return all;
    }

    World world;
    std::vector<JointId> springs;

private:
    void add(const Blueprint& plan, Point at) {
        bodies_.push_back(world.add(plan, {.position = at}));
    }
    std::vector<Body> bodies_;
};

/// (All rests but for roundings of lengths, which stiff springs feel.)
TEST(Retune, IsAsIfItHadAlwaysBeenSo) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Weightless before, after;
        after.world.step();
        test::Random random(seed);
        for (int i = 0; i < 6; ++i) {
            const std::size_t which = random.below(before.springs.size());
            const Real stiffness = static_cast<Real>(std::pow(10, random.uniform(-1, 6)));
            const Real damping = static_cast<Real>(std::pow(10, random.uniform(-3, 2)));
            before.change(before.springs[which], stiffness, damping);
            after.change(after.springs[which], stiffness, damping);
            if (i % 2 == 0) after.world.step();
        }
        for (Weightless* w : {&before, &after}) {
            w->kick();
            for (int tick = 0; tick < 50; ++tick) w->world.step();
        }
        const auto there = before.places(), here = after.places();
        for (std::size_t i = 0; i < there.size(); ++i)
            ASSERT_LT((there[i] - here[i]).norm(), 2e-6) << "seed " << seed << ", particle " << i;
    }
}

/// What the stage of changes looks at while a spring among so many ropes is made shorter and softer
/// in each tick.
std::uint32_t lookedAtWhileReeling(int others) {
    World world({.sleeping = false});
    for (int i = 0; i < others; ++i)
        world.add(shapes::rope({.to = {2, 0}, .links = 10, .pinFirst = true}),
                  {.position = {3.0 * i, 20}});
    const Body rope =
        world.add(shapes::rope({.to = {0, -2}, .links = 10, .bending = 0, .pinFirst = true}));
    const Body load = world.add(shapes::ball({.radius = Real(0.2)}), {.position = {0, -4}});
    const JointId spring = world.connect(rope.back(), load.front(), {.stiffness = 1e4});
    std::uint32_t most = 0;
    for (int tick = 0; tick < 50; ++tick) {
        const Real length = 2 - Real(0.02) * static_cast<Real>(tick);
        world.setRestLength(spring, length);
        world.setStiffness(spring, Real(2e4) / length);
        world.setDamping(spring, Real(20) / length);
        world.step();
        const std::uint32_t looked =
            world.statistics().items[static_cast<std::size_t>(Stage::changes)];
        if (tick > 0) most = std::max(most, looked);
    }
    EXPECT_LT(world.position(load.front()).y(), -2.5);
    EXPECT_GT(world.position(load.front()).y(), -3.5) << "it has been pulled up";
    return most;
}

TEST(Retune, CostsTheSameWhateverElseThereIs) {
    EXPECT_EQ(lookedAtWhileReeling(0), 0u);
    EXPECT_EQ(lookedAtWhileReeling(100), 0u);
}

TEST(Retune, LengthsOfSpringsInLanesFollow) {
    World world;
    Blueprint bar;
    bar.kind = BodyKind::fixed;
    for (int i = 0; i < 20; ++i)
        bar.particles.push_back({.position = {static_cast<Real>(i), 0}, .mass = 1});
    const Body beam = world.add(bar, {.position = {0, 10}});
    std::vector<JointId> springs;
    std::vector<ParticleId> balls;
    for (std::size_t i = 0; i < 20; ++i) {
        const Body ball = world.add(shapes::ball({.radius = Real(0.1), .mass = 1}),
                                    {.position = {static_cast<double>(i), 9}});
        balls.push_back(ball.front());
        springs.push_back(world.connect(beam.particles()[i], ball.front(),
                                        {.stiffness = 100, .damping = 10, .restLength = 1}));
    }
    world.step();
    for (std::size_t i = 0; i < 20; ++i)
        world.setRestLength(springs[i], 1 + Real(0.1) * static_cast<Real>(i));
    test::run(world, 8);
    for (std::size_t i = 0; i < 20; ++i)
        EXPECT_NEAR(world.position(balls[i]).y(),
                    10 - (1 + 0.1 * static_cast<double>(i) + 9.81 / 100), 1e-3)
            << i;
}

}  // namespace
}  // namespace sulfur
