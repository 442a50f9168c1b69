// Ready-made blueprints that are lines of links: ground, floor, rope, chain, bridge.
#include <algorithm>
#include <cmath>
#include <sulfur/shapes.hpp>

#include "core/error_checks.hpp"
#include "core/settings.hpp"
#include "core/trigonometry.hpp"
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
    if (!options.bends.empty() && options.bends.size() != last)
        throw Error(ErrorCode::outOfRange,
                    "ground has " + std::to_string(options.bends.size()) +
                        " bends; allowed is none, or one for each of its " + std::to_string(last) +
                        " capsules");
    for (std::uint32_t i = 0; i < last; ++i)
        plan.joints.push_back({.a = i,
                               .b = (i + 1) % count,
                               .radius = options.radius,
                               .bend = options.bends.empty() ? 0 : options.bends[i]});
    plan.validate();
    return plan;
}

Blueprint floor(Vec2 from, Vec2 to, Real radius) {
    Blueprint plan = ground({.points = {from, to}, .radius = radius});
    plan.name = "floor";
    return plan;
}

namespace {

/// What hangs between two pins is longer than the way between them, unless the caller asks for
/// something else. A single link cannot bend.
double slackOf(const RopeOptions& options, int links) {
    if (!options.slack) return options.pinFirst && options.pinLast && links > 1 ? 0.02 : 0;
    const double slack = static_cast<double>(*options.slack);
    requireRange(slack, 0, links > 1 ? 10 : 0, links > 1 ? "slack" : "slack of a single link");
    return slack;
}

/// Corners of `links` equal sides along a circle, on the lower side of a way, or to the right of
/// one that is upright; together they are longer than the way by the share `slack`.
class Arc {
public:
    Arc(const Vec2& from, const Vec2& to, int links, double slack)
        : from_(from),
          along_(to - from),
          across_(along_[1], -along_[0]),
          links_(links),
          half_(halfAngle(links, slack)) {
        if (across_[1] > 0 || (across_[1] == 0 && across_[0] < 0)) across_ = -across_;
    }

    Vec2 place(int i) const {
        if (half_ == 0) return from_ + static_cast<Real>(i) / static_cast<Real>(links_) * along_;
        const Point at = detail::unitVector(half_ * (2.0 * i / links_ - 1));
        const Point end = detail::unitVector(half_);
        const double radius = 0.5 / end[1];  // of a circle with a chord of 1
        return from_ + static_cast<Real>(0.5 + radius * at[1]) * along_ +
               static_cast<Real>(radius * (at[0] - end[0])) * across_;
    }

private:
    /// Half of the angle of the whole arc, from sin(links x) / sin(x) = links / (1 + slack) by
    /// bisection: the left side falls from `links` to 0 while the angle goes from 0 to pi.
    static double halfAngle(int links, double slack) {
        if (slack == 0) return 0;
        double low = 0, high = detail::fullTurn / 2;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            const double ratio =
                detail::unitVector(middle)[1] / detail::unitVector(middle / links)[1];
            (ratio * (1 + slack) > links ? low : high) = middle;
        }
        return low;
    }

    Vec2 from_, along_, across_;
    int links_;
    double half_;
};

/// Elastic links would be pressed flat by a bend that is nearly as stiff as they are.
void stiffen(Blueprint& plan, const RopeOptions& options, double link) {
    if (options.bending == 0) return;
    const double mass = static_cast<double>(plan.particles[0].mass);
    const double most = std::sqrt(static_cast<double>(options.stiffness) / (16 * mass));
    const double w = std::min(
        detail::tuned::ropeFrequency * std::sqrt(static_cast<double>(options.bending)), most);
    const double z = detail::tuned::ropeDamping * static_cast<double>(options.bendingDamping);
    const double inertia = mass * link * link;
    const auto stiffness = static_cast<Real>(inertia * w * w);
    const auto damping = static_cast<Real>(2 * z * inertia * w);
    for (std::uint32_t i = 1; i + 1 < plan.particles.size(); ++i)
        plan.angles.push_back({i - 1, i, i + 1, stiffness, damping, Real(0)});
}

}  // namespace

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
    const double slack = slackOf(options, links);
    requireRange(static_cast<double>(options.bending), 0, 100, "bending");
    requireRange(static_cast<double>(options.bendingDamping), 0, 100, "bendingDamping");
    Blueprint plan;
    plan.name = "rope";
    plan.material = options.material;
    const Real mass = options.mass / static_cast<Real>(links + 1);
    const Arc arc(options.from, options.to, links, slack);
    for (int i = 0; i <= links; ++i) {
        const bool pinned = (i == 0 && options.pinFirst) || (i == links && options.pinLast);
        plan.particles.push_back({.position = arc.place(i), .mass = mass, .pinned = pinned});
    }
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(links); ++i) {
        plan.joints.push_back({.a = i,
                               .b = i + 1,
                               .stiffness = options.stiffness,
                               .damping = options.damping,
                               .restLength = static_cast<Real>((1 + slack) * length / links),
                               .radius = options.radius,
                               .strength = options.strength});
    }
    stiffen(plan, options, length / links);
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
                           .bending = 0,
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
