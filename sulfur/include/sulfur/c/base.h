/// \file
/// What all of the C interface has in common: results, errors, vectors, handles, surfaces.
///
/// It is the C++ interface in C99, name by name: World::setGravity(g) is
/// sulfur_world_set_gravity(world, g). Units, ranges and what a call does are those of the C++
/// header that is named beside it, and of World for all calls.
///
/// Functions. What can fail returns a SulfurResult and is not SULFUR_OK then; nothing has changed,
/// and what its pointers would have received is as it was. (A tick in which callbacks failed has
/// run: callbacks.h.) Results are left at the last parameters. No pointer may be null unless the
/// function says so; a null pointer is refused. Pointers to options and filters, and what functions
/// of the caller get as `user`, may always be null: for options that means the defaults. No C++
/// exception leaves a function.
///
/// Numbers are double in every build. Where the library computes in single precision, it rounds
/// what it is given, and tells what it has.
///
/// Structs. Take what `..._default()` returns and change what you need. What a struct points at
/// must stay until the call returns, not longer.
///
/// Objects (SulfurWorld, SulfurBlueprint, SulfurSnapshot, SulfurThreadPool) belong to the caller,
/// who destroys each with its own `..._destroy()`, which takes null too. Handles are plain numbers,
/// which own nothing: `{0, 0}` is null, one of something that is gone is refused.
///
/// Lists. A function with `out`, `capacity` and `count` writes the first `capacity` entries to
/// `out` and leaves in `count` how many there are. With a capacity of 0 `out` may be null.
///
/// Threads: one thread at a time may use an object; different worlds are independent.
#ifndef SULFUR_C_BASE_H
#define SULFUR_C_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Marks what the library exports.
#if defined(__GNUC__)
#define SULFUR_API __attribute__((visibility("default")))
#else
#define SULFUR_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// How a call ended: SULFUR_OK or why it was refused. The first ones are sulfur::ErrorCode.
typedef int32_t SulfurResult;
/// Values of SulfurResult.
enum {
    SULFUR_OK = 0,            ///< it did what it says
    SULFUR_NOT_FINITE = 1,    ///< a NaN or an infinity where a finite number is needed
    SULFUR_OUT_OF_RANGE = 2,  ///< a number or a kind outside the range that its documentation gives
    SULFUR_BAD_INDEX = 3,     ///< an index that points at nothing
    SULFUR_STALE_HANDLE = 4,  ///< a handle that is null, or whose thing was removed
    SULFUR_DEGENERATE = 5,    ///< geometry that cannot work, such as a rigid joint of length zero
    SULFUR_BAD_SNAPSHOT = 6,  ///< bytes that are no snapshot, or one of another version or build
    SULFUR_TORN = 7,          ///< a world in the middle of a tick for which there was no memory
    SULFUR_IN_CALLBACK = 8,   ///< a call that no callback of a world may make
    SULFUR_NO_MEMORY = 9,     ///< there is none; a world that was in a tick is torn now
    SULFUR_NULL_POINTER = 10,  ///< a pointer that must not be null
    SULFUR_FAILED = 11         ///< anything else
};

/// What was wrong with the last call that this thread made and that was refused: one sentence, in
/// UTF-8, at most 1023 bytes; empty when there was none. Valid until this thread's next such call.
SULFUR_API const char* sulfur_last_error(void);
/// The name of a result, "out of range"; "?" for other numbers. Valid for ever.
SULFUR_API const char* sulfur_result_name(SulfurResult result);
/// "major.minor.patch" of the library that is linked. Valid for ever.
SULFUR_API const char* sulfur_version(void);
/// Whether the library was built with SULFUR_REAL_DOUBLE.
SULFUR_API bool sulfur_double_precision(void);

/// A place, a displacement, a velocity, a force: sulfur::Point or sulfur::Vec2.
typedef struct SulfurVec {
    double x;  ///< to the right
    double y;  ///< up
} SulfurVec;

/// Where and how a body is placed; sulfur::Pose.
typedef struct SulfurPose {
    SulfurVec position;  ///< metres
    double angle;        ///< radians, counter-clockwise
} SulfurPose;

/// An upright rectangle; sulfur::Bounds.
typedef struct SulfurBounds {
    SulfurVec low;   ///< metres, lower left corner
    SulfurVec high;  ///< metres, upper right corner
} SulfurBounds;

/// A particle's handle; sulfur::ParticleId.
typedef struct SulfurParticleId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurParticleId;

/// A joint's handle; sulfur::JointId.
typedef struct SulfurJointId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurJointId;

/// A body's handle; sulfur::BodyId.
typedef struct SulfurBodyId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurBodyId;

/// An attachment's handle; sulfur::AttachmentId.
typedef struct SulfurAttachmentId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurAttachmentId;

/// A force field's handle; sulfur::FieldId.
typedef struct SulfurFieldId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurFieldId;

/// A grab's handle; sulfur::GrabId.
typedef struct SulfurGrabId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurGrabId;

/// A mechanism's handle; sulfur::MechanismId.
typedef struct SulfurMechanismId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurMechanismId;

/// An angular joint's handle; sulfur::AngleId.
typedef struct SulfurAngleId {
    uint32_t index;       ///< slot, counted from 1; 0 is null
    uint32_t generation;  ///< of the slot
} SulfurAngleId;

/// How a surface behaves; sulfur::Material, which gives the ranges.
typedef struct SulfurMaterial {
    double static_friction;     ///< coefficient
    double kinetic_friction;    ///< coefficient
    double restitution;         ///< 0 to 1
    double surface_speed;       ///< m/s, as of a conveyor belt
    double rolling_resistance;  ///< coefficient, as of a wheel in sand
} SulfurMaterial;
/// That of a body for which none is given.
SULFUR_API SulfurMaterial sulfur_material_default(void);

/// Which bodies collide; sulfur::Filter.
typedef struct SulfurFilter {
    uint32_t category;  ///< bits: what the body is
    uint32_t mask;      ///< bits: what it collides with
    int32_t group;      ///< 0: no group
} SulfurFilter;
/// Category 1, which collides with everything.
SULFUR_API SulfurFilter sulfur_filter_default(void);
/// Whether `a` and `b` may collide.
SULFUR_API bool sulfur_may_collide(SulfurFilter a, SulfurFilter b);

#ifdef __cplusplus
}
#endif

#endif
