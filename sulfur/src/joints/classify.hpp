// How joints are solved, and what they are to the particles at their ends.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// The inverse mass that a particle has while its body is awake, 0 if nothing moves it then.
Real inverseMassAwake(const State& state, std::uint32_t particle);

/// The part of a spring's load `x` that is a force. It leaves x without a kink and stays below
/// 2 softLimit, so that a spring goes over from explicit to implicit without anybody feeling where.
Real explicitLoad(Real x);

/// A network of springs and dampers that are forces is stable with NSV while h^2 K + 2 h B < 4,
/// where the highest eigenvalue is bounded by Gershgorin's circles: for each particle, the sums
/// over its joints of k (w_i + w_j) and b (w_i + w_j). The explicit parts never go beyond 3, of
/// which springs have up to 2.
struct JointLoad {
    Real stiffness = 0;  // h^2 K
    Real damping = 0;    // h B
};
struct Spring {
    Real stiffness = 0;  // N/m
    Real damping = 0;    // N s/m
};
inline Spring springOf(const Joints& joints, std::uint32_t j) {
    return {joints.stiffness[j], joints.damping[j]};
}

/// What a push on a particle moves (1/kg): a rigid component answers with its effective mass there,
/// in the direction in which it is least.
Real mobility(const State& state, std::uint32_t particle);
/// How much a spring counts at a particle. `isLink`: a rigid joint ends there.
Real weightOfSprings(const State& state, std::uint32_t particle, bool isLink);
/// Adds what a spring loads a particle with. `mobilities`: of both its ends together, 1/kg.
void addLoad(JointLoad& load, const Spring& spring, Real weight, Real mobilities, Real h);

/// How a joint is solved: what of it is a force, and its kind.
struct HowSolved {
    Real stiffness = 0;  // N/m
    Real damping = 0;    // N s/m
    JointKind kind = JointKind::explicitElastic;
};
/// Of the joint if it has this stiffness and damping, between particles of such loads.
HowSolved howSolved(const State& state, std::uint32_t joint, const Spring& spring,
                    const JointLoad& a, const JointLoad& b);

/// Derives how each joint is solved; the collision radius of particles, whose surface they show,
/// that of the thickest capsule that ends there, and how thin bodies are. Where bodies were added
/// to what was there `before`, and nothing else changed, only theirs.
void classifyJoints(State& state, const Counts& before);
/// Derives how angular joints are solved, after the others.
void classifyAngles(State& state, const Counts& before);
void updateReach(State& state, const Counts& before = {});

}  // namespace sulfur::detail
