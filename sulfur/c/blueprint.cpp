// The plan of a body.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

SulfurParticleSpec sulfur_particle_spec_default(void) {
    return toC(ParticleSpec{});
}

SulfurJointSpec sulfur_joint_spec_default(void) {
    return toC(JointSpec{});
}

SulfurAngularJointSpec sulfur_angular_joint_spec_default(void) {
    return toC(AngularJointSpec{});
}

SulfurSkin sulfur_skin_default(void) {
    return {"", nullptr, 0, nullptr, 0};
}

SulfurMaterial sulfur_material_default(void) {
    return toC(Material{});
}

SulfurFilter sulfur_filter_default(void) {
    return toC(Filter{});
}

bool sulfur_may_collide(SulfurFilter a, SulfurFilter b) {
    return mayCollide(fromC(a), fromC(b));
}

// --- as a whole ----------------------------------------------------------------------------------

SulfurResult sulfur_blueprint_create(SulfurBlueprint** blueprint) {
    return make(blueprint, [] { return Blueprint{}; });
}

SulfurResult sulfur_blueprint_copy(const SulfurBlueprint* blueprint, SulfurBlueprint** copy) {
    return make(copy, [&] { return of(blueprint); });
}

void sulfur_blueprint_destroy(SulfurBlueprint* blueprint) {
    delete blueprint;
}

SulfurResult sulfur_blueprint_validate(const SulfurBlueprint* blueprint) {
    return call([&] { of(blueprint).validate(); });
}

SulfurResult sulfur_blueprint_mass(const SulfurBlueprint* blueprint, double* mass) {
    return give(mass, [&] { return of(blueprint).mass(); });
}

SulfurResult sulfur_blueprint_centre_of_mass(const SulfurBlueprint* blueprint, SulfurVec* centre) {
    return give(centre, [&] { return of(blueprint).centreOfMass(); });
}

SulfurResult sulfur_blueprint_name(const SulfurBlueprint* blueprint, const char** name) {
    return give(name, [&]() -> const std::string& { return of(blueprint).name; });
}

SulfurResult sulfur_blueprint_set_name(SulfurBlueprint* blueprint, const char* name) {
    return call([&] { of(blueprint).name = &required(name, "the name"); });
}

SulfurResult sulfur_blueprint_kind(const SulfurBlueprint* blueprint, SulfurBodyKind* kind) {
    return give(kind, [&] { return of(blueprint).kind; });
}

SulfurResult sulfur_blueprint_set_kind(SulfurBlueprint* blueprint, SulfurBodyKind kind) {
    return call([&] { of(blueprint).kind = bodyKind(kind); });
}

SulfurResult sulfur_blueprint_material(const SulfurBlueprint* blueprint, SulfurMaterial* material) {
    return give(material, [&] { return of(blueprint).material; });
}

SulfurResult sulfur_blueprint_set_material(SulfurBlueprint* blueprint, SulfurMaterial material) {
    return call([&] { of(blueprint).material = fromC(material); });
}

SulfurResult sulfur_blueprint_filter(const SulfurBlueprint* blueprint, SulfurFilter* filter) {
    return give(filter, [&] { return of(blueprint).filter; });
}

SulfurResult sulfur_blueprint_set_filter(SulfurBlueprint* blueprint, SulfurFilter filter) {
    return call([&] { of(blueprint).filter = fromC(filter); });
}

SulfurResult sulfur_blueprint_self_collision(const SulfurBlueprint* blueprint, bool* on) {
    return give(on, [&] { return of(blueprint).selfCollision; });
}

SulfurResult sulfur_blueprint_set_self_collision(SulfurBlueprint* blueprint, bool on) {
    return call([&] { of(blueprint).selfCollision = on; });
}

SulfurResult sulfur_blueprint_sensor(const SulfurBlueprint* blueprint, bool* sensor) {
    return give(sensor, [&] { return of(blueprint).sensor; });
}

SulfurResult sulfur_blueprint_set_sensor(SulfurBlueprint* blueprint, bool sensor) {
    return call([&] { of(blueprint).sensor = sensor; });
}

