#include "battery/random/staged.hpp"

#include <algorithm>
#include <cmath>

namespace sulfur::lab {

namespace {

using Vec = Eigen::Vector2d;

WorldSettings settingsOf(const Scene& scene, bool sleeping) {
    return {.gravity = {0, static_cast<Real>(-scene.gravity)},
            .airFriction = static_cast<Real>(scene.airFriction),
            .tickRate = scene.rate,
            .sleeping = sleeping};
}

Vec turned(const Vec& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

}  // namespace

Staged::Staged(const Scene& scene, bool sleeping)
    : world(settingsOf(scene, sleeping)), scene_(scene) {
    if (scene.room > 0) addRoom(scene.room);
    for (const Thing& thing : scene.things) add(thing);
    for (const Tie& t : scene.ties) {
        try {
            tie(t);
        } catch (const Error&) {
            // Two drivers cannot be joined, and a point far from a small thing is out of range.
        }
    }
    for (const Influence& influence : scene.influences) add(influence);
}

void Staged::addRoom(double half) {
    const auto h = static_cast<Real>(half);
    Blueprint plan = shapes::ground(
        {.points = {{-h, -h}, {h, -h}, {h, h}, {-h, h}}, .closed = true, .radius = h / 50});
    if (!scene_.contacts) plan.filter.mask = 0;
    world.add(plan);
}

void Staged::add(const Thing& thing) {
    Blueprint plan = planOf(thing);
    if (!scene_.contacts) plan.filter.mask = 0;
    bodies_.push_back(world.add(plan, {.position = thing.place, .angle = thing.angle}));
}

ParticleId Staged::particleAt(std::size_t thing, double along) {
    const Body& body = bodies_[thing];
    const auto i = static_cast<std::size_t>(along * static_cast<double>(body.size()));
    return body[std::min(i, body.size() - 1)];
}

void Staged::tie(const Tie& tie) {
    const ParticleId a = particleAt(tie.a, tie.alongA);
    if (tie.kind == Tie::Kind::grab) {
        const Vec target = world.position(a) + Vec(0, scene_.things[tie.a].size);
        world.grab(a, target);
        return;
    }
    const ParticleId b = particleAt(tie.b, tie.alongB);
    if (tie.kind == Tie::Kind::attachment) {
        const Thing& holder = scene_.things[tie.b];
        const Vec local = turned(world.position(a) - holder.place, -holder.angle);
        keepIfWhole(world.attach(a, bodies_[tie.b], local.cast<Real>()));
        return;
    }
    ConnectOptions options;
    if (tie.kind == Tie::Kind::spring) {
        const Real mass = std::min(world.info(a).mass, world.info(b).mass);
        options.stiffness = mass * static_cast<Real>(tie.frequency * tie.frequency);
        options.damping = mass * static_cast<Real>(0.1 * tie.frequency);
    }
    world.connect(a, b, options);
}

/// A disc has no orientation and cannot hold what is beside it: such an attachment would pull.
void Staged::keepIfWhole(AttachmentId id) {
    const AttachmentInfo info = world.info(id);
    Point held(0, 0);
    for (std::size_t i = 0; i < info.count; ++i)
        held += static_cast<double>(info.weights[i]) * world.position(info.supports[i]);
    const Point place = world.position(info.particle);
    const double reach = (place - world.position(info.supports[0])).norm();
    if ((held - place).norm() > 1e-5 * reach) world.remove(id);
}

void Staged::add(const Influence& influence) {
    const Vec way = turned({influence.strength, 0}, influence.angle);
    if (influence.kind == Influence::Kind::uniform)
        world.add(UniformField{.acceleration = way.cast<Real>()});
    else if (influence.kind == Influence::Kind::radial)
        world.add(RadialField{.strength = static_cast<Real>(influence.strength), .falloff = 1});
    else
        world.add(WindField{.velocity = way.cast<Real>()});
}

std::vector<bool> Staged::whoGoes() const {
    std::vector<bool> goes;
    for (const Thing& thing : scene_.things)
        goes.push_back(!thing.velocity.isZero() || thing.spin != 0);
    for (bool more = true; more;) {
        more = false;
        for (const Tie& tie : scene_.ties) {
            if (tie.kind == Tie::Kind::grab || goes[tie.a] == goes[tie.b]) continue;
            goes[tie.a] = goes[tie.b] = more = true;
        }
    }
    return goes;
}

void Staged::launch() {
    const auto asleep = [&] {
        const auto all = movers();
        return std::all_of(all.begin(), all.end(), [&](BodyId id) { return world.asleep(id); });
    };
    for (long i = std::lround(scene_.calm * scene_.rate); i > 0 && !asleep(); --i) world.step();
    const std::vector<bool> goes = whoGoes();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Thing& thing = scene_.things[i];
        if (thing.role == Role::driven || !goes[i]) continue;
        const Point centre = world.centreOfMass(bodies_[i]);
        for (const ParticleId id : bodies_[i].particles()) {
            const Vec r = world.position(id) - centre;
            const Vec v = thing.velocity + thing.spin * Vec(-r.y(), r.x());
            world.setVelocity(id, v.cast<Real>());
        }
    }
}

void Staged::drive(World& which) {
    const double time = static_cast<double>(driven_) / scene_.rate;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Thing& t = scene_.things[i];
        if (t.role == Role::driven)
            which.moveTo(bodies_[i].id(), {.position = t.place + time * t.velocity,
                                           .angle = t.angle + time * t.spin});
    }
}

void Staged::step(World* twin) {
    ++driven_;
    drive(world);
    world.step();
    if (!twin) return;
    drive(*twin);
    twin->step();
}

std::vector<BodyId> Staged::movers() const {
    std::vector<BodyId> found;
    for (const BodyId id : world.bodies())
        if (world.kind(id) == BodyKind::dynamic) found.push_back(id);
    return found;
}

double Staged::behindWalls() const {
    double most = 0;
    const auto look = [&](ParticleId id) {
        most = std::max(most, world.position(id).cwiseAbs().maxCoeff() - scene_.room);
    };
    for (const BodyId body : movers()) {
        if (world.sensor(body)) continue;
        for (const ParticleId id : world.particles(body))
            if (world.info(id).radius > 0) look(id);
        for (const JointId id : world.joints(body)) {
            const JointInfo joint = world.info(id);
            if (joint.radius <= 0) continue;
            look(joint.a);
            look(joint.b);
        }
    }
    return most;
}

double Staged::fastest() const {
    double most = 0;
    for (const BodyId body : movers())
        most = std::max(most, static_cast<double>(world.meanVelocity(body).norm()));
    return most;
}

bool Staged::finite() const {
    const auto isFinite = [&](ParticleId id) {
        return world.position(id).allFinite() && world.velocity(id).allFinite();
    };
    for (const BodyId body : world.bodies()) {
        const auto particles = world.particles(body);
        if (!std::all_of(particles.begin(), particles.end(), isFinite)) return false;
    }
    return true;
}

}  // namespace sulfur::lab
