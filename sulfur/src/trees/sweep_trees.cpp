// Trees in the sweeps: those on which something else pulls, and lines through meshes.
//
// A tree that moves alone has already arrived at the tick's end; what contacts push then, it
// answers with the masses and directions that it has there. A line through a mesh is solved like
// one rigid joint among others: along its directions at the tick's start.
#include <algorithm>
#include <utility>
#include <vector>

#include "contacts/touch_rows.hpp"
#include "core/limits.hpp"
#include "core/settings.hpp"
#include "core/trigonometry.hpp"
#include "particles/motion.hpp"
#include "rigid/grip.hpp"
#include "trees/geometry.hpp"
#include "trees/networks.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// A line whose light nodes whip more than this in a tick pulls along its present directions.
constexpr double mostWhip = tuned::sweptWhip;

using tuned::mostReleases;
using tuned::softest;

/// What impacts have given to a node.
struct Blown {
    Point way{0, 0};  // m
    double turn = 0;  // rad
};

template <int N>
class TreeSweeper {
public:
    TreeSweeper(State& state, std::uint32_t tree)
        : state_(state),
          tree_(state.trees.list[tree]),
          solver_(state.trees.scratch.elimination<N>()),
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

    /// `given`: displacement and angle of each node by impacts. Takes away by how much links have
    /// grown longer by them, along their directions when the step begins. (At the step's end a link
    /// that an impact has turned by much would be solved along a wrong one.)
    void share(const std::pmr::vector<Blown>& given) {
        for (std::size_t i = 1; i < count_; ++i) {
            const TreeNode& n = node(i);
            auto& link = solver_.links[i];
            link.parent = n.parent;
            link.rows = 0;
            const Span span = spanOf(i, false);
            const auto& here = given[tree_.first + i];
            const auto& there = given[tree_.first + n.parent];
            const auto at = [](const Blown& b, const Point& arm) {
                return Point(b.way + b.turn * Point(-arm[1], arm[0]));
            };
            const Point parting = at(here, span.armHere) - at(there, span.armThere);
            if (n.kind != LinkKind::joint) {
                setMeeting<N>(link, span, span);
                link.value = {parting[0], parting[1]};
                continue;
            }
            const double length = span.apart.norm();
            if (state_.joints.kind[n.link] != JointKind::rigid || !(length > 1e-12)) continue;
            const Point direction = span.apart / length;
            setDistance<N>(link, span, span, direction, direction);
            link.value = {direction.dot(parting), 0};
            link.compliance = {0, 0};
        }
        solver_.solve();
        for (std::size_t i = 0; i < count_; ++i) apply(i);
    }

    void sweep() {
        held_.clear();
        held_.reserve(count_);  // at once, so that a later step that presses more allocates nothing
        const auto first = state_.trees.contact.begin() + tree_.first;
        touching_ = static_cast<double>(
            std::count_if(first, first + static_cast<std::ptrdiff_t>(count_),
                          [](std::uint32_t contact) { return contact != none; }));
        for (std::size_t i = 1; i < count_; ++i) {
            updateLink(i);
            addContact(i);
        }
        solver_.solve();
        for (int k = 0; k < mostReleases && releaseContacts(); ++k) solver_.solve();
        for (std::size_t i = 0; i < count_; ++i) apply(i);
        for (std::size_t i = 1; i < count_; ++i) {
            const auto& link = solver_.links[i];
            const bool joint = node(i).kind == LinkKind::joint;
            if (link.rows == 2 && joint) pushContact(i, link.lambda[1]);
            for (std::size_t r = 0; r < 2; ++r)
                if (static_cast<int>(r) < link.rows && !(joint && r == 1))
                    state_.trees.lambda[tree_.first + i][r] += link.lambda[r];
        }
    }

