// Mechanisms between bodies.
#include <vector>

#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

SulfurDrive sulfur_drive_default(void) {
    return toC(Drive{});
}

SulfurHingeOptions sulfur_hinge_options_default(void) {
    return toC(HingeOptions{});
}

SulfurWeldOptions sulfur_weld_options_default(void) {
    return toC(WeldOptions{});
}

SulfurSliderOptions sulfur_slider_options_default(void) {
    return toC(SliderOptions{});
}

SulfurWheelMechanismOptions sulfur_wheel_mechanism_options_default(void) {
    return toC(WheelOptions{});
}

SulfurDistanceOptions sulfur_distance_options_default(void) {
    return toC(DistanceOptions{});
}

SulfurPulleyOptions sulfur_pulley_options_default(void) {
    return toC(PulleyOptions{});
}

SulfurResult sulfur_world_hinge(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b, SulfurVec at,
                                const SulfurHingeOptions* options, SulfurMechanismId* mechanism) {
    return give(mechanism, [&] {
        return of(world).hinge(fromC(a), fromC(b), point(at), orDefault<HingeOptions>(options));
    });
}

SulfurResult sulfur_world_weld(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b, SulfurVec at,
                               const SulfurWeldOptions* options, SulfurMechanismId* mechanism) {
    return give(mechanism, [&] {
        return of(world).weld(fromC(a), fromC(b), point(at), orDefault<WeldOptions>(options));
    });
}

SulfurResult sulfur_world_slider(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b, SulfurVec at,
                                 SulfurVec axis, const SulfurSliderOptions* options,
                                 SulfurMechanismId* mechanism) {
    return give(mechanism, [&] {
        return of(world).slider(fromC(a), fromC(b), point(at), vec(axis),
                                orDefault<SliderOptions>(options));
    });
}

SulfurResult sulfur_world_slider_on_rail(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b,
                                         SulfurVec at, const SulfurJointId* rail, size_t count,
                                         const SulfurSliderOptions* options,
                                         SulfurMechanismId* mechanism) {
    return give(mechanism, [&] {
        if (count > 0) required(rail, "the rail");
        std::vector<JointId> links;
        for (std::size_t k = 0; k < count; ++k) links.push_back(fromC(rail[k]));
        return of(world).slider(fromC(a), fromC(b), point(at), links,
                                orDefault<SliderOptions>(options));
    });
}

SulfurResult sulfur_world_wheel(SulfurWorld* world, SulfurBodyId body, SulfurBodyId wheel,
                                SulfurVec at, SulfurVec axis,
                                const SulfurWheelMechanismOptions* options,
                                SulfurWheelIds* mechanisms) {
    return give(mechanisms, [&] {
        return of(world).wheel(fromC(body), fromC(wheel), point(at), vec(axis),
                               orDefault<WheelOptions>(options));
    });
}

SulfurResult sulfur_world_distance(SulfurWorld* world, SulfurBodyId a, SulfurVec at_a,
                                   SulfurBodyId b, SulfurVec at_b,
                                   const SulfurDistanceOptions* options,
                                   SulfurMechanismId* mechanism) {
    return give(mechanism, [&] {
        return of(world).distance(fromC(a), point(at_a), fromC(b), point(at_b),
                                  orDefault<DistanceOptions>(options));
    });
}

SulfurResult sulfur_world_pulley(SulfurWorld* world, SulfurBodyId a, SulfurVec at_a,
                                 SulfurVec over_a, SulfurBodyId b, SulfurVec at_b, SulfurVec over_b,
                                 SulfurBodyId frame, const SulfurPulleyOptions* options,
                                 SulfurMechanismId* mechanism) {
    return give(mechanism, [&] {
        return of(world).pulley(fromC(a), point(at_a), point(over_a), fromC(b), point(at_b),
                                point(over_b), fromC(frame), orDefault<PulleyOptions>(options));
    });
}

SulfurResult sulfur_world_gear(SulfurWorld* world, SulfurMechanismId first,
                               SulfurMechanismId second, double ratio,
                               SulfurMechanismId* mechanism) {
    return give(mechanism,
                [&] { return of(world).gear(fromC(first), fromC(second), real(ratio)); });
}

SulfurResult sulfur_mechanism_info(const SulfurWorld* world, SulfurMechanismId mechanism,
                                   SulfurMechanismInfo* info) {
    return give(info, [&] { return of(world).info(fromC(mechanism)); });
}

SulfurResult sulfur_mechanism_rail(const SulfurWorld* world, SulfurMechanismId mechanism,
                                   SulfurJointId* out, size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).info(fromC(mechanism)).rail; });
}

SulfurResult sulfur_mechanism_set_drive(SulfurWorld* world, SulfurMechanismId mechanism,
                                        const SulfurDrive* drive) {
    return call([&] { of(world).setDrive(fromC(mechanism), fromC(required(drive, "the drive"))); });
}

SulfurResult sulfur_mechanism_remove(SulfurWorld* world, SulfurMechanismId mechanism) {
    return call([&] { of(world).remove(fromC(mechanism)); });
}

SulfurResult sulfur_mechanism_exists(const SulfurWorld* world, SulfurMechanismId mechanism,
                                     bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(mechanism)); });
}

SulfurResult sulfur_world_mechanisms(const SulfurWorld* world, SulfurMechanismId* out,
                                     size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).mechanisms(); });
}

}  // extern "C"

}  // namespace sulfur::c
