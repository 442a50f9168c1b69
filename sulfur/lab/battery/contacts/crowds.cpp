// A thousand bodies in a funnel, a tumbler and a compactor.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

int crowdOf(const Setup& setup) {
    return setup.quick ? 200 : 1000;
}

constexpr double pitchX = 0.36, pitchY = 0.32;  // m, between the middles at first

constexpr int kinds = 4, jelly = 2;

/// Discs, crates, jellies and ropes in turn.
Blueprint member(int number) {
    constexpr double mass = 0.2;
    switch (number % kinds) {
        case 0:
            return shapes::ball({.radius = Real(0.1), .mass = real(mass)});
        case 1:
            return crate({.size = 0.2, .mass = mass});
        case jelly:
            return shapes::jelly({.size = vec2(0.25, 0.25),
                                  .columns = 3,
                                  .rows = 3,
                                  .mass = real(mass),
                                  .stiffness = 2000,
                                  .damping = 2});
        default:
            return shapes::rope(
                {.from = vec2(-0.15, 0), .to = vec2(0.15, 0), .links = 4, .mass = real(mass)});
    }
}

/// m^2 that a member covers.
double areaOf(int number) {
    constexpr double ropeRadius = 0.015;
    switch (number % kinds) {
        case 0:
            return std::numbers::pi * 0.1 * 0.1;
        case 1:
            return 0.2 * 0.2;
        case jelly:
            return 0.25 * 0.25;
        default:
            return 0.3 * 2 * ropeRadius + std::numbers::pi * ropeRadius * ropeRadius;
    }
}

/// Fills the places of a grid that `inside` allows, row by row from `low`, with the whole crowd.
template <class Inside>
std::vector<Body> fill(World& world, int crowd, Point low, int columns, Inside inside) {
    std::vector<Body> bodies;
    for (int n = 0; static_cast<int>(bodies.size()) < crowd && n < 100 * crowd; ++n) {
        const Point place = low + Point(pitchX * (n % columns), pitchY * (n / columns));
        if (inside(place))
            bodies.push_back(
                world.add(member(static_cast<int>(bodies.size())), {.position = place}));
    }
    return bodies;
}

/// Bodies with a particle outside of a room, a closed line.
int lost(const World& world, const std::vector<Body>& bodies, const std::vector<Point>& room) {
    return static_cast<int>(std::count_if(bodies.begin(), bodies.end(), [&](const Body& body) {
        return std::any_of(body.particles().begin(), body.particles().end(), [&](ParticleId id) {
            return windingNumber(room, world.position(id)) == 0;
        });
    }));
}

Rows judge(const std::string& what, World& world, const std::vector<Body>& bodies,
           const std::vector<Point>& room, const Setup& setup) {
    SpeedMeter meter(world, bodies);
    world.step();
    const double speed = meter.add();
    const int strange =
        static_cast<int>(std::count_if(bodies.begin(), bodies.end(), [&](const Body& body) {
            return !allFinite(world, body.particles());
        }));
    keepPicture(setup, what, world);
    std::vector<BodyId> jellies;
    for (std::size_t i = jelly; i < bodies.size(); i += kinds) jellies.push_back(bodies[i].id());
    std::sort(jellies.begin(), jellies.end());
    const auto with = [&](BodyId a, BodyId b) {
        return std::binary_search(jellies.begin(), jellies.end(), a) ||
               std::binary_search(jellies.begin(), jellies.end(), b);
    };
    const auto without = [&](BodyId a, BodyId b) { return !with(a, b); };
    const std::string name =
        fmt::format("{} bodies in a {}, {:.1f} s: ", bodies.size(), what, world.time());
    return {atMost(name + "bodies that found no place",
                   crowdOf(setup) - static_cast<double>(bodies.size()), 0),
            atMost(name + "bodies that are not finite", strange, 0),
            atMost(name + "bodies lost", lost(world, bodies, room), 0),
            fallsShort(name + "deepest overlap without jellies (share of a capsule's radius)",
                       deepestOverlap(world, without).share, 0.3, 0.1),
            fallsShort(name + "deepest overlap with a jelly (share of a capsule's radius)",
                       deepestOverlap(world, with).share, 0.5, 0.1),
            reported(name + "largest speed at last (m/s)", speed)};
}

