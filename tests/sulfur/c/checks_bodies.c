#include <math.h>
#include <string.h>

#include "check.h"
#include "checks.h"

/* A world without gravity with one crate of 2 kg. */
static const char* make(SulfurWorld** world, SulfurBodyId* crate) {
    SulfurWorldSettings settings = sulfur_world_settings_default();
    SulfurBoxOptions box = sulfur_box_options_default();
    SulfurBlueprint* blueprint = NULL;
    settings.gravity = v(0, 0);
    OK(sulfur_world_create(&settings, world));
    box.mass = 2;
    OK(sulfur_shape_box(&box, &blueprint));
    OK(sulfur_blueprint_set_name(blueprint, "crate"));
    OK(sulfur_world_add_body(*world, blueprint, at(1, 2, 0.5), crate));
    sulfur_blueprint_destroy(blueprint);
    return NULL;
}

static const char* check_motion(SulfurWorld* world, SulfurBodyId crate) {
    SulfurPose pose;
    SulfurVec velocity, centre;
    SulfurBounds bounds;
    double angle, turning, mass, inertia;
    OK(sulfur_body_mass(world, crate, &mass));
    CHECK(fabs(mass - 2) < 1e-6);
    OK(sulfur_body_inertia(world, crate, &inertia));
    CHECK(fabs(inertia - 2 * 2 / 12.0) < 1e-5);
    OK(sulfur_body_apply_impulse(world, crate, v(4, 0), v(1, 2)));
    OK(sulfur_body_apply_angular_impulse(world, crate, 1));
    OK(sulfur_body_mean_velocity(world, crate, &velocity));
    CHECK(fabs(velocity.x - 2) < 1e-5 && fabs(velocity.y) < 1e-5);
    OK(sulfur_body_angular_velocity(world, crate, &turning));
    CHECK(fabs(turning - 3) < 1e-4);
    OK(sulfur_world_step(world));
    OK(sulfur_body_pose(world, crate, &pose));
    CHECK(fabs(pose.position.x - 1.004) < 1e-6 && fabs(pose.angle - 0.506) < 1e-5);
    OK(sulfur_body_angle(world, crate, &angle));
    CHECK(angle == pose.angle);
    OK(sulfur_body_interpolated_pose(world, crate, 0.5, &pose));
    CHECK(fabs(pose.position.x - 1.002) < 1e-6);
    OK(sulfur_body_centre_of_mass(world, crate, &centre));
    CHECK(fabs(centre.x - 1.004) < 1e-6);
    OK(sulfur_body_set_pose(world, crate, at(0, 0, 0)));
    OK(sulfur_body_bounds(world, crate, &bounds));
    CHECK(fabs(bounds.low.x + 0.5) < 1e-5 && fabs(bounds.high.y - 0.5) < 1e-5);
    OK(sulfur_body_set_velocity(world, crate, v(0, 0)));
    OK(sulfur_body_apply_force(world, crate, v(0, 1000), v(0, 0)));
    OK(sulfur_body_apply_torque(world, crate, -5));
    OK(sulfur_world_step(world));
    OK(sulfur_body_mean_velocity(world, crate, &velocity));
    CHECK(velocity.y > 0.4);
    OK(sulfur_body_angular_velocity(world, crate, &turning));
    CHECK(turning < 0);
    return NULL;
}

