#include <array>
#include <cmath>
#include <quaoar/hero.hpp>

namespace quaoar {
namespace {

using sulfur::Real;
using sulfur::Vec2;

/// Corners of a regular polygon by repeated rotation. The one sine and cosine go through a fixed
/// series, because the library's may differ in the last bit from machine to machine, and the
/// hero's rest shape decides every replay.
std::vector<Vec2> regularPolygon(int corners, double radius) {
    const double angle = 2 * 3.14159265358979323846 / corners;
    double cosine = 0, sine = 0, term = 1;
    for (int n = 0; n < 24; ++n) {
        const double sign = n % 4 < 2 ? 1 : -1;
        (n % 2 == 0 ? cosine : sine) += sign * term;
        term *= angle / (n + 1);
    }
    std::vector<Vec2> points;
    double x = radius, y = 0;
    for (int i = 0; i < corners; ++i) {
        points.emplace_back(static_cast<Real>(x), static_cast<Real>(y));
        const double turned = x * cosine - y * sine;
        y = x * sine + y * cosine;
        x = turned;
    }
    return points;
}

sulfur::JointSpec spring(const HeroRules& rules, std::uint32_t a, std::uint32_t b, Real radius) {
    sulfur::JointSpec joint;
    joint.a = a;
    joint.b = b;
    joint.stiffness = rules.stiffness;
    joint.damping = rules.damping;
    joint.radius = radius;
    return joint;
}

/// The texture over the whole body: a fan around the middle, as wide as the outline's centre line.
sulfur::Skin heroSkin(const std::vector<Vec2>& outline, Real radius) {
    sulfur::Skin skin;
    skin.texture = "hero.svg";
    skin.uv.emplace_back(Real(0.5), Real(0.5));
    for (const Vec2& p : outline) {
        skin.uv.emplace_back(Real(0.5) + p.x() / (2 * radius), Real(0.5) - p.y() / (2 * radius));
    }
    const auto count = static_cast<std::uint32_t>(outline.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        skin.triangles.push_back({0u, 1 + i, 1 + (i + 1) % count});
    }
    return skin;
}

}  // namespace

sulfur::Blueprint heroBlueprint(const HeroRules& rules) {
    sulfur::Blueprint hero;
    hero.name = "hero";
    hero.material = {.staticFriction = Real(0.7), .kineticFriction = Real(0.55), .restitution = 0};
    hero.filter.category = Category::hero;
    hero.filter.mask = ~Category::rope;

    const Real radius = rules.radius - rules.skinRadius;
    const std::vector<Vec2> outline = regularPolygon(rules.segments, static_cast<double>(radius));
    const Real share = (rules.mass - rules.coreMass) / static_cast<Real>(rules.segments);
    hero.particles.push_back(
        {.position = {0, 0}, .mass = rules.coreMass, .radius = rules.coreRadius});
    for (const Vec2& p : outline) hero.particles.push_back({.position = p, .mass = share});

    const auto count = static_cast<std::uint32_t>(rules.segments);
    for (std::uint32_t i = 0; i < count; ++i) {
        hero.joints.push_back(spring(rules, 1 + i, 1 + (i + 1) % count, rules.skinRadius));
        hero.joints.push_back(spring(rules, 0, 1 + i, 0));
        hero.joints.back().stiffness = rules.spokeStiffness;
        hero.joints.push_back(spring(rules, 1 + i, 1 + (i + 2) % count, 0));
    }
    hero.skin = heroSkin(outline, radius);
    return hero;
}

}  // namespace quaoar
