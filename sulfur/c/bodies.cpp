// Bodies.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

// --- making and removing -------------------------------------------------------------------------

SulfurResult sulfur_world_add_body(SulfurWorld* world, const SulfurBlueprint* blueprint,
                                   SulfurPose pose, SulfurBodyId* body) {
    return give(body, [&] { return of(world).add(of(blueprint), fromC(pose)).id(); });
}

SulfurResult sulfur_body_remove(SulfurWorld* world, SulfurBodyId body) {
    return call([&] { of(world).remove(fromC(body)); });
}

SulfurResult sulfur_body_exists(const SulfurWorld* world, SulfurBodyId body, bool* exists) {
    return give(exists, [&] { return of(world).contains(fromC(body)); });
}

SulfurResult sulfur_world_bodies(const SulfurWorld* world, SulfurBodyId* out, size_t capacity,
                                 size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).bodies(); });
}

// --- what it is ----------------------------------------------------------------------------------

SulfurResult sulfur_body_particles(const SulfurWorld* world, SulfurBodyId body,
                                   SulfurParticleId* out, size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).particles(fromC(body)); });
}

SulfurResult sulfur_body_particle(const SulfurWorld* world, SulfurBodyId body, size_t index,
                                  SulfurParticleId* particle) {
    return give(particle, [&] {
        const auto particles = of(world).particles(fromC(body));
        return entry(particles, index, "particle");
    });
}

SulfurResult sulfur_body_joints(const SulfurWorld* world, SulfurBodyId body, SulfurJointId* out,
                                size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).joints(fromC(body)); });
}

SulfurResult sulfur_body_name(const SulfurWorld* world, SulfurBodyId body, const char** name) {
    return give(name, [&]() -> const std::string& { return of(world).name(fromC(body)); });
}

SulfurResult sulfur_body_kind(const SulfurWorld* world, SulfurBodyId body, SulfurBodyKind* kind) {
    return give(kind, [&] { return of(world).kind(fromC(body)); });
}

SulfurResult sulfur_body_skin(const SulfurWorld* world, SulfurBodyId body, SulfurSkin* skin,
                              bool* has) {
    return call([&] {
        SulfurSkin& result = required(skin, "a result");
        bool& isThere = required(has, "has");
        const std::optional<Skin>& worn = of(world).skin(fromC(body));
        if (worn) result = toC(*worn, world->uv);
        isThere = worn.has_value();
    });
}

SulfurResult sulfur_body_material(const SulfurWorld* world, SulfurBodyId body,
                                  SulfurMaterial* material) {
    return give(material, [&] { return of(world).material(fromC(body)); });
}

SulfurResult sulfur_body_set_material(SulfurWorld* world, SulfurBodyId body,
                                      SulfurMaterial material) {
    return call([&] { of(world).setMaterial(fromC(body), fromC(material)); });
}

SulfurResult sulfur_body_filter(const SulfurWorld* world, SulfurBodyId body, SulfurFilter* filter) {
    return give(filter, [&] { return of(world).filter(fromC(body)); });
}

SulfurResult sulfur_body_set_filter(SulfurWorld* world, SulfurBodyId body, SulfurFilter filter) {
    return call([&] { of(world).setFilter(fromC(body), fromC(filter)); });
}

SulfurResult sulfur_body_self_collision(const SulfurWorld* world, SulfurBodyId body, bool* on) {
    return give(on, [&] { return of(world).selfCollision(fromC(body)); });
}

SulfurResult sulfur_body_set_self_collision(SulfurWorld* world, SulfurBodyId body, bool on) {
    return call([&] { of(world).setSelfCollision(fromC(body), on); });
}

SulfurResult sulfur_body_sensor(const SulfurWorld* world, SulfurBodyId body, bool* sensor) {
    return give(sensor, [&] { return of(world).sensor(fromC(body)); });
}

SulfurResult sulfur_body_set_sensor(SulfurWorld* world, SulfurBodyId body, bool sensor) {
    return call([&] { of(world).setSensor(fromC(body), sensor); });
}

SulfurResult sulfur_body_visitors(const SulfurWorld* world, SulfurBodyId sensor, SulfurBodyId* out,
                                  size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).visitors(fromC(sensor)); });
}

SulfurResult sulfur_body_gravity_scale(const SulfurWorld* world, SulfurBodyId body, double* scale) {
    return give(scale, [&] { return of(world).gravityScale(fromC(body)); });
}

