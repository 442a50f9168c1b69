// Runs the checks that are written in C, and holds a scene made in C against the same in C++.
#include "../helpers.hpp"
#include "checks.h"

namespace sulfur {
namespace {

/// The scene of scene.c.
std::vector<Body> makeScene(World& world) {
    Material rough;
    rough.staticFriction = Real(0.75);
    world.add(shapes::ground({.points = {{-8, 9}, {-8, 0}, {8, 0}, {8, 9}}, .material = rough}));
    std::vector<Body> crates;
    for (int i = 0; i < 5; ++i)
        crates.push_back(
            world.add(shapes::box(), {.position = {-5, 0.6 + 1.1 * i}, .angle = 0.05 * i}));
    world.setUserData(crates[2], 99);
    const Body rope = world.add(shapes::rope({.from = {-2, 8}, .to = {1, 8}, .pinFirst = true}));
    const Body load = world.add(shapes::box({.size = {Real(0.75), Real(0.5)}, .mass = 5}),
                                {.position = {1, 7.75}});
    world.attach(rope.back(), load, {0, Real(0.25)});
    const Body jelly = world.add(shapes::jelly(), {.position = {-2, 2}, .angle = 0.25});
    world.add(shapes::wall({.strength = 300}), {.position = {5, 0.6}});
    const Body ball = world.add(shapes::ball(), {.position = {1.5, 1}});
    ball.setVelocity({20, 1}, -3);
    world.add(WindField{.velocity = {2, 0}, .drag = Real(0.125)});
    world.grab(jelly, {Real(0.25), Real(0.25)}, {-2, 4});
    return crates;
}

TEST(CInterface, ASceneMadeInCHasTheBitsOfTheSameInCpp) {
    World world({.gravity = {0, Real(-9.75)}, .airFriction = Real(0.0625)});
    const std::vector<Body> crates = makeScene(world);
    SulfurWorld* other = nullptr;
    SulfurBodyId ids[5];
    ASSERT_STREQ(c_make_scene(&other, ids), nullptr);
    std::uint64_t hash = 0;
    for (int i = 0; i < 500; ++i) {
        world.step();
        ASSERT_EQ(sulfur_world_step(other), SULFUR_OK) << sulfur_last_error();
        ASSERT_EQ(sulfur_world_hash(other, &hash), SULFUR_OK);
        ASSERT_EQ(hash, world.hash()) << i;
    }
    for (std::size_t i = 0; i < 5; ++i) {
        SulfurVec centre{};
        ASSERT_EQ(sulfur_body_centre_of_mass(other, ids[i], &centre), SULFUR_OK);
        EXPECT_EQ(centre.x, crates[i].centreOfMass().x());
        EXPECT_EQ(centre.y, crates[i].centreOfMass().y());
    }
    sulfur_world_destroy(other);
}

TEST(CInterface, Bodies) {
    EXPECT_STREQ(c_check_bodies(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Blueprints) {
    EXPECT_STREQ(c_check_blueprint(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Angles) {
    EXPECT_STREQ(c_check_angles(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Parts) {
    EXPECT_STREQ(c_check_parts(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Mechanisms) {
    EXPECT_STREQ(c_check_mechanisms(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Queries) {
    EXPECT_STREQ(c_check_queries(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Events) {
    EXPECT_STREQ(c_check_events(), nullptr) << sulfur_last_error();
}

TEST(CInterface, State) {
    EXPECT_STREQ(c_check_state(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Draw) {
    EXPECT_STREQ(c_check_draw(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Errors) {
    EXPECT_STREQ(c_check_errors(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Threads) {
    EXPECT_STREQ(c_check_threads(), nullptr) << sulfur_last_error();
}

TEST(CInterface, Callbacks) {
    EXPECT_STREQ(c_check_callbacks(), nullptr) << sulfur_last_error();
}

/// What a callback in C answers arrives as it does in C++.
TEST(CInterface, CallbacksHaveTheBitsOfTheSameInCpp) {
    World world({.gravity = {0, Real(-9.75)}, .airFriction = Real(0.0625)});
    makeScene(world);
    world.setShouldCollide([](BodyId a, BodyId b) { return (a.index + b.index) % 3 != 0; });
    world.setPreSolve([](const PreSolveContact& contact, Material& surface) {
        surface.staticFriction = surface.kineticFriction = Real(0.125);
        surface.surfaceSpeed = contact.gap < Real(0.001) ? contact.speed : Real(1);
        return contact.a.index % 4 != 0;
    });
    SulfurWorld* other = nullptr;
    SulfurBodyId ids[5];
    ASSERT_STREQ(c_make_scene(&other, ids), nullptr);
    sulfur_world_set_should_collide(
        other, [](void*, SulfurBodyId a, SulfurBodyId b) { return (a.index + b.index) % 3 != 0; },
        nullptr);
    sulfur_world_set_pre_solve(
        other,
        [](void*, const SulfurPreSolveContact* contact, SulfurMaterial* surface) {
            surface->static_friction = surface->kinetic_friction = 0.125;
            const bool near = contact->gap < static_cast<double>(Real(0.001));
            surface->surface_speed = near ? contact->speed : 1;
            return contact->a.index % 4 != 0;
        },
        nullptr);
    std::uint64_t hash = 0;
    for (int i = 0; i < 250; ++i) {
        world.step();
        ASSERT_EQ(sulfur_world_step(other), SULFUR_OK) << sulfur_last_error();
        ASSERT_EQ(sulfur_world_hash(other, &hash), SULFUR_OK);
        ASSERT_EQ(hash, world.hash()) << i;
    }
    sulfur_world_destroy(other);
}

/// Expects that a blueprint made in C, which it destroys, makes the same body as one made in C++.
void expectSame(SulfurResult result, SulfurBlueprint*& made, const Blueprint& plan,
                const char* what) {
    ASSERT_EQ(result, SULFUR_OK) << what << ": " << sulfur_last_error();
    World world;
    world.add(plan);
    SulfurWorld* other = nullptr;
    SulfurBodyId id{};
    std::uint64_t hash = 0;
    EXPECT_EQ(sulfur_world_create(nullptr, &other), SULFUR_OK);
    EXPECT_EQ(sulfur_world_add_body(other, made, {}, &id), SULFUR_OK) << sulfur_last_error();
    EXPECT_EQ(sulfur_world_hash(other, &hash), SULFUR_OK);
    EXPECT_EQ(hash, world.hash()) << what;
    sulfur_world_destroy(other);
    sulfur_blueprint_destroy(made);
}

TEST(CInterface, ShapesHaveTheDefaultsOfCpp) {
    SulfurBlueprint* made = nullptr;
#define EXPECT_SAME(shape)                                                                  \
    {                                                                                       \
        const auto options = sulfur_##shape##_options_default();                            \
        expectSame(sulfur_shape_##shape(&options, &made), made, shapes::shape({}), #shape); \
        expectSame(sulfur_shape_##shape(nullptr, &made), made, shapes::shape({}), #shape);  \
    }
    EXPECT_SAME(box)
    EXPECT_SAME(ball)
    EXPECT_SAME(wheel)
    EXPECT_SAME(rope)
    EXPECT_SAME(chain)
    EXPECT_SAME(bridge)
    EXPECT_SAME(jelly)
    EXPECT_SAME(cloth)
    EXPECT_SAME(wall)
    EXPECT_SAME(blob)
#undef EXPECT_SAME
}

// Every option arrives where it belongs.

constexpr SulfurVec corners[3] = {{0, 0}, {2, 0}, {1, 3}};
const std::vector<Vec2> points{{0, 0}, {2, 0}, {1, 3}};
constexpr SulfurMaterial surface{0.75, 0.25, 0.5, 3, 0.125};
const Material material{Real(0.75), Real(0.25), Real(0.5), 3, Real(0.125)};

TEST(CInterfaceShapes, Ground) {
    SulfurBlueprint* made = nullptr;
    SulfurGroundOptions ground = sulfur_ground_options_default();
    ground.points = corners;
    ground.point_count = 3;
    ground.closed = true;
    ground.radius = 0.125;
    ground.material = surface;
    expectSame(sulfur_shape_ground(&ground, &made), made,
               shapes::ground(
                   {.points = points, .closed = true, .radius = Real(0.125), .material = material}),
               "ground");
}

TEST(CInterfaceShapes, Box) {
    SulfurBlueprint* made = nullptr;
    SulfurBoxOptions box = sulfur_box_options_default();
    box.size = {2, 1};
    box.mass = 3;
    box.radius = 0.0625;
    box.stiffness = 5000;
    box.damping = 2;
    box.strength = 700;
    box.solid_inertia = false;
    box.material = surface;
    expectSame(sulfur_shape_box(&box, &made), made,
               shapes::box({.size = {2, 1},
                            .mass = 3,
                            .radius = Real(0.0625),
                            .stiffness = 5000,
                            .damping = 2,
                            .strength = 700,
                            .solidInertia = false,
                            .material = material}),
               "box");
}

TEST(CInterfaceShapes, Polygon) {
    SulfurBlueprint* made = nullptr;
    SulfurPolygonOptions polygon = sulfur_polygon_options_default();
    polygon.points = corners;
    polygon.point_count = 3;
    polygon.mass = 3;
    polygon.radius = 0.0625;
    polygon.stiffness = 5000;
    polygon.damping = 2;
    polygon.strength = 700;
    polygon.material = surface;
    expectSame(sulfur_shape_polygon(&polygon, &made), made,
               shapes::polygon({.points = points,
                                .mass = 3,
                                .radius = Real(0.0625),
                                .stiffness = 5000,
                                .damping = 2,
                                .strength = 700,
                                .material = material}),
               "polygon");
}

TEST(CInterfaceShapes, Ball) {
    SulfurBlueprint* made = nullptr;
    SulfurBallOptions ball = sulfur_ball_options_default();
    ball.radius = 0.5;
    ball.mass = 3;
    ball.material = surface;
    expectSame(sulfur_shape_ball(&ball, &made), made,
               shapes::ball({.radius = Real(0.5), .mass = 3, .material = material}), "ball");
}

TEST(CInterfaceShapes, Wheel) {
    SulfurBlueprint* made = nullptr;
    SulfurWheelOptions wheel = sulfur_wheel_options_default();
    wheel.radius = 0.75;
    wheel.segments = 9;
    wheel.mass = 3;
    wheel.rim_radius = 0.0625;
    wheel.spoke_stiffness = 5000;
    wheel.spoke_damping = 2;
    wheel.strength = 700;
    wheel.material = surface;
    expectSame(sulfur_shape_wheel(&wheel, &made), made,
               shapes::wheel({.radius = Real(0.75),
                              .segments = 9,
                              .mass = 3,
                              .rimRadius = Real(0.0625),
                              .spokeStiffness = 5000,
                              .spokeDamping = 2,
                              .strength = 700,
                              .material = material}),
               "wheel");
}

TEST(CInterfaceShapes, Rope) {
    SulfurBlueprint* made = nullptr;
    SulfurRopeOptions rope = sulfur_rope_options_default();
    rope.from = {1, 2};
    rope.to = {3, 4};
    rope.links = 9;
    rope.has_slack = true;
    rope.slack = 0.25;
    rope.mass = 3;
    rope.radius = 0.0625;
    rope.stiffness = 5000;
    rope.damping = 2;
    rope.bending = 0.25;
    rope.strength = 700;
    rope.pin_first = true;
    rope.material = surface;
    expectSame(sulfur_shape_rope(&rope, &made), made,
               shapes::rope({.from = {1, 2},
                             .to = {3, 4},
                             .links = 9,
                             .slack = Real(0.25),
                             .mass = 3,
                             .radius = Real(0.0625),
                             .stiffness = 5000,
                             .damping = 2,
                             .bending = Real(0.25),
                             .strength = 700,
                             .pinFirst = true,
                             .material = material}),
               "rope");
}

TEST(CInterfaceShapes, Chain) {
    SulfurBlueprint* made = nullptr;
    SulfurChainOptions chain = sulfur_chain_options_default();
    chain.from = {1, 2};
    chain.to = {3, 4};
    chain.links = 9;
    chain.mass = 3;
    chain.radius = 0.0625;
    chain.strength = 700;
    chain.pin_last = true;
    chain.material = surface;
    expectSame(sulfur_shape_chain(&chain, &made), made,
               shapes::chain({.from = {1, 2},
                              .to = {3, 4},
                              .links = 9,
                              .mass = 3,
                              .radius = Real(0.0625),
                              .strength = 700,
                              .pinLast = true,
                              .material = material}),
               "chain");
}

TEST(CInterfaceShapes, Bridge) {
    SulfurBlueprint* made = nullptr;
    SulfurBridgeOptions bridge = sulfur_bridge_options_default();
    bridge.from = {1, 2};
    bridge.to = {5, 3};
    bridge.planks = 7;
    bridge.sag = 0.5;
    bridge.mass = 3;
    bridge.radius = 0.0625;
    bridge.stiffness = 5000;
    bridge.damping = 2;
    bridge.strength = 700;
    bridge.material = surface;
    expectSame(sulfur_shape_bridge(&bridge, &made), made,
               shapes::bridge({.from = {1, 2},
                               .to = {5, 3},
                               .planks = 7,
                               .sag = Real(0.5),
                               .mass = 3,
                               .radius = Real(0.0625),
                               .stiffness = 5000,
                               .damping = 2,
                               .strength = 700,
                               .material = material}),
               "bridge");
}

TEST(CInterfaceShapes, Jelly) {
    SulfurBlueprint* made = nullptr;
    SulfurJellyOptions jelly = sulfur_jelly_options_default();
    jelly.size = {2, 1};
    jelly.columns = 5;
    jelly.rows = 3;
    jelly.mass = 3;
    jelly.radius = 0.0625;
    jelly.stiffness = 500;
    jelly.damping = 2;
    jelly.strength = 700;
    jelly.material = surface;
    expectSame(sulfur_shape_jelly(&jelly, &made), made,
               shapes::jelly({.size = {2, 1},
                              .columns = 5,
                              .rows = 3,
                              .mass = 3,
                              .radius = Real(0.0625),
                              .stiffness = 500,
                              .damping = 2,
                              .strength = 700,
                              .material = material}),
               "jelly");
}

TEST(CInterfaceShapes, Cloth) {
    SulfurBlueprint* made = nullptr;
    SulfurClothOptions cloth = sulfur_cloth_options_default();
    cloth.size = {3, 1};
    cloth.columns = 5;
    cloth.rows = 4;
    cloth.mass = 3;
    cloth.radius = 0.0625;
    cloth.diagonals = true;
    cloth.pin_corners = false;
    cloth.stiffness = 500;
    cloth.damping = 2;
    cloth.strength = 700;
    cloth.material = surface;
    expectSame(sulfur_shape_cloth(&cloth, &made), made,
               shapes::cloth({.size = {3, 1},
                              .columns = 5,
                              .rows = 4,
                              .mass = 3,
                              .radius = Real(0.0625),
                              .diagonals = true,
                              .pinCorners = false,
                              .stiffness = 500,
                              .damping = 2,
                              .strength = 700,
                              .material = material}),
               "cloth");
}

TEST(CInterfaceShapes, Wall) {
    SulfurBlueprint* made = nullptr;
    SulfurWallOptions wall = sulfur_wall_options_default();
    wall.size = {3, 1};
    wall.columns = 5;
    wall.rows = 4;
    wall.mass = 3;
    wall.radius = 0.0625;
    wall.stiffness = 5000;
    wall.damping = 2;
    wall.strength = 700;
    wall.pin_bottom = true;
    wall.material = surface;
    expectSame(sulfur_shape_wall(&wall, &made), made,
               shapes::wall({.size = {3, 1},
                             .columns = 5,
                             .rows = 4,
                             .mass = 3,
                             .radius = Real(0.0625),
                             .stiffness = 5000,
                             .damping = 2,
                             .strength = 700,
                             .pinBottom = true,
                             .material = material}),
               "wall");
}

TEST(CInterfaceShapes, Blob) {
    SulfurBlueprint* made = nullptr;
    SulfurBlobOptions blob = sulfur_blob_options_default();
    blob.radius = 0.75;
    blob.segments = 9;
    blob.mass = 3;
    blob.skin_radius = 0.0625;
    blob.stiffness = 500;
    blob.damping = 2;
    blob.material = surface;
    expectSame(sulfur_shape_blob(&blob, &made), made,
               shapes::blob({.radius = Real(0.75),
                             .segments = 9,
                             .mass = 3,
                             .skinRadius = Real(0.0625),
                             .stiffness = 500,
                             .damping = 2,
                             .material = material}),
               "blob");
}

TEST(CInterfaceShapes, FloorAndThePapers) {
    SulfurBlueprint* made = nullptr;
    expectSame(sulfur_shape_floor({-2, 0}, {2, 1}, 0.0625, &made), made,
               shapes::floor({-2, 0}, {2, 1}, Real(0.0625)), "floor");
    const SulfurRopeOptions paperRope = sulfur_preset_rope(50);
    expectSame(sulfur_shape_rope(&paperRope, &made), made, shapes::rope(presets::rope(50)),
               "the paper's rope");
    const SulfurBoxOptions paperBox = sulfur_preset_plain_box({2, 1}, 3);
    expectSame(sulfur_shape_box(&paperBox, &made), made, shapes::box(presets::plainBox({2, 1}, 3)),
               "the paper's box");
    EXPECT_EQ(sulfur_preset_world().air_friction,
              static_cast<double>(presets::world().airFriction));
}

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

/// Exceptions of functions that the caller gave do not go through C.
TEST(CInterface, NoExceptionLeavesIt) {
    SulfurWorld* world = nullptr;
    SulfurBodyId ids[5];
    ASSERT_STREQ(c_make_scene(&world, ids), nullptr);
    SulfurQueryFilter filter = sulfur_query_filter_default();
    filter.accept = [](void*, SulfurBodyId) -> bool { throw 3; };
    std::size_t count = 77;
    EXPECT_EQ(sulfur_world_bodies_at(world, {-5, 0.6}, &filter, nullptr, 0, &count), SULFUR_FAILED);
    EXPECT_EQ(count, 77u);
    std::uint64_t ticks = 0;
    sulfur_world_set_should_collide(
        world, [](void*, SulfurBodyId, SulfurBodyId) -> bool { throw 3; }, nullptr);
    EXPECT_EQ(sulfur_world_step(world), SULFUR_FAILED);
    EXPECT_EQ(sulfur_world_ticks(world, &ticks), SULFUR_OK);
    EXPECT_EQ(ticks, 1u);
    sulfur_world_destroy(world);
}

}  // namespace
}  // namespace sulfur
