// A diving board of rigid links with an elastic angle between each two (AngularJointSpec) bends
// under a crate as the beam of Euler and Bernoulli does. Then a rope pulls it down and is cut, and
// the board throws the crate up.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sulfur/sulfur.hpp>

#include "picture.hpp"

namespace {

constexpr std::uint32_t links = 15;
constexpr double length = 3, link = length / links;  // m
constexpr double rigidity = 7500;                    // E I in N m^2

/// A board that lies along x from the origin, where it is clamped: its first link, to the left of
/// it, is held. Between two links an angle has the stiffness E I over the length of a link, at the
/// clamp twice that, because half a link bends there: the error goes with the square of that
/// length. Damping makes the swinging of a light board die away.
sulfur::Blueprint board() {
    using sulfur::Real;
    sulfur::Blueprint plan{.name = "board"};
    for (std::uint32_t i = 0; i < links + 2; ++i)
        plan.particles.push_back({.position = {static_cast<Real>(link * (i - 1.0)), 0},
                                  .mass = Real(0.2),
                                  .pinned = i < 2});
    for (std::uint32_t i = 0; i <= links; ++i)
        plan.joints.push_back({.a = i, .b = i + 1, .radius = Real(0.04)});
    for (std::uint32_t i = 0; i < links; ++i) {
        const double stiffness = (i == 0 ? 2 : 1) * rigidity / link;
        plan.angles.push_back({.a = i,
                               .b = i + 1,
                               .c = i + 2,
                               .stiffness = static_cast<Real>(stiffness),
                               .damping = static_cast<Real>(0.03 * stiffness)});
    }
    return plan;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace sulfur;
    Picture picture(argc, argv, {-0.8, -0.3}, {6.2, 4.3});

    World world;
    constexpr double height = 1.4, mass = 8, g = 9.81;  // m, kg, m/s^2
    world.add(shapes::floor({-2, 0}, {10, 0}));
    const Body springy = world.add(board(), {.position = {0, height}});
    picture.paint(springy, "gold");
    const auto tip = [&] { return world.position(springy.back()).y(); };
    while (world.time() < 3) world.step();
    const double alone = tip();  // bent by its own weight

    const Body crate = world.add(shapes::box({.size = {Real(0.4), Real(0.4)}, .mass = Real(mass)}),
                                 {.position = {2.7, alone + 0.25}});
    picture.paint(crate, "red");
    while (world.time() < 10) world.step();
    picture.take(world, 0.3);
    // What the crate presses with goes down through its centre of mass, at x = a. A clamped beam
    // gives way by F a^2 (3 L - a) / (6 E I) at its end.
    const double a = crate.centreOfMass().x();
    const double expected = mass * g * a * a * (3 * length - a) / (6 * rigidity);
    const double sag = alone - tip();
    std::printf("the crate bends it by %.1f mm, expected %.1f\n", 1000 * sag, 1000 * expected);

    const Body anchor = world.add({.kind = BodyKind::fixed, .particles = {{.position = {3, 0}}}});
    const JointId rope = world.connect(anchor.front(), springy.back());
    const double start = world.time(), atRest = tip();
    while (world.time() < start + 2) {
        const double pulled = 0.8 * (world.time() - start) / 2;
        world.setRestLength(rope, static_cast<Real>(atRest - pulled));
        world.step();
    }
    picture.take(world, 0.5);
    world.remove(rope);

    const double low = crate.centreOfMass().y();
    double top = low;
    for (int tick = 1; tick <= 360; ++tick) {
        world.step();
        top = std::max(top, crate.centreOfMass().y());
        if (tick % 20 == 0) picture.dot(crate.centreOfMass());
    }
    picture.take(world);
    std::printf("cut loose, it throws the crate up by %.2f m\n", top - low);
    return std::abs(sag - expected) < 0.02 * expected && top - low > 1.5 ? 0 : 1;
}
