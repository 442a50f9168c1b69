// Mechanisms and angular joints that go: overloaded, removed, or with what they held.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/sleep.hpp"
#include "shape/make_shapes.hpp"
#include "solver/compact.hpp"
#include "solver/coordinates.hpp"
#include "solver/mechanisms.hpp"

namespace sulfur::detail {

namespace {

/// The two bodies may collide again, if it was the mechanism that forbade it and no other one of
/// theirs wants that too.
void allowCollision(State& state, const Mechanism& m) {
    if (m.vetoes == 0) return;
    const auto pair = BodyPair::of(m.a, m.b);
    for (Mechanism& other : state.mechanisms.list) {
        if (other.apart == 0 || BodyPair::of(other.a, other.b) != pair) continue;
        other.vetoes = 1;
        return;
    }
    const auto at = std::lower_bound(state.vetoes.begin(), state.vetoes.end(), pair);
    if (at == state.vetoes.end() || *at != pair) return;
    state.vetoes.erase(at);
    for (const BodyId body : {m.a, m.b})
        if (state.bodySlots.contains(body)) shapeIsStale(state, body.index - 1);
}

void removePins(State& state, const Mechanism& m) {
    const auto isThere = [&](AttachmentId id) { return id && state.attachmentSlots.contains(id); };
    if (std::none_of(m.pins.begin(), m.pins.end(), isThere)) return;
    Removal removal(state);
    for (const AttachmentId pin : m.pins)
        if (isThere(pin)) removal.attachments[state.attachmentSlots.dense(pin)] = true;
    compact(state, removal);
}

/// N or N m, also where a limit pushes against a motor.
Real loadOf(const RowForces& f) {
    return std::max(std::abs(f.spring + f.motor), std::abs(f.lower + f.upper));
}

/// N
Vec2 pinForceOf(const State& state, const Mechanism& m) {
    const bool isPinned = m.pins[0] && state.attachmentSlots.contains(m.pins[0]);
    return isPinned ? state.attachments[state.attachmentSlots.dense(m.pins[0])].force : Vec2(0, 0);
}

/// The load of an angular joint in its strength.
Real loadOf(const Angles& angles, std::uint32_t i) {
    return std::abs(angles.torque[i]) / angles.strength[i];
}

void tellBroken(State& state, std::uint32_t angle, Real torque) {
    const Angles& angles = state.angles;
    state.events.anglesBroken.push_back({angles.id[angle], state.bodies[angles.body[angle]].id,
                                         state.particles.id[angles.b[angle]], torque});
}

}  // namespace

void dropMechanism(State& state, std::uint32_t index) {
    Mechanisms& all = state.mechanisms;
    const Mechanism m = std::move(all.list[index]);
    all.slots.erase(m.id);
    all.list.erase(all.list.begin() + index);
    for (auto i = index; i < all.list.size(); ++i) all.slots.move(all.list[i].id, i);
    for (const BodyId body : {m.a, m.b})
        if (state.bodySlots.contains(body)) wakeBody(state, state.bodySlots.dense(body));
    allowCollision(state, m);
    removePins(state, m);
    for (const BodyId own : m.own)
        if (own && state.bodySlots.contains(own)) removeBody(state, state.bodySlots.dense(own));
    state.structure.changed();
    state.work.changed();
}

void forgetMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    // A gear goes after its parts, which may stand anywhere: until nothing goes any more.
    for (std::size_t before = all.list.size() + 1; all.list.size() < before;) {
        before = all.list.size();
        for (auto i = static_cast<std::uint32_t>(before); i-- > 0;)
            if (i < all.list.size() && !holds(state, all.list[i])) dropMechanism(state, i);
    }
}

void dropAngles(State& state, const std::vector<AngleId>& gone) {
    if (gone.empty()) return;
    Removal removal(state);
    for (const AngleId id : gone) {
        if (!state.angleSlots.contains(id)) continue;
        const auto i = state.angleSlots.dense(id);
        removal.angles[i] = true;
        wakeBody(state, state.angles.body[i]);
    }
    compact(state, removal);
    forgetMechanisms(state);
}

std::vector<AngleId> breakingAngles(State& state) {
    const Angles& angles = state.angles;
    std::vector<AngleId> gone;
    std::uint32_t worst = none;  // of the body that is looked at; they stand body by body
    const auto breakWorst = [&] {
        if (worst == none) return;
        tellBroken(state, worst, std::abs(angles.torque[worst]));
        gone.push_back(angles.id[worst]);
        worst = none;
    };
    for (const auto i : state.work.breakableAngles) {
        if (!(loadOf(angles, i) > 1)) continue;
        if (worst != none && angles.body[worst] != angles.body[i]) breakWorst();
        if (worst == none || loadOf(angles, i) > loadOf(angles, worst)) worst = i;
    }
    breakWorst();
    return gone;
}

void breakMechanisms(State& state) {
    Mechanisms& all = state.mechanisms;
    if (all.empty()) return;
    std::vector<AngleId> gone;
    for (auto i = static_cast<std::uint32_t>(all.list.size()); i-- > 0;) {
        const Mechanism& m = all.list[i];
        if (m.angle && !state.angleSlots.contains(m.angle)) continue;  // gone with a joint
        const Real driven = loadOf(m.forces[0]), held = pinForceOf(state, m).norm();
        if (driven <= m.drive.strength && held <= m.pinStrength) continue;
        if (m.angle) {
            tellBroken(state, state.angleSlots.dense(m.angle), driven);
            gone.push_back(m.angle);
            continue;
        }
        const Real force = held > m.pinStrength ? held : driven;
        state.events.mechanismsBroken.push_back({m.id, m.a, m.b, force});
        dropMechanism(state, i);
    }
    dropAngles(state, gone);
    forgetMechanisms(state);
}

}  // namespace sulfur::detail
