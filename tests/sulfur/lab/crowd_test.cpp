// S8: bodies of any outline, what they overlap, and that every scene runs in every engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sulfur/sulfur.hpp>

#include "bench/compare.hpp"
#include "bench/crowd.hpp"
#include "bench/engines/sulfur_blueprints.hpp"
#include "figure_of.hpp"
#include "settings_of.hpp"

namespace {

using namespace sulfur;
using namespace sulfur::lab;
using namespace sulfur::lab::bench;

constexpr double pi = std::numbers::pi;

/// Counts what a scene makes, and moves nothing.
class Counter final : public EngineWorld {
public:
    void addFixed(const Point&, const Point&) override {}
    void addSquare(const Point&, double, const Point&) override {}
    void addRope(const RopePlan&) override {}
    void addBlob(const Point&) override {}
    void addBody(const BodyPlan& plan) override { plans.push_back(plan); }
    void addPin(const PinPlan&) override { ++pins; }
    void removeBody(std::size_t) override { ++removed; }
    void step() override {}
    std::pair<Point, double> square(std::size_t) const override { return {}; }
    std::vector<Point> rope(std::size_t) const override { return {}; }
    std::vector<Point> blob(std::size_t) const override { return {}; }
    Motion body(std::size_t i) const override {
        return {.place = plans[i].place,
                .angle = plans[i].angle,
                .velocity = plans[i].velocity,
                .spin = plans[i].spin};
    }

    int moving() const {
        return static_cast<int>(std::count_if(plans.begin(), plans.end(), [](const BodyPlan& plan) {
            return plan.mover == Mover::physics;
        }));
    }

    std::vector<BodyPlan> plans;
    int pins = 0, removed = 0;
};

TEST(BenchOutlines, HaveTheMomentsOfSolids) {
    EXPECT_NEAR(disc(2).area(), 4 * pi, 1e-12);
    EXPECT_NEAR(disc(2).gyration2(), 2, 1e-12);
    EXPECT_NEAR(rectangle(Point(1, 2)).area(), 8, 1e-12);
    EXPECT_NEAR(rectangle(Point(1, 2)).gyration2(), (4.0 + 16) / 12, 1e-12);
    // Without length a disc, without thickness a rod.
    EXPECT_NEAR(capsule(Point(1, 0), Point(1 + 1e-9, 0), 2).gyration2(), 1 + 2, 1e-6);
    EXPECT_NEAR(capsule(Point(-1, 0), Point(1, 0), 1e-9).gyration2(), 4.0 / 12, 1e-6);
    EXPECT_NEAR(capsule(Point(-1, 0), Point(1, 0), 0.5).area(), 2 + pi / 4, 1e-12);
}

TEST(BenchOutlines, OverlapAlongTheShortestWay) {
    const auto at = [](const Outline& outline, double x, double y, double angle = 0) {
        return placed(outline, {.place = Point(x, y), .angle = angle});
    };
    const Outline square = rectangle(Point(0.5, 0.5));
    EXPECT_NEAR(overlapOf(at(disc(1), 0, 0), at(disc(0.5), 0, 1.4)), 0.1, 1e-12);
    EXPECT_NEAR(overlapOf(at(square, 0, 0), at(disc(0.5), 0.9, 0)), 0.1, 1e-12);
    // A corner that looks at a disc, and one that looks at a side.
    EXPECT_NEAR(overlapOf(at(square, 0, 0), at(disc(0.5), 0.8, 0.9)), 0, 1e-12);
    EXPECT_NEAR(overlapOf(at(square, 0, 0), at(square, 1.1, 0, pi / 4)), 0.5 + std::sqrt(0.5) - 1.1,
                1e-12);
    const Outline rod = capsule(Point(-1, 0), Point(1, 0), 0.1);
    EXPECT_NEAR(overlapOf(at(rod, 0, 0), at(rod, 2.1, 0)), 0.1, 1e-9);
    EXPECT_NEAR(overlapOf(at(rod, 0, 0), at(rod, 0, 0.15)), 0.05, 1e-12);
    // Crossed in the middle, each must go to the other's end.
    EXPECT_NEAR(overlapOf(at(rod, 0, 0), at(rod, 0, 0, pi / 2)), 1.2, 1e-9);
    EXPECT_LT(overlapOf(at(rod, 0, 0), at(square, 2, 2)), 0);
}

TEST(BenchOutlines, OnlyWhatMayTouchOverlaps) {
    const auto piece = [](double x, std::size_t body, int group, bool moves) {
        return Piece{placed(disc(0.5), {.place = Point(x, 0)}), body, group, moves};
    };
    EXPECT_EQ(overlaps({piece(0, 0, 0, true), piece(0.9, 1, 0, false)}).size(), 1u);
    EXPECT_EQ(overlaps({piece(0, 0, 0, false), piece(0.9, 1, 0, false)}).size(), 0u);
    EXPECT_EQ(overlaps({piece(0, 0, 0, true), piece(0.9, 0, 0, true)}).size(), 0u);
    EXPECT_EQ(overlaps({piece(0, 0, 1, true), piece(0.9, 1, 1, true)}).size(), 0u);
    EXPECT_EQ(overlaps({piece(0, 0, 1, true), piece(0.9, 1, 2, true)}).size(), 1u);
    EXPECT_EQ(overlaps({piece(0, 0, 0, true), piece(1.1, 1, 0, true)}).size(), 0u);
}

TEST(BenchBodies, OursHaveTheMassAndTheInertiaOfThePlan) {
    const Point left(-1, -8.0 / 9), right(1, -8.0 / 9), notch(0, -2.0 / 9), top(0, 10.0 / 9);
    BodyPlan dart{.parts = {{{left, notch, top}}, {{notch, right, top}}}};
    dart.contour = {left, notch, right, top};
    BodyPlan pinned{.parts = {disc(0.4)}};
    pinned.sockets = {{0, 0.5}, {0, -0.5}, {-0.5, 0}, {0.5, 0}};
    const BodyPlan box{.parts = {rectangle(Point(0.2, 0.1))}, .density = 8};
    const BodyPlan* const plans[] = {&dart, &pinned, &box};
    for (const BodyPlan* plan : plans) {
        const Blueprint body = blueprintOf(*plan);
        double inertia = 0;
        for (const ParticleSpec& particle : body.particles)
            inertia +=
                static_cast<double>(particle.mass) * particle.position.cast<double>().squaredNorm();
        EXPECT_NEAR(static_cast<double>(body.mass()) / plan->mass(), 1, 1e-5);
        EXPECT_NEAR(body.centreOfMass().cast<double>().norm(), 0, 1e-5);
        EXPECT_NEAR(inertia / plan->inertia(), 1, 1e-4);
        EXPECT_NO_THROW(body.validate());
    }
}

TEST(BenchCrowds, AreChosenByName) {
    EXPECT_EQ(scenes({"S8"}, Extent::quick).size(), crowdNames().size());
    const auto one = scenes({"S8:smash"}, Extent::quick);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].variant, "smash");
    for (const Scene& scene : scenes({}, Extent::quick)) EXPECT_NE(scene.key, "S8");
    EXPECT_THROW(crowd("nothing", Extent::quick), std::out_of_range);
}

