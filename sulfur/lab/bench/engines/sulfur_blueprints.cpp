#include "bench/engines/sulfur_blueprints.hpp"

#include <algorithm>
#include <cmath>
#include <sulfur/shapes.hpp>

#include "battery/scenes.hpp"

namespace sulfur::lab::bench {

namespace {

void join(Blueprint& body, std::size_t a, std::size_t b, double radius) {
    body.joints.push_back({.a = static_cast<std::uint32_t>(a),
                           .b = static_cast<std::uint32_t>(b),
                           .radius = real(radius)});
}

/// Core and sockets have the mass and the inertia of the outline.
Blueprint withSockets(const BodyPlan& plan) {
    double reach2 = 0;
    for (const Point& socket : plan.sockets) reach2 += socket.squaredNorm();
    const double mass = plan.inertia() / reach2;
    Blueprint body;
    body.particles.push_back(
        {.mass = real(plan.mass() - mass * static_cast<double>(plan.sockets.size())),
         .radius = real(plan.parts[0].radius)});
    for (const Point& socket : plan.sockets) {
        body.particles.push_back({.position = socket.cast<Real>(), .mass = real(mass)});
        for (std::size_t i = 0; i + 1 < body.particles.size(); ++i)
            join(body, i, body.particles.size() - 1, 0);
    }
    return body;
}

/// Capsules end to end. Ends at one place are one particle.
Blueprint capsules(const BodyPlan& plan) {
    Blueprint body;
    std::vector<Point> places;
    const auto indexOf = [&](const Point& p) {
        const auto same = [&](const Point& q) { return (p - q).norm() < 1e-9; };
        const auto found = std::find_if(places.begin(), places.end(), same);
        if (found != places.end()) return static_cast<std::size_t>(found - places.begin());
        places.push_back(p);
        body.particles.push_back({.position = p.cast<Real>(), .mass = 0});
        return places.size() - 1;
    };
    for (const Outline& part : plan.parts) {
        const std::size_t a = indexOf(part.points[0]), b = indexOf(part.points[1]);
        const double mass = plan.density * part.area();
        for (const std::size_t end : {a, b}) body.particles[end].mass += real(mass / 2);
        join(body, a, b, part.radius);
    }
    return body;
}

/// The corners of a polygon whose sides lie `radius` outside of the core's.
std::vector<Vec2> outerCorners(const std::vector<Point>& core, double radius) {
    const std::size_t n = core.size();
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < n; ++i) {
        const Point in = (core[i] - core[(i + n - 1) % n]).normalized();
        const Point out = (core[(i + 1) % n] - core[i]).normalized();
        const double turn = 1 + in.dot(out);
        corners.emplace_back(
            (core[i] + radius / turn * Point(in.y() + out.y(), -in.x() - out.x())).cast<Real>());
    }
    return corners;
}

Blueprint polygon(const BodyPlan& plan) {
    const std::vector<Point>& core = plan.contour.empty() ? plan.parts[0].points : plan.contour;
    double radius = plan.parts[0].radius;
    const std::vector<Vec2> corners = outerCorners(core, radius);
    if (radius == 0) {
        constexpr double share = 0.01, most = 0.02;  // of the shortest side; m
        radius = most;
        for (std::size_t i = 0; i < core.size(); ++i)
            radius = std::min(radius, share * (core[(i + 1) % core.size()] - core[i]).norm());
    }
    // An upright rectangle has the library's own shape.
    const Vec2 size = corners.size() > 2 ? Vec2(corners[2] - corners[0]) : Vec2(0, 0);
    const bool upright =
        corners.size() == 4 && corners[1] == Vec2(corners[2].x(), corners[0].y()) &&
        corners[3] == Vec2(corners[0].x(), corners[2].y()) && corners[2] == -corners[0];
    if (upright)
        return shapes::box({.size = size, .mass = real(plan.mass()), .radius = real(radius)});
    return shapes::polygon({.points = corners, .mass = real(plan.mass()), .radius = real(radius)});
}

Blueprint shapeOf(const BodyPlan& plan) {
    if (!plan.sockets.empty()) return withSockets(plan);
    const Outline& part = plan.parts[0];
    if (part.points.size() == 1)
        return shapes::ball({.radius = real(part.radius), .mass = real(plan.mass())});
    return part.points.size() == 2 ? capsules(plan) : polygon(plan);
}

}  // namespace

Blueprint blueprintOf(const BodyPlan& plan) {
    Blueprint body = shapeOf(plan);
    body.material = {.staticFriction = real(plan.friction),
                     .kineticFriction = real(plan.friction),
                     .restitution = real(plan.restitution)};
    if (plan.mover != Mover::physics)
        body.kind = plan.mover == Mover::motor ? BodyKind::kinematic : BodyKind::fixed;
    body.filter.group = -plan.group;
    return body;
}

}  // namespace sulfur::lab::bench
