// Running bodies follow what becomes of their plans.
#pragma once

#include <sulfur/world.hpp>

namespace sulfurchamber {

/// Gives a running body what differs between two plans, the first of which it was made of. What can
/// be set is set, so that it goes on moving as it does; where that does not do (other particles or
/// joints, thickness, kind), another body takes its place, with its pose, its velocities as far as
/// the particles are the same, its joints to other bodies, its axles, whom it passes through, and
/// its user data. Returns the body that is there then. Throws sulfur::Error when `after` is
/// unusable; the world is then unchanged.
sulfur::BodyId follow(sulfur::World& world, sulfur::BodyId body, const sulfur::Blueprint& before,
                      const sulfur::Blueprint& after);

}  // namespace sulfurchamber