static const char* check_properties(SulfurWorld* world, SulfurBodyId crate) {
    SulfurMaterial material = sulfur_material_default();
    SulfurFilter filter = sulfur_filter_default(), other = sulfur_filter_default();
    const char* name = NULL;
    SulfurBodyKind kind;
    uint64_t data;
    double scale;
    bool on;
    OK(sulfur_body_name(world, crate, &name));
    CHECK(strcmp(name, "crate") == 0);
    OK(sulfur_body_kind(world, crate, &kind));
    CHECK(kind == SULFUR_DYNAMIC);
    material.restitution = 0.25;
    OK(sulfur_body_set_material(world, crate, material));
    OK(sulfur_body_material(world, crate, &material));
    CHECK(material.restitution == 0.25 && fabs(material.static_friction - 0.6) < 1e-7);
    filter.group = -3;
    OK(sulfur_body_set_filter(world, crate, filter));
    OK(sulfur_body_filter(world, crate, &other));
    CHECK(other.group == -3 && other.category == 1 && other.mask == 0xffffffffu);
    CHECK(!sulfur_may_collide(filter, other));
    OK(sulfur_body_set_self_collision(world, crate, true));
    OK(sulfur_body_self_collision(world, crate, &on));
    CHECK(on);
    OK(sulfur_body_set_sensor(world, crate, true));
    OK(sulfur_body_sensor(world, crate, &on));
    CHECK(on);
    OK(sulfur_body_set_gravity_scale(world, crate, 0.5));
    OK(sulfur_body_gravity_scale(world, crate, &scale));
    CHECK(scale == 0.5);
    OK(sulfur_body_set_user_data(world, crate, 0xfedcba9876543210u));
    OK(sulfur_body_user_data(world, crate, &data));
    CHECK(data == 0xfedcba9876543210u);
    OK(sulfur_body_wake(world, crate));
    OK(sulfur_body_asleep(world, crate, &on));
    CHECK(!on);
    return NULL;
}

/* Whether it takes part, and as what; its frame in the world. Alone, without gravity. */
static const char* check_taking_part(SulfurWorld* world, SulfurBodyId crate) {
    SulfurVec place, back, before, after;
    SulfurPose pose;
    SulfurBodyKind kind;
    size_t count = 1;
    bool on;
    OK(sulfur_body_set_damping(world, crate, 0, 0));
    OK(sulfur_body_enabled(world, crate, &on));
    CHECK(on);
    OK(sulfur_body_set_motion(world, crate, v(1, 0), 0));
    OK(sulfur_body_set_enabled(world, crate, false));
    OK(sulfur_body_enabled(world, crate, &on));
    CHECK(!on);
    OK(sulfur_body_centre_of_mass(world, crate, &before));
    OK(sulfur_world_step(world));
    OK(sulfur_body_centre_of_mass(world, crate, &after));
    CHECK(after.x == before.x);
    OK(sulfur_body_set_enabled(world, crate, true));
    OK(sulfur_world_step(world));
    OK(sulfur_body_centre_of_mass(world, crate, &after));
    CHECK(fabs(after.x - before.x - 0.002) < 1e-6);
    OK(sulfur_body_set_kind(world, crate, SULFUR_FIXED));
    OK(sulfur_body_kind(world, crate, &kind));
    CHECK(kind == SULFUR_FIXED);
    CHECK(sulfur_body_set_kind(world, crate, (SulfurBodyKind)7) == SULFUR_OUT_OF_RANGE);
    OK(sulfur_body_set_kind(world, crate, SULFUR_DYNAMIC));
    OK(sulfur_body_contacts(world, crate, NULL, 0, &count));
    CHECK(count == 0);
    OK(sulfur_world_touches(world, crate, crate, &on));
    CHECK(!on);
    OK(sulfur_body_to_world(world, crate, v(0, 0), &place));
    OK(sulfur_body_pose(world, crate, &pose));
    CHECK(fabs(place.x - pose.position.x) < 1e-12 && fabs(place.y - pose.position.y) < 1e-12);
    OK(sulfur_body_to_world(world, crate, v(1, 2), &place));
    OK(sulfur_body_from_world(world, crate, place, &back));
    CHECK(fabs(back.x - 1) < 1e-9 && fabs(back.y - 2) < 1e-9);
    OK(sulfur_body_vector_to_world(world, crate, v(3, 4), &place));
    OK(sulfur_body_vector_from_world(world, crate, place, &back));
    CHECK(fabs(back.x - 3) < 1e-5 && fabs(back.y - 4) < 1e-5);
    return NULL;
}

