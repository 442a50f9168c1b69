// Friction acts at the surface, on both sides at one point: what one side gains of angular momentum
// the other one loses.
#include <functional>

#include "battery/random/momenta.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

const Material rough{.staticFriction = 1, .kineticFriction = Real(0.8)};

Blueprint roughened(Blueprint plan) {
    plan.material = rough;
    return plan;
}

/// A body that flies and spins.
Body launch(World& world, const Blueprint& plan, const Pose& pose, const Vec2& velocity,
            Real omega) {
    const Body body = world.add(roughened(plan), pose);
    const Point centre = world.centreOfMass(body);
    for (const ParticleId id : body.particles()) {
        const Vec2 r = (world.position(id) - centre).cast<Real>();
        world.setVelocity(id, velocity + omega * Vec2(-r[1], r[0]));
    }
    return body;
}

struct Scene {
    const char* name;
    std::function<void(World&)> fill;
    double seconds = 0.5;
};

/// Things that rub against each other in free space, each with an orientation.
std::vector<Scene> scenes() {
    const Blueprint crate = shapes::box({.size = {Real(0.6), Real(0.4)}});
    const Blueprint wheel = shapes::wheel({.radius = Real(0.4)});
    const Blueprint thick = shapes::box({.radius = Real(0.2)});
    const Blueprint rod = shapes::rope(
        {.from = {Real(-0.4), 0}, .to = {Real(0.4), 0}, .links = 1, .radius = Real(0.1)});
    const Blueprint jelly = shapes::jelly({.stiffness = 4000, .damping = 5});
    return {
        {"wheels that spin against each other",
         [=](World& w) {
             launch(w, wheel, {{-0.45, 0}, 0}, {1, 0}, 20);
             launch(w, wheel, {{0.45, 0}, 0}, {-1, 0}, 20);
         }},
        {"crates that meet askew",
         [=](World& w) {
             launch(w, crate, {{-0.8, 0.1}, 0.4}, {4, 1}, 3);
             launch(w, crate, {{0.8, 0}, 0}, {-4, 0}, -5);
         }},
        {"crates with thick edges",
         [=](World& w) {
             launch(w, thick, {{-0.8, 0.3}, 0.2}, {4, 2}, 3);
             launch(w, thick, {{0.8, 0}, 0}, {-4, -2}, 0);
         }},
        {"a rod along a crate",
         [=](World& w) {
             launch(w, rod, {{-0.6, 0.5}, 0.1}, {5, -2}, 4);
             launch(w, crate, {{0, 0}, 0}, {0, 0}, 0);
         }},
        {"a crate and a jelly",
         [=](World& w) {
             launch(w, crate, {{-1.2, 0.3}, 0.3}, {6, 0}, 6);
             launch(w, jelly, {{0, 0}, 0}, {0, 0}, 0);
         }},
        {"a wheel in a pile of crates",
         [=](World& w) {
             launch(w, wheel, {{-1.2, 0.1}, 0}, {8, 0}, -20);
             for (int i = 0; i < 3; ++i)
                 launch(w, crate, {{0.1 * i, 0.41 * (i - 1)}, 0}, {0, 0}, 0);
         }},
        {"a rope round a wheel",
         [=](World& w) {
             launch(w, wheel, {{0, 0}, 0}, {0, 0}, 20);
             launch(w, shapes::rope({.from = {-1, Real(0.5)}, .to = {1, Real(0.5)}, .links = 20}),
                    {}, {0, -4}, 0);
         }},
    };
}

TEST(AngularMomentum, FrictionKeepsIt) {
    for (const Scene& scene : scenes())
        for (const int rate : {60, 120, 500, 2000, 10000}) {
            World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
            scene.fill(world);
            const lab::Momenta before = lab::momentaOf(world, {0, 0});
            bool met = false;
            const auto ticks = std::lround(scene.seconds * rate);
            for (long i = 0; i < ticks; ++i) {
                world.step();
                met = met || !world.events().contactsBegun.empty();
            }
            const lab::Momenta after = lab::momentaOf(world, {0, 0});
            const double scale = std::max(before.angularScale, after.angularScale);
            const auto what = testing::Message() << scene.name << ", " << rate << " Hz";
            EXPECT_TRUE(met) << what;
            EXPECT_LT(std::abs(after.angular - before.angular), 1e-5 * scale) << what;
            EXPECT_LT((after.linear.sum - before.linear.sum).norm(), 1e-5 * before.linear.scale)
                << what;
            EXPECT_LT(after.energy, 1.01 * before.energy) << what;
        }
}

