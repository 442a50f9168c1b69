// World: changing what exists.
#include <algorithm>

#include "bodies/sleep.hpp"
#include "contacts/stages.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "rigid/find_clusters.hpp"
#include "shape/make_shapes.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::indexOf;
using detail::maxCoordinate;
using detail::maxForce;
using detail::maxSpeed;
using detail::requireRange;
using detail::State;

namespace {

void wakeAll(State& state) {
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) detail::wakeBody(state, i);
}

/// When what it collides with changes: what touched it, and what was let overlap it.
void wakeAround(State& state, std::uint32_t body) {
    detail::wakeTouching(state, body);
    detail::wakeNear(state, body);
}

void wakeOwner(State& state, std::uint32_t particle) {
    detail::wakeBody(state, state.particles.body[particle]);
}

/// The lists of contacts count what bounces, and what resists rolling.
void changeMaterial(State& state, Material& material, const Material& to) {
    if ((material.restitution > 0) != (to.restitution > 0) ||
        (material.rollingResistance > 0) != (to.rollingResistance > 0))
        state.core.listsStale = true;
    material = to;
}

/// 1/s, of a body.
void requireDamping(Real linear, Real angular, int tickRate) {
    requireRange(static_cast<double>(linear), 0, tickRate, "linear damping");
    requireRange(static_cast<double>(angular), 0, tickRate, "angular damping");
}

}  // namespace

namespace detail {

void setParticleVelocity(State& state, std::uint32_t i, const Point& velocity) {
    if (state.particles.pinned[i]) return;
    state.particles.velocity[i] = velocity;
    stirClusters(state, i);
    if (state.bodies[state.particles.body[i]].kind == BodyKind::dynamic) state.fresh.push_back(i);
}

void refuseFixed(const State& state, std::uint32_t body) {
    if (state.bodies[body].kind == BodyKind::fixed)
        throw Error(ErrorCode::degenerate,
                    "a fixed body cannot have a velocity; allowed are dynamic and kinematic ones");
}

}  // namespace detail

void World::setGravity(Vec2 gravity) {
    detail::requireWithin(gravity, detail::maxAcceleration, "gravity");
    if (gravity == impl_->data.settings.gravity) return;
    State& state = impl_->changing();
    state.settings.gravity = gravity;
    wakeAll(state);
}

Vec2 World::gravity() const {
    return impl_->data.settings.gravity;
}

void World::setAirFriction(Real airFriction) {
    State& state = impl_->outside();
    requireRange(static_cast<double>(airFriction), 0, state.settings.tickRate, "air friction");
    state.settings.airFriction = airFriction;
}

void World::setTickRate(int tickRate) {
    requireRange(tickRate, detail::minTickRate, detail::maxTickRate, "tick rate");
    State& state = impl_->outside();
    if (tickRate == state.settings.tickRate) return;
    // Air friction and damping may not be faster than the ticks.
    requireRange(static_cast<double>(state.settings.airFriction), 0, tickRate, "air friction");
    for (const BodyId id : detail::listedIds(state)) {
        const detail::BodyRecord& body = state.bodies[indexOf(state, id)];
        requireDamping(body.linearDamping, body.angularDamping, tickRate);
    }
    state.rateTime = time();
    state.rateTick = state.tick;
    state.settings.tickRate = tickRate;
    state.h = detail::stepDuration(tickRate);
    state.structure.changed();
}

void World::setDamper(Damper damper) {
    impl_->outside().settings.damper = damper;
}

Real World::airFriction() const {
    return impl_->data.settings.airFriction;
}

void World::setMaterial(BodyId id, const Material& material) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    detail::validate(material);
    changeMaterial(state, state.bodies[index].material, material);
    detail::shapeIsStale(state, id.index - 1);
    detail::wakeTouching(state, index);
}

void World::setFilter(BodyId id, const Filter& filter) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    state.bodies[index].filter = filter;
    detail::shapeIsStale(state, id.index - 1);
    wakeAround(state, index);
    detail::bodyChanged(state);
}

void World::setMaterial(JointId id, const std::optional<Material>& material) {
    State& state = impl_->changing();
    const auto j = indexOf(state, id);
    if (material) detail::validate(*material);
    changeMaterial(state, state.joints.material[j], material.value_or(Material{}));
    state.joints.ownMaterial[j] = material ? 1 : 0;
    for (const auto p : {state.joints.a[j], state.joints.b[j]})
        detail::shapeIsStale(state, state.bodies[state.particles.body[p]].id.index - 1);
    detail::wakeEnds(state, j);
}

