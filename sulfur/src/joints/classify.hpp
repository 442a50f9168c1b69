// How joints are solved, and what they are to the particles at their ends.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// The inverse mass that a particle has while its body is awake, 0 if nothing moves it then.
Real inverseMassAwake(const State& state, std::uint32_t particle);

/// The part of a spring's load `x` that is a force. It leaves x without a kink and stays below
/// 2 softLimit, so that a spring goes over from explicit to implicit without anybody feeling where.
Real explicitLoad(Real x);

/// Derives how each joint is solved; the collision radius of particles, whose surface they show,
/// that of the thickest capsule that ends there, and how thin bodies are. Where bodies were added
/// to what was there `before`, and nothing else changed, only theirs.
void classifyJoints(State& state, const Counts& before);
/// Derives how angular joints are solved, after the others.
void classifyAngles(State& state, const Counts& before);
void updateReach(State& state, const Counts& before = {});

}  // namespace sulfur::detail
