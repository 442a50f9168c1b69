// World: life, time, and looking at things.
#include <algorithm>
#include <cmath>
#include <string>

#include "bodies/mechanism_bodies.hpp"
#include "contacts/stages.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "joints/turn.hpp"
#include "shape/materials.hpp"
#include "solver/coordinates.hpp"
#include "solver/stages.hpp"
#include "trees/tree_solver.hpp"
#include "world/impl.hpp"

namespace sulfur {

namespace detail {

namespace {

template <class Id>
std::uint32_t lookUp(const Slots<Id>& slots, Id id, const char* what) {
    if (slots.contains(id)) return slots.dense(id);
    throw Error(ErrorCode::staleHandle,
                std::string("the ") + what + " handle " + std::to_string(id.index) + ":" +
                    std::to_string(id.generation) + " refers to nothing; allowed is one whose " +
                    what + " is still in this world");
}

void validateSettings(const WorldSettings& settings) {
    for (int axis = 0; axis < 2; ++axis)
        requireRange(static_cast<double>(settings.gravity[axis]), -maxAcceleration, maxAcceleration,
                     "gravity");
    requireRange(settings.tickRate, minTickRate, maxTickRate, "tick rate");
    requireRange(settings.sweeps, 1, 100, "sweeps");
    requireRange(static_cast<double>(settings.airFriction), 0, settings.tickRate, "air friction");
    const auto requireSpeed = [](const std::optional<Real>& speed, const char* what) {
        if (speed) requireRange(static_cast<double>(*speed), 0, maxSpeed, what);
    };
    requireSpeed(settings.sleepSpeed, "sleep speed");
    requireSpeed(settings.reboundSpeed, "rebound speed");
}

}  // namespace

std::uint32_t indexOf(const State& state, ParticleId id) {
    return lookUp(state.particleSlots, id, "particle");
}
std::uint32_t indexOf(const State& state, JointId id) {
    return lookUp(state.jointSlots, id, "joint");
}
std::uint32_t indexOf(const State& state, BodyId id) {
    return lookUp(state.bodySlots, id, "body");
}
std::uint32_t indexOf(const State& state, AttachmentId id) {
    return lookUp(state.attachmentSlots, id, "attachment");
}
std::uint32_t indexOf(const State& state, AngleId id) {
    return lookUp(state.angleSlots, id, "angular joint");
}

}  // namespace detail

void World::Impl::refuseTorn() {
    throw Error(ErrorCode::outOfMemory,
                "the world is in the middle of a tick for which there was no memory; allowed is "
                "World::restore");
}

detail::State& World::Impl::changing() {
    detail::bringMembers(changingKnown());
    return data;
}

detail::State& World::Impl::changingKnown() {
    detail::State& changed = known();
    detail::requireOutside(changed.callbacks);
    detail::makeRoom(changed.turned, changed.bodies.size());
    detail::makeRoom(changed.core.staleShapes, 2);
    detail::makeRoom(changed.placed, 1);
    return changed;
}

using detail::BodyRecord;
using detail::indexOf;
using detail::none;
using detail::State;

const char* name(Stage stage) {
    switch (stage) {
        case Stage::changes:
            return "changes";
        case Stage::forces:
            return "forces";
        case Stage::fields:
            return "fields";
        case Stage::predict:
            return "predict";
        case Stage::broadPhase:
            return "broad phase";
        case Stage::narrowPhase:
            return "narrow phase";
        case Stage::constraints:
            return "constraints";
        case Stage::velocities:
            return "velocities";
        case Stage::breakage:
            return "breakage";
        case Stage::sleep:
            return "sleep";
        case Stage::sensors:
            return "sensors";
        case Stage::count:
            break;
    }
    return "?";
}

World::World(const WorldSettings& settings)
    : impl_(std::make_unique<Impl>()), home_(std::make_unique<World*>(this)) {
    detail::validateSettings(settings);
    impl_->state().settings = settings;
    impl_->state().h = detail::stepDuration(settings.tickRate);
    impl_->state().lastStep = static_cast<double>(impl_->state().h);
}

World::~World() = default;

World::World(World&& other) noexcept
    : impl_(std::move(other.impl_)), home_(std::move(other.home_)) {
    if (home_) *home_ = this;
}

World& World::operator=(World&& other) noexcept {
    impl_ = std::move(other.impl_);
    home_ = std::move(other.home_);
    if (home_) *home_ = this;
    return *this;
}

// --- time ----------------------------------------------------------------------------------

void World::step() {
    State& state = impl_->known();
    detail::requireOutside(state.callbacks);
    try {
        detail::step(state);
    } catch (...) {  // of threads that the host lends, too
        impl_->torn = true;
        state.callbacks.failure = nullptr;
        throw;
    }
    state.callbacks.passOn();
}
std::uint64_t World::ticks() const {
    return impl_->known().tick;
}
double World::time() const {
    const State& state = impl_->known();
    return state.rateTime +
           static_cast<double>(state.tick - state.rateTick) / state.settings.tickRate;
}
Real World::tickDuration() const {
    return 1 / static_cast<Real>(impl_->data.settings.tickRate);
}
const WorldSettings& World::settings() const {
    return impl_->data.settings;
}
const Events& World::events() const {
    return impl_->data.events;
}
const Statistics& World::statistics() const {
    return impl_->data.statistics;
}
void World::setProfiling(bool on) {
    detail::requireOutside(impl_->data.callbacks);
    impl_->data.profiling = on;
}

void World::setTasks(Tasks* tasks) {
    detail::requireOutside(impl_->data.callbacks);
    impl_->data.tasks = tasks;
}

void World::setShouldCollide(ShouldCollide shouldCollide) {
    detail::requireOutside(impl_->data.callbacks);
    impl_->data.callbacks.shouldCollide = std::move(shouldCollide);
}

void World::setPreSolve(PreSolve preSolve) {
    detail::requireOutside(impl_->data.callbacks);
    impl_->data.callbacks.preSolve = std::move(preSolve);
}

// --- looking -------------------------------------------------------------------------------

bool World::contains(BodyId id) const {
    return impl_->known().bodySlots.contains(id);
}
bool World::contains(ParticleId id) const {
    return impl_->known().particleSlots.contains(id);
}
bool World::contains(JointId id) const {
    return impl_->known().jointSlots.contains(id);
}
bool World::contains(AttachmentId id) const {
    return impl_->known().attachmentSlots.contains(id);
}

std::span<const BodyId> World::bodies() const {
    return detail::listedIds(impl_->known());
}

std::vector<JointId> World::connections() const {
    const auto& joints = impl_->state().joints;
    std::vector<JointId> found;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) found.push_back(joints.id[j]);
    return found;
}

