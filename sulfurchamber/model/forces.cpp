#include "forces.hpp"

#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::BodyKind;
using sulfur::JointId;
using sulfur::MechanismKind;
using sulfur::Point;
using sulfur::World;

constexpr double earthGravity = 9.81;  // m/s^2

bool isMoving(const World& world, BodyId body) {
    return world.contains(body) && world.kind(body) == BodyKind::dynamic;
}

void addJoint(const World& world, JointId joint, std::vector<ForceArrow>& arrows) {
    const auto info = world.info(joint);
    const Point a = world.position(info.a), b = world.position(info.b);
    const double length = (b - a).norm();
    if (info.force == 0 || !(length > 0)) return;
    const Point pull = static_cast<double>(info.force) / length * (b - a);
    if (!world.info(info.a).pinned) arrows.push_back({a, pull, ForceKind::joint});
    if (!world.info(info.b).pinned) arrows.push_back({b, -pull, ForceKind::joint});
}

void addMechanisms(const World& world, std::vector<ForceArrow>& arrows) {
    for (const auto mechanism : world.mechanisms()) {
        const auto info = world.info(mechanism);
        if (info.kind == MechanismKind::gear) continue;
        Point force = info.holding.cast<double>();
        const double along = static_cast<double>(info.force);
        const Point way = info.pointB - info.pointA;
        if (info.kind == MechanismKind::slider) force += along * info.axis.cast<double>();
        if (info.kind == MechanismKind::distance && way.norm() > 0)
            force += along / way.norm() * way;
        if (!(force.norm() > 0)) continue;
        if (isMoving(world, info.b)) arrows.push_back({info.pointB, force, ForceKind::joint});
        if (isMoving(world, info.a)) arrows.push_back({info.pointA, -force, ForceKind::joint});
    }
}

}  // namespace

std::vector<ForceArrow> gravityForces(const World& world) {
    std::vector<ForceArrow> arrows;
    const Point g = world.gravity().cast<double>();
    for (const BodyId body : world.bodies()) {
        if (!isMoving(world, body)) continue;
        const double weight =
            static_cast<double>(world.mass(body)) * static_cast<double>(world.gravityScale(body));
        arrows.push_back({world.centreOfMass(body), weight * g, ForceKind::gravity});
    }
    return arrows;
}

std::vector<ForceArrow> contactForces(const World& world) {
    std::vector<ForceArrow> arrows;
    const double tick = static_cast<double>(world.tickDuration());
    for (const auto& contact : world.contacts()) {
        const Point normal = contact.normal.cast<double>();
        const Point push =
            (static_cast<double>(contact.impulse) * normal +
             static_cast<double>(contact.friction) * Point(-normal.y(), normal.x())) /
            tick;
        if (!(push.norm() > 0)) continue;
        if (isMoving(world, contact.a)) arrows.push_back({contact.point, push, ForceKind::contact});
        if (isMoving(world, contact.b))
            arrows.push_back({contact.point, -push, ForceKind::contact});
    }
    return arrows;
}

std::vector<ForceArrow> jointForces(const World& world) {
    std::vector<ForceArrow> arrows;
    for (const BodyId body : world.bodies()) {
        if (!isMoving(world, body)) continue;
        const auto joints = world.joints(body);
        // A rope has fewer joints than particles, a solid one more.
        const bool open = joints.size() < world.particles(body).size();
        for (const JointId joint : joints)
            if (open || std::isfinite(world.info(joint).stiffness)) addJoint(world, joint, arrows);
    }
    for (const JointId joint : world.connections()) addJoint(world, joint, arrows);
    addMechanisms(world, arrows);
    if (arrows.size() <= mostJointArrows) return arrows;
    std::nth_element(arrows.begin(), arrows.begin() + mostJointArrows, arrows.end(),
                     [](const ForceArrow& a, const ForceArrow& b) {
                         return a.force.squaredNorm() > b.force.squaredNorm();
                     });
    arrows.resize(mostJointArrows);
    return arrows;
}

double typicalForce(const World& world) {
    double heaviest = 0;
    for (const BodyId body : world.bodies())
        if (isMoving(world, body))
            heaviest = std::max(heaviest, static_cast<double>(world.mass(body)));
    return heaviest > 0 ? earthGravity * heaviest : 1;
}

}  // namespace sulfurchamber
