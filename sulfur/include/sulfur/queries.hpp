/// \file
/// Questions about the geometry of a world.
///
/// Queries see every body where it is now, whoever moves it and whether it sleeps or not, also one
/// that was added since the last tick. They never change how the world goes on.
///
/// The solid of a body is the union of its capsules and discs; overlaps, closest points and
/// starting places of moved shapes also take what its closed outlines enclose. A body has a closed
/// outline where capsules that are sides of triangles of joints go round in a loop: crates, wheels,
/// jellies, walls and their pieces have one; ropes have none, nor has a ring of rods, which folds.
/// A fixed or kinematic body has one if joints without a radius brace it, as in all solid shapes,
/// or if its line of capsules goes round clockwise; a room, drawn counter-clockwise, has none.
///
/// Complexity: every query costs as much as the cells of the broad phase's grid that it covers,
/// each with what is in it, and never more than one look at every capsule. The first query after a
/// tick or a change also brings the grid up to date.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>

namespace sulfur {

/// Restricts a query to some bodies. All of its conditions must hold.
struct QueryFilter {
    std::uint32_t mask = 0xffffffffu;  ///< bits of Filter::category, of which a body needs one
    BodyId ignore = {};                ///< a body that the query passes through; null: none
    bool sensors = false;              ///< whether sensors are found too
    /// What else a body must be; empty: nothing. It may be asked more than once about a body and
    /// must not change the world.
    std::function<bool(BodyId)> accept = {};
};

/// Where something that moves along a straight way meets a surface.
struct CastHit {
    BodyId body = {};          ///< what is hit
    JointId joint = {};        ///< the capsule that is hit; null when a disc is
    ParticleId particle = {};  ///< the disc that is hit, or the capsule's nearer end
    Point point{0, 0};         ///< on the surface, metres
    Vec2 normal{0, 0};         ///< unit length, out of the surface; zero when the way starts inside
    double fraction = 0;       ///< of the way from start to end, 0..1
    Real along = 0;            ///< place along the hit capsule from its particle a (0) to b (1)
};

/// The place of a surface that is nearest to a point.
struct ClosestPoint {
    BodyId body = {};          ///< whose surface it is
    JointId joint = {};        ///< the capsule; null for a disc
    ParticleId particle = {};  ///< the disc, or the capsule's nearer end
    Point point{0, 0};         ///< on the surface, metres
    Vec2 normal{0, 0};         ///< unit length, out of the body
    double distance = 0;       ///< metres; negative inside of the body, 0 on its surface
    Real along = 0;            ///< place along the capsule from its particle a (0) to b (1)
};

/// A body that overlaps a region.
struct Overlap {
    BodyId body = {};          ///< which it is
    JointId joint = {};        ///< a capsule of it that does; null when a disc does, or none
    ParticleId particle = {};  ///< a disc that does, or an end of the capsule; null when its
                               ///< outline encloses the region without touching it
};

/// A convex shape: the convex hull of up to eight points, made thicker all round by a radius.
class QueryShape {
public:
    /// The most points that a shape may have.
    static constexpr std::size_t maxPoints = 8;

    /// A disc. Coordinates here and below are -1e7 to 1e7 m, radii 0 to 1e6 m; Error otherwise.
    static QueryShape circle(Point centre, double radius);
    /// What is within `radius` of the segment from `a` to `b`.
    static QueryShape capsule(Point a, Point b, double radius);
    /// A rectangle around `centre`, `size` metres wide and high (0 to 1e6), turned
    /// counter-clockwise by `angle` radians (-1e6 to 1e6).
    static QueryShape box(Point centre, Vec2 size, double angle = 0);
    /// The convex hull of 1 to 8 points, in any order, made thicker by `radius`.
    static QueryShape polygon(std::span<const Point> points, double radius = 0);

    /// The points, without those that only its radius reaches.
    std::span<const Point> points() const { return {points_.data(), count_}; }
    /// Metres.
    double radius() const { return radius_; }

private:
    QueryShape(std::span<const Point> points, double radius);

    std::array<Point, maxPoints> points_;
    std::size_t count_ = 0;
    double radius_ = 0;
};

}  // namespace sulfur
