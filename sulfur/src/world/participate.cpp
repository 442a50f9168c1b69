// World: whether a body takes part, and who moves it.
#include <algorithm>
#include <utility>

#include "bodies/pose.hpp"
#include "bodies/sleep.hpp"
#include "contacts/stages.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "rigid/disc_turns.hpp"
#include "rigid/find_clusters.hpp"
#include "shape/make_shapes.hpp"
#include "solver/work_lists.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::Attachment;
using detail::BodyRecord;
using detail::Cluster;
using detail::indexOf;
using detail::RigidMotion;
using detail::State;

namespace {

/// What touched it, is tied to it, or sleeps where it is.
void wakeAllAround(State& state, std::uint32_t index) {
    detail::wakeTouching(state, index);
    detail::wakeNear(state, index);
}

/// [first, second) of its particles.
std::pair<std::uint32_t, std::uint32_t> particlesOf(const BodyRecord& body) {
    return {body.firstParticle,
            body.firstParticle + static_cast<std::uint32_t>(body.particles.size())};
}

void noteParticipation(State& state, std::uint32_t index) {
    detail::restoreInverseMass(state, index);
    detail::shapeIsStale(state, state.bodies[index].id.index - 1);
    detail::bodyChanged(state);
}

/// Nobody pulls any more.
void forgetPulls(State& state) {
    for (std::uint32_t j = 0; j < state.joints.size(); ++j)
        if (state.joints.body[j] == detail::none && isCut(state, j))
            state.joints.force[j] = state.joints.lambda[j] = 0;
    for (Attachment& held : state.attachments)
        if (isCut(state, held)) held.force = Vec2(0, 0);
}

/// What has been still for a while is drawn where it is, and nothing is still to act on it.
void stayHere(State& state, std::uint32_t index) {
    const auto [first, last] = particlesOf(state.bodies[index]);
    for (auto i = first; i < last; ++i) {
        state.particles.displacement[i] = Vec2(0, 0);
        state.particles.force[i] = Point(0, 0);
    }
    const detail::Range clusters = detail::clustersOf(state, index);
    for (auto c = clusters.first; c < clusters.last; ++c) {
        Cluster& cluster = state.clusters.list[c];
        cluster.centreBefore = cluster.centre;
        cluster.headingBefore = cluster.heading;
    }
    state.bodies[index].turnBefore = state.bodies[index].turn;
}

/// Of what a body that becomes dynamic is tied to.
void requireTies(const State& state, std::uint32_t index) {
    const auto& p = state.particles;
    const auto require = [&](std::uint32_t a, std::uint32_t b) {
        if (p.body[a] == p.body[b] || (p.body[a] != index && p.body[b] != index)) return;
        const auto other = p.body[a] == index ? p.body[b] : p.body[a];
        if (state.bodies[other].kind == BodyKind::dynamic)
            detail::requireMassRatio(static_cast<double>(p.mass[a]), static_cast<double>(p.mass[b]),
                                     "particle mass");
    };
    for (std::uint32_t j = 0; j < state.joints.size(); ++j)
        if (state.joints.body[j] == detail::none) require(state.joints.a[j], state.joints.b[j]);
    for (const Attachment& held : state.attachments)
        for (std::uint32_t k = 0; k < held.count; ++k) require(held.particle, held.support[k]);
}

/// Whether all of it is one rigid component.
bool isOneRigid(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    const detail::Range clusters = detail::clustersOf(state, index);
    if (body.clustersStale || clusters.last - clusters.first != 1) return false;
    const Cluster& c = state.clusters.list[clusters.first];
    return c.last - c.first == body.particles.size();
}

/// A disc that ceases to be one leaves how it is turned to its body, where nothing else shows it.
void keepHeading(State& state, std::uint32_t index) {
    const detail::Range clusters = detail::clustersOf(state, index);
    for (auto c = clusters.first; c < clusters.last; ++c) {
        Cluster& cluster = state.clusters.list[c];
        if (!isDisc(cluster) || state.bodies[index].particles.size() != 1) continue;
        detail::keepTurn(state.bodies[index], cluster);
        cluster.heading = cluster.headingBefore = Point(1, 0);
    }
}

void setVelocities(State& state, std::uint32_t index, const RigidMotion& whole, const Point& linear,
                   double angular) {
    const auto [first, last] = particlesOf(state.bodies[index]);
    for (auto i = first; i < last; ++i) {
        const Point arm = state.particles.position[i] - whole.centre;
        if (state.particles.pinned[i] == 0)
            state.particles.velocity[i] =
                detail::limited(linear + angular * detail::perpendicular(arm));
    }
}

/// Goes on, turning about its centre of mass.
void driveAs(State& state, std::uint32_t index, const RigidMotion& whole, double angular) {
    BodyRecord& body = state.bodies[index];
    body.spin = angular;
    body.drift = whole.velocity;
    if (angular != 0) body.target = detail::poseOf(detail::frameOf(state, body));
    setVelocities(state, index, whole, whole.velocity, angular);
}

/// Its first kick is half a step's, as that of what is made.
void letGo(State& state, std::uint32_t index, double spin) {
    const auto [first, last] = particlesOf(state.bodies[index]);
    for (auto i = first; i < last; ++i) {
        state.fresh.push_back(i);
        state.particles.force[i] = Point(0, 0);
    }
    for (auto i = first; i < last && spin != 0; ++i)
        if (state.particles.radius[i] > 0) detail::setSpin(state, i, spin);
}

}  // namespace

void World::setEnabled(BodyId id, bool enabled) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    BodyRecord& body = state.bodies[index];
    if (body.disabled == !enabled) return;
    if (enabled) {
        body.disabled = false;
        body.restingTime = 0;
        stayHere(state, index);
        wakeAllAround(state, index);
        state.placed.push_back(id.index - 1);
    } else {
        detail::wakeTouching(state, index);
        body.disabled = true;
        stayHere(state, index);
        forgetPulls(state);
        std::erase_if(state.sensing.visits,
                      [&](const detail::Visit& visit) { return visit.sensor == id; });
    }
    noteParticipation(state, index);
}

void World::setKind(BodyId id, BodyKind kind) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    BodyRecord& body = state.bodies[index];
    if (kind == body.kind) return;
    if (kind == BodyKind::dynamic) requireTies(state, index);
    detail::makeRoom(state.fresh, body.particles.size());
    detail::makeRoom(state.discTurns, body.particles.size());
    const RigidMotion whole = detail::rigidMotionOf(state, index);
    const bool turns = isOneRigid(state, index);
    // From here on nothing fails.
    wakeAllAround(state, index);
    keepHeading(state, index);
    const double spin = body.spin;
    body.kind = kind;
    body.moving = body.stopping = false;
    body.spin = 0;
    std::erase_if(state.fresh, [&](std::uint32_t i) { return state.particles.body[i] == index; });
    if (kind == BodyKind::kinematic) driveAs(state, index, whole, turns ? whole.spin : 0);
    if (kind == BodyKind::fixed) setVelocities(state, index, whole, Point(0, 0), 0);
    detail::shapeChanged(state, index);
    noteParticipation(state, index);
    if (kind == BodyKind::dynamic) letGo(state, index, spin);
}

}  // namespace sulfur
