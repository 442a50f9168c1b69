// Networks in the sweeps: what contacts and other constraints push, they answer as a whole.
//
// A network has already arrived at the tick's end. What its links have grown by since then goes
// back along their directions at the end, by Newton's method for the multipliers of all sweeps of
// the step together. Contacts that press are part of the equations, so that what the whole network
// pulls with meets the surface at once.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <utility>

#include "contacts/touch_rows.hpp"
#include "core/settings.hpp"
#include "core/trigonometry.hpp"
#include "model/slow_speeds.hpp"
#include "particles/motion.hpp"
#include "rigid/grip.hpp"
#include "trees/network_contacts.hpp"
#include "trees/networks.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

using Pairs = std::vector<std::array<double, 2>>;

class SweptNetwork {
public:
    SweptNetwork(State& state, const Tree& tree)
        : state_(state),
          tree_(tree),
          factor_(state.trees.factors[tree.network]),
          work_(state.trees.networkSweep),
          count_(tree.last - tree.first),
          links_(tree.lastLink - tree.firstLink),
          contacts_(state, tree),
          places_(&state.arena) {
        work_.inverseMass.resize(count_);
        for (std::size_t i = 0; i < count_; ++i)
            work_.inverseMass[i] = inverseMassOf(state_, node(i));
    }

    void remember() {
        begin();
        for (std::size_t l = 0; l < links_; ++l) met(l) = valueOf(l);
        factor_.given.assign(count_, Freedoms::Zero());
        factor_.answers.clear();
        factor_.work = 0;
        factor_.error = 0;
        factor_.waits = false;
    }

    /// Takes away by how much links have grown longer by blows, along the directions of the step.
    void share(std::span<const Freedoms> given) {
        const auto rows = stepRows(state_, tree_);
        work_.values.assign(links_, {0, 0});
        for (std::size_t l = 0; l < links_; ++l) {
            const NetworkLink& n = link(l);
            if (n.kind == LinkKind::joint && state_.joints.kind[n.link] != JointKind::rigid)
                continue;
            for (std::size_t r = 0; r < 2; ++r)
                work_.values[l][r] =
                    rows[l].here[r].dot(given[n.here]) + rows[l].there[r].dot(given[n.there]);
        }
        work_.nodes.assign(count_, Freedoms::Zero());
        correctNetwork(state_, tree_, rows, stepSystem(state_, tree_), work_.nodes, work_.values);
        work_.nodes.assign(count_, Freedoms::Zero());
        addPulls(rows, work_.values);
        move();
    }

    /// Up to so many passes, unless there is no work left. `loads`: it begins where the nodes would
    /// be without what rows begin with.
    void sweep(int mostPasses = tuned::networkPasses, bool loads = false) {
        begin();
        work_.wanted.assign(links_, {0, 0});
        const auto step = stepRows(state_, tree_);
        work_.rows.assign(step.begin(), step.end());
        for (std::size_t l = 0; l < links_; ++l) stiffen(l);
        work_.lambda.resize(links_);
        const double perNewton = 1 / static_cast<double>(newtonsPerMultiplier(state_));
        for (std::size_t l = 0; l < links_; ++l)
            for (std::size_t r = 0; r < 2; ++r)
                work_.lambda[l][r] = loads ? perNewton * link(l).swept[r]
                                           : state_.trees.linkLambda[tree_.firstLink + l][r];
        if (loads) takeLoadsBack();
        contacts_.list();
        if (loads) contacts_.bound();
        double best = 0, last = 0;
        bool isBest = true;
        for (int pass = 0;; ++pass) {
            const double worst = std::max(evaluate(), contacts_.error());
            const bool done = worst <= tuned::sweptTolerance;
            factor_.error = pass == 0 ? worst : std::min(factor_.error, worst);
            if (pass == 0 && done && !loads) return;
            isBest = pass == 0 || worst < best;
            if (isBest) {
                best = worst;
                keepBest();
            }
            factor_.work += tuned::productsOfNode * (count_ + work_.contacts.size());
            if (done || pass == mostPasses || !std::isfinite(worst)) break;
            if (pass == 0 ? isStale() : isSlow(worst, last, tuned::sweptTolerance)) factorise();
            if (!contacts_.areKnown()) contacts_.findAnswers(factor_.swept);
            last = worst;
            solve();
            advance();
        }
        push(isBest);
    }

