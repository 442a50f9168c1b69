#include "rigid/cluster_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/limits.hpp"
#include "core/pieces.hpp"
#include "core/trigonometry.hpp"
#include "kernels/cluster_motion.hpp"
#include "rigid/disc_turns.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

/// No member may be faster than any particle may.
double limitedSpin(const Cluster& c, double spin) {
    if (std::abs(spin) * c.reach <= maxSpeed) return spin;  // (mostly, and without a division)
    return std::copysign(maxSpeed / c.reach, spin);
}

/// The motion of a rigid body with the momentum and angular momentum that its particles have.
void adopt(const State& state, Cluster& cluster) {
    const Particles& p = state.particles;
    Point momentum(0, 0);
    double angular = 0;
    for (std::uint32_t k = cluster.first; k < cluster.last; ++k) {
        const auto i = state.clusters.members[k];
        if (p.pinned[i]) continue;
        const Point mv = static_cast<double>(p.mass[i]) * p.velocity[i];
        momentum += mv;
        angular += cross(turned(cluster.heading, state.clusters.places[k]), mv);
    }
    cluster.velocity = cluster.freeInverseMass * momentum;
    if (!isDisc(cluster)) cluster.spin = cluster.freeInverseInertia * angular;
    cluster.stirred = 0;
}

/// Calls f for clusters of a list, in pieces: no two have a member in common.
template <class Function>
void forEachCluster(State& state, const std::vector<std::uint32_t>& list, Function&& f) {
    constexpr std::size_t inMicrosecond = 150;
    inPieces(state.tasks, list.size(), inMicrosecond, [&](std::size_t first, std::size_t last) {
        for (auto k = first; k < last; ++k) f(state.clusters.list[list[k]]);
    });
}

/// Air friction by the trapezoidal rule, as for particles.
struct AirFriction {
    explicit AirFriction(const State& state) {
        const double kick = (state.lastStep + static_cast<double>(state.h)) / 2;
        const double half = kick * static_cast<double>(state.settings.airFriction) / 2;
        keep = (1 - half) / (1 + half);
        push = kick / (1 + half);
    }
    double keep, push;
};

/// All but its sine and versine.
void predictCluster(State& state, Cluster& c, const AirFriction& air) {
    const ClusterLoad load = c.inverseMass > 0 && !state.anyForced
                                 ? ClusterLoad{state.settings.gravity.cast<double>(), 0}
                                 : loadOf(state, c);
    c.velocity = limited(air.keep * c.velocity + air.push * load.acceleration);
    c.spin = limitedSpin(c, air.keep * c.spin + air.push * load.turning);
    c.displacement = c.predicted = (static_cast<double>(state.h) * c.velocity).cast<Real>();
    c.angle = c.predictedAngle = static_cast<double>(state.h) * c.spin;
}

/// Neighbours in a list of clusters, as many as kernels take at once.
class Block {
public:
    Block(State& state, const std::uint32_t* indices, std::size_t count)
        : clusters_(state.clusters.list.data()), indices_(indices), count_(count) {}

    std::size_t size() const { return count_; }
    Cluster& operator[](std::size_t k) const { return clusters_[indices_[k]]; }

private:
    Cluster* clusters_;
    const std::uint32_t* indices_;
    std::size_t count_;
};

/// A number for each cluster of a block, and zeros behind them.
template <class Number>
using PerCluster = std::array<Number, clusterBlock>;

/// Calls f(const Block&) for the clusters of a list, in pieces.
template <class Function>
void forEachBlock(State& state, const std::vector<std::uint32_t>& list, Function&& f) {
    constexpr std::size_t inMicrosecond = 80;
    inPieces(state.tasks, list.size(), inMicrosecond, [&](std::size_t first, std::size_t last) {
        for (; first < last; first += clusterBlock)
            f(Block(state, list.data() + first, std::min(clusterBlock, last - first)));
    });
}

