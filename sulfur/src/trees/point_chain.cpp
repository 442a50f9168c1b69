// A chain of points in plain arrays: the same scheme as TreeStepper's, without its generality.
//
// Link i holds node i to node i - 1. With e_i the present and u_i the starting direction of link i
// the multipliers solve a tridiagonal system,
//     (w_i-1 + w_i) e_i.u_i lambda_i + alpha_i lambda_i
//         - w_i-1 e_i.u_i-1 lambda_i-1 - w_i e_i.u_i+1 lambda_i+1 = -C_i,
// which is eliminated from both ends towards the middle: two recurrences that do not wait for each
// other take half the time of one. A rigid link's constraint is C = (d^2 - r^2) / 2r, whose
// gradient is d / r: the same solution without a root or a division.
#include "trees/point_chain.hpp"

#include <cmath>

#include "core/limits.hpp"
#include "particles/motion.hpp"
#include "trees/node_motion.hpp"
#include "trees/step_judgement.hpp"

namespace sulfur::detail {

namespace {

using Pair = ChainScratch::Pair;
using ChainNode = ChainScratch::Node;
using ChainLink = ChainScratch::Link;
using ChainSpring = ChainScratch::Spring;
using ChainFactor = ChainScratch::Factor;

inline double dot(Pair a, Pair b) {
    const Pair product = a * b;
    return product[0] + product[1];
}
inline Pair limitedTo(double most, Pair v) {
    const Pair high = {most, most}, low = -high;
    v = v < high ? v : high;
    return v > low ? v : low;
}
inline Pair pairOf(const Point& p) {
    return Pair{p[0], p[1]};
}

class ChainStepper {
public:
    ChainStepper(State& state, Tree& tree)
        : state_(state),
          tree_(tree),
          count_(tree.last - tree.first),
          tick_(static_cast<double>(state.h)) {
        ChainScratch& scratch = state.trees.scratch.chain;
        scratch.reserve(count_);
        nodes_ = scratch.nodes.data();
        links_ = scratch.links.data();
        springs_ = scratch.springs.data();
        factors_ = scratch.factors.data();
    }

    bool run() {
        load();
        Outcome outcome = attempt(tree_.steps);
        while (!enough(outcome) && tree_.steps < mostSteps) {
            tree_.steps *= 2;
            outcome = attempt(tree_.steps);
        }
        if (!enough(outcome) || !allFinite()) return false;
        store();
        state_.statistics.chainSteps += tree_.steps;
        tree_.lastStep = tick_ / tree_.steps;
        if (outcome.calm() && tree_.steps > 1) tree_.steps /= 2;
        return true;
    }

private:
    const TreeNode& node(std::size_t i) const { return state_.trees.nodes[tree_.first + i]; }

    bool enough(const Outcome& outcome) const {
        return tree_.steps == mostSteps ? outcome.tolerable() : outcome.good();
    }

    // --- the tick's start ------------------------------------------------------------------

    void load() {
        const Point gravity = state_.settings.gravity.cast<double>();
        for (std::size_t i = 0; i < count_; ++i) loadNode(i, gravity);
        elastic_ = false;
        for (std::size_t i = 1; i < count_; ++i) loadLink(i);
    }

    void loadNode(std::size_t i, const Point& gravity) {
        const Particles& particles = state_.particles;
        const auto p = node(i).particle;
        ChainNode& n = nodes_[i];
        n.inverseMass = static_cast<double>(particles.inverseMass[p]);
        if (n.inverseMass > 0) {
            n.startVelocity = pairOf(particles.velocity[p]);
            n.gravity = pairOf(gravityOf(state_, particles.body[p]));
            n.acceleration = pairOf(gravity + n.inverseMass * particles.force[p]);
        } else {  // as the caller drives it; the stage before has set the displacement
            n.startVelocity = pairOf(particles.displacement[p].cast<double>() / tick_);
            n.acceleration = n.gravity = Pair{0, 0};
        }
    }

