// World: where a body is as a whole, and putting it elsewhere.
#include "bodies/pose.hpp"

#include <algorithm>

#include "bodies/sleep.hpp"
#include "contacts/stages.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/trigonometry.hpp"
#include "rigid/cluster_motion.hpp"
#include "shape/bends.hpp"
#include "shape/make_shapes.hpp"
#include "solver/work_lists.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::BodyRecord;
using detail::Cluster;
using detail::Frame;
using detail::indexOf;
using detail::none;
using detail::State;
using detail::turned;
using detail::turnedBack;

namespace {

Frame frameNow(State& state, BodyId id) {
    return detail::frameOf(state, state.bodies[indexOf(state, id)]);
}

/// How a body goes over to another pose: it is turned about its centre of mass, which goes to
/// another place.
struct Transfer {
    Transfer(const Frame& from, const Pose& pose)
        : centre(from.centre),
          turn(turnedBack(from.heading, detail::unitVector(pose.angle)).normalized()),
          to(pose.position + turned(detail::unitVector(pose.angle), from.restCentre)) {}

    Point operator()(const Point& place) const { return to + turned(turn, place - centre); }

    Point centre, turn, to;
};

void requireRoom(const State& state, const BodyRecord& body, const Transfer& transfer) {
    for (std::uint32_t k = 0; k < body.particles.size(); ++k)
        detail::requireWithin(transfer(state.particles.position[body.firstParticle + k]),
                              detail::maxCoordinate, {"particle", k, "position at that pose"});
}

/// Velocities turn with what is turned: relative to that of the centre of mass, or, where a pin
/// holds the body, as they are.
void turnVelocities(State& state, std::uint32_t index, const Point& turn) {
    const BodyRecord& body = state.bodies[index];
    detail::Particles& p = state.particles;
    const auto first = body.firstParticle;
    const auto last = first + static_cast<std::uint32_t>(body.particles.size());
    const bool isHeld = std::any_of(p.pinned.begin() + first, p.pinned.begin() + last,
                                    [](std::uint8_t pinned) { return pinned != 0; });
    const Point mean = isHeld ? Point(0, 0) : detail::meanVelocityOf(state, body);
    const auto turnOne = [&](Point& velocity) {
        velocity = detail::limited(mean + turned(turn, velocity - mean));
    };
    for (auto i = first; i < last; ++i) turnOne(p.velocity[i]);
    const detail::Range clusters = detail::clustersOf(state, index);
    for (auto c = clusters.first; c < clusters.last; ++c) turnOne(state.clusters.list[c].velocity);
}

/// Particles go one by one; those of a rigid component that is up to date with it, so that its
/// shape keeps every bit.
void move(State& state, std::uint32_t index, const Transfer& transfer) {
    BodyRecord& body = state.bodies[index];
    detail::Particles& p = state.particles;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        p.position[i] = transfer(p.position[i]);
        p.displacement[i] = Vec2(0, 0);
    }
    const detail::Range clusters = detail::clustersOf(state, index);
    for (auto i = clusters.first; i < clusters.last; ++i) {
        Cluster& c = state.clusters.list[i];
        c.centre = c.centreBefore = transfer(c.centre);
        c.heading = c.headingBefore = turned(transfer.turn, c.heading).normalized();
        if (!body.clustersStale) detail::placeMembers(state, i);
    }
}

/// Of a single particle, which does not show how it is turned, and where nothing else tells.
void turnFrame(const State& state, BodyRecord& body, const Point& heading) {
    const auto cluster = state.particles.cluster[body.firstParticle];
    const bool rolls = body.particles.size() == 1 && cluster != none;
    body.turn = body.turnBefore =
        rolls ? turnedBack(state.clusters.list[cluster].heading, heading) : heading;
}

/// How a body is solved depends on its place where it is tied to others or is part of a tree.
void noteTies(State& state, std::uint32_t index) {
    const auto& structure = state.structure;
    const bool derived =
        !structure.stale || (structure.onlyAdded && index < structure.before.bodies);
    if (!derived) return;
    if (state.structureChanged || detail::hasLinks(state.core, state.bodies[index].id.index - 1) ||
        detail::isInTree(state, index))
        state.structure.changed();
}

}  // namespace

Pose World::pose(BodyId id) const {
    return detail::poseOf(frameNow(impl_->state(), id));
}

double World::angle(BodyId id) const {
    return detail::angleOf(frameNow(impl_->state(), id).heading);
}

