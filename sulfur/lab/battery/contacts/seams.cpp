// Sliding over the seams of a floor that is a chain of segments.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr double startSpeed = 2;  // m/s
constexpr int segments = 100;
constexpr double seamless = 25;  // m, a segment that is longer than the way: for comparison
constexpr double begin = -2;     // m, where the floor begins; what slides starts at 0

void addChain(World& world, double segment, const Material& material) {
    constexpr double radius = 0.05;
    std::vector<Vec2> points;
    for (int i = 0; i <= segments; ++i) points.push_back(vec2(begin + i * segment, -radius));
    world.add(shapes::ground({.points = points, .radius = real(radius), .material = material}));
}

struct Slider {
    std::string what;
    Blueprint plan;
    double height;  // m, of its middle above the floor
    bool bounded = true;
};

/// The largest vertical speed of the centre over its speed at the time, until it is slower than a
/// quarter of what it began with, or near the end of the floor.
Row slide(Slider slider, double segment, double friction, const Setup& setup) {
    const Material material{.staticFriction = real(friction), .kineticFriction = real(friction)};
    World world(still(setup, standardGravity));
    addChain(world, segment, material);
    slider.plan.material = material;
    const Body body = world.add(slider.plan, {.position = Point(0, slider.height)});
    run(world, 1);  // to rest, so that only the seams are seen
    world.setVelocity(body, vec2(startSpeed, 0));
    const double end = begin + segments * segment - 1;
    double bump = 0;
    Point before = world.centreOfMass(body);
    for (int tick = 0; tick < 10 * setup.tickRate && before.x() < end; ++tick) {
        world.step();
        const Point now = world.centreOfMass(body);
        const Point way = now - before;
        before = now;
        if (!(way.x() * setup.tickRate > startSpeed / 4)) break;
        bump = worst(bump, std::abs(way.y() / way.x()));
    }
    const std::string name = fmt::format(
        "{} at {:g} m/s over seams every {:g} m, friction {:g}, {:.1f} m: vertical "
        "speed (share of its speed)",
        slider.what, startSpeed, segment, friction, before.x());
    if (!(before.x() > 0.5)) return atMost(name, std::nan(""), 1e-3);
    return slider.bounded ? atMost(name, bump, 1e-3) : reported(name, bump);
}

}  // namespace

Rows seams(const Setup& setup) {
    const std::vector<Slider> sliders{
        {"crate of 1 m", crate(), 0.5},
        {"crate of 0.3 m", crate({.size = 0.3}), 0.15},
        {"disc", shapes::ball({.radius = Real(0.25)}), 0.25},
        {"jelly", firmJelly(1, 1), 0.5, false},
    };
    Rows rows;
    for (const Slider& slider : sliders)
        for (const double friction : {0.0, 0.3})
            for (const double segment : {0.1, 0.25, 0.5, seamless})
                rows.push_back(slide(slider, segment, friction, setup));
    return rows;
}

}  // namespace sulfur::lab
