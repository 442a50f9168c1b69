// Contacts: projection by the least distance with the masses' shares, and sliding friction.
#include <algorithm>

#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

Vec2 relativeDisplacement(const Particles& particles, const Contact& c) {
    const auto& d = particles.displacement;
    return d[c.particle] - c.weightA * d[c.a] - c.weightB * d[c.b];
}

void push(Particles& particles, const Contact& c, const Vec2& impulse) {
    const auto& w = particles.inverseMass;
    auto& d = particles.displacement;
    d[c.particle] += w[c.particle] * impulse;
    d[c.a] -= c.weightA * w[c.a] * impulse;
    d[c.b] -= c.weightB * w[c.b] * impulse;
}

/// The gap at the end of the tick may not be negative; what was negative at its start is taken
/// back elsewhere (see findContacts), so that it becomes no velocity. The accumulated multiplier
/// never pulls.
void solveNormal(Particles& particles, Contact& c) {
    const Real gap = std::max<Real>(c.gap, 0) + c.normal.dot(relativeDisplacement(particles, c));
    const Real before = c.normalLambda;
    c.normalLambda = std::max<Real>(0, before - gap / c.inverseEffectiveMass);
    push(particles, c, (c.normalLambda - before) * c.normal);
}

/// Friction takes away sliding, by at most its coefficient times the normal multiplier (Coulomb).
void solveFriction(Particles& particles, Contact& c) {
    const Vec2 tangent(-c.normal[1], c.normal[0]);
    const Real slip = tangent.dot(relativeDisplacement(particles, c));
    const Real before = c.tangentLambda;
    const Real most = c.friction * c.normalLambda;
    c.tangentLambda = std::clamp(before - slip / c.inverseEffectiveMass, -most, most);
    push(particles, c, (c.tangentLambda - before) * tangent);
}

/// How deep the sweeps may leave a contact, as a share of its thickness.
constexpr Real guardedDepth = Real(0.25);

}  // namespace

void solveContacts(State& state) {
    for (Contact& contact : state.contacts) {
        solveNormal(state.particles, contact);
        if (contact.friction > 0) solveFriction(state.particles, contact);
    }
}

void guardContacts(State& state) {
    for (Contact& contact : state.contacts) {
        const Vec2 moved = relativeDisplacement(state.particles, contact);
        const Real gap = std::max<Real>(contact.gap, 0) + contact.normal.dot(moved);
        if (gap < -guardedDepth * contact.thickness) solveNormal(state.particles, contact);
    }
}

}  // namespace sulfur::detail
