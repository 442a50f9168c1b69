// Contacts: projection by the least distance with the masses' shares, and sliding friction.
#include <algorithm>
#include <cmath>

#include "rigid/grip.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

Vec2 relativeDisplacement(const State& state, const Contact& c) {
    Vec2 moved =
        displacementOf(state, c.gripOfParticle) - c.shareA * displacementOf(state, c.gripOfA);
    if (c.shareB != 0) moved -= c.shareB * displacementOf(state, c.gripOfB);
    return moved;
}

void push(State& state, const Contact& c, const Vec2& impulse) {
    push(state, c.gripOfParticle, impulse);
    push(state, c.gripOfA, -c.shareA * impulse);
    if (c.shareB != 0) push(state, c.gripOfB, -c.shareB * impulse);
}

/// The gap at the end of the tick may not be negative; what was negative at its start is taken
/// back elsewhere (see findContacts), so that it becomes no velocity. The accumulated multiplier
/// never pulls.
void solveNormal(State& state, Contact& c) {
    const Real gap = std::max<Real>(c.gap, 0) + c.normal.dot(relativeDisplacement(state, c));
    const Real before = c.normalLambda;
    c.normalLambda = std::max<Real>(0, before - gap / c.inverseEffectiveMass);
    push(state, c, (c.normalLambda - before) * c.normal);
}

Vec2 tangentOf(const Contact& c) {
    return {-c.normal[1], c.normal[0]};
}

/// Friction takes away sliding, by at most its coefficient times the normal multiplier (Coulomb);
/// also what was left of it in the ticks before, back to the place where the contact sticks.
void solveFriction(State& state, Contact& c) {
    if (c.tangentInverseMass == 0) return;  // held by a pin in that direction
    const Vec2 tangent = tangentOf(c);
    const Real slip = c.drift + tangent.dot(relativeDisplacement(state, c));
    const Real before = c.tangentLambda;
    const Real most = c.friction * c.normalLambda;
    c.tangentLambda = std::clamp(before - slip / c.tangentInverseMass, -most, most);
    push(state, c, (c.tangentLambda - before) * tangent);
}

/// How deep the sweeps may leave a contact, as a share of its thickness.
constexpr Real guardedDepth = Real(0.25);

}  // namespace

void warmStartContacts(State& state) {
    const auto& memory = state.contactMemory;
    for (Contact& c : state.contacts) {
        const ContactMemory key{c.particle, c.a, c.b, 0, 0, 0};
        const auto at = std::lower_bound(memory.begin(), memory.end(), key);
        if (at == memory.end() || key < *at) continue;
        c.drift = at->drift;
        c.normalLambda = at->normalLambda;
        const Real most = c.friction * c.normalLambda;
        c.tangentLambda = std::clamp(at->tangentLambda, -most, most);
        push(state, c, c.normalLambda * c.normal + c.tangentLambda * tangentOf(c));
    }
}

void rememberContacts(State& state) {
    auto& memory = state.contactMemory;
    memory.clear();
    for (const Contact& c : state.contacts) {
        if (c.normalLambda <= 0) continue;
        const bool sticks = std::abs(c.tangentLambda) < c.friction * c.normalLambda;
        const Real slip = tangentOf(c).dot(relativeDisplacement(state, c));
        memory.push_back(
            {c.particle, c.a, c.b, c.normalLambda, c.tangentLambda, sticks ? c.drift + slip : 0});
    }
    std::sort(memory.begin(), memory.end());
}

void solveContacts(State& state) {
    for (Contact& contact : state.contacts) {
        solveNormal(state, contact);
        if (contact.friction > 0) solveFriction(state, contact);
    }
}

void guardContacts(State& state) {
    for (Contact& contact : state.contacts) {
        const Vec2 moved = relativeDisplacement(state, contact);
        const Real gap = std::max<Real>(contact.gap, 0) + contact.normal.dot(moved);
        if (gap < -guardedDepth * contact.thickness) solveNormal(state, contact);
    }
}

}  // namespace sulfur::detail
