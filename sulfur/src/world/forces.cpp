// World: moving and pushing a body as a whole.
#include <algorithm>
#include <cmath>

#include "bodies/pose.hpp"
#include "bodies/sleep.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "rigid/disc_turns.hpp"
#include "rigid/find_clusters.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::BodyRecord;
using detail::indexOf;
using detail::maxCoordinate;
using detail::maxForce;
using detail::maxSpeed;
using detail::requireRange;
using detail::requireWithin;
using detail::RigidMotion;
using detail::State;

namespace {

/// What a rigid body would do: its particles differ by their places alone.
struct RigidField {
    Point centre{0, 0};  // m
    Point straight{0, 0};
    double turning = 0;  // per m

    Point at(const Point& place) const {
        return straight + turning * detail::perpendicular(Point(place - centre));
    }
};

/// The accelerations (or velocities) that a force and a torque about the centre of mass (or an
/// impulse and an angular one) give.
RigidField answerOf(const RigidMotion& whole, const Point& push, double twist) {
    return {whole.centre, push / whole.mass, whole.inertia > 0 ? twist / whole.inertia : 0};
}

/// Calls f(particle) for all of a body.
template <class Function>
void forEachParticle(const State& state, std::uint32_t index, Function&& f) {
    const BodyRecord& body = state.bodies[index];
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) f(body.firstParticle + k);
}

/// What each particle and disc of a body gets of a push must be in range too.
void requireShares(const State& state, std::uint32_t index, const RigidMotion& whole,
                   const RigidField& field, const char* particle, const char* disc) {
    constexpr double most = maxForce * (1 + 1e-9);  // what rounding adds is cut later
    const auto first = state.bodies[index].firstParticle;
    forEachParticle(state, index, [&](std::uint32_t i) {
        const Point share =
            static_cast<double>(state.particles.mass[i]) * field.at(state.particles.position[i]);
        requireWithin(share, most, {"particle", i - first, particle});
    });
    for (const auto i : whole.discs)
        requireRange(detail::inertiaOfDisc(state, i) * field.turning, -most, most,
                     {"disc", i - first, disc});
}

/// Neither particles nor the rims of discs may be faster than any particle.
void requireSpeeds(const State& state, std::uint32_t index, const RigidMotion& whole,
                   const RigidField& field) {
    const auto first = state.bodies[index].firstParticle;
    forEachParticle(state, index, [&](std::uint32_t i) {
        requireWithin(field.at(state.particles.position[i]), maxSpeed,
                      {"particle", i - first, "velocity in that motion"});
    });
    for (const auto i : whole.discs)
        requireRange(static_cast<double>(state.particles.radius[i]) * field.turning, -maxSpeed,
                     maxSpeed, {"disc", i - first, "speed of its rim in that motion"});
}

/// The force acts on all particles as if they were a rigid body, which is then as exact as its
/// rigid components are.
void pushDuringTick(State& state, std::uint32_t index, const RigidMotion& whole,
                    const RigidField& field) {
    requireShares(state, index, whole, field, "its share of the force", "its share of the torque");
    if (state.bodies[index].kind != BodyKind::dynamic || state.bodies[index].disabled) return;
    detail::makeRoom(state.discTurns, whole.discs.size());
    detail::wakeBody(state, index);
    state.anyForced = true;
    forEachParticle(state, index, [&](std::uint32_t i) {
        const Point share =
            static_cast<double>(state.particles.mass[i]) * field.at(state.particles.position[i]);
        Point& force = state.particles.force[i];
        force = (force + share).cwiseMax(-maxForce).cwiseMin(maxForce);
    });
    for (const auto i : whole.discs)
        detail::addTorque(state, i, detail::inertiaOfDisc(state, i) * field.turning);
}

