// Whom a row pushes, one lane at a time.
#pragma once

#include <cstdint>

#include "model/contact_core.hpp"

namespace sulfur::detail {

/// Calls f(mover, impulse, its moment) for whom a row pushes; kg m and kg m^2.
template <class Function>
void forEachPush(const ManifoldBlock& r, std::uint32_t l, Function&& f) {
    Vec2 push = r.rubbing[l] * Vec2(r.tangentX[l], r.tangentY[l]);
    Real twistA = r.rubbing[l] * r.tangentArmA[l], twistB = r.rubbing[l] * r.tangentArmB[l];
    for (const ManifoldPoint& p : r.points) {
        push += p.pressing[l] * Vec2(p.normalX[l], p.normalY[l]);
        twistA += p.pressing[l] * p.normalArmA[l];
        twistB += p.pressing[l] * p.normalArmB[l];
    }
    f(r.a[l], Vec2(-push), -twistA);
    f(r.b[l], push, twistB);
}
template <class Function>
void forEachPush(const TouchBlock& t, std::uint32_t l, Function&& f) {
    const Real n = t.pressing[l], r = t.rubbing[l];
    if (n == 0 && r == 0) return;
    const Vec2 push(t.normalX[l] * n - t.normalY[l] * r, t.normalY[l] * n + t.normalX[l] * r);
    const Vec2 rod = (t.rod[l] * r + t.lean[l] * n) * Vec2(t.sideX[l], t.sideY[l]);
    f(t.p[l], push, t.normalArmP[l] * n + t.tangentArmP[l] * r);
    f(t.a[l], Vec2(rod - t.weightA[l] * push), -(t.normalArmA[l] * n + t.tangentArmA[l] * r));
    f(t.b[l], Vec2(-rod - t.weightB[l] * push), -(t.normalArmB[l] * n + t.tangentArmB[l] * r));
}

/// What a row presses, kg m.
inline Real pressingOf(const ManifoldBlock& r, std::uint32_t l) {
    return r.points[0].pressing[l] + r.points[1].pressing[l];
}
inline Real pressingOf(const TouchBlock& t, std::uint32_t l) {
    return t.pressing[l];
}

/// A row gives its bodies a share of what it gave.
inline void keepImpulses(ManifoldBlock& r, std::uint32_t l, Real share) {
    for (Real* impulse : {&r.rubbing[l], &r.points[0].pressing[l], &r.points[1].pressing[l]})
        *impulse *= share;
}
inline void keepImpulses(TouchBlock& t, std::uint32_t l, Real share) {
    t.rubbing[l] *= share;
    t.pressing[l] *= share;
}

/// Calls f(block, lane) for all rows of a body, given by its slot.
template <class Core, class Function>
void forEachRow(Core& core, std::uint32_t body, Function&& f) {
    const auto& first = core.shapes.firstChunk;  // of those that have a shape
    for (auto c = body < first.size() ? first[body] : none; c != none;
         c = core.shapes.chunks[c].nextOfBody)
        for (auto at = core.shapes.chunks[c].firstPair; at != none;) {
            const Pair& pair = core.pairs[at / 2];
            at = pair.next[at % 2];
            if (pair.row) f(core.rows.manifold(pair.row), RowGraph::laneOf(pair.row));
            for (auto i = pair.firstTouch; i != none; i = core.touches[i].next)
                if (const RowPlace row = core.touches[i].row)
                    f(core.rows.touch(row), RowGraph::laneOf(row));
        }
}

}  // namespace sulfur::detail
