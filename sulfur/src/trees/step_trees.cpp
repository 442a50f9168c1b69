// A tree that moves alone goes through the tick in steps of its own.
//
// Each step is the scheme that molecular dynamics knows as SHAKE (Ryckaert et al. 1977): joints
// pull along their directions at the step's start, as hard as makes their lengths right at its
// end. It keeps energy and angular momentum, but explodes where light links whip under great
// tension; there the steps are halved until they do not, and if even the shortest do not converge,
// the tree pulls along its directions at the step's end for this tick, which always converges and
// only ever takes energy away.
#include <algorithm>

#include "core/limits.hpp"
#include "core/settings.hpp"
#include "core/trigonometry.hpp"
#include "particles/motion.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/grip.hpp"
#include "trees/chain_batches.hpp"
#include "trees/geometry.hpp"
#include "trees/networks.hpp"
#include "trees/node_motion.hpp"
#include "trees/point_chain.hpp"
#include "trees/step_judgement.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

constexpr int mostPasses = tuned::newtonPasses, mostFallbackPasses = tuned::fallbackPasses;

using Motion = StepScratch::Motion;
using NodeData = StepScratch::Node;
using LinkData = StepScratch::Link;

template <int N>
class TreeStepper {
public:
    TreeStepper(State& state, Tree& tree)
        : state_(state),
          tree_(tree),
          solver_(state.trees.scratch.elimination<N>()),
          nodes_(state.trees.scratch.step.nodes),
          motion_(state.trees.scratch.step.motion),
          before_(state.trees.scratch.step.before),
          links_(state.trees.scratch.step.links),
          count_(tree.last - tree.first) {}

    void run() {
        load();
        Outcome outcome = attempt(tree_.steps);
        while (!outcome.good() && tree_.steps < mostSteps) {
            tree_.steps *= 2;
            outcome = attempt(tree_.steps);
        }
        store();
        state_.statistics.chainSteps += tree_.steps;
        tree_.lastStep = step_;
        if (outcome.calm() && tree_.steps > 1) tree_.steps /= 2;
    }

private:
    double tick() const { return static_cast<double>(state_.h); }
    const TreeNode& node(std::size_t i) const { return state_.trees.nodes[tree_.first + i]; }

    // --- the tick's start ------------------------------------------------------------------