/* How it comes to rest: what turns, what is braked, what sleeps. Alone, without gravity. */
static const char* check_calming(SulfurWorld* world, SulfurBodyId crate) {
    double linear, angular, turned, turning;
    SulfurVec before, velocity;
    bool on;
    OK(sulfur_body_fixed_rotation(world, crate, &on));
    CHECK(!on);
    OK(sulfur_body_set_fixed_rotation(world, crate, true));
    OK(sulfur_body_fixed_rotation(world, crate, &on));
    CHECK(on);
    OK(sulfur_body_set_motion(world, crate, v(1, 0), 2));
    OK(sulfur_world_step(world));
    OK(sulfur_body_angular_velocity(world, crate, &turning));
    CHECK(fabs(turning) < 1e-5);
    OK(sulfur_body_set_fixed_rotation(world, crate, false));
    OK(sulfur_body_set_damping(world, crate, 50, 100));
    OK(sulfur_body_linear_damping(world, crate, &linear));
    OK(sulfur_body_angular_damping(world, crate, &angular));
    CHECK(linear == 50 && angular == 100);
    CHECK(sulfur_body_set_damping(world, crate, -1, 0) == SULFUR_OUT_OF_RANGE);
    OK(sulfur_body_set_motion(world, crate, v(1, 0), 2));
    OK(sulfur_world_step(world));
    OK(sulfur_body_mean_velocity(world, crate, &before));
    OK(sulfur_body_angular_velocity(world, crate, &turned));
    OK(sulfur_world_step(world));
    OK(sulfur_body_mean_velocity(world, crate, &velocity));
    OK(sulfur_body_angular_velocity(world, crate, &turning));
    /* The trapezoidal rule over 1/500 s. */
    CHECK(fabs(velocity.x / before.x - 0.95 / 1.05) < 1e-4);
    CHECK(fabs(turning / turned - 0.9 / 1.1) < 1e-4);
    OK(sulfur_body_set_sleeping_allowed(world, crate, false));
    OK(sulfur_body_sleeping_allowed(world, crate, &on));
    CHECK(!on);
    OK(sulfur_body_put_to_sleep(world, crate, &on));
    CHECK(!on);
    OK(sulfur_body_set_sleeping_allowed(world, crate, true));
    OK(sulfur_body_put_to_sleep(world, crate, &on));
    CHECK(on);
    OK(sulfur_body_asleep(world, crate, &on));
    CHECK(on);
    OK(sulfur_body_wake(world, crate));
    return NULL;
}

/* A second body, which may pass through the first, is moved, and removed. */
static const char* check_two(SulfurWorld* world, SulfurBodyId crate) {
    SulfurBlueprint* blueprint = NULL;
    SulfurBodyId paddle, all[3];
    SulfurBodyPair pair;
    SulfurPose pose;
    size_t count;
    bool on;
    OK(sulfur_shape_ball(NULL, &blueprint));
    OK(sulfur_blueprint_set_kind(blueprint, SULFUR_KINEMATIC));
    OK(sulfur_world_add_body(world, blueprint, at(9, 9, 0), &paddle));
    sulfur_blueprint_destroy(blueprint);
    OK(sulfur_world_set_collision(world, paddle, crate, false));
    OK(sulfur_world_collision(world, crate, paddle, &on));
    CHECK(!on);
    OK(sulfur_world_vetoes(world, &pair, 1, &count));
    CHECK(count == 1 && pair.a.index == crate.index && pair.b.index == paddle.index);
    OK(sulfur_body_move_to(world, paddle, at(9, 9.01, 0)));
    OK(sulfur_world_step(world));
    OK(sulfur_body_pose(world, paddle, &pose));
    CHECK(fabs(pose.position.y - 9.01) < 1e-9);
    OK(sulfur_world_bodies(world, all, 3, &count));
    CHECK(count == 2 && all[0].index == crate.index && all[1].index == paddle.index);
    all[0].index = 77;
    OK(sulfur_world_bodies(world, all, 0, &count));
    CHECK(count == 2 && all[0].index == 77);
    OK(sulfur_body_remove(world, paddle));
    OK(sulfur_body_exists(world, paddle, &on));
    CHECK(!on);
    OK(sulfur_body_exists(world, crate, &on));
    CHECK(on);
    return NULL;
}

const char* c_check_bodies(void) {
    SulfurWorld* world = NULL;
    SulfurBodyId crate;
    const char* wrong = make(&world, &crate);
    if (!wrong) wrong = check_motion(world, crate);
    if (!wrong) wrong = check_calming(world, crate);
    if (!wrong) wrong = check_taking_part(world, crate);
    if (!wrong) wrong = check_properties(world, crate);
    if (!wrong) wrong = check_two(world, crate);
    sulfur_world_destroy(world);
    return wrong;
}

