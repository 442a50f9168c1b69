// What rolls down a slope.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "battery/joints/joints.hpp"
#include "battery/joints/subjects.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr double rollRadius = 0.5;                  // m
constexpr double rollSlope = std::numbers::pi / 9;  // rad
constexpr double rollSeconds = 2;

/// On a slope through the origin that falls to the right, from rest: the acceleration along it,
/// and the largest distance from the line on which the centre should go.
struct Roll {
    double acceleration = 0, bump = 0;  // m/s^2, m
};

template <class Place, class Step>
Roll watch(long ticks, Place place, Step step) {
    const Point along(std::cos(rollSlope), -std::sin(rollSlope)), up(-along.y(), along.x());
    const Point start = place();
    Roll roll;
    for (long i = 0; i < ticks; ++i) {
        step();
        roll.bump = worst(roll.bump, std::abs((place() - start).dot(up)));
    }
    roll.acceleration = 2 * (place() - start).dot(along) / (rollSeconds * rollSeconds);
    return roll;
}

Roll rollDisc(const JointSubject& subject) {
    const auto world = subject.world(false);
    Workshop workshop(*world);
    const Point along(std::cos(rollSlope), -std::sin(rollSlope)), up(-along.y(), along.x());
    workshop.add({.parts = {bench::rectangle({40, 0.5})},
                  .mover = bench::Mover::nobody,
                  .place = -0.5 * up,
                  .angle = -rollSlope});
    const auto disc = workshop.add({.parts = {bench::disc(rollRadius)}, .place = rollRadius * up});
    return watch(
        subject.ticks(rollSeconds), [&] { return world->body(disc).place; },
        [&] { world->step(); });
}

/// One of ours with a rim, at rest on the slope, and what theory makes of its moment of inertia.
struct Rim {
    Rim(const Blueprint& plan, int rate, const Setup& setup)
        : world(still({.tickRate = rate, .sweeps = setup.sweeps}, standardGravity)) {
        const Point along(std::cos(rollSlope), -std::sin(rollSlope)), up(-along.y(), along.x());
        const Material rough{.staticFriction = 1, .kineticFriction = 1};
        constexpr double thickness = 0.05;
        world.add(shapes::ground({.points = {vec2(-10, 0), vec2(40, 0)},
                                  .radius = real(thickness),
                                  .material = rough}),
                  {.position = -thickness * up, .angle = -rollSlope});
        Blueprint rolling = plan;
        rolling.material = rough;
        body = world.add(rolling, {.position = rollRadius * up, .angle = -rollSlope});
        const double inertia = static_cast<double>(world.inertia(body));
        const double mass = static_cast<double>(world.mass(body));
        expected = standardGravity * std::sin(rollSlope) /
                   (1 + inertia / (mass * rollRadius * rollRadius));
    }
    Roll roll() {
        return watch(
            std::lround(rollSeconds * world.settings().tickRate),
            [&] { return world.centreOfMass(body); }, [&] { world.step(); });
    }

    World world;
    Body body;
    double expected = 0;  // m/s^2
};

Rows rollRim(const std::string& what, const Blueprint& plan, int rate, double reached,
             const Setup& setup) {
    Rim rim(plan, rate, setup);
    const Roll roll = rim.roll();
    const std::string name = fmt::format("{} Hz: {} down 20 degrees: ", rate, what);
    constexpr double asked = 0.005;
    const std::string quantity = name + "error of its acceleration (share)";
    const double error = std::abs(roll.acceleration / rim.expected - 1);
    return {reached > asked ? fallsShort(quantity, error, reached, asked)
                            : atMost(quantity, error, asked),
            reported(name + "its centre leaves its line (m)", roll.bump)};
}

/// A wheel of spokes whose rim is a circle: sixteen arcs.
Blueprint roundWheel() {
    constexpr int segments = 16;
    Blueprint plan =
        shapes::wheel({.radius = real(rollRadius), .segments = segments, .rimRadius = Real(0.02)});
    for (JointSpec& joint : plan.joints)
        if (joint.radius > 0) joint.bend = real(2 * std::numbers::pi / segments);
    return plan;
}