    void load() {
        solver_.resize(count_);
        nodes_.resize(count_);
        motion_.resize(count_);
        links_.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) loadNode(i);
        for (std::size_t i = 1; i < count_; ++i) loadLink(i);
    }

    void loadNode(std::size_t i) {
        NodeData& data = nodes_[i];
        detail::loadNode(state_, node(i), data);
        auto& w = solver_.nodes[i].inverseMass;
        w[0] = w[1] = data.inverseMass;
        if constexpr (N == 3) w[2] = data.inverseInertia;
    }

    Point armOf(const TreeNode& n, const LinkEnd& end) const {
        if (n.cluster == none) return {0, 0};
        return turned(state_.clusters.list[n.cluster].heading, end.place);
    }

    void loadLink(std::size_t i) {
        const TreeNode& n = node(i);
        LinkData& link = links_[i];
        link = {};
        link.armHere = armOf(n, n.here);
        link.armThere = armOf(node(n.parent), n.there);
        solver_.links[i].parent = n.parent;
        if (n.kind != LinkKind::joint) return;
        const Joints& joints = state_.joints;
        link.rest = static_cast<double>(joints.restLength[n.link]);
        link.elastic.rigid = joints.kind[n.link] == JointKind::rigid;
        link.pull = static_cast<double>(joints.explicitStiffness[n.link]);
        link.brake = static_cast<double>(joints.explicitDamping[n.link]);
        link.stiffness = static_cast<double>(joints.stiffness[n.link]) - link.pull;
        link.damping = static_cast<double>(joints.damping[n.link] - joints.explicitDamping[n.link]);
        const double force = static_cast<double>(joints.force[n.link]);
        link.guess = link.elastic.rigid && std::abs(force) < maxForce ? force : 0;
    }

    /// 1/kg, in the direction in which a node moves most easily at that arm.
    double mobilityAt(std::size_t i, const Point& arm) const {
        return nodes_[i].inverseMass + nodes_[i].inverseInertia * arm.squaredNorm();
    }

    // --- one try with a number of steps -----------------------------------------------------

    /// The tick in `steps` steps. With the most that there are it always succeeds: steps that do
    /// not are made again with directions that brake.
    Outcome attempt(std::uint32_t steps) {
        const double step = tick() / steps;
        for (std::size_t i = 0; i < count_; ++i) motion_[i] = nodes_[i].start;
        for (std::size_t i = 1; i < count_; ++i) prepareLink(links_[i], step);
        Outcome whole;
        std::uint32_t fallbacks = 0;
        for (std::uint32_t s = 0; s < steps && (whole.good() || steps == mostSteps); ++s) {
            if (fallbacks == tuned::mostFallbacks) {
                whole.add(goOnCoarsely(steps - s, step));
                break;
            }
            const NodeKick kick = s == 0 ? firstKick(state_, tree_, step) : NodeKick{step, step};
            if (steps == mostSteps) before_ = motion_;
            Outcome one = makeStep(kick, step, s == 0, false);
            if (steps == mostSteps && !torn_ && !one.tolerable()) {
                motion_ = before_;
                one = makeStep(kick, step, s == 0, true);
                ++fallbacks;
            }
            finishStep(step);
            whole.add(one);
        }
        return whole;
    }

    /// What the `left` shortest steps would be, in fewer ones that brake.
    Outcome goOnCoarsely(std::uint32_t left, double step) {
        const std::uint32_t steps = std::min(left, tuned::coarseSteps);
        const double coarse = left * step / steps;
        Outcome whole;
        for (std::size_t i = 1; i < count_; ++i) stretchStep(links_[i], coarse);
        for (std::uint32_t s = 0; s < steps; ++s) {
            const NodeKick kick{coarse, s == 0 ? (step + coarse) / 2 : coarse};
            whole.add(makeStep(kick, coarse, false, true));
            finishStep(coarse);
        }
        return whole;
    }
    Outcome makeStep(NodeKick kick, double step, bool first, bool fallback) {
        step_ = step;
        predictNodes(state_, nodes_, kick, step, motion_);
        beginStep(kick.forces, step, first);
        fallback |= torn_;
        if (fallback) ++state_.statistics.chainFallbacks;
        if (fallback)
            for (std::size_t i = 1; i < count_; ++i) links_[i].lambda = {0, 0};
        else
            warmStart();
        Outcome outcome;
        outcome.converged = converge(fallback);
        judge(outcome);
        return outcome;
    }

    void stretchStep(LinkData& link, double step) {
        const double perPush = step / resistance(state_, step);
        link.elastic.hk = link.stiffness * step * perPush;
        link.elastic.hb = link.damping * perPush;
    }
    void prepareLink(LinkData& link, double step) {
        stretchStep(link, step);
        link.impulse = {0, 0};
        link.lambda = {-link.guess * step * step, 0};
    }

    /// Arms and distance of a link after the displacements so far; without them at a step's start.
    Span spanOf(std::size_t i, bool moved) const {
        const std::size_t parent = solver_.links[i].parent;
        const Motion &here = motion_[i], &there = motion_[parent];
        Span span;
        span.armHere = armNow(i, links_[i].armHere, moved);
        span.armThere = armNow(parent, links_[i].armThere, moved);
        span.apart = (here.place - there.place) + (span.armHere - span.armThere);
        if (moved) span.apart += here.displacement - there.displacement;
        return span;
    }

    Point armNow(std::size_t i, const Point& arm, bool moved) const {
        if constexpr (N == 2) return {0, 0};
        const Motion& m = motion_[i];
        if (node(i).cluster == none) return {0, 0};
        const Point before = turned(m.heading, arm);
        return moved ? turned(unitVector(m.turning), before) : before;
    }

    void beginStep(double kick, double step, bool first) {
        const double perNewton = kick * step / resistance(state_, kick);
        const bool shortest = tree_.steps == mostSteps;
        torn_ = false;
        for (std::size_t i = 1; i < count_; ++i) {
            LinkData& link = links_[i];
            link.start = spanOf(i, false);
            link.length = link.start.apart.norm();
            if (node(i).kind != LinkKind::joint) {
                const double left = errorLeft(link.length, step, closingSpeedOf(node(i).kind));
                const Point apart =
                    left > 0 ? Point(left / link.length * link.start.apart) : Point(0, 0);
                link.left = {apart[0], apart[1]};
                continue;
            }
            link.left[0] = link.elastic.rigid ? errorLeft(link.length - link.rest, step) : 0;
            torn_ |= shortest && link.left[0] != 0;
            link.inert = !(link.length > 1e-12);
            link.early = 0;
            if (!link.inert) link.direction = link.start.apart / link.length;
            if (!link.inert && !link.elastic.rigid) pushByChange(i, perNewton, first);
        }
    }

    /// What the part of a spring that is a force gives beyond what it gave when the tick began,
    /// which is part of the nodes' accelerations: held for all steps it would feed the spring.
    void pushByChange(std::size_t i, double perNewton, bool first) {
        LinkData& link = links_[i];
        const std::size_t parent = solver_.links[i].parent;
        const Point parting =
            velocityAt(i, link.start.armHere) - velocityAt(parent, link.start.armThere);
        const double lengthening = link.direction.dot(parting);
        Point force =
            (-link.pull * (link.length - link.rest) - link.brake * lengthening) * link.direction;
        if (state_.settings.damper == Damper::full)
            force -= link.brake * (parting - lengthening * link.direction);
        if (first) link.held = force;
        const Point push = perNewton * (force - link.held);
        link.early = push.dot(link.direction);
        move(i, push, link.start.armHere);
        move(parent, -push, link.start.armThere);
    }

    Point velocityAt(std::size_t i, const Point& arm) const {
        return motion_[i].velocity + motion_[i].spin * Point(-arm[1], arm[0]);
    }

    /// Begins with the multipliers of the step before: the passes then have little left to do.
    void warmStart() {
        for (std::size_t i = 1; i < count_; ++i) {
            LinkData& link = links_[i];
            if (node(i).kind != LinkKind::joint || link.inert || !link.elastic.rigid) {
                link.lambda = {0, 0};
                continue;
            }
            const std::size_t parent = solver_.links[i].parent;
            const Point push = link.lambda[0] * link.direction;
            move(i, push, link.start.armHere);
            move(parent, -push, link.start.armThere);
        }
    }

    void move(std::size_t i, const Point& push, const Point& arm) {
        motion_[i].displacement += nodes_[i].inverseMass * push;
        if constexpr (N == 3)
            motion_[i].turning += nodes_[i].inverseInertia * (arm[0] * push[1] - arm[1] * push[0]);
    }

    bool converge(bool fallback) {
        const int most = fallback ? mostFallbackPasses : mostPasses;
        for (int pass = 0;; ++pass) {
            const double worst = updateRows(fallback);
            if (worst <= treeTolerance) return true;
            if (pass == most || !std::isfinite(worst)) return false;
            solver_.solve();
            apply();
        }
    }

    /// Rows at the present displacements; the largest error relative to a length.
    double updateRows(bool fallback) {
        double worst = 0;
        for (std::size_t i = 1; i < count_; ++i) {
            auto& row = solver_.links[i];
            LinkData& link = links_[i];
            row.rows = 0;
            if (link.inert) continue;
            const Span now = spanOf(i, true);
            if (node(i).kind != LinkKind::joint) {
                setMeeting<N>(row, fallback ? now : link.start, now);
                for (std::size_t r = 0; r < 2; ++r) row.value[r] -= link.left[r];
                worst = std::max(worst, std::hypot(row.value[0], row.value[1]));
                continue;
            }
            const double length = now.apart.norm();
            if (!(length > 1e-12)) return std::isnan(length) ? length : 1.0;
            const Point direction = now.apart / length;
            setDistance<N>(row, fallback ? now : link.start, now,
                           fallback ? direction : link.direction, direction);
            const double give = torn_ && link.elastic.rigid ? giveOf(i) : 0;
            row.compliance[0] = complianceOf(link.elastic) + give;
            row.value[0] = valueOf(link.elastic, length - link.rest - link.left[0],
                                   length - link.length, link.lambda[0]) +
                           give * link.lambda[0];
            worst = std::max(worst, std::abs(row.value[0]) / std::max(link.rest, 1e-3));
        }
        return worst;
    }

    /// What is torn between two that stand fast can never close. Its links pull so hard that their
    /// whip is a quarter, no harder; longer ones up to twice as hard, so that in the end all are
    /// equally long.
    double giveOf(std::size_t i) const {
        const double rest = links_[i].rest, length = std::max(links_[i].length, rest);
        const double lightest = std::max(mobilityAt(i, links_[i].armHere),
                                         mobilityAt(node(i).parent, links_[i].armThere));
        const double share = (1 + rest / length) / 2;
        return 16 * lightest * share * closingSpeed * step_ / length;
    }

    void apply() {
        for (std::size_t i = 0; i < count_; ++i) {
            const auto& impulse = solver_.nodes[i].impulse;
            motion_[i].displacement += nodes_[i].inverseMass * Point(impulse[0], impulse[1]);
            if constexpr (N == 3) motion_[i].turning += nodes_[i].inverseInertia * impulse[2];
        }
        for (std::size_t i = 1; i < count_; ++i)
            for (std::size_t r = 0; r < 2; ++r)
                if (static_cast<int>(r) < solver_.links[i].rows)
                    links_[i].lambda[r] += solver_.links[i].lambda[r];
    }

    void finishStep(double step) {
        for (std::size_t i = 0; i < count_; ++i) moveNode(nodes_[i], step, motion_[i]);
        const double newtons = resistance(state_, step) / step;
        for (std::size_t i = 1; i < count_; ++i)
            for (std::size_t r = 0; r < 2; ++r)
                links_[i].impulse[r] +=
                    newtons * (links_[i].lambda[r] + (r == 0 ? links_[i].early : 0));
    }

    /// How far this step was from where SHAKE explodes.
    void judge(Outcome& outcome) {
        for (std::size_t i = 0; i < count_; ++i) nodes_[i].pull = 0;
        for (std::size_t i = 1; i < count_; ++i) {
            const LinkData& link = links_[i];
            if (node(i).kind != LinkKind::joint || link.inert) continue;
            const double pull = std::abs(link.lambda[0]) / link.length;
            nodes_[i].pull += pull;
            nodes_[solver_.links[i].parent].pull += pull;
            const auto& row = solver_.links[i].rowHere[0];
            const double turn = link.direction[0] * row[1] - link.direction[1] * row[0];
            outcome.turn = std::max(outcome.turn, std::abs(turn));
            if (link.direction[0] * row[0] + link.direction[1] * row[1] < 0) outcome.turn = 2;
        }
        for (std::size_t i = 0; i < count_; ++i)
            outcome.whip = std::max(outcome.whip, 2 * nodes_[i].inverseMass * nodes_[i].pull);
        if (!std::isfinite(outcome.whip)) outcome.converged = false;
    }

    // --- the tick's end ---------------------------------------------------------------------

    void store() {
        if (!allFinite(motion_)) stop();
        for (std::size_t i = 0; i < count_; ++i)
            state_.trees.predicted[tree_.first + i] =
                storeNode(state_, node(i), nodes_[i], motion_[i]);
        const double perNewton = tick() / resistance(state_, tick());
        for (std::size_t i = 1; i < count_; ++i) {
            const TreeNode& n = node(i);
            const auto& impulse = links_[i].impulse;
            if (n.kind == LinkKind::joint)
                state_.joints.lambda[n.link] = static_cast<Real>(impulse[0] * perNewton);
            else
                forceOf(state_, n) =
                    (Point(impulse[0], impulse[1]) * ((n.turned ? -1 : 1) / tick()))
                        .template cast<Real>();
        }
    }

    /// No number is left to go on with: everything stays where it was.
    void stop() {
        for (std::size_t i = 0; i < count_; ++i) {
            motion_[i] = nodes_[i].start;
            motion_[i].velocity = Point(0, 0);
            motion_[i].spin = 0;
        }
        for (LinkData& link : links_) link.impulse = {0, 0};
    }

    State& state_;
    Tree& tree_;
    Elimination<N>& solver_;
    std::vector<NodeData>& nodes_;
    std::vector<Motion>&motion_, &before_;
    std::vector<LinkData>& links_;
    std::uint32_t count_;
    double step_ = 0;    // s, of the step that is made
    bool torn_ = false;  // whether, in the shortest, a rigid link is not as long as it should be
};

void stepTree(State& state, Tree& tree) {
    if (tree.chain && stepChain(state, tree)) return;
    if (tree.network != none)
        stepNetwork(state, tree);
    else if (tree.points)
        TreeStepper<2>(state, tree).run();
    else
        TreeStepper<3>(state, tree).run();
    for (auto k = tree.first; k < tree.last; ++k)
        if (const auto p = state.trees.nodes[k].particle; p != none)
            state.particles.force[p] = Point(0, 0);
}

}  // namespace

void stepTrees(State& state) {
    if (state.work.lonelyTrees.empty()) return;
    std::pmr::vector<std::uint32_t> left(&state.arena);
    left.reserve(state.work.lonelyTrees.size());
    state.trees.predicted.resize(state.trees.nodes.size());
    stepChainBatches(state, left);
    for (const auto i : left) stepTree(state, state.trees.list[i]);
    for (const auto i : state.work.chains.others) stepTree(state, state.trees.list[i]);
}

}  // namespace sulfur::detail
