#include "follow.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace sulfurchamber {
namespace {

using sulfur::Blueprint;
using sulfur::BodyId;
using sulfur::JointId;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::Vec2;
using sulfur::World;

// Whether setters of the world lead from one plan to the other.
bool canBeSet(const World& world, BodyId body, const Blueprint& before, const Blueprint& after) {
    if (before.kind != after.kind || before.particles.size() != after.particles.size() ||
        before.joints.size() != after.joints.size() || before.angles.size() != after.angles.size())
        return false;
    if (world.particles(body).size() != before.particles.size() ||
        world.joints(body).size() != before.joints.size())
        return false;
    for (std::size_t i = 0; i < after.particles.size(); ++i)
        if (before.particles[i].radius != after.particles[i].radius ||
            before.particles[i].position != after.particles[i].position)
            return false;
    for (std::size_t i = 0; i < after.joints.size(); ++i) {
        const auto& a = before.joints[i];
        const auto& b = after.joints[i];
        if (a.a != b.a || a.b != b.b || a.radius != b.radius || a.restLength != b.restLength ||
            a.bend != b.bend)
            return false;
    }
    return std::equal(before.angles.begin(), before.angles.end(), after.angles.begin(),
                      [](const auto& a, const auto& b) {
                          return a.a == b.a && a.b == b.b && a.c == b.c &&
                                 a.stiffness == b.stiffness && a.damping == b.damping &&
                                 a.restAngle == b.restAngle && a.lower == b.lower &&
                                 a.upper == b.upper && a.motorSpeed == b.motorSpeed &&
                                 a.motorMax == b.motorMax && a.motorTarget == b.motorTarget &&
                                 a.strength == b.strength;
                      });
}

void set(World& world, BodyId body, const Blueprint& before, const Blueprint& after) {
    const auto particles = world.particles(body);
    for (std::size_t i = 0; i < after.particles.size(); ++i) {
        const auto& a = before.particles[i];
        const auto& b = after.particles[i];
        if (a.mass != b.mass) world.setMass(particles[i], b.mass);
        if (a.pinned != b.pinned) world.setPinned(particles[i], b.pinned);
    }
    const auto span = world.joints(body);
    const std::vector<JointId> joints(span.begin(), span.end());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const auto& a = before.joints[i];
        const auto& b = after.joints[i];
        if (a.stiffness != b.stiffness) world.setStiffness(joints[i], b.stiffness);
        if (a.damping != b.damping) world.setDamping(joints[i], b.damping);
        if (a.strength != b.strength) world.setStrength(joints[i], b.strength);
        if (a.material != b.material) world.setMaterial(joints[i], b.material);
    }
    if (!(before.material == after.material)) world.setMaterial(body, after.material);
    if (!(before.filter == after.filter)) world.setFilter(body, after.filter);
    if (before.sensor != after.sensor) world.setSensor(body, after.sensor);
    if (before.selfCollision != after.selfCollision)
        world.setSelfCollision(body, after.selfCollision);
}

// A joint to another body, by the place of its end in this one.
struct Tie {
    std::size_t place = 0;
    ParticleId other;
    bool first = false;  // whether the end in this body is the joint's a
    sulfur::ConnectOptions options;
};

std::vector<Tie> tiesOf(const World& world, BodyId body) {
    const auto particles = world.particles(body);
    const auto placeOf = [&](ParticleId particle) {
        return static_cast<std::size_t>(std::find(particles.begin(), particles.end(), particle) -
                                        particles.begin());
    };
    std::vector<Tie> ties;
    for (const JointId joint : world.connections()) {
        const auto info = world.info(joint);
        const bool first = world.info(info.a).body == body;
        if (!first && world.info(info.b).body != body) continue;
        ties.push_back({placeOf(first ? info.a : info.b),
                        first ? info.b : info.a,
                        first,
                        {info.stiffness, info.damping, info.restLength, info.radius, info.strength,
                         std::nullopt}});
    }
    return ties;
}

