// Stage: candidates to contacts.
//
// Two segments that do not cross are nearest at an end of one of them, so particle against
// capsule is all there is in two dimensions, beside pairs that cross already.
//
// Contacts are found for the positions at the start of the tick, where nothing has passed through
// anything yet, and kept when the predicted displacements could close the gap. The constraint
// gap + n . d >= 0 then stops even what would jump over a thin wall within one tick.
#include <algorithm>
#include <cmath>

#include "collision/geometry.hpp"
#include "rigid/grip.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// Share of an overlap that is taken back in a tick, and the speed that this may not exceed.
constexpr Real recoveryShare = Real(0.3);
constexpr Real recoverySpeed = 1;  // m/s

/// Positions of a particle and a capsule relative to the capsule's first end.
struct Local {
    Vec2 p, b;        // at the start of the tick
    Vec2 dp, da, db;  // displacements
};

Local localise(const Particles& particles, std::uint32_t p, const Collider& c) {
    const auto& x = particles.position;
    return {(x[p] - x[c.a]).cast<Real>(), (x[c.b] - x[c.a]).cast<Real>(), particles.displacement[p],
            particles.displacement[c.a], particles.displacement[c.b]};
}

struct Meeting {
    Real along = 0;
    Vec2 normal{0, 0};
    Real distance = 0;  // from the capsule's axis, along the normal
};

/// Beside the segment: the normal is the segment's own, on the particle's side.
Meeting meetSide(const Local& l, Real along) {
    Meeting m;
    m.along = along;
    m.normal = Vec2(-l.b[1], l.b[0]) / l.b.norm();
    m.distance = m.normal.dot(l.p);
    if (m.distance < 0) {
        m.normal = -m.normal;
        m.distance = -m.distance;
    }
    return m;
}

/// At an end of the segment: the normal points from that end to the particle.
Meeting meetEnd(const Local& l, Real along) {
    Meeting m;
    m.along = along;
    const Vec2 offset = l.p - along * l.b;
    m.distance = offset.norm();
    if (m.distance > 0)
        m.normal = offset / m.distance;
    else
        m.normal = l.b.norm() > 0 ? Vec2(Vec2(-l.b[1], l.b[0]).normalized()) : Vec2(0, 1);
    return m;
}

/// Where the particle and the capsule meet, for the positions at the start of the tick.
///
/// A particle that slides along a chain of capsules would touch the rounded end of the next one
/// before it is beside it, which makes a bump. So when it will be beside it at the end of the tick,
/// and is about as far from its axis as it would be then, it meets the side at once.
Meeting meet(const Local& l, Real thickness) {
    const Vec2 origin(0, 0);
    const Real start = nearestAlong(l.p, origin, l.b);
    if (start > 0 && start < 1) return meetSide(l, start);
    const Real end = nearestAlong<Vec2>(l.p + l.dp - l.da, origin, l.b + l.db - l.da);
    if (end > 0 && end < 1) {
        const Meeting side = meetSide(l, end);
        if (side.distance > Real(0.7) * thickness) return side;
    }
    return meetEnd(l, start);
}

struct MixedMaterial {
    Real friction, restitution;
};

MixedMaterial mix(const Material& a, const Material& b) {
    return {std::sqrt(a.kineticFriction * b.kineticFriction),
            std::max(a.restitution, b.restitution)};
}

/// What the contact acts on: the capsule's point is one grip if a rigid component has both ends.
void takeHold(const State& state, Contact& c) {
    c.gripOfParticle = gripOf(state, c.particle);
    c.gripOfA = gripOf(state, c.a);
    c.gripOfB = gripOf(state, c.b);
    c.shareA = c.weightA;
    c.shareB = c.weightB;
    if (c.gripOfA.cluster == none || c.gripOfA.cluster != c.gripOfB.cluster) return;
    c.gripOfA.arm = c.weightA * c.gripOfA.arm + c.weightB * c.gripOfB.arm;
    c.shareA = 1;
    c.shareB = 0;
}

Real inverseMassAlong(const State& state, const Contact& c, const Vec2& direction) {
    Real w = detail::inverseMassAlong(state, c.gripOfParticle, direction) +
             c.shareA * c.shareA * detail::inverseMassAlong(state, c.gripOfA, direction);
    if (c.shareB != 0)
        w += c.shareB * c.shareB * detail::inverseMassAlong(state, c.gripOfB, direction);
    return w;
}

Contact makeContact(const State& state, const Candidate& candidate, const Collider& c,
                    const Meeting& m, Real thickness) {
    Contact contact;
    contact.particle = candidate.particle;
    contact.a = c.a;
    contact.b = c.b;
    contact.bodyA = state.particles.body[candidate.particle];
    contact.bodyB = c.body;
    contact.weightA = c.a == c.b ? 1 : 1 - m.along;
    contact.weightB = c.a == c.b ? 0 : m.along;
    contact.normal = m.normal;
    contact.thickness = thickness;
    contact.gap = m.distance - thickness;
    takeHold(state, contact);
    contact.inverseEffectiveMass = inverseMassAlong(state, contact, contact.normal);
    contact.tangentInverseMass = inverseMassAlong(state, contact, perpendicular(contact.normal));
    const auto material =
        mix(state.bodies[contact.bodyA].material, state.bodies[contact.bodyB].material);
    contact.friction = material.friction;
    contact.restitution = material.restitution;
    return contact;
}

