// Trees in the sweeps: those on which something else pulls, and lines through meshes.
//
// A tree that moves alone has already arrived at the tick's end; what contacts push then, it
// answers with the masses and directions that it has there. A line through a mesh is solved like
// one rigid joint among others: along its directions at the tick's start.
#include <algorithm>

#include "core/limits.hpp"
#include "core/trigonometry.hpp"
#include "rigid/grip.hpp"
#include "trees/geometry.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// A line whose light nodes whip more than this in a tick pulls along its present directions.
constexpr double mostWhip = 0.2;

template <int N>
class TreeSweeper {
public:
    TreeSweeper(State& state, std::uint32_t tree, Elimination<N>& solver)
        : state_(state),
          tree_(state.trees.list[tree]),
          solver_(solver),
          count_(tree_.last - tree_.first) {
        solver_.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) loadMasses(i);
    }

    /// Notes the values that the prediction has led to.
    void remember() {
        for (std::size_t i = 1; i < count_; ++i) {
            updateLink(i);
            auto& met = state_.trees.met[tree_.first + i];
            met = {0, 0};
            if (solver_.links[i].rows == 2) met = solver_.links[i].value;
            if (solver_.links[i].rows == 1) met[0] = lengthNow_;
        }
    }

    void sweep() {
        for (std::size_t i = 1; i < count_; ++i) updateLink(i);
        solver_.solve();
        for (std::size_t i = 0; i < count_; ++i) apply(i);
        for (std::size_t i = 1; i < count_; ++i)
            for (std::size_t r = 0; r < 2; ++r)
                if (static_cast<int>(r) < solver_.links[i].rows)
                    state_.trees.lambda[tree_.first + i][r] += solver_.links[i].lambda[r];
    }

private:
    const TreeNode& node(std::size_t i) const { return state_.trees.nodes[tree_.first + i]; }

    void loadMasses(std::size_t i) {
        const TreeNode& n = node(i);
        auto& w = solver_.nodes[i].inverseMass;
        w.setZero();
        if (n.cluster != none) {
            const Cluster& c = state_.clusters.list[n.cluster];
            w[0] = w[1] = static_cast<double>(c.inverseMass);
            if constexpr (N == 3) w[2] = static_cast<double>(c.inverseInertia);
        } else if (n.particle != none) {
            w[0] = w[1] = static_cast<double>(state_.particles.inverseMass[n.particle]);
        }
    }

    struct Place {
        Point at, arm;
    };

    Place placeOf(std::size_t i, const LinkEnd& end, bool moved) const {
        const TreeNode& n = node(i);
        if (n.cluster != none) {
            const Cluster& c = state_.clusters.list[n.cluster];
            Point arm = turned(c.heading, end.place), at = c.centre;
            if (moved) {
                arm = turned(unitVector(c.angle), arm);
                at += c.displacement.template cast<double>();
            }
            return {at + arm, arm};
        }
        const Particles& p = state_.particles;
        Point at(0, 0);
        const auto add = [&](std::uint32_t k, double weight) {
            at += weight * p.position[k];
            if (moved) at += weight * p.displacement[k].template cast<double>();
        };
        if (n.particle != none) {
            add(n.particle, 1);
        } else {
            const Attachment& held = state_.attachments[n.link];
            for (std::uint32_t k = 0; k < held.count; ++k)
                add(held.support[k], static_cast<double>(held.weight[k]));
        }
        return {at, Point(0, 0)};
    }

    Span spanOf(std::size_t i, bool moved) const {
        const TreeNode& n = node(i);
        const Place here = placeOf(i, n.here, moved), there = placeOf(n.parent, n.there, moved);
        return {here.arm, there.arm, here.at - there.at};
    }

    void updateLink(std::size_t i) {
        const TreeNode& n = node(i);
        auto& link = solver_.links[i];
        link.parent = n.parent;
        link.rows = 0;
        const Span now = spanOf(i, true);
        const auto& met = state_.trees.met[tree_.first + i];
        if (n.kind != LinkKind::joint) {
            setMeeting<N>(link, now, now);
            std::array<double, 2> wanted = met;
            if (!tree_.alone) {
                const Point apart = spanOf(i, false).apart;
                const double gap = apart.norm();
                const double left = errorLeft(gap, static_cast<double>(state_.h));
                if (left > 0) wanted = {left / gap * apart[0], left / gap * apart[1]};
            }
            for (std::size_t r = 0; r < 2; ++r) link.value[r] -= wanted[r];
            return;
        }
        lengthNow_ = now.apart.norm();
        if (!(lengthNow_ > 1e-12)) return;
        const Span start = spanOf(i, false);
        const double before = start.apart.norm();
        const Point direction = now.apart / lengthNow_;
        const bool asAtStart = !tree_.alone && before > 1e-12 && whip(n.link, before) < mostWhip &&
                               direction.dot(start.apart) > 0.5 * before;
        setDistance<N>(link, asAtStart ? start : now, now,
                       asAtStart ? Point(start.apart / before) : direction, direction);
        setValue(i, before, met[0]);
    }

    double whip(std::uint32_t joint, double length) const {
        const auto& w = state_.particles.inverseMass;
        const Joints& joints = state_.joints;
        const double h = static_cast<double>(state_.h);
        return 2 * static_cast<double>(std::max(w[joints.a[joint]], w[joints.b[joint]])) *
               std::abs(static_cast<double>(joints.force[joint])) * h * h / length;
    }

    /// `met`: the length that the prediction led to, for trees that move alone.
    void setValue(std::size_t i, double before, double met) {
        const Joints& joints = state_.joints;
        const auto j = node(i).link;
        auto& link = solver_.links[i];
        const double h = static_cast<double>(state_.h);
        Elastic elastic;
        elastic.rigid = joints.kind[j] == JointKind::rigid;
        elastic.hk = (static_cast<double>(joints.stiffness[j]) -
                      static_cast<double>(joints.explicitStiffness[j])) *
                     h * h;
        elastic.hb = static_cast<double>(joints.damping[j] - joints.explicitDamping[j]) * h;
        const double rest = static_cast<double>(joints.restLength[j]);
        const double wanted =
            tree_.alone ? met : rest + (elastic.rigid ? errorLeft(before - rest, h) : 0);
        link.compliance = complianceOf(elastic);
        link.value[0] =
            valueOf(elastic, lengthNow_ - wanted, lengthNow_ - (tree_.alone ? met : before),
                    state_.trees.lambda[tree_.first + i][0]);
    }

    void apply(std::size_t i) {
        const TreeNode& n = node(i);
        const auto& impulse = solver_.nodes[i].impulse;
        const Point pushed(impulse[0], impulse[1]);
        if (n.cluster != none) {
            Cluster& c = state_.clusters.list[n.cluster];
            c.displacement += (static_cast<double>(c.inverseMass) * pushed).template cast<Real>();
            if constexpr (N == 3) turnBy(c, static_cast<double>(c.inverseInertia) * impulse[2]);
        } else if (n.particle != none) {
            const double w = static_cast<double>(state_.particles.inverseMass[n.particle]);
            state_.particles.displacement[n.particle] += (w * pushed).template cast<Real>();
        }
    }

    State& state_;
    const Tree& tree_;
    Elimination<N>& solver_;
    std::size_t count_;
    double lengthNow_ = 0;  // of the link that was updated last
};