TEST(BenchCrowds, HaveTheSizesOfTheirModels) {
    const auto made = [](const std::string& name) {
        Counter world;
        const auto play = crowd(name, Extent::usual).play();
        play->begin(world);
        play->before(world, 0);
        EXPECT_EQ(figureOf(play->figures(world), "lost"), 0) << name;
        return std::pair{world.moving(), world.pins};
    };
    EXPECT_EQ(made("tumbler").first, 2025);
    EXPECT_EQ(made("spinner").first, 6076);
    EXPECT_EQ(made("smash").first, 9601);
    EXPECT_EQ(made("rain").first, 5 * 25);
    EXPECT_EQ(made("large-pyramid").first, 5050);
    EXPECT_EQ(made("many-pyramids").first, 22'000);
    // Between the seven fixed ones there are no pins.
    EXPECT_EQ(made("joint-grid"), (std::pair{100 * 100 - 7, 2 * 100 * 99 - 6}));
    EXPECT_EQ(made("barrels").first, 3900);
    EXPECT_EQ(made("compounds").first, 3000);
}

TEST(BenchCrowds, RainGoesWhenItsPlaceIsNeededAgain) {
    Counter world;
    const auto play = crowd("rain", Extent::quick).play();
    play->begin(world);
    play->before(world, 9.5 * 8 / 60);
    EXPECT_EQ(world.moving(), 10 * 2 * 25);
    EXPECT_EQ(world.removed, 0);
    play->before(world, 10.5 * 8 / 60);
    EXPECT_EQ(world.removed, 2 * 25);
}

TEST(BenchCrowds, EverySceneRunsInEveryEngine) {
    for (const std::string& name : crowdNames()) {
        Scene scene = crowd(name, Extent::quick);
        scene.seconds = 0.05;
        for (const Setting& setting : settingsOf(scene)) {
            const RunResult run = runOnce(scene, engineOf(setting.engine), setting, 60);
            EXPECT_EQ(run.simulated, scene.seconds) << name << ", " << setting.engine;
            EXPECT_EQ(figureOf(run.figures, "lost"), 0) << name << ", " << setting.engine;
            EXPECT_GT(figureOf(run.figures, "worst tick"), 0);
            for (const Figure& figure : run.figures)
                EXPECT_TRUE(std::isfinite(figure.value)) << name << ", " << figure.name;
        }
    }
}

TEST(BenchCrowds, MotorsTurnAndPinsHoldInEveryEngine) {
    for (const Setting& setting : settingsOf(crowd("tumbler", Extent::quick))) {
        const auto world = engineOf(setting.engine).make(setting);
        BodyPlan rod{.parts = {rectangle(Point(2, 0.1))}};
        rod.mover = Mover::motor;
        rod.place = Point(5, 0);
        rod.spin = 0.5;
        world->addBody(rod);
        BodyPlan bob{.parts = {disc(0.4)}};
        bob.sockets = {{-0.5, 0}, {0.5, 0}};
        for (int i = 0; i < 2; ++i) {
            bob.mover = i == 0 ? Mover::nobody : Mover::physics;
            bob.place = Point(i, 0);
            bob.group = 1;
            world->addBody(bob);
        }
        world->addPin({1, 1, 2, 0});
        double lowest = 0;
        for (int tick = 0; tick < setting.rate; ++tick) {
            world->step();
            const auto [a, b] = world->pin(0);
            EXPECT_LT((a - b).norm(), 0.02) << setting.engine;
            lowest = std::min(lowest, world->body(2).place.y());
        }
        EXPECT_NEAR(world->body(0).angle, 0.5, 1e-3) << setting.engine;
        EXPECT_NEAR(lowest, -0.5, 0.03) << setting.engine;
    }
}

}  // namespace