Body World::body(BodyId id) {
    indexOf(impl_->state(), id);
    return {*this, id};
}

namespace {
const BodyRecord& record(const State& state, BodyId id) {
    return state.bodies[indexOf(state, id)];
}
}  // namespace

std::span<const ParticleId> World::particles(BodyId id) const {
    return record(impl_->known(), id).particles;
}
std::span<const JointId> World::joints(BodyId id) const {
    return record(impl_->known(), id).joints;
}
const std::string& World::name(BodyId id) const {
    return record(impl_->known(), id).name;
}
BodyKind World::kind(BodyId id) const {
    return record(impl_->known(), id).kind;
}
const Material& World::material(BodyId id) const {
    return record(impl_->known(), id).material;
}
const Material& World::material(JointId id) const {
    const State& state = impl_->state();
    const auto j = indexOf(state, id);
    const auto owner = state.joints.body[j] != detail::none
                           ? state.joints.body[j]
                           : state.particles.body[state.joints.a[j]];
    return detail::surfaceOf(state, j, owner);
}
bool World::selfCollision(BodyId id) const {
    return record(impl_->known(), id).selfCollision;
}
bool World::collision(BodyId a, BodyId b) const {
    const State& state = impl_->state();
    indexOf(state, a);
    indexOf(state, b);
    return !std::binary_search(state.vetoes.begin(), state.vetoes.end(),
                               detail::BodyPair::of(a, b));
}
std::vector<std::pair<BodyId, BodyId>> World::vetoes() const {
    std::vector<std::pair<BodyId, BodyId>> pairs;
    for (const auto& [a, b] : impl_->state().vetoes) pairs.emplace_back(a, b);
    return pairs;
}
const Filter& World::filter(BodyId id) const {
    return record(impl_->known(), id).filter;
}
bool World::sensor(BodyId id) const {
    return record(impl_->known(), id).sensor;
}
std::vector<BodyId> World::visitors(BodyId id) const {
    indexOf(impl_->state(), id);
    std::vector<BodyId> found;
    for (const detail::Visit& visit : impl_->state().sensing.visits)
        if (visit.sensor == id && contains(visit.visitor)) found.push_back(visit.visitor);
    return found;
}
const std::optional<Skin>& World::skin(BodyId id) const {
    return record(impl_->known(), id).skin;
}
std::uint64_t World::userData(BodyId id) const {
    return record(impl_->known(), id).userData;
}
Real World::gravityScale(BodyId id) const {
    return record(impl_->known(), id).gravityScale;
}
bool World::fixedRotation(BodyId id) const {
    return record(impl_->known(), id).fixedRotation;
}
Real World::linearDamping(BodyId id) const {
    return record(impl_->known(), id).linearDamping;
}
Real World::angularDamping(BodyId id) const {
    return record(impl_->known(), id).angularDamping;
}
bool World::isEnabled(BodyId id) const {
    return !record(impl_->known(), id).disabled;
}
bool World::sleepingAllowed(BodyId id) const {
    return !record(impl_->known(), id).sleepless;
}
bool World::asleep(BodyId id) const {
    return record(impl_->known(), id).asleep;
}