    /// The largest error of a rigid joint's length, as a share of it.
    double strain() {
        double most = 0;
        for (std::size_t i = 1; i < count_; ++i) {
            const TreeNode& n = node(i);
            if (n.kind != LinkKind::joint || state_.joints.kind[n.link] != JointKind::rigid)
                continue;
            updateLink(i);
            if (solver_.links[i].rows == 0) continue;  // without a direction it has no value
            const double rest = static_cast<double>(state_.joints.restLength[n.link]);
            most = std::max(most, std::abs(solver_.links[i].value[0]) / rest);
        }
        return most;
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
        Point direction = now.apart / lengthNow_;
        // Ends that a contact has sent past each other come back the way that they went.
        if (direction.dot(start.apart) < -0.9 * before) {
            direction = -direction;
            lengthNow_ = -lengthNow_;
        }
        const bool asAtStart = !tree_.alone && before > 1e-12 && whip(n.link, before) < mostWhip &&
                               direction.dot(start.apart) > 0.5 * before;
        setDistance<N>(link, asAtStart ? start : now, now,
                       asAtStart ? Point(start.apart / before) : direction, direction);
        setValue(i, before, met[0]);
    }

    /// A contact that presses on a node of points, or on the capsule of its joint, is a second row
    /// of that link, so that what the whole tree pulls with meets the surface at once. The other
    /// side's mobility stands in the place of a compliance, as many times as the tree touches it
    /// (mass splitting: Tonge, Benevolenski and Voroshilov 2012).
    void addContact(std::size_t i) {
        const auto at = state_.trees.contact[tree_.first + i];
        auto& link = solver_.links[i];
        if (at == none || link.rows != 1) return;
        addTouch(i, at);
    }

    void addTouch(std::size_t i, std::uint32_t touch) {
        auto& link = solver_.links[i];
        const TouchView t = viewOfTouch(state_, touch);
        if (t.pressing <= 0 && t.gap >= 0) return;
        const Point here = directionOf(t, node(i).particle),
                    there = directionOf(t, node(node(i).parent).particle);
        link.rows = 2;
        link.rowHere[1] = link.columnHere[1] = rowAlong<N>(here, Point(0, 0));
        link.rowThere[1] = link.columnThere[1] = rowAlong<N>(there, Point(0, 0));
        // What overlaps already is pushed apart elsewhere.
        link.value[1] =
            static_cast<double>(t.gap) - std::min(static_cast<double>(t.gapBefore), 0.0);
        const double own = here.squaredNorm() * solver_.nodes[i].inverseMass[0] +
                           there.squaredNorm() * solver_.nodes[link.parent].inverseMass[0];
        const double other = static_cast<double>(t.inverseMass) - own;
        link.compliance[1] = touching_ * std::max(other, 0.0) + softest * own;
        held_.push_back(static_cast<std::uint32_t>(i));
    }
    static Point directionOf(const TouchView& t, std::uint32_t particle) {
        Point sum(0, 0);
        for (std::size_t k = 0; k < 3 && particle != none; ++k)
            if (t.particles[k] == particle) sum += t.directions[k].cast<double>();
        return sum;
    }

    /// Contacts that would have to pull are let go. Returns whether there were any.
    bool releaseContacts() {
        const auto pulls = [&](std::uint32_t i) {
            const auto touch = state_.trees.contact[tree_.first + i];
            return static_cast<double>(pressingOf(state_, touch)) + solver_.links[i].lambda[1] < 0;
        };
        const auto kept =
            std::partition(held_.begin(), held_.end(), [&](std::uint32_t i) { return !pulls(i); });
        if (kept == held_.end()) return false;
        for (auto i = kept; i != held_.end(); ++i) solver_.links[*i].rows = 1;
        held_.erase(kept, held_.end());
        return true;
    }

