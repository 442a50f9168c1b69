#include "trees/network_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/limits.hpp"
#include "core/settings.hpp"
#include "core/trigonometry.hpp"
#include "particles/motion.hpp"
#include "trees/geometry.hpp"
#include "trees/node_motion.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// Newmark's weight of the step's end.
constexpr double averaged = 0.25;
constexpr double shortest = 1e-12;  // m; a shorter link has no direction

}  // namespace

NetworkEquations::NetworkEquations(State& state, const Tree& tree)
    : state_(state),
      tree_(tree),
      scratch_(state.trees.scratch.network),
      nodes_(state.trees.scratch.step.nodes),
      motion_(state.trees.scratch.step.motion),
      links_(scratch_.links),
      step_(static_cast<double>(state.h)) {}

// --- the step's start ------------------------------------------------------------------------

void NetworkEquations::load() {
    const std::size_t count = tree_.last - tree_.first;
    auto& nodes = state_.trees.scratch.step.nodes;
    nodes.resize(count);
    motion_.resize(count);
    scratch_.inverseMass.resize(count);
    scratch_.sizes.assign(count, 1);
    for (std::size_t i = 0; i < count; ++i) {
        loadNode(state_, node(i), nodes[i]);
        motion_[i] = nodes[i].start;
        scratch_.inverseMass[i] = inverseMassOf(state_, node(i));
        if (nodes[i].inverseMass > 0) mass_ += 1 / nodes[i].inverseMass;
        free_ &= nodes[i].inverseMass > 0;
    }
    scratch_.turned.assign(count, Point(1, 0));
    for (std::size_t i = 0; i < count && !tree_.points; ++i)
        scratch_.turned[i] = unitVector(-step_ * motion_[i].spin);
    links_.resize(tree_.lastLink - tree_.firstLink);
    for (std::size_t l = 0; l < links_.size(); ++l) loadLink(l);
    for (std::size_t l = 0; l < links_.size(); ++l) limitPull(l);
}

Point NetworkEquations::armOf(std::size_t i, const LinkEnd& end) const {
    const auto cluster = node(i).cluster;
    if (cluster == none) return {0, 0};
    return turned(state_.clusters.list[cluster].heading, end.place);
}

void NetworkEquations::loadLink(std::size_t l) {
    const NetworkLink& n = link(l);
    Link& data = links_[l];
    data = {};
    data.start.armHere = armOf(n.here, n.atHere);
    data.start.armThere = armOf(n.there, n.atThere);
    if (n.kind == LinkKind::joint) {
        loadJoint(n.link, data);
    } else {
        data.rows = 2;
        data.size = std::max({data.start.armHere.norm(), data.start.armThere.norm(), 1e-3});
    }
    for (const auto i : {n.here, n.there})
        scratch_.sizes[i] = std::min(scratch_.sizes[i], data.size);
    data.mobility =
        mobilityOf(n.here, data.start.armHere) + mobilityOf(n.there, data.start.armThere);
    data.turnHere = scratch_.inverseMass[n.here][2];
    data.turnThere = scratch_.inverseMass[n.there][2];
    if (data.mobility == 0) data.rows = 0;
    // What can only turn has a mass for its links as well.
    if (data.mobility > 0) mass_ = std::max(mass_, 1 / data.mobility);
    const double perNewton = step_ * step_ / resistance(state_, step_);
    data.warm = {n.pushed[0] * perNewton, n.pushed[1] * perNewton};
    lookBack(n, data);
}

/// Where the link is, and where it was a step earlier.
void NetworkEquations::lookBack(const NetworkLink& n, Link& data) const {
    const Motion &here = motion_[n.here], &there = motion_[n.there];
    data.start.apart = (here.place - there.place) + (data.start.armHere - data.start.armThere);
    data.before.armHere = turned(scratch_.turned[n.here], data.start.armHere);
    data.before.armThere = turned(scratch_.turned[n.there], data.start.armThere);
    data.before.apart = data.start.apart - step_ * (here.velocity - there.velocity) +
                        (data.before.armHere - data.start.armHere) -
                        (data.before.armThere - data.start.armThere);
    data.length = data.start.apart.norm();
}

void NetworkEquations::loadJoint(std::uint32_t j, Link& data) const {
    const Joints& joints = state_.joints;
    data.rest = static_cast<double>(joints.restLength[j]);
    data.elastic.rigid = joints.kind[j] == JointKind::rigid;
    const double perPush = step_ / resistance(state_, step_);
    data.elastic.hk = (static_cast<double>(joints.stiffness[j]) -
                       static_cast<double>(joints.explicitStiffness[j])) *
                      step_ * perPush;
    data.elastic.hb = static_cast<double>(joints.damping[j] - joints.explicitDamping[j]) * perPush;
    data.rows = 1;
    data.size = std::max(data.rest, 1e-3);
}