/// After angles were set: their sines and versines.
void updateTurns(const Block& block) {
    PerCluster<double> half{};
    PerCluster<Real> sine, versine;
    for (std::size_t k = 0; k < block.size(); ++k) half[k] = block[k].angle / 2;
    clusterKernels().sines(half.data(), sine.data(), versine.data(), block.size());
    for (std::size_t k = 0; k < block.size(); ++k) {
        block[k].sine = sine[k];
        block[k].versine = versine[k];
    }
}

MemberView membersOf(State& state) {
    Particles& p = state.particles;
    return {p.position.data()->data(),
            p.velocity.data()->data(),
            p.force.data()->data(),
            p.displacement.data()->data(),
            p.arm.data()->data(),
            state.clusters.members.data(),
            state.clusters.places.data()->data()};
}

/// Headings and centres at the end of the tick. Discs remember the heading at its beginning: they
/// have no members that could tell how they turned.
void move(const Block& block, bool isFirst) {
    PerCluster<double> angle{}, x{}, y{};
    for (std::size_t k = 0; k < block.size(); ++k) {
        const Cluster& c = block[k];
        angle[k] = c.angle + c.twist;
        x[k] = c.heading[0];
        y[k] = c.heading[1];
    }
    clusterKernels().turn(angle.data(), x.data(), y.data(), block.size());
    for (std::size_t k = 0; k < block.size(); ++k) {
        Cluster& c = block[k];
        if (isFirst || !isDisc(c)) c.headingBefore = c.heading;
        c.heading = Point(x[k], y[k]);
        c.twist = 0;
        c.centreBefore = c.centre;
        c.centre += c.displacement.cast<double>() + c.shift.cast<double>();
        c.centre = c.centre.cwiseMax(-maxCoordinate).cwiseMin(maxCoordinate);
        c.shift = Vec2(0, 0);
    }
}

ClusterPose poseOf(const Cluster& c) {
    return {c.first,
            c.last,
            c.centre[0],
            c.centre[1],
            c.heading[0],
            c.heading[1],
            c.centreBefore[0],
            c.centreBefore[1],
            c.headingBefore[0],
            c.headingBefore[1],
            c.velocity[0],
            c.velocity[1],
            c.spin};
}

ClusterWay wayOf(const Cluster& c) {
    return {c.first, c.last, c.displacement[0], c.displacement[1], c.sine, c.versine};
}

}  // namespace

ClusterLoad loadOf(const State& state, const Cluster& c) {
    if (c.inverseMass == 0 && c.inverseInertia == 0) return {};
    const Particles& p = state.particles;
    const Point gravity = state.settings.gravity.cast<double>();
    Point force(0, 0);
    double torque = 0;
    for (std::uint32_t k = c.first; k < c.last && state.anyForced; ++k) {
        const auto i = state.clusters.members[k];
        const Point& f = p.force[i];
        force += f;
        torque += cross(p.arm[i].cast<double>(), f);
    }
    if (state.anyForced && isDisc(c)) torque += torqueOn(state, c);
    // What turns about its centre of mass falls as gravity has it; what is pinned only turns.
    const bool isFree = c.freeInverseMass > 0;
    if (!isFree) torque += cross(turned(c.heading, c.massCentre), Point(c.mass * gravity));
    const Point fall = isFree ? gravity : Point(0, 0);
    return {fall + static_cast<double>(c.inverseMass) * force,
            static_cast<double>(c.inverseInertia) * torque};
}

void adoptStirredClusters(State& state) {
    if (!state.anyStirred) return;
    for (const auto c : state.work.awakeClusters)
        if (state.clusters.list[c].stirred) adopt(state, state.clusters.list[c]);
    state.anyStirred = false;
}

void predictClusters(State& state) {
    const AirFriction air(state);
    const bool turns = !onlyContactsAsk(state);
    forEachBlock(state, state.work.clusters, [&](const Block& block) {
        for (std::size_t k = 0; k < block.size(); ++k) predictCluster(state, block[k], air);
        if (turns) updateTurns(block);
    });
}

