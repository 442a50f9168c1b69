// Falling asleep and waking up, of one body and of what sleeps with it.
#pragma once

#include <Eigen/Geometry>

#include "model/state.hpp"

namespace sulfur::detail {

using BodyBounds = Eigen::AlignedBox<double, 2>;

/// Of all that a body touches with in the next `duration` seconds; joints between bodies and what
/// acts on it are left out.
BodyBounds boundsOf(const State& state, std::uint32_t body, double duration);
/// Makes a body take part again, with all that fell asleep with it or leans on it, or lets it rest,
/// at once.
void wakeBody(State& state, std::uint32_t body);
/// Wakes the sleepers that a body may have come to overlap: those whose bounding boxes meet its
/// own. Linear in the particles of the sleepers.
void wakeNear(State& state, std::uint32_t body);
void sleepBody(State& state, std::uint32_t body);
/// Joins the rings of two sleepers, so that they wake together.
void joinSleepers(State& state, std::uint32_t a, std::uint32_t b);

/// Gives the particles of a body the inverse masses that its kind, their masses and pins demand.
void restoreInverseMass(State& state, std::uint32_t body);

}  // namespace sulfur::detail