/// 1/kg, in the direction in which a node moves most easily at that arm.
double NetworkEquations::mobilityOf(std::size_t i, const Point& arm) const {
    const Freedoms& w = scratch_.inverseMass[i];
    return w[0] + w[2] * arm.squaredNorm();
}

/// What cannot hold pulls no harder than would stop all masses at once at the speed at which it
/// closes, times by how much it is too long, so that in the end all are stretched alike.
void NetworkEquations::limitPull(std::size_t l) {
    Link& data = links_[l];
    const bool joint = link(l).kind == LinkKind::joint;
    const double error = joint ? data.length - data.rest : data.length;
    const double speed = closingSpeedOf(link(l).kind);
    const double left = joint && !data.elastic.rigid ? 0 : errorLeft(error, step_, speed);
    torn_ |= left != 0;
    data.left = {left, 0};
    if (!joint && left > 0)
        data.left = {left / data.length * data.start.apart[0],
                     left / data.length * data.start.apart[1]};
    const double asked = std::abs(error) - std::abs(left);
    const double share = joint ? data.rest / std::max(data.length, data.rest) : 1;
    data.least = std::max(tuned::networkCompliance * data.mobility,
                          share * asked / (mass_ * closingSpeed * step_));
}

void NetworkEquations::begin(Way way) {
    way_ = way;
    couple_ = 0;
    for (Link& data : links_) {
        if (way == Way::projects) data.warm = {0, 0};
        data.lambda = data.warm;
    }
}

// --- at the present displacements ------------------------------------------------------------

double NetworkEquations::evaluate() {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const bool solves = way_ != Way::projects;
    double worst = 0;
    auto& residual = scratch_.nodes;
    residual.assign(motion_.size(), Freedoms::Zero());
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        const Motion& m = motion_[i];
        const Freedoms change =
            Freedoms(m.displacement[0], m.displacement[1], m.turning) - scratch_.predicted[i];
        if (!change.allFinite()) return endless;
        const Freedoms& w = scratch_.inverseMass[i];
        for (int k = 0; k < 3; ++k)
            if (solves && w[k] > 0) residual[i][k] = change[k] / w[k];
        if (!tree_.points) scratch_.turned[i] = unitVector(m.turning);
    }
    for (std::size_t l = 0; l < links_.size(); ++l) {
        updateLink(l);
        const Link& data = links_[l];
        for (int r = 0; r < data.rows; ++r) {
            const auto k = static_cast<std::size_t>(r);
            if (!std::isfinite(data.value[k])) return endless;
            worst = std::max(worst, std::abs(data.value[k]) / data.size);
            if (!solves) continue;
            residual[link(l).here] -= data.lambda[k] * data.here[k];
            residual[link(l).there] -= data.lambda[k] * data.there[k];
        }
    }
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        const Freedoms off = scratch_.inverseMass[i].cwiseProduct(residual[i]);
        worst = std::max({worst, off.head<2>().norm() / scratch_.sizes[i], std::abs(off[2])});
        if (!off.allFinite()) return endless;
    }
    return worst;
}

/// The share of the average by which a pull takes part in what the step does. What pushes explodes
/// sideways by itself; it goes only so far that the matrix stays positive.
double NetworkEquations::shareOf(double pushed, double mobility) const {
    const double share = way_ == Way::keeps ? averaged : 1;
    return pushed > 0 ? std::min(share, averaged / (pushed * mobility)) : share;
}

[[gnu::always_inline]] inline Point NetworkEquations::average(const Point& before,
                                                              const Point& start, const Point& now,
                                                              double share) const {
    if (way_ == Way::projects) return now;
    if (way_ == Way::brakes) return start + share * (now - start);
    return start + share * ((now - start) + (before - start));
}

/// How a distance along `direction` changes with the freedoms that a node has.
[[gnu::always_inline]] inline Freedoms NetworkEquations::along(std::size_t i,
                                                               const Point& direction,
                                                               const Point& arm) const {
    return ofMovable({direction[0], direction[1], cross(arm, direction)}, scratch_.inverseMass[i]);
}

void NetworkEquations::updateLink(std::size_t l) {
    const NetworkLink& n = link(l);
    Link& data = links_[l];
    if (data.rows == 0) return;
    const Motion &here = motion_[n.here], &there = motion_[n.there];
    Span& now = data.now;
    now.apart = data.start.apart + (here.displacement - there.displacement);
    if (!tree_.points) {
        now.armHere = turned(scratch_.turned[n.here], data.start.armHere);
        now.armThere = turned(scratch_.turned[n.there], data.start.armThere);
        now.apart += (now.armHere - data.start.armHere) - (now.armThere - data.start.armThere);
    }
    if (n.kind == LinkKind::joint)
        updateJoint(n, data);
    else
        updateMeeting(n, data);
}

