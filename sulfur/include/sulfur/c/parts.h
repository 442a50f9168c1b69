/// \file
/// Particles, joints, angular joints, attachments and grabs; sulfur/world.hpp, sulfur/grab.hpp.
#ifndef SULFUR_C_PARTS_H
#define SULFUR_C_PARTS_H

#include <sulfur/c/base.h>
#include <sulfur/c/mechanisms.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

// --- particles ----------------------------------------------------------------------------------

/// What a particle is at the moment; sulfur::ParticleInfo.
typedef struct SulfurParticleInfo {
    SulfurBodyId body;   ///< whose it is
    SulfurVec position;  ///< metres
    SulfurVec velocity;  ///< m/s
    double mass;         ///< kg
    double radius;       ///< m
    bool pinned;         ///< whether it is held where it is
    double angle;        ///< rad, -pi to pi: how far a disc that rolls has turned, else 0
    double spin;         ///< rad/s, of a disc that rolls, else 0
} SulfurParticleInfo;
/// What it is.
SULFUR_API SulfurResult sulfur_particle_info(const SulfurWorld* world, SulfurParticleId particle,
                                             SulfurParticleInfo* info);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_particle_exists(const SulfurWorld* world, SulfurParticleId particle,
                                               bool* exists);
/// Metres.
SULFUR_API SulfurResult sulfur_particle_position(const SulfurWorld* world,
                                                 SulfurParticleId particle, SulfurVec* position);
/// Where to draw it, when `alpha` (0 to 1) of the next tick has passed on the clock.
SULFUR_API SulfurResult sulfur_particle_interpolated(const SulfurWorld* world,
                                                     SulfurParticleId particle, double alpha,
                                                     SulfurVec* position);
/// m/s; World::velocity.
SULFUR_API SulfurResult sulfur_particle_velocity(const SulfurWorld* world,
                                                 SulfurParticleId particle, SulfurVec* velocity);
/// Moves it without giving it velocity, metres.
SULFUR_API SulfurResult sulfur_particle_set_position(SulfurWorld* world, SulfurParticleId particle,
                                                     SulfurVec position);
/// m/s.
SULFUR_API SulfurResult sulfur_particle_set_velocity(SulfurWorld* world, SulfurParticleId particle,
                                                     SulfurVec velocity);
/// kg.
SULFUR_API SulfurResult sulfur_particle_set_mass(SulfurWorld* world, SulfurParticleId particle,
                                                 double mass);
/// Holds it where it is, or lets it go.
SULFUR_API SulfurResult sulfur_particle_set_pinned(SulfurWorld* world, SulfurParticleId particle,
                                                   bool pinned);
/// Newtons during the next tick.
SULFUR_API SulfurResult sulfur_particle_apply_force(SulfurWorld* world, SulfurParticleId particle,
                                                    SulfurVec force);
/// N s, at once.
SULFUR_API SulfurResult sulfur_particle_apply_impulse(SulfurWorld* world, SulfurParticleId particle,
                                                      SulfurVec impulse);

// --- joints -------------------------------------------------------------------------------------

/// Options of a joint between two particles that exist already; sulfur::ConnectOptions.
typedef struct SulfurConnectOptions {
    double stiffness;         ///< N/m; INFINITY is rigid
    double damping;           ///< N s/m
    bool has_rest_length;     ///< else their distance now is it
    double rest_length;       ///< m
    double radius;            ///< m; above 0 it collides
    double strength;          ///< N
    bool has_material;        ///< else its surface is its body's
    SulfurMaterial material;  ///< of its surface
} SulfurConnectOptions;
/// Rigid and unbreakable, without a surface.
SULFUR_API SulfurConnectOptions sulfur_connect_options_default(void);

