#include "helpers.hpp"

namespace sulfur {
namespace {

Blueprint pair() {
    Blueprint plan;
    plan.particles = {{.position = {0, 0}, .mass = 1}, {.position = {2, 0}, .mass = 3}};
    plan.joints = {{.a = 0, .b = 1}};
    return plan;
}

void expectRefused(const Blueprint& plan, ErrorCode code, const std::string& mentions) {
    try {
        plan.validate();
        ADD_FAILURE() << "accepted, expected a message with: " << mentions;
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code));
        EXPECT_NE(std::string(error.what()).find(mentions), std::string::npos) << error.what();
    }
}

TEST(Blueprint, MassAndCentre) {
    const Blueprint plan = pair();
    EXPECT_EQ(plan.mass(), 4);
    EXPECT_EQ(plan.centreOfMass(), Vec2(1.5, 0));
    EXPECT_NO_THROW(plan.validate());
}

TEST(Blueprint, RefusesNonsenseAndNamesIt) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    Blueprint plan;
    expectRefused(plan, ErrorCode::degenerate, "no particles");
    plan = pair();
    plan.particles[1].mass = nan;
    expectRefused(plan, ErrorCode::notFinite, "particle 1: mass");
    plan = pair();
    plan.particles[0].mass = -1;
    expectRefused(plan, ErrorCode::outOfRange, "particle 0: mass");
    plan = pair();
    plan.particles[0].position[1] = infinite;
    expectRefused(plan, ErrorCode::notFinite, "particle 0: position");
    plan = pair();
    plan.joints[0].b = 2;
    expectRefused(plan, ErrorCode::badIndex, "joint 0");
    plan = pair();
    plan.joints[0].b = 0;
    expectRefused(plan, ErrorCode::degenerate, "itself");
    plan = pair();
    plan.joints[0].stiffness = nan;
    expectRefused(plan, ErrorCode::notFinite, "joint 0: stiffness");
    plan = pair();
    plan.joints[0].restLength = Real(0);
    expectRefused(plan, ErrorCode::degenerate, "rest length is 0");
    plan = pair();
    plan.material.kineticFriction = 2;
    expectRefused(plan, ErrorCode::outOfRange, "static friction");
    plan = pair();
    plan.joints[0].material = Material{.staticFriction = infinite};
    expectRefused(plan, ErrorCode::notFinite, "joint 0: static friction");
    plan = pair();
    plan.skin = Skin{"texture", {Vec2(0, 0)}, {}};
    expectRefused(plan, ErrorCode::badIndex, "texture coordinates");
    plan = pair();
    plan.skin = Skin{"texture", {Vec2(0, 0), Vec2(1, 0)}, {{0, 1, 2}}};
    expectRefused(plan, ErrorCode::badIndex, "triangle");
}

}  // namespace
}  // namespace sulfur
