#include "collision/meeting.hpp"

#include <algorithm>
#include <cmath>

#include "collision/geometry.hpp"

namespace sulfur::detail {

namespace {

constexpr int mostAdvances = 24;
constexpr Real touching = Real(0.02);  // of the thickness: as near as the advancement must come

}  // namespace

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