    void loadLink(std::size_t i) {
        const Joints& joints = state_.joints;
        const auto j = node(i).link;
        const auto& x = state_.particles.position;
        const Point &here = x[node(i).particle], &there = x[node(i - 1).particle];
        ChainLink& link = links_[i];
        link.apart = pairOf(here) - pairOf(there);
        link.masses = nodes_[i].inverseMass + nodes_[i - 1].inverseMass;
        link.rest = static_cast<double>(joints.restLength[j]);
        link.share = shareOf(link.rest);
        const double force = static_cast<double>(joints.force[j]);
        ChainSpring& spring = springs_[i];
        spring.rigid = joints.kind[j] == JointKind::rigid;
        link.guess = spring.rigid && std::abs(force) < maxForce ? force : 0;
        if (spring.rigid) return;
        elastic_ = true;
        spring.pull = static_cast<double>(joints.explicitStiffness[j]);
        spring.brake = static_cast<double>(joints.explicitDamping[j]);
        spring.stiffness = static_cast<double>(joints.stiffness[j]) - spring.pull;
        spring.damping = static_cast<double>(joints.damping[j] - joints.explicitDamping[j]);
    }

    // --- one try with a number of steps -----------------------------------------------------

    Outcome attempt(std::uint32_t steps) {
        const double step = tick_ / steps;
        prepare(step);
        Outcome whole;
        for (std::uint32_t s = 0; s < steps && enough(whole); ++s) {
            const NodeKick kick = s == 0 ? firstKick(state_, tree_, step) : NodeKick{step, step};
            predict(kick, step);
            if (!beginStep(kick.forces, step, s == 0) || (steps == mostSteps && torn_)) {
                whole.converged = false;
                break;
            }
            Outcome one;
            one.converged = elastic_ ? converge<true>() : converge<false>();
            judge(one);
            finishStep(step);
            whole.add(one);
        }
        return whole;
    }

    void prepare(double step) {
        for (std::size_t i = 0; i < count_; ++i) {
            nodes_[i].velocity = nodes_[i].startVelocity;
            nodes_[i].moved = Pair{0, 0};
        }
        for (std::size_t i = 1; i < count_; ++i) {
            links_[i].impulse = 0;
            links_[i].lambda = -links_[i].guess * step * step;
        }
        if (!elastic_) return;
        const double perPush = step / resistance(state_, step);
        for (std::size_t i = 1; i < count_; ++i) {
            ChainSpring& spring = springs_[i];
            spring.hk = spring.stiffness * step * perPush;
            spring.hb = spring.damping * perPush;
            spring.compliance = spring.rigid ? 0 : 1 / (spring.hk + spring.hb);
            spring.early = 0;
        }
    }

    void predict(NodeKick kick, double step) {
        const double half = kick.forces * static_cast<double>(state_.settings.airFriction) / 2;
        const double keep = (1 - half) / (1 + half), push = kick.forces / (1 + half);
        const double longer = kick.gravity - kick.forces;
        for (std::size_t i = 0; i < count_; ++i) {
            ChainNode& n = nodes_[i];
            if (n.inverseMass > 0)
                n.velocity = limitedTo(
                    maxSpeed, keep * n.velocity + push * n.acceleration + longer * n.gravity);
            n.displacement = step * n.velocity;
        }
    }

    /// Directions at the step's start, and the multipliers of the step before: the passes then
    /// have little left to do. False if a link has no direction.
    bool beginStep(double kick, double step, bool first) {
        bool directed = true;
        torn_ = false;
        const double perNewton = kick * step / resistance(state_, kick);
        Pair before{0, 0};  // what the link before has pushed this node with
        for (std::size_t i = 1; i < count_; ++i) {
            ChainLink& link = links_[i];
            ChainNode &here = nodes_[i], &there = nodes_[i - 1];
            link.now = link.apart + (here.moved - there.moved);
            if (!elastic_ && isAtRest(link)) {
                link.target = link.rest;
                link.scale = link.inverseLength = link.share;
            } else {
                directed &= measure(link, !elastic_ || springs_[i].rigid, step);
                torn_ |= link.target != link.rest;
            }
            link.start = link.inverseLength * link.now;
            Pair push = link.lambda * link.start;
            if (elastic_ && !springs_[i].rigid) push = changeOfPull(i, perNewton, first);
            there.displacement += there.inverseMass * (before - push);
            before = push;
        }
        nodes_[count_ - 1].displacement += nodes_[count_ - 1].inverseMass * before;
        return directed;
    }

