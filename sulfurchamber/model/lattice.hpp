// Outlines drawn by hand, and bodies that fill them.
#pragma once

#include <sulfur/blueprint.hpp>
#include <vector>

namespace sulfurchamber {

using Outline = std::vector<sulfur::Point>;

/// The same line with no more points than it takes to stay within `error` metres of it (Douglas and
/// Peucker 1973). A closed one keeps its first point.
Outline simplified(const Outline& outline, double error, bool closed);
/// Whether a closed outline crosses or touches itself.
bool meetsItself(const Outline& outline);
/// Square metres within a closed outline.
double areaWithin(const Outline& outline);

/// A soft body that fills a closed outline: particles along it and in a grid inside, about
/// `spacing` metres apart, joined by springs as triangles (Delaunay's triangulation), with capsules
/// along the outline. Its frame's origin is the outline's. Throws std::runtime_error when the
/// outline meets itself or has no room for a body. Holes, clockwise outlines inside of one that
/// runs anticlockwise, stay empty.
sulfur::Blueprint lattice(const Outline& outline, double spacing, double mass, double stiffness,
                          double damping, const std::vector<Outline>& holes = {});

}  // namespace sulfurchamber
