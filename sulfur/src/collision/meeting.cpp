#include "collision/meeting.hpp"

#include <algorithm>
#include <cmath>

#include "collision/geometry.hpp"

namespace sulfur::detail {

namespace {

/// Beside the axis: the normal is the axis' own, on the particle's side.
Meeting meetSide(const Local& l, Real along) {
    Meeting m;
    m.along = along;
    m.normal = Vec2(-l.b[1], l.b[0]) / l.b.norm();
    m.distance = m.normal.dot(l.p);
    if (m.distance < 0) {
        m.normal = -m.normal;
        m.distance = -m.distance;
    }
    return m;
}

/// At an end of the axis: the normal points from that end to the particle.
Meeting meetEnd(const Local& l, Real along) {
    Meeting m;
    m.along = along;
    m.atEnd = true;
    const Vec2 offset = l.p - along * l.b;
    m.distance = offset.norm();
    if (m.distance > 0)
        m.normal = offset / m.distance;
    else
        m.normal = l.b.norm() > 0 ? Vec2(Vec2(-l.b[1], l.b[0]).normalized()) : Vec2(0, 1);
    return m;
}

constexpr int mostAdvances = 24;
constexpr Real touching = Real(0.02);  // of the thickness: as near as the advancement must come

}  // namespace

Meeting meetAt(const Local& l, Real along) {
    return isEnd(along) ? meetEnd(l, along) : meetSide(l, along);
}

Meeting meet(const Local& l) {
    return meetAt(l, nearestAlong<Vec2>(l.p, Vec2(0, 0), l.b));
}

Meeting meetOnTheWay(const Local& l, Real thickness) {
    const Meeting start = meet(l);
    // All points of the axis move between its ends, and so does their speed towards the particle.
    const Real travel = std::max((l.dp - l.da).norm(), (l.dp - l.db).norm());
    Meeting now = start;
    Real fraction = 0;
    for (int i = 0; i < mostAdvances; ++i) {
        const Real left = now.distance - thickness;
        if (left <= touching * thickness) {
            now.fraction = fraction;
            return now;
        }
        if (travel <= 0) return start;
        fraction += left / travel;
        if (fraction >= 1) return start;
        now = meet(l.at(fraction));
    }
    // It creeps along the surface: as good as touching when it is that near.
    if (now.distance > Real(1.5) * thickness) return start;
    now.fraction = fraction;
    return now;
}

}  // namespace sulfur::detail
