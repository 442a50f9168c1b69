// Soft bodies as wholes: what they keep in flight, and when they slip.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "battery/random/momenta.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

/// Flies for a minute. Returns the largest change of angular momentum about the origin, in m v r.
double lostSpin(World& world, double massSpeedSize) {
    world.step();
    const double before = lab::momentaOf(world, {0, 0}).angular;
    double lost = 0;
    const int rate = world.settings().tickRate;
    for (int i = 0; i < 60 * rate; ++i) {
        world.step();
        if (i % rate == 0)
            lost = std::max(lost, std::abs(lab::momentaOf(world, {0, 0}).angular - before));
    }
    return lost / massSpeedSize;
}

TEST(SoftMotion, BlobsThatMeetKeepTheirSpinAndPart) {
    for (const Real restitution : {Real(0), Real(0.3), Real(0.8)})
        for (const int rate : {60, 120, 240, 500}) {
            World world({.gravity = {0, 0}, .tickRate = rate});
            const Blueprint plan = shapes::blob({.material = {.restitution = restitution}});
            const Body a = world.add(plan, {.position = {-1, 0.2}});
            const Body b = world.add(plan, {.position = {1, -0.1}});
            world.setVelocity(a, Vec2(Real(2.5), 0));
            world.setVelocity(b, Vec2(Real(-2.5), 0));
            const double energy = world.energy();
            EXPECT_LT(lostSpin(world, 2 * static_cast<double>(plan.mass()) * 2.5), 1e-3)
                << restitution << " at " << rate;
            EXPECT_LT(world.energy(), 1.001 * energy) << restitution << " at " << rate;
            EXPECT_GT((world.centreOfMass(a) - world.centreOfMass(b)).norm(), 2)
                << restitution << " at " << rate;
        }
}

TEST(SoftMotion, ARopeBetweenJelliesKeepsTheirSpin) {
    for (const int rate : {60, 120, 240, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
        const Body a = world.add(shapes::jelly());
        const Body b = world.add(shapes::jelly(), {.position = {3, 0}});
        const Body rope = world.add(shapes::rope({.from = {Real(0.48), 0}, .to = {Real(2.52), 0}}));
        world.attach(rope.front(), a, Vec2(Real(0.48), 0));
        world.attach(rope.back(), b, Vec2(Real(-0.48), 0));
        world.setVelocity(a, Vec2(1, 1));
        world.setVelocity(b, Vec2(-1, -2));
        EXPECT_LT(lostSpin(world, 2.5 * 2 * 2), 1e-3) << rate;
    }
}

/// What lies still when the ground begins to tilt, slowly. (A jelly that is put down on a slope
/// slides first, and may flutter then, which unloads it for moments: at any rate, up to 10 kHz.)
TEST(SoftMotion, AJellySlipsAtTheAngleOfStaticFriction) {
    const Material material{.staticFriction = Real(0.6), .kineticFriction = Real(0.6)};
    const double theory = std::atan(0.6) * 180 / std::numbers::pi;
    const Blueprint plans[] = {
        shapes::jelly({.material = material}),
        shapes::jelly({.stiffness = 4000, .damping = 10, .material = material}),
        shapes::jelly({.size = {2, Real(0.5)}, .columns = 9, .rows = 3, .material = material}),
        shapes::box({.material = material}),
    };
    for (const int rate : {120, 500})
        for (const Blueprint& plan : plans) {
            World world({.tickRate = rate, .sleeping = false});
            Blueprint floor = shapes::floor({-50, 0}, {50, 0});
            floor.material = material;
            world.add(floor);
            const Body body = world.add(plan, {.position = {0, 0.6}});
            test::run(world, 4);
            double degrees = 0;
            while (degrees < 40 && std::abs(world.meanVelocity(body).x()) < Real(0.02)) {
                degrees += (degrees < 25 ? 2 : 0.2) / rate;
                const double angle = degrees * std::numbers::pi / 180;
                world.setGravity({static_cast<Real>(-9.81 * std::sin(angle)),
                                  static_cast<Real>(-9.81 * std::cos(angle))});
                world.step();
            }
            EXPECT_NEAR(degrees, theory, 0.02 * theory) << plan.name << " at " << rate;
        }
}

}  // namespace
}  // namespace sulfur
