// What a world holds in memory.
#include <string>
#include <sulfur/world.hpp>

#include "world/impl.hpp"

namespace sulfur {

namespace {

using detail::State;

/// Adds up the elements of arrays.
class Sum {
public:
    template <class... Vectors>
    Sum& add(const Vectors&... vectors) {
        ((bytes_ += vectors.size() * sizeof(typename Vectors::value_type)), ...);
        return *this;
    }
    Sum& addBytes(std::size_t bytes) {
        bytes_ += bytes;
        return *this;
    }
    MemoryUse as(const char* name, std::size_t items, bool hot) const {
        return {name, items, bytes_, hot};
    }

private:
    std::size_t bytes_ = 0;
};

MemoryUse ofHotParticles(const State& state) {
    const auto& p = state.particles;
    return Sum()
        .add(p.position, p.displacement, p.velocity, p.force, p.inverseMass, p.cluster, p.arm,
             p.shift, p.reach, p.body)
        .as("particles: motion and surface", p.size(), true);
}

MemoryUse ofColdParticles(const State& state) {
    const auto& p = state.particles;
    return Sum()
        .add(p.mass, p.radius, p.rest, p.pinned, p.id)
        .as("particles: what they were made as", p.size(), false);
}

MemoryUse ofHotJoints(const State& state) {
    const auto& j = state.joints;
    return Sum()
        .add(j.a, j.b, j.restLength, j.stiffness, j.damping, j.explicitStiffness, j.explicitDamping,
             j.lambda, j.force, j.kind, j.inCluster, j.braced)
        .as("joints: what holds", j.size(), true);
}

MemoryUse ofColdJoints(const State& state) {
    const auto& j = state.joints;
    return Sum()
        .add(j.radius, j.bend, j.strength, j.material, j.ownMaterial, j.body, j.id,
             state.structure.colours)
        .as("joints: surface, strength, owner", j.size(), false);
}

MemoryUse ofAngles(const State& state) {
    const auto& a = state.angles;
    const auto& w = state.work;
    return Sum()
        .add(a.a, a.b, a.c, a.restAngle, a.stiffness, a.damping, a.explicitStiffness,
             a.explicitDamping, a.armBefore, a.armAfter, a.torque, a.kind, a.before, a.after,
             a.body, a.strength, a.drive, a.id, w.explicitAngles, w.implicitAngles,
             w.breakableAngles, w.sweptAngles.list, w.sweptAngles.groups, w.sweptAngles.factors)
        .as("angular joints", a.size(), true);
}

MemoryUse ofSweptJoints(const State& state) {
    Sum sum;
    for (const auto* swept : {&state.work.implicitSweep, &state.work.rigidSweep})
        sum.add(swept->joint, swept->a, swept->b, swept->massA, swept->massB, swept->length,
                swept->hk, swept->hb, swept->startX, swept->startY, swept->directionX,
                swept->directionY, swept->whips, swept->lambda, swept->gain, swept->rest);
    return sum.as("joints in sweeps: their lanes",
                  state.work.implicitJoints.size() + state.work.rigidJoints.size(), true);
}

MemoryUse ofWorkLists(const State& state) {
    const auto& w = state.work;
    return Sum()
        .add(w.awake, w.points, w.free, w.awakeClusters, w.clusters, w.watchedClusters,
             w.lonelyTrees, w.tiedTrees, w.lines, w.explicitJoints, w.implicitJoints, w.rigidJoints,
             w.stiffJoints, w.stiffRuns, w.breakableJoints, w.attachments, w.hinges, w.heldNodes,
             w.bodies, w.kinematic, w.strained, w.turned, state.turned, state.placed,
             state.discTurns, w.tiedJoints, w.springs, w.springStart, w.explicitBatches.batches,
             w.explicitBatches.joint, w.explicitBatches.a, w.explicitBatches.b,
             w.explicitBatches.rest, w.explicitBatches.stiffness, w.explicitBatches.damping,
             state.starts)
        .as("lists of what is awake", w.awakeParticles, true);
}

MemoryUse ofTriangles(const State& state) {
    const auto& t = state.triangles;
    return Sum()
        .add(t.all, t.awake.a, t.awake.b, t.awake.c, t.awake.rest, t.awake.held, t.awake.flat,
             t.awake.pressed, t.pressed)
        .as("triangles of soft bodies", t.all.size(), true);
}

MemoryUse ofClusters(const State& state) {
    const auto& c = state.clusters;
    return Sum()
        .add(c.list, c.members, c.places, c.hinges)
        .as("rigid components", c.list.size(), true);
}

MemoryUse ofTrees(const State& state) {
    const auto& t = state.trees;
    const auto& c = state.work.chains;
    return Sum()
        .add(t.list, t.nodes, t.ofParticle, t.ofCluster, t.predicted, t.met, t.lambda, t.touched,
             t.contact, t.nodeOfParticle, c.list, c.particles, c.joints, c.inverseMass, c.rest,
             c.share)
        .as("trees and chains", t.nodes.size(), true);
}

MemoryUse ofNetworks(const State& state) {
    const auto& t = state.trees;
    Sum sum;
    sum.add(t.links, t.rows, t.linkMet, t.linkLambda, t.networkTouches, t.heldRows, t.groupOf);
    for (const auto* factors : {&t.factors, &t.earlier})
        for (const auto& f : *factors) {
            sum.add(f.rows, f.given, f.settled);
            sum.addBytes(f.pattern.bytes() + f.step.bytes() + f.swept.bytes());
        }
    return sum.as("networks: links and factors", t.links.size(), true);
}

MemoryUse ofMovers(const State& state) {
    const std::size_t count = state.core.movers.size() - 1;  // without the one that never moves
    Sum sum;
    state.core.movers.forEachArray(
        [&](const auto& list) { sum.addBytes(count * sizeof(list[0])); });
    return sum.as("what contacts push", count, true);
}

MemoryUse ofShapes(const State& state) {
    const auto& s = state.core.shapes;
    return Sum()
        .add(s.corners, s.sides, s.uses, s.spokes, s.chunks, s.firstChunk, s.moverOfParticle,
             state.surface)
        .as("corners and sides", s.sides.size(), true);
}

MemoryUse ofPairs(const State& state) {
    const auto& c = state.core;
    return Sum()
        .add(c.pairs, c.watches, c.rooms, c.encounters, c.buckets)
        .as("pairs that are near", c.pairs.size(), true);
}

MemoryUse ofRows(const State& state) {
    return Sum()
        .add(state.core.touches)
        .addBytes(state.core.rows.bytes())
        .as("rows of contacts", state.core.rows.size(), true);
}

MemoryUse ofBodies(const State& state) {
    Sum sum;
    sum.add(state.bodies, state.bodyIds, state.attachments, state.mechanisms.list);
    for (const auto& body : state.bodies) sum.add(body.particles, body.joints, body.name);
    for (const auto& mechanism : state.mechanisms.list) sum.add(mechanism.rail.links);
    sum.addBytes(state.particleSlots.bytes() + state.jointSlots.bytes() + state.bodySlots.bytes() +
                 state.attachmentSlots.bytes() + state.angleSlots.bytes() +
                 state.mechanisms.slots.bytes());
    return sum.as("bodies, and all handles", state.bodies.size(), false);
}

std::size_t bytesOfMembers(const detail::NetworkSweep& sweep) {
    std::size_t bytes = 0;
    for (const detail::NetworkMember& m : sweep.members)
        bytes += m.rows.capacity() * sizeof(detail::NetworkRow) +
                 (m.inverseMass.capacity() + m.moved.capacity() + m.bestMoved.capacity() +
                  m.residual.capacity() + m.nodes.capacity()) *
                     sizeof(Eigen::Vector3d) +
                 (m.lambda.capacity() + m.bestLambda.capacity() + m.wanted.capacity() +
                  m.values.capacity()) *
                     2 * sizeof(double);
    return bytes;
}

/// What a step needs only while it lasts.
MemoryUse ofScratch(const State& state) {
    const auto& c = state.core;
    const auto& t = state.trees.scratch;
    const auto& n = state.trees.scratch.network;
    const auto& w = state.trees.networkSweep;
    const auto& m = state.mechanisms;
    const auto& e = state.work.explicitBatches;
    return Sum()
        .add(c.ahead, c.moved, c.placed, c.again, c.heirs, c.leads, c.passings, c.ways, c.lengths,
             c.blows, c.knocks, c.impulses, c.struck, c.held, c.places)
        .add(m.rows, m.movers, m.nodes, m.answers, m.groups, m.numbers, m.trees)
        .add(t.chain.nodes, t.chain.links, t.chain.springs, t.chain.factors, t.step.nodes,
             t.step.motion, t.step.before, t.step.links, t.held, t.begins,
             state.work.chains.scratch)
        .addBytes(t.points.bytes() + t.bodies.bytes())
        .add(n.links, n.inverseMass, n.predicted, n.nodes, n.sizes, n.turned, n.best, n.values,
             n.points, n.bodies, w.contacts, w.bodies)
        .addBytes(bytesOfMembers(w))
        .add(e.levelOfParticle, e.levelOfJoint, e.sorted, e.levelStart)
        .add(state.young, state.asked)
        .addBytes(state.arena.bytes())
        .as("scratch of a step", c.movers.size() - 1, true);
}

}  // namespace

std::vector<MemoryUse> World::memory() const {
    const State& state = impl_->state();
    std::vector<MemoryUse> uses;
    for (const auto use : {ofHotParticles, ofColdParticles, ofHotJoints, ofColdJoints, ofAngles,
                           ofSweptJoints, ofWorkLists, ofTriangles, ofClusters, ofTrees, ofNetworks,
                           ofMovers, ofShapes, ofPairs, ofRows, ofBodies, ofScratch})
        uses.push_back(use(state));
    return uses;
}

}  // namespace sulfur
