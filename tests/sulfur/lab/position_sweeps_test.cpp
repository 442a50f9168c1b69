// XPBD, where the motion is known.
#include "integrators/position_sweeps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace sulfur::lab;

const SweptBody fixed{};

/// Where a pendulum of 1 m that starts level is after 1 s.
Vec pendulumAfterASecond(double h) {
    PositionSweeps method({fixed, {.place = Vec(1, 0), .inverseMass = 1}},
                          {{.a = 0, .b = 1, .length = 1}}, 9.81, 1);
    for (long i = 0; i < std::lround(1 / h); ++i) method.step(h);
    return method.bodies()[1].place;
}

/// One link is solved exactly by one sweep: what is left is the order of the steps, which is one.
TEST(PositionSweeps, APendulumConvergesWithTheFirstOrder) {
    const Vec coarse = pendulumAfterASecond(1e-3), middle = pendulumAfterASecond(5e-4),
              fine = pendulumAfterASecond(2.5e-4);
    EXPECT_NEAR(fine.norm(), 1, 1e-12);
    EXPECT_NEAR(std::log2((coarse - middle).norm() / (middle - fine).norm()), 1, 0.1);
}

/// Two squares pinned by their corners, spinning in free flight.
TEST(PositionSweeps, PinnedBodiesKeepTheirMomentaAndTheirPin) {
    const SweptBody left{.place = Vec(-0.5, 0.5),
                         .velocity = Vec(1, 0),
                         .spin = 5,
                         .inverseMass = 1,
                         .inverseInertia = 6};
    const SweptBody right{.place = Vec(0.5, -0.5), .inverseMass = 0.5, .inverseInertia = 3};
    PositionSweeps method({left, right}, {{0, 1, Vec(0.5, -0.5), Vec(-0.5, 0.5), 0}}, 0, 20);
    const auto spinOf = [](const SweptBody& body) {
        const Vec& x = body.place;
        const Vec& v = body.velocity;
        return (x.x() * v.y() - x.y() * v.x()) / body.inverseMass + body.spin / body.inverseInertia;
    };
    const double spin = spinOf(left) + spinOf(right);
    for (int i = 0; i < 1000; ++i) method.step(1e-3);
    const SweptBody &a = method.bodies()[0], &b = method.bodies()[1];
    EXPECT_LT((a.at(Vec(0.5, -0.5)) - b.at(Vec(-0.5, 0.5))).norm(), 1e-9);
    EXPECT_LT((a.velocity + 2 * b.velocity - Vec(1, 0)).norm(), 1e-9);
    EXPECT_NEAR(spinOf(a) + spinOf(b), spin, 5e-3 * spin);
    EXPECT_GT(std::abs(b.spin), 0.1);
}

TEST(PositionSweeps, WhatIsFixedStays) {
    PositionSweeps method({fixed, fixed}, {{.a = 0, .b = 1, .length = 1}}, 9.81, 3);
    method.step(0.01);
    EXPECT_EQ(method.bodies()[1].place, Vec(0, 0));
}

}  // namespace
