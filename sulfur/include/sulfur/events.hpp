/// \file
/// What happened during the last tick.
#pragma once

#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur {

/// Two bodies began to touch: they push each other in this tick and did not in the one before. The
/// point and the normal are those of the contact that pushes most. A blow without rebound may be
/// spread over this tick and the next, so that the whole momentum of a landing is the sum of this
/// impulse and those of the first ContactPersisted. What others call hit events are those of them
/// whose speed is above a threshold, such as 1 m/s.
struct ContactBegun {
    BodyId a = {};      ///< the body whose particle touches
    BodyId b = {};      ///< the other
    Point point{0, 0};  ///< metres, on the surface of a
    Vec2 normal{0, 0};  ///< unit length, from b towards a
    Real speed = 0;     ///< m/s at which they approached along the normal, >= 0
    Real impulse = 0;  ///< N s along their normals, of all their contacts in this tick, rebound too
};

/// Two bodies touched in the last tick and still do. Told only while WorldSettings::tellPersisting
/// is on, and not of sleepers.
struct ContactPersisted {
    BodyId a = {};      ///< the body whose particle touches
    BodyId b = {};      ///< the other
    Point point{0, 0};  ///< metres, on the surface of a: of the contact that pushes most
    Vec2 normal{0, 0};  ///< unit length, of the same, from b towards a
    Real impulse = 0;   ///< N s, as in ContactBegun; over the tick's duration it is the mean force
};

/// Two bodies touched in the last tick and no longer do: they parted, one was removed, or they may
/// no longer collide. Told in the next tick. Falling asleep and waking end nothing.
struct ContactEnded {
    BodyId a = {};  ///< one; its handle is no longer valid if the body was removed
    BodyId b = {};  ///< the other; likewise
};

/// A joint was loaded beyond its strength and is gone.
struct JointBroken {
    JointId joint = {};  ///< no longer valid; for comparison only
    BodyId body = {};    ///< null for a joint between bodies
    Point point{0, 0};   ///< metres: its middle
    Real force = 0;      ///< newtons at which it broke
};

/// A body whose joints broke has fallen apart: what no joint of its own connects any more became a
/// body of its own, with the same material, filter, name and user data.
struct BodySplit {
    BodyId body = {};   ///< the heaviest part, which keeps the old handle
    BodyId piece = {};  ///< the new one
};

/// A particle is gone because what broke off with it has no surface left: neither a joint that
/// collides nor a radius of its own.
struct ParticleLost {
    ParticleId particle = {};  ///< no longer valid; for comparison only
    BodyId body = {};          ///< whose it was; no longer valid if that was its last particle
    Point point{0, 0};         ///< metres: where it was
};

/// A body came into a sensor; see World::setSensor.
struct SensorEntered {
    BodyId sensor = {};   ///< what felt it
    BodyId visitor = {};  ///< what came
};

/// A body left a sensor, or was removed while it was in one.
struct SensorLeft {
    BodyId sensor = {};   ///< what felt it
    BodyId visitor = {};  ///< what left; no longer valid when it was removed
};

/// A limit of a mechanism or of an angular joint began to push; see Drive.
struct LimitReached {
    MechanismId mechanism = {};  ///< whose, or null
    bool upper = false;          ///< which of both
    AngleId angle = {};          ///< the angular joint whose limit it is, or null
};

/// Such a limit no longer pushes.
struct LimitLeft {
    MechanismId mechanism = {};  ///< whose, or null
    bool upper = false;          ///< which of both
    AngleId angle = {};          ///< the angular joint whose limit it is, or null
};

/// A mechanism was loaded beyond the strength of its drive and is gone.
struct MechanismBroken {
    MechanismId mechanism = {};  ///< no longer valid; for comparison only
    BodyId a = {};               ///< one of its bodies
    BodyId b = {};               ///< the other one
    Real force = 0;              ///< N m or N at which it broke
};

/// An angular joint was loaded beyond its strength and is gone. What it bent stays together.
struct AngleBroken {
    AngleId angle = {};      ///< no longer valid; for comparison only
    BodyId body = {};        ///< whose it was
    ParticleId corner = {};  ///< where
    Real torque = 0;         ///< N m at which it broke
};

/// Events of one tick, overwritten by the next World::step. The order is fixed: joints oldest
/// first, pairs of bodies by the smaller of their handles, then the larger, each pair at most once.
/// Of a tick of several steps (Statistics::substeps), joints and sensors of its steps stand one
/// after the other. Of sensors no contacts are told. World::restore() leaves no events.
struct Events {
    std::vector<ContactBegun> contactsBegun = {};          ///< bodies that began to touch
    std::vector<ContactPersisted> contactsPersisted = {};  ///< bodies that go on touching
    std::vector<ContactEnded> contactsEnded = {};          ///< bodies that no longer touch
    std::vector<JointBroken> jointsBroken = {};            ///< joints that broke
    std::vector<BodySplit> bodiesSplit = {};               ///< bodies that fell apart
    std::vector<ParticleLost> particlesLost = {};          ///< particles left without a joint
    /// Bodies that came into sensors, by the ids of sensor and visitor.
    std::vector<SensorEntered> sensorsEntered = {};
    /// Bodies that left sensors, in the same order.
    std::vector<SensorLeft> sensorsLeft = {};
    std::vector<LimitReached> limitsReached = {};        ///< limits that began to push
    std::vector<LimitLeft> limitsLeft = {};              ///< limits that no longer push
    std::vector<MechanismBroken> mechanismsBroken = {};  ///< mechanisms that broke
    std::vector<AngleBroken> anglesBroken = {};          ///< angular joints that broke
};

}  // namespace sulfur