void World::setSelfCollision(BodyId id, bool on) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    if (state.bodies[index].selfCollision == on) return;
    state.bodies[index].selfCollision = on;
    detail::shapeIsStale(state, id.index - 1);
    detail::wakeBody(state, index);
    detail::bodyChanged(state);
}

void World::setCollision(BodyId a, BodyId b, bool on) {
    State& state = impl_->changing();
    const auto first = indexOf(state, a), second = indexOf(state, b);
    if (first == second)
        throw Error(ErrorCode::degenerate,
                    "collision of a body with itself; allowed are two bodies, and "
                    "setSelfCollision for one");
    const auto pair = detail::BodyPair::of(a, b);
    auto& vetoes = state.vetoes;
    detail::makeRoom(vetoes, 1);
    const auto at = std::lower_bound(vetoes.begin(), vetoes.end(), pair);
    const bool vetoed = at != vetoes.end() && *at == pair;
    if (vetoed != on) return;
    if (on)
        vetoes.erase(at);
    else
        vetoes.insert(at, pair);
    for (const auto body : {first, second}) {
        wakeAround(state, body);
        detail::shapeIsStale(state, state.bodies[body].id.index - 1);
    }
    detail::bodyChanged(state);
}

void World::setSensor(BodyId id, bool sensor) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    if (state.bodies[index].sensor == sensor) return;
    state.bodies[index].sensor = sensor;
    detail::shapeIsStale(state, id.index - 1);
    std::erase_if(state.sensing.visits,
                  [&](const detail::Visit& visit) { return visit.sensor == id; });
    wakeAround(state, index);
    detail::bodyChanged(state);
}

void World::setGravityScale(BodyId id, Real scale) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    requireRange(static_cast<double>(scale), -1000, 1000, "gravity scale");
    if (scale == state.bodies[index].gravityScale) return;
    detail::wakeTouching(state, index);
    state.bodies[index].gravityScale = scale;
    state.gravityScaled =
        std::any_of(state.bodies.begin(), state.bodies.end(),
                    [](const detail::BodyRecord& body) { return body.gravityScale != 1; });
}

void World::setFixedRotation(BodyId id, bool on) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    if (on == state.bodies[index].fixedRotation) return;
    detail::wakeTouching(state, index);
    state.bodies[index].fixedRotation = on;
    detail::shapeChanged(state, index);
}

void World::setDamping(BodyId id, Real linear, Real angular) {
    State& state = impl_->outside();
    detail::BodyRecord& body = state.bodies[indexOf(state, id)];
    requireDamping(linear, angular, state.settings.tickRate);
    body.linearDamping = linear;
    body.angularDamping = angular;
    state.damped = std::any_of(state.bodies.begin(), state.bodies.end(), detail::isDamped);
}

void World::setUserData(BodyId id, std::uint64_t data) {
    State& state = impl_->outside();
    state.bodies[indexOf(state, id)].userData = data;
}

void World::setStiffness(JointId id, Real stiffness) {
    State& state = impl_->changing();
    const auto j = indexOf(state, id);
    detail::requireNonNegativeOrInfinite(static_cast<double>(stiffness), "stiffness");
    if (stiffness == infinite && state.joints.restLength[j] == 0)
        throw Error(ErrorCode::degenerate,
                    "a joint of rest length 0 cannot be rigid; allowed is a finite stiffness");
    if (stiffness != infinite && state.joints.bend[j].angle != 0)
        throw Error(ErrorCode::outOfRange,
                    "a joint whose capsule is bent is rigid; allowed is an infinite stiffness");
    detail::retune(state, j, {stiffness, state.joints.damping[j]});
}

void World::setDamping(JointId id, Real damping) {
    State& state = impl_->changing();
    const auto j = indexOf(state, id);
    requireRange(static_cast<double>(damping), 0, 1e12, "damping");
    detail::retune(state, j, {state.joints.stiffness[j], damping});
}

void World::setRestLength(JointId id, Real restLength) {
    State& state = impl_->changing();
    const auto j = indexOf(state, id);
    requireRange(static_cast<double>(restLength), 0, 1e9, "rest length");
    if (restLength == 0 && (state.joints.stiffness[j] == infinite || state.joints.radius[j] > 0))
        throw Error(ErrorCode::degenerate,
                    "rest length is 0; a rigid or colliding joint needs more than 0");
    detail::changeRestLength(state, j, restLength);
}

