// Angular joints that are too stiff to be forces: compliant constraints in the sweeps.
//
// Those of a body are solved at once. One by one they would need as many sweeps as the square of
// their number, and a strip would be softer than it is. Where each pushes the same things as its
// neighbours only, as along a strip, the matrix is a narrow band.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory_resource>

#include "core/settings.hpp"
#include "joints/turn.hpp"
#include "particles/motion.hpp"
#include "rigid/grip.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

/// kg m^2 that stand for 1 N m in a step.
double multiplierPerTorque(const State& state) {
    const double h = static_cast<double>(state.h);
    return h * h / resistance(state, h);
}

/// What a joint pushes with these slopes: members of one rigid component push it together.
void findMovers(const State& state, SweptAngle& s, const Turn& turn) {
    s.present = turn;
    for (std::size_t k = 0; k < 3; ++k) {
        const Grip& grip = s.grips[k];
        s.movers[k] = {};
        if (grip.cluster == none) {
            const auto w = state.particles.inverseMass[grip.particle];
            s.movers[k] = {grip.particle, none, turn.slopes[k], 0, static_cast<double>(w), 0};
            continue;
        }
        const auto from = s.movers.begin(), to = from + static_cast<std::ptrdiff_t>(k);
        auto mover =
            std::find_if(from, to, [&](const TurnedMover& m) { return m.cluster == grip.cluster; });
        if (mover == to) {
            const Cluster& c = state.clusters.list[grip.cluster];
            mover->cluster = grip.cluster;
            mover->inverseMass = static_cast<double>(c.inverseMass);
            mover->inverseInertia = static_cast<double>(c.inverseInertia);
        }
        mover->force += turn.slopes[k];
        mover->turning += cross(grip.arm.cast<double>(), turn.slopes[k]);
    }
}

/// How far (rad) an impulse (kg m^2) of one joint turns the other.
double response(const SweptAngle& s, const SweptAngle& t) {
    double sum = 0;
    for (const TurnedMover& m : s.movers)
        for (const TurnedMover& n : t.movers) {
            if (m.particle != n.particle || m.cluster != n.cluster) continue;
            sum += m.inverseMass * m.force.dot(n.force) + m.inverseInertia * m.turning * n.turning;
        }
    return sum;
}

/// Where it begins, and what it needs in all sweeps of this step.
SweptAngle startOf(const State& state, std::uint32_t i) {
    const Angles& angles = state.angles;
    const auto& x = state.particles.position;
    SweptAngle s;
    s.grips = {gripOf(state, angles.a[i]), gripOf(state, angles.b[i]), gripOf(state, angles.c[i])};
    s.before = x[angles.b[i]] - x[angles.a[i]];
    s.after = x[angles.c[i]] - x[angles.b[i]];
    s.inert = !hasTurn(s.before, s.after);
    if (s.inert) return s;
    s.start = turnOf(angles, i, s.before, s.after);
    findMovers(state, s, s.start);
    const double mobility = response(s, s), perTorque = multiplierPerTorque(state);
    s.hk = perTorque * static_cast<double>(angles.stiffness[i] - angles.explicitStiffness[i]);
    s.hb = perTorque / static_cast<double>(state.h) *
           static_cast<double>(angles.damping[i] - angles.explicitDamping[i]);
    s.inert = !((s.hk + s.hb) * mobility > std::numeric_limits<double>::epsilon());
    s.whips =
        perTorque * std::abs(static_cast<double>(angles.torque[i])) * mobility > tuned::mostWhip;
    return s;
}

/// Implicit Euler for what is no force, as constraints with compliance 1 / (k h^2) and accumulated
/// multipliers, as solveImplicit() in stiff_joints.cpp has it for lengths. They pull along the
/// slopes of the step's start, which keeps the spin and the energy of what turns as a whole, but
/// not where one has turned far, or whips.
class AngleSweep {
public:
    AngleSweep(State& state, const AngleGroup& group)
        : state_(state),
          list_(state.work.sweptAngles.list.data() + group.first),
          angles_(state.work.implicitAngles.data() + group.first),
          size_(group.last - group.first),
          width_(group.width),
          factors_(state.work.sweptAngles.factors.data() + group.factor) {}

