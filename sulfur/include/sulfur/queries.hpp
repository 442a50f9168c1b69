/// \file
/// Questions about the geometry of a world.
#pragma once

#include <cstdint>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>

namespace sulfur {

/// Restricts a query to bodies whose filter has a category in `mask`.
struct QueryFilter {
    std::uint32_t mask = 0xffffffffu;  ///< bits of Filter::category
    BodyId ignore = {};                ///< a body that the query passes through; null: none
};

/// Where a ray met a surface.
struct RayHit {
    BodyId body = {};          ///< what was hit
    JointId joint = {};        ///< the capsule that was hit; null when a disc was
    ParticleId particle = {};  ///< the disc that was hit, or the capsule's nearer end
    Point point{0, 0};         ///< on the surface, metres
    Vec2 normal{0, 0};         ///< unit length, out of the surface; zero when the ray starts inside
    Real fraction = 0;         ///< of the way from start to end, 0..1
    Real along = 0;            ///< place along the hit capsule from its particle a (0) to b (1)
};

}  // namespace sulfur
