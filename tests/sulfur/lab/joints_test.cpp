// The instruments of the scenes with joints, where what they must show is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "battery/joints/joints.hpp"
#include "battery/joints/subjects.hpp"

namespace {

using namespace sulfur;
using namespace sulfur::lab;

JointSubject ours(int rate) {
    return {{.engine = "sulfur", .rate = rate, .iterations = 4}, true};
}

TEST(JointSubjects, AreOursAtEveryRateWithBox2dBeside) {
    const auto all = jointSubjects({});
    for (const int rate : jointRates())
        EXPECT_EQ(std::count_if(all.begin(), all.end(),
                                [&](const auto& s) { return s.ours && s.setting.rate == rate; }),
                  1);
    for (const JointSubject& subject : all) {
        EXPECT_EQ(subject.row("x", 2, 1).passed, !subject.ours) << subject.label();
        EXPECT_FALSE(subject.row("x", NAN, 1).passed);
    }
}

TEST(Anchors, TellHowFarApartAndHowTurnedTwoBodiesAre) {
    const auto world = ours(500).world(true);
    Workshop workshop(*world);
    const auto nail = workshop.addNail({1, 2});
    const auto beam = workshop.add(
        {.parts = {bench::rectangle({0.5, 0.1})}, .place = {1.5, 2}, .angle = 0.5, .group = 1});
    const auto joint = workshop.join({.a = nail, .b = beam, .at = {1, 2}});
    EXPECT_NEAR(workshop.anchors(joint).gap(*world).norm(), 0, 1e-6);
    EXPECT_NEAR(workshop.anchors(joint).value(*world), 0, 1e-6);
    // What is not the joint's own is seen: it turns about the nail, and holds.
    for (int i = 0; i < 250; ++i) {
        world->applyTorque(beam, 1);
        world->step();
    }
    const double turned = world->body(beam).angle - 0.5;
    EXPECT_GT(turned, 0.3);
    EXPECT_NEAR(workshop.anchors(joint).value(*world), turned, 1e-6);
    EXPECT_NEAR(workshop.anchors(joint).gap(*world).norm(), 0, 1e-5);
    Anchors wrong = workshop.anchors(joint);
    wrong.onB += Point(0, 0.01);
    EXPECT_NEAR(wrong.gap(*world).norm(), 0.01, 1e-5);
}

TEST(JointPlan, MeansTheSameSpringByItsFrequency) {
    const auto world = ours(500).world(true);
    Workshop workshop(*world);
    const bench::BodyPlan plan{.parts = {bench::disc(0.5)}, .group = 1};
    const auto nail = workshop.addNail({0, 0});
    const auto wheel = workshop.add(plan);
    workshop.join({.a = nail, .b = wheel, .hertz = 2});
    for (int i = 0; i < 25; ++i) {
        world->applyTorque(wheel, 1);
        world->step();
    }
    int crossings = 0;
    double before = world->body(wheel).angle;
    for (int i = 0; i < 2500; ++i) {
        world->step();
        const double now = world->body(wheel).angle;
        crossings += (now > 0) != (before > 0) ? 1 : 0;
        before = now;
    }
    EXPECT_NEAR(crossings, 20, 1) << "in 5 s at 2 Hz";
}

}  // namespace
