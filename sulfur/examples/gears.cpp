// A winch: a motor turns a small gear, that one a large one, and a drum on the large one winds up
// the rope of a load. Teeth touch nothing: mechanisms couple the angles of both gears, and the
// angle of the large one with the length of the rope.
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

using namespace sulfur;

namespace {

constexpr double pi = 3.14159265358979, module = 0.05;  // m of the pitch diameter for each tooth

/// `phase` is the place of its first tooth, counted in teeth.
Body addGear(World& world, Point centre, int teeth, double phase, Real mass) {
    shapes::PolygonOptions outline{.mass = mass, .radius = Real(0.005)};
    for (int i = 0; i < teeth; ++i)
        for (const auto& [side, height] : {std::pair(-0.3, -0.04), std::pair(-0.12, 0.04),
                                           std::pair(0.12, 0.04), std::pair(0.3, -0.04)}) {
            const double angle = 2 * pi * (i + phase + side) / teeth;
            const double radius = module * teeth / 2 + height;
            outline.points.push_back(
                Point(radius * std::cos(angle), radius * std::sin(angle)).cast<Real>());
        }
    return world.add(shapes::polygon(outline), {.position = centre});
}

}  // namespace

int main(int argc, char** argv) {
    Picture picture(argc, argv, {-1.6, -0.2}, {1.4, 3.5});
    constexpr int few = 8, many = 24;                           // teeth
    constexpr double drumRadius = 0.25, mass = 100, speed = 3;  // m, kg, rad/s of the motor
    const Point small(-0.8, 2.7), large(0, 2.7),
        edge(0.25, 2.7);  // edge: where the rope comes down

    World world;
    const Body frame = world.add(shapes::floor({-3, 0}, {3, 0}));
    const Body pinion = addGear(world, small, few, 0.5, 2);
    const Body wheel = addGear(world, large, many, 0, 10);
    const Body drum =
        world.add(shapes::ball({.radius = Real(drumRadius), .mass = 5}), {.position = large});
    const Body load = world.add(shapes::box({.size = {Real(0.6), Real(0.6)}, .mass = Real(mass)}),
                                {.position = {edge.x(), 0.36}});
    world.setCollision(pinion, wheel, false);
    world.weld(wheel, drum, large);
    const MechanismId motor =
        world.hinge(frame, pinion, small, {.drive = {.motorSpeed = Real(-speed), .motorMax = 150}});
    const MechanismId axle = world.hinge(frame, wheel, large);
    const MechanismId rope = world.distance(frame, edge, load, {edge.x(), 0.66});
    world.gear(motor, axle, Real(many) / few);     // they turn against each other
    world.gear(axle, rope, Real(1 / drumRadius));  // what is wound up is no longer there
    picture.paint(drum, "grey");
    picture.take(world, 0.3);

    const double before = world.info(rope).value;
    while (world.time() < 4) world.step();
    const double torque = -world.info(motor).force, needed = mass * 9.81 * drumRadius * few / many;
    const double lifted = before - world.info(rope).value;
    const double expected = 4 * speed * few / many * drumRadius;
    picture.take(world);
    picture.line(edge, world.info(rope).pointB);

    world.setDrive(motor, {.motorMax = 150});  // a motor that stands still is a brake
    while (world.time() < 6) world.step();
    const double lost = lifted - (before - world.info(rope).value);
    std::printf(
        "the motor lifted the load by %.3f m, expected %.3f, with %.1f N m, expected %.1f; "
        "the brake then lost %.1f mm\n",
        lifted, expected, torque, needed, 1000 * lost);
    return std::abs(lifted - expected) < 0.02 && std::abs(torque - needed) < 0.02 * needed &&
                   std::abs(lost) < 0.005
               ? 0
               : 1;
}
