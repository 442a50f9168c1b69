// What the library tells: counts, what things are, answers of queries, events.
#include <algorithm>

#include "convert.hpp"

namespace sulfur::c {

static_assert(SULFUR_STAGE_COUNT == static_cast<int>(Stage::count));
static_assert(SULFUR_MAX_SHAPE_POINTS == QueryShape::maxPoints);

SulfurStatistics toC(const Statistics& s) {
    SulfurStatistics result{};
    result.particles = s.particles;
    result.joints = s.joints;
    result.bodies = s.bodies;
    result.awake_particles = s.awakeParticles;
    result.explicit_joints = s.explicitJoints;
    result.implicit_joints = s.implicitJoints;
    result.rigid_joints = s.rigidJoints;
    result.swept_joints = s.sweptJoints;
    result.explicit_angles = s.explicitAngles;
    result.implicit_angles = s.implicitAngles;
    result.clusters = s.clusters;
    result.trees = s.trees;
    result.chain_steps = s.chainSteps;
    result.chains_in_lanes = s.chainsInLanes;
    result.chain_fallbacks = s.chainFallbacks;
    result.networks = s.networks;
    result.network_factors = s.networkFactors;
    result.triangles = s.triangles;
    result.pressed_triangles = s.pressedTriangles;
    result.candidates = s.candidates;
    result.looks = s.looks;
    result.contacts = s.contacts;
    result.boxes = s.boxes;
    result.substeps = s.substeps;
    result.damped_joints = s.dampedJoints;
    result.breakable_joints = s.breakableJoints;
    result.fast_pairs = s.fastPairs;
    result.held_back = s.heldBack;
    result.idle_ticks = s.idleTicks;
    std::copy(s.items.begin(), s.items.end(), result.items);
    std::copy(s.seconds.begin(), s.seconds.end(), result.seconds);
    return result;
}

SulfurMemoryUse toC(const MemoryUse& use) {
    return {use.name, use.items, use.bytes, use.hot};
}

SulfurParticleInfo toC(const ParticleInfo& info) {
    return {toC(info.body),   toC(info.position), toC(info.velocity), toC(info.mass),
            toC(info.radius), info.pinned,        info.angle,         info.spin};
}

SulfurJointInfo toC(const JointInfo& info) {
    return {toC(info.body),      toC(info.a),       toC(info.b),      toC(info.restLength),
            toC(info.stiffness), toC(info.damping), toC(info.radius), toC(info.strength),
            toC(info.force),     toC(info.bend)};
}

SulfurAngleInfo toC(const AngleInfo& info) {
    return {toC(info.id),    toC(info.body), toC(info.a),      toC(info.b),  toC(info.c),
            toC(info.drive), info.angle,     toC(info.torque), info.atLower, info.atUpper};
}

SulfurAttachmentInfo toC(const AttachmentInfo& info) {
    SulfurAttachmentInfo result{};
    result.particle = toC(info.particle);
    result.count = info.count;
    for (std::size_t i = 0; i < info.supports.size(); ++i) {
        result.supports[i] = toC(info.supports[i]);
        result.weights[i] = toC(info.weights[i]);
    }
    return result;
}

SulfurGrabInfo toC(const GrabInfo& info) {
    return {toC(info.body), toC(info.point), toC(info.target), toC(info.force)};
}

SulfurCastHit toC(const CastHit& hit) {
    return {toC(hit.body),   toC(hit.joint), toC(hit.particle), toC(hit.point),
            toC(hit.normal), hit.fraction,   toC(hit.along)};
}

SulfurClosestPoint toC(const ClosestPoint& closest) {
    return {toC(closest.body),   toC(closest.joint), toC(closest.particle), toC(closest.point),
            toC(closest.normal), closest.distance,   toC(closest.along)};
}

SulfurOverlap toC(const Overlap& overlap) {
    return {toC(overlap.body), toC(overlap.joint), toC(overlap.particle)};
}

SulfurQueryShape toC(const QueryShape& shape) {
    SulfurQueryShape result{};
    const auto points = shape.points();
    for (std::size_t i = 0; i < points.size(); ++i) result.points[i] = toC(points[i]);
    result.count = static_cast<std::uint32_t>(points.size());
    result.radius = shape.radius();
    return result;
}

SulfurContactInfo toC(const ContactInfo& contact) {
    return {toC(contact.a),      toC(contact.b),       toC(contact.point),
            toC(contact.normal), toC(contact.impulse), toC(contact.friction)};
}

SulfurPreSolveContact toC(const PreSolveContact& contact) {
    return {toC(contact.a),      toC(contact.b),     toC(contact.point),
            toC(contact.normal), toC(contact.speed), toC(contact.gap)};
}

SulfurContactBegun toC(const ContactBegun& event) {
    return {toC(event.a),      toC(event.b),     toC(event.point),
            toC(event.normal), toC(event.speed), toC(event.impulse)};
}

SulfurContactPersisted toC(const ContactPersisted& event) {
    return {toC(event.a), toC(event.b), toC(event.point), toC(event.normal), toC(event.impulse)};
}

SulfurContactEnded toC(const ContactEnded& event) {
    return {toC(event.a), toC(event.b)};
}

SulfurJointBroken toC(const JointBroken& event) {
    return {toC(event.joint), toC(event.body), toC(event.point), toC(event.force)};
}

SulfurBodySplit toC(const BodySplit& event) {
    return {toC(event.body), toC(event.piece)};
}

SulfurParticleLost toC(const ParticleLost& event) {
    return {toC(event.particle), toC(event.body), toC(event.point)};
}

SulfurSensorEvent toC(const SensorEntered& event) {
    return {toC(event.sensor), toC(event.visitor)};
}

SulfurSensorEvent toC(const SensorLeft& event) {
    return {toC(event.sensor), toC(event.visitor)};
}

}  // namespace sulfur::c