    /// What the part of a spring that is a force gives this node beyond what it gave when the tick
    /// began, which is part of the node's acceleration: held for all steps it would feed the
    /// spring.
    Pair changeOfPull(std::size_t i, double perNewton, bool first) {
        const ChainLink& link = links_[i];
        ChainSpring& spring = springs_[i];
        const Pair parting = nodes_[i].velocity - nodes_[i - 1].velocity;
        const double lengthening = dot(link.start, parting);
        const double stretch = 1 / link.inverseLength - link.rest;
        Pair force = (-spring.pull * stretch - spring.brake * lengthening) * link.start;
        if (state_.settings.damper == Damper::full)
            force -= spring.brake * (parting - lengthening * link.start);
        if (first) spring.held = force;
        const Pair push = perNewton * (force - spring.held);
        spring.early = dot(push, link.start);
        return push;
    }

    /// Nearly always a rigid link has its rest length. Then no root is needed: a direction that is
    /// longer than 1 by a millionth changes only the unit of the multiplier, by as much.
    static bool isAtRest(const ChainLink& link) {
        const double stretch = dot(link.now, link.now) * link.share - link.rest;
        return std::abs(stretch) < std::min(2e-6 * link.rest, smallStretch) && link.share < 1e3;
    }

    static bool measure(ChainLink& link, bool rigid, double step) {
        const double length = std::sqrt(dot(link.now, link.now));
        link.inverseLength = 1 / length;
        link.target = link.rest + (rigid ? errorLeft(length - link.rest, step) : 0);
        link.scale = 1 / link.target;
        if (!rigid) link.lambda = 0;
        return length > 1e-12;
    }

    template <bool withSprings>
    bool converge() {
        double before = 0;
        for (int pass = 0, factored = 0;; ++pass) {
            const double worst = evaluate<withSprings>();
            if (worst <= treeTolerance) return true;
            const bool stale = pass == 0 || !(worst < worthwhile * before);
            if (pass == mostChainPasses || (stale && factored == mostChainFactors) ||
                !std::isfinite(worst))
                return false;
            if (stale) {
                factorise<withSprings>();
                ++factored;
            }
            solve();
            before = worst;
        }
    }

    /// Constraints and their gradients at the present displacements; the largest error relative to
    /// a length.
    template <bool withSprings>
    double evaluate() {
        double worst = 0;
        for (std::size_t i = 1; i < count_; ++i) {
            ChainLink& link = links_[i];
            const Pair apart = link.now + (nodes_[i].displacement - nodes_[i - 1].displacement);
            const double square = dot(apart, apart);
            if (withSprings && !springs_[i].rigid) {
                const ChainSpring& s = springs_[i];
                const double length = std::sqrt(square);
                if (!(length > 1e-12)) return std::isnan(length) ? length : 1.0;
                link.present = (1 / length) * apart;
                link.value = (link.lambda + s.hk * (length - link.rest) +
                              s.hb * (length - dot(link.start, link.now))) *
                             s.compliance;
            } else {
                link.present = link.scale * apart;
                link.value = 0.5 * (square * link.scale - link.target);
            }
            worst = std::max(worst, std::abs(link.value) * link.share);
        }
        return worst;
    }

    // --- the tridiagonal system -------------------------------------------------------------

    std::size_t lastLink() const { return count_ - 1; }
    std::size_t middle() const { return count_ / 2; }

