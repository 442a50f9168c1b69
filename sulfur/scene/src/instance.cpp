#include <sulfur/scene/instance.hpp>

#include "placing.hpp"

namespace sulfur::scene {

namespace {

const Placement& bodyOf(const Scene& scene, const std::string& id) {
    const auto* body = scene.body(id);
    if (body == nullptr) throw ReadError(scene.file, 0, id, "is not the id of a body of the scene");
    return *body;
}

ParticleId particleOf(const Scene& scene, const Instance& instance, const World& world,
                      const ParticleRef& ref) {
    const auto particles = world.particles(instance.body(bodyOf(scene, ref.body).id));
    if (ref.particle < particles.size()) return particles[ref.particle];
    throw ReadError(scene.file, 0, ref.body,
                    "has no particle " + std::to_string(ref.particle) + "; allowed is 0 to " +
                        std::to_string(particles.size() - 1));
}

}  // namespace

void applyState(const Scene& scene, const Placement& placement, World& world, BodyId body) {
    const auto& state = *placement.state;
    const auto particles = world.particles(body);
    if (state.positions.size() != particles.size() || state.velocities.size() != particles.size())
        throw ReadError(scene.file, 0, placement.id,
                        "state has not one position and one velocity for each of the " +
                            std::to_string(particles.size()) + " particles");
    if (state.angle && particles.size() == 1)
        world.setPose(body, {state.positions[0], *state.angle});
    for (std::size_t i = 0; i < particles.size(); ++i)
        world.setPosition(particles[i], state.positions[i]);
    if (world.kind(body) == BodyKind::fixed) return;
    for (std::size_t i = 0; i < particles.size(); ++i)
        world.setVelocity(particles[i], state.velocities[i]);
    if (state.spin != 0 && particles.size() == 1)
        world.setVelocity(body, state.velocities[0], state.spin);
}

BodyId Instance::body(std::string_view id) const {
    const auto found = bodies.find(id);
    return found == bodies.end() ? BodyId{} : found->second;
}

std::string Instance::id(BodyId body) const {
    for (const auto& [id, handle] : bodies)
        if (handle == body) return id;
    return "";
}

Instance instantiate(const Scene& scene, World& world) {
    Instance instance;
    for (const auto& placement : scene.bodies) {
        const BodyId body = world.add(blueprintOf(scene, placement), placement.pose);
        instance.bodies.emplace(placement.id, body);
        if (placement.state) {
            applyState(scene, placement, world, body);
        } else if (placement.velocity != Vec2(0, 0)) {
            world.setVelocity(body, placement.velocity);
        }
    }
    for (const auto& connection : scene.connections)
        instance.connections.push_back(
            world.connect(particleOf(scene, instance, world, connection.a),
                          particleOf(scene, instance, world, connection.b), connection.options));
    for (const auto& attachment : scene.attachments)
        instance.attachments.push_back(
            world.attach(particleOf(scene, instance, world, attachment.particle),
                         instance.body(bodyOf(scene, attachment.body).id), attachment.point));
    for (const auto& veto : scene.vetoes)
        world.setCollision(instance.body(bodyOf(scene, veto.a).id),
                           instance.body(bodyOf(scene, veto.b).id), false);
    for (const auto& field : scene.fields) instance.fields.push_back(world.add(field.field));
    // After the vetoes: what mechanisms keep apart by themselves ends with them.
    try {
        instance.mechanisms = makeMechanisms(scene.mechanisms, instance.bodies, world);
    } catch (const ReadError& e) {
        throw ReadError(scene.file, 0, e.object(), e.message());
    }
    return instance;
}

}  // namespace sulfur::scene