    /// What the tree's side of the contact got with the links' impulses, the other side gets here.
    void pushContact(std::size_t i, double lambda) {
        const auto touch = state_.trees.contact[tree_.first + i];
        const double change = std::max(lambda, -static_cast<double>(pressingOf(state_, touch)));
        const bool isCorner = particlesOfTouch(state_, touch)[0] == node(i).particle;
        pressFromOutside(state_, touch, static_cast<Real>(change), isCorner, !isCorner);
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
        const double h = static_cast<double>(state_.h), perPush = h / resistance(state_, h);
        Elastic elastic;
        elastic.rigid = joints.kind[j] == JointKind::rigid;
        elastic.hk = (static_cast<double>(joints.stiffness[j]) -
                      static_cast<double>(joints.explicitStiffness[j])) *
                     h * perPush;
        elastic.hb = static_cast<double>(joints.damping[j] - joints.explicitDamping[j]) * perPush;
        const double rest = static_cast<double>(joints.restLength[j]);
        const double wanted =
            tree_.alone ? met : rest + (elastic.rigid ? errorLeft(before - rest, h) : 0);
        link.compliance[0] = complianceOf(elastic);
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
    double touching_ = 0;   // contacts of the tree
    double lengthNow_ = 0;  // of the link that was updated last; negative when its ends have passed
    std::vector<std::uint32_t>& held_ = state_.trees.scratch.held;
};

template <class Function>
void withSweeper(State& state, std::uint32_t tree, Function&& f) {
    if (state.trees.list[tree].points) {
        TreeSweeper<2> sweeper(state, tree);
        f(sweeper);
    } else {
        TreeSweeper<3> sweeper(state, tree);
        f(sweeper);
    }
}

void pull(State& state, const Grip& grip) {
    Trees& trees = state.trees;
    const auto tree =
        grip.cluster != none ? trees.ofCluster[grip.cluster] : trees.ofParticle[grip.particle];
    if (tree != none) trees.touched[tree] = Trees::pulled;
}

/// Whether the `number`-th sweep over rows has stirred a node, or what touches its link.
bool isStirred(const State& state, const Tree& tree, int number) {
    const auto& stirred = state.core.stirred;
    const auto isNow = [&](std::uint32_t m) { return m != none && stirred[m] >= number; };
    for (auto k = tree.first; k < tree.last; ++k) {
        const TreeNode& n = state.trees.nodes[k];
        if (n.cluster != none && isNow(moverOfCluster(state, n.cluster))) return true;
        if (n.particle != none && isNow(moverOfParticle(state, n.particle))) return true;
        const auto touch = state.trees.contact[k];
        if (touch == none) continue;
        const auto movers = moversOfTouch(state, touch);
        if (std::any_of(movers.begin(), movers.end(), isNow)) return true;
    }
    return false;
}

const std::vector<Freedoms>& blownNodes(State& state, std::uint32_t tree,
                                        const std::pmr::vector<Blown>& given) {
    auto& nodes = state.trees.networkSweep.moved;
    nodes.clear();
    for (auto k = state.trees.list[tree].first; k < state.trees.list[tree].last; ++k)
        nodes.emplace_back(given[k].way[0], given[k].way[1], given[k].turn);
    return nodes;
}

}  // namespace

void touchTrees(State& state) {
    Trees& trees = state.trees;
    trees.touchedAlone.clear();
    trees.networkTouches.clear();
    trees.touchedAlone.reserve(state.work.lonelyTrees.size());
    if (trees.list.empty()) return;
    trees.touched.assign(trees.list.size(), 0);
    trees.linkMet.assign(trees.links.size(), {0, 0});
    trees.linkLambda.assign(trees.links.size(), {0, 0});
    const auto& tied = state.work.tiedTrees;
    trees.met.assign(trees.nodes.size(), {0, 0});
    trees.lambda.assign(trees.nodes.size(), {0, 0});
    giveContacts(state);
    for (std::size_t k = 0; k < state.core.awakeMovers.size(); ++k) {
        if (state.core.movers.colours[state.core.awakeMovers[k]] == 0) continue;
        const auto i = state.core.awakeDense[k];
        const auto tree = state.core.awakeIsCluster[k] ? trees.ofCluster[i] : trees.ofParticle[i];
        if (tree != none) trees.touched[tree] = 1;
    }
    for (const Lead& lead : state.core.leads) {
        const BodyRecord& body = state.bodies[lead.body];
        for (auto p = body.firstParticle; p < body.firstParticle + body.particles.size(); ++p)
            pull(state, gripOf(state, p));
    }
    for (const Grab& grab : state.influences.grabs)
        for (std::uint32_t k = 0; k < grab.count; ++k)
            pull(state, gripOf(state, state.particleSlots.dense(grab.support[k])));
    for (const auto i : tied) trees.touched[i] = Trees::pulled;
    for (const auto i : state.work.lonelyTrees) {
        if (!trees.touched[i]) continue;
        trees.touchedAlone.push_back(i);
        if (trees.list[i].network != none)
            rememberNetwork(state, trees.list[i]);
        else
            withSweeper(state, i, [](auto& s) { s.remember(); });
    }
}

