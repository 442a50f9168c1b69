// Measuring: what is recorded is what happens, and fits find what physics says.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "model/measurement.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

std::vector<const Quantity*> some(std::initializer_list<const char*> keys) {
    std::vector<const Quantity*> found;
    for (const char* key : keys) found.push_back(quantity(key));
    return found;
}

BodyId addBox(Workbench& bench, Point from, Point to) {
    bench.setTool(ToolKind::box);
    bench.press({.position = from});
    bench.move({.position = to});
    bench.release({.position = to});
    bench.select({bench.document().world().bodies().back()});
    return bench.document().world().bodies().back();
}

sulfur::scene::Placement fourMetresUp() {
    sulfur::scene::Placement placement;
    placement.pose.position = {0, 4};
    return placement;
}

void tickOn(Workbench& bench, int ticks) {
    for (int i = 0; i < ticks; ++i) bench.tick();
}

TEST(Measurement, KeysAreUniqueAndEachHasAName) {
    std::set<std::string_view> keys;
    for (const Quantity& one : quantities()) {
        EXPECT_TRUE(keys.insert(one.key).second);
        EXPECT_FALSE(one.name.empty());
        EXPECT_FALSE(one.help.empty());
    }
    EXPECT_EQ(quantity("nothing"), nullptr);
}

TEST(Measurement, FreeFallFitsGravity) {
    Workbench bench;
    addBox(bench, {0, 8}, {1, 9});
    bench.measure(some({"velocity-y", "height", "energy", "contact-force"}));
    tickOn(bench, 500);
    const auto& series = bench.measurements().series();
    ASSERT_EQ(series.size(), 4u);
    ASSERT_EQ(series[0].samples.size(), 500u);
    const auto line = fitLine(series[0].samples);
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->slope, -9.81, 0.001);
    EXPECT_LT(line->deviation, 0.001);
    // Half of the way in the first 0.5 s is a quarter of it.
    const auto half = nearest(series[1].samples, 0.5);
    EXPECT_NEAR(8.5 - half->value, 9.81 / 8, 0.02);
    const auto energies = series[2].samples;
    EXPECT_NEAR(energies.front().value, energies.back().value,
                1e-4 * std::abs(energies.front().value));
    EXPECT_EQ(series[3].samples.back().value, 0);
    // The scene has the energy that the library tells.
    bench.select({});
    Measurements all;
    const Measurements::Subject scene{{}, 0, "the scene"};
    const auto energy = some({"energy"});
    all.watch({&scene, 1}, energy);
    all.sample(bench.document().world());
    EXPECT_NEAR(all.series()[0].samples[0].value, bench.document().world().energy(),
                1e-5 * std::abs(energies.back().value));
}

// At each rate the steps of a tick are others, and so is the time of the velocities.
TEST(Measurement, WhatFallsKeepsItsEnergyAtEachRate) {
    const auto box = sulfur::scene::makePrefab("box", sulfur::shapes::BoxOptions{});
    for (const int rate : {60, 120, 240, 480, 500}) {
        sulfur::World world(sulfur::WorldSettings{.tickRate = rate});
        const auto body = world.add(box.blueprint, {}).id();
        const Quantity& energy = *quantity("energy");
        world.step();
        const double before = *energy.get(world, body);
        for (int i = 1; i < rate; ++i) world.step();
        const double mass = static_cast<double>(world.mass(body));
        EXPECT_NEAR(*energy.get(world, body), before, 0.002 * mass) << rate << " Hz";
    }
}

TEST(Measurement, WhatLiesIsHeldByItsWeight) {
    Workbench bench;
    const BodyId box = addBox(bench, {0, 0.1}, {1, 1.1});
    bench.measure(some({"contact-force"}));
    tickOn(bench, 600);
    const auto& samples = bench.measurements().series()[0].samples;
    const double weight = 9.81 * static_cast<double>(bench.document().world().mass(box));
    EXPECT_NEAR(mean(between(samples, 1.0, 1.2)), weight, 0.02 * weight);
}

/// A particle that a joint holds to a pin at the origin.
sulfur::scene::Prefab pendulum(sulfur::Vec2 at) {
    auto prefab = sulfur::scene::makePrefab("bob", sulfur::shapes::BoxOptions{});
    prefab.generator = {};
    auto& plan = prefab.blueprint;
    plan = {};
    plan.name = "bob";
    plan.particles.resize(2);
    plan.particles[0].pinned = true;
    plan.particles[1].position = at;
    plan.joints.push_back({.a = 0, .b = 1});
    return prefab;
}

