// Particles, joints, attachments and grabs.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

// --- particles -----------------------------------------------------------------------------------

SulfurResult sulfur_particle_info(const SulfurWorld* world, SulfurParticleId particle,
                                  SulfurParticleInfo* info) {
    return give(info, [&] { return of(world).info(fromC(particle)); });
}

SulfurResult sulfur_particle_exists(const SulfurWorld* world, SulfurParticleId particle,
                                    bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(particle)); });
}

SulfurResult sulfur_particle_position(const SulfurWorld* world, SulfurParticleId particle,
                                      SulfurVec* position) {
    return give(position, [&] { return of(world).position(fromC(particle)); });
}

SulfurResult sulfur_particle_interpolated(const SulfurWorld* world, SulfurParticleId particle,
                                          double alpha, SulfurVec* position) {
    return give(position, [&] { return of(world).interpolated(fromC(particle), alpha); });
}

SulfurResult sulfur_particle_velocity(const SulfurWorld* world, SulfurParticleId particle,
                                      SulfurVec* velocity) {
    return give(velocity, [&] { return of(world).velocity(fromC(particle)); });
}

SulfurResult sulfur_particle_set_position(SulfurWorld* world, SulfurParticleId particle,
                                          SulfurVec position) {
    return call([&] { of(world).setPosition(fromC(particle), point(position)); });
}

SulfurResult sulfur_particle_set_velocity(SulfurWorld* world, SulfurParticleId particle,
                                          SulfurVec velocity) {
    return call([&] { of(world).setVelocity(fromC(particle), vec(velocity)); });
}

SulfurResult sulfur_particle_set_mass(SulfurWorld* world, SulfurParticleId particle, double mass) {
    return call([&] { of(world).setMass(fromC(particle), real(mass)); });
}

SulfurResult sulfur_particle_set_pinned(SulfurWorld* world, SulfurParticleId particle,
                                        bool pinned) {
    return call([&] { of(world).setPinned(fromC(particle), pinned); });
}

SulfurResult sulfur_particle_apply_force(SulfurWorld* world, SulfurParticleId particle,
                                         SulfurVec force) {
    return call([&] { of(world).applyForce(fromC(particle), vec(force)); });
}

SulfurResult sulfur_particle_apply_impulse(SulfurWorld* world, SulfurParticleId particle,
                                           SulfurVec impulse) {
    return call([&] { of(world).applyImpulse(fromC(particle), vec(impulse)); });
}

// --- joints --------------------------------------------------------------------------------------

SulfurConnectOptions sulfur_connect_options_default(void) {
    return toC(ConnectOptions{});
}

SulfurResult sulfur_world_connect(SulfurWorld* world, SulfurParticleId a, SulfurParticleId b,
                                  const SulfurConnectOptions* options, SulfurJointId* joint) {
    return give(joint, [&] {
        return of(world).connect(fromC(a), fromC(b), orDefault<ConnectOptions>(options));
    });
}

SulfurResult sulfur_joint_remove(SulfurWorld* world, SulfurJointId joint) {
    return call([&] { of(world).remove(fromC(joint)); });
}

SulfurResult sulfur_joint_info(const SulfurWorld* world, SulfurJointId joint,
                               SulfurJointInfo* info) {
    return give(info, [&] { return of(world).info(fromC(joint)); });
}

SulfurResult sulfur_joint_exists(const SulfurWorld* world, SulfurJointId joint, bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(joint)); });
}

SulfurResult sulfur_world_connections(const SulfurWorld* world, SulfurJointId* out, size_t capacity,
                                      size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).connections(); });
}

SulfurResult sulfur_joint_material(const SulfurWorld* world, SulfurJointId joint,
                                   SulfurMaterial* material) {
    return give(material, [&] { return of(world).material(fromC(joint)); });
}

SulfurResult sulfur_joint_set_material(SulfurWorld* world, SulfurJointId joint,
                                       const SulfurMaterial* material) {
    return call([&] {
        std::optional<Material> surface;
        if (material) surface = fromC(*material);
        of(world).setMaterial(fromC(joint), surface);
    });
}

SulfurResult sulfur_joint_set_stiffness(SulfurWorld* world, SulfurJointId joint, double stiffness) {
    return call([&] { of(world).setStiffness(fromC(joint), real(stiffness)); });
}

SulfurResult sulfur_joint_set_damping(SulfurWorld* world, SulfurJointId joint, double damping) {
    return call([&] { of(world).setDamping(fromC(joint), real(damping)); });
}

