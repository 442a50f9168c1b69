#include "battery/pendulums.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

/// Period (s) of a pendulum with the frequency `omega` for small swings, released at rest at
/// `angle`: 4 K(sin(angle / 2)) / omega, with the complete elliptic integral K.
double periodFrom(double angle, double omega) {
    return 4 * std::comp_ellint_1(std::sin(angle / 2)) / omega;
}

}  // namespace

Rows pendulum(double seconds, const Setup& setup) {
    World world(still(setup, standardGravity));
    const Body body =
        world.add(chain({.places = {Vec(0, 0), Vec(1, 0)}, .masses = {1, 1}, .lengths = {1}}));
    Crossings crossings;
    const auto ticks = std::lround(seconds * setup.tickRate);
    for (long i = 0; i < ticks; ++i) {
        world.step();
        crossings.add(world.time(), world.position(body.back()).x());
    }
    const double theory = periodFrom(std::numbers::pi / 2, std::sqrt(standardGravity));
    const double energy = world.energy();   // J, which was 0 at the release
    const double budget = standardGravity;  // J, released from 0 to the lowest point
    const std::string name = fmt::format("pendulum from 90 degrees, {:g} s: ", seconds);
    return {atMost(name + "error of the period (share)", std::abs(crossings.period() / theory - 1),
                   1e-3),
            atMost(name + "energy lost (share)", -energy / budget, 5e-3),
            atMost(name + "energy gained (share)", energy / budget, 5e-3)};
}

Row solidPendulum(Vec2 size, Hinge hinge, const Setup& setup) {
    World world(still(setup, standardGravity));
    const double radius = 0.02, mass = 1, angle = std::numbers::pi / 6;
    const Eigen::Vector2d outer = size.cast<double>();
    // Where the hinge is, seen from the centre.
    const Vec arm =
        hinge == Hinge::corner ? Vec(outer / 2 - Vec(radius, radius)) : Vec(0, outer.y() / 2);
    Blueprint plan = shapes::box({.size = size, .mass = real(mass), .radius = real(radius)});
    plan.filter.mask = 0;
    // It hangs at rest with its centre below the hinge; it is released turned by `angle` from that.
    const double turn = std::numbers::pi / 2 - std::atan2(arm.y(), arm.x()) + angle;
    const Vec down(std::cos(turn) * arm.x() - std::sin(turn) * arm.y(),
                   std::sin(turn) * arm.x() + std::cos(turn) * arm.y());
    const Body body = world.add(plan, {.position = Point(-down), .angle = turn});
    if (hinge == Hinge::corner) {
        const auto corner = world.nearestParticle(Point(0, 0), real(0.001));
        if (!corner)
            return atMost("solid pendulum without a corner particle",
                          std::numeric_limits<double>::quiet_NaN(), 0);
        world.setPinned(*corner, true);
    } else {
        Blueprint nail = ghost("nail");
        nail.kind = BodyKind::fixed;
        nail.particles.push_back({});
        const Body held = world.add(nail);
        world.attach(held.front(), body, arm.cast<Real>());
    }
    Crossings crossings;
    for (long i = 0; i < 20L * setup.tickRate; ++i) {
        world.step();
        crossings.add(world.time(), motionOf(world, body.particles()).centre.x());
    }
    const double distance = arm.norm();
    const double inertia = mass * (outer.squaredNorm() / 12 + distance * distance);
    const double theory = periodFrom(angle, std::sqrt(mass * standardGravity * distance / inertia));
    return atMost(fmt::format("solid rectangle {:g} x {:g} m, hinge at its {}: error of the period "
                              "(share)",
                              outer.x(), outer.y(), hinge == Hinge::corner ? "corner" : "top"),
                  std::abs(crossings.period() / theory - 1), 5e-3);
}

}  // namespace sulfur::lab