void NetworkEquations::updateJoint(const NetworkLink& n, Link& data) {
    const double length = data.now.apart.norm(), lambda = data.lambda[0];
    data.share = shareOf(data.warm[0] / std::max(data.length, shortest), data.mobility);
    const Point mean = average(data.before.apart, data.start.apart, data.now.apart, data.share);
    const double size = mean.norm();
    data.direction = size > shortest ? Point(mean / size) : Point(1, 0);
    setArms(data, data.warm[0] * data.direction);
    data.here[0] = along(n.here, data.direction, data.meanHere);
    data.there[0] = -along(n.there, data.direction, data.meanThere);
    const double error = length - data.rest - data.left[0];
    data.compliance = std::max(complianceOf(data.elastic), data.least);
    data.value[0] = data.elastic.rigid || data.compliance == data.least
                        ? error + data.compliance * lambda
                        : valueOf(data.elastic, error, length - data.length, lambda);
}

void NetworkEquations::updateMeeting(const NetworkLink& n, Link& data) {
    setArms(data, Point(data.warm[0], data.warm[1]));
    data.compliance = data.least;
    for (std::size_t r = 0; r < 2; ++r) {
        const Point unit = r == 0 ? Point(1, 0) : Point(0, 1);
        data.here[r] = along(n.here, unit, data.meanHere);
        data.there[r] = -along(n.there, unit, data.meanThere);
        data.value[r] = data.now.apart[static_cast<Eigen::Index>(r)] - data.left[r] +
                        data.compliance * data.lambda[r];
    }
}

/// The arms at which a push of `push` acts on the node here, and against it on the other.
void NetworkEquations::setArms(Link& data, const Point& push) {
    if (tree_.points) return;
    data.shareHere = shareOf(-push.dot(data.start.armHere), data.turnHere);
    data.shareThere = shareOf(push.dot(data.start.armThere), data.turnThere);
    data.meanHere =
        average(data.before.armHere, data.start.armHere, data.now.armHere, data.shareHere);
    data.meanThere =
        average(data.before.armThere, data.start.armThere, data.now.armThere, data.shareThere);
}

bool NetworkEquations::hasTurned() const {
    for (std::size_t l = 0; l < links_.size(); ++l) {
        const Link& data = links_[l];
        const NetworkRow& row = state_.trees.rows[tree_.firstLink + l];
        for (int r = 0; r < data.rows; ++r) {
            const auto k = static_cast<std::size_t>(r);
            const Freedoms here = data.here[k] - row.here[k];
            const Freedoms there = data.there[k] - row.there[k];
            const double turn = std::max(here.head<2>().norm(), there.head<2>().norm());
            const double lever = std::max(std::abs(here[2]), std::abs(there[2])) / data.size;
            if (!(std::max(turn, lever) <= tuned::factorTurn)) return true;
        }
    }
    return false;
}

/// What pushes resists being turned by less than nothing, but not so much that the matrix would no
/// longer be positive.
NetworkRow NetworkEquations::rowOf(std::size_t l) const {
    const NetworkLink& n = link(l);
    const Link& data = links_[l];
    NetworkRow row;
    if (data.rows == 0) return row;
    row.here = data.here;
    row.there = data.there;
    row.stiffness = {1 / data.compliance, data.rows == 2 ? 1 / data.compliance : 0};
    if (way_ == Way::projects) return row;
    Point push(data.lambda[0], data.lambda[1]);
    if (data.rows == 1) {
        push = data.lambda[0] * data.direction;
        const Point across = perpendicular(data.direction);
        row.acrossHere = along(n.here, across, data.meanHere);
        row.acrossThere = -along(n.there, across, data.meanThere);
        row.tension = std::max(-data.share * data.lambda[0] / std::max(data.length, shortest),
                               -averaged / data.mobility);
    }
    if (data.turnHere > 0)
        row.turnHere =
            std::max(data.shareHere * push.dot(data.meanHere), -averaged / data.turnHere);
    if (data.turnThere > 0)
        row.turnThere =
            std::max(-data.shareThere * push.dot(data.meanThere), -averaged / data.turnThere);
    return row;
}

// --- the solution ----------------------------------------------------------------------------

