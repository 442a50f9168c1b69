#include "follow.hpp"

#include <algorithm>

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
        if (a.a != b.a || a.b != b.b || a.radius != b.radius || a.restLength != b.restLength)
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

BodyId replace(World& world, BodyId body, const Blueprint& after) {
    const auto ties = tiesOf(world, body);
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
