#include <math.h>

#include "check.h"
#include "checks.h"

/* Without gravity: what stands still, and three crates in a row. */
typedef struct Scene {
    SulfurWorld* world;
    SulfurBodyId ground, crates[3];
} Scene;

static const char* make(Scene* scene) {
    SulfurWorldSettings settings = sulfur_world_settings_default();
    SulfurBlueprint* blueprint = NULL;
    int i;
    settings.gravity = v(0, 0);
    OK(sulfur_world_create(&settings, &scene->world));
    OK(sulfur_shape_floor(v(-9, -5), v(9, -5), 0.05, &blueprint));
    OK(sulfur_world_add_body(scene->world, blueprint, at(0, 0, 0), &scene->ground));
    sulfur_blueprint_destroy(blueprint);
    OK(sulfur_shape_box(NULL, &blueprint));
    for (i = 0; i < 3; ++i)
        OK(sulfur_world_add_body(scene->world, blueprint, at(2.0 * i, 0, 0), &scene->crates[i]));
    sulfur_blueprint_destroy(blueprint);
    return NULL;
}

/* Steps until a limit tells of itself; `left` asks for one that no longer pushes. */
static const char* await_limit(SulfurWorld* world, bool left, SulfurLimitEvent* limit) {
    int i;
    for (i = 0; i < 500; ++i) {
        SulfurEvents events;
        OK(sulfur_world_step(world));
        OK(sulfur_world_events(world, &events));
        if ((left ? events.limits_left_count : events.limits_reached_count) == 0) continue;
        *limit = left ? events.limits_left[0] : events.limits_reached[0];
        return NULL;
    }
    return "no limit told of itself";
}

/* A motor turns a crate to a limit and back again, until the drive breaks. */
static const char* check_hinge(const Scene* s) {
    SulfurHingeOptions options = sulfur_hinge_options_default();
    SulfurMechanismId hinge;
    SulfurMechanismInfo info;
    SulfurLimitEvent limit;
    SulfurEvents events;
    const char* wrong;
    bool exists;
    int i;
    options.drive.motor_speed = 2;
    options.drive.motor_max = 1000;
    options.drive.upper = 0.5;
    OK(sulfur_world_hinge(s->world, s->ground, s->crates[0], v(0, 0), &options, &hinge));
    for (i = 0; i < 50; ++i) OK(sulfur_world_step(s->world));
    OK(sulfur_mechanism_info(s->world, hinge, &info));
    CHECK(info.kind == SULFUR_HINGE && info.a.index == s->ground.index);
    CHECK(info.b.index == s->crates[0].index && fabs(info.point_b.x) < 1e-3);
    CHECK(fabs(info.value - 0.2) < 0.01 && fabs(info.speed - 2) < 0.01 && !info.at_upper);
    CHECK(isinf(info.drive.lower) && info.drive.motor_max == 1000 && !info.drive.has_motor_target);
    wrong = await_limit(s->world, false, &limit);
    if (wrong) return wrong;
    CHECK(limit.upper && limit.mechanism.index == hinge.index);
    OK(sulfur_mechanism_info(s->world, hinge, &info));
    CHECK(info.at_upper && fabs(info.value - 0.5) < 0.01);
    options.drive.motor_speed = -2;
    OK(sulfur_mechanism_set_drive(s->world, hinge, &options.drive));
    wrong = await_limit(s->world, true, &limit);
    if (wrong) return wrong;
    CHECK(limit.upper && limit.mechanism.index == hinge.index);
    for (i = 0; i < 10; ++i) OK(sulfur_world_step(s->world)); /* away from the limit */
    options.drive.motor_speed = 9;
    options.drive.strength = 0.001;
    OK(sulfur_mechanism_set_drive(s->world, hinge, &options.drive));
    OK(sulfur_world_step(s->world));
    OK(sulfur_world_events(s->world, &events));
    CHECK(events.mechanisms_broken_count == 1);
    CHECK(events.mechanisms_broken[0].b.index == s->crates[0].index);
    CHECK(fabs(events.mechanisms_broken[0].force) > 0.001);
    OK(sulfur_mechanism_exists(s->world, hinge, &exists));
    CHECK(!exists);
    return NULL;
}

