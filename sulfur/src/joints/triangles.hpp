// The triangles of soft bodies, which may be pressed flat but not turned over.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "rigid/clusters.hpp"

namespace sulfur::detail {

struct State;

/// Three particles of a body that joints hold to each other.
struct Triangle {
    std::uint32_t a = none, b = none, c = none;  // dense indices, anticlockwise at rest
    Real rest = 0;                               // m^2, twice its area at rest
    bool rigid = false;  // a rigid component has one of its corners; of those awake only
};

/// One that this tick would press too flat, or that is turned over already.
struct PressedTriangle {
    std::array<Grip, 3> corners;
    std::array<Vec2, 3> slopes;  // m, by which each corner widens it, as it was when the tick began
    Vec2 startB{0, 0}, startC{0, 0};  // m, from a to b and to c when the tick began
    Real rest = 0;                    // m^2, as above
    Real least = 0;                   // m^2, twice the area that it keeps in this tick
    Real lambda = 0;                  // kg, what it pushes with
};

/// Derived from joints and rigid components, and never archived.
struct Triangles {
    std::vector<Triangle> all;             // in the order of their bodies, asleep or not
    std::vector<Triangle> awake;           // of these, the ones that something moves
    std::vector<PressedTriangle> pressed;  // in this tick
    std::vector<std::uint8_t> isPressed;   // of those awake
    bool anyRigid = false;                 // of those pressed, with a corner in a rigid component
    std::uint32_t bodies = 0;              // so many, from the first on, have theirs in `all`
};

/// Finds the triangles of joints in dynamic bodies that have not been looked at, but for those that
/// are flat at rest, rigid, or part of a chain that moves alone. A body with more than four
/// triangles a joint is no lattice (everything hangs on everything there) and has none.
void findTriangles(State& state);

/// Derives which of them are awake.
void listTriangles(State& state);

}  // namespace sulfur::detail
