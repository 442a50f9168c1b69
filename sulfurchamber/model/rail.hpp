// Lines of joints along which a slider leads a body: ropes, hoops, wires, grounds.
#pragma once

#include <span>
#include <sulfur/world.hpp>
#include <vector>

namespace sulfurchamber {

/// A line of joints of one body, in their order.
struct RailLine {
    sulfur::BodyId body;
    std::vector<sulfur::JointId> links;
    sulfur::Point at{0, 0};  ///< its place that is nearest to where it was looked for, metres
    double length = 0;       ///< metres, now
};

/// The lines whose surface is within `reach` metres of a point, one of a body, the longest first.
/// From the nearest joint a line goes on both ways to where it ends, divides or closes. What has a
/// surface is led along that, not along braces inside.
std::vector<RailLine> railsAt(const sulfur::World& world, const sulfur::Point& point, double reach);

/// The line itself: the ends of its links, with chords of those that are bent.
std::vector<sulfur::Point> lineOf(const sulfur::World& world,
                                  std::span<const sulfur::JointId> links);

/// From a to b on the arc that turns by `bend`, radians: both ends and what chords need between.
std::vector<sulfur::Point> chordsOf(const sulfur::Point& a, const sulfur::Point& b, double bend);

}  // namespace sulfurchamber
