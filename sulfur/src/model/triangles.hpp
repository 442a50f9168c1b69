// The triangles of soft bodies, which may be pressed flat but not turned over.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "model/clusters.hpp"

namespace sulfur::detail {

/// Three particles of a body that joints hold to each other.
struct Triangle {
    std::uint32_t a = none, b = none, c = none;  // dense indices, anticlockwise at rest
    Real rest = 0;                               // m^2, twice its area at rest
};

/// The triangles that something moves, in blocks of eight.
struct AwakeTriangles {
    // As the kernel sees them (AreaView): filled up to whole blocks.
    std::vector<std::uint32_t> a, b, c;
    std::vector<Real> rest;
    std::size_t count = 0;
    std::vector<std::uint32_t> held;  // of these, the ones with a corner in a rigid component
    std::vector<std::uint8_t> flat, pressed;  // a bit for each, a byte for each block

    std::size_t blocks() const { return flat.size(); }
    Triangle operator[](std::size_t i) const { return {a[i] / 2, b[i] / 2, c[i] / 2, rest[i]}; }

    void clear();
    void add(const Triangle& triangle, bool isHeld);
    /// After the last was added.
    void fillBlocks();
};

/// One that this tick would press too flat, or that is turned over already.
struct PressedTriangle {
    std::array<Grip, 3> corners;
    std::array<Real, 3> inverseMass;  // 1/kg, of corners that are particles alone
    bool held = false;                // a rigid component has one of its corners
    std::array<Vec2, 3> slopes;  // m, by which each corner widens it, as it was when the tick began
    Vec2 startB{0, 0}, startC{0, 0};  // m, from a to b and to c when the tick began
    Real rest = 0;                    // m^2, as above
    Real least = 0;                   // m^2, twice the area that it keeps in this tick
    Real response = 0;                // m^2/kg, to pushes along the slopes
    Real lambda = 0;                  // kg, what it pushes with
    /// When the tick ends it is led back: m^2, of twice its area, that are wanted of that. Slopes,
    /// response and lambda are then those of that.
    bool led = false;
    Real rise = 0;
};

/// Derived from joints and rigid components, and never archived.
struct Triangles {
    std::vector<Triangle> all;             // in the order of their bodies, asleep or not
    AwakeTriangles awake;                  // of these
    std::vector<PressedTriangle> pressed;  // in this tick
    bool anyHeld = false;                  // of those pressed
    std::uint32_t bodies = 0;              // so many, from the first on, have theirs in `all`
};

}  // namespace sulfur::detail
