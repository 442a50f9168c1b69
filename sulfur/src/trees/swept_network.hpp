// A network in the sweeps: Newton's method for its links, with what contacts press on its nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <utility>
#include <vector>

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

/// Begins in each pass where its nodes are, which its links keep at their lengths.
class SweptNetwork {
public:
    SweptNetwork(State& state, const Tree& tree, NetworkMember& work)
        : state_(state),
          tree_(tree),
          factor_(state.trees.factors[tree.network]),
          work_(work),
          count_(tree.last - tree.first),
          links_(tree.lastLink - tree.firstLink),
          places_(&state.arena) {
        work_.inverseMass.resize(count_);
        for (std::size_t i = 0; i < count_; ++i)
            work_.inverseMass[i] = inverseMassOf(state_, node(i));
    }

    void remember() {
        begin();
        for (std::size_t l = 0; l < links_; ++l) met(l) = valueOf(l);
        factor_.given.assign(count_, Freedoms::Zero());
        factor_.settled.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) factor_.settled[i] = motionOf(node(i));
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

    /// Passes begin where the last ones have ended: what pushes nodes from outside would fling a
    /// light one farther than the directions of its links hold. `loads`: of what rows begin with.
    void load(bool loads) {
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
        for (std::size_t i = 0; i < count_; ++i)
            work_.moved[i] = ofMovable(factor_.settled[i] - motionOf(node(i)), inverseMassAt(i));
    }

    /// Rows and values where the nodes are now, and what links pull; the largest error, relative to
    /// lengths.
    double evaluateLinks() {
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
        work_.nodes.assign(count_, Freedoms::Zero());
        addPulls(work_.rows, work_.lambda);
        return std::isfinite(worst) ? worst : std::numeric_limits<double>::infinity();
    }
    /// By how much the nodes' motion differs from what links and contacts give along their present
    /// directions. Returns the largest, m.
    double findResiduals() {
        double worst = 0;
        work_.residual.assign(count_, Freedoms::Zero());
        for (std::size_t i = 0; i < count_; ++i) {
            const Freedoms w = inverseMassAt(i);
            for (int k = 0; k < 3; ++k)
                if (w[k] > 0)
                    work_.residual[i][k] =
                        work_.moved[i][k] / w[k] + factor_.given[i][k] - work_.nodes[i][k];
            worst = std::max(worst, w.cwiseProduct(work_.residual[i]).norm());
        }
        return std::isfinite(worst) ? worst : std::numeric_limits<double>::infinity();
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
        ++state_.statistics.networkFactors;
    }
    void correct() {
        work_.nodes = work_.residual;
        work_.values = work_.wanted;
        correctNetwork(state_, tree_, factor_.rows, factor_.swept, work_.nodes, work_.values);
    }

    /// In lengths of a link: beyond one the directions do not hold at all.
    double farthest() const {
        double way = 0;
        for (std::size_t l = 0; l < links_; ++l) {
            const Freedoms &here = work_.nodes[link(l).here], &there = work_.nodes[link(l).there];
            way = std::max({way, (here - there).head<2>().norm() / sizeOf(l), std::abs(here[2]),
                            std::abs(there[2])});
        }
        return way;
    }
    void advance(double share) {
        for (std::size_t i = 0; i < count_; ++i) work_.moved[i] += share * work_.nodes[i];
        for (std::size_t l = 0; l < links_; ++l)
            for (std::size_t r = 0; r < 2; ++r) work_.lambda[l][r] += share * work_.values[l][r];
    }
    void keepBest() {
        work_.bestLambda = work_.lambda;
        work_.bestMoved = work_.moved;
    }
    void takeBest() {
        work_.lambda = work_.bestLambda;
        work_.moved = work_.bestMoved;
        for (std::size_t l = 0; l < links_; ++l) updateRow(l);
    }
    /// Nodes get what the links give along their directions at the end.
    void push() {
        for (std::size_t l = 0; l < links_; ++l)
            state_.trees.linkLambda[tree_.firstLink + l] = work_.lambda[l];
        work_.nodes.assign(count_, Freedoms::Zero());
        addPulls(work_.rows, work_.lambda);
        for (std::size_t i = 0; i < count_; ++i) {
            factor_.settled[i] = motionOf(node(i)) + work_.moved[i];
            const Freedoms more = work_.nodes[i] - factor_.given[i];
            factor_.given[i] = work_.nodes[i];
            work_.nodes[i] = more;
        }
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

    /// What nodes are pushed by without a velocity. Returns whether there is any.
    bool loadPushes() {
        bool any = false;
        work_.residual.assign(count_, Freedoms::Zero());
        work_.wanted.assign(links_, {0, 0});
        for (std::size_t i = 0; i < count_; ++i) {
            if (!(inverseMassAt(i)[0] > 0)) continue;
            const Freedoms push = pushOf(state_, moverOfNode(i));
            any = any || !push.isZero(0);
            for (int k = 0; k < 3; ++k)
                if (inverseMassAt(i)[k] > 0) work_.residual[i][k] = -push[k] / inverseMassAt(i)[k];
        }
        return any;
    }
    void place() {
        for (std::size_t i = 0; i < count_; ++i) placeBy(state_, moverOfNode(i), work_.nodes[i]);
    }
    void forgetMultipliers() {
        for (std::size_t l = 0; l < links_; ++l)
            state_.trees.linkLambda[tree_.firstLink + l] = {0, 0};
    }
    std::size_t nodes() const { return count_; }
    std::uint64_t budget() const { return productsOfStep(tree_); }
    std::uint64_t price() const { return priceOf(state_, tree_); }

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

    Freedoms motionOf(const TreeNode& n) const {
        if (n.cluster != none) {
            const Cluster& c = state_.clusters.list[n.cluster];
            const Point way = c.displacement.cast<double>();
            return {way[0], way[1], c.angle};
        }
        if (n.particle == none) return Freedoms::Zero();
        const Point way = state_.particles.displacement[n.particle].cast<double>();
        return {way[0], way[1], 0};
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

    /// To `nodes`: what links push with their multipliers.
    void addPulls(std::span<const NetworkRow> rows,
                  const std::vector<std::array<double, 2>>& multipliers) {
        for (std::size_t l = 0; l < links_; ++l)
            for (std::size_t r = 0; r < 2; ++r) {
                if (rows[l].stiffness[r] == 0) continue;
                work_.nodes[link(l).here] += multipliers[l][r] * rows[l].here[r];
                work_.nodes[link(l).there] += multipliers[l][r] * rows[l].there[r];
            }
    }

    State& state_;
    const Tree& tree_;
    NetworkFactor& factor_;
    NetworkMember& work_;
    std::size_t count_, links_;
    std::pmr::vector<Point> places_;  // m, of nodes before anything has moved
};

}  // namespace sulfur::detail
