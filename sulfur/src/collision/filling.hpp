// From where a particle and a capsule meet to their contact.
//
// This is done for every contact in every tick: what is small is always inlined, so that what was
// found stays in registers on its way into the contact.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision/contact_plan.hpp"
#include "collision/meeting.hpp"
#include "solver/contact_motion.hpp"
#include "solver/restitution.hpp"

namespace sulfur::detail {

/// A particle and what it is held off, and how they meet.
struct FoundTouch {
    const ContactPlan& plan;
    Meeting meeting;

    bool atCorner() const { return plan.a == plan.b; }
    Real weightA() const { return atCorner() ? 1 : 1 - meeting.along; }
    Real weightB() const { return atCorner() ? 0 : meeting.along; }
    Real gap() const { return meeting.distance - plan.thickness; }
};

/// Three grips on a contact's sides, and the shares that A and B have.
struct Hold {
    Grip particle, a, b;
    Real shareA = 0, shareB = 0;
};

/// What the contact acts on: the capsule's point is one grip if a rigid component has both ends.
[[gnu::always_inline]] inline Hold takeHold(const State& state, const FoundTouch& t) {
    const ContactPlan& plan = t.plan;
    const auto& arm = state.particles.arm;
    const Vec2 &p = arm[plan.particle], &a = arm[plan.a], &b = arm[plan.b];
    const Real weightA = t.weightA(), weightB = t.weightB();
    Hold hold{{plan.particle, plan.clusterOfParticle, Vec2(p[0], p[1])},
              {plan.a, plan.clusterOfA, Vec2(a[0], a[1])},
              {plan.b, plan.clusterOfB, Vec2(b[0], b[1])},
              weightA,
              weightB};
    if (plan.clusterOfA == none || plan.clusterOfA != plan.clusterOfB) return hold;
    hold.a.arm = Vec2(weightA * a[0] + weightB * b[0], weightA * a[1] + weightB * b[1]);
    hold.shareA = 1;
    hold.shareB = 0;
    return hold;
}

/// 1/kg that pushes along the normal and along the tangent meet.
struct InverseMasses {
    Real normal = 0, tangent = 0;

    [[gnu::always_inline]] void add(const State& state, const Grip& grip, Real share,
                                    const Vec2& along) {
        const Real share2 = share * share;
        normal += share2 * inverseMassAlong(state, grip, along);
        tangent += share2 * inverseMassAlong(state, grip, perpendicular(along));
    }
};

/// All but what depends on how it moves. Written in its place, since to copy a contact takes as
/// long as this; and nothing that was just written is read, since a processor waits for what it
/// has to read in other portions than it was written in.
[[gnu::always_inline]] inline void fillContact(const State& state, const FoundTouch& t,
                                               Contact& contact) {
    const ContactPlan& plan = t.plan;
    const Vec2 normal(t.meeting.normal[0], t.meeting.normal[1]);
    const Hold hold = takeHold(state, t);
    InverseMasses masses;
    masses.add(state, hold.particle, 1, normal);
    masses.add(state, hold.a, hold.shareA, normal);
    if (hold.shareB != 0) masses.add(state, hold.b, hold.shareB, normal);
    contact.particle = plan.particle;
    contact.a = plan.a;
    contact.b = plan.b;
    contact.joint = plan.joint;
    contact.bodyA = plan.bodyA;
    contact.bodyB = plan.bodyB;
    contact.weightA = t.weightA();
    contact.weightB = t.weightB();
    contact.gripOfParticle = hold.particle;
    contact.gripOfA = hold.a;
    contact.gripOfB = hold.b;
    contact.shareA = hold.shareA;
    contact.shareB = hold.shareB;
    contact.normal = normal;
    contact.thickness = plan.thickness;
    contact.gap = t.gap();
    contact.inverseEffectiveMass = masses.normal;
    contact.tangentInverseMass = masses.tangent;
    contact.staticFriction = plan.staticFriction;
    contact.kineticFriction = plan.kineticFriction;
    contact.restitution = plan.restitution;
    contact.rough = plan.rough;
    contact.conveyed = state.h * plan.surfaceSpeed;
}

/// What rests may stand this much off the surface: as far as four times the earth's gravity moves
/// it in a tick from rest, but no more than a share of the thickness. Within it a contact only
/// stops what closes it, so that no sweep's remainder sets a stack rocking. (What rebounds does so
/// at the surface itself, and has none.)
inline Real slackOf(const State& state, const Contact& c) {
    return std::min<Real>(Real(0.005) * c.thickness, Real(40) * state.h * state.h);
}

inline bool comesSliding(const Contact& c, const Vec2& moved, Real slip) {
    return std::abs(c.conveyed + perpendicular(c.normal).dot(moved)) > slip;
}

/// Whether it closes or slides, by the predicted motion, by so large a share of its thickness that
/// its direction, which is that of the tick's start, may be wrong at the end.
inline bool isFast(const Contact& c, Real closing, const Vec2& moved) {
    return -closing > Real(0.05) * c.thickness || moved.norm() > Real(0.25) * c.thickness;
}

/// How a particle is inside of a body. Candidates of the same two come one after the other, so that
/// the answer for the last one is mostly that for the next.
struct Inside {
    std::uint32_t particle = none, body = none;
    bool enclosed = false;
    std::uint32_t nearest = none;  // edge of its outline, by joint; none until somebody asks
};

/// The plan of a candidate that has come near for the first time.
struct FirstPlan {
    std::uint32_t watch = 0;  // its number
    ContactPlan plan;
};

/// What a piece of the stage finds.
struct Found {
    std::vector<Contact>& contacts;
    std::vector<std::uint32_t>& knocked;  // sleepers that something ran into
    std::vector<FirstPlan>& plans;
    Real slip = 0;    // m, slipOfRest() of the state
    Inside inside{};  // what was asked last
};

/// A kinematic body that runs into a sleeper can only wake it in this tick.
inline void knock(const State& state, const Contact& c, Real closing, Found& found) {
    if (c.gap + closing > 0) return;
    for (const auto body : {c.bodyA, c.bodyB})
        if (state.bodies[body].asleep) found.knocked.push_back(body);
}

/// Adds the contact if the predicted displacements, which close its gap by so many m, can do so.
[[gnu::always_inline]] inline void keepIfNear(const State& state, const FoundTouch& t,
                                              const Vec2& moved, Real closing, Found& found) {
    const Real near = state.broad.watchedGap(t.plan.thickness);
    if (t.gap() + std::min<Real>(closing, 0) > near) return;
    static const Contact blank;  // to copy it is faster than to clear a new one
    Contact& contact = found.contacts.emplace_back(blank);
    fillContact(state, t, contact);
    if (contact.inverseEffectiveMass == 0) {
        knock(state, contact, closing, found);
        return found.contacts.pop_back();
    }
    contact.approach = -closing / state.h;
    const bool rebounds = mayRebound(contact);
    contact.slack = rebounds ? 0 : slackOf(state, contact);
    contact.sliding = comesSliding(contact, moved, found.slip);
    contact.fast = isFast(contact, closing, moved);
    if (rebounds) planRebound(state, contact);
}

}  // namespace sulfur::detail
