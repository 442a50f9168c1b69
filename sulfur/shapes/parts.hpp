// What the ready-made shapes have in common: checks of their options, and joints.
#pragma once

#include <cstdint>
#include <sulfur/blueprint.hpp>
#include <sulfur/error.hpp>
#include <vector>

namespace sulfur::detail {

/// What the joints of a shape are made of.
struct Bracing {
    Real stiffness = infinite;  // N/m
    Real damping = 0;           // N s/m
    Real strength = infinite;   // N
};

inline void join(Blueprint& plan, std::uint32_t a, std::uint32_t b, Real radius,
                 const Bracing& bracing) {
    plan.joints.push_back({.a = a,
                           .b = b,
                           .stiffness = bracing.stiffness,
                           .damping = bracing.damping,
                           .radius = radius,
                           .strength = bracing.strength});
}

/// Adds particles at the outermost points of the round corners of an outline, whose corners are the
/// first particles, and ties each to its corner and to those beside it.
void addLobes(Blueprint& plan, const std::vector<Point>& lobes, const Bracing& bracing);

/// Throws unless both sides of an outer size leave room for capsules of this radius.
void requireOuterSize(Vec2 size, Real radius);

/// Says that capsules of this radius keep the particles too near to the middle.
[[noreturn]] void refuseThickness(const char* what, Real radius);

}  // namespace sulfur::detail