SulfurResult sulfur_blueprint_skin(const SulfurBlueprint* blueprint, SulfurSkin* skin, bool* has) {
    return call([&] {
        SulfurSkin& result = required(skin, "a result");
        bool& isThere = required(has, "has");
        const std::optional<Skin>& worn = of(blueprint).skin;
        if (worn) result = toC(*worn, blueprint->uv);
        isThere = worn.has_value();
    });
}

SulfurResult sulfur_blueprint_set_skin(SulfurBlueprint* blueprint, const SulfurSkin* skin) {
    return call([&] {
        std::optional<Skin> worn;
        if (skin) worn = fromC(*skin);
        of(blueprint).skin = std::move(worn);
    });
}

// --- particles and joints ------------------------------------------------------------------------

SulfurResult sulfur_blueprint_particle_count(const SulfurBlueprint* blueprint, size_t* count) {
    return give(count, [&] { return of(blueprint).particles.size(); });
}

SulfurResult sulfur_blueprint_particle(const SulfurBlueprint* blueprint, size_t index,
                                       SulfurParticleSpec* particle) {
    return give(particle, [&] { return entry(of(blueprint).particles, index, "particle"); });
}

SulfurResult sulfur_blueprint_set_particle(SulfurBlueprint* blueprint, size_t index,
                                           SulfurParticleSpec particle) {
    return call([&] {
        const ParticleSpec spec = fromC(particle);
        entry(of(blueprint).particles, index, "particle") = spec;
    });
}

SulfurResult sulfur_blueprint_add_particle(SulfurBlueprint* blueprint, SulfurParticleSpec particle,
                                           uint32_t* index) {
    return call([&] {
        auto& particles = of(blueprint).particles;
        particles.push_back(fromC(particle));
        if (index) *index = static_cast<std::uint32_t>(particles.size() - 1);
    });
}

SulfurResult sulfur_blueprint_joint_count(const SulfurBlueprint* blueprint, size_t* count) {
    return give(count, [&] { return of(blueprint).joints.size(); });
}

SulfurResult sulfur_blueprint_joint(const SulfurBlueprint* blueprint, size_t index,
                                    SulfurJointSpec* joint) {
    return give(joint, [&] { return entry(of(blueprint).joints, index, "joint"); });
}

SulfurResult sulfur_blueprint_set_joint(SulfurBlueprint* blueprint, size_t index,
                                        SulfurJointSpec joint) {
    return call([&] {
        const JointSpec spec = fromC(joint);
        entry(of(blueprint).joints, index, "joint") = spec;
    });
}

SulfurResult sulfur_blueprint_add_joint(SulfurBlueprint* blueprint, SulfurJointSpec joint,
                                        uint32_t* index) {
    return call([&] {
        auto& joints = of(blueprint).joints;
        joints.push_back(fromC(joint));
        if (index) *index = static_cast<std::uint32_t>(joints.size() - 1);
    });
}

SulfurResult sulfur_blueprint_angle_count(const SulfurBlueprint* blueprint, size_t* count) {
    return give(count, [&] { return of(blueprint).angles.size(); });
}

SulfurResult sulfur_blueprint_angle(const SulfurBlueprint* blueprint, size_t index,
                                    SulfurAngularJointSpec* angle) {
    return give(angle, [&] { return entry(of(blueprint).angles, index, "angular joint"); });
}

SulfurResult sulfur_blueprint_set_angle(SulfurBlueprint* blueprint, size_t index,
                                        SulfurAngularJointSpec angle) {
    return call([&] {
        const AngularJointSpec spec = fromC(angle);
        entry(of(blueprint).angles, index, "angular joint") = spec;
    });
}

SulfurResult sulfur_blueprint_add_angle(SulfurBlueprint* blueprint, SulfurAngularJointSpec angle,
                                        uint32_t* index) {
    return call([&] {
        auto& angles = of(blueprint).angles;
        angles.push_back(fromC(angle));
        if (index) *index = static_cast<std::uint32_t>(angles.size() - 1);
    });
}

}  // extern "C"

}  // namespace sulfur::c
