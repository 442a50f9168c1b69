// Mechanisms made through the C interface, beside the same made in C++.
#include <sulfur/c/sulfur.h>

#include "../helpers.hpp"

namespace sulfur {
namespace {

/// What World::hash() covers of mechanisms: the same made in C and in C++ have the same bits.
struct Mechanisms : testing::Test {
    World world;
    SulfurWorld* other = nullptr;
    BodyId bodies[3];
    SulfurBodyId ids[3];
    SulfurMechanismId made{};
    const Drive drive{.lower = -2,
                      .upper = 3,
                      .stiffness = 5000,
                      .damping = 7,
                      .rest = Real(0.25),
                      .motorSpeed = 11,
                      .motorMax = 13,
                      .motorTarget = Real(0.5),
                      .strength = 1700};
    static constexpr SulfurDrive driveInC{-2, 3, 5000, 7, 0.25, 11, 13, true, 0.5, 1700};

    Mechanisms() {
        SulfurBlueprint* crate = nullptr;
        EXPECT_EQ(sulfur_world_create(nullptr, &other), SULFUR_OK);
        EXPECT_EQ(sulfur_shape_box(nullptr, &crate), SULFUR_OK);
        for (int i = 0; i < 3; ++i) {
            bodies[i] = world.add(shapes::box(), {.position = {2 * i, 0}});
            EXPECT_EQ(sulfur_world_add_body(other, crate, {{2.0 * i, 0}, 0}, &ids[i]), SULFUR_OK);
        }
        sulfur_blueprint_destroy(crate);
    }
    ~Mechanisms() override { sulfur_world_destroy(other); }

    void expectSame(SulfurResult result) {
        ASSERT_EQ(result, SULFUR_OK) << sulfur_last_error();
        for (int i = 0; i < 20; ++i) {
            std::uint64_t hash = 0;
            EXPECT_EQ(sulfur_world_hash(other, &hash), SULFUR_OK);
            ASSERT_EQ(hash, world.hash()) << i;
            EXPECT_EQ(sulfur_world_step(other), SULFUR_OK);
            world.step();
        }
    }
};

TEST_F(Mechanisms, Hinges) {
    const SulfurHingeOptions options{driveInC, true, true, 19000, 0.25};
    world.hinge(bodies[0], bodies[1], {1, 0},
                {.drive = drive, .collide = true, .pin = true, .strength = 19000, .value = 0.25});
    expectSame(sulfur_world_hinge(other, ids[0], ids[1], {1, 0}, &options, &made));
    SulfurHingeOptions loose = sulfur_hinge_options_default();
    loose.pin = false;
    world.hinge(bodies[0], bodies[2], {2, 0}, {.pin = false});
    expectSame(sulfur_world_hinge(other, ids[0], ids[2], {2, 0}, &loose, &made));
}

TEST_F(Mechanisms, Welds) {
    const SulfurWeldOptions options{5000, 7, true, 19000, 2300, -0.5};
    world.weld(bodies[0], bodies[1], {1, 0},
               {.stiffness = 5000,
                .damping = 7,
                .collide = true,
                .strength = 19000,
                .torqueStrength = 2300,
                .value = -0.5});
    expectSame(sulfur_world_weld(other, ids[0], ids[1], {1, 0}, &options, &made));
}

TEST_F(Mechanisms, Sliders) {
    const SulfurSliderOptions options{driveInC, true, false, 0.75};
    world.slider(bodies[0], bodies[1], {1, 0}, {1, 2},
                 {.drive = drive, .collide = true, .turns = false, .value = 0.75});
    expectSame(sulfur_world_slider(other, ids[0], ids[1], {1, 0}, {1, 2}, &options, &made));
}

TEST_F(Mechanisms, SlidersOnRails) {
    const SulfurSliderOptions options{driveInC, true, true, 0.75};
    const JointId link = world.joints(bodies[0])[0];
    const Point at = world.position(world.info(link).a);
    const MechanismId slider = world.slider(bodies[0], bodies[1], at, std::vector{link},
                                            {.drive = drive, .collide = true, .value = 0.75});
    const SulfurJointId rail{link.index, link.generation};
    ASSERT_EQ(sulfur_world_slider_on_rail(other, ids[0], ids[1], {at.x(), at.y()}, nullptr, 1,
                                          &options, &made),
              SULFUR_NULL_POINTER);
    const SulfurResult result = sulfur_world_slider_on_rail(other, ids[0], ids[1], {at.x(), at.y()},
                                                            &rail, 1, &options, &made);
    SulfurJointId links[2] = {};
    std::size_t count = 0;
    ASSERT_EQ(sulfur_mechanism_rail(other, made, links, 2, &count), SULFUR_OK);
    EXPECT_EQ(count, 1u);
    EXPECT_EQ(links[0].index, link.index);
    SulfurMechanismInfo info{};
    ASSERT_EQ(sulfur_mechanism_info(other, made, &info), SULFUR_OK);
    EXPECT_EQ(info.rail_begin, world.info(slider).railBegin);
    EXPECT_EQ(info.rail_begin, 0.75);
    expectSame(result);
}

TEST_F(Mechanisms, Wheels) {
    SulfurWheelMechanismOptions options = sulfur_wheel_mechanism_options_default();
    options.spring = driveInC;
    options.motor.motor_speed = 3;
    options.motor.motor_max = 5;
    SulfurWheelIds wheel{};
    world.wheel(bodies[0], bodies[1], {2, 0}, {0, 1},
                {.spring = drive, .motor = {.motorSpeed = 3, .motorMax = 5}});
    expectSame(sulfur_world_wheel(other, ids[0], ids[1], {2, 0}, {0, 1}, &options, &wheel));
}

TEST_F(Mechanisms, Distances) {
    const SulfurDistanceOptions options{driveInC, false};
    world.distance(bodies[0], {0, 0}, bodies[1], {2, 0.25}, {.drive = drive, .collide = false});
    expectSame(sulfur_world_distance(other, ids[0], {0, 0}, ids[1], {2, 0.25}, &options, &made));
}

TEST_F(Mechanisms, Pulleys) {
    const SulfurPulleyOptions options{2, true, 3.5, 19000};
    world.pulley(bodies[0], {0, 0}, {2, 0.25}, bodies[2], {4, 0}, {2, -0.25}, bodies[1],
                 {.ratio = 2, .length = Real(3.5), .strength = 19000});
    expectSame(sulfur_world_pulley(other, ids[0], {0, 0}, {2, 0.25}, ids[2], {4, 0}, {2, -0.25},
                                   ids[1], &options, &made));
}

}  // namespace
}  // namespace sulfur
