/// \file
/// What a world asks its caller in the middle of a tick.
///
/// Callbacks are called by the thread that calls World::step(), one at a time, in an order that is
/// the same whenever the same calls were made in the same order, whatever threads are lent. What
/// they answer decides how the world goes on: answers that follow from what they are told and from
/// the world alone keep it deterministic.
///
/// A callback may look at the world, but not change it. Places are those at which the step began
/// (a tick below 480 Hz has several, see Statistics::substeps); velocities may already be those
/// that forces have given. Whatever changes the world throws Error{inCallback}, as do queries,
/// hash(), snapshot(), restore(), validate() and step().
///
/// When a callback throws, the tick goes on to its end as if there were no callbacks, and then
/// step() throws the same: the world is whole, and one tick further.
#pragma once

#include <functional>
#include <sulfur/ids.hpp>

namespace sulfur {

/// Whether two bodies collide; the first is the one with the smaller handle. See
/// World::setShouldCollide().
using ShouldCollide = std::function<bool(BodyId a, BodyId b)>;

}  // namespace sulfur