void shareBlows(State& state) {
    const ContactCore& core = state.core;
    if (core.blows.empty() || state.trees.touchedAlone.empty()) return;
    std::pmr::vector<Blown> ofParticle(state.particles.size(), &state.arena),
        ofCluster(state.clusters.list.size(), &state.arena);
    for (const Blow& blow : core.blows) {
        const auto i = core.denseOfMover[blow.mover];
        Blown& sum = core.moverIsCluster[blow.mover] != 0 ? ofCluster[i] : ofParticle[i];
        sum.way += blow.velocity.cast<double>();
        sum.turn += static_cast<double>(blow.spin);
    }
    std::pmr::vector<Blown> given(state.trees.nodes.size(), &state.arena);
    for (const auto tree : state.trees.touchedAlone) {
        bool any = false;
        for (auto k = state.trees.list[tree].first; k < state.trees.list[tree].last; ++k) {
            const TreeNode& n = state.trees.nodes[k];
            if (n.cluster != none)
                given[k] = ofCluster[n.cluster];
            else if (n.particle != none)
                given[k] = ofParticle[n.particle];
            any = any || given[k].turn != 0 || !given[k].way.isZero(0);
        }
        if (!any) continue;
        if (state.trees.list[tree].network != none)
            shareInNetwork(state, state.trees.list[tree], blownNodes(state, tree, given));
        else
            withSweeper(state, tree, [&](auto& s) { s.share(given); });
    }
}

void sweepTrees(State& state, int number) {
    const auto sweep = [&](std::uint32_t i) {
        if (state.trees.list[i].network != none)
            sweepNetwork(state, state.trees.list[i]);
        else
            withSweeper(state, i, [](auto& s) { s.sweep(); });
    };
    for (const auto i : state.work.lines) sweep(i);
    const Trees& trees = state.trees;
    for (const auto i : trees.touchedAlone)
        if (number == 1 || trees.touched[i] == Trees::pulled ||
            isStirred(state, trees.list[i], number))
            sweep(i);
}

double strainOfTrees(State& state) {
    double most = 0;
    const auto look = [&](std::uint32_t tree) {
        if (state.trees.list[tree].network != none)
            most = std::max(most, strainOfNetwork(state, state.trees.list[tree]));
        else
            withSweeper(state, tree, [&](auto& s) { most = std::max(most, s.strain()); });
    };
    for (const auto i : state.trees.touchedAlone) look(i);
    for (const auto i : state.work.lines)
        if (state.trees.touched[i]) look(i);
    return most;
}

void recordTreeForces(State& state) {
    const Trees& trees = state.trees;
    Joints& joints = state.joints;
    const auto record = [&](const Tree& tree) {
        if (tree.network != none) return recordNetworkForces(state, tree);
        for (auto k = tree.first + 1; k < tree.last; ++k) {
            const TreeNode& n = trees.nodes[k];
            if (n.kind != LinkKind::joint) {
                const Vec2 pushed(static_cast<Real>(trees.lambda[k][0]),
                                  static_cast<Real>(trees.lambda[k][1]));
                Vec2& force = forceOf(state, n);
                if (!tree.alone) force = Vec2(0, 0);
                force += Real(n.turned ? -1 : 1) * newtonsPerMultiplier(state) * pushed;
                continue;
            }
            const Real swept = static_cast<Real>(trees.lambda[k][0]);
            joints.lambda[n.link] = tree.alone ? joints.lambda[n.link] + swept : swept;
        }
    };
    for (const auto i : state.work.lines) record(trees.list[i]);
    for (const auto i : trees.touchedAlone) record(trees.list[i]);
}

void updateTreeVelocities(State& state) {
    const double h = static_cast<double>(state.h);
    for (const auto i : state.trees.touchedAlone) {
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