/// What a joint is at the moment; sulfur::JointInfo.
typedef struct SulfurJointInfo {
    SulfurBodyId body;   ///< null for a joint between bodies
    SulfurParticleId a;  ///< one end
    SulfurParticleId b;  ///< the other end
    double rest_length;  ///< m
    double stiffness;    ///< N/m
    double damping;      ///< N s/m
    double radius;       ///< m
    double strength;     ///< N
    double force;        ///< N in the last tick, positive when it pulls
    double bend;         ///< radians by which its capsule turns from a to b
} SulfurJointInfo;
/// Joins two particles; World::connect.
SULFUR_API SulfurResult sulfur_world_connect(SulfurWorld* world, SulfurParticleId a,
                                             SulfurParticleId b,
                                             const SulfurConnectOptions* options,
                                             SulfurJointId* joint);
/// Removes it.
SULFUR_API SulfurResult sulfur_joint_remove(SulfurWorld* world, SulfurJointId joint);
/// What it is.
SULFUR_API SulfurResult sulfur_joint_info(const SulfurWorld* world, SulfurJointId joint,
                                          SulfurJointInfo* info);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_joint_exists(const SulfurWorld* world, SulfurJointId joint,
                                            bool* exists);
/// Joints between bodies, oldest first.
SULFUR_API SulfurResult sulfur_world_connections(const SulfurWorld* world, SulfurJointId* out,
                                                 size_t capacity, size_t* count);
/// Its surface: its own, or that of its body.
SULFUR_API SulfurResult sulfur_joint_material(const SulfurWorld* world, SulfurJointId joint,
                                              SulfurMaterial* material);
/// Gives it a surface of its own; null: its body's again.
SULFUR_API SulfurResult sulfur_joint_set_material(SulfurWorld* world, SulfurJointId joint,
                                                  const SulfurMaterial* material);
/// N/m.
SULFUR_API SulfurResult sulfur_joint_set_stiffness(SulfurWorld* world, SulfurJointId joint,
                                                   double stiffness);
/// N s/m.
SULFUR_API SulfurResult sulfur_joint_set_damping(SulfurWorld* world, SulfurJointId joint,
                                                 double damping);
/// Metres.
SULFUR_API SulfurResult sulfur_joint_set_rest_length(SulfurWorld* world, SulfurJointId joint,
                                                     double rest_length);
/// N.
SULFUR_API SulfurResult sulfur_joint_set_strength(SulfurWorld* world, SulfurJointId joint,
                                                  double strength);

// --- angular joints -----------------------------------------------------------------------------

/// What an angular joint is at the moment; sulfur::AngleInfo.
typedef struct SulfurAngleInfo {
    SulfurAngleId id;    ///< its handle
    SulfurBodyId body;   ///< whose it is
    SulfurParticleId a;  ///< one neighbour
    SulfurParticleId b;  ///< the corner
    SulfurParticleId c;  ///< the other neighbour
    SulfurDrive drive;   ///< spring, limits, motor and strength, in rad and N m
    double angle;        ///< radians: the turn from a to b to that from b to c
    double torque;       ///< N m in the last tick, positive where it makes the angle larger
    bool at_lower;       ///< whether the lower limit pushed in the last tick
    bool at_upper;       ///< the same of the upper one
} SulfurAngleInfo;
/// Those of a body in the order of its blueprint, without those that are gone.
SULFUR_API SulfurResult sulfur_body_angles(const SulfurWorld* world, SulfurBodyId body,
                                           SulfurAngleInfo* out, size_t capacity, size_t* count);
/// What it is.
SULFUR_API SulfurResult sulfur_angle_info(const SulfurWorld* world, SulfurAngleId angle,
                                          SulfurAngleInfo* info);
/// Changes what acts along its angle; World::setDrive.
SULFUR_API SulfurResult sulfur_angle_set_drive(SulfurWorld* world, SulfurAngleId angle,
                                               const SulfurDrive* drive);
/// Takes it away; what it bent stays.
SULFUR_API SulfurResult sulfur_angle_remove(SulfurWorld* world, SulfurAngleId angle);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_angle_exists(const SulfurWorld* world, SulfurAngleId angle,
                                            bool* exists);

// --- attachments --------------------------------------------------------------------------------

