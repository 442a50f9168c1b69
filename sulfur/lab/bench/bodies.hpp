// Bodies of any outline, as scenes describe them to every engine alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::lab::bench {

/// Everything that is at most `radius` from a convex core: one point makes a disc, two a capsule,
/// three to eight, counter-clockwise, a polygon. Metres.
struct Outline {
    std::vector<Point> points;
    double radius = 0;

    double area() const;  ///< m^2
    /// Mean square distance of the solid from the origin of its coordinates, m^2. Of a polygon
    /// without its radius.
    double gyration2() const;
};

Outline disc(double radius);
Outline capsule(const Point& a, const Point& b, double radius);
/// An upright rectangle about the origin.
Outline rectangle(const Point& half, double radius = 0);

/// Who moves a body.
enum class Mover : std::uint8_t {
    physics,
    nobody,
    motor,  ///< it turns about its origin with its spin, whatever is in its way
};

/// A body in its own frame, whose origin is its centre of mass. Its parts do not overlap, except
/// capsules that share an end. What physics moves is one disc, capsule or polygon, or a polygon cut
/// into several.
struct BodyPlan {
    std::vector<Outline> parts;
    std::vector<Point> contour = {};  ///< of a polygon cut into several: its corners, m
    std::vector<Point> sockets = {};  ///< where pins may hold a disc or polygon; their
                                      ///< middle is the origin, m
    Mover mover = Mover::physics;
    Point place{0, 0};       ///< m
    double angle = 0;        ///< rad
    Point velocity{0, 0};    ///< m/s, of what physics moves
    double spin = 0;         ///< rad/s, of what a motor turns
    double density = 1;      ///< kg/m^2
    double friction = 0.5;   ///< of its surface
    double restitution = 0;  ///< of its surface
    int group = 0;           ///< bodies of one group other than 0 do not touch each other
    bool asleep = false;     ///< whether it begins asleep, where an engine can do that

    double mass() const;     ///< kg
    double inertia() const;  ///< kg m^2 about the origin
};

/// Holds two sockets together; both bodies may turn about them.
struct PinPlan {
    std::size_t a = 0, socketA = 0;  ///< a body, by its number, and its socket
    std::size_t b = 0, socketB = 0;
};

/// Where a body is and how it moves.
struct Motion {
    Point place{0, 0};     ///< m, of its centre of mass
    double angle = 0;      ///< rad; 0 for what has none in its engine
    Point velocity{0, 0};  ///< m/s
    double spin = 0;       ///< rad/s

    bool finite() const;
    /// Where a point of the body is.
    Point at(const Point& local) const;
};

/// An outline at its place.
Outline placed(const Outline& outline, const Motion& motion);

/// How deep two outlines are in each other, m: the shortest way that parts them. Below 0 they are
/// apart, and the number is a lower bound of the distance, negated.
double overlapOf(const Outline& a, const Outline& b);

/// An outline of a body at its place.
struct Piece {
    Outline outline;
    std::size_t body = 0;
    int group = 0;
    bool moves = true;
};

/// The overlaps of all pairs that overlap and may touch, m.
std::vector<double> overlaps(const std::vector<Piece>& pieces);

}  // namespace sulfur::lab::bench