/* A stick of 3 and 1 kg. */
static const char* make_stick(SulfurBlueprint** plan) {
    SulfurParticleSpec particle = sulfur_particle_spec_default();
    SulfurJointSpec joint = sulfur_joint_spec_default();
    uint32_t a, b;
    OK(sulfur_blueprint_create(plan));
    CHECK(sulfur_blueprint_validate(*plan) != SULFUR_OK);
    CHECK(strstr(sulfur_last_error(), "particle") != NULL);
    particle.mass = 3;
    OK(sulfur_blueprint_add_particle(*plan, particle, &a));
    particle.position = v(2, 0);
    particle.mass = 1;
    OK(sulfur_blueprint_add_particle(*plan, particle, &b));
    CHECK(a == 0 && b == 1);
    joint.a = a;
    joint.b = b;
    joint.radius = 0.125;
    joint.bend = 0.5;
    joint.has_material = true;
    joint.material = sulfur_material_default();
    joint.material.surface_speed = 2;
    joint.material.rolling_resistance = 0.5;
    OK(sulfur_blueprint_add_joint(*plan, joint, NULL));
    OK(sulfur_blueprint_validate(*plan));
    return NULL;
}

static const char* check_stick(SulfurBlueprint* plan) {
    SulfurParticleSpec particle;
    SulfurJointSpec joint;
    SulfurVec centre;
    double mass;
    size_t count;
    OK(sulfur_blueprint_mass(plan, &mass));
    OK(sulfur_blueprint_centre_of_mass(plan, &centre));
    CHECK(mass == 4 && centre.x == 0.5 && centre.y == 0);
    OK(sulfur_blueprint_particle_count(plan, &count));
    CHECK(count == 2);
    OK(sulfur_blueprint_particle(plan, 1, &particle));
    CHECK(particle.mass == 1 && particle.position.x == 2);
    CHECK(sulfur_blueprint_particle(plan, 2, &particle) == SULFUR_BAD_INDEX);
    OK(sulfur_blueprint_joint_count(plan, &count));
    OK(sulfur_blueprint_joint(plan, 0, &joint));
    CHECK(count == 1 && joint.has_material && joint.material.surface_speed == 2);
    CHECK(joint.bend == 0.5);
    CHECK(joint.material.rolling_resistance == 0.5);
    CHECK(!joint.has_rest_length && joint.radius == 0.125 && isinf(joint.stiffness));
    joint.stiffness = 50;
    joint.bend = 0; /* what is elastic is straight */
    OK(sulfur_blueprint_set_joint(plan, 0, joint));
    particle.mass = 2;
    OK(sulfur_blueprint_set_particle(plan, 1, particle));
    return NULL;
}

static const char* check_plan(SulfurBlueprint* plan) {
    SulfurFilter filter = sulfur_filter_default();
    SulfurMaterial material = sulfur_material_default();
    SulfurBodyKind kind;
    const char* name;
    bool on;
    filter.category = 4;
    material.restitution = 0.5;
    OK(sulfur_blueprint_set_name(plan, "stick"));
    OK(sulfur_blueprint_set_kind(plan, SULFUR_KINEMATIC));
    OK(sulfur_blueprint_set_filter(plan, filter));
    OK(sulfur_blueprint_set_material(plan, material));
    OK(sulfur_blueprint_set_self_collision(plan, true));
    OK(sulfur_blueprint_set_sensor(plan, true));
    filter = sulfur_filter_default();
    material = sulfur_material_default();
    OK(sulfur_blueprint_name(plan, &name));
    OK(sulfur_blueprint_kind(plan, &kind));
    OK(sulfur_blueprint_filter(plan, &filter));
    OK(sulfur_blueprint_material(plan, &material));
    CHECK(strcmp(name, "stick") == 0 && kind == SULFUR_KINEMATIC);
    CHECK(filter.category == 4 && material.restitution == 0.5);
    OK(sulfur_blueprint_self_collision(plan, &on));
    CHECK(on);
    OK(sulfur_blueprint_sensor(plan, &on));
    CHECK(on);
    OK(sulfur_blueprint_set_kind(plan, SULFUR_DYNAMIC));
    return NULL;
}

