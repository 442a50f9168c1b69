// A trebuchet throws a stone. A counterweight hangs on the short end of a beam, which turns about
// an axle; a rope holds the long end down until it is cut. The stone is pressed into its spoon
// while the beam turns ever faster, and flies on when that meets the stop.
#include <algorithm>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-4.4, -0.3}, {11.6, 5.9});

    World world;
    world.add(shapes::floor({-10, 0}, {60, 0}));
    // The trestle touches nothing: it has no bit in its mask.
    const Body trestle = world.add(
        {.kind = BodyKind::fixed,
         .particles = {{.position = {0, 1.8}}, {.position = {-0.7, 0}}, {.position = {0.7, 0}}},
         .joints = {{.a = 0, .b = 1, .radius = 0.06}, {.a = 0, .b = 2, .radius = 0.06}},
         .filter = {.mask = 0}});
    world.add({.kind = BodyKind::fixed,
               .particles = {{.position = {-0.5, 2.6}, .radius = 0.1}}});  // stop

    // The beam lies level in its own frame, with the axle at the origin and the spoon on the left.
    const Body beam = world.add(
        shapes::polygon(
            {.points = {{1, -0.08}, {1, 0.08}, {-2.8, 0.08}, {-2.9, 0.3}, {-3, 0.3}, {-3, -0.08}},
             .mass = 30}),
        {.position = {0, 1.8}, .angle = 0.5});
    world.attach(trestle.front(), beam, {0, 0});
    const Body ground =
        world.add({.kind = BodyKind::fixed, .particles = {{.position = {-2.7, 0}}}});
    const JointId rope = world.connect(ground.front(), beam[5]);
    const Body weight =
        world.add(shapes::ball({.radius = 0.35, .mass = 100}), {.position = {0.9, 1.7}});
    world.connect(beam[0], weight.front());
    const Body stone =
        world.add(shapes::ball({.radius = 0.12, .mass = 3}), {.position = {-2.48, 0.67}});
    picture.paint(stone, "red");
    while (world.time() < 1) world.step();
    picture.take(world, 0.25);

    world.remove(rope);
    double highest = 0;
    while (stone.centreOfMass().y() > 0.18 || world.time() < 1.2) {
        world.step();
        highest = std::max(highest, stone.centreOfMass().y());
        if (world.ticks() % 25 == 0) picture.dot(stone.centreOfMass());
        if (world.ticks() == 860) picture.take(world);
    }
    std::printf("the stone rose to %.1f m and came down at %.1f m, %.1f s after the rope was cut\n",
                highest, stone.centreOfMass().x(), world.time() - 1);
    return stone.centreOfMass().x() > 5 && highest > 3 ? 0 : 1;
}
