// How far what the broad phase has drawn may go before it is drawn again, and how near to each
// other candidates must have been drawn.
//
// A collider is drawn with a skin s, so that two of thickness T together share a cell where they
// are no further apart than T + s + s'. It stays drawn while all of it is, at the start of a tick
// and as its displacements predict, within its leeway l of where it was drawn, and goes no further
// than a stride z in the tick. So what is T' apart at any moment of a tick was drawn no further
// apart than T' + l + l'; and in a tick two sides come nearer to each other by no more than
// sqrt 2 (z + z'), each coordinate for itself. What the narrow phase lets through is never further
// apart than the thickness, the gap g that is watched beside it, and that way: see lookAt(). (What
// goes further than T in a tick may touch within 3/2 T of the other, which is less.) All of that
// was drawn nearer than
//
//     T + g + (l + sqrt 2 z) + (l' + sqrt 2 z').
//
// With l = s - g/2 - sqrt 2 z that is T + s + s': the grid finds every candidate, and which
// contacts there are does not depend on when something was drawn.
#pragma once

#include "collision/broad_phase.hpp"
#include "kernels/outings.hpp"

namespace sulfur::detail {

// What is above, for what rests and for what each step adds.
static_assert(leastLeeway <= leastSkin - Real(0.125) - Real(1.4143) * leastStride);
static_assert(leewaySteps <= skinSteps - Real(1.4143) * strideSteps);

/// A skin, in m, as wide as what a surface with this step covers in three ticks, at least, and in
/// up to 17, if the rest is no more than a cell: so that not every tick something leaves its skin.
inline Real skinFor(const BroadPhase& broad, Real step) {
    return leastSkin * broad.baseSkin + skinSteps * step +
           std::min(moreSteps * step, static_cast<Real>(broad.cellSize));
}

/// How far, in m, what was drawn for a step may go from there; kernels/outings.ipp does the same.
inline Real leewayFor(const BroadPhase& broad, Real step) {
    return leastLeeway * broad.baseSkin + leewaySteps * step +
           std::min(moreSteps * step, static_cast<Real>(broad.cellSize));
}

/// How far, in m, it may go in one tick.
inline Real strideFor(const BroadPhase& broad, Real step) {
    return leastStride * broad.baseSkin + strideSteps * step;
}

/// The longest step for which an end of a collider was drawn; less than 0 for what is fixed.
inline Real stepOf(const BroadPhase& broad, const Collider& c) {
    return std::max(broad.step[c.a], broad.step[c.b]);
}

/// With how wide a skin a particle or a collider was drawn, at least, in m. What is fixed has half
/// of the widest gap that is watched.
inline Real skinOf(const BroadPhase& broad, Real step) {
    return step < 0 ? broad.baseSkin / 8 : skinFor(broad, step);
}
inline Real skinOf(const BroadPhase& broad, const Collider& c) {
    return skinOf(broad, stepOf(broad, c));
}

}  // namespace sulfur::detail
