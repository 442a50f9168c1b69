// Segments that fall on a floor of segments: figure 7 of the paper.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr double radius = 0.02, rodLength = 0.5, cell = 0.5;  // m

Blueprint rod() {
    return shapes::rope({.from = vec2(0, -rodLength / 2),
                         .to = vec2(0, rodLength / 2),
                         .links = 1,
                         .mass = 1,
                         .radius = real(radius)});
}

/// A floor of segments of 0.5 m with seams at whole multiples of that, as one chain or as bodies of
/// their own that meet end to end. Its surface is at y = 0.
void addCells(World& world, bool apart) {
    std::vector<Vec2> points;
    for (int i = -10; i <= 10; ++i) points.push_back(vec2(i * cell, -radius));
    if (!apart) {
        world.add(shapes::ground({.points = points, .radius = real(radius)}));
        return;
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        world.add(shapes::ground({.points = {points[i], points[i + 1]}, .radius = real(radius)}));
}

struct Fall {
    const char* where;
    double x;      // m, of the rod's middle
    double angle;  // rad, from upright
    double speed;  // m/s, downwards
    bool apart;    // the floor is of single bodies
};

/// How deep the rod's lowest surface is below the floor's, m.
double depth(const World& world, const Body& body) {
    double lowest = 0;
    for (const ParticleId id : body.particles())
        lowest = worst(lowest, radius - world.position(id).y());
    return lowest;
}

Rows rowsOf(const Fall& f, const Setup& setup) {
    World world(still(setup, standardGravity));
    addCells(world, f.apart);
    const std::vector<Body> bodies{world.add(rod(), {.position = Point(f.x, 1), .angle = f.angle})};
    const Body& body = bodies.front();
    world.setVelocity(body, vec2(0, -f.speed));
    double deepest = 0;
    SpeedMeter meter(world, bodies);
    double speed = 0;
    const int ticks = 10 * setup.tickRate;
    for (int i = 0; i < ticks; ++i) {
        world.step();
        deepest = worst(deepest, depth(world, body));
        const double now = meter.add();
        if (i >= ticks - setup.tickRate) speed = worst(speed, now);
    }
    const std::string name = fmt::format("segment at {:g} m/s, {}, floor of {}: ", f.speed, f.where,
                                         f.apart ? "single segments" : "one chain");
    return {atMost(name + "deepest below the surface (m)", deepest, radius / 2),
            atMost(name + "below the surface at last (m)", depth(world, body), radius / 10),
            atMost(name + "speed after 9 s (m/s)", speed, 1e-3)};
}

}  // namespace

Rows segments(const Setup& setup) {
    Rows rows;
    for (const double speed : {0.0, 10.0, 100.0, 300.0})
        for (const bool apart : {false, true})
            for (const Fall& f : {Fall{"end-on between seams", 0.2, 0, speed, apart},
                                  Fall{"end-on at a seam", 0, 0, speed, apart},
                                  Fall{"across a seam", 0, 1.2, speed, apart}})
                for (Row& row : rowsOf(f, setup)) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
