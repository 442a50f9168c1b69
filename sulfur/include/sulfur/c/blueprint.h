/// \file
/// The plan of a body; sulfur/blueprint.hpp.
#ifndef SULFUR_C_BLUEPRINT_H
#define SULFUR_C_BLUEPRINT_H

#include <sulfur/c/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A point mass; sulfur::ParticleSpec.
typedef struct SulfurParticleSpec {
    SulfurVec position;  ///< metres, in the body's frame
    double mass;         ///< kilograms
    double radius;       ///< metres; above 0 it is a disc
    bool pinned;         ///< held where it is
} SulfurParticleSpec;
/// 1 kg at the origin, without a radius.
SULFUR_API SulfurParticleSpec sulfur_particle_spec_default(void);

/// A connection that holds two particles at a distance; sulfur::JointSpec.
typedef struct SulfurJointSpec {
    uint32_t a;               ///< index of a particle of the blueprint
    uint32_t b;               ///< index of another one
    double stiffness;         ///< N/m; INFINITY is rigid
    double damping;           ///< N s/m
    bool has_rest_length;     ///< else the particles' distance is it
    double rest_length;       ///< metres
    double radius;            ///< metres; above 0 it is a capsule that collides
    double strength;          ///< newtons, beyond which it breaks
    bool has_material;        ///< else its surface is its body's
    SulfurMaterial material;  ///< of its surface
    double bend;              ///< radians by which its capsule turns from a to b; 0: straight
} SulfurJointSpec;
/// Rigid and unbreakable, without a surface, between no particles yet.
SULFUR_API SulfurJointSpec sulfur_joint_spec_default(void);

/// An elastic angle at a particle between two others; sulfur::AngularJointSpec.
typedef struct SulfurAngularJointSpec {
    uint32_t a;             ///< index of a particle of the blueprint
    uint32_t b;             ///< index of another one, the corner
    uint32_t c;             ///< index of a third one
    double stiffness;       ///< N m/rad, 0 to 1e12, or INFINITY
    double damping;         ///< N m s/rad, 0 to 1e12
    bool has_rest_angle;    ///< else as the particles stand
    double rest_angle;      ///< radians, -pi to pi
    double lower;           ///< radians, the least angle; -INFINITY is allowed
    double upper;           ///< radians, the largest one; INFINITY is allowed
    double motor_speed;     ///< rad/s: what the motor wants
    double motor_max;       ///< N m: the most that it gives; 0: no motor
    bool has_motor_target;  ///< else the motor keeps its speed
    double motor_target;    ///< radians: where it goes, at most as fast as its speed, and stays
    double strength;        ///< N m at which it breaks; INFINITY: never
} SulfurAngularJointSpec;
/// Without stiffness, limits and motor, between no particles yet.
SULFUR_API SulfurAngularJointSpec sulfur_angular_joint_spec_default(void);

/// A texture worn by a body; sulfur::Skin.
typedef struct SulfurSkin {
    const char* texture;        ///< asset name, UTF-8
    const SulfurVec* uv;        ///< one per particle; 0 to 1, v points down
    size_t uv_count;            ///< of `uv`
    const uint32_t* triangles;  ///< indices of particles, three for each triangle
    size_t triangle_count;      ///< a third of how many indices there are
} SulfurSkin;
/// No texture, no triangles.
SULFUR_API SulfurSkin sulfur_skin_default(void);

/// Who moves a body; sulfur::BodyKind.
typedef int32_t SulfurBodyKind;
/// Values of SulfurBodyKind.
enum {
    SULFUR_DYNAMIC = 0,    ///< physics
    SULFUR_KINEMATIC = 1,  ///< the caller; it pushes others
    SULFUR_FIXED = 2       ///< nobody; it only collides
};

/// The plan of a body; sulfur::Blueprint.
typedef struct SulfurBlueprint SulfurBlueprint;

/// An empty plan of a dynamic body, the caller's to destroy; shapes.h has ready-made ones.
SULFUR_API SulfurResult sulfur_blueprint_create(SulfurBlueprint** blueprint);
/// Another one like it.
SULFUR_API SulfurResult sulfur_blueprint_copy(const SulfurBlueprint* blueprint,
                                              SulfurBlueprint** copy);
/// Frees it; bodies that were made of it stay. Null: nothing.
SULFUR_API void sulfur_blueprint_destroy(SulfurBlueprint* blueprint);
/// Refuses a plan that sulfur_world_add_body would; Blueprint::validate.
SULFUR_API SulfurResult sulfur_blueprint_validate(const SulfurBlueprint* blueprint);
/// Kilograms, with pinned particles.
SULFUR_API SulfurResult sulfur_blueprint_mass(const SulfurBlueprint* blueprint, double* mass);
/// In the body's frame, metres.
SULFUR_API SulfurResult sulfur_blueprint_centre_of_mass(const SulfurBlueprint* blueprint,
                                                        SulfurVec* centre);

