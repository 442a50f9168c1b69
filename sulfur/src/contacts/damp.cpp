// What sticks to each other at two points moves as one, as far as rigid bodies go. Warm starting
// with few sweeps leaves long waves in piles, which nothing else would damp: the deviation from the
// motion as one decays. What stands on something that the rows cannot push moves with that;
// anything else keeps its momentum, also the angular one.
#include <algorithm>
#include <bit>
#include <cmath>

#include "contacts/stages.hpp"
#include "core/disjoint_sets.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/slow_speeds.hpp"
#include "model/state.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

using tuned::decayRate;
constexpr std::uint64_t interval = tuned::pileInterval;

/// Bodies that move as one.
struct Rigid {
    double mass = 0, inertia = 0;   // kg, kg m^2
    Point centre{0, 0}, way{0, 0};  // m; m in a step
    double turn = 0;                // rad in a step
    std::uint32_t stand = none;     // mover on which they stand, or none
    bool isTorn = false;            // they stand on several
    std::uint32_t bodies = 0;
};

/// What a body touches with a corner, and where that is: m along the side and away from it, from
/// the middle of the body.
struct Foothold {
    std::uint32_t on = none;
    Vec2 arm{0, 0};
};

class Damper {
public:
    explicit Damper(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          sticks_(slowSpeedsOf(state.settings).sticking * state.h),
          sets_(movers_.size(), &state.arena),
          stands_(movers_.size(), none, &state.arena),
          corners_(movers_.size(), Foothold{}, &state.arena),
          rigids_(&state.arena) {}

    void run() {
        linkManifolds();
        countTouches();
        sum();
        damp();
    }

private:
    bool isPushed(std::uint32_t m) const {
        const SolverBody& b = movers_.bodies[m];
        return b.inverseMass > 0 && b.inverseInertia > 0;
    }
    void stand(std::uint32_t m, std::uint32_t on) {
        // On the world or a fixed body nothing moves: all of them are one.
        const SolverBody& b = movers_.bodies[on];
        const Prediction& p = movers_.predictions[on];
        const bool rests = p.vx == 0 && p.vy == 0 && p.spin == 0 && b.vx == 0;
        const auto what = rests ? 0 : on;
        stands_[m] = stands_[m] == none || stands_[m] == what ? what : torn;
    }

    /// On two points. What rows push but do not turn is nothing to be damped to: it would give
    /// momentum that it does not lose.
    void standFlat(std::uint32_t m, std::uint32_t on) {
        if (movers_.bodies[on].inverseMass > 0)
            stands_[m] = torn;
        else
            stand(m, on);
    }

    /// A bit for each row that presses at two points and could hold more than it does.
    static std::uint32_t held(const ManifoldBlock& r) {
        std::uint32_t set = 0;
        for (std::size_t l = 0; l < rowLanes; ++l) {
            const Real one = r.points[0].pressing[l], other = r.points[1].pressing[l];
            const bool holds = std::abs(r.rubbing[l]) < r.staticFriction[l] * (one + other);
            const bool is = (one > 0) & (other > 0) & (r.slip[l] == 0) & holds;
            set |= (is ? 1u : 0u) << l;
        }
        return set;
    }

    void linkManifolds() {
        for (const auto c : core_.rows.inUse())
            for (const ManifoldBlock& r : core_.rows.manifolds[c].blocks)
                for (auto left = held(r); left != 0; left &= left - 1) {
                    const auto l = static_cast<std::size_t>(std::countr_zero(left));
                    const auto a = r.a[l], b = r.b[l];
                    const Motion3 va = motionNow(movers_, a), vb = motionNow(movers_, b);
                    const Real slides = r.tangentX[l] * (vb.x - va.x) +
                                        r.tangentY[l] * (vb.y - va.y) + r.tangentArmB[l] * vb.turn -
                                        r.tangentArmA[l] * va.turn;
                    if (std::abs(slides) > sticks_) continue;
                    if (isPushed(a) && isPushed(b))
                        sets_.unite(a, b);
                    else if (isPushed(a))
                        standFlat(a, b);
                    else if (isPushed(b))
                        standFlat(b, a);
                }
    }

    /// One corner of a body on a side that nothing pushes. A second one that is farther from it
    /// than a surface is thick makes it stand; pieces of a body may share a corner, which touches
    /// twice.
    void standOnCorner(std::uint32_t m, std::uint32_t on, bool cornerMoves, const TouchBlock& t,
                       const TouchShape& shape, std::size_t l) {
        const Vec2 arm = cornerMoves ? Vec2(t.normalArmP[l], t.tangentArmP[l])
                                     : Vec2(t.normalArmA[l], t.tangentArmA[l]);
        Foothold& first = corners_[m];
        if (first.on != on)
            first = {on, arm};
        else if ((arm - first.arm).norm() > 2 * shape.share[l] * shape.thickness[l])
            stand(m, on);
    }

    /// Two corners of a body on sides that nothing pushes.
    void countTouches() {
        for (const auto c : core_.rows.inUse()) {
            const TouchList& list = core_.rows.touches[c];
            for (std::size_t k = 0; k < list.blocks.size(); ++k) {
                const TouchBlock& t = list.blocks[k];
                const TouchShape& shape = list.shapes[k];
                for (std::size_t l = 0; l < rowLanes; ++l) {
                    if (!(t.pressing[l] > 0) || t.slip[l] != 0 || !(shape.sameBody[l] > 0))
                        continue;
                    if (!(std::abs(t.rubbing[l]) < t.staticFriction[l] * t.pressing[l])) continue;
                    const bool cornerMoves = isPushed(t.p[l]), sideMoves = isPushed(t.a[l]);
                    if (cornerMoves == sideMoves) continue;
                    const auto m = cornerMoves ? t.p[l] : t.a[l];
                    const auto on = cornerMoves ? t.a[l] : t.p[l];
                    const Motion3 vp = motionNow(movers_, t.p[l]), va = motionNow(movers_, t.a[l]);
                    const Real slides = -t.normalY[l] * (vp.x - va.x) +
                                        t.normalX[l] * (vp.y - va.y) + t.tangentArmP[l] * vp.turn -
                                        t.tangentArmA[l] * va.turn;
                    if (std::abs(slides) > sticks_) continue;
                    standOnCorner(m, on, cornerMoves, t, shape, l);
                }
            }
        }
    }

    Point placeOf(std::uint32_t m) const {
        const SolverBody& b = movers_.bodies[m];
        return movers_.placeAtReference(m) + Vec2(b.x, b.y).cast<double>();
    }

    void sum() {
        rigids_.assign(movers_.size(), {});
        for (const auto m : core_.awakeMovers) {
            if (!isPushed(m)) continue;
            const SolverBody& b = movers_.bodies[m];
            Rigid& r = rigids_[sets_.find(m)];
            const double mass = 1 / static_cast<double>(b.inverseMass);
            const Motion3 v = motionNow(movers_, m);
            r.mass += mass;
            r.centre += mass * placeOf(m);
            r.way += mass * Vec2(v.x, v.y).cast<double>();
            ++r.bodies;
            if (stands_[m] == none) continue;
            r.isTorn = r.isTorn || stands_[m] == torn || (r.stand != none && r.stand != stands_[m]);
            r.stand = stands_[m];
        }
        for (const auto m : core_.awakeMovers) {
            if (!isPushed(m)) continue;
            const SolverBody& b = movers_.bodies[m];
            Rigid& r = rigids_[sets_.find(m)];
            const double mass = 1 / static_cast<double>(b.inverseMass);
            const double inertia = 1 / static_cast<double>(b.inverseInertia);
            const Motion3 v = motionNow(movers_, m);
            const Point arm = placeOf(m) - r.centre / r.mass;
            r.inertia += inertia + mass * arm.squaredNorm();
            r.turn += inertia * static_cast<double>(v.turn) +
                      mass * cross(arm, Vec2(v.x, v.y).cast<double>());
        }
    }

    void damp() {
        // Implicit Euler.
        const double decay =
            decayRate * static_cast<double>(interval) * static_cast<double>(state_.h);
        const double share = decay / (1 + decay);
        for (std::size_t k = 0; k < core_.awakeMovers.size(); ++k) {
            const auto m = core_.awakeMovers[k];
            if (!isPushed(m)) continue;
            const Rigid& r = rigids_[sets_.find(m)];
            if (r.isTorn || (r.stand == none && r.bodies < 2)) continue;
            Point centre = r.centre / r.mass, way = r.way / r.mass;
            double turn = r.turn / r.inertia;
            if (r.stand != none) {
                const Motion3 v = motionNow(movers_, r.stand);
                centre = placeOf(r.stand);
                way = Vec2(v.x, v.y).cast<double>();
                turn = static_cast<double>(v.turn);
            }
            const Point arm = placeOf(m) - centre;
            const Point wanted = way + turn * Point(-arm[1], arm[0]);
            const Motion3 v = motionNow(movers_, m);
            const Vec2 change = (share * (wanted - Vec2(v.x, v.y).cast<double>())).cast<Real>();
            const Real spin = static_cast<Real>(share * (turn - static_cast<double>(v.turn)));
            movers_.predictions[m].vx += change[0];
            movers_.predictions[m].vy += change[1];
            movers_.predictions[m].spin += spin;
            Cluster& c = state_.clusters.list[core_.awakeDense[k]];
            c.displacement += change;
            c.angle += static_cast<double>(spin);
            updateTurn(c);
        }
    }

    static constexpr std::uint32_t torn = none - 1;

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    Real sticks_;  // m: what slides farther in a step does not stick
    DisjointSets sets_;
    std::pmr::vector<std::uint32_t> stands_;  // by mover: what it stands on, or none, or torn
    std::pmr::vector<Foothold> corners_;      // by mover
    std::pmr::vector<Rigid> rigids_;
};

}  // namespace

void dampSticking(State& state) {
    if (stepNumber(state) % interval != 0 || state.core.rows.empty()) return;
    Damper(state).run();
}

}  // namespace sulfur::detail
