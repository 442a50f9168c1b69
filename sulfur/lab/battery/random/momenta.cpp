#include "battery/random/momenta.hpp"

#include <cmath>

namespace sulfur::lab {

namespace {

using Vec = Eigen::Vector2d;

/// Calls `act` with the ParticleInfo of each particle that can move.
template <class Act>
void forEachMover(const World& world, BodyId body, Act&& act) {
    for (const ParticleId id : world.particles(body)) {
        const ParticleInfo p = world.info(id);
        if (!p.pinned) act(p);
    }
}

/// What the chords of a rigid body that turns lack.
struct Lack {
    double spin = 0;     // N m s
    double kinetic = 0;  // J
};

Lack lackOf(const World& world, BodyId body) {
    double mass = 0, inertia = 0, across = 0, along = 0, kinetic = 0, rounding = 0;
    Vec momentum = Vec::Zero();
    Point centre(0, 0);
    forEachMover(world, body, [&](const ParticleInfo& p) {
        const double m = static_cast<double>(p.mass);
        mass += m;
        centre += m * p.position;
        momentum += m * p.velocity.cast<double>();
    });
    centre /= mass;
    forEachMover(world, body, [&](const ParticleInfo& p) {
        const double m = static_cast<double>(p.mass);
        const Vec r = p.position - centre;
        const Vec v = p.velocity.cast<double>() - momentum / mass;
        inertia += m * r.squaredNorm();
        across += m * cross(r, v);
        along += m * r.dot(v);
        rounding += 1e-6 * m * r.norm() * static_cast<double>(p.velocity.norm());
        kinetic += m / 2 * v.squaredNorm();
    });
    if (along <= rounding || across == 0) return {};
    const double angle = 2 * std::atan2(along, std::abs(across));
    const double spin = across * angle / std::sin(angle);
    return {.spin = spin - across, .kinetic = spin * spin / inertia / 2 - kinetic};
}

}  // namespace

Momentum momentumOf(const World& world) {
    Momentum momentum;
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != BodyKind::dynamic) continue;
        forEachMover(world, body, [&](const ParticleInfo& p) {
            const Vec mv = static_cast<double>(p.mass) * p.velocity.cast<double>();
            momentum.sum += mv;
            momentum.scale += mv.norm();
        });
    }
    return momentum;
}

Momenta momentaOf(const World& world, const Point& about) {
    Momenta all;
    all.linear = momentumOf(world);
    all.energy = world.energy();
    const Vec gravity = world.gravity().cast<double>();
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != BodyKind::dynamic) continue;
        forEachMover(world, body, [&](const ParticleInfo& p) {
            const double m = static_cast<double>(p.mass);
            const Vec v = p.velocity.cast<double>(), r = p.position - about;
            all.angular += m * cross(r, v);
            all.angularScale += m * r.norm() * v.norm();
            all.kinetic += m / 2 * v.squaredNorm();
            const double radius = static_cast<double>(p.radius), inertia = m * radius * radius / 2;
            all.angular += inertia * p.spin;
            all.angularScale += inertia * std::abs(p.spin);
            all.kinetic += inertia * p.spin * p.spin / 2;
            all.gravitational -= m * gravity.dot(p.position);
        });
        if (!isRigid(world, body)) continue;
        const Lack lack = lackOf(world, body);
        all.angular += lack.spin;
        all.kinetic += lack.kinetic;
        all.energy += lack.kinetic;
    }
    return all;
}

bool isRigid(const World& world, BodyId body) {
    // Boxes, polygons and wheels are braced, 2 n - 3 rigid joints or more; a rod has one.
    std::size_t rigid = 0;
    for (const JointId joint : world.joints(body))
        if (world.info(joint).stiffness == infinite) ++rigid;
    const std::size_t count = world.particles(body).size();
    return count >= 2 && rigid >= 2 * count - 3;
}

Point centreOf(const World& world) {
    Point sum(0, 0);
    double mass = 0;
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != BodyKind::dynamic) continue;
        const double m = static_cast<double>(world.mass(body));
        sum += m * world.centreOfMass(body);
        mass += m;
    }
    return mass > 0 ? Point(sum / mass) : sum;
}

}  // namespace sulfur::lab
