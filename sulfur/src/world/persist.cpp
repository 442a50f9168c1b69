// World: snapshot, restore, clone, hash, and the check of invariants.
#include <cstring>

#include "core/archive.hpp"
#include "solver/compact.hpp"
#include "trees/networks.hpp"
#include "world/impl.hpp"
#include "world/validate.hpp"

namespace sulfur {

namespace detail {

namespace {

constexpr std::uint64_t snapshotMark = 0x48735f7266756c53u;  // "Slfr_sH", little-endian

/// Everything that decides how the world goes on.
template <class Archive>
void archiveDecisive(Archive& a, State& state) {
    a(state.settings.gravity);
    a(state.settings.airFriction);
    a(state.settings.tickRate);
    a(state.settings.sleeping);
    a(state.settings.sweeps);
    a(state.settings.damper);
    a(state.settings.friction);
    a(state.lastStep);
    a(state.rateTick);
    a(state.rateTime);
    a(state.tick);
    a(state.particles);
    a(state.joints);
    a(state.attachments);
    a(state.clusters);
    a(state.trees);
    a(state.structure);
    a(state.fresh);
    a(state.vetoes);
    a(state.placed);
    a(state.turned);
    a(state.core);
}

template <class Archive>
void archiveAll(Archive& a, State& state) {
    a(state.h);
    a(state.settings.tellPersisting);
    a(state.settings.sleepSpeed);
    a(state.settings.reboundSpeed);
    archiveDecisive(a, state);
    state.structure.archiveAdded(a);
    a(state.bodies);
    for (Cluster& c : state.clusters.list)
        if (isDisc(c)) a(c.headingBefore);
    a(state.discTurns);
    a(state.core.passedBy);
    a(state.gravityScaled);
    a(state.damped);
    a(state.angles);
    a(listedIds(state));
    a(state.gone);
    a(state.particleSlots);
    a(state.jointSlots);
    a(state.bodySlots);
    a(state.attachmentSlots);
    a(state.angleSlots);
    a(state.influences);
    a(state.mechanisms);
    a(state.structureChanged);
    a(state.sensing.visits);
    a(state.core.rollingSurfaces);  // asked before lists are made anew
}

/// Only where they are given: what a world follows without them is in its gravity.
void archiveSlowSpeeds(Hasher& hasher, const WorldSettings& settings) {
    if (!settings.sleepSpeed && !settings.reboundSpeed) return;
    for (Real speed : {settings.sleepSpeed.value_or(-1), settings.reboundSpeed.value_or(-1)})
        hasher(speed);
}

void archiveBodyMotion(Hasher& hasher, State& state) {
    for (BodyRecord& body : state.bodies) {
        hasher(body.id);
        hasher(body.kind);
        hasher(body.asleep);
        hasher(body.moving);
        hasher(body.stopping);
        hasher(body.restingTime);
        hasher(body.nextAsleep);
        hasher(body.selfCollision);
        hasher(body.material);
        hasher(body.filter);
        if (body.sensor) hasher(body.sensor);
        if (body.gravityScale != 1) hasher(body.gravityScale);
        if (body.fixedRotation) hasher(body.fixedRotation);
        if (body.sleepless) hasher(body.sleepless);
        if (body.disabled) hasher(body.disabled);
        if (isDamped(body)) {
            hasher(body.linearDamping);
            hasher(body.angularDamping);
        }
        hasher(body.target.position);
        hasher(body.target.angle);
        if (body.spin == 0) continue;
        hasher(body.spin);
        hasher(body.drift);
    }
}

/// Strengths only where there are any, as worlds without them have always hashed. What drives them
/// is among the mechanisms.
void archiveAngles(Hasher& hasher, Angles& angles) {
    angles.forEachMoving(hasher);
    for (std::uint32_t i = 0; i < angles.size(); ++i) {
        if (angles.strength[i] == infinite) continue;
        hasher(i);
        hasher(angles.strength[i]);
    }
}

/// What the snapshot of this build begins with.
std::uint64_t buildMark() {
    return snapshotMark ^ sizeof(Real) << 56;
}

/// What it ends with: the hash of all before. So whatever was damaged on its way is refused; rows,
/// pairs and lists name each other by numbers, of which one wrong could lead anywhere.
std::uint64_t sealOf(const Snapshot& snapshot, std::size_t count) {
    Hasher hasher;
    hasher.bytes(snapshot.data(), count);
    return hasher.result;
}

[[noreturn]] void refuseDamaged() {
    throw Error(ErrorCode::badSnapshot,
                "the snapshot is damaged; allowed is one that World::snapshot made");
}

/// Throws unless it is whole and of this build.
void requireWhole(const Snapshot& snapshot) {
    std::uint64_t mark = 0, seal = 0;
    if (snapshot.size() < sizeof mark + sizeof seal) refuseDamaged();
    std::memcpy(&mark, snapshot.data(), sizeof mark);
    if (mark != buildMark())
        throw Error(ErrorCode::badSnapshot,
                    "the snapshot is of another version or precision of "
                    "the library; allowed is one of this build");
    const std::size_t count = snapshot.size() - sizeof seal;
    std::memcpy(&seal, snapshot.data() + count, sizeof seal);
    if (seal != sealOf(snapshot, count)) refuseDamaged();
}

}  // namespace

}  // namespace detail

using detail::State;

std::uint64_t World::hash() const {
    detail::Hasher hasher;
    // An archive takes its fields by reference because a reader fills them; the hasher only reads.
    State& state = impl_->outside();
    detail::archiveDecisive(hasher, state);
    if (state.structure.onlyAdded) state.structure.archiveAdded(hasher);
    detail::archiveSlowSpeeds(hasher, state.settings);
    detail::archiveBodyMotion(hasher, state);
    if (!state.discTurns.empty()) hasher(state.discTurns);
    if (!state.core.passedBy.empty()) hasher(state.core.passedBy);
    if (state.angles.size() > 0) detail::archiveAngles(hasher, state.angles);
    if (!state.influences.empty()) {
        hasher(state.influences.fields);
        hasher(state.influences.grabs);
    }
    if (!state.mechanisms.empty()) hasher(state.mechanisms.list);
    return hasher.result;
}

Snapshot World::snapshot() const {
    detail::Writer writer;
    std::uint64_t mark = detail::buildMark();
    writer(mark);
    detail::archiveAll(writer, impl_->outside());
    std::uint64_t seal = detail::sealOf(writer.result, writer.result.size());
    writer(seal);
    writer.result.shrink_to_fit();  // what is kept for long keeps no room to grow
    return std::move(writer.result);
}

void World::restore(const Snapshot& snapshot) {
    detail::requireOutside(impl_->data.callbacks);
    detail::requireWhole(snapshot);
    detail::Reader reader(snapshot);
    std::uint64_t mark = 0, seal = 0;
    reader(mark);
    auto fresh = std::make_unique<Impl>();
    detail::archiveAll(reader, fresh->data);
    reader(seal);
    if (!reader.finished() || !detail::findBroken(fresh->data).empty()) detail::refuseDamaged();
    detail::prepareNetworks(fresh->data);
    detail::countTies(fresh->data);
    fresh->data.profiling = impl_->data.profiling;
    fresh->data.tasks = impl_->data.tasks;
    fresh->data.callbacks = std::move(impl_->data.callbacks);
    impl_ = std::move(fresh);
}

World World::clone() const {
    const State& state = impl_->known();
    World copy(state.settings);
    copy.restore(snapshot());
    State& fresh = copy.impl_->data;
    fresh.events = state.events;
    fresh.statistics = state.statistics;
    fresh.profiling = state.profiling;
    return copy;
}

std::string World::validate() const {
    if (impl_->torn) return "a tick for which there was no memory";
    detail::listedIds(impl_->outside());
    return detail::findBroken(impl_->data);
}

}  // namespace sulfur
