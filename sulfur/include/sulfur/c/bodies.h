/// \file
/// Bodies: making them, looking at them, pushing them; sulfur/world.hpp and sulfur/body.hpp.
#ifndef SULFUR_C_BODIES_H
#define SULFUR_C_BODIES_H

#include <sulfur/c/base.h>
#include <sulfur/c/blueprint.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

// --- making and removing ------------------------------------------------------------------------

/// Makes a body, at rest; World::add. The blueprint stays the caller's and may be used again.
SULFUR_API SulfurResult sulfur_world_add_body(SulfurWorld* world, const SulfurBlueprint* blueprint,
                                              SulfurPose pose, SulfurBodyId* body);
/// Removes it with all that holds on to it.
SULFUR_API SulfurResult sulfur_body_remove(SulfurWorld* world, SulfurBodyId body);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_body_exists(const SulfurWorld* world, SulfurBodyId body,
                                           bool* exists);
/// All bodies, oldest first.
SULFUR_API SulfurResult sulfur_world_bodies(const SulfurWorld* world, SulfurBodyId* out,
                                            size_t capacity, size_t* count);

// --- what it is ---------------------------------------------------------------------------------

/// Its particles in the order of its blueprint.
SULFUR_API SulfurResult sulfur_body_particles(const SulfurWorld* world, SulfurBodyId body,
                                              SulfurParticleId* out, size_t capacity,
                                              size_t* count);
/// One of them, by its place in that list.
SULFUR_API SulfurResult sulfur_body_particle(const SulfurWorld* world, SulfurBodyId body,
                                             size_t index, SulfurParticleId* particle);
/// Its joints in the order of its blueprint, without those that are gone.
SULFUR_API SulfurResult sulfur_body_joints(const SulfurWorld* world, SulfurBodyId body,
                                           SulfurJointId* out, size_t capacity, size_t* count);
/// The name of its blueprint. Valid until bodies are added or removed.
SULFUR_API SulfurResult sulfur_body_name(const SulfurWorld* world, SulfurBodyId body,
                                         const char** name);
/// Who moves it.
SULFUR_API SulfurResult sulfur_body_kind(const SulfurWorld* world, SulfurBodyId body,
                                         SulfurBodyKind* kind);
/// Changes who moves it; World::setKind.
SULFUR_API SulfurResult sulfur_body_set_kind(SulfurWorld* world, SulfurBodyId body,
                                             SulfurBodyKind kind);
/// Whether it takes part.
SULFUR_API SulfurResult sulfur_body_enabled(const SulfurWorld* world, SulfurBodyId body,
                                            bool* enabled);
/// Takes it out of the world for a while, or back in; World::setEnabled.
SULFUR_API SulfurResult sulfur_body_set_enabled(SulfurWorld* world, SulfurBodyId body,
                                                bool enabled);
/// What it wears; `has` is false and `skin` untouched when it wears nothing. What `skin` points at
/// is valid until the next call of this function for this world, or until bodies are added or
/// removed.
SULFUR_API SulfurResult sulfur_body_skin(const SulfurWorld* world, SulfurBodyId body,
                                         SulfurSkin* skin, bool* has);
/// Its surface.
SULFUR_API SulfurResult sulfur_body_material(const SulfurWorld* world, SulfurBodyId body,
                                             SulfurMaterial* material);
/// Changes its surface.
SULFUR_API SulfurResult sulfur_body_set_material(SulfurWorld* world, SulfurBodyId body,
                                                 SulfurMaterial material);
/// What it collides with.
SULFUR_API SulfurResult sulfur_body_filter(const SulfurWorld* world, SulfurBodyId body,
                                           SulfurFilter* filter);
/// Changes what it collides with.
SULFUR_API SulfurResult sulfur_body_set_filter(SulfurWorld* world, SulfurBodyId body,
                                               SulfurFilter filter);
/// Whether its parts touch each other.
SULFUR_API SulfurResult sulfur_body_self_collision(const SulfurWorld* world, SulfurBodyId body,
                                                   bool* on);
/// Changes whether they do.
SULFUR_API SulfurResult sulfur_body_set_self_collision(SulfurWorld* world, SulfurBodyId body,
                                                       bool on);
/// Whether it is a sensor.
SULFUR_API SulfurResult sulfur_body_sensor(const SulfurWorld* world, SulfurBodyId body,
                                           bool* sensor);
