// Soft bodies do not turn inside out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "helpers.hpp"

namespace sulfur {

namespace {

constexpr std::uint32_t columns = 4, rows = 4;

Blueprint softJelly() {
    return shapes::jelly({.size = {1, 1},
                          .columns = columns,
                          .rows = rows,
                          .mass = 1,
                          .stiffness = 1000,
                          .damping = 5});
}

/// The least area of a half cell of the lattice, as a share of that at rest: negative when it is
/// turned over.
double leastShare(const World& world, const Body& body) {
    const auto at = [&](std::uint32_t column, std::uint32_t row) {
        return world.position(body[row * columns + column]);
    };
    const Blueprint plan = softJelly();
    const Vec2 side = plan.particles[columns + 1].position - plan.particles[0].position;
    double least = 1;
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::array corners{at(column, row), at(column + 1, row), at(column + 1, row + 1),
                                     at(column, row + 1)};
            for (std::size_t i = 0; i < 4; ++i) {
                const auto toNext = corners[(i + 1) % 4] - corners[i];
                const auto toLast = corners[(i + 3) % 4] - corners[i];
                least = std::min(least, static_cast<double>(cross(toNext, toLast)) /
                                            static_cast<double>(side.x() * side.y()));
            }
        }
    return least;
}

struct Motion {
    Eigen::Vector2d momentum{0, 0};
    double angular = 0;
};

/// Of a jelly of 1 kg, about the origin.
Motion motionOf(const World& world, const Body& body) {
    Motion sum;
    const Blueprint plan = softJelly();
    for (std::uint32_t k = 0; k < body.size(); ++k) {
        const auto mass = static_cast<double>(plan.particles[k].mass);
        const Eigen::Vector2d x = world.position(body[k]).cast<double>();
        const Eigen::Vector2d v = world.velocity(body[k]).cast<double>();
        sum.momentum += mass * v;
        sum.angular += mass * cross(x, v);
    }
    return sum;
}

TEST(Areas, AJellySqueezedToATenthHasItsShapeAgain) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body jelly = world.add(softJelly(), {.position = {0, 0.6}});
    Blueprint plate = shapes::floor({-4, 0}, {4, 0});
    plate.kind = BodyKind::kinematic;
    const Body lid = world.add(plate, {.position = {0, 1.5}});
    std::uint32_t pressed = 0;
    for (double height = 1.5; height > 0.15; height -= 0.002) {
        world.moveTo(lid, {.position = {0, height}});
        world.step();
        pressed = std::max(pressed, world.statistics().pressedTriangles);
    }
    EXPECT_GT(pressed, 0u);
    world.remove(lid);
    test::run(world, 8);  // it springs up, and then trembles for some seconds
    EXPECT_GT(leastShare(world, jelly), 0.95);
    EXPECT_EQ(world.statistics().pressedTriangles, 0u);
}

/// Each corner and each inner particle in turn is pushed through the cell beyond it.
TEST(Areas, ACornerPushedThroughComesBack) {
    for (const std::uint32_t which : {0u, columns - 1, columns + 1, columns * rows - 1}) {
        World world({.gravity = {0, 0}});
        const Body jelly = world.add(softJelly());
        const auto place = world.position(jelly[which]);
        world.setPosition(jelly[which], -place);
        ASSERT_LT(leastShare(world, jelly), 0);
        const double energy = world.energy();
        double most = 0;
        for (int i = 0; i < 2000; ++i) {
            world.step();
            most = std::max(most, world.energy());
        }
        EXPECT_GT(leastShare(world, jelly), 0.9) << which;
        EXPECT_LE(most, energy * 1.01) << which;
    }
}

/// A corner is shot inwards, past the barrier that its springs are.
TEST(Areas, MomentumStaysAndNoEnergyComes) {
    for (const int rate : {500, 240, 120}) {
        World world({.gravity = {0, 0}, .tickRate = rate});
        const Body jelly = world.add(softJelly());
        world.setVelocity(jelly, {3, 2});
        world.setVelocity(jelly[0], Vec2(300, 200));
        world.step();
        const Motion before = motionOf(world, jelly);
        const double energy = world.energy();
        std::uint32_t pressed = world.statistics().pressedTriangles;
        double most = 0, least = 1;
        for (int i = 0; i < rate; ++i) {
            world.step();
            pressed = std::max(pressed, world.statistics().pressedTriangles);
            most = std::max(most, world.energy());
            least = std::min(least, leastShare(world, jelly));
        }
        const Motion after = motionOf(world, jelly);
        EXPECT_GT(pressed, 0u) << rate;
        EXPECT_GT(least, 0) << rate;
        EXPECT_LE(most, energy * 1.001) << rate;
        EXPECT_LT((after.momentum - before.momentum).norm(), 1e-5 * before.momentum.norm()) << rate;
        EXPECT_NEAR(after.angular, before.angular, 0.01 * before.momentum.norm()) << rate;
        EXPECT_GT(leastShare(world, jelly), 0.8) << rate;
    }
}

TEST(Areas, NothingIsDoneWhereNothingIsPressed) {
    World world({.gravity = {0, 0}});
    world.add(softJelly());
    world.step();
    EXPECT_EQ(world.statistics().triangles, 4 * (columns - 1) * (rows - 1));
    EXPECT_EQ(world.statistics().pressedTriangles, 0u);
    EXPECT_EQ(world.statistics().items[static_cast<std::size_t>(Stage::constraints)],
              world.statistics().sweptJoints);
}

TEST(Areas, OnlySoftTrianglesCount) {
    World world({.gravity = {0, 0}});
    world.add(shapes::box());
    world.add(shapes::rope({.from = {3, 0}, .to = {5, 0}}));
    Blueprint flat;
    for (const float x : {0.0f, 1.0f, 2.0f})
        flat.particles.push_back({.position = {Real(x), 9}, .mass = 1});
    for (const auto& [a, b] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(0u, 2u)})
        flat.joints.push_back({.a = a, .b = b, .stiffness = 100});
    world.add(flat);
    world.step();
    EXPECT_EQ(world.statistics().triangles, 0u);
}

/// An edge of the outline has the two halves of its one cell.
TEST(Areas, AJointThatGoesTakesItsTrianglesWithIt) {
    World world({.gravity = {0, 0}});
    const Body jelly = world.add(softJelly());
    world.step();
    const auto before = world.statistics().triangles;
    world.remove(jelly.joints()[0]);
    world.step();
    EXPECT_EQ(world.statistics().triangles, before - 2);
}

TEST(Areas, ARestoredWorldGoesOnToTheBit) {
    World world({.gravity = {0, 0}});
    const Body jelly = world.add(softJelly());
    world.setVelocity(jelly[0], Vec2(300, 200));
    while (world.statistics().pressedTriangles == 0 && world.time() < 1) world.step();
    ASSERT_GT(world.statistics().pressedTriangles, 0u);
    World other;
    other.restore(world.snapshot());
    for (int i = 0; i < 50; ++i) {
        world.step();
        other.step();
    }
    EXPECT_EQ(world.hash(), other.hash());
}

}  // namespace

}  // namespace sulfur