    template <bool withSprings>
    double diagonal(std::size_t i) const {
        const double d = links_[i].masses * dot(links_[i].present, links_[i].start);
        return withSprings ? d + springs_[i].compliance : d;
    }
    /// What a multiplier of link i + 1 does to link i, and the other way round.
    double above(std::size_t i) const {
        return -nodes_[i].inverseMass * dot(links_[i].present, links_[i + 1].start);
    }
    double below(std::size_t i) const {
        return -nodes_[i - 1].inverseMass * dot(links_[i].present, links_[i - 1].start);
    }

    double inverseOf(double pivot, std::size_t i) const {
        return std::abs(pivot) > redundantPivot * links_[i].masses ? 1 / pivot : 0;
    }

    template <bool withSprings>
    void factoriseUpTo(std::size_t i) {  // from the first link, i > 1
        ChainFactor& f = factors_[i];
        f.back = below(i);
        f.inverse = inverseOf(diagonal<withSprings>(i) - f.back * factors_[i - 1].ahead, i);
        f.ahead = above(i) * f.inverse;
    }
    template <bool withSprings>
    void factoriseDownTo(std::size_t i) {  // from the last link
        ChainFactor& f = factors_[i];
        f.back = above(i);
        f.inverse = inverseOf(diagonal<withSprings>(i) - f.back * factors_[i + 1].ahead, i);
        f.ahead = below(i) * f.inverse;
    }

    template <bool withSprings>
    void factorise() {
        const std::size_t last = lastLink(), m = middle();
        if (m > 1) {
            factors_[1].inverse = inverseOf(diagonal<withSprings>(1), 1);
            factors_[1].ahead = above(1) * factors_[1].inverse;
        }
        if (last > m) {
            factors_[last].inverse = inverseOf(diagonal<withSprings>(last), last);
            factors_[last].ahead = below(last) * factors_[last].inverse;
        }
        std::size_t up = 2, down = last - 1;
        for (; up < m && down > m; ++up, --down) {
            factoriseUpTo<withSprings>(up);
            factoriseDownTo<withSprings>(down);
        }
        for (; up < m; ++up) factoriseUpTo<withSprings>(up);
        for (; down > m; --down) factoriseDownTo<withSprings>(down);
        double pivot = diagonal<withSprings>(m);
        if (m > 1) pivot -= below(m) * factors_[m - 1].ahead;
        if (m < last) pivot -= above(m) * factors_[m + 1].ahead;
        factors_[m].inverse = inverseOf(pivot, m);
    }

    /// Multipliers for the present values by the factors that there are, and what they push.
    void solve() {
        const std::size_t last = lastLink(), m = middle();
        if (m > 1) factors_[1].right = -links_[1].value * factors_[1].inverse;
        if (m < last) factors_[last].right = -links_[last].value * factors_[last].inverse;
        const auto eliminate = [&](std::size_t i, std::size_t from) {
            ChainFactor& f = factors_[i];
            f.right = (-links_[i].value - f.back * factors_[from].right) * f.inverse;
        };
        std::size_t up = 2, down = last - 1;
        for (; up < m && down > m; ++up, --down) {
            eliminate(up, up - 1);
            eliminate(down, down + 1);
        }
        for (; up < m; ++up) eliminate(up, up - 1);
        for (; down > m; --down) eliminate(down, down + 1);
        double right = -links_[m].value;
        if (m > 1) right -= below(m) * factors_[m - 1].right;
        if (m < last) right -= above(m) * factors_[m + 1].right;
        factors_[m].right = right * factors_[m].inverse;
        substitute();
    }

