// A belt carries crates over a hatch, which the light ones pass and the heavy ones fall through.
// The belt is a surface with a speed of its own (Material::surfaceSpeed): it is the same for all,
// so that nobody needs to be asked. Who falls depends on whom the hatch meets, and that a callback
// says, once for each crate that comes near it.
#include <array>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "picture.hpp"

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-4.4, -0.3}, {6.4, 3.5});

    constexpr double speed = 1.2, height = 2.2;  // m/s, m
    World world;
    const auto belt = [&](double from, double to) {
        Blueprint plan = shapes::box({.size = {static_cast<Real>(to - from), Real(0.2)}});
        plan.kind = BodyKind::fixed;
        plan.material.surfaceSpeed = static_cast<Real>(speed);
        return world.add(plan, {.position = {(from + to) / 2, height - 0.1}});
    };
    belt(-4, 0);
    const BodyId hatch = belt(0, 1.4);
    belt(1.4, 3.6);
    picture.paint(hatch, "gold");
    constexpr double width = 2.7, underHatch = -0.2, underEnd = 3.4;  // m, of two bins
    for (const double left : {underHatch, underEnd})
        world.add(shapes::ground({.points = {{0, Real(1.4)},
                                             {0, 0},
                                             {static_cast<Real>(width), 0},
                                             {static_cast<Real>(width), Real(1.4)}}}),
                  {.position = {left, 0}});

    constexpr Real limit = 5;  // kg
    world.setShouldCollide([&](BodyId a, BodyId b) {
        if (a != hatch && b != hatch) return true;
        return world.mass(a == hatch ? b : a) < limit;
    });

    const std::array<Real, 6> masses{2, 8, 3, 4, 9, 6};  // kg
    std::vector<Body> crates;
    double carried = 0;  // m/s
    while (world.time() < 20) {
        if (world.ticks() % 650 == 0 && crates.size() < 12) {
            const Real mass = masses[crates.size() % masses.size()];
            crates.push_back(world.add(shapes::box({.size = {Real(0.5), Real(0.5)}, .mass = mass}),
                                       {.position = {-3.7, height + 0.26}}));
            picture.paint(crates.back(), mass < limit ? "blue" : "red");
        }
        world.step();
        if (world.time() < 2) carried = static_cast<double>(crates.front().meanVelocity().x());
        if (world.ticks() == 7700) picture.take(world);
    }

    int fallen = 0, passed = 0, astray = 0;
    for (const Body crate : crates) {
        const Point place = crate.centreOfMass();
        const double bin = crate.mass() < limit ? underEnd : underHatch;
        const bool sorted = place.y() < 1.5 && place.x() > bin && place.x() < bin + width;
        if (!sorted)
            ++astray;
        else if (crate.mass() < limit)
            ++passed;
        else
            ++fallen;
    }
    std::printf("carried at %.3f m/s; %d heavy crates fell, %d light ones passed, %d are astray\n",
                carried, fallen, passed, astray);
    return fallen == 6 && passed == 6 && astray == 0 && std::abs(carried - speed) < 0.01 ? 0 : 1;
}