Point World::centreOfMass(BodyId id) const {
    const BodyRecord& body = record(impl_->state(), id);
    const auto& p = impl_->state().particles;
    // Relative to the first particle, so that nothing is lost far from the origin.
    const Point origin = p.position[body.firstParticle];
    Point sum(0, 0);
    double mass = 0;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        sum += static_cast<double>(p.mass[i]) * (p.position[i] - origin);
        mass += static_cast<double>(p.mass[i]);
    }
    return origin + sum / mass;
}

Vec2 World::meanVelocity(BodyId id) const {
    const BodyRecord& body = record(impl_->state(), id);
    const auto& p = impl_->state().particles;
    Point sum(0, 0);
    double mass = 0;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        sum += static_cast<double>(p.mass[i]) * p.velocity[i];
        mass += static_cast<double>(p.mass[i]);
    }
    return (sum / mass).cast<Real>();
}

Real World::mass(BodyId id) const {
    const BodyRecord& body = record(impl_->state(), id);
    double sum = 0;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k)
        sum += static_cast<double>(impl_->state().particles.mass[body.firstParticle + k]);
    return static_cast<Real>(sum);
}

ParticleInfo World::info(ParticleId id) const {
    const State& state = impl_->state();
    const auto i = indexOf(state, id);
    const auto& p = state.particles;
    double angle = 0, spin = 0;
    if (p.cluster[i] != none && isDisc(state.clusters.list[p.cluster[i]])) {
        const detail::Cluster& disc = state.clusters.list[p.cluster[i]];
        angle = detail::angleOf(disc.heading);
        spin = disc.spin;
    }
    return {state.bodies[p.body[i]].id,
            p.position[i],
            p.velocity[i].cast<Real>(),
            p.mass[i],
            p.radius[i],
            p.pinned[i] != 0,
            angle,
            spin};
}

