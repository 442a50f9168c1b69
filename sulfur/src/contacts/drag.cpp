// Friction of the paper: a force of -mu v at each point that presses, instead of Coulomb's. It is
// added once, after the sweeps, which know no friction then.
#include <bit>

#include "contacts/stages.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

/// kg m, of a force that slows a slip (m in this step) down, by implicit Euler: so no drag is too
/// large. `mass`: what meets it, kg; `rate`: kg.
Real slowed(Real slip, Real rate, Real mass) {
    return mass > 0 ? -rate * slip / (1 + rate / mass) : Real(0);
}

Real alongTangent(const ManifoldBlock& r, std::uint32_t l, const Motion3& a, const Motion3& b) {
    return r.tangentX[l] * (b.x - a.x) + r.tangentY[l] * (b.y - a.y) + r.tangentArmB[l] * b.turn -
           r.tangentArmA[l] * a.turn;
}

Real alongTangent(const TouchBlock& t, std::uint32_t l, const Motion3& p, const Motion3& a,
                  const Motion3& b) {
    const Real tx = -t.normalY[l], ty = t.normalX[l];
    const Real rx = t.rod[l] * t.sideX[l], ry = t.rod[l] * t.sideY[l];
    return tx * p.x + ty * p.y + t.tangentArmP[l] * p.turn -
           ((t.weightA[l] * tx - rx) * a.x + (t.weightA[l] * ty - ry) * a.y +
            t.tangentArmA[l] * a.turn) -
           ((t.weightB[l] * tx + rx) * b.x + (t.weightB[l] * ty + ry) * b.y +
            t.tangentArmB[l] * b.turn);
}

/// Calls f(block, shape, lane) for each row that presses.
template <class Lists, class Kernel, class Function>
void forEachPressing(Lists& lists, Kernel&& kernel, Function&& f) {
    for (auto& list : lists)
        for (std::size_t k = 0; k < list.blocks.size(); ++k)
            for (auto set = kernel(list.blocks[k]); set != 0; set &= set - 1)
                f(list.blocks[k], list.shapes[k],
                  static_cast<std::uint32_t>(std::countr_zero(set)));
}

}  // namespace

void dragRows(State& state) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    const auto now = [&](std::uint32_t m) { return motionNow(movers, m); };
    forEachPressing(core.rows.manifolds, rowKernels().pressingManifolds,
                    [&](ManifoldBlock& r, const ManifoldShape& shape, std::uint32_t l) {
                        const Real points = static_cast<Real>((r.points[0].pressing[l] > 0) +
                                                              (r.points[1].pressing[l] > 0));
                        const Real rate = points * core.pairs[shape.pair[l]].drag * state.h;
                        const Real slip = alongTangent(r, l, now(r.a[l]), now(r.b[l])) - r.slip[l];
                        RowGraph::rubManifold(movers, r, l, slowed(slip, rate, r.tangentMass[l]));
                    });
    forEachPressing(core.rows.touches, rowKernels().pressingTouches,
                    [&](TouchBlock& t, const TouchShape& shape, std::uint32_t l) {
                        const Pair& pair = core.pairs[core.touches[shape.touch[l]].pair];
                        const Real slip =
                            alongTangent(t, l, now(t.p[l]), now(t.a[l]), now(t.b[l])) - t.slip[l];
                        const Real rubs = slowed(slip, pair.drag * state.h, t.tangentMass[l]);
                        RowGraph::pressTouch(movers, t, l, 0, rubs);
                    });
}

}  // namespace sulfur::detail
