// Beams of angular joints and of welds, against Euler and Bernoulli.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "battery/joints/joints.hpp"
#include "battery/joints/subjects.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr int stripLinks = 21;
constexpr double stripLink = 0.05;                            // m
constexpr double stripLength = stripLink * (stripLinks - 1);  // m, that is free

/// Particles on rigid links along x, clamped at the first link. Half of a link bends at the clamp,
/// which therefore is twice as stiff as the others.
Blueprint strip(double mass, double stiffness, double damping) {
    Blueprint plan = ghost("strip");
    for (int i = 0; i <= stripLinks; ++i)
        plan.particles.push_back(
            {.position = vec2(stripLink * i, 0), .mass = real(mass), .pinned = i < 2});
    for (std::uint32_t i = 0; i < stripLinks; ++i) plan.joints.push_back({.a = i, .b = i + 1});
    for (std::uint32_t i = 0; i + 1 < stripLinks; ++i)
        plan.angles.push_back(
            {i, i + 1, i + 2, real(i == 0 ? 2 * stiffness : stiffness), real(damping), Real(0)});
    return plan;
}

/// F L^3 / (3 E I), for a load that bends it by a hundredth of its length.
double cantileverError(double stiffness, int rate, const Setup& setup) {
    constexpr double mass = 0.05, share = 0.01;
    const double rigidity = stiffness * stripLink;  // N m^2
    const double slowest =
        3.516 / (stripLength * stripLength) * std::sqrt(rigidity / (mass / stripLink));
    WorldSettings settings = still({.tickRate = rate, .sweeps = setup.sweeps}, 0);
    settings.airFriction = real(std::min(2 * slowest, 0.5 * rate));  // no overshoot
    World world(settings);
    const Body body = world.add(strip(mass, stiffness, 0));
    const double force = share * 3 * rigidity / (stripLength * stripLength);
    while (world.time() < std::max(2.0, 12 / slowest)) {
        world.applyForce(body.back(), vec2(0, -force));
        world.step();
    }
    return std::abs(-world.position(body.back()).y() / (share * stripLength) - 1);
}

/// The same of boxes on welds that are springs: F sum (L - x)^2 / k over the welds.
double weldedError(int rate, const Setup& setup) {
    constexpr int boxes = 8;
    constexpr double stiffness = 2000, force = 1;
    World world(still({.tickRate = rate, .sweeps = setup.sweeps}, 0));
    Blueprint nail = ghost("nail");
    nail.kind = BodyKind::fixed;
    nail.particles.push_back({});
    const Body clamp = world.add(nail);
    Body before = clamp;
    double expected = 0;
    for (int i = 0; i < boxes; ++i) {
        const Body box =
            world.add(shapes::box({.size = vec2(0.98, 0.2)}), {.position = Point(i + 0.5, 0)});
        world.weld(before, box, Point(i, 0), {.stiffness = stiffness, .damping = 600});
        expected += force * (boxes - i) * (boxes - i) / stiffness;
        before = box;
    }
    const Point end(boxes, 0);
    const Point held = world.toBody(before, end);
    for (long i = 0; i < 30L * rate; ++i) {
        world.applyForce(before, vec2(0, -force), world.toWorld(before, held));
        world.step();
    }
    const double bent = -world.toWorld(before, held).y();
    return std::abs(bent / expected - 1);
}

/// How far the end of a clamped column goes to the side under a share of pi^2 E I / (4 L^2), in its
/// length.
double columnBends(double share, int rate, const Setup& setup) {
    constexpr double stiffness = 40;
    World world(still({.tickRate = rate, .sweeps = setup.sweeps}, 0));
    const Body body = world.add(strip(0.01, stiffness, 1), {.angle = std::numbers::pi / 2});
    const double load = share * std::numbers::pi * std::numbers::pi * stiffness * stripLink /
                        (4 * stripLength * stripLength);
    world.applyImpulse(body.back(), vec2(1e-5, 0));
    for (long i = 0; i < 20L * rate; ++i) {
        world.applyForce(body.back(), vec2(0, -load));
        world.step();
    }
    return std::abs(world.position(body.back()).x()) / stripLength;
}

}  // namespace

Rows bending(const Setup& setup) {
    Rows rows;
    for (const int rate : jointRates()) {
        const auto name = [&](const std::string& what) {
            return fmt::format("{} Hz: {}", rate, what);
        };
        for (const double stiffness : {0.5, 50.0, 5000.0})
            rows.push_back(atMost(name(fmt::format("cantilever of angular joints of {:g} N m/rad: "
                                                   "error of its bend (share)",
                                                   stiffness)),
                                  cantileverError(stiffness, rate, setup), 0.02));
        rows.push_back(atMost(name("cantilever of eight boxes on welds: error of its bend (share)"),
                              weldedError(rate, setup), 0.02));
        rows.push_back(atMost(name("column under 0.98 of Euler's load: to the side (lengths)"),
                              columnBends(0.98, rate, setup), 1e-3));
        // What must be large is told by what it lacks.
        rows.push_back(
            atMost(name("column under 1.02 of Euler's load: less to the side than 0.1 (lengths)"),
                   std::max(0.0, 0.1 - columnBends(1.02, rate, setup)), 0));
    }
    return rows;
}

}  // namespace sulfur::lab
