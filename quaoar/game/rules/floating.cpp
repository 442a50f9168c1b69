// Liquid zones: what bodies float by.
//
// Each particle stands for its share of its body's volume, by mass: the shapes of the library place
// masses so that they have the solid's moment of inertia, and so the couple that rights a floating
// body is the solid's too, to first order. Liquid that is displaced weighs, and has to be moved:
// both forces go with the displaced mass.
#include <algorithm>
#include <cmath>
#include <map>
#include <quaoar/hero.hpp>
#include <quaoar/zones.hpp>
#include <string>

namespace quaoar {

using sulfur::BodyId;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

namespace {

/// m^2 of its capsules and discs, as if none met.
double surfaceArea(const sulfur::World& world, BodyId body) {
    double area = 0;
    for (const ParticleId particle : world.particles(body)) {
        const double radius = static_cast<double>(world.info(particle).radius);
        area += 3.14159265358979 * radius * radius;
    }
    for (const sulfur::JointId joint : world.joints(body)) {
        const sulfur::JointInfo info = world.info(joint);
        area += 2 * static_cast<double>(info.radius) * static_cast<double>(info.restLength);
    }
    return area;
}

/// m^2 that a body encloses, by asking the library at many places, with nothing else around. What
/// is open or thin has but that of its capsules.
double enclosedArea(const sulfur::Blueprint& blueprint) {
    constexpr int places = 24;
    sulfur::World world;
    const BodyId body = world.add(blueprint).id();
    const sulfur::Bounds bounds = world.bounds(body);
    const Point size = bounds.high - bounds.low;
    int inside = 0;
    for (int i = 0; i < places * places; ++i) {
        const Point part((i % places + 0.5) / places, (i / places + 0.5) / places);
        inside += world.bodiesAt(bounds.low + size.cwiseProduct(part)).empty() ? 0 : 1;
    }
    const double area = size.x() * size.y() * inside / (places * places);
    return std::max(area, surfaceArea(world, body));
}

}  // namespace

void Zones::findFloats(const Attempt& attempt, Plan& plan) {
    const Level& level = attempt.level;
    const bool any = std::any_of(level.zones.begin(), level.zones.end(),
                                 [](const Zone& zone) { return zone.liquid.has_value(); });
    if (!any) return;
    const auto made = [&](double area, BodyId body) {
        const double count = static_cast<double>(attempt.world.particles(body).size());
        const double depth = std::max(0.01, std::sqrt(area / count) / 2);
        return Float{static_cast<Real>(area) / attempt.world.mass(body), static_cast<Real>(depth)};
    };
    std::map<std::string, Float> known;  // by blueprint
    for (const sulfur::scene::Placement& placement : level.scene.bodies) {
        const BodyId body = attempt.instance.body(placement.id);
        plan.floats.emplace_back();
        const bool fixed = attempt.world.kind(body) == sulfur::BodyKind::fixed;
        if (fixed && !level.surface(placement.id).crumbles) continue;
        const auto [found, isNew] = known.try_emplace(placement.blueprint);
        if (isNew) {
            found->second =
                made(enclosedArea(sulfur::scene::blueprintOf(level.scene, placement)), body);
        }
        plan.floats.back() = found->second;
    }
    const double radius = static_cast<double>(attempt.heroRadius);
    plan.hero = made(3.14159265358979 * radius * radius, attempt.hero);
    plan.rope = {Real(0.01), Real(0.02)};
}

Zones::Float Zones::floatOf(const Attempt& attempt, BodyId body) const {
    if (body == attempt.hero) return plan_->hero;
    if (const auto origin = attempt.origin(body)) return plan_->floats[*origin];
    return plan_->rope;
}

void Zones::pushUp(const Attempt& attempt, std::size_t place) const {
    sulfur::World& world = attempt.world;
    const Zone& zone = attempt.level.zones[place];
    const Vec2 gravity = zone.gravity ? *zone.gravity : world.gravity();
    const Real density = zone.liquid->density * strength(place);
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != sulfur::BodyKind::dynamic || world.asleep(body)) continue;
        const Float floats = floatOf(attempt, body);
        if (floats.volume <= 0) continue;
        const double depth = static_cast<double>(floats.depth);
        for (const ParticleId particle : world.particles(body)) {
            const Point at = world.position(particle);
            if (at.x() < zone.low.x() || at.x() > zone.high.x() || at.y() < zone.low.y()) continue;
            const double under = (zone.high.y() - at.y()) / (2 * depth) + 0.5;
            if (under <= 0) continue;
            const Real displaced = density * floats.volume * world.info(particle).mass *
                                   static_cast<Real>(std::min(under, 1.0));
            const Vec2 velocity = world.velocity(particle);
            world.applyForce(particle, displaced * (-gravity - zone.liquid->drag * velocity));
        }
    }
}

}  // namespace quaoar
