// Where a particle and a capsule meet: nearest points, now or at the time of impact.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

#include "collision/contact.hpp"
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

inline Local localise(const Particles& particles, std::uint32_t p, const Collider& c) {
    const auto& x = particles.position;
    return {(x[p] - x[c.a]).cast<Real>(), (x[c.b] - x[c.a]).cast<Real>(), particles.displacement[p],
            particles.displacement[c.a], particles.displacement[c.b]};
}

/// Whether a place on an axis (0..1) is one of its ends.
inline bool isEnd(Real along) {
    return !(along > 0 && along < 1);
}

/// The nearest points of a particle and a capsule's axis.
struct Meeting {
    Real along = 0;      // place on the axis, 0..1
    Vec2 normal{0, 0};   // unit, from the axis to the particle
    Real distance = 0;   // m, along the normal
    bool atEnd = false;  // an end of the axis is nearest
    Real fraction = 0;   // of the tick at which they are so
};

/// For the positions at the start of the tick.
Meeting meet(const Local& local);

/// The same when the nearest place on the axis is known.
Meeting meetAt(const Local& local, Real along);

/// For the time in this tick at which the two come within `thickness`, if they do; otherwise for
/// the start of the tick. Conservative advancement (Mirtich 1996): no step is longer than the
/// distance that is left over the greatest speed at which it can shrink.
Meeting meetOnTheWay(const Local& local, Real thickness);

}  // namespace sulfur::detail
