// Ready-made blueprints with an outline around a middle: box, ball, blob, wheel.
#include <algorithm>
#include <sulfur/shapes.hpp>

#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/trigonometry.hpp"
#include "parts.hpp"
#include "solid.hpp"

namespace sulfur::shapes {

using detail::Bracing;
using detail::join;
using detail::requirePositive;
using detail::requireRange;

namespace {

/// How the mass of a box is shared where the corners and a core alone cannot carry it.
struct BoxShares {
    double corners = 0, ends = 0, core = 0;  // of all four, of both, of one; their sum is 1
};

constexpr double coreBesideEnds = 0.04;

/// Thick capsules leave the corners so near to the middle that even all of the mass in them has
/// too little inertia. Then the middle of the two short outer sides, where the capsules still
/// cover it, carries the rest: with the share q in the corners at the distance |half|,
///   q |half|^2 + (1 - q) (length / 2)^2 = gyration^2,
/// and q is at least a third, because gyration^2 <= length^2 / 6. Where the corners have a little
/// too much by themselves, and too little for a core alone, both do: the core has a steady share.
BoxShares boxShares(const detail::Solid& solid, double corner2, double end2) {
    const double gyration2 = solid.gyration2();
    const double corners = (end2 - gyration2) / (end2 - corner2);
    const double end = (1 - corners) / 2, corner = corners / 4;
    // Ends with less than that, no world takes.
    if (solid.mass * end >= detail::minMass && end * detail::maxMassRatio >= corner)
        return {corners, 1 - corners, 0};
    const double outside = 1 - coreBesideEnds;
    const double ends = (gyration2 - outside * corner2) / (end2 - corner2);
    return {outside - ends, ends, coreBesideEnds};
}

void joinToCorners(Blueprint& plan, const Point& place, double mass, const Bracing& bracing) {
    const auto index = static_cast<std::uint32_t>(plan.particles.size());
    plan.particles.push_back({.position = place.cast<Real>(), .mass = static_cast<Real>(mass)});
    for (std::uint32_t i = 0; i < 4; ++i) join(plan, i, index, 0, bracing);
}

void addOutriggers(Blueprint& plan, Vec2 size, const detail::Solid& solid, const Bracing& bracing) {
    const int axis = size.x() >= size.y() ? 0 : 1;
    const double arm = static_cast<double>(size[axis]) / 2;
    const BoxShares shares =
        boxShares(solid, plan.particles[0].position.cast<double>().squaredNorm(), arm * arm);
    for (auto& corner : plan.particles)
        corner.mass = static_cast<Real>(solid.mass * shares.corners / 4);
    for (const double sign : {-1.0, 1.0}) {
        Point place(0, 0);
        place[axis] = sign * arm;
        joinToCorners(plan, place, solid.mass * shares.ends / 2, bracing);
    }
    if (shares.core > 0) joinToCorners(plan, {0, 0}, solid.mass * shares.core, bracing);
}

void addCore(Blueprint& plan, const detail::Shares& shares, std::uint32_t outline,
             const Bracing& spokes) {
    for (std::size_t i = 0; i < shares.outline.size(); ++i)
        plan.particles[i].mass = shares.outline[i];
    const auto core = static_cast<std::uint32_t>(plan.particles.size());
    plan.particles.push_back({.position = shares.corePlace, .mass = shares.core});
    for (std::uint32_t i = 0; i < outline; ++i) join(plan, i, core, 0, spokes);
}

/// Gives the four corners of a box, and what else it needs, the mass and the inertia of a solid.
void addSolid(Blueprint& plan, const BoxOptions& options, const Bracing& bracing) {
    const Point half = options.size.cast<double>() / 2;
    std::vector<Point> inner, corners;
    for (const ParticleSpec& particle : plan.particles) {
        inner.emplace_back(particle.position.cast<double>());
        corners.emplace_back(half.cwiseProduct(inner.back().cwiseSign()));
    }
    const double radius = static_cast<double>(options.radius);
    const auto solid = options.rounded ? detail::solidRounded(corners, inner, radius, options.mass)
                                       : detail::solidRectangle(options.size, options.mass);
    const std::vector<double> even(4, 0.25);
    if (const auto shares = shareWithCore(solid, inner, even))
        return addCore(plan, *shares, 4, bracing);
    if (!options.rounded) return addOutriggers(plan, options.size, solid, bracing);
    const auto lobes = detail::lobesOf(corners, inner, radius);
    const auto shares = shareWithLobes(solid, inner, lobes, even);
    if (!shares) detail::refuseThickness("radius", options.radius);
    detail::addLobes(plan, lobes, bracing);
    addCore(plan, *shares, 4, bracing);
}

/// A ring of `count` particles joined by capsules, around a hub, with the inertia of a disc.
struct Ring {
    Real radius = 0;      // m, outer
    Real skinRadius = 0;  // m
    const char* skinName = "";
    Real mass = 0;
    std::uint32_t count = 0;
    Bracing rim = {}, spokes = {};
};

void addRing(Blueprint& plan, const Ring& ring) {
    const double radius = static_cast<double>(ring.radius) - static_cast<double>(ring.skinRadius);
    std::vector<Point> places;
    for (std::uint32_t i = 0; i < ring.count; ++i) {
        places.emplace_back(radius * detail::unitVector(detail::fullTurn * i / ring.count));
        plan.particles.push_back({.position = places.back().cast<Real>()});
    }
    const auto shares =
        shareWithCore(detail::solidDisc(ring.radius, ring.mass), places,
                      std::vector<double>(ring.count, 1 / static_cast<double>(ring.count)));
    if (!shares) detail::refuseThickness(ring.skinName, ring.skinRadius);
    for (std::uint32_t i = 0; i < ring.count; ++i)
        join(plan, i, (i + 1) % ring.count, ring.skinRadius, ring.rim);
    addCore(plan, *shares, ring.count, ring.spokes);
}

}  // namespace

Blueprint box(const BoxOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    requirePositive(static_cast<double>(options.mass), "mass");
    detail::requireOuterSize(options.size, options.radius);
    const Vec2 half = options.size / 2 - Vec2(options.radius, options.radius);
    const Bracing bracing{options.stiffness, options.damping, options.strength};
    Blueprint plan;
    plan.name = "box";
    plan.material = options.material;
    for (const Vec2& sign : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        plan.particles.push_back({.position = half.cwiseProduct(sign), .mass = options.mass / 4});
    for (std::uint32_t i = 0; i < 4; ++i) join(plan, i, (i + 1) % 4, options.radius, bracing);
    join(plan, 0, 2, 0, bracing);
    join(plan, 1, 3, 0, bracing);
    if (options.solidInertia) addSolid(plan, options, bracing);
    plan.validate();
    return plan;
}

Blueprint ball(const BallOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    Blueprint plan;
    plan.name = "ball";
    plan.material = options.material;
    plan.particles.push_back({.mass = options.mass, .radius = options.radius});
    plan.validate();
    return plan;
}

Blueprint blob(const BlobOptions& options) {
    requirePositive(static_cast<double>(options.skinRadius), "skin radius");
    requirePositive(static_cast<double>(options.mass), "mass");
    requireRange(static_cast<double>(options.radius), 2 * static_cast<double>(options.skinRadius),
                 1e6, "radius");
    requireRange(options.segments, 3, 1000, "segments");
    Blueprint plan;
    plan.name = "blob";
    plan.material = options.material;
    const auto count = static_cast<std::uint32_t>(options.segments);
    const Bracing bracing{options.stiffness, options.damping, infinite};
    addRing(plan, {options.radius, options.skinRadius, "skin radius", options.mass, count, bracing,
                   bracing});
    // Braces over one neighbour resist bending of the outline; with fewer than five segments
    // they would repeat the outline.
    if (count >= 5)
        for (std::uint32_t i = 0; i < count; ++i) join(plan, i, (i + 2) % count, 0, bracing);
    plan.validate();
    return plan;
}

Blueprint wheel(const WheelOptions& options) {
    requirePositive(static_cast<double>(options.rimRadius), "rim radius");
    requirePositive(static_cast<double>(options.mass), "mass");
    requireRange(static_cast<double>(options.radius), 2 * static_cast<double>(options.rimRadius),
                 1e6, "radius");
    requireRange(options.segments, 3, 1000, "segments");
    Blueprint plan;
    plan.name = "wheel";
    plan.material = options.material;
    addRing(plan, {options.radius,
                   options.rimRadius,
                   "rim radius",
                   options.mass,
                   static_cast<std::uint32_t>(options.segments),
                   {infinite, 0, options.strength},
                   {options.spokeStiffness, options.spokeDamping, options.strength}});
    plan.validate();
    return plan;
}

}  // namespace sulfur::shapes