/// What is projected goes no farther than directions hold.
void NetworkEquations::advance(const std::vector<Freedoms>& nodes,
                               const std::vector<std::array<double, 2>>& multipliers) {
    double excess = 1;
    for (std::size_t l = 0; l < links_.size() && way_ == Way::projects; ++l) {
        const Freedoms &here = nodes[link(l).here], &there = nodes[link(l).there];
        const double goes = (here - there).head<2>().norm() / links_[l].size;
        const double turns = std::max(std::abs(here[2]), std::abs(there[2]));
        excess = std::max({excess, goes / tuned::projectedTurn, turns / tuned::projectedTurn});
    }
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        motion_[i].displacement += nodes[i].head<2>() / excess;
        motion_[i].turning += nodes[i][2] / excess;
    }
    for (std::size_t l = 0; l < links_.size(); ++l) {
        const std::array<double, 2> change{multipliers[l][0] / excess, multipliers[l][1] / excess};
        for (int r = 0; r < links_[l].rows; ++r)
            links_[l].lambda[static_cast<std::size_t>(r)] += change[static_cast<std::size_t>(r)];
        if (free_) couple_ += coupleOf(l, state_.trees.rows[tree_.firstLink + l], change);
    }
}

/// By which pulls along a row turn the whole, from where its nodes are when the step begins.
double NetworkEquations::coupleOf(std::size_t l, const NetworkRow& row,
                                  const std::array<double, 2>& lambda) const {
    const Point apart = motion_[link(l).here].place - motion_[link(l).there].place;
    double sum = 0;
    for (std::size_t r = 0; r < 2; ++r)
        sum += lambda[r] * (cross(apart, row.here[r].head<2>()) + row.here[r][2] + row.there[r][2]);
    return sum;
}

void NetworkEquations::keepBest() {
    for (Link& data : links_) data.best = data.lambda;
    scratch_.best = motion_;
    bestCouple_ = couple_;
}

void NetworkEquations::takeBest(bool useful) {
    if (useful) motion_ = scratch_.best;  // which may be that of another network otherwise
    couple_ = useful ? bestCouple_ : 0;
    for (Link& data : links_) data.lambda = useful ? data.best : std::array<double, 2>{0, 0};
    for (std::size_t i = 0; i < motion_.size() && !useful; ++i) {
        motion_[i].displacement = scratch_.predicted[i].head<2>();
        motion_[i].turning = scratch_.predicted[i][2];
    }
    evaluate();
    settle();
}

void NetworkEquations::settle() {
    if (way_ != Way::projects) {
        auto& given = scratch_.nodes;
        given = scratch_.predicted;
        couple_ = 0;
        for (std::size_t l = 0; l < links_.size(); ++l) {
            const NetworkLink& n = link(l);
            const Link& data = links_[l];
            for (int r = 0; r < data.rows; ++r) {
                const auto k = static_cast<std::size_t>(r);
                given[n.here] +=
                    data.lambda[k] * scratch_.inverseMass[n.here].cwiseProduct(data.here[k]);
                given[n.there] +=
                    data.lambda[k] * scratch_.inverseMass[n.there].cwiseProduct(data.there[k]);
            }
            if (!free_) continue;
            NetworkRow row;
            row.here = data.here;
            row.there = data.there;
            couple_ += coupleOf(l, row, data.lambda);
        }
        for (std::size_t i = 0; i < motion_.size(); ++i) {
            motion_[i].displacement = given[i].head<2>();
            motion_[i].turning = given[i][2];
        }
    }
    if (free_) turnBack();
}

/// Directions are not quite those between the ends when the step begins, so that pulls leave a
/// small couple. Of a network that nothing holds it is given back by turning the whole where it is
/// when the step ends, which changes no length.
void NetworkEquations::turnBack() {
    const auto mean = [&](auto&& placeOf) {
        Point sum(0, 0);
        for (std::size_t i = 0; i < motion_.size(); ++i)
            sum += placeOf(motion_[i]) / (nodes_[i].inverseMass * mass_);
        return sum;
    };
    const auto start = [](const Motion& m) { return m.place; };
    const auto end = [](const Motion& m) { return Point(m.place + m.displacement); };
    const Point startCentre = mean(start), endCentre = mean(end);
    double inertia = 0;
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        const Point from = start(motion_[i]) - startCentre, to = end(motion_[i]) - endCentre;
        inertia += from.dot(to) / nodes_[i].inverseMass;
        if (nodes_[i].inverseInertia > 0) inertia += 1 / nodes_[i].inverseInertia;
    }
    if (!(inertia > 0)) return;
    const double turn = -couple_ / inertia;
    for (std::size_t i = 0; i < motion_.size(); ++i) {
        motion_[i].displacement += turn * perpendicular(Point(end(motion_[i]) - endCentre));
        if (nodes_[i].inverseInertia > 0) motion_[i].turning += turn;
    }
}

}  // namespace sulfur::detail