/* The plan is gone before its copy is used. */
static const char* check_skin(SulfurBlueprint* plan) {
    const SulfurVec uv[2] = {{0, 1}, {1, 0.5}};
    const uint32_t corners[3] = {0, 1, 0};
    SulfurSkin skin = sulfur_skin_default(), worn;
    SulfurBlueprint* copy = NULL;
    SulfurWorld* world = NULL;
    SulfurBodyId body;
    double mass;
    bool has;
    OK(sulfur_blueprint_skin(plan, &worn, &has));
    CHECK(!has);
    skin.texture = "stick.png";
    skin.uv = uv;
    skin.uv_count = 2;
    skin.triangles = corners;
    skin.triangle_count = 1;
    OK(sulfur_blueprint_set_skin(plan, &skin));
    OK(sulfur_blueprint_copy(plan, &copy));
    OK(sulfur_blueprint_set_skin(plan, NULL));
    OK(sulfur_blueprint_skin(copy, &worn, &has));
    CHECK(has && strcmp(worn.texture, "stick.png") == 0 && worn.uv_count == 2);
    CHECK(worn.uv[1].y == 0.5 && worn.triangle_count == 1 && worn.triangles[1] == 1);
    OK(sulfur_world_create(NULL, &world));
    OK(sulfur_world_add_body(world, copy, at(0, 0, 0), &body));
    sulfur_blueprint_destroy(copy);
    OK(sulfur_body_skin(world, body, &worn, &has));
    CHECK(has && worn.uv[0].y == 1 && worn.triangles[1] == 1);
    OK(sulfur_body_mass(world, body, &mass));
    CHECK(mass == 5);
    sulfur_world_destroy(world);
    return NULL;
}

const char* c_check_blueprint(void) {
    SulfurBlueprint* plan = NULL;
    const char* wrong = make_stick(&plan);
    if (!wrong) wrong = check_stick(plan);
    if (!wrong) wrong = check_plan(plan);
    if (!wrong) wrong = check_skin(plan);
    sulfur_blueprint_destroy(plan);
    return wrong;
}

/* Two rods of 1 m at a right angle, which would rather be one. */
static const char* make_corner(SulfurBlueprint** plan) {
    const SulfurVec places[3] = {{0, 0}, {1, 0}, {1, 1}};
    SulfurParticleSpec particle = sulfur_particle_spec_default();
    SulfurJointSpec joint = sulfur_joint_spec_default();
    SulfurAngularJointSpec angle = sulfur_angular_joint_spec_default();
    uint32_t i;
    size_t count;
    OK(sulfur_blueprint_create(plan));
    for (i = 0; i < 3; ++i) {
        particle.position = places[i];
        OK(sulfur_blueprint_add_particle(*plan, particle, NULL));
    }
    for (i = 0; i < 2; ++i) {
        joint.a = i;
        joint.b = i + 1;
        OK(sulfur_blueprint_add_joint(*plan, joint, NULL));
    }
    CHECK(angle.stiffness == 0 && !angle.has_rest_angle);
    angle.b = 1;
    angle.c = 2;
    angle.stiffness = 7;
    angle.damping = 0.125;
    OK(sulfur_blueprint_add_angle(*plan, angle, &i));
    OK(sulfur_blueprint_angle_count(*plan, &count));
    CHECK(i == 0 && count == 1);
    OK(sulfur_blueprint_angle(*plan, 0, &angle));
    CHECK(angle.b == 1 && angle.c == 2 && angle.stiffness == 7 && !angle.has_rest_angle);
    CHECK(sulfur_blueprint_angle(*plan, 1, &angle) == SULFUR_BAD_INDEX);
    angle.stiffness = 2;
    angle.has_rest_angle = true;
    OK(sulfur_blueprint_set_angle(*plan, 0, angle));
    CHECK(sulfur_blueprint_set_angle(*plan, 1, angle) == SULFUR_BAD_INDEX);
    return NULL;
}

