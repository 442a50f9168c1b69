// What mechanisms are tested between.
#pragma once

#include "helpers.hpp"

namespace sulfur::test {

inline Body boxAt(World& world, Point at, Vec2 size = {1, Real(0.2)}, Real mass = 1) {
    return world.add(shapes::box({.size = size, .mass = mass}), {.position = at});
}
inline Body fixedAt(World& world, Point at) {
    return world.add({.kind = BodyKind::fixed, .particles = {{.position = at.cast<Real>()}}});
}

}  // namespace sulfur::test
