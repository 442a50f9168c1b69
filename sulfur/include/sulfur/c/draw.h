/// \file
/// Shows a world to whatever draws, writes or counts; sulfur/draw.hpp.
///
/// What a function gets is valid only while it runs. It must not change the world.
#ifndef SULFUR_C_DRAW_H
#define SULFUR_C_DRAW_H

#include <sulfur/c/base.h>
#include <sulfur/c/blueprint.h>
#include <sulfur/c/events.h>
#include <sulfur/c/fields.h>
#include <sulfur/c/mechanisms.h>
#include <sulfur/c/parts.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// What is shown; sulfur::DrawOptions.
typedef struct SulfurDrawOptions {
    bool bodies;       ///< SulfurDebugDraw::body
    bool particles;    ///< SulfurDebugDraw::particle
    bool discs;        ///< SulfurDebugDraw::disc
    bool joints;       ///< SulfurDebugDraw::joint
    bool capsules;     ///< SulfurDebugDraw::capsule
    bool contacts;     ///< SulfurDebugDraw::contact
    bool attachments;  ///< SulfurDebugDraw::attachment
    bool fields;       ///< SulfurDebugDraw::field
    bool grabs;        ///< SulfurDebugDraw::grab
    bool mechanisms;   ///< SulfurDebugDraw::mechanism
    bool angles;       ///< SulfurDebugDraw::angle
    double alpha;      ///< how much of the next tick has passed on the clock, 0 to 1
    SulfurZone view;   ///< what is outside is left out
} SulfurDrawOptions;
/// Everything, everywhere.
SULFUR_API SulfurDrawOptions sulfur_draw_options_default(void);

/// A particle.
typedef struct SulfurDrawnParticle {
    SulfurParticleId id;  ///< its handle
    SulfurBodyId body;    ///< its body
    SulfurVec place;      ///< metres
    SulfurVec velocity;   ///< m/s
    bool pinned;          ///< whether it is held where it is
    bool asleep;          ///< whether its body sleeps
} SulfurDrawnParticle;

/// A particle with a radius.
typedef struct SulfurDrawnDisc {
    SulfurParticleId id;  ///< the particle
    SulfurBodyId body;    ///< its body
    SulfurVec centre;     ///< metres
    double radius;        ///< metres
    bool asleep;          ///< whether its body sleeps
} SulfurDrawnDisc;

/// A joint, drawn as a line.
typedef struct SulfurDrawnJoint {
    SulfurJointId id;   ///< its handle
    SulfurBodyId body;  ///< null for a joint between bodies
    SulfurVec a;        ///< metres: one end
    SulfurVec b;        ///< metres: the other end
    double force;       ///< newtons in the last tick, positive when it pulls
    double strength;    ///< newtons
    double stiffness;   ///< N/m
    bool asleep;        ///< whether the body of its end a sleeps
} SulfurDrawnJoint;

/// The surface of a joint with a radius.
typedef struct SulfurDrawnCapsule {
    SulfurJointId id;   ///< the joint
    SulfurBodyId body;  ///< null for a joint between bodies
    SulfurVec a;        ///< metres: one end of the axis
    SulfurVec b;        ///< metres: the other end
    double radius;      ///< metres
    bool asleep;        ///< whether the body of its end a sleeps
} SulfurDrawnCapsule;

/// A body.
typedef struct SulfurDrawnBody {
    SulfurBodyId id;           ///< its handle
    SulfurBodyKind kind;       ///< who moves it
    SulfurVec centre_of_mass;  ///< metres
    SulfurVec low;             ///< metres: lower left corner around its particles
    SulfurVec high;            ///< metres: upper right corner around its particles
    bool asleep;               ///< whether it sleeps
} SulfurDrawnBody;

/// A particle held at a point of a body.
typedef struct SulfurDrawnAttachment {
    SulfurAttachmentId id;  ///< its handle
    SulfurVec particle;     ///< metres: the particle
    SulfurVec point;        ///< metres: where it should be
    SulfurVec supports[3];  ///< metres: what carries that point
    uint32_t count;         ///< of the supports, 1 to 3
} SulfurDrawnAttachment;