void pushAtOnce(State& state, std::uint32_t index, const RigidMotion& whole,
                const RigidField& field) {
    requireShares(state, index, whole, field, "its share of the impulse",
                  "its share of the angular impulse");
    if (state.bodies[index].kind != BodyKind::dynamic || state.bodies[index].disabled) return;
    detail::makeRoom(state.discTurns, whole.discs.size());
    detail::wakeBody(state, index);
    forEachParticle(state, index, [&](std::uint32_t i) {
        if (state.particles.pinned[i]) return;
        Point& velocity = state.particles.velocity[i];
        velocity = detail::limited(velocity + field.at(state.particles.position[i]));
        detail::stirClusters(state, i);
    });
    for (const auto i : whole.discs)
        detail::setSpin(state, i, detail::spinOf(state, i) + field.turning);
}

/// How long a push acts, and what it is called then.
struct PushKind {
    const char *push, *point, *twist;
    void (*act)(State&, std::uint32_t body, const RigidMotion&, const RigidField&);
};
constexpr PushKind lasting{"force", "point of a force", "torque", pushDuringTick};
constexpr PushKind sudden{"impulse", "point of an impulse", "angular impulse", pushAtOnce};

void pushBody(State& state, BodyId id, const Vec2& push, const Point& at, const PushKind& kind) {
    const auto index = indexOf(state, id);
    requireWithin(push, maxForce, kind.push);
    requireWithin(at, maxCoordinate, kind.point);
    if (push.isZero(0)) return;
    const RigidMotion whole = detail::rigidMotionOf(state, index);
    const Point exact = push.cast<double>();
    const double lever = cross(Point(at - whole.centre), exact);
    kind.act(state, index, whole, answerOf(whole, exact, lever));
}

void twistBody(State& state, BodyId id, Real twist, const PushKind& kind) {
    const auto index = indexOf(state, id);
    requireRange(static_cast<double>(twist), -maxForce, maxForce, kind.twist);
    if (twist == 0) return;
    const RigidMotion whole = detail::rigidMotionOf(state, index);
    kind.act(state, index, whole, answerOf(whole, Point(0, 0), static_cast<double>(twist)));
}

/// A kinematic body turns about its centre of mass until it is told otherwise.
void driveByItself(const State& state, BodyRecord& body, const Vec2& linear, double angular) {
    body.moving = body.stopping = false;
    body.spin = angular;
    body.drift = linear.cast<double>();
    if (angular != 0) body.target = detail::poseOf(detail::frameOf(state, body));
}

}  // namespace

void World::setVelocity(BodyId id, Vec2 linear, double angular) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    requireWithin(linear, maxSpeed, "velocity");
    requireRange(angular, -1e6, 1e6, "angular velocity");
    detail::refuseFixed(state, index);
    BodyRecord& body = state.bodies[index];
    const RigidMotion whole = detail::rigidMotionOf(state, index);
    const RigidField field{whole.centre, linear.cast<double>(), angular};
    requireSpeeds(state, index, whole, field);
    detail::makeRoom(state.fresh, body.particles.size());
    detail::makeRoom(state.discTurns, whole.discs.size());
    detail::wakeBody(state, index);
    if (body.kind == BodyKind::kinematic) driveByItself(state, body, linear, angular);
    forEachParticle(state, index, [&](std::uint32_t i) {
        detail::setParticleVelocity(state, i, field.at(state.particles.position[i]));
    });
    for (const auto i : whole.discs) detail::setSpin(state, i, angular);
}

void World::applyForce(BodyId id, Vec2 force, Point at) {
    pushBody(impl_->changing(), id, force, at, lasting);
}

void World::applyTorque(BodyId id, Real torque) {
    twistBody(impl_->changing(), id, torque, lasting);
}

void World::applyImpulse(BodyId id, Vec2 impulse, Point at) {
    pushBody(impl_->changing(), id, impulse, at, sudden);
}

void World::applyAngularImpulse(BodyId id, Real impulse) {
    twistBody(impl_->changing(), id, impulse, sudden);
}

}  // namespace sulfur
