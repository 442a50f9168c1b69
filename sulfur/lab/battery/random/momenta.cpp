#include "battery/random/momenta.hpp"

#include <cmath>
#include <vector>

namespace sulfur::lab {

namespace {

using Vec = Eigen::Vector2d;

constexpr int fineRate = 10000;  // Hz, the highest that a world allows

/// Calls `act` with the ParticleInfo of each particle that can move.
template <class Act>
void forEachMover(const World& world, BodyId body, Act&& act) {
    for (const ParticleId id : world.particles(body)) {
        const ParticleInfo p = world.info(id);
        if (!p.pinned) act(p);
    }
}

/// How a rigid body turned in the last tick, beside what the chords of its particles tell.
struct Turn {
    double factor = 1;   // of the spin, over that of the chords
    double kinetic = 0;  // J that the chords lack
    double spin = 0;     // N m s about its centre, of the chords
};

Turn turnOf(const World& world, BodyId body) {
    double mass = 0, inertia = 0, spin = 0, sine = 0, cosine = 0, kinetic = 0;
    Vec momentum = Vec::Zero();
    Point centre(0, 0);
    forEachMover(world, body, [&](const ParticleInfo& p) {
        const double m = static_cast<double>(p.mass);
        mass += m;
        centre += m * p.position;
        momentum += m * p.velocity.cast<double>();
    });
    centre /= mass;
    const double h = 1.0 / world.settings().tickRate;
    forEachMover(world, body, [&](const ParticleInfo& p) {
        const double m = static_cast<double>(p.mass);
        const Vec r = p.position - centre;
        const Vec v = p.velocity.cast<double>() - momentum / mass;
        const Vec before = r - h * v;
        inertia += m * r.squaredNorm();
        spin += m * cross(r, v);
        kinetic += m / 2 * v.squaredNorm();
        sine += m * cross(before, r);
        cosine += m * before.dot(r);
    });
    const double omega = std::atan2(sine, cosine) / h;
    Turn turn;
    turn.spin = spin;
    turn.factor = spin == 0 ? 1 : inertia * omega / spin;
    turn.kinetic = inertia * omega * omega / 2 - kinetic;
    return turn;
}

double elasticOf(const World& world, const JointId id, double h) {
    const JointInfo j = world.info(id);
    if (j.stiffness == infinite) return 0;
    // At the time of the velocities, as World::energy.
    const auto at = [&](ParticleId p) {
        return Point(world.position(p) - h / 2 * world.velocity(p).cast<double>());
    };
    const double stretch = (at(j.b) - at(j.a)).norm() - static_cast<double>(j.restLength);
    return static_cast<double>(j.stiffness) / 2 * stretch * stretch;
}

Momenta measure(const World& world, const Point& about, bool chords) {
    Momenta all;
    all.linear = momentumOf(world);
    const Vec gravity = world.gravity().cast<double>();
    const double h = chords ? 1.0 / world.settings().tickRate : 0;
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != BodyKind::dynamic) continue;
        forEachMover(world, body, [&](const ParticleInfo& p) {
            const double m = static_cast<double>(p.mass);
            const Vec v = p.velocity.cast<double>(), r = p.position - about;
            all.angular += m * cross(r, v);
            all.angularScale += m * r.norm() * v.norm();
            all.kinetic += m / 2 * v.squaredNorm();
            all.gravitational -= m * gravity.dot(p.position - h / 2 * v);
        });
        for (const JointId joint : world.joints(body)) all.elastic += elasticOf(world, joint, h);
        if (!chords || !isRigid(world, body)) continue;
        const Turn turn = turnOf(world, body);
        all.angular += (turn.factor - 1) * turn.spin;
        all.kinetic += turn.kinetic;
    }
    for (const JointId joint : world.connections()) all.elastic += elasticOf(world, joint, h);
    all.energy = all.kinetic + all.elastic + all.gravitational;
    return all;
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

Momenta momentaAsTold(const World& world, const Point& about) {
    return measure(world, about, false);
}

Momenta momentaOf(const World& world, const Point& about) {
    World copy;
    copy.restore(world.snapshot());
    copy.setTickRate(fineRate);
    copy.step();
    return measure(copy, about, true);
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