    void start() {
        for (std::size_t k = 0; k < size_; ++k) list_[k] = startOf(state_, angles_[k]);
        if (width_ > 0) factorise();
    }

    void sweep() {
        if (width_ > 0) return sweepWhole();
        for (std::size_t k = 0; k < size_; ++k) sweepOne(k);
        for (std::size_t k = size_; k-- > 0;) sweepOne(k);
    }

private:
    double& pivot(std::size_t k) const { return factors_[k * (width_ + 1)]; }
    /// `before` is at most `width_` less than k.
    double& factor(std::size_t k, std::size_t before) const {
        return factors_[k * (width_ + 1) + (k - before)];
    }
    std::size_t firstBefore(std::size_t k) const { return k > width_ ? k - width_ : 0; }
    static double diagonal(const SweptAngle& s) { return response(s, s) + 1 / (s.hk + s.hb); }

    /// L D L^T of the responses and compliances.
    void factorise() const {
        for (std::size_t k = 0; k < size_; ++k) {
            const bool inert = list_[k].inert;
            double own = inert ? 1 : diagonal(list_[k]);
            for (std::size_t j = firstBefore(k); j < k; ++j) {
                double sum = inert || list_[j].inert ? 0 : response(list_[k], list_[j]);
                for (std::size_t i = std::max(firstBefore(k), firstBefore(j)); i < j; ++i)
                    sum -= factor(k, i) * factor(j, i) * pivot(i);
                factor(k, j) = sum / pivot(j);
                own -= factor(k, j) * factor(k, j) * pivot(j);
            }
            pivot(k) = own;
        }
    }

    /// The angles as they are in this sweep; whether all slopes of the step's start still hold.
    bool look() {
        bool holds = true;
        for (std::size_t k = 0; k < size_; ++k) {
            SweptAngle& s = list_[k];
            s.change = 0;
            if (s.inert) continue;
            const auto moved = [&](std::size_t i) {
                return displacementOf(state_, s.grips[i]).template cast<double>().eval();
            };
            const Point corner = moved(1);
            const Point before = s.before + corner - moved(0), after = s.after + moved(2) - corner;
            if (!hasTurn(before, after)) continue;
            s.present = turnOf(state_.angles, angles_[k], before, after);
            const bool own = !s.whips && !turnsFar(s.before, before) && !turnsFar(s.after, after);
            holds &= own;
            const Turn& along = own ? s.start : s.present;
            double turned = 0;
            for (std::size_t i = 0; i < 3; ++i) turned += along.slopes[i].dot(moved(i));
            s.change = wanted(s, turned);
        }
        return holds;
    }
    static bool turnsFar(const Point& v, const Point& w) {
        return v.dot(w) < std::sqrt(v.squaredNorm() * w.squaredNorm()) / 2;
    }
    /// rad, to be made by changes of the multipliers. `turned`: what displacements turn along the
    /// slopes that push, so that dampers only take.
    static double wanted(const SweptAngle& s, double turned) {
        return -(s.hk * s.present.bend + s.hb * turned + s.lambda) / (s.hk + s.hb);
    }

    void sweepWhole() {
        const bool holds = look();
        for (std::size_t k = 0; k < size_; ++k)
            if (!list_[k].inert)
                findMovers(state_, list_[k], holds ? list_[k].start : list_[k].present);
        if (!holds) factorise();
        solve();
        double largest = 0;  // rad, of all angles
        for (std::size_t k = 0; k < size_; ++k) largest = std::max(largest, turnAt(k));
        const double share = std::min(1.0, tuned::projectedTurn / std::max(largest, 1e-300));
        for (std::size_t k = 0; k < size_; ++k) give(list_[k], share * list_[k].change);
        if (!holds) restoreFactors();
    }

    void restoreFactors() {
        for (std::size_t k = 0; k < size_; ++k)
            if (!list_[k].inert) findMovers(state_, list_[k], list_[k].start);
        factorise();
    }

    /// Changes of multipliers instead of those of angles.
    void solve() {
        for (std::size_t k = 0; k < size_; ++k)
            for (std::size_t j = firstBefore(k); j < k; ++j)
                list_[k].change -= factor(k, j) * list_[j].change;
        for (std::size_t k = 0; k < size_; ++k) list_[k].change /= pivot(k);
        for (std::size_t k = size_; k-- > 0;)
            for (std::size_t j = firstBefore(k); j < k; ++j)
                list_[j].change -= factor(k, j) * list_[k].change;
    }