TEST(Measurement, ThePendulumSwingsAsItsLengthSays) {
    // A ball on a rigid rod of 1 m, pulled aside by 0.1 rad: a physical pendulum.
    Workbench bench;
    Document& document = bench.document();
    const auto prefab = pendulum({std::sin(0.1f), -std::cos(0.1f)});
    document.edit("Add pendulum", [&] { document.add(prefab, fourMetresUp()); });
    const BodyId bob = document.world().bodies().back();
    bench.select({bob});
    bench.measure(some({"x", "angle"}));
    tickOn(bench, 5000);
    for (const Series& one : bench.measurements().series()) {
        const auto sine = fitSine(one.samples);
        ASSERT_TRUE(sine) << one.title();
        const double amplitude = 0.1;  // period = 2 pi sqrt(l/g) (1 + a^2/16)
        const double expected =
            std::sqrt(9.81) / (2 * std::numbers::pi) / (1 + amplitude * amplitude / 16);
        EXPECT_NEAR(sine->frequency, expected, 0.001 * expected) << one.title();
        EXPECT_LT(sine->deviation, 0.02 * sine->amplitude) << one.title();
    }
}

TEST(Measurement, ASineIsFoundAtAnyFrequencyAndPhase) {
    for (const double frequency : {0.06, 0.5, 3.7, 21.0})
        for (const double phase : {-2.0, 0.0, 1.3}) {
            std::vector<Sample> samples;
            for (int i = 0; i < 5000; ++i) {
                const double t = 3 + i * 0.002;
                samples.push_back(
                    {t, 5 + 0.3 * std::sin(2 * std::numbers::pi * frequency * t + phase)});
            }
            const auto fit = fitSine(samples);
            ASSERT_TRUE(fit);
            EXPECT_NEAR(fit->frequency, frequency, 1e-4 * frequency + 1e-4);
            EXPECT_NEAR(fit->amplitude, 0.3, 1e-3);
            EXPECT_NEAR(fit->mean, 5, 1e-3);
            EXPECT_NEAR(std::remainder(fit->phase - phase, 2 * std::numbers::pi), 0, 0.02);
            EXPECT_NEAR(fit->at(4), samples[500].value, 1e-3);
        }
    EXPECT_FALSE(fitSine({}));
    EXPECT_FALSE(fitLine({}));
}

TEST(Measurement, RewindingReplacesWhatCameLater) {
    Workbench bench;
    addBox(bench, {0, 8}, {1, 9});
    bench.measure(some({"height"}));
    tickOn(bench, 400);
    Document& document = bench.document();
    document.goTo({document.timeline().line(), 100});
    EXPECT_EQ(bench.measurements().series()[0].samples.size(), 400u);
    Constants constants = document.constants();
    constants.gravity = -9.81;
    document.setConstants(constants);
    tickOn(bench, 50);
    const auto& samples = bench.measurements().series()[0].samples;
    ASSERT_EQ(samples.size(), 150u);
    EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(),
                               [](const Sample& a, const Sample& b) { return a.time < b.time; }));
    EXPECT_NEAR(samples.back().time, 0.3, 1e-9);
    // It is the same body after a reset, whose handle may be another.
    document.reset();
    tickOn(bench, 20);
    EXPECT_EQ(bench.measurements().series()[0].samples.size(), 20u);
}

TEST(Measurement, SeveralBodiesTheSceneAndWhatDoesNotApply) {
    Workbench bench;
    const BodyId a = addBox(bench, {0, 3}, {1, 4});
    const BodyId b = addBox(bench, {2, 3}, {3, 4});
    bench.select({a, b});
    bench.measure(some({"kinetic", "height"}));
    tickOn(bench, 100);
    ASSERT_EQ(bench.measurements().series().size(), 4u);
    EXPECT_EQ(bench.measurements().series()[0].title(), "Energy of motion of box");
    EXPECT_EQ(bench.measurements().series()[2].title(), "Energy of motion of box2");
    const double both = bench.measurements().series()[0].samples.back().value +
                        bench.measurements().series()[2].samples.back().value;
    // Nothing selected: the last ones stay.
    bench.select({});
    bench.measure(some({"kinetic", "height"}));
    EXPECT_EQ(bench.measurements().series().size(), 4u);
    // In a new scene there is nothing but the scene.
    bench.document().clear();
    bench.documentChanged();
    bench.measure(some({"kinetic", "height"}));
    ASSERT_EQ(bench.measurements().series().size(), 1u);
    EXPECT_EQ(bench.measurements().series()[0].title(), "Energy of motion of the scene");
    EXPECT_GT(both, 0);
}

