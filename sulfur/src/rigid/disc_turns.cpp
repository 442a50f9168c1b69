#include "rigid/disc_turns.hpp"

#include <algorithm>
#include <utility>

#include "core/limits.hpp"

namespace sulfur::detail {

namespace {

/// Where a disc stands in the list, or would.
template <class List>
auto placeIn(List& list, ParticleId id) {
    return std::lower_bound(
        list.begin(), list.end(), id,
        [](const DiscTurn& turn, ParticleId other) { return turn.disc < other; });
}

const DiscTurn* find(const State& state, ParticleId id) {
    const auto at = placeIn(state.discTurns, id);
    return at != state.discTurns.end() && at->disc == id ? &*at : nullptr;
}

DiscTurn& findOrAdd(State& state, ParticleId id) {
    const auto at = placeIn(state.discTurns, id);
    if (at != state.discTurns.end() && at->disc == id) return *at;
    return *state.discTurns.insert(at, DiscTurn{.disc = id});
}

bool isKnown(const State& state, std::uint32_t particle) {
    const auto cluster = state.particles.cluster[particle];
    return cluster != none && isDisc(state.clusters.list[cluster]);
}

/// rad/s, with which the rim of a disc goes as fast as anything may.
double mostSpin(const State& state, std::uint32_t particle) {
    return maxSpeed / static_cast<double>(state.particles.radius[particle]);
}

}  // namespace

double spinOf(const State& state, std::uint32_t particle) {
    const DiscTurn* asked = find(state, state.particles.id[particle]);
    if (asked && asked->spun) return asked->spin;
    return isKnown(state, particle) ? state.clusters.list[state.particles.cluster[particle]].spin
                                    : 0;
}

void setSpin(State& state, std::uint32_t particle, double spin) {
    const double most = mostSpin(state, particle), kept = std::clamp(spin, -most, most);
    if (isKnown(state, particle)) {
        Cluster& disc = state.clusters.list[state.particles.cluster[particle]];
        if (!state.bodies[disc.body].fixedRotation) disc.spin = kept;
        return;
    }
    DiscTurn& asked = findOrAdd(state, state.particles.id[particle]);
    asked.spin = kept;
    asked.spun = true;
}

void addTorque(State& state, std::uint32_t particle, double torque) {
    DiscTurn& asked = findOrAdd(state, state.particles.id[particle]);
    asked.torque = std::clamp(asked.torque + torque, -maxForce, maxForce);
}

double torqueOn(const State& state, const Cluster& disc) {
    if (state.discTurns.empty() || disc.inverseInertia == 0) return 0;
    const auto particle = state.clusters.members[disc.first];
    const DiscTurn* asked = find(state, state.particles.id[particle]);
    if (!asked || asked->torque == 0) return 0;
    const double most = mostSpin(state, particle);
    const double perSpin = 1 / (static_cast<double>(state.h) * disc.freeInverseInertia);
    return std::clamp(asked->torque, std::min(0.0, (-most - disc.spin) * perSpin),
                      std::max(0.0, (most - disc.spin) * perSpin));
}

void takeSpins(State& state) {
    for (DiscTurn& asked : state.discTurns) {
        if (!std::exchange(asked.spun, false) || !state.particleSlots.contains(asked.disc))
            continue;
        const auto particle = state.particleSlots.dense(asked.disc);
        if (isKnown(state, particle)) setSpin(state, particle, asked.spin);
    }
}

}  // namespace sulfur::detail
