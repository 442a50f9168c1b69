// Rolling resistance: a couple that acts against how two bodies that press on each other turn
// against each other, at most c R N, with the coefficient c, the force N of the contact and the
// effective radius R of both (1/R = 1/R1 + 1/R2; Ai et al. 2011, "Assessment of rolling resistance
// models in discrete element simulations", model A; for a disc on flat ground it is the rolling
// resistance coefficient of engineering, F = c N).
//
// It acts before motion is predicted, beside gravity and other forces, with the impulses that rows
// had in the last step. So friction, which is solved later, meets it as any other torque.
#include <algorithm>
#include <cmath>

#include "contacts/stages.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"
#include "rigid/cluster_motion.hpp"

namespace sulfur::detail {

namespace {

/// How a mover goes in this step if rows give what they gave in the last one, m and rad.
struct Going {
    double x = 0, y = 0, turn = 0;
};

/// The particle that a mover is, or the first of its rigid component; none where it never moves, or
/// is no more. Lists of what is awake may be of the step before.
std::uint32_t leaderOf(const State& state, std::uint32_t m) {
    const auto slot = state.core.movers.particle[m];
    const auto i = slot == none ? none : state.particleSlots.denseOf(slot);
    return i != none && state.awake(state.particles.body[i]) ? i : none;
}

/// Its rigid component, or null.
const Cluster* clusterOf(const State& state, std::uint32_t m) {
    const auto i = leaderOf(state, m);
    const auto c = i == none ? none : state.particles.cluster[i];
    return c == none ? nullptr : &state.clusters.list[c];
}

Going goingOf(const State& state, std::uint32_t m) {
    const auto i = leaderOf(state, m);
    if (i == none) return {};
    const SolverBody& rows = state.core.movers.bodies[m];
    const double h = static_cast<double>(state.h);
    const Cluster* c = clusterOf(state, m);
    const ClusterLoad load = c ? loadOf(state, *c) : ClusterLoad{};
    const Point velocity = c ? c->velocity : state.particles.velocity[i];
    return {static_cast<double>(rows.vx) + h * (velocity[0] + h * load.acceleration[0]),
            static_cast<double>(rows.vy) + h * (velocity[1] + h * load.acceleration[1]),
            static_cast<double>(rows.spin) + (c ? h * (c->spin + h * load.turning) : 0)};
}

/// A contact as what rolls sees it: b rolls on a, and friction acts on both along one tangent.
struct Rolling {
    std::uint32_t a = 0, b = 0;        // movers
    double armA = 0, armB = 0;         // m, levers of the tangent about their centres
    double slip = 0, turn = 0;         // m and rad in this step, of b against a
    double pressing = 0, rubbing = 0;  // kg m, of the last step
    double staticFriction = 0, coefficient = 0;
    double mobility = 0;                // 1/kg, of the slip
    double inertiaA = 0, inertiaB = 0;  // 1/(kg m^2), inverse
};

double inverseInertiaOf(const State& state, std::uint32_t m) {
    const Cluster* c = clusterOf(state, m);
    return c ? static_cast<double>(c->inverseInertia) : 0;
}

/// kg m^2, what the contact can give. What cannot turn counts as flat.
double mostOf(const Rolling& r) {
    const double curved =
        (r.inertiaA > 0 ? 1 / std::abs(r.armA) : 0) + (r.inertiaB > 0 ? 1 / std::abs(r.armB) : 0);
    return std::isfinite(curved) ? r.coefficient * r.pressing / curved : 0;
}

/// kg m^2, on b and against a, that ends how both turn against each other: together with their slip
/// where friction can hold that, else alone.
double coupleOf(const Rolling& r) {
    const double most = mostOf(r), both = r.inertiaA + r.inertiaB;
    const double coupling = r.armA * r.inertiaA + r.armB * r.inertiaB;
    const double left = both - coupling * coupling / r.mobility;
    const double alone = std::clamp(-r.turn / both, -most, most);
    if (!(left > 0)) return alone;
    const double held = std::clamp(-(r.turn - coupling / r.mobility * r.slip) / left, -most, most);
    const double friction = r.rubbing - (r.slip + coupling * held) / r.mobility;
    return std::abs(friction) <= r.staticFriction * r.pressing ? held : alone;
}

void turn(State& state, std::uint32_t m, double couple) {
    const auto i = leaderOf(state, m);
    if (i == none || state.particles.cluster[i] == none) return;
    Cluster& c = state.clusters.list[state.particles.cluster[i]];
    c.spin += couple * static_cast<double>(c.inverseInertia) / static_cast<double>(state.h);
}

/// `mass`: kg, effective, of the slip.
void resist(State& state, Rolling& r, double mass) {
    r.inertiaA = inverseInertiaOf(state, r.a);
    r.inertiaB = inverseInertiaOf(state, r.b);
    if (!(r.inertiaA + r.inertiaB > 0) || !(mass > 0)) return;
    r.mobility = 1 / mass;
    const double couple = coupleOf(r);
    turn(state, r.b, couple);
    turn(state, r.a, -couple);
}

void resist(State& state, const ManifoldBlock& block, const ManifoldShape& shape, std::uint32_t l) {
    const double pressing = static_cast<double>(block.points[0].pressing[l]) +
                            static_cast<double>(block.points[1].pressing[l]);
    if (!(pressing > 0)) return;
    const Going a = goingOf(state, block.a[l]), b = goingOf(state, block.b[l]);
    Rolling r{block.a[l], block.b[l], static_cast<double>(block.tangentArmA[l]),
              static_cast<double>(block.tangentArmB[l])};
    r.slip = static_cast<double>(block.tangentX[l]) * (b.x - a.x) +
             static_cast<double>(block.tangentY[l]) * (b.y - a.y) + r.armB * b.turn -
             r.armA * a.turn - static_cast<double>(block.slip[l]);
    r.turn = b.turn - a.turn;
    r.pressing = pressing;
    r.rubbing = static_cast<double>(block.rubbing[l]);
    r.staticFriction = static_cast<double>(block.staticFriction[l]);
    r.coefficient = static_cast<double>(shape.rolling[l]);
    resist(state, r, static_cast<double>(block.tangentMass[l]));
}

/// Sides of what is soft roll nobody: only where one mover has both ends is there a turn.
void resist(State& state, const TouchBlock& t, const TouchShape& shape, std::uint32_t l) {
    const auto& bodies = state.core.movers.bodies;
    const bool isSoft = shape.sameBody[l] == 0 &&
                        (bodies[t.a[l]].inverseMass > 0 || bodies[t.b[l]].inverseMass > 0);
    const double pressing = static_cast<double>(t.pressing[l]);
    if (isSoft || !(pressing > 0)) return;
    const Going p = goingOf(state, t.p[l]), a = goingOf(state, t.a[l]), b = goingOf(state, t.b[l]);
    Rolling r{t.a[l], t.p[l], static_cast<double>(t.tangentArmA[l]),
              static_cast<double>(t.tangentArmP[l])};
    const double tx = -static_cast<double>(t.normalY[l]), ty = static_cast<double>(t.normalX[l]);
    const double rod = static_cast<double>(t.rod[l]);
    const double rx = rod * static_cast<double>(t.sideX[l]),
                 ry = rod * static_cast<double>(t.sideY[l]);
    const double wa = static_cast<double>(t.weightA[l]), wb = static_cast<double>(t.weightB[l]);
    r.slip = tx * p.x + ty * p.y + r.armB * p.turn -
             ((wa * tx - rx) * a.x + (wa * ty - ry) * a.y + r.armA * a.turn) -
             ((wb * tx + rx) * b.x + (wb * ty + ry) * b.y +
              static_cast<double>(t.tangentArmB[l]) * b.turn) -
             static_cast<double>(t.slip[l]);
    r.turn = p.turn - a.turn;
    r.pressing = pressing;
    r.rubbing = static_cast<double>(t.rubbing[l]);
    r.staticFriction = static_cast<double>(t.staticFriction[l]);
    r.coefficient = static_cast<double>(shape.rolling[l]);
    resist(state, r, static_cast<double>(t.tangentMass[l]));
}

template <class List>
void resistAll(State& state, const List& list) {
    for (std::size_t k = 0; k < list.blocks.size(); ++k)
        for (std::uint32_t lane = 0; lane < rowLanes; ++lane)
            if (list.shapes[k].rolling[lane] > 0)
                resist(state, list.blocks[k], list.shapes[k], lane);
}

}  // namespace

void resistRolling(State& state) {
    const ContactCore& core = state.core;
    if (core.rollingSurfaces == 0) return;
    for (const auto c : core.rows.inUse()) {
        resistAll(state, core.rows.manifolds[c]);
        resistAll(state, core.rows.touches[c]);
    }
}

}  // namespace sulfur::detail