TEST(Measurement, AnglesGoOnBeyondHalfATurn) {
    Workbench bench;
    bench.document().setConstants({.gravity = 0, .elasticity = 1, .friction = 1, .airFriction = 0});
    const BodyId box = addBox(bench, {0, 3}, {1, 4});
    bench.measure(some({"angle", "spin"}));
    bench.tick();
    bench.document().world().setVelocity(box, sulfur::Vec2(0, 0), 10);
    tickOn(bench, 500);
    const auto& series = bench.measurements().series();
    const auto line = fitLine(between(series[0].samples, 0.1, 1.0));
    EXPECT_NEAR(line->slope, 10 * 180 / std::numbers::pi, 1);
    EXPECT_NEAR(series[1].samples.back().value, 10, 0.05);
}

TEST(Measurement, JointsTellTheirForceAndStrain) {
    Workbench bench;
    Document& document = bench.document();
    auto prefab = pendulum({0, -1});
    auto& plan = prefab.blueprint;
    plan.particles[1].mass = 2;
    plan.joints[0].stiffness = 200;
    plan.joints[0].damping = 20;
    document.edit("Add spring", [&] { document.add(prefab, fourMetresUp()); });
    bench.select({document.world().bodies().back()});
    bench.measure(some({"joint-force", "strain", "elastic"}));
    tickOn(bench, 3000);
    const auto& series = bench.measurements().series();
    EXPECT_NEAR(series[0].samples.back().value, 2 * 9.81, 0.1);
    EXPECT_NEAR(series[1].samples.back().value, 100 * 2 * 9.81 / 200, 0.1);
    EXPECT_NEAR(series[2].samples.back().value, 0.5 * 200 * std::pow(2 * 9.81 / 200, 2), 0.02);
}

TEST(Measurement, TheTableHasATimeAndAColumnForEach) {
    Series a{{}, 0, "a, b", quantity("height"), {{0.5, 1}, {1, 2}}};
    Series b{{}, 0, "c", quantity("speed"), {{1, 3.25}}};
    const std::array both{a, b};
    EXPECT_EQ(csv(both), "time/s,\"Height of a, b/m\",Speed of c/m/s\n0.5,1,\n1,2,3.25\n");
}

TEST(Measurement, NoMoreThanItsLimit) {
    Measurements measurements;
    sulfur::World world;
    const auto box = sulfur::scene::makePrefab("box", sulfur::shapes::BoxOptions{});
    const BodyId body = world.add(box.blueprint).id();
    const Measurements::Subject subject{body, 0, "box"};
    const auto height = some({"height"});
    measurements.watch({&subject, 1}, height);
    for (std::size_t i = 0; i < Measurements::mostSamples + 10; ++i) {
        world.step();
        measurements.sample(world);
    }
    EXPECT_LE(measurements.series()[0].samples.size(), Measurements::mostSamples);
    EXPECT_GT(measurements.series()[0].samples.size(), Measurements::mostSamples * 8 / 10);
    measurements.clear();
    EXPECT_TRUE(measurements.series()[0].samples.empty());
}

TEST(Measurement, TrailsFollowWhatIsSelected) {
    Workbench bench;
    addBox(bench, {0, 3}, {1, 4});
    bench.setTrails(true);
    tickOn(bench, 100);
    const auto& series = bench.trailMeasurements().series();
    ASSERT_EQ(series.size(), 2u);
    EXPECT_EQ(series[0].samples.size(), 100u);
    EXPECT_NEAR(series[0].samples.back().value, 0.5, 1e-6);
    EXPECT_LT(series[1].samples.back().value, series[1].samples.front().value);
    EXPECT_TRUE(bench.measurements().series().empty());
    bench.clearMeasurements();
    EXPECT_TRUE(series[0].samples.empty());
    bench.setTrails(false);
    EXPECT_TRUE(bench.trailMeasurements().series().empty());
    tickOn(bench, 10);
}

}  // namespace
}  // namespace sulfurchamber