/// Makes it a sensor or an ordinary body; World::setSensor.
SULFUR_API SulfurResult sulfur_body_set_sensor(SulfurWorld* world, SulfurBodyId body, bool sensor);
/// Who was in a sensor at the end of the last tick and is still there, by their handles.
SULFUR_API SulfurResult sulfur_body_visitors(const SulfurWorld* world, SulfurBodyId sensor,
                                             SulfurBodyId* out, size_t capacity, size_t* count);
/// How much of gravity acts on it.
SULFUR_API SulfurResult sulfur_body_gravity_scale(const SulfurWorld* world, SulfurBodyId body,
                                                  double* scale);
/// Changes that, -1000 to 1000.
SULFUR_API SulfurResult sulfur_body_set_gravity_scale(SulfurWorld* world, SulfurBodyId body,
                                                      double scale);
/// Whether it keeps its angle, whatever pushes it.
SULFUR_API SulfurResult sulfur_body_fixed_rotation(const SulfurWorld* world, SulfurBodyId body,
                                                   bool* on);
/// Changes that; World::setFixedRotation.
SULFUR_API SulfurResult sulfur_body_set_fixed_rotation(SulfurWorld* world, SulfurBodyId body,
                                                       bool on);
/// 1/s, of its centre of mass.
SULFUR_API SulfurResult sulfur_body_linear_damping(const SulfurWorld* world, SulfurBodyId body,
                                                   double* damping);
/// 1/s, of how it turns about that.
SULFUR_API SulfurResult sulfur_body_angular_damping(const SulfurWorld* world, SulfurBodyId body,
                                                    double* damping);
/// Changes both, each 0 to the tick rate; World::setDamping.
SULFUR_API SulfurResult sulfur_body_set_damping(SulfurWorld* world, SulfurBodyId body,
                                                double linear, double angular);
/// The caller's number; 0 at first.
SULFUR_API SulfurResult sulfur_body_user_data(const SulfurWorld* world, SulfurBodyId body,
                                              uint64_t* data);
/// Leaves a number with a body, for the caller's use.
SULFUR_API SulfurResult sulfur_body_set_user_data(SulfurWorld* world, SulfurBodyId body,
                                                  uint64_t data);
/// Whether it sleeps.
SULFUR_API SulfurResult sulfur_body_asleep(const SulfurWorld* world, SulfurBodyId body,
                                           bool* asleep);
/// Wakes it and its island.
SULFUR_API SulfurResult sulfur_body_wake(SulfurWorld* world, SulfurBodyId body);
/// Puts it to sleep with its island. `asleep` is false, and nothing has changed, where that may not
/// be; World::putToSleep.
SULFUR_API SulfurResult sulfur_body_put_to_sleep(SulfurWorld* world, SulfurBodyId body,
                                                 bool* asleep);
/// Whether it may fall asleep.
SULFUR_API SulfurResult sulfur_body_sleeping_allowed(const SulfurWorld* world, SulfurBodyId body,
                                                     bool* allowed);
/// Changes that; World::setSleepingAllowed.
SULFUR_API SulfurResult sulfur_body_set_sleeping_allowed(SulfurWorld* world, SulfurBodyId body,
                                                         bool allowed);

/// Two bodies.
typedef struct SulfurBodyPair {
    SulfurBodyId a;  ///< the one with the smaller handle
    SulfurBodyId b;  ///< the other
} SulfurBodyPair;
/// False after sulfur_world_set_collision(world, a, b, false).
SULFUR_API SulfurResult sulfur_world_collision(const SulfurWorld* world, SulfurBodyId a,
                                               SulfurBodyId b, bool* on);
/// Lets two bodies pass through each other (false), whatever their filters say, or not (true).
SULFUR_API SulfurResult sulfur_world_set_collision(SulfurWorld* world, SulfurBodyId a,
                                                   SulfurBodyId b, bool on);
/// The pairs that pass through each other, in the order of their handles.
SULFUR_API SulfurResult sulfur_world_vetoes(const SulfurWorld* world, SulfurBodyPair* out,
                                            size_t capacity, size_t* count);

// --- where it is and how it moves ---------------------------------------------------------------