SulfurResult sulfur_body_set_gravity_scale(SulfurWorld* world, SulfurBodyId body, double scale) {
    return call([&] { of(world).setGravityScale(fromC(body), real(scale)); });
}

SulfurResult sulfur_body_fixed_rotation(const SulfurWorld* world, SulfurBodyId body, bool* on) {
    return give(on, [&] { return of(world).fixedRotation(fromC(body)); });
}

SulfurResult sulfur_body_set_fixed_rotation(SulfurWorld* world, SulfurBodyId body, bool on) {
    return call([&] { of(world).setFixedRotation(fromC(body), on); });
}

SulfurResult sulfur_body_linear_damping(const SulfurWorld* world, SulfurBodyId body,
                                        double* damping) {
    return give(damping, [&] { return of(world).linearDamping(fromC(body)); });
}

SulfurResult sulfur_body_angular_damping(const SulfurWorld* world, SulfurBodyId body,
                                         double* damping) {
    return give(damping, [&] { return of(world).angularDamping(fromC(body)); });
}

SulfurResult sulfur_body_set_damping(SulfurWorld* world, SulfurBodyId body, double linear,
                                     double angular) {
    return call([&] { of(world).setDamping(fromC(body), real(linear), real(angular)); });
}

SulfurResult sulfur_body_user_data(const SulfurWorld* world, SulfurBodyId body, uint64_t* data) {
    return give(data, [&] { return of(world).userData(fromC(body)); });
}

SulfurResult sulfur_body_set_user_data(SulfurWorld* world, SulfurBodyId body, uint64_t data) {
    return call([&] { of(world).setUserData(fromC(body), data); });
}

SulfurResult sulfur_body_asleep(const SulfurWorld* world, SulfurBodyId body, bool* asleep) {
    return give(asleep, [&] { return of(world).asleep(fromC(body)); });
}

SulfurResult sulfur_body_wake(SulfurWorld* world, SulfurBodyId body) {
    return call([&] { of(world).wake(fromC(body)); });
}

SulfurResult sulfur_body_put_to_sleep(SulfurWorld* world, SulfurBodyId body, bool* asleep) {
    return give(asleep, [&] { return of(world).putToSleep(fromC(body)); });
}

SulfurResult sulfur_body_sleeping_allowed(const SulfurWorld* world, SulfurBodyId body,
                                          bool* allowed) {
    return give(allowed, [&] { return of(world).sleepingAllowed(fromC(body)); });
}

SulfurResult sulfur_body_set_sleeping_allowed(SulfurWorld* world, SulfurBodyId body, bool allowed) {
    return call([&] { of(world).setSleepingAllowed(fromC(body), allowed); });
}

SulfurResult sulfur_world_collision(const SulfurWorld* world, SulfurBodyId a, SulfurBodyId b,
                                    bool* on) {
    return give(on, [&] { return of(world).collision(fromC(a), fromC(b)); });
}

SulfurResult sulfur_world_set_collision(SulfurWorld* world, SulfurBodyId a, SulfurBodyId b,
                                        bool on) {
    return call([&] { of(world).setCollision(fromC(a), fromC(b), on); });
}

SulfurResult sulfur_world_vetoes(const SulfurWorld* world, SulfurBodyPair* out, size_t capacity,
                                 size_t* count) {
    return giveList(out, capacity, count, [&] { return of(world).vetoes(); });
}

// --- where it is and how it moves ----------------------------------------------------------------

SulfurResult sulfur_body_pose(const SulfurWorld* world, SulfurBodyId body, SulfurPose* pose) {
    return give(pose, [&] { return of(world).pose(fromC(body)); });
}

SulfurResult sulfur_body_interpolated_pose(const SulfurWorld* world, SulfurBodyId body,
                                           double alpha, SulfurPose* pose) {
    return give(pose, [&] { return of(world).interpolatedPose(fromC(body), alpha); });
}

SulfurResult sulfur_body_angle(const SulfurWorld* world, SulfurBodyId body, double* angle) {
    return give(angle, [&] { return of(world).angle(fromC(body)); });
}

SulfurResult sulfur_body_centre_of_mass(const SulfurWorld* world, SulfurBodyId body,
                                        SulfurVec* centre) {
    return give(centre, [&] { return of(world).centreOfMass(fromC(body)); });
}

SulfurResult sulfur_body_mean_velocity(const SulfurWorld* world, SulfurBodyId body,
                                       SulfurVec* velocity) {
    return give(velocity, [&] { return of(world).meanVelocity(fromC(body)); });
}

