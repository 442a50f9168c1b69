// A tree in the sweeps: one on which something else pulls, or a line through a mesh.
//
// A tree that moves alone has already arrived at the tick's end; what contacts push then, it
// answers with the masses and directions that it has there. A line through a mesh is solved like
// one rigid joint among others: along its directions at the tick's start.
#pragma once

#include <algorithm>
#include <array>
#include <memory_resource>
#include <span>
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

    /// Notes how far apart the ends of links are where the prediction has led them.
    void remember() {
        for (std::size_t i = 1; i < count_; ++i) {
            const Point apart = spanOf(i, true).apart;
            state_.trees.met[tree_.first + i] = {apart[0], apart[1]};
        }
    }

    /// `given`: displacement and angle of each node by impacts. Takes away by how much links have
    /// grown longer by them, along their directions when the step begins. (At the step's end a link
    /// that an impact has turned by much would be solved along a wrong one.)
    void share(std::span<const Freedoms> given) {
        oppose(given, false);
        for (std::size_t i = 0; i < count_; ++i) apply(i);
    }

    /// The same for what nobody has given yet, along the directions that the links have now: of
    /// each node what is left of it.
    void answer(std::span<Freedoms> given) {
        oppose(given, true);
        addSolution(given);
    }

    /// Links answer what rows begin with before nodes get it, along the directions that they have
    /// then: it would throw a light node so far that its links would point anywhere. Where they
    /// would not hold it, rows take it back.
    void answerLoads() {
        auto& begins = state_.trees.scratch.begins;
        begins.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) begins[i] = beginsWith(node(i));
        const auto isNothing = [](const Freedoms& b) { return b.isZero(0); };
        if (std::all_of(begins.begin(), begins.end(), isNothing)) return;
        for (std::size_t i = 1; i < count_; ++i) updateLink(i, begins);
        solver_.solve();
        // Once more, with the tensions that this has found.
        bool anyPulls = false;
        for (std::size_t i = 1; i < count_; ++i)
            anyPulls |= keepFromTurning(i, -solver_.links[i].lambda[0], begins);
        if (anyPulls) solver_.solve();
        addSolution(begins);
        if (!holdsWith(begins)) return;
        for (std::size_t i = 0; i < count_; ++i) apply(i);
        addMultipliers();
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
            keepFromTurning(i, pullsSoFar(i));
            addContact(i);
        }
        solver_.solve();
        const double most = held_.empty() ? 0 : mostPressingNow();
        for (int k = 0; k < tuned::mostReleases && releaseContacts(most); ++k) solver_.solve();
        for (std::size_t i = 0; i < count_; ++i) apply(i);
        for (const auto i : held_) pushContact(i, std::exchange(solver_.links[i].lambda[1], 0));
        addMultipliers();
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

    /// How far the ends of a link part by what their nodes are given.
    Point partingBy(std::span<const Freedoms> given, std::size_t i, const Span& span) const {
        const auto at = [](const Freedoms& b, const Point& arm) {
            return Point(b.head<2>() + b[2] * Point(-arm[1], arm[0]));
        };
        return at(given[i], span.armHere) - at(given[node(i).parent], span.armThere);
    }

    /// Finds the impulses at which rigid links do not grow by what is given.
    void oppose(std::span<const Freedoms> given, bool now) {
        for (std::size_t i = 1; i < count_; ++i) {
            const TreeNode& n = node(i);
            auto& link = solver_.links[i];
            link.parent = n.parent;
            link.rows = 0;
            const Span span = spanOf(i, now);
            const Point parting = partingBy(given, i, span);
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
    }

    /// What the rows of a node begin with and have not given yet.
    Freedoms beginsWith(const TreeNode& n) const {
        const auto m = n.cluster != none    ? moverOfCluster(state_, n.cluster)
                       : n.particle != none ? moverOfParticle(state_, n.particle)
                                            : none;
        if (m == none) return Freedoms::Zero();
        const SolverBody& body = state_.core.movers.bodies[m];
        const Motion3& given = state_.core.movers.given[m];
        Freedoms begins = Freedoms::Zero();
        if (body.inverseMass > 0)
            begins.head<2>() = Vec2(body.vx - given.x, body.vy - given.y).cast<double>();
        if (body.inverseInertia > 0) begins[2] = static_cast<double>(body.spin - given.turn);
        return begins;
    }

    void addSolution(std::span<Freedoms> given) const {
        for (std::size_t i = 0; i < count_; ++i)
            for (int k = 0; k < N; ++k)
                given[i][k] += solver_.nodes[i].inverseMass[k] * solver_.nodes[i].impulse[k];
    }

    void addMultipliers() {
        for (std::size_t i = 1; i < count_; ++i) {
            auto& sum = state_.trees.lambda[tree_.first + i];
            for (std::size_t r = 0; r < 2; ++r)
                if (static_cast<int>(r) < solver_.links[i].rows)
                    sum[r] += solver_.links[i].lambda[r];
        }
    }

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

    /// `given`: what nodes are about to get, or nothing.
    void updateLink(std::size_t i, std::span<const Freedoms> given = {}) {
        const TreeNode& n = node(i);
        auto& link = solver_.links[i];
        link.parent = n.parent;
        link.rows = 0;
        Span now = spanOf(i, true);
        const Point parting = given.empty() ? Point(0, 0) : partingBy(given, i, now);
        const auto& noted = state_.trees.met[tree_.first + i];
        const Point met(noted[0], noted[1]);
        if (n.kind != LinkKind::joint) {
            now.apart += parting;
            setMeeting<N>(link, now, now);
            Point wanted = met;
            if (!tree_.alone) {
                const Point apart = spanOf(i, false).apart;
                const double gap = apart.norm();
                const double h = static_cast<double>(state_.h);
                const double left = errorLeft(gap, h, closingSpeedOf(n.kind));
                if (left > 0) wanted = left / gap * apart;
            }
            link.value[0] -= wanted[0];
            link.value[1] -= wanted[1];
            return;
        }
        lengthNow_ = now.apart.norm();
        if (!(lengthNow_ > 1e-12)) return;
        const Span start = tree_.alone ? Span{} : spanOf(i, false);
        const Point from = tree_.alone ? met : start.apart;
        const double before = from.norm();
        Point direction = now.apart / lengthNow_;
        // Ends that a contact has sent past each other come back the way that they went.
        if (direction.dot(from) < -0.9 * before) {
            direction = -direction;
            lengthNow_ = -lengthNow_;
        }
        const bool asAtStart = !tree_.alone && before > 1e-12 &&
                               whip(n.link, before) < tuned::sweptWhip &&
                               direction.dot(from) > 0.5 * before;
        setDistance<N>(link, asAtStart ? start : now, now,
                       asAtStart ? Point(from / before) : direction, direction);
        lengthNow_ += direction.dot(parting);
        setValue(i, before);
    }

    /// kg m, tension that this step has found so far.
    double pullsSoFar(std::size_t i) const { return -state_.trees.lambda[tree_.first + i][0]; }

    /// A second row of a joint that pulls: when it is turned from the direction that the prediction
    /// has led it to, it pulls along the new one. Without, a light node of a taut rope would be as
    /// if it were free, and contacts would throw it to and fro from step to step. Returns whether
    /// there is one.
    bool keepFromTurning(std::size_t i, double pulls, std::span<const Freedoms> given = {}) {
        auto& link = solver_.links[i];
        const bool isJoint = link.rows > 0 && node(i).kind == LinkKind::joint;
        if (!isJoint || !tree_.alone || !(pulls > 0)) return false;
        const auto& noted = state_.trees.met[tree_.first + i];
        const Point met(noted[0], noted[1]);
        const double length = met.norm(), compliance = length / pulls;
        if (!(length > 1e-12) || !std::isfinite(compliance)) return false;
        const Span now = spanOf(i, true);
        const Point across = perpendicular(Point(met / length));
        Point apart = now.apart;
        if (!given.empty()) apart += partingBy(given, i, now);
        link.rows = 2;
        link.rowHere[1] = link.columnHere[1] = rowAlong<N>(across, now.armHere);
        link.rowThere[1] = link.columnThere[1] = -rowAlong<N>(across, now.armThere);
        link.compliance[1] = compliance;
        link.value[1] = across.dot(apart) + compliance * state_.trees.lambda[tree_.first + i][1];
        return true;
    }

    /// Whether rigid links keep their lengths when nodes get that, and no arm turns far.
    bool holdsWith(std::span<const Freedoms> given) const {
        for (const Freedoms& g : given)
            if (!(std::abs(g[2]) <= tuned::largestTurn)) return false;
        for (std::size_t i = 1; i < count_; ++i) {
            const TreeNode& n = node(i);
            if (n.kind != LinkKind::joint || state_.joints.kind[n.link] != JointKind::rigid)
                continue;
            const Span now = spanOf(i, true);
            const double before = now.apart.norm();
            const double after = (now.apart + partingBy(given, i, now)).norm();
            if (!(std::abs(after - before) <= tuned::brakingTolerable * before)) return false;
        }
        return true;
    }

    /// A contact that presses on a node of points, or on the capsule of its joint, is the second
    /// row of that link, so that what the whole tree pulls with meets the surface at once. The
    /// other side's mobility stands in the place of a compliance, as many times as the tree touches
    /// it (mass splitting: Tonge, Benevolenski and Voroshilov 2012).
    void addContact(std::size_t i) {
        const auto at = state_.trees.contact[tree_.first + i];
        const bool hasLength = solver_.links[i].rows > 0 && node(i).kind == LinkKind::joint;
        if (at != none && hasLength) addTouch(i, at);
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
        const double other = static_cast<double>(t.normal.inverseMass) - own;
        link.compliance[1] = touching_ * std::max(other, 0.0) + tuned::softest * own;
        if (other > tuned::softest * own) touchingMass_ += 1 / other;  // less is rounding
        held_.push_back(static_cast<std::uint32_t>(i));
    }
    static Point directionOf(const TouchView& t, std::uint32_t particle) {
        Point sum(0, 0);
        for (std::size_t k = 0; k < 3 && particle != none; ++k)
            if (t.particles[k] == particle) sum += t.normal.ways[k].cast<double>();
        return sum;
    }

    /// The most that a contact may press with in this sweep: what takes part brings no more.
    double mostPressingNow() const {
        double mass = touchingMass_, closing = 0;
        for (const auto& n : solver_.nodes)
            if (n.inverseMass[0] > 0) mass += 1 / n.inverseMass[0];
        const auto close = [&](std::size_t i, std::size_t r) {
            if (static_cast<int>(r) < solver_.links[i].rows)
                closing = std::max(closing, std::abs(solver_.links[i].value[r]));
        };
        for (std::size_t i = 1; i < count_; ++i) {
            close(i, 0);
            if (node(i).kind != LinkKind::joint) close(i, 1);
        }
        for (const auto i : held_) close(i, 1);
        return mostPressing(state_, mass, closing);
    }

    /// Contacts that would have to pull are let go, and those that would have to press beyond all
    /// measure, for links that cannot hold beside them. Returns whether there were any.
    bool releaseContacts(double most) {
        const auto isWrong = [&](std::uint32_t i) {
            const auto touch = state_.trees.contact[tree_.first + i];
            const double change = solver_.links[i].lambda[1];
            return static_cast<double>(pressingOf(state_, touch)) + change < 0 || change > most;
        };
        return std::erase_if(held_, [&](std::uint32_t i) {
                   if (!isWrong(i)) return false;
                   updateLink(i);
                   keepFromTurning(i, pullsSoFar(i));
                   return true;
               }) > 0;
    }

    /// What the tree's side of the contact got with the links' impulses, the other side gets here.
    void pushContact(std::size_t i, double lambda) {
        const auto touch = state_.trees.contact[tree_.first + i];
        const double change = std::max(lambda, -static_cast<double>(pressingOf(state_, touch)));
        const bool isCorner = particlesOfTouch(state_, touch)[0] == node(i).particle;
        pressFromOutside(state_, touch, static_cast<Real>(change), 0,
                         {isCorner, !isCorner, !isCorner});
    }

    double whip(std::uint32_t joint, double length) const {
        const auto& w = state_.particles.inverseMass;
        const Joints& joints = state_.joints;
        const double h = static_cast<double>(state_.h);
        return 2 * static_cast<double>(std::max(w[joints.a[joint]], w[joints.b[joint]])) *
               std::abs(static_cast<double>(joints.force[joint])) * h * h / length;
    }

    /// `before`: m, its length as predicted, for trees that move alone, or when the step began.
    void setValue(std::size_t i, double before) {
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
            tree_.alone ? before : rest + (elastic.rigid ? errorLeft(before - rest, h) : 0);
        link.compliance[0] = complianceOf(elastic);
        link.value[0] = valueOf(elastic, lengthNow_ - wanted, lengthNow_ - before,
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
    double touching_ = 0;      // contacts of the tree
    double touchingMass_ = 0;  // kg, of what they press on
    double lengthNow_ = 0;  // of the link that was updated last; negative when its ends have passed
    std::vector<std::uint32_t>& held_ = state_.trees.scratch.held;
};

}  // namespace sulfur::detail
