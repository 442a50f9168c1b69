/// \file
/// Force fields; sulfur/fields.hpp, which says how they act and gives the ranges.
#ifndef SULFUR_C_FIELDS_H
#define SULFUR_C_FIELDS_H

#include <sulfur/c/base.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Which of the fields it is.
typedef int32_t SulfurFieldKind;
/// Values of SulfurFieldKind.
enum {
    SULFUR_UNIFORM_FIELD = 0,  ///< the same acceleration everywhere in a zone
    SULFUR_RADIAL_FIELD = 1,   ///< towards a point or away from it
    SULFUR_WIND_FIELD = 2      ///< moving air
};

/// sulfur::UniformField.
typedef struct SulfurUniformField {
    SulfurZone zone;         ///< where it acts
    SulfurVec acceleration;  ///< m/s^2
    uint32_t mask;           ///< acts on bodies with one of these categories
} SulfurUniformField;

/// sulfur::RadialField.
typedef struct SulfurRadialField {
    SulfurVec centre;  ///< metres
    double strength;   ///< m/s^2 at a distance of 1 m; positive attracts
    int32_t falloff;   ///< 0 to 4
    double core;       ///< metres
    double reach;      ///< metres; INFINITY is allowed
    uint32_t mask;     ///< acts on bodies with one of these categories
} SulfurRadialField;

/// sulfur::WindField.
typedef struct SulfurWindField {
    SulfurZone zone;     ///< where it blows
    SulfurVec velocity;  ///< m/s
    double drag;         ///< 1/s, 0 to the tick rate
    uint32_t mask;       ///< acts on bodies with one of these categories
} SulfurWindField;

/// Any of the fields: only the member of its kind counts.
typedef struct SulfurField {
    SulfurFieldKind kind;        ///< which one it is
    SulfurUniformField uniform;  ///< if it is uniform
    SulfurRadialField radial;    ///< if it is radial
    SulfurWindField wind;        ///< if it is a wind
} SulfurField;
/// A field of a kind, with the defaults of all three.
SULFUR_API SulfurField sulfur_field_default(SulfurFieldKind kind);

/// Adds one; World::add.
SULFUR_API SulfurResult sulfur_world_add_field(SulfurWorld* world, const SulfurField* field,
                                               SulfurFieldId* id);
/// Changes one; World::set.
SULFUR_API SulfurResult sulfur_field_set(SulfurWorld* world, SulfurFieldId field,
                                         const SulfurField* to);
/// What it is.
SULFUR_API SulfurResult sulfur_field_info(const SulfurWorld* world, SulfurFieldId field,
                                          SulfurField* info);
/// Removes it.
SULFUR_API SulfurResult sulfur_field_remove(SulfurWorld* world, SulfurFieldId field);
/// Whether its handle is valid.
SULFUR_API SulfurResult sulfur_field_exists(const SulfurWorld* world, SulfurFieldId field,
                                            bool* exists);
/// All of them, oldest first.
SULFUR_API SulfurResult sulfur_world_fields(const SulfurWorld* world, SulfurFieldId* out,
                                            size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif
