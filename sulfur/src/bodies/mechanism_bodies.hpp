// Which bodies a mechanism ties to each other.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Calls f(body, other) (dense) for pairs that link all of them.
template <class Function>
void forEachTieOf(const State& state, const Mechanism& m, Function&& f) {
    std::uint32_t first = none;
    const auto add = [&](ParticleId id) {
        if (!id) return;
        const auto body = state.particles.body[state.particleSlots.dense(id)];
        if (first == none) first = body;
        if (body != first) f(first, body);
    };
    const auto addAll = [&](const Mechanism& part) {
        for (const MechanismPoint& point : part.points)
            if (point.count > 0) add(point.support[0]);
        for (const MechanismArm& arm : part.arms) add(arm.from);
    };
    addAll(m);
    if (m.kind != MechanismKind::gear) return;
    for (const MechanismId part : m.parts)
        addAll(state.mechanisms.list[state.mechanisms.slots.dense(part)]);
}

/// Whether it does nothing, because a body of it takes no part.
inline bool isCut(const State& state, const Mechanism& m) {
    bool cut = state.bodies[state.bodySlots.dense(m.a)].disabled ||
               state.bodies[state.bodySlots.dense(m.b)].disabled;
    forEachTieOf(state, m, [&](std::uint32_t a, std::uint32_t b) {
        cut |= state.bodies[a].disabled || state.bodies[b].disabled;
    });
    return cut;
}

}  // namespace sulfur::detail
