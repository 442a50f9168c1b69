// Loads of stacks that begin to rest, as an accelerator: rows begin with what statics asks of them,
// instead of what the sweeps of a hundred steps would find. Everything works without it.
//
// Rigid components are visited from the top down. Each hands its weight, and what has been laid on
// it, to the points on which it stands: of all impulses that hold force and torque, those with the
// least sum of squares. Done in every step, this would stir what the sweeps have settled; it is
// done when many of the rows that bear are new, and once more after the first step of a body, in
// which half its weight acts.
#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "contacts/stages.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

/// A point on which the upper of two bodies stands.
struct Stand {
    std::uint32_t upper = 0, lower = 0;  // movers
    RowPlace row;
    int point = 0;
    Real up = 0;                    // share of the impulse that holds weight
    Real ofUpper = 0, ofLower = 0;  // m, levers of what pushes the upper one up, the lower one down
};

/// What one body bears and has to hand on.
struct Load {
    double height = 0;             // m, along gravity
    double force = 0, torque = 0;  // kg m, kg m^2
};

class Loader {
public:
    explicit Loader(State& state)
        : state_(state),
          core_(state.core),
          movers_(core_.movers),
          stands_(&state.arena),
          loads_(&state.arena),
          order_(&state.arena) {
        const Vec2 g = state.settings.gravity;
        weight_ = static_cast<double>(g.norm() * state.h * state.h);
        if (weight_ > 0) up_ = -g / g.norm();
    }

