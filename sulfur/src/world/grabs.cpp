// World: grabbing things.
#include "solver/grabs.hpp"
#include "bodies/sleep.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "core/trigonometry.hpp"
#include "particles/motion.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::Grab;
using detail::indexOf;
using detail::State;

namespace detail {

Real movableMass(const State& state, std::uint32_t body) {
    const auto& record = state.bodies[body];
    double sum = 0;
    for (std::uint32_t k = 0; k < record.particles.size(); ++k) {
        const auto i = record.firstParticle + k;
        if (!state.particles.pinned[i]) sum += static_cast<double>(state.particles.mass[i]);
    }
    return static_cast<Real>(sum);
}

}  // namespace detail

namespace {

void validate(const GrabOptions& options) {
    detail::requirePositive(static_cast<double>(options.frequency), "grab: frequency");
    detail::requireRange(static_cast<double>(options.frequency), 0, 1000, "grab: frequency");
    detail::requireRange(static_cast<double>(options.dampingRatio), 0, 100, "grab: damping ratio");
    if (!options.maxForce || *options.maxForce == infinite) return;
    detail::requirePositive(static_cast<double>(*options.maxForce), "grab: max force");
}

void validateTarget(const Point& target) {
    for (int axis = 0; axis < 2; ++axis)
        detail::requireRange(target[axis], -detail::maxCoordinate, detail::maxCoordinate,
                             "grab: target");
}

/// `held` says what to hold, as an attachment does; its own particle means nothing.
GrabId addGrab(State& state, const detail::Attachment& held, const Point& target,
               const GrabOptions& options) {
    validate(options);
    validateTarget(target);
    const auto body = state.particles.body[held.support[0]];
    if (state.bodies[body].kind != BodyKind::dynamic)
        throw Error(ErrorCode::degenerate,
                    "a fixed or kinematic body cannot be grabbed; allowed is a dynamic one");
    const Real mass = detail::movableMass(state, body);
    const Real omega = static_cast<Real>(detail::fullTurn) * options.frequency;
    Grab grab;
    grab.count = held.count;
    grab.weight = held.weight;
    for (std::uint32_t k = 0; k < held.count; ++k)
        grab.support[k] = state.particles.id[held.support[k]];
    grab.target = target;
    grab.stiffness = mass * omega * omega;
    grab.damping = 2 * options.dampingRatio * mass * omega;
    grab.maxForce = options.maxForce.value_or(Real(981) * mass);
    auto& influences = state.influences;
    detail::makeRoom(influences.grabs, 1);
    influences.grabSlots.makeRoom(1);
    grab.id = influences.grabSlots.insert(static_cast<std::uint32_t>(influences.grabs.size()));
    influences.grabs.push_back(grab);
    detail::wakeBody(state, body);
    return grab.id;
}

std::uint32_t indexOfGrab(const State& state, GrabId id) {
    const auto& slots = state.influences.grabSlots;
    if (slots.contains(id) && detail::holds(state, state.influences.grabs[slots.dense(id)]))
        return slots.dense(id);
    throw Error(ErrorCode::staleHandle, "the grab handle " + std::to_string(id.index) + ":" +
                                            std::to_string(id.generation) +
                                            " refers to nothing; allowed is one that was not "
                                            "released and whose body is still in this world");
}

void wakeHeld(State& state, const Grab& grab) {
    detail::wakeBody(state, state.particles.body[state.particleSlots.dense(grab.support[0])]);
}

}  // namespace

GrabId World::grab(ParticleId particle, Point target, const GrabOptions& options) {
    State& state = impl_->changing();
    detail::Attachment held;
    held.count = 1;
    held.support[0] = indexOf(state, particle);
    held.weight[0] = 1;
    return addGrab(state, held, target, options);
}

GrabId World::grab(BodyId body, Vec2 localPoint, Point target, const GrabOptions& options) {
    State& state = impl_->changing();
    const auto index = indexOf(state, body);
    detail::requireFinite(localPoint, "local point");
    const detail::Attachment held = detail::supportsFor(state, index, localPoint);
    for (const Real weight : held.weight)
        detail::requireRange(static_cast<double>(weight), -detail::farthestSupport,
                             detail::farthestSupport,
                             "local point: its distance in sizes of the body");
    return addGrab(state, held, target, options);
}

void World::setTarget(GrabId id, Point target) {
    State& state = impl_->changing();
    Grab& grab = state.influences.grabs[indexOfGrab(state, id)];
    validateTarget(target);
    if (target == grab.target) return;
    grab.target = target;
    wakeHeld(state, grab);
}

void World::release(GrabId id) {
    State& state = impl_->changing();
    const auto index = indexOfGrab(state, id);
    auto& influences = state.influences;
    influences.grabSlots.makeRoom(0);
    wakeHeld(state, influences.grabs[index]);
    influences.grabSlots.erase(id);
    influences.grabs.erase(influences.grabs.begin() + index);
    for (auto i = index; i < influences.grabs.size(); ++i)
        influences.grabSlots.move(influences.grabs[i].id, i);
}

bool World::contains(GrabId id) const {
    const auto& influences = impl_->state().influences;
    return influences.grabSlots.contains(id) &&
           detail::holds(impl_->state(), influences.grabs[influences.grabSlots.dense(id)]);
}

std::vector<GrabId> World::grabs() const {
    std::vector<GrabId> found;
    for (const Grab& grab : impl_->state().influences.grabs)
        if (detail::holds(impl_->state(), grab)) found.push_back(grab.id);
    return found;
}

GrabInfo World::info(GrabId id) const {
    const State& state = impl_->state();
    const Grab& grab = state.influences.grabs[indexOfGrab(state, id)];
    GrabInfo info;
    info.target = grab.target;
    info.force = detail::newtonsPerMultiplier(state) * grab.impulse;
    for (std::uint32_t k = 0; k < grab.count; ++k) {
        const auto i = state.particleSlots.dense(grab.support[k]);
        info.body = state.bodies[state.particles.body[i]].id;
        info.point += static_cast<double>(grab.weight[k]) * state.particles.position[i];
    }
    return info;
}

}  // namespace sulfur
