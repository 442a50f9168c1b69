// Ready-made blueprints that are lines of links: ground, floor, rope, chain, bridge.
#include <algorithm>
#include <cmath>
#include <sulfur/shapes.hpp>

#include "core/error_checks.hpp"
#include "parts.hpp"

namespace sulfur::shapes {

using detail::requireFinite;
using detail::requirePositive;
using detail::requireRange;

Blueprint ground(const GroundOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    if (options.points.size() < 2)
        throw Error(ErrorCode::degenerate, "ground has " + std::to_string(options.points.size()) +
                                               " points; needed are at least two");
    Blueprint plan;
    plan.name = "ground";
    plan.kind = BodyKind::fixed;
    plan.material = options.material;
    for (const auto& point : options.points) plan.particles.push_back({.position = point});
    const auto count = static_cast<std::uint32_t>(options.points.size());
    const auto last = options.closed && count > 2 ? count : count - 1;
    for (std::uint32_t i = 0; i < last; ++i)
        plan.joints.push_back({.a = i, .b = (i + 1) % count, .radius = options.radius});
    plan.validate();
    return plan;
}

Blueprint floor(Vec2 from, Vec2 to, Real radius) {
    Blueprint plan = ground({.points = {from, to}, .radius = radius});
    plan.name = "floor";
    return plan;
}

Blueprint rope(const RopeOptions& options) {
    requireFinite(options.from, "from");
    requireFinite(options.to, "to");
    requirePositive(static_cast<double>(options.mass), "mass");
    const Vec2 span = options.to - options.from;
    const double length = static_cast<double>(span.norm());
    requireRange(length, 1e-6, 1e6, "length");
    const int links = options.links != 0
                          ? options.links
                          : std::clamp(static_cast<int>(std::lround(length / 0.05)), 1, 100000);
    requireRange(links, 1, 100000, "links");
    Blueprint plan;
    plan.name = "rope";
    plan.material = options.material;
    const Real mass = options.mass / static_cast<Real>(links + 1);
    for (int i = 0; i <= links; ++i) {
        const Real way = static_cast<Real>(i) / static_cast<Real>(links);
        const bool pinned = (i == 0 && options.pinFirst) || (i == links && options.pinLast);
        plan.particles.push_back(
            {.position = options.from + way * span, .mass = mass, .pinned = pinned});
    }
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(links); ++i) {
        plan.joints.push_back({.a = i,
                               .b = i + 1,
                               .stiffness = options.stiffness,
                               .damping = options.damping,
                               .restLength = static_cast<Real>(length / links),
                               .radius = options.radius,
                               .strength = options.strength});
    }
    plan.validate();
    return plan;
}

Blueprint chain(const ChainOptions& options) {
    requireFinite(options.from, "from");
    requireFinite(options.to, "to");
    const double length = static_cast<double>((options.to - options.from).norm());
    const int usual = std::clamp(static_cast<int>(std::lround(length / 0.12)), 1, 100000);
    Blueprint plan = rope({.from = options.from,
                           .to = options.to,
                           .links = options.links != 0 ? options.links : usual,
                           .mass = options.mass,
                           .radius = options.radius,
                           .strength = options.strength,
                           .pinFirst = options.pinFirst,
                           .pinLast = options.pinLast,
                           .material = options.material});
    plan.name = "chain";
    return plan;
}

Blueprint bridge(const BridgeOptions& options) {
    requireFinite(options.from, "from");
    requireFinite(options.to, "to");
    requirePositive(static_cast<double>(options.mass), "mass");
    requirePositive(static_cast<double>(options.radius), "radius");
    requireRange(options.planks, 1, 10000, "planks");
    requireRange(static_cast<double>(options.sag), 0, 1e6, "sag");
    const Vec2 span = options.to - options.from;
    requireRange(static_cast<double>(span.norm()), 1e-6, 1e6, "length");
    Blueprint plan;
    plan.name = "bridge";
    plan.material = options.material;
    const auto planks = static_cast<std::uint32_t>(options.planks);
    const Real plank = options.mass / static_cast<Real>(planks);
    for (std::uint32_t i = 0; i <= planks; ++i) {
        const bool end = i == 0 || i == planks;
        const Real way = static_cast<Real>(i) / static_cast<Real>(planks);
        const Vec2 down(0, -4 * options.sag * way * (1 - way));
        plan.particles.push_back({.position = options.from + way * span + down,
                                  .mass = end ? plank / 2 : plank,
                                  .pinned = end});
    }
    const detail::Bracing bracing{options.stiffness, options.damping, options.strength};
    for (std::uint32_t i = 0; i < planks; ++i)
        detail::join(plan, i, i + 1, options.radius, bracing);
    plan.validate();
    return plan;
}

}  // namespace sulfur::shapes
