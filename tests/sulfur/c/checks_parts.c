#include <math.h>

#include "check.h"
#include "checks.h"

/* Two balls of 1 kg, without gravity. */
static const char* make(SulfurWorld** world, SulfurBodyId balls[2], SulfurParticleId centres[2]) {
    SulfurWorldSettings settings = sulfur_world_settings_default();
    SulfurBlueprint* blueprint = NULL;
    int i;
    settings.gravity = v(0, 0);
    OK(sulfur_world_create(&settings, world));
    OK(sulfur_shape_ball(NULL, &blueprint));
    for (i = 0; i < 2; ++i) {
        OK(sulfur_world_add_body(*world, blueprint, at(2.0 * i, 0, 0), &balls[i]));
        OK(sulfur_body_particle(*world, balls[i], 0, &centres[i]));
    }
    sulfur_blueprint_destroy(blueprint);
    return NULL;
}

static const char* check_particle(SulfurWorld* world, SulfurParticleId particle) {
    SulfurParticleInfo info;
    SulfurVec place;
    bool exists;
    OK(sulfur_particle_set_mass(world, particle, 4));
    OK(sulfur_particle_apply_impulse(world, particle, v(0, 8)));
    OK(sulfur_particle_info(world, particle, &info));
    CHECK(info.mass == 4 && info.velocity.y == 2 && info.radius == 0.25 && !info.pinned);
    OK(sulfur_particle_set_pinned(world, particle, true));
    OK(sulfur_particle_info(world, particle, &info));
    CHECK(info.pinned);
    OK(sulfur_particle_set_pinned(world, particle, false));
    OK(sulfur_particle_set_velocity(world, particle, v(5, 0)));
    OK(sulfur_particle_set_position(world, particle, v(1, 1)));
    OK(sulfur_world_step(world));
    OK(sulfur_particle_position(world, particle, &place));
    CHECK(fabs(place.x - 1.01) < 1e-6 && place.y == 1);
    OK(sulfur_particle_interpolated(world, particle, 0, &place));
    CHECK(fabs(place.x - 1) < 1e-6);
    OK(sulfur_particle_apply_force(world, particle, v(0, 4000)));
    OK(sulfur_world_step(world));
    OK(sulfur_particle_velocity(world, particle, &place));
    CHECK(fabs(place.y - 2) < 1e-4);
    OK(sulfur_particle_exists(world, particle, &exists));
    CHECK(exists);
    OK(sulfur_particle_set_position(world, particle, v(0, 0)));
    OK(sulfur_particle_set_velocity(world, particle, v(0, 0)));
    return NULL;
}

static const char* check_joint(SulfurWorld* world, const SulfurParticleId ends[2]) {
    SulfurConnectOptions options = sulfur_connect_options_default();
    SulfurMaterial material = sulfur_material_default();
    SulfurJointId joint, listed;
    SulfurJointInfo info;
    size_t count;
    bool exists;
    options.stiffness = 100;
    options.radius = 0.1;
    OK(sulfur_world_connect(world, ends[0], ends[1], &options, &joint));
    OK(sulfur_joint_info(world, joint, &info));
    CHECK(info.body.index == 0 && info.a.index == ends[0].index && info.b.index == ends[1].index);
    CHECK(info.rest_length == 2 && info.stiffness == 100 && isinf(info.strength));
    OK(sulfur_joint_set_stiffness(world, joint, 200));
    OK(sulfur_joint_set_damping(world, joint, 3));
    OK(sulfur_joint_set_rest_length(world, joint, 1));
    OK(sulfur_joint_set_strength(world, joint, 1000));
    OK(sulfur_joint_info(world, joint, &info));
    CHECK(info.stiffness == 200 && info.damping == 3 && info.rest_length == 1);
    CHECK(info.strength == 1000);
    material.restitution = 1;
    OK(sulfur_joint_set_material(world, joint, &material));
    OK(sulfur_joint_material(world, joint, &material));
    CHECK(material.restitution == 1);
    OK(sulfur_joint_set_material(world, joint, NULL));
    OK(sulfur_joint_material(world, joint, &material));
    CHECK(material.restitution == 0);
    OK(sulfur_world_step(world));
    OK(sulfur_joint_info(world, joint, &info));
    CHECK(info.force > 100);
    OK(sulfur_world_connections(world, &listed, 1, &count));
    CHECK(count == 1 && listed.index == joint.index);
    OK(sulfur_joint_remove(world, joint));
    OK(sulfur_joint_exists(world, joint, &exists));
    CHECK(!exists);
    return NULL;
}