JointInfo World::info(JointId id) const {
    const State& state = impl_->state();
    const auto i = indexOf(state, id);
    const auto& j = state.joints;
    return {j.body[i] == none ? BodyId{} : state.bodies[j.body[i]].id,
            state.particles.id[j.a[i]],
            state.particles.id[j.b[i]],
            j.restLength[i],
            j.stiffness[i],
            j.damping[i],
            j.radius[i],
            j.strength[i],
            j.force[i],
            j.bend[i].angle};
}

Point World::position(ParticleId id) const {
    return impl_->state().particles.position[indexOf(impl_->state(), id)];
}

Point World::interpolated(ParticleId id, double alpha) const {
    detail::requireRange(alpha, 0, 1, "interpolated: alpha");
    const auto& p = impl_->state().particles;
    const auto i = indexOf(impl_->state(), id);
    return p.position[i] - (1 - alpha) * p.displacement[i].cast<double>();
}

Vec2 World::velocity(ParticleId id) const {
    return impl_->state().particles.velocity[indexOf(impl_->state(), id)].cast<Real>();
}

namespace {
/// Where a particle was when it had the velocity that is stored: in the middle of its last step.
Point positionOfVelocity(const State& state, std::uint32_t i) {
    const auto& p = state.particles;
    return p.position[i] - detail::lastStepOf(state, i) / 2 * p.velocity[i];
}
double energyOfAngles(const State& state) {
    const auto& j = state.angles;
    double sum = 0;
    for (std::uint32_t i = 0; i < j.size(); ++i) {
        if (j.drive[i]) continue;  // it is among the mechanisms
        const Point corner = positionOfVelocity(state, j.b[i]);
        const Point before = corner - positionOfVelocity(state, j.a[i]);
        const Point after = positionOfVelocity(state, j.c[i]) - corner;
        if (!detail::hasTurn(before, after)) continue;
        const double bend = detail::turnOf(j, i, before, after).bend;
        sum += static_cast<double>(j.stiffness[i]) * bend * bend / 2;
    }
    return sum;
}
}  // namespace

double World::energy() const {
    const State& state = impl_->state();
    const auto& p = state.particles;
    double sum = 0;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        if (state.bodies[p.body[i]].kind != BodyKind::dynamic || p.pinned[i]) continue;
        const auto v = p.velocity[i];
        Point gravity = state.settings.gravity.cast<double>();
        if (state.gravityScaled) gravity += detail::moreGravity(state, p.body[i]);
        sum += static_cast<double>(p.mass[i]) *
               (v.squaredNorm() / 2 - gravity.dot(positionOfVelocity(state, i)));
    }
    for (const detail::Cluster& c : state.clusters.list)
        if (isDisc(c) && canTurn(c)) sum += c.spin * c.spin / (2 * c.freeInverseInertia);
    const auto& j = state.joints;
    for (std::uint32_t i = 0; i < j.size(); ++i) {
        if (j.stiffness[i] == infinite || (j.body[i] == none && isCut(state, i))) continue;
        const Point apart = positionOfVelocity(state, j.b[i]) - positionOfVelocity(state, j.a[i]);
        const double stretch = apart.norm() - static_cast<double>(j.restLength[i]);
        sum += static_cast<double>(j.stiffness[i]) * stretch * stretch / 2;
    }
    for (const detail::Mechanism& m : state.mechanisms.list) {
        const double stiffness = static_cast<double>(m.drive.stiffness);
        if (stiffness == 0 || m.drive.stiffness == infinite || isCut(state, m)) continue;
        const double value =
            valueOf(state, m, detail::RowOf::drive, false) - state.lastStep / 2 * speedOf(state, m);
        sum += stiffness * std::pow(value - static_cast<double>(m.drive.rest), 2) / 2;
    }
    return sum + energyOfAngles(state);
}

}  // namespace sulfur