    /// Nodes that overlaps push apart take their links along, and what presses on these.
    void settlePushes() {
        bool any = contacts_.overlap();
        work_.residual.assign(count_, Freedoms::Zero());
        for (std::size_t i = 0; i < count_; ++i) {
            if (!(inverseMassAt(i)[0] > 0)) continue;
            const Freedoms push = pushOf(state_, moverOfNode(i));
            any = any || !push.isZero(0);
            for (int k = 0; k < 3; ++k)
                if (inverseMassAt(i)[k] > 0) work_.residual[i][k] = -push[k] / inverseMassAt(i)[k];
        }
        if (!any) return;
        if (isStale()) factorise();
        if (!contacts_.areKnown()) contacts_.findAnswers(factor_.swept);
        work_.wanted.assign(links_, {0, 0});
        correct();
        contacts_.solvePushes(work_.nodes);
        contacts_.addChanges(work_.residual, -1);
        correct();
        for (std::size_t i = 0; i < count_; ++i) placeBy(state_, moverOfNode(i), work_.nodes[i]);
        contacts_.placeBodies();
    }

    /// Where passes have not led to a solution, which a network that is crumpled or pressed beyond
    /// what it can bear may not have: all of it loses what speed it has against what it touches.
    void brakeUnsolved() {
        if (factor_.error <= tuned::brakingTolerable) return;
        ++state_.statistics.chainFallbacks;
        begin();
        contacts_.list();
        contacts_.brake();
        for (std::size_t l = 0; l < links_; ++l)
            state_.trees.linkLambda[tree_.firstLink + l] = {0, 0};
    }

    /// The largest error of a rigid joint's length, as a share of it.
    double strain() {
        begin();
        double most = 0;
        for (std::size_t l = 0; l < links_; ++l) {
            const NetworkLink& n = link(l);
            if (n.kind != LinkKind::joint || state_.joints.kind[n.link] != JointKind::rigid)
                continue;
            most = std::max(most, std::abs(valueOf(l)[0] - met(l)[0]) / sizeOf(l));
        }
        return most;
    }

private:
    const NetworkLink& link(std::size_t l) const { return state_.trees.links[tree_.firstLink + l]; }
    const TreeNode& node(std::size_t i) const { return state_.trees.nodes[tree_.first + i]; }
    std::array<double, 2>& met(std::size_t l) { return state_.trees.linkMet[tree_.firstLink + l]; }
    const Freedoms& inverseMassAt(std::size_t i) const { return work_.inverseMass[i]; }

    /// m, that errors of a link are relative to.
    double sizeOf(std::size_t l) const {
        const NetworkLink& n = link(l);
        return n.kind == LinkKind::joint ? static_cast<double>(state_.joints.restLength[n.link])
                                         : 1.0;
    }

    // --- the links at the end of the step, so far ---------------------------------------------

    struct Place {
        Point at{0, 0}, arm{0, 0};
    };

