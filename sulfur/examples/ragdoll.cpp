// A ragdoll falls down a flight of stairs. It is one blueprint: a particle for every joint of the
// body, a capsule for every limb between them, and a disc for the head. Limbs that share a particle
// turn about it, so that hinges need nothing more; the triangle of the chest keeps its shape.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

sulfur::Blueprint ragdoll() {
    using sulfur::Real;
    sulfur::Blueprint plan{.name = "ragdoll"};
    const auto at = [&](Real x, Real y, Real mass) {
        plan.particles.push_back({.position = {x, y}, .mass = mass});
        return static_cast<std::uint32_t>(plan.particles.size() - 1);
    };
    const auto limb = [&](std::uint32_t a, std::uint32_t b, Real radius) {
        plan.joints.push_back({.a = a, .b = b, .radius = radius});
    };
    const auto head = at(0, 1.7f, 5), neck = at(0, 1.5f, 5), hip = at(0, 0.95f, 20);
    plan.particles[head].radius = 0.12f;
    limb(head, neck, 0.05f);
    limb(neck, hip, 0.09f);
    for (const Real side : {-1.f, 1.f}) {
        const auto shoulder = at(0.18f * side, 1.45f, 8), elbow = at(0.3f * side, 1.2f, 2);
        const auto hand = at(0.4f * side, 0.95f, 1);
        limb(neck, shoulder, 0.07f);
        limb(shoulder, hip, 0.09f);
        limb(shoulder, elbow, 0.05f);
        limb(elbow, hand, 0.04f);
        const auto knee = at(0.12f * side, 0.5f, 6), foot = at(0.15f * side, 0.05f, 3);
        limb(hip, knee, 0.07f);
        limb(knee, foot, 0.05f);
    }
    return plan;
}

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-2, -0.3}, {6.4, 4.8});

    World world;
    shapes::GroundOptions stairs{.points = {{-4, 2.4}, {0, 2.4}}};
    for (int step = 1; step <= 8; ++step) {
        const Real x = 0.45f * static_cast<Real>(step - 1),
                   y = 2.4f - 0.3f * static_cast<Real>(step);
        stairs.points.insert(stairs.points.end(), {{x, y}, {x + 0.45f, y}});
    }
    stairs.points.push_back({12, 0});
    world.add(shapes::ground(stairs));
    const Body doll = world.add(ragdoll(), {.position = {-0.6, 2.5}});
    picture.paint(doll, "orange");
    doll.setVelocity({2.2, 0}, -1);

    double stretch = 0;  // m, the most that a limb is longer or shorter than it should be
    Point before(0, 0);  // where it lies a second before the end
    for (const unsigned tick : {1u, 400u, 700u, 1100u, 4000u}) {
        while (world.ticks() < tick) {
            world.step();
            for (const JointId limb : doll.joints()) {
                const JointInfo info = world.info(limb);
                const double length = (world.position(info.a) - world.position(info.b)).norm();
                stretch = std::max(stretch, std::abs(length - info.restLength));
            }
            if (world.ticks() == 3500) before = doll.centreOfMass();
        }
        picture.take(world, tick == 4000 ? 1 : 0.45);
    }

    const Point end = doll.centreOfMass();
    const double late = (end - before).norm();
    std::printf(
        "it lies %.2f m from the edge at %.2f m; limbs stretched by up to %.1f mm; in the "
        "last second it moved by %.1f mm\n",
        end.x(), end.y(), 1000 * stretch, 1000 * late);
    return end.y() < 1 && stretch < 0.02 && late < 0.02 ? 0 : 1;
}