/// For people and files, UTF-8. Valid until it is set again or the blueprint is destroyed.
SULFUR_API SulfurResult sulfur_blueprint_name(const SulfurBlueprint* blueprint, const char** name);
/// Copies a name.
SULFUR_API SulfurResult sulfur_blueprint_set_name(SulfurBlueprint* blueprint, const char* name);
/// Who moves it.
SULFUR_API SulfurResult sulfur_blueprint_kind(const SulfurBlueprint* blueprint,
                                              SulfurBodyKind* kind);
/// Sets who moves it.
SULFUR_API SulfurResult sulfur_blueprint_set_kind(SulfurBlueprint* blueprint, SulfurBodyKind kind);
/// Its surface.
SULFUR_API SulfurResult sulfur_blueprint_material(const SulfurBlueprint* blueprint,
                                                  SulfurMaterial* material);
/// Sets its surface.
SULFUR_API SulfurResult sulfur_blueprint_set_material(SulfurBlueprint* blueprint,
                                                      SulfurMaterial material);
/// What it collides with.
SULFUR_API SulfurResult sulfur_blueprint_filter(const SulfurBlueprint* blueprint,
                                                SulfurFilter* filter);
/// Sets what it collides with.
SULFUR_API SulfurResult sulfur_blueprint_set_filter(SulfurBlueprint* blueprint,
                                                    SulfurFilter filter);
/// Whether its own parts touch each other.
SULFUR_API SulfurResult sulfur_blueprint_self_collision(const SulfurBlueprint* blueprint, bool* on);
/// Sets whether they do.
SULFUR_API SulfurResult sulfur_blueprint_set_self_collision(SulfurBlueprint* blueprint, bool on);
/// Whether it only feels; see sulfur_body_set_sensor.
SULFUR_API SulfurResult sulfur_blueprint_sensor(const SulfurBlueprint* blueprint, bool* sensor);
/// Sets whether it only feels.
SULFUR_API SulfurResult sulfur_blueprint_set_sensor(SulfurBlueprint* blueprint, bool sensor);
/// What it wears; `has` is false and `skin` untouched when it wears nothing. What `skin` points at
/// is valid until the next call of this function or the next change of the blueprint.
SULFUR_API SulfurResult sulfur_blueprint_skin(const SulfurBlueprint* blueprint, SulfurSkin* skin,
                                              bool* has);
/// Copies what it is to wear; null: nothing.
SULFUR_API SulfurResult sulfur_blueprint_set_skin(SulfurBlueprint* blueprint,
                                                  const SulfurSkin* skin);

/// The number of its particles.
SULFUR_API SulfurResult sulfur_blueprint_particle_count(const SulfurBlueprint* blueprint,
                                                        size_t* count);
/// One of them, by its index.
SULFUR_API SulfurResult sulfur_blueprint_particle(const SulfurBlueprint* blueprint, size_t index,
                                                  SulfurParticleSpec* particle);
/// Changes one.
SULFUR_API SulfurResult sulfur_blueprint_set_particle(SulfurBlueprint* blueprint, size_t index,
                                                      SulfurParticleSpec particle);
/// Adds one behind the others, whose index is then `index`, which may be null.
SULFUR_API SulfurResult sulfur_blueprint_add_particle(SulfurBlueprint* blueprint,
                                                      SulfurParticleSpec particle, uint32_t* index);
/// The number of its joints.
SULFUR_API SulfurResult sulfur_blueprint_joint_count(const SulfurBlueprint* blueprint,
                                                     size_t* count);
/// One of them, by its index.
SULFUR_API SulfurResult sulfur_blueprint_joint(const SulfurBlueprint* blueprint, size_t index,
                                               SulfurJointSpec* joint);
/// Changes one.
SULFUR_API SulfurResult sulfur_blueprint_set_joint(SulfurBlueprint* blueprint, size_t index,
                                                   SulfurJointSpec joint);
/// Adds one behind the others, whose index is then `index`, which may be null.
SULFUR_API SulfurResult sulfur_blueprint_add_joint(SulfurBlueprint* blueprint,
                                                   SulfurJointSpec joint, uint32_t* index);
/// The number of its angular joints.
SULFUR_API SulfurResult sulfur_blueprint_angle_count(const SulfurBlueprint* blueprint,
                                                     size_t* count);
/// One of them, by its index.
SULFUR_API SulfurResult sulfur_blueprint_angle(const SulfurBlueprint* blueprint, size_t index,
                                               SulfurAngularJointSpec* angle);
/// Changes one.
SULFUR_API SulfurResult sulfur_blueprint_set_angle(SulfurBlueprint* blueprint, size_t index,
                                                   SulfurAngularJointSpec angle);
/// Adds one behind the others, whose index is then `index`, which may be null.
SULFUR_API SulfurResult sulfur_blueprint_add_angle(SulfurBlueprint* blueprint,
                                                   SulfurAngularJointSpec angle, uint32_t* index);

#ifdef __cplusplus
}
#endif

#endif
