// The axis of a bent capsule: an arc of a circle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sulfur/math.hpp>

#include "core/bend.hpp"
#include "core/trigonometry.hpp"

namespace sulfur::detail {

/// An arc, up to half a circle.
struct Arc {
    Point a{0, 0}, b{0, 0};  // m, its ends
    Point centre{0, 0};      // m
    Point middle{1, 0};      // unit, from the centre to the middle of the arc
    double radius = 0;       // m
    double half = 0;         // rad, half of the angle by which it turns
    double turns = 1;        // +1: anticlockwise from a to b, -1: clockwise

    /// At a share of its length from a to b.
    Point at(double share) const {
        const Point u = unitVector(turns * (2 * share - 1) * half);
        return centre + radius * Point(middle[0] * u[0] - middle[1] * u[1],
                                       middle[1] * u[0] + middle[0] * u[1]);
    }
    /// Whether it has a point in a direction (unit) from its centre.
    bool reachesTo(const Point& direction) const {
        return direction.dot(middle) >= unitVector(half)[0];
    }
    Point top() const { return centre + radius * middle; }
    /// Where the tangents at both ends meet that in the middle: with the ends, these have all of
    /// the arc in their hull.
    std::array<Point, 2> hull() const {
        const Point along = turns * Point(-middle[1], middle[0]);
        const Point u = unitVector(half / 2);
        const double way = radius * u[1] / u[0];
        return {top() - way * along, top() + way * along};
    }
};

/// That turns by `bend`, leastBend to mostBend either way: anticlockwise where it is positive.
inline Arc arcBetween(const Point& a, const Point& b, double bend) {
    Arc arc;
    arc.a = a;
    arc.b = b;
    arc.half = std::min(std::abs(bend) / 2, fullTurn / 4);
    arc.turns = bend < 0 ? -1 : 1;
    const Point chord = b - a, u = unitVector(arc.half);
    const double length = chord.norm();
    arc.radius = length / (2 * u[1]);
    arc.middle = arc.turns * Point(chord[1], -chord[0]) / length;
    arc.centre = (a + b) / 2 - arc.radius * u[0] * arc.middle;
    return arc;
}

/// How far chords leave an arc at most, as a share of its capsule's radius; but there are never
/// more than so many. The interface promises both.
inline constexpr double chordsWithin = 0.01, mostChords = 256;

/// Calls f(from, to, share at from, share at to) for chords of an arc that leave it by at most
/// `within`, m.
template <class Function>
void forEachChord(const Arc& arc, double within, Function&& f) {
    // A chord of the angle t leaves a circle by r (1 - cos(t / 2)), nearly r t^2 / 8.
    const double angle = std::sqrt(8 * within / arc.radius);
    const int count =
        static_cast<int>(std::clamp(std::ceil(2 * arc.half / angle), 1.0, mostChords));
    Point from = arc.a;
    for (int k = 1; k <= count; ++k) {
        const Point to = k < count ? arc.at(static_cast<double>(k) / count) : arc.b;
        f(from, to, static_cast<double>(k - 1) / count, static_cast<double>(k) / count);
        from = to;
    }
}

}  // namespace sulfur::detail