/// A force field.
typedef struct SulfurDrawnField {
    SulfurFieldId id;   ///< its handle
    SulfurField field;  ///< what it is
} SulfurDrawnField;

/// A grab.
typedef struct SulfurDrawnGrab {
    SulfurGrabId id;      ///< its handle
    SulfurGrabInfo info;  ///< where it holds and pulls
} SulfurDrawnGrab;

/// A mechanism.
typedef struct SulfurDrawnMechanism {
    SulfurMechanismId id;      ///< its handle
    SulfurMechanismInfo info;  ///< what it is and does
    SulfurVec places[4];       ///< metres; sulfur::DebugDraw::Mechanism says which
    uint32_t count;            ///< of the places, 1 to 4
} SulfurDrawnMechanism;

/// An angular joint.
typedef struct SulfurDrawnAngle {
    SulfurAngleInfo info;  ///< what it is and does, with its handle
    SulfurVec a;           ///< metres: one neighbour
    SulfurVec b;           ///< metres: the corner
    SulfurVec c;           ///< metres: the other neighbour
    bool asleep;           ///< whether its body sleeps
} SulfurDrawnAngle;

/// Gets a body.
typedef void (*SulfurDrawBody)(void* user, const SulfurDrawnBody* body);
/// Gets a particle.
typedef void (*SulfurDrawParticle)(void* user, const SulfurDrawnParticle* particle);
/// Gets a disc.
typedef void (*SulfurDrawDisc)(void* user, const SulfurDrawnDisc* disc);
/// Gets a joint.
typedef void (*SulfurDrawJoint)(void* user, const SulfurDrawnJoint* joint);
/// Gets a capsule.
typedef void (*SulfurDrawCapsule)(void* user, const SulfurDrawnCapsule* capsule);
/// Gets a contact of the last tick.
typedef void (*SulfurDrawContact)(void* user, const SulfurContactInfo* contact);
/// Gets an attachment.
typedef void (*SulfurDrawAttachment)(void* user, const SulfurDrawnAttachment* attachment);
/// Gets a field.
typedef void (*SulfurDrawField)(void* user, const SulfurDrawnField* field);
/// Gets a grab.
typedef void (*SulfurDrawGrab)(void* user, const SulfurDrawnGrab* grab);
/// Gets a mechanism.
typedef void (*SulfurDrawMechanism)(void* user, const SulfurDrawnMechanism* mechanism);
/// Gets an angular joint.
typedef void (*SulfurDrawAngle)(void* user, const SulfurDrawnAngle* angle);

/// Receives what is shown, in the order that sulfur::DebugDraw has; null functions are not called.
typedef struct SulfurDebugDraw {
    void* user;                       ///< what each function gets
    SulfurDrawBody body;              ///< called for each body
    SulfurDrawParticle particle;      ///< called for each particle
    SulfurDrawDisc disc;              ///< called for each particle with a radius
    SulfurDrawJoint joint;            ///< called for each joint
    SulfurDrawCapsule capsule;        ///< called for each joint with a radius
    SulfurDrawContact contact;        ///< called for each contact of the last tick
    SulfurDrawAttachment attachment;  ///< called for each attachment
    SulfurDrawField field;            ///< called for each force field
    SulfurDrawGrab grab;              ///< called for each grab
    SulfurDrawMechanism mechanism;    ///< called for each mechanism
    SulfurDrawAngle angle;            ///< called for each angular joint
} SulfurDebugDraw;
/// No functions.
SULFUR_API SulfurDebugDraw sulfur_debug_draw_default(void);
/// Shows a world; World::draw.
SULFUR_API SulfurResult sulfur_world_draw(const SulfurWorld* world, const SulfurDebugDraw* to,
                                          const SulfurDrawOptions* options);

#ifdef __cplusplus
}
#endif

#endif
