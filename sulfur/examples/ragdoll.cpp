// A ragdoll falls down a flight of stairs. It is one blueprint: a particle for every joint of the
// body, a capsule for every limb between them, and a disc for the head. Limbs that share a particle
// turn about it, so that hinges need nothing more; the triangle of the chest keeps its shape.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

sulfur::Blueprint ragdoll() {
    enum {
        head,
        neck,
        leftShoulder,
        rightShoulder,
        hip,
        leftElbow,
        rightElbow,
        leftHand,
        rightHand,
        leftKnee,
        rightKnee,
        leftFoot,
        rightFoot
    };
    sulfur::Blueprint plan{.name = "ragdoll"};
    plan.particles = {{.position = {0, 1.7}, .mass = 5, .radius = 0.12},
                      {.position = {0, 1.5}, .mass = 5},
                      {.position = {-0.18, 1.45}, .mass = 8},
                      {.position = {0.18, 1.45}, .mass = 8},
                      {.position = {0, 0.95}, .mass = 20},
                      {.position = {-0.3, 1.2}, .mass = 2},
                      {.position = {0.3, 1.2}, .mass = 2},
                      {.position = {-0.4, 0.95}, .mass = 1},
                      {.position = {0.4, 0.95}, .mass = 1},
                      {.position = {-0.12, 0.5}, .mass = 6},
                      {.position = {0.12, 0.5}, .mass = 6},
                      {.position = {-0.15, 0.05}, .mass = 3},
                      {.position = {0.15, 0.05}, .mass = 3}};
    const auto limb = [&](std::uint32_t a, std::uint32_t b, sulfur::Real radius) {
        plan.joints.push_back({.a = a, .b = b, .radius = radius});
    };
    limb(neck, leftShoulder, 0.07f);  // chest
    limb(neck, rightShoulder, 0.07f);
    limb(leftShoulder, hip, 0.09f);
    limb(rightShoulder, hip, 0.09f);
    limb(neck, hip, 0.09f);
    limb(neck, head, 0.05f);
    limb(leftShoulder, leftElbow, 0.05f);
    limb(leftElbow, leftHand, 0.04f);
    limb(rightShoulder, rightElbow, 0.05f);
    limb(rightElbow, rightHand, 0.04f);
    limb(hip, leftKnee, 0.07f);
    limb(leftKnee, leftFoot, 0.05f);
    limb(hip, rightKnee, 0.07f);
    limb(rightKnee, rightFoot, 0.05f);
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

    double stretch = 0, late = 0;  // of limbs, m; of the whole body in the last second, m
    Point before(0, 0);
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
    late = (doll.centreOfMass() - before).norm();

    std::printf(
        "it fell to %.2f m, %.2f m from the edge; limbs stretched by %.1f mm; in the last second "
        "it moved "
        "%.1f mm\n",
        doll.centreOfMass().y(), doll.centreOfMass().x(), 1000 * stretch, 1000 * late);
    return doll.centreOfMass().y() < 1 && stretch < 0.02 && late < 0.02 ? 0 : 1;
}
