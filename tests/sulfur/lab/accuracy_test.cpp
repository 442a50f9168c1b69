// The work-precision diagrams: their references and their errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "accuracy/piles.hpp"
#include "accuracy/show.hpp"
#include "accuracy/work_precision.hpp"
#include "integrators/integrator.hpp"
#include "references/chain.hpp"

namespace {

using namespace sulfur::lab;

Subject only(const std::string& key, std::vector<int> rates) {
    for (Subject subject : accuracySubjects(true)) {
        if (subject.key != key) continue;
        subject.rates = std::move(rates);
        return subject;
    }
    throw std::out_of_range(key);
}

constexpr CostOptions oneMeasurement{.least = 0, .repeats = 1, .most = 100};

std::vector<double> errors(const AccuracyScene& scene, const Subject& subject) {
    const WorkPrecision work = measureWorkPrecision(scene, {subject}, oneMeasurement);
    std::vector<double> found;
    for (const WorkPoint& point : work.curves.front().points) found.push_back(point.error);
    return found;
}

TEST(Accuracy, SuvatAndTheWorldFallExactly) {
    const auto scene = makeScene("fall", {});
    EXPECT_LT(errors(scene, only("suvat", {60})).front(), 1e-12);
    EXPECT_LT(errors(scene, only("world-4", {60})).front(), 1e-4);
    EXPECT_GT(errors(scene, only("euler", {60})).front(), 1e-2);
}

TEST(Accuracy, ErrorsShrinkWithTheOrder) {
    const auto scene = makeScene("spring", {});
    const auto order = [&](const std::string& key) {
        const auto found = errors(scene, only(key, {500, 1000}));
        return std::log2(found[0] / found[1]);
    };
    EXPECT_NEAR(order("rk4"), 4, 0.2);
    EXPECT_NEAR(order("rk2"), 2, 0.2);
    EXPECT_NEAR(order("euler"), 1, 0.2);
}

TEST(Accuracy, StiffSpringsConvergeToTheRigidReference) {
    auto scene = makeScene("double", {});
    EXPECT_LT(scene.referenceError, 1e-9);
    const double soft = errors(scene, only("rk4", {20000})).front();
    scene.rigidStandIn *= 10;
    const double stiff = errors(scene, only("rk4", {20000})).front();
    EXPECT_LT(soft, 1e-3);
    EXPECT_NEAR(stiff / soft, 0.1, 0.03);
}

TEST(Accuracy, AStackStaysWhereItIsAndNoIntegratorPlaysIt) {
    const auto scene = makeScene("stack", {});
    EXPECT_LT(errors(scene, only("world-4", {500})).front(), 2e-3);
    EXPECT_FALSE(only("rk4", {500}).plays(scene));
    const auto subjects = accuracySubjects(true);
    const auto plays = [&](const Subject& s) { return !s.plays || s.plays(scene); };
    EXPECT_GE(std::count_if(subjects.begin(), subjects.end(), plays), 3);
}

TEST(Accuracy, AnExplosionIsNoPoint) {
    const auto work =
        measureWorkPrecision(makeScene("crate", {}), {only("euler", {500})}, oneMeasurement);
    EXPECT_TRUE(std::isinf(work.curves.front().points.front().error));
    EXPECT_TRUE(std::isnan(work.curves.front().points.front().cost));
    EXPECT_NE(asText({work}, oneMeasurement).find("exploded"), std::string::npos);
}

TEST(Accuracy, EverySceneHasAReferenceAndWatchedParticles) {
    for (const std::string& key : sceneKeys()) {
        const auto scene = makeScene(key, {.quick = true});
        EXPECT_FALSE(scene.reference.empty()) << key;
        EXPECT_FALSE(scene.error.empty()) << key;
        EXPECT_GE(scene.path.size(), 5u) << key;
        EXPECT_LT(scene.referenceError, 1e-6) << key;
        for (const auto& places : scene.path) EXPECT_EQ(places.size(), scene.watched.size()) << key;
        if (!scene.masses.empty()) {
            EXPECT_NO_THROW(scene.blueprint().validate()) << key;
        }
        EXPECT_EQ(scene.hasRigidJoints(), scene.rigidStandIn > 0) << key;
    }
}

TEST(Accuracy, OffersEveryIntegratorAndThreeSettingsOfOurs) {
    std::set<std::string> keys;
    for (const Subject& subject : accuracySubjects(false)) keys.insert(subject.key);
    for (const auto& entry : integrators()) EXPECT_TRUE(keys.count(entry.key)) << entry.key;
    EXPECT_TRUE(keys.count("world-1") && keys.count("world-4") && keys.count("world-16"));
}

TEST(Accuracy, TheFrontHoldsWhatNothingBeats) {
    WorkPrecision work;
    work.curves = {{"a", "A", true, {{60, 1e-1, 1}, {500, 1e-3, 5}, {1000, 1e-3, 8}}, ""},
                   {"b", "B", false, {{60, 2e-1, 2}, {500, 1e-2, 3}}, ""}};
    const auto front = paretoFront(work);
    ASSERT_EQ(front.size(), 3u);
    EXPECT_EQ(front[0].title, "A");
    EXPECT_EQ(front[1].title, "B");
    EXPECT_EQ(front[1].point.cost, 3);
    EXPECT_EQ(front[2].point.cost, 5);
    for (WorkCurve& curve : work.curves)
        for (WorkPoint& point : curve.points) point.strain = 1 / point.error;
    const auto byStrain = paretoFront(work, &WorkPoint::strain);
    ASSERT_EQ(byStrain.size(), 2u);
    EXPECT_EQ(byStrain[0].point.cost, 1);
    EXPECT_EQ(byStrain[1].point.cost, 2);
    const auto coarse = paretoFront(work, &WorkPoint::error, 5e-3);
    ASSERT_EQ(coarse.size(), 2u);
    EXPECT_EQ(coarse[1].point.error, 1e-2);
}

TEST(Accuracy, OtherEnginesPlayChainsNetsGridsAndStacksOnly) {
    const auto isIntegrator = [](const Subject& subject) {
        return std::any_of(integrators().begin(), integrators().end(),
                           [&](const IntegratorEntry& entry) { return entry.key == subject.key; });
    };
    std::map<std::string, AccuracyScene> scenes;
    for (const std::string& key : sceneKeys()) scenes[key] = makeScene(key, {.quick = true});
    for (const Subject& subject : accuracySubjects(true)) {
        if (!subject.plays || isIntegrator(subject)) continue;
        const bool sweeps = subject.key.starts_with("xpbd"), nets = subject.key != "bullet-10";
        const std::map<std::string, bool> expected{{"pendulum", true},
                                                   {"rope", true},
                                                   {"double", true},
                                                   {"stack", !sweeps},
                                                   {"lattice", nets && !sweeps},
                                                   {"net", nets},
                                                   {"cloth", nets},
                                                   {"grid", nets},
                                                   {"crate", sweeps},
                                                   {"spring", false},
                                                   {"fall", false}};
        for (const auto& [key, plays] : expected)
            EXPECT_EQ(subject.plays(scenes.at(key)), plays) << subject.key << ' ' << key;
    }
}

/// The springs know nothing of rows and columns, from which the reference is made.
TEST(Accuracy, StiffSpringsConvergeToTheReferenceOfANet) {
    for (const char* key : {"net", "cloth"}) {
        auto scene = makeScene(key, {.load = 1, .quick = true});
        EXPECT_LT(scene.referenceError, 1e-8) << key;
        scene.path.resize(2);
        scene.rigidStandIn *= 4;
        const double soft = errors(scene, only("rk4", {50000})).front();
        scene.rigidStandIn *= 4;
        const double stiff = errors(scene, only("rk4", {50000})).front();
        EXPECT_LT(soft, 1e-3) << key;
        EXPECT_LT(stiff, 0.4 * soft) << key;
    }
}

/// A load that weighs 10,000 times as much as the net swings below the tip of its taut V.
TEST(Accuracy, AHeavyLoadOnANetIsAPendulum) {
    const auto scene = makeScene("net", {.load = 1e6, .quick = true});
    constexpr double length = 0.5, lean = 0.2;
    const Vec start = length * Vec(std::sin(lean), -std::cos(lean));
    const Vec tip = scene.start.x[5];
    EXPECT_LT((scene.start.x[scene.watched.front()] - tip - start).norm(), 1e-12);
    const ChainPath pendulum = convergedPath({{length}, {1}}, {{start}, {Vec(0, 0)}},
                                             scene.interval, scene.path.size(), 1e-9);
    for (std::size_t n = 0; n < scene.path.size(); ++n)
        EXPECT_LT((scene.path[n].front() - tip - pendulum.states[n + 1].x.front()).norm(), 2e-4);
}

TEST(Accuracy, TheWorldHoldsNetsAndGridsAtAnyLoad) {
    for (const char* key : {"net", "cloth", "grid"}) {
        for (const double load : {1.0, 1e6}) {
            const auto scene = makeScene(key, {.load = load, .quick = true});
            const auto work = measureWorkPrecision(
                scene, {only("world-4", {60}), only("xpbd-1", {60})}, oneMeasurement);
            const WorkPoint &ours = work.curves[0].points[0], &swept = work.curves[1].points[0];
            EXPECT_LT(ours.strain, 1e-3) << key << ' ' << load;
            EXPECT_LT(ours.error, 1e-2) << key << ' ' << load;
            EXPECT_GT(swept.strain, 100 * ours.strain) << key << ' ' << load;
        }
    }
}

/// Where sweeps go one way only it explodes.
TEST(Accuracy, SweepsOfAGridConverge) {
    auto scene = makeScene("grid", {.load = 1, .quick = true});
    scene.path.resize(3);
    const auto found = errors(scene, only("xpbd-1", {500, 10000}));
    EXPECT_GT(found[0], 1e-2);
    EXPECT_LT(found[1], 1e-2);
}

TEST(Accuracy, StrainIsShownWhereSomethingIsTied) {
    const auto fall =
        measureWorkPrecision(makeScene("fall", {}), {only("world-4", {60})}, oneMeasurement);
    EXPECT_EQ(asText({fall}, oneMeasurement).find("strain"), std::string::npos);
    for (const auto& [key, what] :
         {std::pair{"double", "strain of a rigid joint"}, std::pair{"grid", "opening of a pin"}}) {
        auto scene = makeScene(key, {.quick = true});
        scene.path.resize(1);
        const auto work = measureWorkPrecision(scene, {only("xpbd-1", {60})}, oneMeasurement);
        EXPECT_GT(work.curves.front().points.front().strain, 0) << key;
        EXPECT_NE(asText({work}, oneMeasurement).find(what), std::string::npos) << key;
        EXPECT_NE(asSvg(work, &WorkPoint::strain).find(what), std::string::npos) << key;
        EXPECT_EQ(asSvg(work).find(what), std::string::npos) << key;
    }
}

TEST(Accuracy, EveryContenderHasItsPointsForAPile) {
    const WorkPrecision work = measurePile("S2", true);
    ASSERT_FALSE(work.curves.empty());
    EXPECT_TRUE(work.curves.front().ours);
    for (const WorkCurve& curve : work.curves)
        for (const WorkPoint& point : curve.points)
            EXPECT_TRUE(std::isfinite(point.error) && point.cost > 0) << curve.title;
    EXPECT_FALSE(paretoFront(work).empty());
}

}  // namespace
