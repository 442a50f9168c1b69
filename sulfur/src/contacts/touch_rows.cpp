#include "contacts/touch_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/clusters.hpp"
#include "model/contact_core.hpp"
#include "model/slow_speeds.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

/// How a mover goes in this step, by the state.
Motion3 motionOf(const State& state, std::uint32_t m) {
    const ContactCore& core = state.core;
    const auto i = core.denseOfMover[m];
    if (i == none) return {};
    if (core.moverIsCluster[m] != 0) {
        const Cluster& c = state.clusters.list[i];
        return {c.displacement[0], c.displacement[1], static_cast<Real>(c.angle)};
    }
    const Vec2& d = state.particles.displacement[i];
    return {d[0], d[1], 0};
}

std::uint32_t moverOfLeader(const State& state, std::uint32_t particle) {
    const auto slot = state.particles.id[particle].index - 1;
    const auto& movers = state.core.shapes.moverOfParticle;
    return slot < movers.size() ? movers[slot] : none;
}

}  // namespace

std::uint32_t moverOfCluster(const State& state, std::uint32_t cluster) {
    return moverOfLeader(state, state.clusters.members[state.clusters.list[cluster].first]);
}

std::uint32_t moverOfParticle(const State& state, std::uint32_t particle) {
    const auto cluster = state.particles.cluster[particle];
    return cluster == none ? moverOfLeader(state, particle) : moverOfCluster(state, cluster);
}

std::array<std::uint32_t, 3> particlesOfTouch(const State& state, std::uint32_t index) {
    const Shapes& shapes = state.core.shapes;
    const Touch& touch = state.core.touches[index];
    const Side& side = shapes.sides[touch.side];
    std::array<std::uint32_t, 3> particles{touch.corner, side.a, side.b};
    for (auto& i : particles) i = state.particleSlots.denseOf(shapes.corners[i].particle);
    return particles;
}

std::array<std::uint32_t, 3> moversOfTouch(const State& state, std::uint32_t index) {
    const RowPlace row = state.core.touches[index].row;
    const TouchBlock& t = state.core.rows.touch(row);
    const auto l = RowGraph::laneOf(row);
    return {t.p[l], t.a[l], t.b[l]};
}

Real pressingOf(const State& state, std::uint32_t index) {
    const RowPlace row = state.core.touches[index].row;
    return state.core.rows.touch(row).pressing[RowGraph::laneOf(row)];
}

TouchMasses changeMasses(State& state, std::uint32_t index, TouchMasses masses) {
    const RowPlace row = state.core.touches[index].row;
    TouchBlock& t = state.core.rows.touch(row);
    const auto l = RowGraph::laneOf(row);
    return {std::exchange(t.normalMass[l], masses.normal),
            std::exchange(t.tangentMass[l], masses.tangent)};
}

TouchView viewOfTouch(const State& state, std::uint32_t index) {
    const ContactCore& core = state.core;
    const Touch& touch = core.touches[index];
    const TouchBlock& t = core.rows.touch(touch.row);
    const auto l = RowGraph::laneOf(touch.row);
    TouchView view;
    view.particles = particlesOfTouch(state, index);
    view.movers = moversOfTouch(state, index);
    const Vec2 normal(t.normalX[l], t.normalY[l]), tangent(-t.normalY[l], t.normalX[l]);
    const Vec2 side(t.sideX[l], t.sideY[l]), lean = t.lean[l] * side, rod = t.rod[l] * side;
    view.normal = {{normal, -t.weightA[l] * normal + lean, -t.weightB[l] * normal - lean},
                   {t.normalArmP[l], -t.normalArmA[l], -t.normalArmB[l]},
                   t.mobility[l]};
    view.tangent = {{tangent, -t.weightA[l] * tangent + rod, -t.weightB[l] * tangent - rod},
                    {t.tangentArmP[l], -t.tangentArmA[l], -t.tangentArmB[l]},
                    t.tangentMass[l] > 0 ? 1 / t.tangentMass[l] : Real(0)};
    view.pressing = t.pressing[l];
    view.rubbing = t.rubbing[l];
    view.staticFriction = t.staticFriction[l];
    view.kineticFriction = t.kineticFriction[l];
    view.gapBefore = view.gap = t.gap[l];
    view.slop = t.slop[l];
    view.slide = -t.slip[l];
    for (std::size_t k = 0; k < 3; ++k) {
        const SolverBody& body = core.movers.bodies[view.movers[k]];
        const Motion3 way = motionOf(state, view.movers[k]);
        const auto along = [&](const TouchDirection& d, Real x, Real y, Real turn) {
            return d.ways[k].dot(Vec2(x, y)) + d.arms[k] * turn;
        };
        view.gapBefore += along(view.normal, body.x, body.y, body.turn);
        view.gap += along(view.normal, body.x + way.x, body.y + way.y, body.turn + way.turn);
        view.slide += along(view.tangent, way.x, way.y, way.turn);
    }
    return view;
}

void pressFromOutside(State& state, std::uint32_t index, Real pressing, Real rubbing,
                      const std::array<bool, 3>& have) {
    Movers& movers = state.core.movers;
    const Touch& touch = state.core.touches[index];
    TouchBlock& t = state.core.rows.touch(touch.row);
    const auto l = RowGraph::laneOf(touch.row);
    const std::array<std::uint32_t, 3> list = moversOfTouch(state, index);
    std::array<SolverBody, 3> before;
    for (std::size_t k = 0; k < 3; ++k) before[k] = movers.bodies[list[k]];
    RowGraph::pressTouch(movers, t, l, pressing, rubbing);
    const Real settled = slowSpeedsOf(state.settings).settledChange * state.h;
    const bool stirs = std::max(std::abs(pressing), std::abs(rubbing)) * t.mobility[l] > settled;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!have[k]) {
            if (stirs) state.core.stirred[list[k]] = state.core.sweep;
            continue;
        }
        const SolverBody& now = movers.bodies[list[k]];
        Motion3& given = movers.given[list[k]];
        given.x += now.vx - before[k].vx;
        given.y += now.vy - before[k].vy;
        given.turn += now.spin - before[k].spin;
    }
}

}  // namespace sulfur::detail