static const char* check_corner(SulfurWorld* world, const SulfurBlueprint* plan) {
    const double right = 1.5707963267948966;
    SulfurStatistics statistics;
    SulfurAngleInfo info;
    SulfurBodyId body;
    SulfurJointId rod;
    SulfurParticleId corner;
    size_t count;
    OK(sulfur_world_add_body(world, plan, at(0, 0, 0), &body));
    OK(sulfur_body_particle(world, body, 1, &corner));
    OK(sulfur_body_angles(world, body, &info, 1, &count));
    CHECK(count == 1 && info.b.index == corner.index && fabs(info.angle - right) < 1e-6);
    CHECK(info.drive.stiffness == 2 && info.drive.damping == 0.125 && info.drive.rest == 0);
    CHECK(info.body.index == body.index && info.id.index != 0);
    OK(sulfur_world_step(world));
    OK(sulfur_body_angles(world, body, &info, 1, &count));
    CHECK(fabs(info.torque + 2 * right) < 0.02 && info.angle < right);
    OK(sulfur_world_statistics(world, &statistics));
    CHECK(statistics.explicit_angles == 1 && statistics.implicit_angles == 0);
    OK(sulfur_body_joints(world, body, &rod, 1, &count));
    OK(sulfur_joint_remove(world, rod));
    OK(sulfur_world_step(world));
    OK(sulfur_world_statistics(world, &statistics));
    CHECK(statistics.explicit_angles == 0);
    return NULL;
}

/* An elbow with a motor, which a limit stops, until the limit breaks. */
static const char* check_elbow(SulfurWorld* world, const SulfurBlueprint* plan) {
    SulfurBodyId body;
    SulfurAngleInfo info;
    SulfurDrive drive;
    SulfurEvents events;
    size_t count, reached = 0, broken = 0;
    bool exists;
    int i;
    OK(sulfur_world_add_body(world, plan, at(5, 0, 0), &body));
    OK(sulfur_body_angles(world, body, &info, 1, &count));
    drive = info.drive;
    drive.stiffness = drive.damping = 0;
    drive.upper = 2;
    drive.motor_speed = 5;
    drive.motor_max = 40;
    OK(sulfur_angle_set_drive(world, info.id, &drive));
    for (i = 0; i < 200; ++i) {
        OK(sulfur_world_step(world));
        OK(sulfur_world_events(world, &events));
        if (events.limits_reached_count == 0) continue;
        reached += events.limits_reached_count;
        CHECK(events.limits_reached[0].angle.index == info.id.index);
        CHECK(events.limits_reached[0].mechanism.index == 0 && events.limits_reached[0].upper);
    }
    OK(sulfur_angle_info(world, info.id, &info));
    CHECK(reached == 1 && info.at_upper && !info.at_lower && fabs(info.angle - 2) < 1e-3);
    drive.strength = 20;
    OK(sulfur_angle_set_drive(world, info.id, &drive));
    for (i = 0; i < 3; ++i) {
        OK(sulfur_world_step(world));
        OK(sulfur_world_events(world, &events));
        if (events.angles_broken_count == 0) continue;
        broken += events.angles_broken_count;
        CHECK(events.angles_broken[0].angle.index == info.id.index);
        CHECK(events.angles_broken[0].corner.index == info.b.index);
        CHECK(events.angles_broken[0].torque > 20);
    }
    OK(sulfur_angle_exists(world, info.id, &exists));
    CHECK(broken == 1 && !exists);
    CHECK(sulfur_angle_remove(world, info.id) == SULFUR_STALE_HANDLE);
    OK(sulfur_body_remove(world, body));
    return NULL;
}

const char* c_check_angles(void) {
    SulfurWorldSettings settings = sulfur_world_settings_default();
    SulfurWorld* world = NULL;
    SulfurBlueprint* plan = NULL;
    const char* wrong = make_corner(&plan);
    settings.gravity = v(0, 0);
    if (!wrong) OK(sulfur_world_create(&settings, &world));
    if (!wrong) wrong = check_corner(world, plan);
    if (!wrong) wrong = check_elbow(world, plan);
    sulfur_blueprint_destroy(plan);
    sulfur_world_destroy(world);
    return wrong;
}
