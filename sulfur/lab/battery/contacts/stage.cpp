#include "battery/contacts/stage.hpp"

#include <algorithm>
#include <cmath>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"
#include "svg_scene.hpp"

namespace sulfur::lab {

Blueprint crate(const CrateOptions& options) {
    return shapes::box({.size = vec2(options.size, options.size),
                        .mass = real(options.mass),
                        .radius = real(options.radius),
                        .material = options.material});
}

Blueprint firmJelly(double size, double mass, double stiffness, double damping) {
    return shapes::jelly({.size = vec2(size, size),
                          .mass = real(mass),
                          .stiffness = real(stiffness),
                          .damping = real(damping)});
}

Body addFloor(World& world, double reach, const Material& material) {
    constexpr double radius = 0.05;
    return world.add(shapes::ground({.points = {vec2(-reach, -radius), vec2(reach, -radius)},
                                     .radius = real(radius),
                                     .material = material}));
}

SpeedMeter::SpeedMeter(const World& world, const std::vector<Body>& bodies)
    : world_(world), bodies_(bodies) {
    add();
}

double SpeedMeter::add() {
    const bool first = before_.empty();
    double fastest = 0;
    std::size_t n = 0;
    for (const Body& body : bodies_) {
        for (const ParticleId id : body.particles()) {
            const Point now = world_.position(id);
            if (n == before_.size()) before_.push_back(now);
            fastest = worst(fastest, (now - before_[n]).norm());
            before_[n++] = now;
        }
    }
    return first ? 0 : fastest * world_.settings().tickRate;
}

Places::Places(const World& world, const std::vector<Body>& bodies)
    : world_(world), bodies_(bodies) {
    for (const Body& body : bodies) start_.push_back(world.centreOfMass(body));
}

Point Places::way(std::size_t i) const {
    return world_.centreOfMass(bodies_[i]) - start_[i];
}

double Places::sideways() const {
    double most = 0;
    for (std::size_t i = 0; i < start_.size(); ++i) most = worst(most, std::abs(way(i).x()));
    return most;
}

double Places::sunk() const {
    double most = 0;
    for (std::size_t i = 0; i < start_.size(); ++i) most = worst(most, -way(i).y());
    return most;
}

double Places::farthest() const {
    double most = 0;
    for (std::size_t i = 0; i < start_.size(); ++i) most = worst(most, way(i).norm());
    return most;
}

int Places::moved(double reach) const {
    int count = 0;
    // Not a number is not at its place either.
    for (std::size_t i = 0; i < start_.size(); ++i) count += way(i).norm() <= reach ? 0 : 1;
    return count;
}

void keepPicture(const Setup& setup, const std::string& name, const World& world) {
    if (setup.album != nullptr) setup.album->add(name, world);
}

}  // namespace sulfur::lab
