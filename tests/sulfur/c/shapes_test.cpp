// Ready-made blueprints through the C interface: defaults, and where each option arrives.
#include <sulfur/c/sulfur.h>

#include "../helpers.hpp"

namespace sulfur {
namespace {

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
    rope.bending_damping = 4;
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
                             .bendingDamping = 4,
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

}  // namespace
}  // namespace sulfur
