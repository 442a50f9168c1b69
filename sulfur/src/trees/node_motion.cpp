#include "trees/node_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/limits.hpp"
#include "core/trigonometry.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/grip.hpp"

namespace sulfur::detail {

namespace {

using Motion = StepScratch::Motion;
using NodeData = StepScratch::Node;

double tickOf(const State& state) {
    return static_cast<double>(state.h);
}

void loadParticle(const State& state, std::uint32_t p, NodeData& data) {
    const Particles& particles = state.particles;
    data.start.place = particles.position[p];
    data.inverseMass = static_cast<double>(particles.inverseMass[p]);
    if (data.inverseMass > 0) {
        data.start.velocity = particles.velocity[p];
        data.gravity = gravityOf(state, particles.body[p]);
        data.acceleration =
            state.settings.gravity.cast<double>() + data.inverseMass * particles.force[p];
    } else {  // as the caller drives it; the stage before has set the displacement
        data.start.velocity = particles.displacement[p].cast<double>() / tickOf(state);
    }
}

/// A place between particles that cannot move by themselves.
void loadSupport(const State& state, const Attachment& held, NodeData& data) {
    for (std::uint32_t k = 0; k < held.count; ++k) {
        const double weight = static_cast<double>(held.weight[k]);
        const auto p = held.support[k];
        data.start.place += weight * state.particles.position[p];
        data.start.velocity +=
            weight / tickOf(state) * state.particles.displacement[p].cast<double>();
    }
}

}  // namespace

void loadNode(const State& state, const TreeNode& node, NodeData& data) {
    data = {};
    if (node.cluster != none) {
        const Cluster& c = state.clusters.list[node.cluster];
        const ClusterLoad load = loadOf(state, c);
        data.start.place = c.centre;
        data.start.velocity = c.velocity;
        data.start.spin = c.spin;
        data.acceleration = load.acceleration;
        data.angular = load.turning;
        data.inverseMass = static_cast<double>(c.inverseMass);
        if (data.inverseMass > 0) data.gravity = gravityOf(state, c.body);
        data.inverseInertia = static_cast<double>(c.inverseInertia);
        data.mostSpin = maxSpeed / c.reach;
    } else if (node.particle != none) {
        loadParticle(state, node.particle, data);
    } else {
        loadSupport(state, state.attachments[node.link], data);
    }
}

NodeKick firstKick(const State& state, const Tree& tree, double step) {
    return {step + (state.lastStep - tickOf(state)) / 2, (tree.lastStep + step) / 2};
}

void predictNodes(const State& state, const std::vector<NodeData>& nodes, NodeKick kick,
                  double step, std::vector<Motion>& motion) {
    const double half = kick.forces * static_cast<double>(state.settings.airFriction) / 2;
    const double keep = (1 - half) / (1 + half), push = kick.forces / (1 + half);
    const double longer = kick.gravity - kick.forces;
    const double limit = maxSpeed;
    for (std::size_t i = 0; i < motion.size(); ++i) {
        Motion& m = motion[i];
        const NodeData& data = nodes[i];
        if (data.inverseMass > 0)
            m.velocity = (keep * m.velocity + push * data.acceleration + longer * data.gravity)
                             .cwiseMax(-limit)
                             .cwiseMin(limit);
        if (data.inverseInertia > 0)
            m.spin = std::clamp(keep * m.spin + push * data.angular, -data.mostSpin, data.mostSpin);
        m.displacement = step * m.velocity;
        m.turning = step * m.spin;
    }
}

void moveNode(const NodeData& data, double step, Motion& m) {
    // What the caller has torn apart comes together at the speed limit, not at once.
    const double limit = maxSpeed * step;
    m.displacement = m.displacement.cwiseMax(-limit).cwiseMin(limit);
    m.place += m.displacement;
    if (data.inverseMass > 0) m.velocity = m.displacement / step;
    if (data.mostSpin == 0) return;
    const double most = data.mostSpin * step;
    m.turning = std::clamp(m.turning, -most, most);
    m.angle += m.turning;
    m.heading = turned(unitVector(m.turning), m.heading);
    m.spin = m.turning / step;
}

bool allFinite(const std::vector<Motion>& motion) {
    return std::all_of(motion.begin(), motion.end(), [](const Motion& m) {
        return m.place.allFinite() && m.velocity.allFinite() && std::isfinite(m.angle) &&
               std::isfinite(m.spin);
    });
}

Vec2 storeNode(State& state, const TreeNode& node, const NodeData& data, const Motion& m) {
    const Vec2 moved = (m.place - data.start.place).cast<Real>();
    if (node.cluster != none) {
        Cluster& c = state.clusters.list[node.cluster];
        c.displacement = c.predicted = moved;
        c.angle = c.predictedAngle = m.angle;
        c.velocity = m.velocity;
        c.spin = m.spin;
        updateTurn(c);
    } else if (data.inverseMass > 0) {
        state.particles.displacement[node.particle] = moved;
        state.particles.velocity[node.particle] = m.velocity;
    }
    return moved;
}

}  // namespace sulfur::detail
