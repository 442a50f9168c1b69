// Making and removing bodies, connections and attachments.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "bodies/sleep.hpp"
#include "contacts/stages.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "core/segments.hpp"
#include "core/trigonometry.hpp"
#include "joints/retune.hpp"
#include "solver/compact.hpp"
#include "solver/mechanisms.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace detail {

namespace {

void validateMasses(const Blueprint& plan) {
    for (const auto& p : plan.particles)
        requireRange(static_cast<double>(p.mass), minMass, maxMass, "particle mass");
    const auto [least, most] = std::minmax_element(
        plan.particles.begin(), plan.particles.end(),
        [](const ParticleSpec& a, const ParticleSpec& b) { return a.mass < b.mass; });
    requireMassRatio(static_cast<double>(least->mass), static_cast<double>(most->mass),
                     "particle mass");
}

/// Of two particles that are to be tied together. What never moves may have any mass.
void validateTie(const State& state, std::uint32_t a, std::uint32_t b) {
    for (const auto p : {a, b})
        if (state.bodies[state.particles.body[p]].kind != BodyKind::dynamic) return;
    requireMassRatio(static_cast<double>(state.particles.mass[a]),
                     static_cast<double>(state.particles.mass[b]), "particle mass");
}

void addParticle(State& state, const ParticleSpec& spec, const Pose& pose, const Point& turn,
                 BodyRecord& body, std::uint32_t bodyIndex) {
    Particles& p = state.particles;
    const auto index = static_cast<std::uint32_t>(p.size());
    const Point rest = spec.position.cast<double>();
    p.position.push_back(pose.position + turned(turn, rest));
    p.displacement.emplace_back(0, 0);
    p.velocity.emplace_back(0, 0);
    p.force.emplace_back(0, 0);
    p.inverseMass.push_back(0);
    p.cluster.push_back(none);
    p.arm.emplace_back(0, 0);
    p.shift.emplace_back(0, 0);
    p.reach.push_back(spec.radius);
    p.body.push_back(bodyIndex);
    p.mass.push_back(spec.mass);
    p.radius.push_back(spec.radius);
    p.rest.push_back(spec.position);
    p.pinned.push_back(spec.pinned ? 1 : 0);
    p.id.push_back(state.particleSlots.insert(index));
    body.particles.push_back(p.id.back());
    if (body.kind == BodyKind::dynamic) state.fresh.push_back(index);
}

JointId addJoint(State& state, std::uint32_t a, std::uint32_t b, const ConnectOptions& options,
                 Real restLength, std::uint32_t body, Real bend = 0) {
    Joints& j = state.joints;
    const auto index = static_cast<std::uint32_t>(j.size());
    j.a.push_back(a);
    j.b.push_back(b);
    j.restLength.push_back(restLength);
    j.stiffness.push_back(options.stiffness);
    j.damping.push_back(options.damping);
    j.explicitStiffness.push_back(0);
    j.explicitDamping.push_back(0);
    j.lambda.push_back(0);
    j.force.push_back(0);
    j.kind.push_back(JointKind::rigid);
    j.inCluster.push_back(0);
    j.braced.push_back(0);
    j.radius.push_back(options.radius);
    j.bend.push_back({std::abs(static_cast<double>(bend)) < leastBend ? 0 : bend});
    j.strength.push_back(options.strength);
    j.material.push_back(options.material.value_or(Material{}));
    j.ownMaterial.push_back(options.material.has_value() ? 1 : 0);
    j.body.push_back(body);
    j.id.push_back(state.jointSlots.insert(index));
    if (body == none)
        for (const auto p : {a, b}) ++state.bodies[state.particles.body[p]].ties;
    for (const auto p : {a, b})
        state.particles.reach[p] = std::max(state.particles.reach[p], options.radius);
    return j.id.back();
}

void makeRoomForParticles(State& state, std::size_t count, BodyKind kind) {
    state.particles.forEachArray([&](auto& list) { makeRoom(list, count); });
    state.particleSlots.makeRoom(count);
    if (kind == BodyKind::dynamic) makeRoom(state.fresh, count);
}

void makeRoomForJoints(State& state, std::size_t count) {
    state.joints.forEachArray([&](auto& list) { makeRoom(list, count); });
    state.jointSlots.makeRoom(count);
}

/// What a body has by itself.
BodyRecord recordOf(const Blueprint& plan) {
    BodyRecord body;
    body.kind = plan.kind;
    body.material = plan.material;
    body.filter = plan.filter;
    body.selfCollision = plan.selfCollision;
    body.sensor = plan.sensor;
    body.name = plan.name;
    body.skin = plan.skin;
    body.particles.reserve(plan.particles.size());
    body.joints.reserve(plan.joints.size());
    return body;
}

Real distanceNow(const State& state, std::uint32_t a, std::uint32_t b) {
    return static_cast<Real>((state.particles.position[b] - state.particles.position[a]).norm());
}

void validateConnection(const ConnectOptions& options, Real rest) {
    requireNonNegativeOrInfinite(static_cast<double>(options.stiffness), "stiffness");
    requireRange(static_cast<double>(options.damping), 0, 1e12, "damping");
    requireRange(static_cast<double>(options.radius), 0, 1e6, "radius");
    requireNonNegativeOrInfinite(static_cast<double>(options.strength), "strength");
    if (options.material) validate(*options.material);
    requireRange(static_cast<double>(rest), 0, 1e9, "rest length");
    if (rest == 0 && (options.stiffness == infinite || options.radius > 0))
        throw Error(ErrorCode::degenerate,
                    "rest length is 0; a rigid or colliding joint needs more than 0");
}

}  // namespace

