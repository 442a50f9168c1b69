// A network goes through the tick in one step.
//
// It solves for the places at its end and for the multipliers together, by Newton's method
// with factors that are kept until directions have turned. Links pull along an average of their
// directions before, at the start and at the end of the step, 1/4, 1/2 and 1/4 (Newmark 1959):
// that keeps energy as SHAKE does, and light links under great tension do not whip, however long
// the step. What contacts push on pulls along its directions at the end, which brakes. Where that
// does not converge, the nodes fly and are projected from there, pass after pass, to near places at
// which the links hold (Goldenthal et al. 2007).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "contacts/touch_rows.hpp"
#include "core/settings.hpp"
#include "particles/motion.hpp"
#include "trees/network_equations.hpp"
#include "trees/networks.hpp"
#include "trees/node_motion.hpp"

namespace sulfur::detail {

namespace {

class NetworkStepper {
public:
    NetworkStepper(State& state, Tree& tree)
        : state_(state),
          tree_(tree),
          equations_(state, tree),
          scratch_(state.trees.scratch.network),
          nodes_(state.trees.scratch.step.nodes),
          motion_(state.trees.scratch.step.motion) {}

    void run() {
        equations_.load();
        makeStep();
        for (std::size_t i = 0; i < nodes_.size(); ++i) moveNode(nodes_[i], tick(), motion_[i]);
        store();
        ++state_.statistics.chainSteps;
        tree_.lastStep = tick();
    }

private:
    using Motion = NetworkEquations::Motion;
    using Link = NetworkEquations::Link;

    double tick() const { return static_cast<double>(state_.h); }
    const TreeNode& node(std::size_t i) const { return state_.trees.nodes[tree_.first + i]; }

    /// Whether contacts pushed on it in the last step. They are absent from this one, so that what
    /// they had bent would swing to the other side if it kept its energy.
    bool isPressed() const {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const TreeNode& n = node(i);
            if (n.cluster == none && n.particle == none) continue;
            const auto m = n.cluster != none ? moverOfCluster(state_, n.cluster)
                                             : moverOfParticle(state_, n.particle);
            if (m == none) continue;
            const SolverBody& body = state_.core.movers.bodies[m];
            if (body.vx != 0 || body.vy != 0 || body.spin != 0) return true;
        }
        return false;
    }

    /// In one way, or, if that does not lead to a solution, by projecting.
    void makeStep() {
        const bool brakes = isPressed() || equations_.isTorn();
        if (tryWay(brakes ? Way::brakes : Way::keeps)) return;
        ++state_.statistics.chainFallbacks;
        // Its matrix has no tension.
        if (tree_.factorStep != 0) tree_.factorStep = Tree::stale;
        tryWay(Way::projects);
        tree_.factorStep = Tree::stale;
    }

    bool tryWay(Way way) {
        equations_.begin(way);
        for (std::size_t i = 0; i < nodes_.size(); ++i) motion_[i] = nodes_[i].start;
        predictNodes(state_, nodes_, firstKick(state_, tree_, tick()), tick(), motion_);
        scratch_.predicted.resize(nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            Motion& m = motion_[i];
            scratch_.predicted[i] = {m.displacement[0], m.displacement[1], m.turning};
            if (way == Way::projects) continue;
            m.displacement = tick() * nodes_[i].start.velocity;
            m.turning = tick() * nodes_[i].start.spin;
        }
        const bool made = converge(way);
        if (tree_.factorStep == 0) factorise();  // the sweeps need it
        return made;
    }

    /// Newton's method, or projections. Returns whether what is left can be tolerated.
    bool converge(Way way) {
        const bool projects = way == Way::projects;
        const int mostFactors = factorsOfStep();
        const int most =
            projects ? std::min(tuned::projectionPasses, mostFactors) : tuned::networkPasses;
        double last = 0, best = std::numeric_limits<double>::infinity();
        bool fresh = false;
        int stalled = 0, factors = 0;
        for (int pass = 0;; ++pass) {
            const double worst = equations_.evaluate();
            if (fresh && worst > best / 2) ++stalled;
            if (worst < best) {
                best = worst;
                equations_.keepBest();
            }
            if (worst <= tuned::networkTolerance) {
                equations_.settle();
                return true;
            }
            const bool ends = pass == most || (!projects && stalled == 2);
            const bool diverges = !(worst < 1e2 * best) && (fresh || !std::isfinite(worst));
            if (ends || diverges) break;
            const bool stale = tree_.factorStep != tick() || equations_.hasTurned();
            const bool slow = pass > 0 && isSlow(worst, last, tuned::networkTolerance);
            fresh = projects || pass == 0 ? stale || slow : slow && !fresh;
            fresh = fresh && factors < mostFactors;
            if (fresh) {
                factorise();
                ++factors;
            }
            correct();
            last = worst;
        }
        equations_.takeBest(best <= tuned::uselessError);
        return best <= (way == Way::keeps ? tuned::networkTolerable : tuned::brakingTolerable);
    }

    /// How many times a step has work for.
    int factorsOfStep() const {
        const std::uint64_t all = productsOfStep(tree_);
        const std::uint64_t most = all / priceOf(state_, tree_);
        return static_cast<int>(
            std::clamp<std::uint64_t>(most, tuned::factorPasses, tuned::projectionPasses));
    }

    /// Makes the matrix of the links as they are.
    void factorise() {
        for (std::size_t l = 0; l < scratch_.links.size(); ++l)
            state_.trees.rows[tree_.firstLink + l] = equations_.rowOf(l);
        factoriseNetwork(state_, tree_, stepRows(state_, tree_),
                         state_.trees.factors[tree_.network].step);
        tree_.factorStep = tick();
        ++state_.statistics.networkFactors;
    }

    void correct() {
        auto& values = scratch_.values;
        values.resize(scratch_.links.size());
        for (std::size_t l = 0; l < values.size(); ++l) values[l] = scratch_.links[l].value;
        correctNetwork(state_, tree_, stepRows(state_, tree_), stepSystem(state_, tree_),
                       scratch_.nodes, values);
        equations_.advance(scratch_.nodes, values);
    }

    void store() {
        if (!allFinite(motion_)) stop();
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            state_.trees.predicted[tree_.first + i] =
                storeNode(state_, node(i), nodes_[i], motion_[i]);
        const double newtons = resistance(state_, tick()) / tick() / tick();
        for (std::size_t l = 0; l < scratch_.links.size(); ++l) {
            NetworkLink& n = state_.trees.links[tree_.firstLink + l];
            const auto& lambda = scratch_.links[l].lambda;
            n.pushed = {newtons * lambda[0], newtons * lambda[1]};
            if (n.kind == LinkKind::joint)
                state_.joints.lambda[n.link] = static_cast<Real>(lambda[0]);
            else
                forceOf(state_, n) = Point(n.pushed[0], n.pushed[1]).cast<Real>();
        }
    }

    /// No number is left to go on with: everything stays where it was.
    void stop() {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            motion_[i] = nodes_[i].start;
            motion_[i].velocity = Point(0, 0);
            motion_[i].spin = 0;
        }
        for (Link& data : scratch_.links) data.lambda = {0, 0};
        tree_.factorStep = Tree::stale;
    }

    State& state_;
    Tree& tree_;
    NetworkEquations equations_;
    NetworkScratch& scratch_;
    std::vector<StepScratch::Node>& nodes_;
    std::vector<Motion>& motion_;
};

}  // namespace

void stepNetwork(State& state, Tree& tree) {
    NetworkStepper(state, tree).run();
}

}  // namespace sulfur::detail