static const char* check_ties(SulfurWorld* world, const SulfurBodyId balls[2],
                              const SulfurParticleId centres[2]) {
    SulfurGrabOptions options = sulfur_grab_options_default();
    SulfurAttachmentId attachment, held;
    SulfurAttachmentInfo tie;
    SulfurGrabId grab, listed;
    SulfurGrabInfo info;
    size_t count;
    bool exists;
    OK(sulfur_world_attach_to_body(world, centres[0], balls[1], v(0, 0), &attachment));
    OK(sulfur_attachment_info(world, attachment, &tie));
    CHECK(tie.count >= 1 && tie.particle.index == centres[0].index);
    CHECK(tie.supports[0].index == centres[1].index && tie.weights[0] == 1);
    OK(sulfur_world_attachments(world, &held, 1, &count));
    CHECK(count == 1 && held.index == attachment.index);
    OK(sulfur_attachment_remove(world, attachment));
    OK(sulfur_attachment_exists(world, attachment, &exists));
    CHECK(!exists);
    options.frequency = 10;
    options.has_max_force = true;
    options.max_force = 50;
    OK(sulfur_world_grab_particle(world, centres[0], v(0, 3), &options, &grab));
    OK(sulfur_grab_set_target(world, grab, v(0, 5)));
    OK(sulfur_world_step(world));
    OK(sulfur_grab_info(world, grab, &info));
    CHECK(info.target.y == 5 && info.force.y > 49 && info.force.y < 51);
    OK(sulfur_world_grabs(world, &listed, 1, &count));
    CHECK(count == 1 && listed.index == grab.index);
    OK(sulfur_grab_release(world, grab));
    OK(sulfur_grab_exists(world, grab, &exists));
    CHECK(!exists);
    return NULL;
}

/* Which also has a joint to attach something to. */
static const char* check_rope(SulfurWorld* world, SulfurParticleId centre) {
    SulfurBlueprint* blueprint = NULL;
    SulfurBodyId rope;
    SulfurJointId link;
    SulfurAttachmentId attachment;
    SulfurAttachmentInfo tie;
    size_t count;
    OK(sulfur_shape_rope(NULL, &blueprint));
    OK(sulfur_world_add_body(world, blueprint, at(0, 0, 0), &rope));
    sulfur_blueprint_destroy(blueprint);
    OK(sulfur_body_joints(world, rope, &link, 1, &count));
    CHECK(count == 40);
    OK(sulfur_world_attach_to_joint(world, centre, link, 0.25, &attachment));
    OK(sulfur_attachment_info(world, attachment, &tie));
    CHECK(tie.count == 2 && tie.weights[0] == 0.75 && tie.weights[1] == 0.25);
    return NULL;
}

const char* c_check_parts(void) {
    SulfurWorld* world = NULL;
    SulfurBodyId balls[2];
    SulfurParticleId centres[2];
    const char* wrong = make(&world, balls, centres);
    if (!wrong) wrong = check_particle(world, centres[0]);
    if (!wrong) wrong = check_joint(world, centres);
    if (!wrong) wrong = check_ties(world, balls, centres);
    if (!wrong) wrong = check_rope(world, centres[1]);
    sulfur_world_destroy(world);
    return wrong;
}