SulfurResult sulfur_joint_set_rest_length(SulfurWorld* world, SulfurJointId joint,
                                          double rest_length) {
    return call([&] { of(world).setRestLength(fromC(joint), real(rest_length)); });
}

SulfurResult sulfur_joint_set_strength(SulfurWorld* world, SulfurJointId joint, double strength) {
    return call([&] { of(world).setStrength(fromC(joint), real(strength)); });
}

// --- angular joints ------------------------------------------------------------------------------

SulfurResult sulfur_body_angles(const SulfurWorld* world, SulfurBodyId body, SulfurAngleInfo* out,
                                size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).angles(fromC(body)); });
}

SulfurResult sulfur_angle_info(const SulfurWorld* world, SulfurAngleId angle,
                               SulfurAngleInfo* info) {
    return give(info, [&] { return of(world).info(fromC(angle)); });
}

SulfurResult sulfur_angle_set_drive(SulfurWorld* world, SulfurAngleId angle,
                                    const SulfurDrive* drive) {
    return call([&] { of(world).setDrive(fromC(angle), fromC(required(drive, "the drive"))); });
}

SulfurResult sulfur_angle_remove(SulfurWorld* world, SulfurAngleId angle) {
    return call([&] { of(world).remove(fromC(angle)); });
}

SulfurResult sulfur_angle_exists(const SulfurWorld* world, SulfurAngleId angle, bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(angle)); });
}

// --- attachments ---------------------------------------------------------------------------------

SulfurResult sulfur_world_attach_to_body(SulfurWorld* world, SulfurParticleId particle,
                                         SulfurBodyId body, SulfurVec local_point,
                                         SulfurAttachmentId* attachment) {
    return give(attachment,
                [&] { return of(world).attach(fromC(particle), fromC(body), vec(local_point)); });
}

SulfurResult sulfur_world_attach_to_joint(SulfurWorld* world, SulfurParticleId particle,
                                          SulfurJointId joint, double along,
                                          SulfurAttachmentId* attachment) {
    return give(attachment,
                [&] { return of(world).attach(fromC(particle), fromC(joint), real(along)); });
}

SulfurResult sulfur_attachment_remove(SulfurWorld* world, SulfurAttachmentId attachment) {
    return call([&] { of(world).remove(fromC(attachment)); });
}

SulfurResult sulfur_attachment_info(const SulfurWorld* world, SulfurAttachmentId attachment,
                                    SulfurAttachmentInfo* info) {
    return give(info, [&] { return of(world).info(fromC(attachment)); });
}

SulfurResult sulfur_attachment_exists(const SulfurWorld* world, SulfurAttachmentId attachment,
                                      bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(attachment)); });
}

SulfurResult sulfur_world_attachments(const SulfurWorld* world, SulfurAttachmentId* out,
                                      size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).attachments(); });
}

// --- grabs ---------------------------------------------------------------------------------------

SulfurGrabOptions sulfur_grab_options_default(void) {
    return toC(GrabOptions{});
}

SulfurResult sulfur_world_grab_particle(SulfurWorld* world, SulfurParticleId particle,
                                        SulfurVec target, const SulfurGrabOptions* options,
                                        SulfurGrabId* grab) {
    return give(grab, [&] {
        return of(world).grab(fromC(particle), point(target), orDefault<GrabOptions>(options));
    });
}

SulfurResult sulfur_world_grab_body(SulfurWorld* world, SulfurBodyId body, SulfurVec local_point,
                                    SulfurVec target, const SulfurGrabOptions* options,
                                    SulfurGrabId* grab) {
    return give(grab, [&] {
        return of(world).grab(fromC(body), vec(local_point), point(target),
                              orDefault<GrabOptions>(options));
    });
}

SulfurResult sulfur_grab_set_target(SulfurWorld* world, SulfurGrabId grab, SulfurVec target) {
    return call([&] { of(world).setTarget(fromC(grab), point(target)); });
}

SulfurResult sulfur_grab_release(SulfurWorld* world, SulfurGrabId grab) {
    return call([&] { of(world).release(fromC(grab)); });
}

SulfurResult sulfur_grab_info(const SulfurWorld* world, SulfurGrabId grab, SulfurGrabInfo* info) {
    return give(info, [&] { return of(world).info(fromC(grab)); });
}

SulfurResult sulfur_grab_exists(const SulfurWorld* world, SulfurGrabId grab, bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(grab)); });
}

SulfurResult sulfur_world_grabs(const SulfurWorld* world, SulfurGrabId* out, size_t capacity,
                                size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).grabs(); });
}

}  // extern "C"

}  // namespace sulfur::c