    void run() {
        const bool again = std::exchange(core_.loadsAgain, 0) != 0;
        if (weight_ == 0) return;
        measureHeights();
        findStands();
        if (!again && (bearing_ == 0 || tuned::newShare * new_ < bearing_)) return;
        core_.loadsAgain = again || state_.young.empty() ? 0 : 1;
        handDown();
    }

private:
    void measureHeights() {
        loads_.assign(movers_.size(), {});
        std::pmr::vector<bool> isYoung(state_.clusters.list.size(), false, &state_.arena);
        for (const auto i : state_.young)
            if (const auto c = state_.particles.cluster[i]; c != none) isYoung[c] = true;
        for (std::size_t k = 0; k < core_.awakeMovers.size(); ++k) {
            const auto m = core_.awakeMovers[k];
            const SolverBody& b = movers_.bodies[m];
            const Point at = movers_.placeAtReference(m) + Vec2(b.x, b.y).cast<double>();
            loads_[m].height = at.dot(up_.cast<double>());
            if (b.inverseMass > 0 && b.inverseInertia > 0) {
                const bool half = core_.awakeIsCluster[k] != 0 && isYoung[core_.awakeDense[k]];
                loads_[m].force = (half ? 0.5 : 1) * weight_ / static_cast<double>(b.inverseMass);
                // What is lighter than nothing bears nothing.
                loads_[m].force *= std::max(0.0, static_cast<double>(gravityScaleOf(state_, m)));
                order_.push_back(m);
            }
        }
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(loads_[b].height, a) < std::pair(loads_[a].height, b);
        });
    }

    void findStands() {
        for (const auto c : core_.rows.inUse()) {
            const ManifoldList& list = core_.rows.manifolds[c];
            for (std::uint32_t index = 0; index < list.rows; ++index) addStands({c, index});
        }
        std::sort(stands_.begin(), stands_.end(), [](const Stand& a, const Stand& b) {
            return std::tie(a.upper, a.row.colour, a.row.index, a.point) <
                   std::tie(b.upper, b.row.colour, b.row.index, b.point);
        });
    }

    /// A row bears where its points press in this step without coming down fast, and its normals
    /// are steep enough for friction to matter little.
    void addStands(RowPlace place) {
        const ManifoldBlock& r = core_.rows.manifold(place);
        const auto l = RowGraph::laneOf(place);
        const auto a = r.a[l], b = r.b[l];
        const SolverBody &p = movers_.bodies[a], &q = movers_.bodies[b];
        const Motion3 va = motionNow(movers_, a), vb = motionNow(movers_, b);
        bool bears = false, isNew = true;
        for (int k = 0; k < 2; ++k) {
            const ManifoldPoint& point = r.points[k];
            if (!(point.normalMass[l] > 0)) continue;
            const Vec2 n(point.normalX[l], point.normalY[l]);
            const Real armA = point.normalArmA[l], armB = point.normalArmB[l];
            const Real gap =
                point.gap[l] + n.dot(Vec2(q.x - p.x, q.y - p.y)) + armB * q.turn - armA * p.turn;
            const Real closing =
                n.dot(Vec2(vb.x - va.x, vb.y - va.y)) + armB * vb.turn - armA * va.turn;
            const Real up = n.dot(up_), steepest = Real(tuned::steep);
            const Real slow = 2 * static_cast<Real>(weight_);
            if (std::abs(up) < steepest || gap > slow || std::abs(closing) > slow) continue;
            const bool aStands = up < 0;
            const auto upper = aStands ? a : b, lower = aStands ? b : a;
            if (movers_.bodies[upper].inverseInertia == 0) continue;
            const bool lowerMoves = movers_.bodies[lower].inverseMass > 0;
            if (lowerMoves && !(loads_[lower].height < loads_[upper].height)) continue;
            stands_.push_back({upper, lower, place, k, std::abs(up), aStands ? -armA : armB,
                               aStands ? armB : -armA});
            bears = true;
            isNew = isNew && point.pressing[l] == 0;
        }
        bearing_ += bears ? 1 : 0;
        new_ += bears && isNew ? 1 : 0;
    }

    void handDown() {
        for (const auto m : order_) {
            const auto first = std::lower_bound(
                stands_.begin(), stands_.end(), m,
                [](const Stand& s, std::uint32_t upper) { return s.upper < upper; });
            auto last = first;
            while (last != stands_.end() && last->upper == m) ++last;
            if (first != last) handOver(loads_[m], {first, last});
        }
    }

    /// Impulses alpha up + beta lever of the points hold force and torque with the least sum of
    /// squares. What would have to pull holds nothing, and the others share its part.
    void handOver(const Load& load, std::span<const Stand> stands) {
        double uu = 0, ut = 0, tt = 0;
        for (const Stand& s : stands) {
            const double u = static_cast<double>(s.up), t = static_cast<double>(s.ofUpper);
            uu += u * u;
            ut += u * t;
            tt += t * t;
        }
        const double determinant = uu * tt - ut * ut;
        const bool canTurn = determinant > 1e-6 * uu * tt;
        const double alpha =
            canTurn ? (load.force * tt + load.torque * ut) / determinant : load.force / uu;
        const double beta = canTurn ? (-load.torque * uu - load.force * ut) / determinant : 0;
        const auto share = [&](const Stand& s) {
            return std::max(
                alpha * static_cast<double>(s.up) + beta * static_cast<double>(s.ofUpper), 0.0);
        };
        double held = 0;
        for (const Stand& s : stands) held += share(s) * static_cast<double>(s.up);
        if (!(held > 0)) return;
        for (const Stand& s : stands) press(s, share(s) * load.force / held);
    }
    void press(const Stand& s, double impulse) {
        ManifoldBlock& block = core_.rows.manifold(s.row);
        const auto l = RowGraph::laneOf(s.row);
        const Real more = static_cast<Real>(impulse) - block.points[s.point].pressing[l];
        RowGraph::pressManifold(movers_, block, l, s.point, more);
        loads_[s.lower].force += impulse * static_cast<double>(s.up);
        loads_[s.lower].torque += impulse * static_cast<double>(s.ofLower);
    }

    State& state_;
    ContactCore& core_;
    Movers& movers_;
    Vec2 up_{0, 1};
    double weight_ = 0;  // m, by which gravity speeds up a step
    std::pmr::vector<Stand> stands_;
    std::pmr::vector<Load> loads_;           // by mover
    std::pmr::vector<std::uint32_t> order_;  // movers, the highest first
    std::uint32_t bearing_ = 0, new_ = 0;    // rows
};

}  // namespace

void loadStacks(State& state) {
    Loader(state).run();
}

}  // namespace sulfur::detail