SulfurResult sulfur_body_angular_velocity(const SulfurWorld* world, SulfurBodyId body,
                                          double* velocity) {
    return give(velocity, [&] { return of(world).angularVelocity(fromC(body)); });
}

SulfurResult sulfur_body_mass(const SulfurWorld* world, SulfurBodyId body, double* mass) {
    return give(mass, [&] { return of(world).mass(fromC(body)); });
}

SulfurResult sulfur_body_inertia(const SulfurWorld* world, SulfurBodyId body, double* inertia) {
    return give(inertia, [&] { return of(world).inertia(fromC(body)); });
}

SulfurResult sulfur_body_bounds(const SulfurWorld* world, SulfurBodyId body, SulfurBounds* bounds) {
    return give(bounds, [&] { return of(world).bounds(fromC(body)); });
}

// --- moving it -----------------------------------------------------------------------------------

SulfurResult sulfur_body_set_pose(SulfurWorld* world, SulfurBodyId body, SulfurPose pose) {
    return call([&] { of(world).setPose(fromC(body), fromC(pose)); });
}

SulfurResult sulfur_body_set_velocity(SulfurWorld* world, SulfurBodyId body, SulfurVec velocity) {
    return call([&] { of(world).setVelocity(fromC(body), vec(velocity)); });
}

SulfurResult sulfur_body_set_motion(SulfurWorld* world, SulfurBodyId body, SulfurVec linear,
                                    double angular) {
    return call([&] { of(world).setVelocity(fromC(body), vec(linear), angular); });
}

SulfurResult sulfur_body_apply_force(SulfurWorld* world, SulfurBodyId body, SulfurVec force,
                                     SulfurVec at) {
    return call([&] { of(world).applyForce(fromC(body), vec(force), point(at)); });
}

SulfurResult sulfur_body_apply_torque(SulfurWorld* world, SulfurBodyId body, double torque) {
    return call([&] { of(world).applyTorque(fromC(body), real(torque)); });
}

SulfurResult sulfur_body_apply_impulse(SulfurWorld* world, SulfurBodyId body, SulfurVec impulse,
                                       SulfurVec at) {
    return call([&] { of(world).applyImpulse(fromC(body), vec(impulse), point(at)); });
}

SulfurResult sulfur_body_apply_angular_impulse(SulfurWorld* world, SulfurBodyId body,
                                               double impulse) {
    return call([&] { of(world).applyAngularImpulse(fromC(body), real(impulse)); });
}

SulfurResult sulfur_body_move_to(SulfurWorld* world, SulfurBodyId body, SulfurPose pose) {
    return call([&] { of(world).moveTo(fromC(body), fromC(pose)); });
}

// --- whether it takes part, and as what ----------------------------------------------------------

SulfurResult sulfur_body_set_kind(SulfurWorld* world, SulfurBodyId body, SulfurBodyKind kind) {
    return call([&] { of(world).setKind(fromC(body), bodyKind(kind)); });
}

SulfurResult sulfur_body_enabled(const SulfurWorld* world, SulfurBodyId body, bool* enabled) {
    return give(enabled, [&] { return of(world).isEnabled(fromC(body)); });
}

SulfurResult sulfur_body_set_enabled(SulfurWorld* world, SulfurBodyId body, bool enabled) {
    return call([&] { of(world).setEnabled(fromC(body), enabled); });
}

// --- its frame and that of the world -------------------------------------------------------------

SulfurResult sulfur_body_to_world(const SulfurWorld* world, SulfurBodyId body, SulfurVec local,
                                  SulfurVec* place) {
    return give(place, [&] { return of(world).toWorld(fromC(body), point(local)); });
}

SulfurResult sulfur_body_from_world(const SulfurWorld* world, SulfurBodyId body, SulfurVec place,
                                    SulfurVec* local) {
    return give(local, [&] { return of(world).toBody(fromC(body), point(place)); });
}

SulfurResult sulfur_body_vector_to_world(const SulfurWorld* world, SulfurBodyId body,
                                         SulfurVec local, SulfurVec* vector) {
    return give(vector, [&] { return of(world).vectorToWorld(fromC(body), vec(local)); });
}

SulfurResult sulfur_body_vector_from_world(const SulfurWorld* world, SulfurBodyId body,
                                           SulfurVec vector, SulfurVec* local) {
    return give(local, [&] { return of(world).vectorToBody(fromC(body), vec(vector)); });
}

}  // extern "C"

}  // namespace sulfur::c