Vec2 relativeDisplacement(const Particles& particles, const Contact& c) {
    const auto& d = particles.displacement;
    return d[c.particle] - c.weightA * d[c.a] - c.weightB * d[c.b];
}

/// Adds the contact if the predicted displacements could close its gap.
void keepIfNear(State& state, Contact contact) {
    if (contact.inverseEffectiveMass == 0) return;
    const Real closing = contact.normal.dot(relativeDisplacement(state.particles, contact));
    if (contact.gap + std::min<Real>(closing, 0) > state.broad.baseSkin / 4) return;
    contact.approach = -closing / state.h;
    state.contacts.push_back(contact);
}

Real thicknessOf(const State& state, const Candidate& candidate) {
    return state.particles.reach[candidate.particle] +
           state.broad.collider(candidate.collider).radius;
}

/// For two capsules that cross, the end that is nearest to the other's axis is led back to the
/// side that it came from.
struct Crossing {
    Candidate end;
    Meeting meeting;
};

void considerEnd(const State& state, std::uint32_t particle, std::uint32_t collider,
                 Crossing& best) {
    const Local local = localise(state.particles, particle, state.broad.collider(collider));
    const Meeting m = meet(local, thicknessOf(state, {particle, collider}));
    if (m.distance < best.meeting.distance) best = {{particle, collider}, m};
}

void findCrossings(State& state, std::vector<Crossing>& found) {
    const BroadPhase& broad = state.broad;
    const auto& x = state.particles.position;
    for (const auto pair : broad.pairs) {
        const auto i = static_cast<std::uint32_t>(pair >> 32);
        const auto j = static_cast<std::uint32_t>(pair);
        const Collider& a = broad.collider(i);
        const Collider& b = broad.collider(j);
        if (a.a == a.b || b.a == b.b || !segmentsCross(x[a.a], x[a.b], x[b.a], x[b.b])) continue;
        Crossing best;
        best.meeting.distance = std::numeric_limits<Real>::max();
        considerEnd(state, a.a, j, best);
        considerEnd(state, a.b, j, best);
        considerEnd(state, b.a, i, best);
        considerEnd(state, b.b, i, best);
        found.push_back(best);
    }
    std::sort(found.begin(), found.end(),
              [](const Crossing& a, const Crossing& b) { return a.end < b.end; });
}

bool isCrossing(const std::vector<Crossing>& crossings, const Candidate& candidate) {
    const auto at = std::lower_bound(
        crossings.begin(), crossings.end(), candidate,
        [](const Crossing& crossing, const Candidate& c) { return crossing.end < c; });
    return at != crossings.end() && at->end == candidate;
}

/// Takes back a share of the overlap that was there before the tick by moving positions, not
/// displacements, so that it leaves no velocity behind and nothing is thrown apart.
void recover(State& state, Contact& contact) {
    if (contact.gap >= 0) return;
    const Real push = std::min(-contact.gap * recoveryShare, recoverySpeed * state.h);
    const Vec2 impulse = push / contact.inverseEffectiveMass * contact.normal;
    shift(state, contact.gripOfParticle, impulse);
    shift(state, contact.gripOfA, -contact.shareA * impulse);
    if (contact.shareB != 0) shift(state, contact.gripOfB, -contact.shareB * impulse);
}

}  // namespace

void findContacts(State& state) {
    state.contacts.clear();
    thread_local std::vector<Crossing> crossings;  // nearly always empty
    crossings.clear();
    findCrossings(state, crossings);
    for (const Candidate& candidate : state.broad.candidates) {
        const Collider& c = state.broad.collider(candidate.collider);
        if (!crossings.empty() && isCrossing(crossings, candidate)) continue;
        const Real thickness = thicknessOf(state, candidate);
        const Meeting m = meet(localise(state.particles, candidate.particle, c), thickness);
        keepIfNear(state, makeContact(state, candidate, c, m, thickness));
    }
    for (Crossing& crossing : crossings) {
        crossing.meeting.normal = -crossing.meeting.normal;
        crossing.meeting.distance = -crossing.meeting.distance;
        keepIfNear(state,
                   makeContact(state, crossing.end, state.broad.collider(crossing.end.collider),
                               crossing.meeting, thicknessOf(state, crossing.end)));
    }
    for (Contact& contact : state.contacts) recover(state, contact);
    state.statistics.contacts = static_cast<std::uint32_t>(state.contacts.size());
}

}  // namespace sulfur::detail