void validatePose(const Pose& pose) {
    requireWithin(pose.position, maxCoordinate / 2, "pose: position");
    requireRange(pose.angle, -1e6, 1e6, "pose: angle");
}

/// The three particles of a body that hold a point best, with its weights: the two nearest to the
/// point, and that third one which makes the triangle with them the least flat.
Attachment supportsFor(const State& state, std::uint32_t body, Vec2 point) {
    const BodyRecord& record = state.bodies[body];
    const auto& rest = state.particles.rest;
    std::vector<std::uint32_t> order(record.particles.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = record.firstParticle + k;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return (rest[a] - point).squaredNorm() < (rest[b] - point).squaredNorm();
    });
    Attachment held;
    held.count = 1;
    held.support[0] = order[0];
    held.weight[0] = 1;
    if (order.size() == 1 || (rest[order[0]] - point).norm() == 0) return held;
    const Vec2 a = rest[order[0]], ab = rest[order[1]] - a, ap = point - a;
    std::uint32_t third = none;
    Real best = 0;
    for (std::size_t k = 2; k < order.size(); ++k) {
        const Vec2 ac = rest[order[k]] - a;
        const Real flatness = std::abs(cross(ab, ac)) / (ab.squaredNorm() + ac.squaredNorm());
        if (flatness > best * Real(1.5)) {
            best = flatness;
            third = order[k];
        }
    }
    held.support[1] = order[1];
    if (best < Real(0.01)) {  // all in a line: the nearest place on the segment
        held.count = 2;
        held.weight[1] = nearestAlong<Vec2>(ap, Vec2(0, 0), ab);
        held.weight[0] = 1 - held.weight[1];
        return held;
    }
    const Vec2 ac = rest[third] - a;
    held.count = 3;
    held.support[2] = third;
    held.weight[1] = cross(ap, ac) / cross(ab, ac);
    held.weight[2] = cross(ab, ap) / cross(ab, ac);
    held.weight[0] = 1 - held.weight[1] - held.weight[2];
    return held;
}

