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
#include "particles/motion.hpp"
#include "rigid/grip.hpp"
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
          links_(tree.lastLink - tree.firstLink) {
        work_.inverseMass.resize(count_);
        for (std::size_t i = 0; i < count_; ++i)
            work_.inverseMass[i] = inverseMassOf(state_, node(i));
    }

    void remember() {
        work_.moved.assign(count_, Freedoms::Zero());
        for (std::size_t l = 0; l < links_; ++l) met(l) = valueOf(l);
        factor_.given.assign(count_, Freedoms::Zero());
        factor_.work = 0;
        factor_.waits = false;
    }

    /// Takes away by how much links have grown longer by blows, along the directions of the step.
    void share(std::span<const Freedoms> given) {
        const NetworkRows rows = stepRows(state_, tree_);
        work_.values.assign(links_, {0, 0});
        for (std::size_t l = 0; l < links_; ++l) {
            const NetworkLink& n = link(l);
            if (n.kind == LinkKind::joint && state_.joints.kind[n.link] != JointKind::rigid)
                continue;
            for (std::size_t r = 0; r < 2; ++r)
                work_.values[l][r] = rows.links[l].here[r].dot(given[n.here]) +
                                     rows.links[l].there[r].dot(given[n.there]);
        }
        work_.nodes.assign(count_, Freedoms::Zero());
        correctNetwork(state_, tree_, rows, stepSystem(state_, tree_), work_.nodes, work_.values);
        work_.nodes.assign(count_, Freedoms::Zero());
        addPulls(rows.links, work_.values);
        move();
    }

    /// Up to so many passes, unless there is no work left.
    void sweep(int mostPasses = tuned::networkPasses) {
        work_.moved.assign(count_, Freedoms::Zero());
        work_.wanted.assign(links_, {0, 0});
        const auto first = state_.trees.linkLambda.begin() + tree_.firstLink;
        work_.lambda.assign(first, first + static_cast<std::ptrdiff_t>(links_));
        listPressed();
        double best = 0, last = 0;
        for (int pass = 0;; ++pass) {
            const double worst = evaluate();
            if (pass == 0 && worst == 0 && work_.contacts.empty()) return;
            // What contacts press is no part of the first error.
            const bool done = pass > 0 && worst <= tuned::sweptTolerance;
            if (pass == 0 || worst < best || done) {
                best = std::max(worst, tuned::sweptTolerance);
                keepBest();
            }
            factor_.work += tuned::productsOfNode * (count_ + work_.contacts.size());
            if (done || pass == mostPasses || !(worst < 1e2 * best)) break;
            if (pass == 0 ? isStale() : isSlow(worst, last, tuned::sweptTolerance)) factorise();
            last = worst;
            solve();
            for (int k = 0; k < tuned::mostReleases && release(); ++k) solve();
            advance();
        }
        push();
    }

    /// The largest error of a rigid joint's length, as a share of it.
    double strain() {
        work_.moved.assign(count_, Freedoms::Zero());
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

    Place placeOf(std::uint32_t i, const LinkEnd& end) const {
        const TreeNode& n = node(i);
        const Freedoms& more = work_.moved[i];
        if (n.cluster != none) {
            const Cluster& c = state_.clusters.list[n.cluster];
            const Point arm = turned(unitVector(c.angle + more[2]), turned(c.heading, end.place));
            return {c.centre + c.displacement.cast<double>() + more.head<2>() + arm, arm};
        }
        const Particles& p = state_.particles;
        const auto at = [&](std::uint32_t k) {
            return Point(p.position[k] + p.displacement[k].cast<double>());
        };
        if (n.particle != none) return {at(n.particle) + more.head<2>()};
        const Attachment& held = state_.attachments[n.link];
        Place sum;
        for (std::uint32_t k = 0; k < held.count; ++k)
            sum.at += static_cast<double>(held.weight[k]) * at(held.support[k]);
        return sum;
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
    /// far keeps it from being turned.
    NetworkRow rowOf(std::size_t l) const {
        const NetworkLink& n = link(l);
        NetworkRow row = stepRows(state_, tree_).links[l];
        const Place here = placeOf(n.here, n.atHere), there = placeOf(n.there, n.atThere);
        if (n.kind != LinkKind::joint) {
            for (std::size_t r = 0; r < 2; ++r) {
                const Point unit = r == 0 ? Point(1, 0) : Point(0, 1);
                row.here[r] = along(n.here, unit, here.arm);
                row.there[r] = -along(n.there, unit, there.arm);
            }
            return row;
        }
        const Point apart = here.at - there.at;
        const double length = apart.norm();
        if (!(length > 1e-12)) return row;
        const Point direction = apart / length, across = perpendicular(direction);
        row.here[0] = along(n.here, direction, here.arm);
        row.there[0] = -along(n.there, direction, there.arm);
        row.acrossHere = along(n.here, across, here.arm);
        row.acrossThere = -along(n.there, across, there.arm);
        row.tension = std::max(-work_.lambda[l][0], 0.0) / length;
        return row;
    }

    // --- Newton's method ----------------------------------------------------------------------

    /// Rows, values and residuals where the nodes are now; the largest error, relative to lengths.
    double evaluate() {
        double worst = 0;
        work_.rows.clear();
        for (std::size_t l = 0; l < links_; ++l) {
            work_.rows.push_back(rowOf(l));
            const auto now = valueOf(l);
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
        for (const PressedRow& row : work_.contacts) {
            work_.nodes[row.here] += row.pressed * row.alongHere;
            if (row.there != none) work_.nodes[row.there] += row.pressed * row.alongThere;
        }
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
        if (factor_.tick != state_.tick || factor_.pressing != work_.pressing ||
            factor_.rows.size() != links_)
            return true;
        for (std::size_t l = 0; l < links_; ++l) {
            const Freedoms turn = work_.rows[l].here[0] - factor_.rows[l].here[0];
            if (!(turn.head<2>().norm() < tuned::factorTurn)) return true;
        }
        return false;
    }

    void factorise() {
        factor_.rows = work_.rows;
        factor_.tick = state_.tick;
        factor_.pressing = work_.pressing;
        factoriseNetwork(state_, tree_, {factor_.rows, work_.contacts}, factor_.swept);
        factor_.work += priceOf(state_, tree_);
        ++state_.statistics.networkFactors;
    }

    void solve() {
        work_.nodes = work_.residual;
        work_.values = work_.wanted;
        for (PressedRow& row : work_.contacts) {
            row.value =
                row.gap + row.alongHere.dot(work_.moved[row.here]) + row.pressed / row.stiffness;
            if (row.there != none) row.value += row.alongThere.dot(work_.moved[row.there]);
        }
        correctNetwork(state_, tree_, {factor_.rows, work_.contacts}, factor_.swept, work_.nodes,
                       work_.values);
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
        for (PressedRow& row : work_.contacts) row.pressed += row.value / way;
    }

    void keepBest() {
        work_.bestLambda = work_.lambda;
        work_.bestMoved = work_.moved;
        for (PressedRow& row : work_.contacts) row.best = row.pressed;
    }

    // --- contacts -----------------------------------------------------------------------------

    /// Contacts that press. The other side's mobility stands in the place of a compliance, as many
    /// times as the network touches something (mass splitting: Tonge, Benevolenski and Voroshilov
    /// 2012).
    void listPressed() {
        work_.contacts.clear();
        work_.pressing.clear();
        const auto& all = state_.trees.networkTouches;
        const auto isBefore = [](const NetworkTouch& a, std::uint32_t n) { return a.network < n; };
        const auto first = std::lower_bound(all.begin(), all.end(), tree_.network, isBefore);
        auto last = first;
        while (last != all.end() && last->network == tree_.network) ++last;
        const auto touching = static_cast<double>(last - first);
        for (auto held = first; held != last; ++held) addPressed(*held, touching);
    }

    void addPressed(const NetworkTouch& held, double touching) {
        const TouchView t = viewOfTouch(state_, held.touch);
        if (t.pressing <= 0 && t.gap >= 0) return;
        PressedRow row;
        row.touch = held.touch;
        row.here = held.here;
        row.there = held.there;
        row.alongHere = alongOf(t, held.here);
        double own = row.alongHere.squaredNorm() * inverseMassAt(held.here)[0];
        if (held.there != none) {
            row.alongThere = alongOf(t, held.there);
            own += row.alongThere.squaredNorm() * inverseMassAt(held.there)[0];
        }
        const double other = std::max(static_cast<double>(t.inverseMass) - own, 0.0);
        row.stiffness = 1 / (touching * other + tuned::softest * own);
        // What overlaps already is pushed apart elsewhere.
        row.gap = static_cast<double>(t.gap) - std::min(static_cast<double>(t.gapBefore), 0.0);
        work_.contacts.push_back(row);
        work_.pressing.push_back(held.touch);
    }
    Freedoms alongOf(const TouchView& t, std::uint32_t i) const {
        Freedoms sum(0, 0, 0);
        for (std::size_t k = 0; k < 3; ++k)
            if (node(i).particle == t.particles[k]) sum.head<2>() += t.directions[k].cast<double>();
        return sum;
    }

    /// Contacts that would have to pull are let go. Returns whether there were any.
    bool release() {
        const auto pulls = [&](const PressedRow& row) {
            return static_cast<double>(pressingOf(state_, row.touch)) + row.pressed + row.value < 0;
        };
        if (std::erase_if(work_.contacts, pulls) == 0) return false;
        work_.pressing.clear();
        for (const PressedRow& row : work_.contacts) work_.pressing.push_back(row.touch);
        factorise();
        return true;
    }

    // --- the answer ---------------------------------------------------------------------------

    /// To `nodes`: what links push with their multipliers.
    void addPulls(std::span<const NetworkRow> rows, const Pairs& multipliers) {
        for (std::size_t l = 0; l < links_; ++l)
            for (std::size_t r = 0; r < 2; ++r) {
                work_.nodes[link(l).here] += multipliers[l][r] * rows[l].here[r];
                work_.nodes[link(l).there] += multipliers[l][r] * rows[l].there[r];
            }
    }

    /// Nodes get what the links give along their directions at the end, and what contacts press.
    void push() {
        work_.lambda = work_.bestLambda;
        work_.moved = work_.bestMoved;
        for (std::size_t l = 0; l < links_; ++l) {
            work_.rows[l] = rowOf(l);
            state_.trees.linkLambda[tree_.firstLink + l] = work_.lambda[l];
        }
        work_.nodes.assign(count_, Freedoms::Zero());
        addPulls(work_.rows, work_.lambda);
        for (std::size_t i = 0; i < count_; ++i) {
            const Freedoms more = work_.nodes[i] - factor_.given[i];
            factor_.given[i] = work_.nodes[i];
            work_.nodes[i] = more;
        }
        for (const PressedRow& row : work_.contacts) pushContact(row);
        move();
    }

    /// What the network's side of a contact gets, the other side gets too.
    void pushContact(const PressedRow& row) {
        const double change =
            std::max(row.best, -static_cast<double>(pressingOf(state_, row.touch)));
        work_.nodes[row.here] += change * row.alongHere;
        if (row.there != none) work_.nodes[row.there] += change * row.alongThere;
        const bool isCorner = particlesOfTouch(state_, row.touch)[0] == node(row.here).particle;
        pressFromOutside(state_, row.touch, static_cast<Real>(change), isCorner, !isCorner);
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
};

}  // namespace

void NetworkSweeper::remember() {
    SweptNetwork(state_, tree_).remember();
}

void NetworkSweeper::share(std::span<const Freedoms> given) {
    SweptNetwork(state_, tree_).share(given);
}

void NetworkSweeper::sweep() {
    NetworkFactor& factor = state_.trees.factors[tree_.network];
    factor.waits = factor.work > productsOfStep(tree_);
    if (!factor.waits) SweptNetwork(state_, tree_).sweep();
}

void NetworkSweeper::finish() {
    if (std::exchange(state_.trees.factors[tree_.network].waits, false))
        SweptNetwork(state_, tree_).sweep(tuned::factorPasses);
}

double NetworkSweeper::strain() {
    return SweptNetwork(state_, tree_).strain();
}

void recordNetworkForces(State& state, const Tree& tree) {
    for (auto l = tree.firstLink; l < tree.lastLink; ++l) {
        const NetworkLink& n = state.trees.links[l];
        const auto& lambda = state.trees.linkLambda[l];
        if (n.kind == LinkKind::joint) {
            state.joints.lambda[n.link] += static_cast<Real>(lambda[0]);
            continue;
        }
        forceOf(state, n) += newtonsPerMultiplier(state) *
                             Vec2(static_cast<Real>(lambda[0]), static_cast<Real>(lambda[1]));
    }
}

}  // namespace sulfur::detail