bool onlyContactsAsk(const State& state) {
    const WorkLists& work = state.work;
    return !work.holdsClusters && work.attachments.empty() && work.hinges.empty() &&
           work.watchedClusters.empty() && state.triangles.awake.held.empty() &&
           state.influences.grabs.empty() && state.mechanisms.empty();
}

void spreadDisplacements(State& state) {
    if (!state.anyForced && onlyContactsAsk(state)) return;
    forEachBlock(state, state.work.awakeClusters, [&](const Block& block) {
        PerCluster<ClusterWay> ways;
        for (std::size_t k = 0; k < block.size(); ++k) ways[k] = wayOf(block[k]);
        clusterKernels().spread(membersOf(state), ways.data(), block.size());
    });
    state.anyForced = false;
}

void updateClusterVelocities(State& state) {
    const double perTick = 1 / static_cast<double>(state.h);
    forEachCluster(state, state.work.awakeClusters, [&](Cluster& c) {
        const Vec2 change = c.displacement - c.predicted;
        c.velocity = limited(c.velocity + perTick * change.cast<double>());
        c.spin = limitedSpin(c, c.spin + perTick * (c.angle - c.predictedAngle));
    });
}

void placeMembers(State& state, std::uint32_t index) {
    const Cluster& c = state.clusters.list[index];
    Particles& p = state.particles;
    for (std::uint32_t k = c.first; k < c.last; ++k) {
        const auto i = state.clusters.members[k];
        const Point arm = turned(c.heading, state.clusters.places[k]);
        p.arm[i] = arm.cast<Real>();
        p.position[i] = c.centre + arm;
    }
}

namespace {

/// Whether a stage asks for the members of clusters: of the next step, or breakage, which divides
/// bodies, or the one that finds out whether a strained body is straight again.
bool mayAskForMembers(const State& state) {
    const WorkLists& work = state.work;
    return !work.breakableJoints.empty() || !work.strained.empty() || state.anyForced ||
           !onlyContactsAsk(state) || !state.influences.fields.empty() || state.gravityScaled ||
           state.damped || !state.sensing.bodies.empty();
}

}  // namespace

void moveClusters(State& state) {
    const bool isFirst = isFirstStep(state);
    forEachBlock(state, state.work.awakeClusters,
                 [&](const Block& block) { move(block, isFirst); });
    state.membersBehind = true;
    if (mayAskForMembers(state)) bringMembers(state);
}

namespace {

/// Members to their clusters, which go on from here.
void bring(State& state, const Block& block) {
    PerCluster<ClusterPose> poses;
    for (std::size_t k = 0; k < block.size(); ++k) poses[k] = poseOf(block[k]);
    clusterKernels().place(membersOf(state), poses.data(), block.size(), maxSpeed);
}

}  // namespace

void bringMembersOf(State& state, std::uint32_t cluster) {
    const auto& awake = state.work.awakeClusters;
    if (state.membersBehind && std::binary_search(awake.begin(), awake.end(), cluster))
        bring(state, {state, &cluster, 1});
}

void bringMembers(State& state) {
    if (!std::exchange(state.membersBehind, false)) return;
    // What is gone stays as it was when it went.
    if (state.work.hasGaps)
        std::erase_if(state.work.awakeClusters, [&](std::uint32_t c) {
            return state.bodies[state.clusters.list[c].body].gone > 0;
        });
    forEachBlock(state, state.work.awakeClusters, [&](const Block& block) { bring(state, block); });
}

Point placeNow(const State& state, std::uint32_t particle) {
    const auto cluster = state.particles.cluster[particle];
    if (cluster == none || !state.membersBehind) return state.particles.position[particle];
    const Cluster& c = state.clusters.list[cluster];
    const auto& members = state.clusters.members;
    const auto first = members.begin() + c.first, last = members.begin() + c.last;
    const auto k = static_cast<std::size_t>(std::find(first, last, particle) - members.begin());
    return c.centre + turned(c.heading, state.clusters.places[k]);
}

}  // namespace sulfur::detail