Point World::toWorld(BodyId id, Point local) const {
    detail::requireWithin(local, detail::maxCoordinate, "point of a body");
    const Frame frame = frameNow(impl_->state(), id);
    return frame.centre + turned(frame.heading, local - frame.restCentre);
}

Point World::toBody(BodyId id, Point point) const {
    detail::requireWithin(point, detail::maxCoordinate, "point");
    const Frame frame = frameNow(impl_->state(), id);
    return frame.restCentre + turnedBack(frame.heading, point - frame.centre);
}

Vec2 World::vectorToWorld(BodyId id, Vec2 local) const {
    detail::requireWithin(local, detail::maxForce, "vector");
    return turned(frameNow(impl_->state(), id).heading, local.cast<double>()).cast<Real>();
}

Vec2 World::vectorToBody(BodyId id, Vec2 vector) const {
    detail::requireWithin(vector, detail::maxForce, "vector");
    return turnedBack(frameNow(impl_->state(), id).heading, vector.cast<double>()).cast<Real>();
}

Pose World::interpolatedPose(BodyId id, double alpha) const {
    detail::requireRange(alpha, 0, 1, "interpolated pose: alpha");
    State& state = impl_->state();
    Frame now = frameNow(state, id);
    const Frame before = detail::frameBefore(state, state.bodies[indexOf(state, id)]);
    const double turn = detail::angleOf(turnedBack(before.heading, now.heading));
    now.centre -= (1 - alpha) * (now.centre - before.centre);
    now.heading = turned(detail::unitVector(-(1 - alpha) * turn), now.heading);
    return detail::poseOf(now);
}

double World::angularVelocity(BodyId id) const {
    State& state = impl_->state();
    return detail::rigidMotionOf(state, indexOf(state, id)).spin;
}

Real World::inertia(BodyId id) const {
    State& state = impl_->state();
    return static_cast<Real>(detail::rigidMotionOf(state, indexOf(state, id)).inertia);
}

Bounds World::bounds(BodyId id) const {
    const State& state = impl_->state();
    const BodyRecord& body = state.bodies[indexOf(state, id)];
    const detail::Particles& p = state.particles;
    Bounds bounds{p.position[body.firstParticle], p.position[body.firstParticle]};
    const auto includePoint = [&](const Point& at, Real radius) {
        const Point around = Point::Constant(static_cast<double>(radius));
        bounds.low = bounds.low.cwiseMin(at - around);
        bounds.high = bounds.high.cwiseMax(at + around);
    };
    const auto include = [&](std::uint32_t i, Real radius) { includePoint(p.position[i], radius); };
    for (std::uint32_t k = 0; k < body.particles.size(); ++k)
        include(body.firstParticle + k, p.radius[body.firstParticle + k]);
    for (const JointId joint : body.joints) {
        const auto j = state.jointSlots.dense(joint);
        for (const auto end : {state.joints.a[j], state.joints.b[j]})
            include(end, state.joints.radius[j]);
        const double bend = detail::bendOf(state, j);
        if (bend == 0) continue;
        const detail::Arc arc =
            detail::arcBetween(p.position[state.joints.a[j]], p.position[state.joints.b[j]], bend);
        for (const Point& axis : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)})
            if (arc.reachesTo(axis))
                includePoint(arc.centre + arc.radius * axis, state.joints.radius[j]);
    }
    return bounds;
}

void World::setPose(BodyId id, const Pose& pose) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    detail::validatePose(pose);
    BodyRecord& body = state.bodies[index];
    const Transfer transfer(detail::frameOf(state, body), pose);
    requireRoom(state, body, transfer);
    detail::wakeTouching(state, index);
    turnVelocities(state, index, transfer.turn);
    move(state, index, transfer);
    turnFrame(state, body, detail::unitVector(pose.angle));
    // What rounding far from the origin has left of the way.
    move(state, index, Transfer(detail::frameOf(state, body), pose));
    body.moving = false;
    if (body.spin != 0) body.target = pose;
    const auto slot = id.index - 1;
    if (state.placed.empty() || state.placed.back() != slot) state.placed.push_back(slot);
    detail::shapeIsStale(state, slot);
    noteTies(state, index);
    // What nobody pushes looks for nobody: a sleeper in its place must notice by itself.
    if (body.kind != BodyKind::dynamic) detail::wakeNear(state, index);
}

}  // namespace sulfur