template <class Function>
void withSweeper(State& state, std::uint32_t tree, Function&& f) {
    thread_local Elimination<2> points;
    thread_local Elimination<3> bodies;
    if (state.trees.list[tree].points) {
        TreeSweeper<2> sweeper(state, tree, points);
        f(sweeper);
    } else {
        TreeSweeper<3> sweeper(state, tree, bodies);
        f(sweeper);
    }
}

void touch(State& state, const Grip& grip) {
    Trees& trees = state.trees;
    const auto tree =
        grip.cluster != none ? trees.ofCluster[grip.cluster] : trees.ofParticle[grip.particle];
    if (tree != none) trees.touched[tree] = 1;
}

}  // namespace

void touchTrees(State& state) {
    Trees& trees = state.trees;
    if (trees.list.empty()) return;
    trees.met.assign(trees.nodes.size(), {0, 0});
    trees.lambda.assign(trees.nodes.size(), {0, 0});
    trees.touched.assign(trees.list.size(), 0);
    for (const Contact& c : state.contacts)
        for (const Grip& grip : {c.gripOfParticle, c.gripOfA, c.gripOfB}) touch(state, grip);
    for (const Grab& grab : state.influences.grabs)
        for (std::uint32_t k = 0; k < grab.count; ++k)
            touch(state, gripOf(state, state.particleSlots.dense(grab.support[k])));
    for (const auto i : state.work.lonelyTrees) {
        if (trees.list[i].tied) trees.touched[i] = 1;
        if (trees.touched[i]) withSweeper(state, i, [](auto& s) { s.remember(); });
    }
}

void sweepTrees(State& state) {
    for (const auto i : state.work.lines) withSweeper(state, i, [](auto& s) { s.sweep(); });
    for (const auto i : state.work.lonelyTrees)
        if (state.trees.touched[i]) withSweeper(state, i, [](auto& s) { s.sweep(); });
}

void recordTreeForces(State& state) {
    const Trees& trees = state.trees;
    Joints& joints = state.joints;
    const auto record = [&](const Tree& tree) {
        for (auto k = tree.first + 1; k < tree.last; ++k) {
            const TreeNode& n = trees.nodes[k];
            if (n.kind != LinkKind::joint) {
                const Vec2 pushed(static_cast<Real>(trees.lambda[k][0]),
                                  static_cast<Real>(trees.lambda[k][1]));
                Vec2& force = forceOf(state, n);
                if (!tree.alone) force = Vec2(0, 0);
                force += Real(n.turned ? -1 : 1) / (state.h * state.h) * pushed;
                continue;
            }
            const Real swept = static_cast<Real>(trees.lambda[k][0]);
            joints.lambda[n.link] = tree.alone ? joints.lambda[n.link] + swept : swept;
        }
    };
    for (const auto i : state.work.lines) record(trees.list[i]);
    for (const auto i : state.work.lonelyTrees)
        if (trees.touched[i]) record(trees.list[i]);
}

void updateTreeVelocities(State& state) {
    const double h = static_cast<double>(state.h);
    for (const auto i : state.work.lonelyTrees) {
        if (!state.trees.touched[i]) continue;
        const Tree& tree = state.trees.list[i];
        for (auto k = tree.first; k < tree.last; ++k) {
            const auto p = state.trees.nodes[k].particle;
            if (p == none || state.particles.inverseMass[p] == 0) continue;
            const Vec2 change = state.particles.displacement[p] - state.trees.predicted[k];
            state.particles.velocity[p] =
                limited(state.particles.velocity[p] + change.cast<double>() / h);
        }
    }
}

}  // namespace sulfur::detail
