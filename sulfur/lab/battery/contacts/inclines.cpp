// Static and kinetic friction on a slope.
#include <fmt/format.h>

#include <cmath>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

const Material rough{.staticFriction = Real(0.6), .kineticFriction = Real(0.48)};

/// A slope through the origin that falls to the left, and what lies on it from the start.
struct Slope {
    Slope(const Setup& setup, double share, Blueprint plan, double height)
        : world(still(setup, standardGravity)),
          angle(std::atan(share * static_cast<double>(rough.staticFriction))) {
        const Vec along(std::cos(angle), std::sin(angle)), up(-along.y(), along.x());
        const double radius = 0.05;
        plan.material = rough;
        body = world.add(plan, {.position = height / 2 * up, .angle = angle});
        world.add(
            shapes::ground(
                {.points = {vec2(-40, 0), vec2(10, 0)}, .radius = real(radius), .material = rough}),
            {.position = -radius * up, .angle = angle});
    }

    World world;
    double angle;  // rad
    Body body;
};

Row creep(const std::string& what, const Blueprint& plan, double bound, const Setup& setup) {
    Slope slope(setup, 0.98, plan, 1);
    run(slope.world, 1);
    const Point start = slope.world.centreOfMass(slope.body);
    double way = 0;
    for (int i = 0; i < 600; ++i) {
        run(slope.world, 0.1);
        way = worst(way, (slope.world.centreOfMass(slope.body) - start).norm());
    }
    keepPicture(setup, "incline98-" + what, slope.world);
    const std::string name = what + " on a slope of 0.98 of its static limit: way in 60 s (m)";
    return bound > 0 ? atMost(name, way, bound) : reported(name, way);
}

Row slide(const std::string& what, const Blueprint& plan, bool bounded, const Setup& setup) {
    Slope slope(setup, 1.02, plan, 1);
    const Point start = slope.world.centreOfMass(slope.body);
    const double seconds = 2;
    run(slope.world, seconds);
    const double way = (slope.world.centreOfMass(slope.body) - start).norm();
    const double expected =
        standardGravity * (std::sin(slope.angle) -
                           static_cast<double>(rough.kineticFriction) * std::cos(slope.angle));
    keepPicture(setup, "incline102-" + what, slope.world);
    const double error = std::abs(2 * way / (seconds * seconds) / expected - 1);
    const std::string name =
        what + " on a slope of 1.02 of its static limit: error of its acceleration (share)";
    return bounded ? atMost(name, error, 0.01) : reported(name, error);
}

}  // namespace

Rows inclines(const Setup& setup) {
    const Blueprint rigid = crate(), soft = firmJelly(1, 1);
    return {creep("crate", rigid, 1e-4, setup), slide("crate", rigid, true, setup),
            creep("jelly", soft, 0, setup), slide("jelly", soft, false, setup)};
}

}  // namespace sulfur::lab