Blueprint line(const std::vector<Point>& points, bool closed) {
    shapes::GroundOptions options{.closed = closed};
    for (const Point& p : points) options.points.push_back(p.cast<Real>());
    return shapes::ground(options);
}

Rows funnel(const Setup& setup) {
    World world(still(setup, standardGravity));
    // From the upper left into the bin and out of it to the upper right; open above.
    const std::vector<Point> room{{-6, 60}, {-6, 10}, {-1.3, 5}, {-7, 5}, {-7, 0},
                                  {7, 0},   {7, 5},   {1.3, 5},  {6, 10}, {6, 60}};
    world.add(line(room, false));
    const std::vector<Body> bodies =
        fill(world, crowdOf(setup), Point(-5.4, 10.5), 31, [](const Point&) { return true; });
    run(world, 9);
    return judge("funnel", world, bodies, room, setup);
}

/// A drum with four paddles turns for 6 s, then stands still for 3 s.
Rows tumbler(const Setup& setup) {
    constexpr double radius = 7, omega = 0.6, turning = 6;
    constexpr int sides = 60;
    World world(still(setup, standardGravity));
    std::vector<Point> ring;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    Blueprint plan = line(ring, true);
    plan.kind = BodyKind::kinematic;
    for (std::uint32_t i = 0; i < sides; i += sides / 4) {
        const auto tip = static_cast<std::uint32_t>(plan.particles.size());
        plan.particles.push_back({.position = plan.particles[i].position * Real(0.9)});
        plan.joints.push_back({.a = i, .b = tip, .radius = Real(0.05)});
    }
    const Body drum = world.add(plan);
    // Below the paddles' circle, and clear of the paddles, which lie along the axes at first.
    const std::vector<Body> bodies =
        fill(world, crowdOf(setup), Point(-7.02, -6.72), 40, [](const Point& p) {
            const bool clear = p.cwiseAbs().minCoeff() > 0.3 && p.norm() < 6.65;
            return p.norm() < 6.05 || clear;
        });
    double angle = 0;
    for (int i = 0; i < std::lround(turning * setup.tickRate); ++i) {
        angle += omega / setup.tickRate;
        world.moveTo(drum, {.angle = angle});
        world.step();
    }
    run(world, 3);
    return judge("tumbler", world, bodies, ring, setup);
}

/// A lid comes down at 0.5 m/s until the bodies fill 85 % of what is left, and stays.
Rows compactor(const Setup& setup) {
    constexpr double half = 5, share = 0.85, speed = 0.5, top = 16, thickness = 0.05;
    World world(still(setup, standardGravity));
    const std::vector<Point> walls{{-half, 30}, {-half, 0}, {half, 0}, {half, 30}};
    world.add(line(walls, false));
    const double reach = half - 2 * thickness - 0.005;
    Blueprint lidPlan = line({{-reach, 0}, {reach, 0}}, false);
    lidPlan.kind = BodyKind::kinematic;
    const Body lid = world.add(lidPlan, {.position = Point(0, top)});
    const std::vector<Body> bodies =
        fill(world, crowdOf(setup), Point(-4.7, 0.3), 27, [](const Point&) { return true; });
    double area = 0;
    for (int i = 0; i < crowdOf(setup); ++i) area += areaOf(i);
    const double lowest = area / share / (2 * (half - thickness)) + 2 * thickness;
    run(world, 2);
    // What stands above the heap is only air: the lid comes down fast to where it begins.
    double height = top;
    while (height > lowest) {
        height = std::max(lowest, height - (height > lowest + 2.4 ? 4 : speed) / setup.tickRate);
        world.moveTo(lid, {.position = Point(0, height)});
        world.step();
    }
    run(world, 2);
    const std::vector<Point> room{{-half, height}, {-half, 0}, {half, 0}, {half, height}};
    return judge("compactor", world, bodies, room, setup);
}

}  // namespace

Rows crowds(const Setup& setup) {
    Rows rows;
    for (Rows more : {funnel(setup), tumbler(setup), compactor(setup)})
        for (Row& row : more) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
