// Stage: force fields act on awake particles.
#include "solver/fields.hpp"

#include <algorithm>

#include "core/limits.hpp"
#include "solver/stages.hpp"
#include "solver/zones.hpp"

namespace sulfur::detail {

namespace {

bool contains(const RadialField& field, const Point& p) {
    return (p - field.centre).norm() <= static_cast<double>(field.reach);
}
template <class Zoned>
bool contains(const Zoned& field, const Point& p) {
    return detail::contains(field.zone, p);
}

Point accelerationAt(const RadialField& field, const Point& p) {
    const Point inwards = field.centre - p;
    const double distance = inwards.norm();
    const double core = static_cast<double>(field.core);
    const double held = std::max(distance, core);
    double size = static_cast<double>(field.strength);
    for (int i = 0; i < field.falloff; ++i) size /= held;
    // Below the core, the distance itself takes the field down to 0.
    return std::clamp(size, -maxAcceleration, maxAcceleration) / held * inwards;
}

/// Calls `act` with each particle of an awake dynamic body on which the field acts.
template <class Kind, class Act>
void forEachIn(State& state, const Kind& field, Act&& act) {
    for (const auto index : state.work.bodies) {
        const BodyRecord& body = state.bodies[index];
        if (body.kind != BodyKind::dynamic) continue;
        if ((body.filter.category & field.mask) == 0) continue;
        state.looked(Stage::fields, body.particles.size());
        const auto last = body.firstParticle + static_cast<std::uint32_t>(body.particles.size());
        for (auto i = body.firstParticle; i < last; ++i)
            if (state.particles.inverseMass[i] != 0 && contains(field, state.particles.position[i]))
                act(i);
    }
}

void push(State& state, const UniformField& field) {
    forEachIn(state, field, [&](std::uint32_t i) {
        state.particles.force[i] += (state.particles.mass[i] * field.acceleration).cast<double>();
    });
}

void push(State& state, const RadialField& field) {
    forEachIn(state, field, [&](std::uint32_t i) {
        state.particles.force[i] += static_cast<double>(state.particles.mass[i]) *
                                    accelerationAt(field, state.particles.position[i]);
    });
}

/// Winds come last, when all other forces are known: they move the velocity v* that those lead to
/// by the share s = h c / (1 + h c / 2) of its distance from the wind's, the trapezoidal rule,
/// which is second order in the tick. Where h c > 2 it would overshoot; s is 1 there. Being applied
/// to v*, a share up to 1 keeps every stable spring stable: with k = 1 - s, the limit of h^2 w^2
/// rises from 4 to 2 (1 + k) / k.
void drag(State& state, const WindField& field) {
    const double h = static_cast<double>(state.h), hc = h * static_cast<double>(field.drag);
    const double share = hc / (1 + std::max(hc / 2, hc - 1));
    const Point gravity = state.settings.gravity.cast<double>();
    const Point wind = field.velocity.cast<double>();
    forEachIn(state, field, [&](std::uint32_t i) {
        Particles& p = state.particles;
        const double w = static_cast<double>(p.inverseMass[i]);
        const Point reached = p.velocity[i] + h * (gravity + w * p.force[i]);
        p.force[i] += static_cast<double>(p.mass[i]) / h * share * (wind - reached);
    });
}

/// Where the gravity of a body is not the world's, the difference is a force.
void scaleGravity(State& state) {
    for (const auto index : state.work.bodies) {
        const BodyRecord& body = state.bodies[index];
        if (body.kind != BodyKind::dynamic || body.gravityScale == 1) continue;
        state.anyForced = true;
        const Point more = moreGravity(state, index);
        const auto last = body.firstParticle + static_cast<std::uint32_t>(body.particles.size());
        for (auto i = body.firstParticle; i < last; ++i)
            if (state.particles.inverseMass[i] != 0)
                state.particles.force[i] += static_cast<double>(state.particles.mass[i]) * more;
    }
}

}  // namespace

bool actsOn(const State& state, const Field& field, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    return std::visit(
        [&](const auto& one) {
            if ((body.filter.category & one.mask) == 0) return false;
            for (std::uint32_t k = 0; k < body.particles.size(); ++k)
                if (contains(one, state.particles.position[body.firstParticle + k])) return true;
            return false;
        },
        field);
}

void applyFields(State& state) {
    if (state.gravityScaled) scaleGravity(state);
    const auto& fields = state.influences.fields;
    if (!fields.empty()) state.anyForced = true;
    for (const FieldRecord& record : fields) {
        if (const auto* uniform = std::get_if<UniformField>(&record.field)) push(state, *uniform);
        if (const auto* radial = std::get_if<RadialField>(&record.field)) push(state, *radial);
    }
    for (const FieldRecord& record : fields)
        if (const auto* wind = std::get_if<WindField>(&record.field)) drag(state, *wind);
    if (state.damped) dampBodies(state);
}

}  // namespace sulfur::detail