    /// How far the changes turn a joint.
    double turnAt(std::size_t k) const {
        double sum = 0;
        const std::size_t last = std::min<std::size_t>(size_, k + width_ + 1);
        for (std::size_t j = firstBefore(k); j < last; ++j)
            if (list_[j].change != 0) sum += response(list_[k], list_[j]) * list_[j].change;
        return std::abs(sum);
    }

    void sweepOne(std::size_t k) {
        AngleSweep one(*this, k);
        SweptAngle& s = list_[k];
        if (s.inert) return;
        const bool holds = one.look();
        findMovers(state_, s, holds ? s.start : s.present);
        const double mobility = response(s, s);
        const double most = tuned::projectedTurn / mobility;
        give(s, std::clamp(s.change / (mobility + 1 / (s.hk + s.hb)), -most, most));
    }
    AngleSweep(const AngleSweep& all, std::size_t k)
        : state_(all.state_),
          list_(all.list_ + k),
          angles_(all.angles_ + k),
          size_(1),
          width_(0),
          factors_(nullptr) {}

    void give(SweptAngle& s, double change) {
        s.lambda += change;
        for (std::size_t k = 0; k < 3; ++k)
            push(state_, s.grips[k], (change * s.present.slopes[k]).cast<Real>());
    }

    State& state_;
    SweptAngle* list_;
    const std::uint32_t* angles_;
    std::size_t size_, width_;
    double* factors_;
};

/// Numbers of what joints push: particles, and behind them rigid components.
std::array<std::uint32_t, 3> pushedBy(const State& state, std::uint32_t i) {
    const Angles& angles = state.angles;
    const auto particles = static_cast<std::uint32_t>(state.particles.size());
    const auto numberOf = [&](std::uint32_t p) {
        const auto cluster = state.particles.cluster[p];
        return cluster == none ? p : particles + cluster;
    };
    return {numberOf(angles.a[i]), numberOf(angles.b[i]), numberOf(angles.c[i])};
}

}  // namespace

void groupAngles(State& state) {
    const auto& list = state.work.implicitAngles;
    const auto& body = state.angles.body;
    SweptAngles& swept = state.work.sweptAngles;
    swept.list.resize(list.size());
    swept.groups.clear();
    // Of what is pushed, the first joint that does.
    const std::size_t numbers = state.particles.size() + state.clusters.list.size();
    std::pmr::vector<std::uint32_t> firstAt(list.empty() ? 0 : numbers, none, &state.arena);
    std::size_t places = 0;
    for (std::uint32_t first = 0, last = 0; first < list.size(); first = last) {
        AngleGroup group{first, first, 1, static_cast<std::uint32_t>(places)};
        for (; last < list.size() && body[list[last]] == body[list[first]]; ++last)
            for (const auto number : pushedBy(state, list[last])) {
                if (firstAt[number] == none) firstAt[number] = last;
                group.width = std::max(group.width, last - firstAt[number]);
            }
        group.last = last;
        if (group.width > tuned::widestGroup) group.width = 0;
        if (group.width > 0) places += (last - first) * (group.width + 1);
        swept.groups.push_back(group);
    }
    swept.factors.resize(places);
}

void startAngles(State& state) {
    for (const AngleGroup& group : state.work.sweptAngles.groups) AngleSweep(state, group).start();
}

void solveAngles(State& state) {
    for (const AngleGroup& group : state.work.sweptAngles.groups) AngleSweep(state, group).sweep();
}

void recordAngles(State& state) {
    const WorkLists& work = state.work;
    Angles& angles = state.angles;
    const double perTorque = multiplierPerTorque(state);
    for (std::size_t k = 0; k < work.implicitAngles.size(); ++k) {
        const auto i = work.implicitAngles[k];
        const auto torque = static_cast<Real>(work.sweptAngles.list[k].lambda / perTorque);
        // What is a force as well has been recorded as one already.
        const bool forces = angles.explicitStiffness[i] > 0 || angles.explicitDamping[i] > 0;
        angles.torque[i] = forces ? angles.torque[i] + torque : torque;
    }
}

}  // namespace sulfur::detail
