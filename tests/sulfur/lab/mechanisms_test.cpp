// S9: what the instruments of mechanisms tell where it is known, and that every scene runs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bench/compare.hpp"
#include "bench/mechanisms.hpp"
#include "figure_of.hpp"
#include "settings_of.hpp"

namespace {

using namespace sulfur;
using namespace sulfur::lab;
using namespace sulfur::lab::bench;

TEST(BenchMechanisms, AreChosenByName) {
    EXPECT_EQ(scenes({"S9"}, Extent::quick).size(), 7u);
    const auto one = scenes({"S9:door"}, Extent::quick);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].variant, "door");
    EXPECT_TRUE(one[0].weightless);
    for (const Scene& scene : scenes({}, Extent::quick)) EXPECT_NE(scene.key, "S9");
    EXPECT_THROW(mechanism("nothing", Extent::quick), std::out_of_range);
}

TEST(BenchMechanisms, TellHowFarAValueIsBeyondItsLimits) {
    EXPECT_EQ(beyond({.lower = -1, .upper = 2}, 1.5), 0);
    EXPECT_EQ(beyond({.lower = -1, .upper = 2}, 2.5), 0.5);
    EXPECT_EQ(beyond({.lower = -1}, -4), 3);
    EXPECT_EQ(beyond({}, 1e9), 0);
    EXPECT_TRUE(std::isnan(worse(1, NAN)));
    EXPECT_TRUE(std::isnan(worse(NAN, 1)));
    EXPECT_EQ(worse(1, 2), 2);
}

TEST(BenchMechanisms, BodiesAreMovedToTheirCentreOfMass) {
    std::vector<Point> corners{{1, 1}, {4, 1}, {1, 4}};
    EXPECT_NEAR((centre(corners) - Point(2, 2)).norm(), 0, 1e-12);
    EXPECT_NEAR((corners[0] - Point(-1, -1)).norm(), 0, 1e-12);
    const BodyPlan line = road({{0, 0}, {2, 0}, {4, 1}}, 0.7);
    ASSERT_EQ(line.parts.size(), 2u);
    EXPECT_EQ(line.parts[0].points[1], line.parts[1].points[0]);
    EXPECT_NEAR(line.parts[0].points[0].y() + line.parts[0].radius, 0, 1e-12);
}

TEST(BenchMechanisms, WhatSlidesOpensAcrossItsLineOnly) {
    const auto world = engineOf("sulfur").make({.engine = "sulfur", .weightless = true});
    Workshop workshop(*world);
    const auto nail = workshop.addNail({0, 0});
    const auto block = workshop.add(
        {.parts = {rectangle({0.2, 0.1})}, .place = {1, 0}, .velocity = {0.5, 0}, .group = 1});
    const auto rail = workshop.join(
        {.kind = JointPlan::Kind::slider, .a = nail, .b = block, .at = {1, 0}, .axis = {1, 0}});
    for (int i = 0; i < 500; ++i) world->step();
    EXPECT_NEAR(workshop.anchors(rail).slid(*world), 0.5, 1e-4);
    EXPECT_LT(workshop.anchors(rail).opening(*world), 1e-5);
    Anchors wrong = workshop.anchors(rail);
    wrong.onB += Point(0, 0.03);
    EXPECT_NEAR(wrong.opening(*world), 0.03, 1e-5);
}

/// How far a motor of 100 N may push 31 g over the limit of their distance, m. Ours has both in one
/// row, in which the limit wins. Box2D solves a soft limit, then the motor, which so has the last
/// word: 22 mm is what its limit gives way at 500 x 1.
double allowedBeyond(const Setting& setting) {
    return setting.engine == "sulfur" ? 1e-3 : 0.05;
}