    /// Nothing has moved yet in these passes.
    void begin() {
        work_.moved.assign(count_, Freedoms::Zero());
        places_.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) places_[i] = placeOf(node(i));
    }

    Point placeOf(const TreeNode& n) const {
        if (n.cluster != none) {
            const Cluster& c = state_.clusters.list[n.cluster];
            return c.centre + c.displacement.cast<double>();
        }
        const Particles& p = state_.particles;
        const auto at = [&](std::uint32_t k) {
            return Point(p.position[k] + p.displacement[k].cast<double>());
        };
        if (n.particle != none) return at(n.particle);
        const Attachment& held = state_.attachments[n.link];
        Point sum(0, 0);
        for (std::uint32_t k = 0; k < held.count; ++k)
            sum += static_cast<double>(held.weight[k]) * at(held.support[k]);
        return sum;
    }

    std::uint32_t moverOfNode(std::size_t i) const {
        const TreeNode& n = node(i);
        if (n.cluster != none) return moverOfCluster(state_, n.cluster);
        return n.particle != none ? moverOfParticle(state_, n.particle) : none;
    }

    void takeLoadsBack() {
        for (std::size_t i = 0; i < count_; ++i) {
            const auto m = moverOfNode(i);
            if (m == none) continue;
            const Motion3& given = state_.core.movers.given[m];
            work_.moved[i] = -Freedoms(static_cast<double>(given.x), static_cast<double>(given.y),
                                       static_cast<double>(given.turn));
        }
    }

    /// The step softens what cannot hold. Sweeps only keep lengths as they are, which can.
    void stiffen(std::size_t l) {
        const NetworkLink& n = link(l);
        if (n.kind == LinkKind::joint && state_.joints.kind[n.link] != JointKind::rigid) return;
        NetworkRow& row = work_.rows[l];
        for (std::size_t r = 0; r < 2; ++r) {
            if (row.stiffness[r] == 0) continue;
            const double mobility = row.here[r].cwiseAbs2().dot(inverseMassAt(n.here)) +
                                    row.there[r].cwiseAbs2().dot(inverseMassAt(n.there));
            row.stiffness[r] =
                std::max(row.stiffness[r], 1 / (tuned::networkCompliance * mobility));
        }
    }

    Place placeOf(std::uint32_t i, const LinkEnd& end) const {
        const Freedoms& more = work_.moved[i];
        const Point centre = places_[i] + more.head<2>();
        if (tree_.points || node(i).cluster == none) return {centre};
        const Cluster& c = state_.clusters.list[node(i).cluster];
        const Point arm = turned(unitVector(c.angle + more[2]), turned(c.heading, end.place));
        return {centre + arm, arm};
    }

    /// A length, or how far apart two places are.
    std::array<double, 2> valueOf(std::size_t l) const {
        const NetworkLink& n = link(l);
        const Point apart = placeOf(n.here, n.atHere).at - placeOf(n.there, n.atThere).at;
        if (n.kind == LinkKind::joint) return {apart.norm(), 0};
        return {apart[0], apart[1]};
    }

    Freedoms along(std::uint32_t i, const Point& direction, const Point& arm) const {
        return ofMovable({direction[0], direction[1], cross(arm, direction)}, inverseMassAt(i));
    }

    /// A link along its present direction, as stiff as in its step; the tension of the sweeps so
    /// far keeps it from being turned. Returns its value.
    std::array<double, 2> updateRow(std::size_t l) {
        const NetworkLink& n = link(l);
        NetworkRow& row = work_.rows[l];
        const Place here = placeOf(n.here, n.atHere), there = placeOf(n.there, n.atThere);
        const Point apart = here.at - there.at;
        if (n.kind != LinkKind::joint) {
            for (std::size_t r = 0; r < 2; ++r) {
                const Point unit = r == 0 ? Point(1, 0) : Point(0, 1);
                row.here[r] = along(n.here, unit, here.arm);
                row.there[r] = -along(n.there, unit, there.arm);
            }
            return {apart[0], apart[1]};
        }
        const double length = apart.norm();
        if (!(length > 1e-12)) return {length, 0};
        const Point direction = apart / length, across = perpendicular(direction);
        row.here[0] = along(n.here, direction, here.arm);
        row.there[0] = -along(n.there, direction, there.arm);
        row.acrossHere = along(n.here, across, here.arm);
        row.acrossThere = -along(n.there, across, there.arm);
        row.tension = std::max(-work_.lambda[l][0], 0.0) / length;
        return {length, 0};
    }

    // --- Newton's method ----------------------------------------------------------------------

    /// Rows, values and residuals where the nodes are now; the largest error, relative to lengths.
    double evaluate() {
        double worst = 0;
        for (std::size_t l = 0; l < links_; ++l) {
            const auto now = updateRow(l);
            for (std::size_t r = 0; r < 2; ++r) {
                const double stiffness = work_.rows[l].stiffness[r];
                if (stiffness == 0) continue;
                work_.wanted[l][r] = now[r] - met(l)[r] + work_.lambda[l][r] / stiffness;
                worst = std::max(worst, std::abs(work_.wanted[l][r]) / sizeOf(l));
            }
        }
        addResiduals();
        for (std::size_t i = 0; i < count_; ++i)
            worst = std::max(worst, inverseMassAt(i).cwiseProduct(work_.residual[i]).norm());
        return std::isfinite(worst) ? worst : std::numeric_limits<double>::infinity();
    }

    /// By how much the nodes' motion differs from what links give along their present directions.
    void addResiduals() {
        work_.nodes.assign(count_, Freedoms::Zero());
        addPulls(work_.rows, work_.lambda);
        contacts_.addPressed(work_.nodes);
        work_.residual.assign(count_, Freedoms::Zero());
        for (std::size_t i = 0; i < count_; ++i) {
            const Freedoms w = inverseMassAt(i);
            for (int k = 0; k < 3; ++k)
                if (w[k] > 0)
                    work_.residual[i][k] =
                        work_.moved[i][k] / w[k] + factor_.given[i][k] - work_.nodes[i][k];
        }
    }

    bool isStale() const {
        if (factor_.tick != state_.tick || factor_.rows.size() != links_) return true;
        for (std::size_t l = 0; l < links_; ++l) {
            const Freedoms turn = work_.rows[l].here[0] - factor_.rows[l].here[0];
            if (!(turn.head<2>().norm() < tuned::factorTurn)) return true;
        }
        return false;
    }

    void factorise() {
        factor_.rows = work_.rows;
        factor_.tick = state_.tick;
        factoriseNetwork(state_, tree_, factor_.rows, factor_.swept);
        factor_.answers.clear();
        factor_.work += priceOf(state_, tree_);
        ++state_.statistics.networkFactors;
    }

    /// First without what contacts change, which then find what they have to.
    void solve() {
        correct();
        contacts_.solve(work_.nodes);
        contacts_.addChanges(work_.residual, -1);
        correct();
    }
    void correct() {
        work_.nodes = work_.residual;
        work_.values = work_.wanted;
        correctNetwork(state_, tree_, factor_.rows, factor_.swept, work_.nodes, work_.values);
    }

    /// No farther than a link's length, for which the directions do not hold at all.
    void advance() {
        double way = 1;
        for (std::size_t l = 0; l < links_; ++l) {
            const Freedoms &here = work_.nodes[link(l).here], &there = work_.nodes[link(l).there];
            way = std::max({way, (here - there).head<2>().norm() / sizeOf(l), std::abs(here[2]),
                            std::abs(there[2])});
        }
        for (std::size_t i = 0; i < count_; ++i) work_.moved[i] += work_.nodes[i] / way;
        for (std::size_t l = 0; l < links_; ++l)
            for (std::size_t r = 0; r < 2; ++r) work_.lambda[l][r] += work_.values[l][r] / way;
        contacts_.advance(1 / way);
    }

    void keepBest() {
        work_.bestLambda = work_.lambda;
        work_.bestMoved = work_.moved;
        contacts_.keepBest();
    }

    // --- the answer ---------------------------------------------------------------------------

    /// To `nodes`: what links push with their multipliers.
    void addPulls(std::span<const NetworkRow> rows, const Pairs& multipliers) {
        for (std::size_t l = 0; l < links_; ++l)
            for (std::size_t r = 0; r < 2; ++r) {
                if (rows[l].stiffness[r] == 0) continue;
                work_.nodes[link(l).here] += multipliers[l][r] * rows[l].here[r];
                work_.nodes[link(l).there] += multipliers[l][r] * rows[l].there[r];
            }
    }

    /// Nodes get what the links give along their directions at the end, and what contacts press.
    void push(bool isBest) {
        if (!isBest) {
            work_.lambda = work_.bestLambda;
            work_.moved = work_.bestMoved;
            for (std::size_t l = 0; l < links_; ++l) updateRow(l);
        }
        for (std::size_t l = 0; l < links_; ++l)
            state_.trees.linkLambda[tree_.firstLink + l] = work_.lambda[l];
        work_.nodes.assign(count_, Freedoms::Zero());
        addPulls(work_.rows, work_.lambda);
        for (std::size_t i = 0; i < count_; ++i) {
            const Freedoms more = work_.nodes[i] - factor_.given[i];
            factor_.given[i] = work_.nodes[i];
            work_.nodes[i] = more;
        }
        contacts_.push(work_.nodes);
        move();
    }

    /// Displacements take up the impulses in `nodes`.
    void move() {
        for (std::size_t i = 0; i < count_; ++i) {
            const TreeNode& n = node(i);
            const Freedoms moved = inverseMassAt(i).cwiseProduct(work_.nodes[i]);
            if (n.cluster != none) {
                Cluster& c = state_.clusters.list[n.cluster];
                c.displacement += moved.head<2>().cast<Real>();
                turnBy(c, moved[2]);
            } else if (n.particle != none) {
                state_.particles.displacement[n.particle] += moved.head<2>().cast<Real>();
            }
        }
    }

    State& state_;
    const Tree& tree_;
    NetworkFactor& factor_;
    NetworkSweep& work_;
    std::size_t count_, links_;
    NetworkContacts contacts_;
    std::pmr::vector<Point> places_;  // m, of nodes before anything has moved
};

}  // namespace

