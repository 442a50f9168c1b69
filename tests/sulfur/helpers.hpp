// What several tests need.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sulfur/sulfur.hpp>

#include "random_numbers.hpp"

namespace sulfur::test {

inline void run(World& world, double seconds) {
    const auto ticks = std::lround(seconds * world.settings().tickRate);
    for (long i = 0; i < ticks; ++i) world.step();
}

/// A particle that collides, and that turns.
inline Blueprint disc() {
    return {.particles = {{.radius = Real(0.5)}}};
}

/// m/s, of its centre of mass.
inline double speedOf(const Body& body) {
    return static_cast<double>(body.meanVelocity().norm());
}

/// The largest deviation of a joint of `body` from its rest length, in that length.
inline double largestStrain(const World& world, const Body& body) {
    double worst = 0;
    for (const JointId id : body.joints()) {
        const JointInfo joint = world.info(id);
        const double length = (world.position(joint.b) - world.position(joint.a)).norm();
        worst = std::max(worst, std::abs(length / static_cast<double>(joint.restLength) - 1));
    }
    return worst;
}

/// Expects that `call` throws Error with `code` and leaves the world's state as it was.
template <class Function>
void expectRefused(World& world, ErrorCode code, Function&& call) {
    const auto before = world.hash();
    try {
        call();
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
        EXPECT_GT(std::string(error.what()).size(), 20u);
    }
    EXPECT_EQ(world.hash(), before);
    EXPECT_EQ(world.validate(), "");
}

/// A plan with somebody else to move it.
inline Blueprint ofKind(Blueprint plan, BodyKind kind) {
    plan.kind = kind;
    return plan;
}

}  // namespace sulfur::test