namespace {

AttachmentId addAttachment(State& state, Attachment held, std::uint32_t particle) {
    for (const Real weight : held.weight)
        requireRange(static_cast<double>(weight), -farthestSupport, farthestSupport,
                     "local point: its distance in sizes of the body");
    for (std::uint32_t k = 0; k < held.count; ++k)
        if (held.support[k] == particle)
            throw Error(ErrorCode::degenerate,
                        "a particle cannot be attached to itself; allowed "
                        "is a point of another body");
    for (std::uint32_t k = 0; k < held.count; ++k) validateTie(state, particle, held.support[k]);
    makeRoom(state.attachments, 1);
    state.attachmentSlots.makeRoom(1);
    held.particle = particle;
    held.id = state.attachmentSlots.insert(static_cast<std::uint32_t>(state.attachments.size()));
    state.attachments.push_back(held);
    ++state.bodies[state.particles.body[particle]].ties;
    for (std::uint32_t k = 0; k < held.count; ++k)
        ++state.bodies[state.particles.body[held.support[k]]].ties;
    for (const auto p : {particle, held.support[0]}) wakeBody(state, state.particles.body[p]);
    bodyChanged(state);
    return held.id;
}

}  // namespace

void bodyChanged(State& state) {
    state.structure.changed();
    state.work.changed();
}

void wakeEnds(State& state, std::uint32_t joint) {
    const bool collides = state.joints.radius[joint] > 0;
    for (const auto p : {state.joints.a[joint], state.joints.b[joint]}) {
        const auto body = state.particles.body[p];
        // With a dynamic body wakes what leans on it.
        if (collides && state.bodies[body].kind != BodyKind::dynamic)
            wakeTouching(state, body);
        else
            wakeBody(state, body);
    }
}

void jointChanged(State& state, std::uint32_t joint) {
    wakeEnds(state, joint);
    if (state.joints.body[joint] != none)
        state.bodies[state.joints.body[joint]].clustersStale = true;
    state.structure.changed();
}

void retune(State& state, std::uint32_t joint, const Spring& spring) {
    Joints& joints = state.joints;
    std::optional<Retuning> retuning;
    if (!state.structure.stale) retuning.emplace(state, joint, spring);
    joints.stiffness[joint] = spring.stiffness;
    joints.damping[joint] = spring.damping;
    if (!retuning || !retuning->isLocal()) return jointChanged(state, joint);
    retuning->apply(state);
    wakeEnds(state, joint);
}

/// Those of a body have a part in its rigid components and triangles.
void changeRestLength(State& state, std::uint32_t joint, Real restLength) {
    state.joints.restLength[joint] = restLength;
    if (state.joints.body[joint] != none) return jointChanged(state, joint);
    state.work.retuned = true;
    wakeEnds(state, joint);
}

void shapeChanged(State& state, std::uint32_t body) {
    state.bodies[body].clustersStale = true;
    state.structure.changed();
}

}  // namespace detail

using detail::indexOf;

Body World::add(const Blueprint& plan, const Pose& pose) {
    plan.validate();
    detail::validateMasses(plan);
    detail::validatePose(pose);
    detail::State& state = impl_->changingKnown();
    detail::BodyRecord body = detail::recordOf(plan);
    detail::makeRoomForParticles(state, plan.particles.size(), plan.kind);
    detail::makeRoomForJoints(state, plan.joints.size());
    const detail::JointsByEnds joints = detail::makeRoomForAngles(state, plan);
    state.bodySlots.makeRoom(1);
    detail::makeRoom(state.bodies, 1);
    detail::makeRoom(state.bodyIds, 1);
    // From here on nothing fails.
    const auto index = static_cast<std::uint32_t>(state.bodies.size());
    const detail::Counts before = detail::countsOf(state);
    body.id = state.bodySlots.insert(index);
    body.firstParticle = static_cast<std::uint32_t>(state.particles.size());
    const Point turn = detail::unitVector(pose.angle);
    body.turn = body.turnBefore = turn;
    for (const ParticleSpec& spec : plan.particles)
        detail::addParticle(state, spec, pose, turn, body, index);
    for (const JointSpec& spec : plan.joints) {
        const auto a = body.firstParticle + spec.a, b = body.firstParticle + spec.b;
        const Vec2 apart = plan.particles[spec.b].position - plan.particles[spec.a].position;
        body.joints.push_back(detail::addJoint(
            state, a, b,
            {spec.stiffness, spec.damping, {}, spec.radius, spec.strength, spec.material},
            spec.restLength.value_or(apart.norm()), index, spec.bend));
    }
    detail::addAngles(state, plan, body, joints);
    state.placed.push_back(body.id.index - 1);
    state.bodyIds.push_back(body.id);
    state.bodies.push_back(std::move(body));
    detail::restoreInverseMass(state, index);
    state.structure.bodyAdded(before);
    state.work.bodyAdded();
    // What is fixed looks for nobody: a sleeper in its place must notice by itself.
    if (plan.kind == BodyKind::fixed) detail::wakeNear(state, index);
    return {*this, state.bodyIds.back()};
}

