/// \file
/// What a world asks its caller in the middle of a tick.
///
/// Callbacks are called by the thread that calls World::step(), one at a time, in an order that is
/// the same whenever the same calls were made in the same order, whatever threads are lent. What
/// they answer decides how the world goes on: answers that follow from what they are told and from
/// the world alone keep it deterministic.
///
/// A callback may look at the world, but not change it. Places are those at which the step began (a
/// tick below 480 Hz has several, see Statistics::substeps), but that overlaps have been pushed
/// apart already when continuous collision asks; velocities may be those that forces have given.
/// Whatever changes the world throws Error{inCallback}, as do queries, hash(), snapshot(),
/// restore(), validate() and step().
///
/// When a callback throws, the tick goes on to its end as if there were no callbacks, and then
/// step() throws the same: the world is whole, and one tick further.
#pragma once

#include <functional>
#include <sulfur/ids.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>

namespace sulfur {

/// Whether two bodies collide; the first is the one with the smaller handle. See
/// World::setShouldCollide().
using ShouldCollide = std::function<bool(BodyId a, BodyId b)>;

/// A contact of two bodies before it is solved.
struct PreSolveContact {
    BodyId a = {};  ///< the body with the smaller handle
    BodyId b = {};  ///< the other
    /// Metres: where the corner or disc that is nearest to the other body has its surface, when the
    /// step begins; the middle between two points.
    Point point{0, 0};
    Vec2 normal{0, 0};  ///< unit length, from b towards a
    Real speed = 0;  ///< m/s at which they approach along the normal, the faster point; < 0: part
    Real gap = 0;    ///< metres between them when the step begins; < 0: so deep do they overlap
};

/// Whether a contact acts in this step, and how. `surface`, which may be changed, is how both
/// surfaces meet: their friction, their restitution, and the speed at which that of b carries a to
/// the right of the normal; rolling resistance is no part of it. See World::setPreSolve().
using PreSolve = std::function<bool(const PreSolveContact& contact, Material& surface)>;

}  // namespace sulfur
