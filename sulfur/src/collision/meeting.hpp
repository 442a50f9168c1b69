// Where a particle and a capsule meet: nearest points, now or at the time of impact.
#pragma once

#include <algorithm>
#include <cstdint>
#include <sulfur/math.hpp>

#include "collision/contact.hpp"
#include "collision/geometry.hpp"
#include "particles/particles.hpp"

namespace sulfur::detail {

/// A particle and a capsule, relative to the capsule's first end at the start of the tick.
struct Local {
    Vec2 p, b;        // the particle and the second end; the first end is the origin
    Vec2 dp, da, db;  // displacements of this tick

    /// As it will be when `fraction` of the displacements is done, still relative to the first end.
    Local at(Real fraction) const {
        return {p + fraction * (dp - da), b + fraction * (db - da), dp, da, db};
    }
};

/// Of particle `p` and the capsule from `a` to `b`.
inline Local localise(const Particles& particles, std::uint32_t p, std::uint32_t a,
                      std::uint32_t b) {
    const auto& x = particles.position;
    const auto& d = particles.displacement;
    const auto copy = [&](std::uint32_t i) { return Vec2(d[i][0], d[i][1]); };
    return {(x[p] - x[a]).cast<Real>(), (x[b] - x[a]).cast<Real>(), copy(p), copy(a), copy(b)};
}

/// Whether a place on an axis (0..1) is one of its ends.
inline bool isEnd(Real along) {
    return !(along > 0 && along < 1);
}

/// A first look at a particle and a capsule.
struct Look {
    Real along = 0;   // place on the axis that is nearest at the start of the tick
    Real travel = 0;  // m, by which the fastest part moves against the other
    bool far = true;  // this tick cannot bring them as near as was asked for
};

/// `near`: as near as they must come, in m. (meeting_lanes.hpp does the same for many.)
inline Look lookAt(const Local& l, Real near) {
    Look look;
    look.travel = std::max((l.dp - l.da).lpNorm<1>(), (l.dp - l.db).lpNorm<1>());
    look.along = nearestAlong<Vec2>(l.p, Vec2(0, 0), l.b);
    const Real reach = near + look.travel;
    look.far = (l.p - look.along * l.b).squaredNorm() > reach * reach;
    return look;
}

/// The nearest points of a particle and a capsule's axis.
struct Meeting {
    Real along = 0;      // place on the axis, 0..1
    Vec2 normal{0, 0};   // unit, from the axis to the particle
    Real distance = 0;   // m, along the normal
    bool atEnd = false;  // an end of the axis is nearest
    Real fraction = 0;   // of the tick at which they are so
};

/// Beside the axis: the normal is the axis' own, on the particle's side.
inline Meeting meetSide(const Local& l, Real along) {
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
inline Meeting meetEnd(const Local& l, Real along) {
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

/// For the positions at the start of the tick, where `along` is the nearest place on the axis.
inline Meeting meetAt(const Local& l, Real along) {
    return isEnd(along) ? meetEnd(l, along) : meetSide(l, along);
}

/// The same when that place is not known.
Meeting meet(const Local& local);

/// For the time in this tick at which the two come within `thickness`, if they do; otherwise for
/// the start of the tick. Conservative advancement (Mirtich 1996): no step is longer than the
/// distance that is left over the greatest speed at which it can shrink.
Meeting meetOnTheWay(const Local& local, Real thickness);

}  // namespace sulfur::detail
