/// \file
/// What happened during the last tick; sulfur/events.hpp.
#ifndef SULFUR_C_EVENTS_H
#define SULFUR_C_EVENTS_H

#include <sulfur/c/base.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Two bodies began to touch; sulfur::ContactBegun.
typedef struct SulfurContactBegun {
    SulfurBodyId a;    ///< the body whose particle touches
    SulfurBodyId b;    ///< the other
    SulfurVec point;   ///< metres, on the surface of a
    SulfurVec normal;  ///< unit length, from b towards a
    double speed;      ///< m/s at which they approached along the normal
    double impulse;    ///< N s of all their contacts in this tick
} SulfurContactBegun;

/// Two bodies go on touching; sulfur::ContactPersisted.
typedef struct SulfurContactPersisted {
    SulfurBodyId a;    ///< the body whose particle touches
    SulfurBodyId b;    ///< the other
    SulfurVec point;   ///< metres, on the surface of a
    SulfurVec normal;  ///< unit length, from b towards a
    double impulse;    ///< N s of all their contacts in this tick
} SulfurContactPersisted;

/// Two bodies no longer touch; sulfur::ContactEnded.
typedef struct SulfurContactEnded {
    SulfurBodyId a;  ///< one; no longer valid if it was removed
    SulfurBodyId b;  ///< the other; likewise
} SulfurContactEnded;

/// A joint was loaded beyond its strength and is gone; sulfur::JointBroken.
typedef struct SulfurJointBroken {
    SulfurJointId joint;  ///< no longer valid; for comparison only
    SulfurBodyId body;    ///< null for a joint between bodies
    SulfurVec point;      ///< metres: its middle
    double force;         ///< newtons at which it broke
} SulfurJointBroken;

/// A body has fallen apart; sulfur::BodySplit.
typedef struct SulfurBodySplit {
    SulfurBodyId body;   ///< the heaviest part, which keeps the old handle
    SulfurBodyId piece;  ///< the new one
} SulfurBodySplit;

/// A particle is gone because it has no surface left; sulfur::ParticleLost.
typedef struct SulfurParticleLost {
    SulfurParticleId particle;  ///< no longer valid; for comparison only
    SulfurBodyId body;          ///< whose it was
    SulfurVec point;            ///< metres: where it was
} SulfurParticleLost;

/// A body came into a sensor, or left it; sulfur::SensorEntered, sulfur::SensorLeft.
typedef struct SulfurSensorEvent {
    SulfurBodyId sensor;   ///< what felt it
    SulfurBodyId visitor;  ///< what came or left; no longer valid when it was removed
} SulfurSensorEvent;

/// A limit of a mechanism or of an angular joint began to push, or no longer does;
/// sulfur::LimitReached, sulfur::LimitLeft.
typedef struct SulfurLimitEvent {
    SulfurMechanismId mechanism;  ///< whose, or null
    bool upper;                   ///< which of both
    SulfurAngleId angle;          ///< the angular joint whose limit it is, or null
} SulfurLimitEvent;

/// A mechanism was loaded beyond its strength and is gone; sulfur::MechanismBroken.
typedef struct SulfurMechanismBroken {
    SulfurMechanismId mechanism;  ///< no longer valid; for comparison only
    SulfurBodyId a;               ///< one of its bodies
    SulfurBodyId b;               ///< the other one
    double force;                 ///< N m or N at which it broke
} SulfurMechanismBroken;

/// An angular joint was loaded beyond its strength and is gone; sulfur::AngleBroken.
typedef struct SulfurAngleBroken {
    SulfurAngleId angle;      ///< no longer valid; for comparison only
    SulfurBodyId body;        ///< whose it was
    SulfurParticleId corner;  ///< where
    double torque;            ///< N m at which it broke
} SulfurAngleBroken;

/// Events of one tick; sulfur::Events, which says in which order. An array that has no entry may be
/// null.
typedef struct SulfurEvents {
    const SulfurContactBegun* contacts_begun;          ///< bodies that began to touch
    size_t contacts_begun_count;                       ///< how many
    const SulfurContactPersisted* contacts_persisted;  ///< bodies that go on touching
    size_t contacts_persisted_count;                   ///< how many
    const SulfurContactEnded* contacts_ended;          ///< bodies that no longer touch
    size_t contacts_ended_count;                       ///< how many
    const SulfurJointBroken* joints_broken;            ///< joints that broke
    size_t joints_broken_count;                        ///< how many
    const SulfurBodySplit* bodies_split;               ///< bodies that fell apart
    size_t bodies_split_count;                         ///< how many
    const SulfurParticleLost* particles_lost;          ///< particles left without a joint
    size_t particles_lost_count;                       ///< how many
    const SulfurSensorEvent* sensors_entered;          ///< bodies that came into sensors
    size_t sensors_entered_count;                      ///< how many
    const SulfurSensorEvent* sensors_left;             ///< bodies that left sensors
    size_t sensors_left_count;                         ///< how many
    const SulfurLimitEvent* limits_reached;            ///< limits that began to push
    size_t limits_reached_count;                       ///< how many
    const SulfurLimitEvent* limits_left;               ///< limits that no longer push
    size_t limits_left_count;                          ///< how many
    const SulfurMechanismBroken* mechanisms_broken;    ///< mechanisms that broke
    size_t mechanisms_broken_count;                    ///< how many
    const SulfurAngleBroken* angles_broken;            ///< angular joints that broke
    size_t angles_broken_count;                        ///< how many
} SulfurEvents;
/// What happened in the last tick. The arrays are the world's, valid until the next call of this
/// function for it, or until it is destroyed.
SULFUR_API SulfurResult sulfur_world_events(const SulfurWorld* world, SulfurEvents* events);

/// What a contact of the last tick was; sulfur::ContactInfo.
typedef struct SulfurContactInfo {
    SulfurBodyId a;    ///< the body whose particle touches
    SulfurBodyId b;    ///< the body whose capsule or disc is touched
    SulfurVec point;   ///< metres
    SulfurVec normal;  ///< unit, from b towards a
    double impulse;    ///< N s along the normal in that tick
    double friction;   ///< N s along the normal turned by a right angle counter-clockwise
} SulfurContactInfo;
/// Contacts that push, in a fixed order; World::contacts.
SULFUR_API SulfurResult sulfur_world_contacts(const SulfurWorld* world, SulfurContactInfo* out,
                                              size_t capacity, size_t* count);
/// Those of one body; World::contacts(body, out).
SULFUR_API SulfurResult sulfur_body_contacts(const SulfurWorld* world, SulfurBodyId body,
                                             SulfurContactInfo* out, size_t capacity,
                                             size_t* count);
/// Whether two bodies touched at the end of the last tick; World::touches.
SULFUR_API SulfurResult sulfur_world_touches(const SulfurWorld* world, SulfurBodyId a,
                                             SulfurBodyId b, bool* touches);

#ifdef __cplusplus
}
#endif

#endif
