/// \file
/// What a world asks its caller in the middle of a tick; sulfur/callbacks.hpp.
///
/// Callbacks are called by the thread that steps the world, one at a time and in a fixed order,
/// whatever threads are lent. One may ask what bodies, particles and joints are. Whatever changes
/// the world returns SULFUR_IN_CALLBACK there and changes nothing, as do queries,
/// sulfur_world_hash, _snapshot, _restore, _validate and _step. It must not destroy the world.
///
/// An answer that cannot be, a number of a surface that is outside the ranges of sulfur::Material,
/// is told when the tick is over: the tick goes on to its end as if there were no callbacks, and
/// then sulfur_world_step returns what is wrong, SULFUR_OUT_OF_RANGE or SULFUR_NOT_FINITE. Unlike
/// after other refused calls the world is then one tick further; it is whole, and the next tick
/// asks again. An exception that a callback written in C++ throws ends alike, in SULFUR_FAILED.
/// In C a callback that fails notes it in what its `user` points at, and answers true.
#ifndef SULFUR_C_CALLBACKS_H
#define SULFUR_C_CALLBACKS_H

#include <sulfur/c/base.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Whether two bodies collide; `a` is the one with the smaller handle.
typedef bool (*SulfurShouldCollideFunction)(void* user, SulfurBodyId a, SulfurBodyId b);
/// Asks in the ticks to come, once about two bodies when they come near each other; null, as at
/// first: asks nobody. `function` and `user` must stay until others are set or the world is
/// destroyed; clones and snapshots do not have them. World::setShouldCollide says how long an
/// answer holds.
SULFUR_API SulfurResult sulfur_world_set_should_collide(SulfurWorld* world,
                                                        SulfurShouldCollideFunction function,
                                                        void* user);

/// A contact of two bodies before it is solved; sulfur::PreSolveContact.
typedef struct SulfurPreSolveContact {
    SulfurBodyId a;    ///< the body with the smaller handle
    SulfurBodyId b;    ///< the other
    SulfurVec point;   ///< metres, on the surface, when the step begins
    SulfurVec normal;  ///< unit length, from b towards a
    double speed;      ///< m/s at which they approach along the normal; below 0 they part
    double gap;        ///< metres between them; below 0 they overlap
} SulfurPreSolveContact;
/// Whether a contact acts in this step. `surface`, which may be changed, is how both surfaces meet;
/// its surface_speed is that at which b's carries a to the right of the normal. Both pointers are
/// valid until the function returns.
typedef bool (*SulfurPreSolveFunction)(void* user, const SulfurPreSolveContact* contact,
                                       SulfurMaterial* surface);
/// Asks in each step to come about each contact, before it is solved; null, as at first: asks
/// nobody. `function` and `user` must stay until others are set or the world is destroyed; clones
/// and snapshots do not have them. World::setPreSolve says who is asked about.
SULFUR_API SulfurResult sulfur_world_set_pre_solve(SulfurWorld* world,
                                                   SulfurPreSolveFunction function, void* user);

#ifdef __cplusplus
}
#endif

#endif