// Something that is held at a point of a body, by the shares of particles that bear it.
struct Axle {
    ParticleId held;  // null: the one at `place` of this body
    std::size_t place = 0;
    std::uint32_t count = 0;
    std::array<ParticleId, 3> supports = {};  // null ones are those at `places` of this body
    std::array<std::size_t, 3> places = {};
    std::array<double, 3> weights = {};
};

std::vector<Axle> axlesOf(const World& world, BodyId body) {
    const auto particles = world.particles(body);
    std::vector<Axle> axles;
    for (const auto attachment : world.attachments()) {
        const auto info = world.info(attachment);
        bool own = false;
        const auto take = [&](ParticleId particle, ParticleId& end, std::size_t& place) {
            const auto found = std::find(particles.begin(), particles.end(), particle);
            place = static_cast<std::size_t>(found - particles.begin());
            if (found == particles.end())
                end = particle;
            else
                own = true;
        };
        Axle axle;
        axle.count = info.count;
        take(info.particle, axle.held, axle.place);
        for (std::size_t i = 0; i < info.count; ++i) {
            take(info.supports[i], axle.supports[i], axle.places[i]);
            axle.weights[i] = static_cast<double>(info.weights[i]);
        }
        if (own) axles.push_back(axle);
    }
    return axles;
}

// The same with what has taken the body's place; left out where particles are gone.
void holdAgain(World& world, BodyId made, const std::vector<Axle>& axles) {
    const auto particles = world.particles(made);
    for (const Axle& axle : axles) {
        const auto now = [&](ParticleId kept, std::size_t place) {
            return kept ? kept : place < particles.size() ? particles[place] : ParticleId{};
        };
        const ParticleId held = now(axle.held, axle.place);
        Point point(0, 0);
        BodyId bearer;
        bool whole = world.contains(held);
        for (std::size_t i = 0; i < axle.count && whole; ++i) {
            const ParticleId support = now(axle.supports[i], axle.places[i]);
            whole = world.contains(support);
            if (!whole) break;
            point += axle.weights[i] * world.position(support);
            bearer = world.info(support).body;
        }
        if (!whole || !bearer) continue;
        const auto pose = world.pose(bearer);
        const Point local = Eigen::Rotation2Dd(-pose.angle) * (point - pose.position);
        world.attach(held, bearer, local.cast<sulfur::Real>());
    }
}

std::vector<BodyId> passersOf(const World& world, BodyId body) {
    std::vector<BodyId> passers;
    for (const auto& [a, b] : world.vetoes())
        if (a == body || b == body) passers.push_back(a == body ? b : a);
    return passers;
}

BodyId replace(World& world, BodyId body, const Blueprint& after) {
    const auto ties = tiesOf(world, body);
    const auto axles = axlesOf(world, body);
    const auto passers = passersOf(world, body);
    const auto pose = world.pose(body);
    const auto velocity = world.meanVelocity(body);
    const double spin = world.angularVelocity(body);
    const auto key = world.userData(body);
    std::vector<Vec2> velocities;
    for (const ParticleId particle : world.particles(body))
        velocities.push_back(world.velocity(particle));
    const BodyId made = world.add(after, pose).id();
    world.setUserData(made, key);
    world.remove(body);
    const auto particles = world.particles(made);
    if (after.kind == sulfur::BodyKind::dynamic) {
        if (velocities.size() == particles.size())
            for (std::size_t i = 0; i < particles.size(); ++i)
                world.setVelocity(particles[i], velocities[i]);
        else
            world.setVelocity(made, velocity, spin);
    }
    for (const Tie& tie : ties) {
        if (tie.place >= particles.size() || !world.contains(tie.other)) continue;
        const ParticleId own = particles[tie.place];
        world.connect(tie.first ? own : tie.other, tie.first ? tie.other : own, tie.options);
    }
    holdAgain(world, made, axles);
    for (const BodyId passer : passers) world.setCollision(made, passer, false);
    return made;
}

}  // namespace

BodyId follow(World& world, BodyId body, const Blueprint& before, const Blueprint& after) {
    after.validate();
    if (!canBeSet(world, body, before, after)) return replace(world, body, after);
    set(world, body, before, after);
    return body;
}

}  // namespace sulfurchamber