/// What an attachment is; sulfur::AttachmentInfo.
typedef struct SulfurAttachmentInfo {
    SulfurParticleId particle;     ///< what is held
    uint32_t count;                ///< of supports, 1 to 3
    SulfurParticleId supports[3];  ///< the first `count` are valid, the others null
    double weights[3];             ///< their sum is 1; 0 beyond `count`
} SulfurAttachmentInfo;
/// Holds a particle at a point of a body, given in the frame of its blueprint; World::attach.
SULFUR_API SulfurResult sulfur_world_attach_to_body(SulfurWorld* world, SulfurParticleId particle,
                                                    SulfurBodyId body, SulfurVec local_point,
                                                    SulfurAttachmentId* attachment);
/// Holds a particle at the place along a joint, 0 to 1; World::attach.
SULFUR_API SulfurResult sulfur_world_attach_to_joint(SulfurWorld* world, SulfurParticleId particle,
                                                     SulfurJointId joint, double along,
                                                     SulfurAttachmentId* attachment);
/// Lets go.
SULFUR_API SulfurResult sulfur_attachment_remove(SulfurWorld* world, SulfurAttachmentId attachment);
/// What it is.
SULFUR_API SulfurResult sulfur_attachment_info(const SulfurWorld* world,
                                               SulfurAttachmentId attachment,
                                               SulfurAttachmentInfo* info);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_attachment_exists(const SulfurWorld* world,
                                                 SulfurAttachmentId attachment, bool* exists);
/// All of them, oldest first.
SULFUR_API SulfurResult sulfur_world_attachments(const SulfurWorld* world, SulfurAttachmentId* out,
                                                 size_t capacity, size_t* count);

// --- grabs --------------------------------------------------------------------------------------

/// How firmly a grab holds; sulfur::GrabOptions.
typedef struct SulfurGrabOptions {
    double frequency;      ///< Hz
    double damping_ratio;  ///< 1 is critical
    bool has_max_force;    ///< else a hundred times the body's weight on Earth is it
    double max_force;      ///< newtons; INFINITY is allowed
} SulfurGrabOptions;
/// 5 Hz, critically damped.
SULFUR_API SulfurGrabOptions sulfur_grab_options_default(void);

/// What a grab is at the moment; sulfur::GrabInfo.
typedef struct SulfurGrabInfo {
    SulfurBodyId body;  ///< the grabbed body
    SulfurVec point;    ///< metres: where it is held now
    SulfurVec target;   ///< metres: where it is pulled to
    SulfurVec force;    ///< newtons on the body in the last tick
} SulfurGrabInfo;
/// Pulls a particle of a dynamic body towards `target`.
SULFUR_API SulfurResult sulfur_world_grab_particle(SulfurWorld* world, SulfurParticleId particle,
                                                   SulfurVec target,
                                                   const SulfurGrabOptions* options,
                                                   SulfurGrabId* grab);
/// Pulls a point of a dynamic body, given in the frame of its blueprint.
SULFUR_API SulfurResult sulfur_world_grab_body(SulfurWorld* world, SulfurBodyId body,
                                               SulfurVec local_point, SulfurVec target,
                                               const SulfurGrabOptions* options,
                                               SulfurGrabId* grab);
/// Moves the target.
SULFUR_API SulfurResult sulfur_grab_set_target(SulfurWorld* world, SulfurGrabId grab,
                                               SulfurVec target);
/// Lets go.
SULFUR_API SulfurResult sulfur_grab_release(SulfurWorld* world, SulfurGrabId grab);
/// What it is.
SULFUR_API SulfurResult sulfur_grab_info(const SulfurWorld* world, SulfurGrabId grab,
                                         SulfurGrabInfo* info);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_grab_exists(const SulfurWorld* world, SulfurGrabId grab,
                                           bool* exists);
/// All of them, oldest first.
SULFUR_API SulfurResult sulfur_world_grabs(const SulfurWorld* world, SulfurGrabId* out,
                                           size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif
