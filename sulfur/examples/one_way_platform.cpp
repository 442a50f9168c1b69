// Three balls are thrown up through platforms, each with another speed. A callback that is asked
// about each contact before it is solved lets them through from below, and holds them when they
// come back from above: each comes to rest on the highest platform that its speed lets it pass.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-3.2, -0.3}, {3.2, 4.9});

    World world;
    constexpr double storey = 1.2, thickness = 0.1, radius = 0.2;  // m
    world.add(shapes::floor({-3, 0}, {3, 0}));
    std::array<BodyId, 3> platforms;
    Blueprint plan = shapes::box({.size = {6, static_cast<Real>(thickness)}});
    plan.kind = BodyKind::fixed;
    for (std::size_t i = 0; i < 3; ++i)
        platforms[i] = world.add(plan, {.position = {0, storey * static_cast<double>(i + 1)}}).id();

    // Whether a platform holds follows from where the other body is as a whole: so it is whatever
    // the body's speed and shape.
    world.setPreSolve([&](const PreSolveContact& contact, Material&) {
        const auto isPlatform = [&](BodyId body) {
            return std::find(platforms.begin(), platforms.end(), body) != platforms.end();
        };
        if (isPlatform(contact.a) == isPlatform(contact.b)) return true;
        const bool first = isPlatform(contact.a);
        const BodyId platform = first ? contact.a : contact.b;
        const BodyId other = first ? contact.b : contact.a;
        return world.bounds(other).low.y() > world.centreOfMass(platform).y();
    });

    std::array<Body, 3> balls;
    const std::array<double, 3> speeds{5.5, 7.3, 8.8};  // m/s
    for (std::size_t i = 0; i < 3; ++i) {
        balls[i] = world.add(shapes::ball({.radius = static_cast<Real>(radius)}),
                             {.position = {1.7 * static_cast<double>(i) - 2.2, 0.3}});
        balls[i].setVelocity({Real(0.4), static_cast<Real>(speeds[i])});
        balls[i].setDamping(0, 10);  // what rolls comes to rest, what flies is not braked
    }
    picture.take(world, 0.25);
    std::array<double, 3> tops{};
    while (world.time() < 6) {
        world.step();
        for (std::size_t i = 0; i < 3; ++i) {
            tops[i] = std::max(tops[i], balls[i].centreOfMass().y());
            if (world.ticks() % 25 == 0 && !world.asleep(balls[i]))
                picture.dot(balls[i].centreOfMass());
        }
    }
    picture.take(world);

    bool right = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const double reach = 0.3 + speeds[i] * speeds[i] / (2 * 9.81);  // as if there was nothing
        const double lies = storey * static_cast<double>(i + 1) + thickness / 2 + radius;
        const double height = balls[i].centreOfMass().y();
        std::printf("%.1f m/s: up to %.2f m, then at %.2f m\n", speeds[i], tops[i], height);
        right = right && std::abs(tops[i] - reach) < 0.02 && std::abs(height - lies) < 0.005 &&
                world.asleep(balls[i]);
    }
    return right ? 0 : 1;
}