/// A disc that slides to and fro in half a circle of arcs or of straight facets, without friction:
/// the share of its energy that ten seconds have left. Where it turns by an angle in a step, a step
/// takes the square of that from arcs: about 0.04.
double energyInBowl(int pieces, bool arcs, int rate, const Setup& setup) {
    constexpr double radius = 2, thickness = 0.05, size = 0.1, start = 1;  // m, rad
    World world(still({.tickRate = rate, .sweeps = setup.sweeps}, standardGravity));
    const Material slick{.staticFriction = 0, .kineticFriction = 0};
    std::vector<Vec2> points;
    for (int k = 0; k <= pieces; ++k) {
        const double angle = std::numbers::pi * k / pieces;
        points.push_back(vec2(-radius * std::cos(angle), -radius * std::sin(angle)));
    }
    std::vector<Real> bends;
    if (arcs) bends.assign(static_cast<std::size_t>(pieces), real(std::numbers::pi / pieces));
    world.add(shapes::ground(
        {.points = points, .radius = real(thickness), .material = slick, .bends = bends}));
    const double length = radius - thickness - size;
    Blueprint disc;
    disc.material = slick;
    disc.particles = {{.mass = 1, .radius = real(size)}};
    const Body body =
        world.add(disc, {.position = {length * std::sin(start), -length * std::cos(start)}});
    const auto energy = [&] {
        return standardGravity * (world.position(body[0]).y() + length) +
               world.velocity(body[0]).cast<double>().squaredNorm() / 2;
    };
    const double before = energy();
    for (long i = 0; i < 10L * rate; ++i) world.step();
    return energy() / before;
}

void appendRows(Rows& rows, Rows more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

}  // namespace

Rows rolling(const Setup& setup) {
    Rows rows;
    for (const JointSubject& subject : jointSubjects(setup)) {
        const Roll roll = rollDisc(subject);
        const double expected = 2.0 / 3 * standardGravity * std::sin(rollSlope);
        rows.push_back(subject.row("disc down 20 degrees: error of its acceleration (share)",
                                   std::abs(roll.acceleration / expected - 1), 0.005));
        rows.push_back(subject.row("disc down 20 degrees: its centre leaves its line (m)",
                                   roll.bump, unbounded));
    }
    const auto wheel = [](int segments, double stiffness) {
        return shapes::wheel({.radius = real(rollRadius),
                              .segments = segments,
                              .rimRadius = Real(0.02),
                              .spokeStiffness = real(stiffness),
                              .spokeDamping = std::isinf(stiffness) ? Real(0) : Real(0.1)});
    };
    // The corners of a rim cost energy, in proportion to the angle at one of them.
    for (const int rate : jointRates()) {
        for (const auto& [segments, reached] : {std::pair(100, 0.04), std::pair(1000, 0.015)})
            appendRows(rows, rollRim(fmt::format("wheel of spokes and hub, {} segments,", segments),
                                     wheel(segments, unbounded), rate, reached, setup));
        appendRows(rows,
                   rollRim("wheel of spokes and hub, 16 arcs,", roundWheel(), rate, 0.005, setup));
        for (const int pieces : {1, 20}) {
            const std::string name = fmt::format("{} Hz: half a bowl of {} ", rate, pieces);
            rows.push_back(atMost(
                name + (pieces == 1 ? "arc" : "arcs") + ": energy lost in 10 s of sliding (share)",
                std::abs(1 - energyInBowl(pieces, true, rate, setup)), 0.05));
        }
        rows.push_back(reported(
            fmt::format("{} Hz: half a bowl of 20 facets: energy lost in 10 s of sliding (share)",
                        rate),
            1 - energyInBowl(20, false, rate, setup)));
        // Links of a soft rim lose what they strike the slope with: 0.029 with ever shorter steps.
        appendRows(rows,
                   rollRim("soft tyre of 400 segments", wheel(400, 10000), rate, 0.027, setup));
    }
    return rows;
}

}  // namespace sulfur::lab
