// Functions of the caller that a world asks in the middle of a tick.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

SulfurResult sulfur_world_set_should_collide(SulfurWorld* world,
                                             SulfurShouldCollideFunction function, void* user) {
    return call([&] {
        ShouldCollide asked;
        if (function)
            asked = [function, user](BodyId a, BodyId b) { return function(user, toC(a), toC(b)); };
        of(world).setShouldCollide(std::move(asked));
    });
}

SulfurResult sulfur_world_set_pre_solve(SulfurWorld* world, SulfurPreSolveFunction function,
                                        void* user) {
    return call([&] {
        PreSolve asked;
        if (function)
            asked = [function, user](const PreSolveContact& contact, Material& surface) {
                const SulfurPreSolveContact told = toC(contact);
                SulfurMaterial changed = toC(surface);
                const bool acts = function(user, &told, &changed);
                surface = fromC(changed);
                return acts;
            };
        of(world).setPreSolve(std::move(asked));
    });
}

}  // extern "C"

}  // namespace sulfur::c
