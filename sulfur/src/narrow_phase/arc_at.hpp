// An arc at one moment: its circle, and what part of that it is.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/settings.hpp"
#include "narrow_phase/xy.hpp"

namespace sulfur::detail {

/// The circle of an arc's axis, seen from the middle of the arc: so no large numbers nearly cancel.
struct Circle {
    Xy top;           // m, the middle of the arc
    Xy outwards;      // unit, from the centre to there
    Real radius = 0;  // m

    /// `beyond`: what is a metre outwards from the middle.
    Circle(Xy middle, Xy beyond, Real size)
        : top(middle), outwards(1 / norm(beyond - middle) * (beyond - middle)), radius(size) {}

    /// m, by which a point is outside of it.
    Real out(Xy p) const {
        const Xy from = p - top;
        const Real more = 2 * radius * dot(from, outwards) + dot(from, from);
        return more / (std::sqrt(std::max<Real>(radius * radius + more, 0)) + radius);
    }
    /// Unit: from the centre to a point.
    Xy normalAt(Xy p) const {
        const Xy from = p - top + radius * outwards;
        return 1 / std::max(norm(from), Real(1e-30)) * from;
    }
};

/// The arc itself.
struct ArcAt : Circle {
    Xy a, b;             // m, its ends
    Real turns = 1;      // +1: the circle's outside is to the right of the way from a to b
    Real halfChord = 0;  // m

    ArcAt(const Circle& circle, Xy from, Xy to)
        : Circle(circle),
          a(from),
          b(to),
          turns(cross(outwards, to - from) > 0 ? Real(1) : Real(-1)),
          halfChord(norm(to - from) / 2) {
        const auto spokeTo = [&](Xy end) { return 1 / radius * (end - top) + outwards; };
        const Xy atA = spokeTo(a), atB = spokeTo(b);
        before_ = turns * Xy{atA.y, -atA.x};
        after_ = turns * Xy{-atB.y, atB.x};
    }

    /// m, by which a point is outside of the angle under which the centre sees the arc; not above 0
    /// within.
    Real beside(Xy p) const {
        return std::max(dot(p - a, before_), dot(p - b, after_)) -
               Real(tuned::beyondEnds) * 2 * halfChord;
    }
    /// m, to the axis.
    Real distance(Xy p) const {
        return beside(p) <= 0 ? std::abs(out(p)) : std::min(norm(p - a), norm(p - b));
    }
    /// Whether a point is between the arc and its chord.
    bool encloses(Xy p) const { return dot(p - a, outwards) > 0 && out(p) < 0; }

private:
    Xy before_, after_;  // unit: from a and b, on along the tangents
};

}  // namespace sulfur::detail
