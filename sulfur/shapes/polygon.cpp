// Ready-made blueprint: any simple polygon, convex or concave, rigid or soft.
#include <algorithm>
#include <cmath>
#include <set>
#include <sulfur/shapes.hpp>

#include "core/error_checks.hpp"
#include "outline.hpp"
#include "parts.hpp"
#include "solid.hpp"

namespace sulfur::shapes {

namespace {

using detail::Bracing;
using detail::join;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

std::vector<Point> checkedCorners(const PolygonOptions& options) {
    detail::requireRange(static_cast<double>(options.points.size()), 3, 200,
                         "the number of a polygon's points");
    std::vector<Point> corners;
    for (const auto& point : options.points) {
        detail::requireFinite(point, "point");
        corners.emplace_back(point.cast<double>());
    }
    if (const auto edges = detail::tangle(corners)) {
        const auto name = [](std::size_t i) { return std::to_string(i); };
        throw Error(ErrorCode::degenerate,
                    (*edges)[0] == (*edges)[1]
                        ? "the polygon has no extent at the edge from point " + name((*edges)[0]) +
                              "; allowed are points that differ and edges that do not fold back"
                        : "the polygon's edges from point " + name((*edges)[0]) +
                              " and from point " + name((*edges)[1]) +
                              " touch; allowed is an outline that meets itself nowhere");
    }
    return corners;
}

/// Weights of the outline's particles that keep the polygon's own centre of mass. The symmetric
/// choice is half of the two triangles beside a corner whose third corner is the centre; where
/// the polygon is not seen from its centre, that may not be positive, but a third of each triangle
/// of a triangulation is.
std::vector<double> outlineWeights(const std::vector<Point>& corners, const Triangles& triangles) {
    const std::size_t count = corners.size();
    const double area = detail::twiceArea(corners);
    const Point centre = detail::solidPolygon(corners, 1).centre;
    std::vector<double> weights(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const double fan = cross(Point(corners[i] - centre), Point(corners[next] - centre)) / area;
        weights[i] += fan / 2;
        weights[next] += fan / 2;
    }
    const double least = 0.1 / static_cast<double>(count);
    if (std::all_of(weights.begin(), weights.end(), [&](double w) { return w > least; }))
        return weights;
    std::fill(weights.begin(), weights.end(), 0.0);
    for (const auto& [a, b, c] : triangles) {
        const double third =
            std::abs(cross(Point(corners[b] - corners[a]), Point(corners[c] - corners[a])) / area) /
            3;
        for (const auto i : {a, b, c}) weights[i] += third;
    }
    return weights;
}

/// The sides of the triangles that are not edges of the outline: with the edges they make the
/// outline rigid, each triangle adding one particle and two joints.
void addDiagonals(Blueprint& plan, const Triangles& triangles, std::uint32_t count,
                  const Bracing& bracing) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> diagonals;
    for (const auto& [a, b, c] : triangles) {
        for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
            const auto [low, high] = std::minmax(p, q);
            if (high != low + 1 && !(low == 0 && high == count - 1)) diagonals.emplace(low, high);
        }
    }
    for (const auto& [a, b] : diagonals) join(plan, a, b, 0, bracing);
}

/// The core is joined to every corner but one that it lies on.
void addCore(Blueprint& plan, const detail::Shares& shares, std::uint32_t count,
             const Bracing& bracing) {
    const Real size = (plan.particles[1].position - plan.particles[0].position).norm();
    const auto core = static_cast<std::uint32_t>(plan.particles.size());
    for (std::size_t i = 0; i < shares.outline.size(); ++i)
        plan.particles[i].mass = shares.outline[i];
    plan.particles.push_back({.position = shares.corePlace, .mass = shares.core});
    for (std::uint32_t i = 0; i < count; ++i)
        if ((plan.particles[i].position - shares.corePlace).norm() > size / 1000)
            join(plan, i, core, 0, bracing);
}

/// A long arc at a sharp corner may pass an edge that ends at a corner bent inwards.
void requireArcsOnEdges(const std::vector<Point>& outer, const std::vector<Point>& inner,
                        Real radius) {
    const std::size_t count = outer.size();
    const double square = static_cast<double>(radius) * static_cast<double>(radius);
    for (std::size_t i = 0; i < count; ++i) {
        const double reach2 = (outer[i] - inner[i]).squaredNorm() - square;
        for (const auto end : {(i + 1) % count, (i + count - 1) % count})
            if ((outer[end] - outer[i]).squaredNorm() < reach2)
                throw Error(ErrorCode::outOfRange,
                            "radius is " + std::to_string(radius) + ", too large to round point " +
                                std::to_string(i) + "; allowed are arcs that end on its edges");
    }
}

}  // namespace

Blueprint polygon(const PolygonOptions& options) {
    detail::requirePositive(static_cast<double>(options.radius), "radius");
    detail::requirePositive(static_cast<double>(options.mass), "mass");
    const auto outer = checkedCorners(options);
    auto corners = detail::inset(outer, static_cast<double>(options.radius));
    if (!corners)
        throw Error(ErrorCode::outOfRange,
                    "radius is " + std::to_string(options.radius) +
                        ", too thick for the polygon's narrowest place; allowed is less than half "
                        "its width there");
    Blueprint plan;
    plan.name = "polygon";
    plan.material = options.material;
    for (auto& corner : *corners) {
        plan.particles.push_back({.position = corner.cast<Real>()});
        corner = plan.particles.back().position.cast<double>();
    }
    const auto count = static_cast<std::uint32_t>(corners->size());
    const auto triangles = detail::triangulate(*corners);
    const double radius = static_cast<double>(options.radius);
    if (options.rounded) requireArcsOnEdges(outer, *corners, options.radius);
    const auto solid = options.rounded ? detail::solidRounded(outer, *corners, radius, options.mass)
                                       : detail::solidPolygon(outer, options.mass);
    const auto weights = outlineWeights(*corners, triangles);
    auto shares = shareWithCore(solid, *corners, weights);
    std::vector<Point> lobes;
    if (!shares && options.rounded) {
        lobes = detail::lobesOf(outer, *corners, radius);
        shares = shareWithLobes(solid, *corners, lobes, weights);
    }
    if (!shares) detail::refuseThickness("radius", options.radius);
    const Bracing bracing{options.stiffness, options.damping, options.strength};
    for (std::uint32_t i = 0; i < count; ++i)
        join(plan, i, (i + 1) % count, options.radius, bracing);
    addDiagonals(plan, triangles, count, bracing);
    if (!lobes.empty()) detail::addLobes(plan, lobes, bracing);
    addCore(plan, *shares, count, bracing);
    plan.validate();
    return plan;
}

}  // namespace sulfur::shapes