/* One of each, with the defaults. */
static const char* make_others(const Scene* s, SulfurMechanismId made[7]) {
    SulfurWheelIds wheel;
    OK(sulfur_world_hinge(s->world, s->ground, s->crates[0], v(0, 0), NULL, &made[0]));
    OK(sulfur_world_slider(s->world, s->ground, s->crates[1], v(2, 0), v(0, 3), NULL, &made[1]));
    OK(sulfur_world_gear(s->world, made[0], made[1], -0.5, &made[2]));
    OK(sulfur_world_distance(s->world, s->crates[0], v(0, 0), s->crates[2], v(4, 0), NULL,
                             &made[3]));
    OK(sulfur_world_pulley(s->world, s->crates[1], v(2, 0), v(2, 5), s->crates[2], v(4, 0), v(4, 5),
                           s->ground, NULL, &made[4]));
    OK(sulfur_world_wheel(s->world, s->ground, s->crates[2], v(4, 0), v(0, 1), NULL, &wheel));
    made[5] = wheel.spring;
    made[6] = wheel.motor;
    return NULL;
}

static const char* check_others(const Scene* s) {
    SulfurDrive drive = sulfur_drive_default();
    SulfurMechanismId made[7], listed[7];
    SulfurMechanismInfo info;
    size_t count;
    bool exists;
    int i;
    const char* wrong = make_others(s, made);
    if (wrong) return wrong;
    OK(sulfur_world_mechanisms(s->world, listed, 7, &count));
    CHECK(count == 7);
    for (i = 0; i < 7; ++i) CHECK(listed[i].index == made[i].index);
    OK(sulfur_mechanism_info(s->world, made[2], &info));
    CHECK(info.kind == SULFUR_GEAR && info.ratio == -0.5);
    CHECK(info.first.index == made[0].index && info.second.index == made[1].index);
    OK(sulfur_mechanism_info(s->world, made[3], &info));
    CHECK(info.kind == SULFUR_DISTANCE && fabs(info.value - 4) < 1e-3 && info.point_b.x > 3.9);
    OK(sulfur_mechanism_info(s->world, made[4], &info));
    CHECK(info.kind == SULFUR_PULLEY && fabs(info.drive.upper - 10) < 1e-3 && info.ratio == 1);
    OK(sulfur_mechanism_info(s->world, made[5], &info));
    CHECK(info.kind == SULFUR_SLIDER && fabs(hypot(info.axis.x, info.axis.y) - 1) < 1e-6);
    OK(sulfur_mechanism_info(s->world, made[6], &info));
    CHECK(info.kind == SULFUR_HINGE);
    drive.motor_speed = 1;
    drive.motor_max = 1e6;
    OK(sulfur_mechanism_set_drive(s->world, made[1], &drive));
    for (i = 0; i < 50; ++i) OK(sulfur_world_step(s->world));
    OK(sulfur_mechanism_info(s->world, made[0], &info)); /* by the gear */
    CHECK(fabs(info.speed - 0.5) < 0.01);
    OK(sulfur_mechanism_remove(s->world, made[0]));
    OK(sulfur_mechanism_exists(s->world, made[0], &exists));
    CHECK(!exists);
    CHECK(sulfur_mechanism_remove(s->world, made[0]) == SULFUR_STALE_HANDLE);
    return NULL;
}

static const char* check_refusals(const Scene* s) {
    SulfurWeldOptions options = sulfur_weld_options_default();
    SulfurMechanismId weld = {77, 0};
    SulfurMechanismInfo info;
    const SulfurBodyId a = s->crates[0], b = s->crates[1];
    CHECK(isinf(options.stiffness) && isinf(options.strength) && !options.collide);
    options.damping = -1;
    CHECK(sulfur_world_weld(s->world, a, b, v(1, 0), &options, &weld) == SULFUR_OUT_OF_RANGE);
    CHECK(sulfur_world_weld(s->world, a, a, v(1, 0), NULL, &weld) == SULFUR_DEGENERATE);
    CHECK(sulfur_world_weld(s->world, a, b, v(1, 0), NULL, NULL) == SULFUR_NULL_POINTER);
    CHECK(weld.index == 77);
    OK(sulfur_world_weld(s->world, a, b, v(1, 0), NULL, &weld));
    OK(sulfur_mechanism_info(s->world, weld, &info));
    CHECK(info.kind == SULFUR_WELD && fabs(info.point_a.x - 1) < 1e-3);
    CHECK(sulfur_mechanism_set_drive(s->world, weld, NULL) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_gear(s->world, weld, weld, 1, &weld) == SULFUR_DEGENERATE);
    return NULL;
}

/* A part of it in a world of its own. */
static const char* run(const char* (*check)(const Scene*)) {
    Scene scene;
    const char* wrong = make(&scene);
    if (!wrong) wrong = check(&scene);
    sulfur_world_destroy(scene.world);
    return wrong;
}

const char* c_check_mechanisms(void) {
    const char* wrong = run(check_hinge);
    if (!wrong) wrong = run(check_others);
    if (!wrong) wrong = run(check_refusals);
    return wrong;
}
