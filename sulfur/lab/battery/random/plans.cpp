// The plan of each kind of thing.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "battery/random/scene.hpp"

namespace sulfur::lab {

namespace {

Real real(double x) {
    return static_cast<Real>(x);
}
Vec2 vec2(double x, double y) {
    return {real(x), real(y)};
}

/// What all makers get: a thing of the size s.
struct Draft {
    double s, variant;
    Real mass, strength;
    const Thing& thing;

    /// A number from `low` to `high`, as the variant has it.
    int count(int low, int high) const {
        return low + static_cast<int>(std::floor(variant * (high - low) + 0.5));
    }
    /// The stiffness of a spring on which one of `particles` equal particles has the frequency.
    Real stiffness(int particles) const {
        return real(thing.mass / particles * thing.frequency * thing.frequency);
    }
    /// A tenth of critical damping.
    Real damping(int particles) const {
        return real(0.2 * thing.mass / particles * thing.frequency);
    }
};

Blueprint ball(const Draft& d) {
    return shapes::ball({.radius = real(d.s / 2), .mass = d.mass});
}
Blueprint block(const Draft& d, double ratio) {
    return shapes::box({.size = vec2(d.s, d.s * ratio),
                        .mass = d.mass,
                        .radius = real(0.05 * d.s * ratio),
                        .strength = d.strength});
}
Blueprint crate(const Draft& d) {
    return block(d, 0.4 + 0.6 * d.variant);
}
Blueprint plank(const Draft& d) {
    return block(d, 0.08 + 0.2 * d.variant);
}
Blueprint polygon(const Draft& d) {
    const int corners = d.count(3, 9);
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        points.push_back(vec2(d.s / 2 * std::cos(angle), d.s / 2 * std::sin(angle)));
    }
    return shapes::polygon({.points = points, .mass = d.mass, .radius = real(0.03 * d.s)});
}
Blueprint hook(const Draft& d) {
    const double a = d.s / 2.9, t = d.s * (0.15 + 0.15 * d.variant);
    return shapes::polygon({.points = {vec2(-a, -a), vec2(a, -a), vec2(a, -a + t),
                                       vec2(-a + t, -a + t), vec2(-a + t, a), vec2(-a, a)},
                            .mass = d.mass,
                            .radius = real(0.03 * d.s)});
}
Blueprint wheel(const Draft& d) {
    return shapes::wheel({.radius = real(d.s / 2),
                          .segments = d.count(8, 16),
                          .mass = d.mass,
                          .rimRadius = real(0.03 * d.s),
                          .strength = d.strength});
}
Blueprint springWheel(const Draft& d) {
    const int segments = d.count(8, 12);
    return shapes::wheel({.radius = real(d.s / 2),
                          .segments = segments,
                          .mass = d.mass,
                          .rimRadius = real(0.03 * d.s),
                          .spokeStiffness = d.stiffness(segments),
                          .spokeDamping = d.damping(segments)});
}
Blueprint line(const Draft& d, int links, double radius, Real stiffness, Real damping) {
    return shapes::rope({.from = vec2(-d.s / 2, 0),
                         .to = vec2(d.s / 2, 0),
                         .links = links,
                         .mass = d.mass,
                         .radius = real(radius * d.s),
                         .stiffness = stiffness,
                         .damping = damping,
                         .strength = d.strength});
}
Blueprint rod(const Draft& d) {
    return line(d, 1, 0.02 + 0.1 * d.variant, infinite, 0);
}
Blueprint rope(const Draft& d) {
    return line(d, d.count(3, 14), 0.01, infinite, 0);
}
Blueprint elasticRope(const Draft& d) {
    const int links = d.count(3, 14);
    return line(d, links, 0.01, d.stiffness(links + 1), d.damping(links + 1));
}
Blueprint chain(const Draft& d) {
    return shapes::chain({.from = vec2(-d.s / 2, 0),
                          .to = vec2(d.s / 2, 0),
                          .links = d.count(2, 8),
                          .mass = d.mass,
                          .radius = real(0.02 * d.s),
                          .strength = d.strength});
}
Blueprint jelly(const Draft& d) {
    const int columns = d.count(2, 4), rows = 3;
    return shapes::jelly({.size = vec2(d.s * 0.8, d.s * (0.3 + 0.5 * d.variant)),
                          .columns = columns,
                          .rows = rows,
                          .mass = d.mass,
                          .radius = real(0.03 * d.s),
                          .stiffness = d.stiffness(columns * rows),
                          .damping = d.damping(columns * rows),
                          .strength = d.strength});
}
Blueprint blob(const Draft& d) {
    const int segments = d.count(7, 14);
    return shapes::blob({.radius = real(d.s / 2),
                         .segments = segments,
                         .mass = d.mass,
                         .skinRadius = real(0.03 * d.s),
                         .stiffness = d.stiffness(segments),
                         .damping = d.damping(segments)});
}
Blueprint wall(const Draft& d) {
    return shapes::wall({.size = vec2(d.s * 0.9, d.s * 0.45),
                         .columns = d.count(2, 4),
                         .rows = 2,
                         .mass = d.mass,
                         .radius = real(0.015 * d.s),
                         .strength = d.strength});
}
Blueprint cloth(const Draft& d) {
    const int columns = d.count(3, 5), rows = 3;
    return shapes::cloth({.size = vec2(d.s * 0.8, d.s * 0.6),
                          .columns = columns,
                          .rows = rows,
                          .mass = d.mass,
                          .radius = real(0.01 * d.s),
                          .pinCorners = false,
                          .stiffness = d.stiffness(columns * rows),
                          .damping = d.damping(columns * rows),
                          .strength = d.strength});
}

constexpr std::array<Blueprint (*)(const Draft&), kindCount> makers{
    ball, crate,       plank, polygon, hook, wheel, springWheel, rod,
    rope, elasticRope, chain, jelly,   blob, wall,  cloth};

}  // namespace

Blueprint planOf(const Thing& thing) {
    const Draft draft{.s = thing.size,
                      .variant = thing.variant,
                      .mass = real(thing.mass),
                      .strength = thing.strength > 0 ? real(thing.strength * thing.mass) : infinite,
                      .thing = thing};
    Blueprint plan = makers[static_cast<std::size_t>(thing.kind)](draft);
    plan.material = {.staticFriction = real(1.25 * thing.friction),
                     .kineticFriction = real(thing.friction),
                     .restitution = real(thing.restitution)};
    if (thing.role == Role::driven) plan.kind = BodyKind::kinematic;
    plan.sensor = thing.role == Role::sensor;
    // Its origin is its middle, so that a pose turns it about that.
    Vec2 low = plan.particles.front().position, high = low;
    for (const ParticleSpec& p : plan.particles) {
        low = low.cwiseMin(p.position);
        high = high.cwiseMax(p.position);
    }
    for (ParticleSpec& p : plan.particles) p.position -= (low + high) / 2;
    return plan;
}

double reachOf(const Blueprint& plan) {
    double reach = 0, thickest = 0;
    for (const ParticleSpec& p : plan.particles)
        reach = std::max(reach, static_cast<double>(p.position.norm() + p.radius));
    for (const JointSpec& joint : plan.joints)
        thickest = std::max(thickest, static_cast<double>(joint.radius));
    return reach + thickest;
}

}  // namespace sulfur::lab
