#include "check.h"
#include "checks.h"

/* Adds what a blueprint says, and destroys it. */
static SulfurResult add(SulfurWorld* world, SulfurBlueprint* blueprint, SulfurPose pose,
                        SulfurBodyId* body) {
    const SulfurResult result = sulfur_world_add_body(world, blueprint, pose, body);
    sulfur_blueprint_destroy(blueprint);
    return result;
}

static const char* add_ground_and_crates(SulfurWorld* world, SulfurBodyId crates[5]) {
    const SulfurVec corners[4] = {{-8, 9}, {-8, 0}, {8, 0}, {8, 9}};
    SulfurGroundOptions ground = sulfur_ground_options_default();
    SulfurBlueprint* blueprint = NULL;
    SulfurBodyId body;
    int i;
    ground.points = corners;
    ground.point_count = 4;
    ground.material.static_friction = 0.75;
    OK(sulfur_shape_ground(&ground, &blueprint));
    OK(add(world, blueprint, at(0, 0, 0), &body));
    for (i = 0; i < 5; ++i) {
        OK(sulfur_shape_box(NULL, &blueprint));
        OK(add(world, blueprint, at(-5, 0.6 + 1.1 * i, 0.05 * i), &crates[i]));
    }
    OK(sulfur_body_set_user_data(world, crates[2], 99));
    return NULL;
}

static const char* hang_rope(SulfurWorld* world) {
    SulfurRopeOptions rope = sulfur_rope_options_default();
    SulfurBoxOptions box = sulfur_box_options_default();
    SulfurBlueprint* blueprint = NULL;
    SulfurBodyId string, load;
    SulfurParticleId last;
    SulfurAttachmentId attachment;
    size_t count = 0;
    rope.from = v(-2, 8);
    rope.to = v(1, 8);
    rope.pin_first = true;
    OK(sulfur_shape_rope(&rope, &blueprint));
    OK(add(world, blueprint, at(0, 0, 0), &string));
    box.size = v(0.75, 0.5);
    box.mass = 5;
    OK(sulfur_shape_box(&box, &blueprint));
    OK(add(world, blueprint, at(1, 7.75, 0), &load));
    OK(sulfur_body_particles(world, string, NULL, 0, &count));
    OK(sulfur_body_particle(world, string, count - 1, &last));
    OK(sulfur_world_attach_to_body(world, last, load, v(0, 0.25), &attachment));
    return NULL;
}

static const char* add_others(SulfurWorld* world) {
    SulfurWallOptions wall = sulfur_wall_options_default();
    SulfurField field = sulfur_field_default(SULFUR_WIND_FIELD);
    SulfurBlueprint* blueprint = NULL;
    SulfurFieldId wind;
    SulfurGrabId grab;
    SulfurBodyId jelly, ball, body;
    OK(sulfur_shape_jelly(NULL, &blueprint));
    OK(add(world, blueprint, at(-2, 2, 0.25), &jelly));
    wall.strength = 300;
    OK(sulfur_shape_wall(&wall, &blueprint));
    OK(add(world, blueprint, at(5, 0.6, 0), &body));
    OK(sulfur_shape_ball(NULL, &blueprint));
    OK(add(world, blueprint, at(1.5, 1, 0), &ball));
    OK(sulfur_body_set_motion(world, ball, v(20, 1), -3));
    field.wind.velocity = v(2, 0);
    field.wind.drag = 0.125;
    OK(sulfur_world_add_field(world, &field, &wind));
    OK(sulfur_world_grab_body(world, jelly, v(0.25, 0.25), v(-2, 4), NULL, &grab));
    return NULL;
}

const char* c_make_scene(SulfurWorld** world, SulfurBodyId crates[5]) {
    SulfurWorldSettings settings = sulfur_world_settings_default();
    const char* wrong;
    settings.gravity = v(0, -9.75);
    settings.air_friction = 0.0625;
    OK(sulfur_world_create(&settings, world));
    wrong = add_ground_and_crates(*world, crates);
    if (!wrong) wrong = hang_rope(*world);
    if (!wrong) wrong = add_others(*world);
    return wrong;
}
