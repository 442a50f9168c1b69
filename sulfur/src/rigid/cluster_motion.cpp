#include "rigid/cluster_motion.hpp"

#include <algorithm>

#include "core/limits.hpp"
#include "core/pieces.hpp"
#include "core/trigonometry.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

/// No member may be faster than any particle may.
double limitedSpin(const Cluster& c, double spin) {
    const double most = maxSpeed / c.reach;
    return std::clamp(spin, -most, most);
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
    cluster.spin = cluster.freeInverseInertia * angular;
    cluster.stirred = 0;
}

/// Calls f for clusters of a list, in pieces: no two have a member in common.
template <class Function>
void forEachCluster(State& state, const std::vector<std::uint32_t>& list, Function&& f) {
    constexpr std::size_t leastPiece = 512;
    inPieces(state.tasks, list.size(), leastPiece, [&](std::size_t first, std::size_t last) {
        for (auto k = first; k < last; ++k) f(state.clusters.list[list[k]]);
    });
}

/// Air friction by the trapezoidal rule, as for particles.
struct AirFriction {
    explicit AirFriction(const State& state) {
        const double kick = (state.lastTick + static_cast<double>(state.h)) / 2;
        const double half = kick * static_cast<double>(state.settings.airFriction) / 2;
        keep = (1 - half) / (1 + half);
        push = kick / (1 + half);
    }
    double keep, push;
};

void predictCluster(State& state, Cluster& c, const AirFriction& air) {
    const ClusterLoad load = loadOf(state, c);
    c.velocity = limited(air.keep * c.velocity + air.push * load.acceleration);
    c.spin = limitedSpin(c, air.keep * c.spin + air.push * load.turning);
    c.displacement = c.predicted = (static_cast<double>(state.h) * c.velocity).cast<Real>();
    c.angle = c.predictedAngle = static_cast<double>(state.h) * c.spin;
    updateTurn(c);
}

}  // namespace

ClusterLoad loadOf(const State& state, const Cluster& c) {
    if (c.inverseMass == 0 && c.inverseInertia == 0) return {};
    const Particles& p = state.particles;
    const Point weight = c.mass * state.settings.gravity.cast<double>();
    Point force = weight;
    double torque = cross(turned(c.heading, c.massCentre), weight);
    for (std::uint32_t k = c.first; k < c.last; ++k) {
        const auto i = state.clusters.members[k];
        const Point& f = p.force[i];
        force += f;
        torque += cross(p.arm[i].cast<double>(), f);
    }
    return {static_cast<double>(c.inverseMass) * force,
            static_cast<double>(c.inverseInertia) * torque};
}

void adoptStirredClusters(State& state) {
    if (!state.anyStirred) return;
    for (Cluster& c : state.clusters.list)
        if (c.stirred) adopt(state, c);
    state.anyStirred = false;
}

void predictClusters(State& state) {
    const AirFriction air(state);
    forEachCluster(state, state.work.clusters, [&](Cluster& c) { predictCluster(state, c, air); });
}

void spreadDisplacements(State& state) {
    Particles& p = state.particles;
    forEachCluster(state, state.work.awakeClusters, [&](const Cluster& c) {
        for (std::uint32_t k = c.first; k < c.last; ++k) {
            const auto m = state.clusters.members[k];
            const Vec2& arm = p.arm[m];
            p.displacement[m] = c.displacement + c.sine * Vec2(-arm[1], arm[0]) - c.versine * arm;
            p.force[m] = Point(0, 0);
        }
    });
}

void updateClusterVelocities(State& state) {
    const double h = static_cast<double>(state.h);
    forEachCluster(state, state.work.awakeClusters, [&](Cluster& c) {
        const Vec2 change = c.displacement - c.predicted;
        c.velocity = limited(c.velocity + change.cast<double>() / h);
        c.spin = limitedSpin(c, c.spin + (c.angle - c.predictedAngle) / h);
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

void moveClusters(State& state) {
    Particles& p = state.particles;
    forEachCluster(state, state.work.awakeClusters, [&](Cluster& c) {
        const double angle = c.angle + c.twist;
        if (angle != 0) c.heading = turned(unitVector(angle), c.heading).normalized();
        c.centre += c.displacement.cast<double>() + c.shift.cast<double>();
        c.centre = c.centre.cwiseMax(-maxCoordinate).cwiseMin(maxCoordinate);
        c.shift = Vec2(0, 0);
        c.twist = 0;
        for (std::uint32_t k = c.first; k < c.last; ++k) {
            const auto i = state.clusters.members[k];
            const Point arm = turned(c.heading, state.clusters.places[k]);
            const Point place = c.centre + arm;
            p.displacement[i] = (place - p.position[i]).cast<Real>();
            p.position[i] = place;
            p.arm[i] = arm.cast<Real>();
            p.velocity[i] = limited(c.velocity + c.spin * perpendicular(arm));
        }
    });
}

}  // namespace sulfur::detail