void World::setStrength(JointId id, Real strength) {
    State& state = impl_->changing();
    const auto j = indexOf(state, id);
    detail::requireNonNegativeOrInfinite(static_cast<double>(strength), "strength");
    state.joints.strength[j] = strength;
    detail::jointChanged(state, j);
}

void World::setMass(ParticleId id, Real mass) {
    State& state = impl_->changing();
    const auto i = indexOf(state, id);
    requireRange(static_cast<double>(mass), detail::minMass, detail::maxMass, "mass");
    const auto body = state.particles.body[i];
    const auto first = state.bodies[body].firstParticle;
    for (auto k = first; k < first + state.bodies[body].particles.size(); ++k)
        if (k != i)
            detail::requireMassRatio(static_cast<double>(mass),
                                     static_cast<double>(state.particles.mass[k]), "mass");
    state.particles.mass[i] = mass;
    detail::wakeBody(state, body);
    detail::restoreInverseMass(state, body);
    detail::shapeChanged(state, body);
}

void World::setPosition(ParticleId id, Point position) {
    State& state = impl_->changing();
    const auto i = indexOf(state, id);
    detail::requireWithin(position, maxCoordinate, "position");
    detail::wakeTouching(state, state.particles.body[i]);
    if (state.particles.position[i] == position) return;
    state.particles.position[i] = position;
    const auto slot = state.bodies[state.particles.body[i]].id.index - 1;
    if (state.placed.empty() || state.placed.back() != slot) state.placed.push_back(slot);
    detail::shapeChanged(state, state.particles.body[i]);
    state.particles.displacement[i] = Vec2(0, 0);
    if (state.bodies[state.particles.body[i]].kind != BodyKind::fixed) return;
    detail::wakeNear(state, state.particles.body[i]);
}

void World::setVelocity(ParticleId id, Vec2 velocity) {
    State& state = impl_->changing();
    const auto i = indexOf(state, id);
    detail::requireWithin(velocity, maxSpeed, "velocity");
    detail::refuseFixed(state, state.particles.body[i]);
    detail::makeRoom(state.fresh, 1);
    wakeOwner(state, i);
    state.bodies[state.particles.body[i]].spin = 0;
    detail::setParticleVelocity(state, i, velocity.cast<double>());
}

void World::setVelocity(BodyId id, Vec2 velocity) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    detail::requireWithin(velocity, maxSpeed, "velocity");
    detail::refuseFixed(state, index);
    auto& body = state.bodies[index];
    detail::makeRoom(state.fresh, body.particles.size());
    detail::wakeBody(state, index);
    body.spin = 0;
    body.stopping = false;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k)
        detail::setParticleVelocity(state, body.firstParticle + k, velocity.cast<double>());
}

void World::applyForce(ParticleId id, Vec2 force) {
    State& state = impl_->changing();
    const auto i = indexOf(state, id);
    detail::requireWithin(force, maxForce, "force");
    if (force.isZero(0)) return;
    wakeOwner(state, i);
    const Point sum = state.particles.force[i] + force.cast<double>();
    state.anyForced = true;
    state.particles.force[i] = sum.cwiseMax(-maxForce).cwiseMin(maxForce);
}

void World::applyImpulse(ParticleId id, Vec2 impulse) {
    State& state = impl_->changing();
    const auto i = indexOf(state, id);
    detail::requireWithin(impulse, maxForce, "impulse");
    if (impulse.isZero(0)) return;
    wakeOwner(state, i);
    const Vec2 change = state.particles.inverseMass[i] * impulse;
    state.particles.velocity[i] =
        detail::limited(state.particles.velocity[i] + change.cast<double>());
    detail::stirClusters(state, i);
}

void World::moveTo(BodyId id, const Pose& pose) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    detail::validatePose(pose);
    detail::BodyRecord& body = state.bodies[index];
    if (body.kind != BodyKind::kinematic)
        throw Error(ErrorCode::degenerate,
                    "only a kinematic body can be moved to a pose; this "
                    "one is dynamic or fixed");
    body.target = pose;
    body.moving = true;
    body.spin = 0;
}

void World::wake(BodyId id) {
    State& state = impl_->changing();
    detail::wakeBody(state, indexOf(state, id));
}

bool World::putToSleep(BodyId id) {
    State& state = impl_->changing();
    return detail::sleepIsland(state, indexOf(state, id));
}

void World::setSleepingAllowed(BodyId id, bool allowed) {
    State& state = impl_->changing();
    const auto index = indexOf(state, id);
    state.bodies[index].sleepless = !allowed;
    if (!allowed) detail::wakeBody(state, index);
}

}  // namespace sulfur