    void substitute() {
        const std::size_t last = lastLink(), m = middle();
        const auto follow = [&](std::size_t i, std::size_t from) {
            factors_[i].right -= factors_[i].ahead * factors_[from].right;
        };
        std::size_t up = m + 1, down = m - 1;
        for (; up <= last && down >= 1; ++up, --down) {
            follow(down, down + 1);
            follow(up, up - 1);
        }
        for (; up <= last; ++up) follow(up, up - 1);
        for (; down >= 1; --down) follow(down, down + 1);
        Pair before{0, 0};  // what the link before has pushed this node with
        for (std::size_t i = 1; i <= last; ++i) {
            const Pair push = factors_[i].right * links_[i].start;
            links_[i].lambda += factors_[i].right;
            ChainNode& n = nodes_[i - 1];
            n.displacement += n.inverseMass * (before - push);
            before = push;
        }
        ChainNode& end = nodes_[last];
        end.displacement += end.inverseMass * before;
    }

    // --- the step's end ---------------------------------------------------------------------

    /// How far this step was from where SHAKE explodes.
    void judge(Outcome& outcome) const {
        double pullBefore = 0;
        for (std::size_t i = 1; i < count_; ++i) {
            const ChainLink& link = links_[i];
            const double pull = std::abs(link.lambda) * link.inverseLength;
            outcome.whip =
                std::max(outcome.whip, 2 * nodes_[i - 1].inverseMass * (pullBefore + pull));
            pullBefore = pull;
            const double turn = link.start[0] * link.present[1] - link.start[1] * link.present[0];
            outcome.turn = std::max(outcome.turn, std::abs(turn));
            if (dot(link.start, link.present) < 0) outcome.turn = 2;
        }
        outcome.whip = std::max(outcome.whip, 2 * nodes_[lastLink()].inverseMass * pullBefore);
        if (!std::isfinite(outcome.whip)) outcome.converged = false;
    }

    void finishStep(double step) {
        const double rate = 1 / step;
        for (std::size_t i = 0; i < count_; ++i) {
            ChainNode& n = nodes_[i];
            // What the caller has torn apart comes together at the speed limit, not at once.
            n.displacement = limitedTo(maxSpeed * step, n.displacement);
            n.moved += n.displacement;
            if (n.inverseMass > 0) n.velocity = rate * n.displacement;
        }
        const double newtons = rate * resistance(state_, step);
        for (std::size_t i = 1; i < count_; ++i)
            links_[i].impulse += newtons * (links_[i].lambda + (elastic_ ? springs_[i].early : 0));
    }

    bool allFinite() const {
        Pair sum{0, 0};  // of zeros, unless something is not finite
        double impulses = 0;
        for (std::size_t i = 0; i < count_; ++i) sum += 0 * (nodes_[i].moved + nodes_[i].velocity);
        for (std::size_t i = 1; i < count_; ++i) impulses += 0 * links_[i].impulse;
        return sum[0] + sum[1] + impulses == 0;
    }

    void store() {
        Particles& particles = state_.particles;
        for (std::size_t i = 0; i < count_; ++i) {
            const ChainNode& n = nodes_[i];
            const Vec2 moved = Point(n.moved[0], n.moved[1]).cast<Real>();
            state_.trees.predicted[tree_.first + i] = moved;
            const auto p = node(i).particle;
            particles.force[p] = Point(0, 0);
            if (!(n.inverseMass > 0)) continue;
            particles.displacement[p] = moved;
            particles.velocity[p] = Point(n.velocity[0], n.velocity[1]);
        }
        const double perNewton = tick_ / resistance(state_, tick_);
        for (std::size_t i = 1; i < count_; ++i)
            state_.joints.lambda[node(i).link] = static_cast<Real>(links_[i].impulse * perNewton);
    }

    State& state_;
    Tree& tree_;
    std::size_t count_;
    double tick_;
    bool elastic_ = false;
    bool torn_ = false;  // whether a rigid link is not as long as it should be
    ChainNode* nodes_ = nullptr;
    ChainLink* links_ = nullptr;
    ChainSpring* springs_ = nullptr;
    ChainFactor* factors_ = nullptr;
};

}  // namespace

bool stepChain(State& state, Tree& tree) {
    return ChainStepper(state, tree).run();
}

}  // namespace sulfur::detail