void World::remove(BodyId id) {
    detail::State& state = impl_->changingKnown();
    detail::removeBody(state, indexOf(state, id));
    detail::forgetMechanisms(state);
}

JointId World::connect(ParticleId first, ParticleId second, const ConnectOptions& options) {
    detail::State& state = impl_->changing();
    const auto a = indexOf(state, first), b = indexOf(state, second);
    if (a == b)
        throw Error(ErrorCode::degenerate,
                    "a joint from a particle to itself; allowed are two different particles");
    const Real rest = options.restLength.value_or(detail::distanceNow(state, a, b));
    detail::validateConnection(options, rest);
    const auto& bodies = state.bodies;
    const auto bodyA = state.particles.body[a], bodyB = state.particles.body[b];
    if (bodies[bodyA].kind != BodyKind::dynamic && bodies[bodyB].kind != BodyKind::dynamic)
        throw Error(ErrorCode::degenerate,
                    "a joint between two particles that never move; at least one must be of a "
                    "dynamic body");
    detail::validateTie(state, a, b);
    const auto owner = bodyA == bodyB ? bodyA : detail::none;
    detail::makeRoomForJoints(state, 1);
    if (owner != detail::none) detail::makeRoom(state.bodies[owner].joints, 1);
    for (const auto body : {bodyA, bodyB}) detail::wakeBody(state, body);
    const JointId id = detail::addJoint(state, a, b, options, rest, owner);
    if (owner != detail::none) {
        state.bodies[owner].joints.push_back(id);
        state.bodies[owner].clustersStale = true;
    }
    detail::bodyChanged(state);
    return id;
}

AttachmentId World::attach(ParticleId particle, BodyId body, Vec2 localPoint) {
    detail::State& state = impl_->changing();
    const auto p = indexOf(state, particle);
    const auto b = indexOf(state, body);
    detail::requireFinite(localPoint, "local point");
    return detail::addAttachment(state, detail::supportsFor(state, b, localPoint), p);
}

AttachmentId World::attach(ParticleId particle, JointId joint, Real along) {
    detail::State& state = impl_->changing();
    const auto p = indexOf(state, particle);
    const auto j = indexOf(state, joint);
    detail::requireRange(static_cast<double>(along), 0, 1, "along");
    detail::Attachment held;
    held.count = 2;
    held.support = {state.joints.a[j], state.joints.b[j], detail::none};
    held.weight = {1 - along, along, 0};
    return detail::addAttachment(state, held, p);
}

void World::remove(JointId id) {
    detail::State& state = impl_->changing();
    const auto index = indexOf(state, id);
    detail::Removal removal(state);
    detail::makeRoomToCompact(state);
    removal.joints[index] = true;
    detail::jointChanged(state, index);
    detail::compact(state, removal);
    detail::forgetMechanisms(state);
}

void World::remove(AttachmentId id) {
    detail::State& state = impl_->changing();
    const auto index = indexOf(state, id);
    detail::Removal removal(state);
    detail::makeRoomToCompact(state);
    removal.attachments[index] = true;
    const detail::Attachment& held = state.attachments[index];
    for (const auto p : {held.particle, held.support[0]})
        detail::wakeBody(state, state.particles.body[p]);
    detail::compact(state, removal);
    detail::forgetMechanisms(state);
}

void World::setPinned(ParticleId particle, bool pinned) {
    detail::State& state = impl_->changing();
    const auto i = indexOf(state, particle);
    state.particles.pinned[i] = pinned ? 1 : 0;
    if (pinned) state.particles.velocity[i] = Point(0, 0);
    const auto body = state.particles.body[i];
    detail::wakeBody(state, body);
    detail::restoreInverseMass(state, body);
    detail::shapeChanged(state, body);
}

}  // namespace sulfur