/// What `seconds` change of both momenta, as shares of the largest that there were.
void expectKept(World& world, double seconds, const char* what) {
    const lab::Momenta before = lab::momentaOf(world, {0, 0});
    test::run(world, seconds);
    const lab::Momenta after = lab::momentaOf(world, {0, 0});
    EXPECT_EQ(world.validate(), "") << what;
    EXPECT_NEAR(after.angular, before.angular,
                1e-6 * std::max(before.angularScale, after.angularScale))
        << what;
    EXPECT_LT((after.linear.sum - before.linear.sum).norm(), 1e-6 * before.linear.scale) << what;
    EXPECT_LT(after.energy, before.energy * (1 + 1e-4)) << what;
}

/// Places are moved apart without a velocity.
TEST(AngularMomentum, OverlapsThatArePushedApartKeepIt) {
    for (const int rate : {60, 240, 500, 2000})
        for (const Blueprint& plan : {shapes::ball(), shapes::box(), shapes::jelly()}) {
            World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
            launch(world, plan, {{0, 0}, 0}, {0, 0}, 0);
            launch(world, plan, {{0.49, 0.02}, 0.1}, {0, 3}, 2);
            expectKept(world, 0.2, plan.name.c_str());
        }
}

/// One body struck at two moments of one step goes on from the first blow to the second.
TEST(AngularMomentum, BlowsOnOneBodyInOneStepKeepIt) {
    for (const int rate : {60, 240, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
        launch(world, shapes::ball(), {{0, 0}, 0}, {0, 0}, 0);
        launch(world, shapes::ball(), {{-0.51, 0.1}, 0}, {9, 2}, 0);
        launch(world, shapes::ball(), {{0.515, 0.1}, 0}, {-12, -2}, 0);
        launch(world, shapes::ball(), {{0.1, 0.53}, 0}, {1, -15}, 0);
        expectKept(world, 0.1, "four balls");
    }
}

/// What is fast is moved back where it would pass.
TEST(AngularMomentum, WhatIsHeldBackKeepsIt) {
    for (const int rate : {60, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
        launch(world, shapes::jelly(), {{0, 0}, 0}, {0, 0}, 0);
        launch(world, shapes::box({.size = {Real(0.2), Real(0.2)}}), {{-3, 0.3}, 0}, {120, 0}, 30);
        expectKept(world, 0.2, "a crate through a jelly");
    }
}

/// An attachment holds where it is right to first order.
TEST(AngularMomentum, WhatTurnsOnAnAttachmentKeepsIt) {
    for (const int rate : {60, 500}) {
        World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
        const Body jelly =
            launch(world, shapes::jelly({.stiffness = 4000}), {{0, 0}, 0}, {0, 0}, 8);
        const Body rod =
            launch(world, shapes::rope({.from = {Real(0.4), 0}, .to = {Real(1.4), 0}, .links = 3, .radius = 0}), {},
                   {0, Real(0.9) * 8}, 8);
        world.attach(rod[0], jelly, {Real(0.4), 0});
        expectKept(world, 1, "a rope on a jelly");
    }
}

/// Bodies of different groups are left alone: what flies by itself keeps every bit.
TEST(AngularMomentum, WhatTouchesNobodyKeepsEveryBit) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body alone = launch(world, shapes::box(), {{9, 9}, 0}, {3, 1}, 4);
    World beside({.gravity = {0, 0}, .sleeping = false});
    const Body same = launch(beside, shapes::box(), {{9, 9}, 0}, {3, 1}, 4);
    launch(beside, shapes::ball(), {{0, 0}, 0}, {0, 0}, 0);
    launch(beside, shapes::ball(), {{0.49, 0.1}, 0}, {0, 2}, 0);
    for (int i = 0; i < 200; ++i) {
        world.step();
        beside.step();
        for (std::size_t k = 0; k < alone.size(); ++k)
            ASSERT_EQ(world.position(alone[k]), beside.position(same[k])) << i;
    }
}

/// Two wheels that turn alike at 1 rad/s meet at 1 m/s. Friction holds their rims together: each
/// has w R of tangential speed, of which a solid disc of m R^2 / 2 gives a third to its centre and
/// keeps a third of its spin. Rims are polygons, which leaves some percent.
TEST(AngularMomentum, WheelsThatMeetRollOnEachOther) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Blueprint wheel = shapes::wheel({.radius = Real(0.4), .segments = 48});
    const Body a = launch(world, wheel, {{-0.405, 0}, 0}, {Real(0.5), 0}, 1);
    launch(world, wheel, {{0.405, 0}, 0}, {Real(-0.5), 0}, 1);
    const lab::Momenta before = lab::momentaOf(world, {0, 0});
    test::run(world, 0.1);
    const lab::Momenta after = lab::momentaOf(world, {0, 0});
    EXPECT_NEAR(static_cast<double>(world.meanVelocity(a)[1]), -0.4 / 3, 0.015);
    EXPECT_NEAR(after.angular, before.angular, 1e-5 * before.angularScale);
}

}  // namespace
}  // namespace sulfur