/// Where the frame of its blueprint is; World::pose.
SULFUR_API SulfurResult sulfur_body_pose(const SulfurWorld* world, SulfurBodyId body,
                                         SulfurPose* pose);
/// The same for drawing, when `alpha` (0 to 1) of the next tick has passed on the clock.
SULFUR_API SulfurResult sulfur_body_interpolated_pose(const SulfurWorld* world, SulfurBodyId body,
                                                      double alpha, SulfurPose* pose);
/// Where a point of its frame is in the world, metres; World::toWorld.
SULFUR_API SulfurResult sulfur_body_to_world(const SulfurWorld* world, SulfurBodyId body,
                                             SulfurVec local, SulfurVec* point);
/// Where a point of the world is in its frame, metres.
SULFUR_API SulfurResult sulfur_body_from_world(const SulfurWorld* world, SulfurBodyId body,
                                               SulfurVec point, SulfurVec* local);
/// A vector of its frame as it is in the world: turned.
SULFUR_API SulfurResult sulfur_body_vector_to_world(const SulfurWorld* world, SulfurBodyId body,
                                                    SulfurVec local, SulfurVec* vector);
/// And the other way.
SULFUR_API SulfurResult sulfur_body_vector_from_world(const SulfurWorld* world, SulfurBodyId body,
                                                      SulfurVec vector, SulfurVec* local);
/// Radians; World::angle.
SULFUR_API SulfurResult sulfur_body_angle(const SulfurWorld* world, SulfurBodyId body,
                                          double* angle);
/// Metres.
SULFUR_API SulfurResult sulfur_body_centre_of_mass(const SulfurWorld* world, SulfurBodyId body,
                                                   SulfurVec* centre);
/// m/s.
SULFUR_API SulfurResult sulfur_body_mean_velocity(const SulfurWorld* world, SulfurBodyId body,
                                                  SulfurVec* velocity);
/// rad/s.
SULFUR_API SulfurResult sulfur_body_angular_velocity(const SulfurWorld* world, SulfurBodyId body,
                                                     double* velocity);
/// kg.
SULFUR_API SulfurResult sulfur_body_mass(const SulfurWorld* world, SulfurBodyId body, double* mass);
/// kg m^2 about its centre of mass.
SULFUR_API SulfurResult sulfur_body_inertia(const SulfurWorld* world, SulfurBodyId body,
                                            double* inertia);
/// The smallest upright rectangle around it; World::bounds.
SULFUR_API SulfurResult sulfur_body_bounds(const SulfurWorld* world, SulfurBodyId body,
                                           SulfurBounds* bounds);

// --- moving it ----------------------------------------------------------------------------------

/// Puts it elsewhere; World::setPose.
SULFUR_API SulfurResult sulfur_body_set_pose(SulfurWorld* world, SulfurBodyId body,
                                             SulfurPose pose);
/// m/s of all its particles; World::setVelocity(body, velocity).
SULFUR_API SulfurResult sulfur_body_set_velocity(SulfurWorld* world, SulfurBodyId body,
                                                 SulfurVec velocity);
/// m/s of its centre of mass and rad/s about it; World::setVelocity(body, linear, angular).
SULFUR_API SulfurResult sulfur_body_set_motion(SulfurWorld* world, SulfurBodyId body,
                                               SulfurVec linear, double angular);
/// Newtons at a point of the world during the next tick.
SULFUR_API SulfurResult sulfur_body_apply_force(SulfurWorld* world, SulfurBodyId body,
                                                SulfurVec force, SulfurVec at);
/// N m during the next tick.
SULFUR_API SulfurResult sulfur_body_apply_torque(SulfurWorld* world, SulfurBodyId body,
                                                 double torque);
/// N s at a point of the world, at once.
SULFUR_API SulfurResult sulfur_body_apply_impulse(SulfurWorld* world, SulfurBodyId body,
                                                  SulfurVec impulse, SulfurVec at);
/// N m s, at once.
SULFUR_API SulfurResult sulfur_body_apply_angular_impulse(SulfurWorld* world, SulfurBodyId body,
                                                          double impulse);
/// Moves a kinematic body so that it is at `pose` after the next tick.
SULFUR_API SulfurResult sulfur_body_move_to(SulfurWorld* world, SulfurBodyId body, SulfurPose pose);

#ifdef __cplusplus
}
#endif

#endif