TEST(BenchMechanisms, ADistanceHasLimitsAndAMotorInEveryEngine) {
    for (const Setting& setting : settingsOf(mechanism("door", Extent::quick))) {
        const auto world = engineOf(setting.engine).make(setting);
        Workshop workshop(*world);
        const auto nail = workshop.addNail({0, 0});
        const auto ball = workshop.add({.parts = {disc(0.1)}, .place = {1, 0}, .group = 1});
        const auto winch = workshop.join({.kind = JointPlan::Kind::distance,
                                          .a = nail,
                                          .b = ball,
                                          .at = {0, 0},
                                          .atB = {1, 0},
                                          .lower = 0.5,
                                          .upper = 1.2,
                                          .motorSpeed = 0.4,
                                          .motorMax = 100});
        for (int i = 0; i < setting.rate / 4; ++i) world->step();
        EXPECT_NEAR(workshop.anchors(winch).gap(*world).norm(), 1.1, 0.01) << setting.engine;
        for (int i = 0; i < setting.rate; ++i) world->step();
        EXPECT_NEAR(workshop.anchors(winch).gap(*world).norm(), 1.2, allowedBeyond(setting))
            << setting.engine;
    }
}

TEST(BenchMechanisms, ABlowTurnsAsItsLeverSaysInEveryEngine) {
    for (const Setting& setting : settingsOf(mechanism("door", Extent::quick))) {
        const auto world = engineOf(setting.engine).make(setting);
        const BodyPlan rod{.parts = {rectangle({0.5, 0.1})}, .place = {2, 3}};
        world->addBody(rod);
        world->applyImpulse(0, Point(0, 0.1), Point(2.5, 3));
        world->step();
        EXPECT_NEAR(world->body(0).velocity.y(), 0.1 / rod.mass(), 1e-3) << setting.engine;
        EXPECT_NEAR(world->body(0).spin, 0.05 / rod.inertia(), 0.05) << setting.engine;
    }
}

/// A rod that flies, and is struck in its first tick where there is no weight.
class Thrown final : public Contraption {
public:
    explicit Thrown(bool struck) : struck_(struck) {}
    void before(EngineWorld& world, double time) override {
        if (struck_ && time == 0) world.applyImpulse(0, Point(0, 0.1), Point(2.5, 3));
    }
    static BodyPlan rod() { return {.parts = {rectangle({0.5, 0.1})}, .place = {2, 3}}; }

protected:
    double weight() const override { return struck_ ? 0 : gravity; }
    void build(Workshop& workshop) override {
        BodyPlan plan = rod();
        if (!struck_) plan.velocity = {1, 4};
        workshop.add(plan);
    }

private:
    bool struck_;
};

TEST(BenchMechanisms, TellTheEnergyThatABlowGivesAndAFlightKeeps) {
    const BodyPlan rod = Thrown::rod();
    const double given = 0.1 * 0.1 / (2 * rod.mass()) + 0.05 * 0.05 / (2 * rod.inertia());
    for (const bool struck : {true, false}) {
        Scene scene = mechanism("door", Extent::quick);
        scene.seconds = 0.5;
        scene.weightless = struck;
        scene.play = [=] { return std::make_unique<Thrown>(struck); };
        for (const Setting& setting : settingsOf(scene)) {
            const RunResult run = runOnce(scene, engineOf(setting.engine), setting, 60);
            // A flight that falls in steps of h loses or gains m g v h / 2 at most.
            const double allowed = struck ? 0.02 * given : 0.2 * 9.81 * 4 / setting.rate;
            EXPECT_NEAR(figureOf(run.figures, "energy gained"), struck ? given : 0, allowed)
                << setting.engine;
        }
    }
}

TEST(BenchMechanisms, EverySceneRunsInEveryEngine) {
    for (const std::string& name : mechanismNames()) {
        Scene scene = mechanism(name, Extent::quick);
        scene.seconds = 0.1;
        for (const Setting& setting : settingsOf(scene)) {
            const RunResult run = runOnce(scene, engineOf(setting.engine), setting, 60);
            EXPECT_EQ(run.simulated, scene.seconds) << name << ", " << setting.engine;
            EXPECT_TRUE(std::isfinite(figureOf(run.figures, scene.error))) << name;
            for (const Figure& figure : run.figures)
                EXPECT_TRUE(std::isfinite(figure.value)) << name << ", " << figure.name;
        }
    }
}

TEST(BenchMechanisms, OurCarsGoAsFarAsTheirMotorsSay) {
    const Scene scene = mechanism("car", Extent::quick);
    const RunResult run =
        runOnce(scene, engineOf("sulfur"), {.engine = "sulfur", .rate = 500, .iterations = 4}, 60);
    EXPECT_LT(figureOf(run.figures, "error of the way"), 3);
    EXPECT_LT(figureOf(run.figures, "max opening"), 0.1);
}

}  // namespace