void NetworkSweeper::remember() {
    SweptNetwork(state_, tree_).remember();
}

void NetworkSweeper::share(std::span<const Freedoms> given) {
    SweptNetwork(state_, tree_).share(given);
}

void NetworkSweeper::answerLoads() {
    SweptNetwork(state_, tree_).sweep(tuned::networkPasses, true);
}

void NetworkSweeper::sweep(bool first) {
    NetworkFactor& factor = state_.trees.factors[tree_.network];
    factor.waits = factor.work > productsOfStep(tree_);
    if (factor.waits) return;
    SweptNetwork network(state_, tree_);
    network.sweep();
    if (first) network.settlePushes();
}

void NetworkSweeper::finish() {
    SweptNetwork network(state_, tree_);
    if (std::exchange(state_.trees.factors[tree_.network].waits, false)) network.sweep();
    network.brakeUnsolved();
}

double NetworkSweeper::strain() {
    return SweptNetwork(state_, tree_).strain();
}

void recordNetworkForces(State& state, const Tree& tree) {
    for (auto l = tree.firstLink; l < tree.lastLink; ++l) {
        NetworkLink& n = state.trees.links[l];
        const auto& lambda = state.trees.linkLambda[l];
        for (std::size_t r = 0; r < 2; ++r)
            n.swept[r] = static_cast<double>(newtonsPerMultiplier(state)) * lambda[r];
        if (n.kind == LinkKind::joint) {
            state.joints.lambda[n.link] += static_cast<Real>(lambda[0]);
            continue;
        }
        forceOf(state, n) += newtonsPerMultiplier(state) *
                             Vec2(static_cast<Real>(lambda[0]), static_cast<Real>(lambda[1]));
    }
}

}  // namespace sulfur::detail
