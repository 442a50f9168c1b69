// Atwood's machine: two weights hang on a rope over a pulley. The rope is a line of rigid links
// with a surface, the pulley is a disc on an axle, and nothing but their friction turns it. The
// weights gain speed as the textbook has it, with the inertia of the disc.
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-2.4, -0.25}, {2.4, 4.3});
    constexpr double radius = 0.5, thickness = 0.03, height = 3.5;  // m
    constexpr double heavy = 10, light = 8, disc = 4, ropes = 0.5;  // kg

    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body axle =
        world.add({.kind = BodyKind::fixed, .particles = {{.position = {0, height}}}});
    const Body pulley =
        world.add(shapes::ball({.radius = radius, .mass = disc}), {.position = {0, height}});
    world.attach(pulley.front(), axle, {0, 0});

    // The rope goes up on the left, round the upper half of the pulley, and down on the right.
    constexpr double bend = radius + thickness / 2, side = 1.6, pi = 3.14159265358979;
    constexpr int links = 80;
    Blueprint rope{.name = "rope"};
    for (int i = 0; i <= links; ++i) {
        const double s = (2 * side + pi * bend) * i / links - side - pi * bend / 2;  // 0 at the top
        const double angle = s / bend;
        const double hang = std::abs(s) - pi * bend / 2;
        const Point place = hang > 0
                                ? Point(std::copysign(bend, s), height - hang)
                                : Point(bend * std::sin(angle), height + bend * std::cos(angle));
        rope.particles.push_back({.position = place.cast<Real>(), .mass = ropes / links});
        if (i > 0)
            rope.joints.push_back(
                {.a = std::uint32_t(i - 1), .b = std::uint32_t(i), .radius = thickness / 2});
    }
    rope.particles.front().mass = light;
    rope.particles.front().radius = 0.2;
    rope.particles.back().mass = heavy;
    rope.particles.back().radius = 0.22;
    const Body weights = world.add(rope);
    picture.take(world, 0.3);

    while (world.time() < 1) world.step();
    picture.take(world);
    const double speed = world.velocity(weights.front()).y();
    const double rim = -pulley.angularVelocity() * bend;  // where the rope's axis runs
    constexpr double lever = radius / bend;
    const double expected =
        9.81 * (heavy - light) / (heavy + light + ropes + disc / 2 * lever * lever) * world.time();
    std::printf(
        "the light weight rises at %.3f m/s, expected %.3f; the pulley runs below it at %.3f m/s\n",
        speed, expected, rim);
    const auto isRight = [&](double v) { return std::abs(v - expected) < 0.03 * expected; };
    return isRight(speed) && isRight(rim) ? 0 : 1;
}
