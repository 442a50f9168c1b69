// Ready-made blueprints: what is common to them, and the small ones.
#include <sulfur/shapes.hpp>

#include <algorithm>
#include <cmath>

#include "core/error_checks.hpp"
#include "core/trigonometry.hpp"

namespace sulfur::shapes {

using detail::requireFinite;
using detail::requirePositive;
using detail::requireRange;

namespace {

void requireSize(Vec2 size, Real radius) {
    requireFinite(size, "size");
    const double smallest = 2 * static_cast<double>(radius);
    for (int axis = 0; axis < 2; ++axis) {
        if (static_cast<double>(size[axis]) > smallest) continue;
        throw Error(ErrorCode::outOfRange, "size is " + std::to_string(size[axis]) +
                                               "; allowed is more than twice the radius, " +
                                               std::to_string(smallest));
    }
}

}  // namespace

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

Blueprint box(const BoxOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    requirePositive(static_cast<double>(options.mass), "mass");
    requireSize(options.size, options.radius);
    const Vec2 half = options.size / 2 - Vec2(options.radius, options.radius);
    // With a share q of the mass in the corners, at distance |half|, the inertia is
    // q m |half|^2; a solid rectangle of the outer size has m |size|^2 / 12.
    const double share = std::min(1.0, static_cast<double>(options.size.squaredNorm()) / 12 /
                                           static_cast<double>(half.squaredNorm()));
    const Real corner =
        options.solidInertia ? options.mass * static_cast<Real>(share) / 4 : options.mass / 4;
    Blueprint plan;
    plan.name = "box";
    plan.material = options.material;
    for (const Vec2& sign : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        plan.particles.push_back({.position = half.cwiseProduct(sign), .mass = corner});
    const auto join = [&](std::uint32_t a, std::uint32_t b, Real radius) {
        plan.joints.push_back({.a = a,
                               .b = b,
                               .stiffness = options.stiffness,
                               .damping = options.damping,
                               .radius = radius,
                               .strength = options.strength});
    };
    for (std::uint32_t i = 0; i < 4; ++i) join(i, (i + 1) % 4, options.radius);
    join(0, 2, 0);
    join(1, 3, 0);
    if (options.solidInertia && share < 1) {
        plan.particles.push_back({.mass = options.mass * static_cast<Real>(1 - share)});
        for (std::uint32_t i = 0; i < 4; ++i) join(i, 4, 0);
    }
    plan.validate();
    return plan;
}

Blueprint ball(const BallOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    Blueprint plan;
    plan.name = "ball";
    plan.material = options.material;
    plan.particles.push_back({.mass = options.mass, .radius = options.radius});
    plan.validate();
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

Blueprint jelly(const JellyOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    requirePositive(static_cast<double>(options.mass), "mass");
    requireSize(options.size, options.radius);
    requireRange(options.columns, 2, 1000, "columns");
    requireRange(options.rows, 2, 1000, "rows");
    Blueprint plan;
    plan.name = "jelly";
    plan.material = options.material;
    const auto columns = static_cast<std::uint32_t>(options.columns);
    const auto rows = static_cast<std::uint32_t>(options.rows);
    const Vec2 inner = options.size - 2 * Vec2(options.radius, options.radius);
    const Real mass = options.mass / static_cast<Real>(columns * rows);
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const Vec2 way(static_cast<Real>(column) / static_cast<Real>(columns - 1),
                           static_cast<Real>(row) / static_cast<Real>(rows - 1));
            plan.particles.push_back(
                {.position = inner.cwiseProduct(way) - inner / 2, .mass = mass});
        }
    }
    const auto at = [columns](std::uint32_t column, std::uint32_t row) {
        return row * columns + column;
    };
    const auto join = [&](std::uint32_t a, std::uint32_t b, bool outline) {
        plan.joints.push_back({.a = a,
                               .b = b,
                               .stiffness = options.stiffness,
                               .damping = options.damping,
                               .radius = outline ? options.radius : 0,
                               .strength = options.strength});
    };
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const bool hasRight = column + 1 < columns;
            const bool hasUp = row + 1 < rows;
            if (hasRight) join(at(column, row), at(column + 1, row), row == 0 || row + 1 == rows);
            if (hasUp)
                join(at(column, row), at(column, row + 1), column == 0 || column + 1 == columns);
            if (hasRight && hasUp) {
                join(at(column, row), at(column + 1, row + 1), false);
                join(at(column + 1, row), at(column, row + 1), false);
            }
        }
    }
    plan.validate();
    return plan;
}

Blueprint blob(const BlobOptions& options) {
    requirePositive(static_cast<double>(options.skinRadius), "skin radius");
    requirePositive(static_cast<double>(options.mass), "mass");
    requireRange(static_cast<double>(options.radius), 2 * static_cast<double>(options.skinRadius),
                 1e6, "radius");
    requireRange(options.segments, 3, 1000, "segments");
    Blueprint plan;
    plan.name = "blob";
    plan.material = options.material;
    const auto count = static_cast<std::uint32_t>(options.segments);
    // A solid disc has the inertia m R^2 / 2; with a share q on the ring of radius r it is
    // q m r^2.
    const double outer = static_cast<double>(options.radius);
    const double ring = outer - static_cast<double>(options.skinRadius);
    const double share = std::min(0.9, outer * outer / (2 * ring * ring));
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto direction = detail::unitVector(detail::fullTurn * i / count);
        plan.particles.push_back(
            {.position = (ring * direction).cast<Real>(),
             .mass = static_cast<Real>(static_cast<double>(options.mass) * share / count)});
    }
    plan.particles.push_back(
        {.mass = static_cast<Real>(static_cast<double>(options.mass) * (1 - share))});
    const auto join = [&](std::uint32_t a, std::uint32_t b, Real radius) {
        plan.joints.push_back({.a = a,
                               .b = b,
                               .stiffness = options.stiffness,
                               .damping = options.damping,
                               .radius = radius});
    };
    for (std::uint32_t i = 0; i < count; ++i) join(i, (i + 1) % count, options.skinRadius);
    for (std::uint32_t i = 0; i < count; ++i) join(i, count, 0);
    // Braces over one neighbour resist bending of the outline; with fewer than five segments
    // they would repeat the outline.
    if (count >= 5)
        for (std::uint32_t i = 0; i < count; ++i) join(i, (i + 2) % count, 0);
    plan.validate();
    return plan;
}

}  // namespace sulfur::shapes
