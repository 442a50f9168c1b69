#include "battery/random/momenta.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace sulfur::lab {

namespace {

using Vec = Eigen::Vector2d;

/// Calls `act` with the ParticleInfo of each of these particles that can move.
template <class Ids, class Act>
void forEachMover(const World& world, const Ids& particles, Act&& act) {
    for (const ParticleId id : particles) {
        const ParticleInfo p = world.info(id);
        if (!p.pinned) act(p);
    }
}

/// What the chords of a rigid body that turns lack.
struct Lack {
    double spin = 0;     // N m s
    double kinetic = 0;  // J
};

Lack lackOf(const World& world, const std::vector<ParticleId>& part) {
    double mass = 0, inertia = 0, across = 0, along = 0, kinetic = 0, rounding = 0;
    Vec momentum = Vec::Zero();
    Point centre(0, 0);
    forEachMover(world, part, [&](const ParticleInfo& p) {
        const double m = static_cast<double>(p.mass);
        mass += m;
        centre += m * p.position;
        momentum += m * p.velocity.cast<double>();
    });
    centre /= mass;
    forEachMover(world, part, [&](const ParticleInfo& p) {
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

/// Particles that turn as one: of triangles of rigid joints that share sides, or of a body that is
/// a single one. What is broken may be several of these.
std::vector<std::vector<ParticleId>> rigidPartsOf(const World& world, BodyId body) {
    std::map<std::pair<ParticleId, ParticleId>, std::size_t> sides;
    for (const JointId id : world.joints(body)) {
        const JointInfo joint = world.info(id);
        if (joint.stiffness == infinite)
            sides.try_emplace(std::minmax(joint.a, joint.b), sides.size());
    }
    std::vector<std::size_t> partOf(sides.size());
    std::iota(partOf.begin(), partOf.end(), 0);
    std::vector<char> braced(sides.size(), world.particles(body).size() == 2);
    const auto unite = [&](std::size_t a, std::size_t b) {
        std::replace(partOf.begin(), partOf.end(), std::size_t{partOf[a]}, std::size_t{partOf[b]});
        braced[a] = braced[b] = 1;
    };
    for (const auto& [side, index] : sides) {
        for (const ParticleId other : world.particles(body)) {
            const auto one = sides.find(std::minmax(side.first, other));
            const auto two = sides.find(std::minmax(side.second, other));
            if (one == sides.end() || two == sides.end()) continue;
            unite(index, one->second);
            unite(index, two->second);
        }
    }
    std::map<std::size_t, std::set<ParticleId>> parts;
    for (const auto& [side, index] : sides)
        if (braced[index]) parts[partOf[index]].insert({side.first, side.second});
    std::vector<std::vector<ParticleId>> all;
    for (const auto& [part, ids] : parts) all.emplace_back(ids.begin(), ids.end());
    return all;
}

}  // namespace

Momentum momentumOf(const World& world) {
    Momentum momentum;
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != BodyKind::dynamic) continue;
        forEachMover(world, world.particles(body), [&](const ParticleInfo& p) {
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
        forEachMover(world, world.particles(body), [&](const ParticleInfo& p) {
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
        for (const auto& part : rigidPartsOf(world, body)) {
            const Lack lack = lackOf(world, part);
            all.angular += lack.spin;
            all.kinetic += lack.kinetic;
            all.energy += lack.kinetic;
        }
    }
    return all;
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
