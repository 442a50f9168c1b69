// Ready-made blueprints, and the paper's.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

SulfurGroundOptions sulfur_ground_options_default(void) {
    return toC(shapes::GroundOptions{});
}

SulfurResult sulfur_shape_ground(const SulfurGroundOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint,
                [&] { return shapes::ground(orDefault<shapes::GroundOptions>(options)); });
}

SulfurResult sulfur_shape_floor(SulfurVec from, SulfurVec to, double radius,
                                SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::floor(vec(from), vec(to), real(radius)); });
}

SulfurBoxOptions sulfur_box_options_default(void) {
    return toC(shapes::BoxOptions{});
}

SulfurResult sulfur_shape_box(const SulfurBoxOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::box(orDefault<shapes::BoxOptions>(options)); });
}

SulfurPolygonOptions sulfur_polygon_options_default(void) {
    return toC(shapes::PolygonOptions{});
}

SulfurResult sulfur_shape_polygon(const SulfurPolygonOptions* options,
                                  SulfurBlueprint** blueprint) {
    return make(blueprint,
                [&] { return shapes::polygon(orDefault<shapes::PolygonOptions>(options)); });
}

SulfurBallOptions sulfur_ball_options_default(void) {
    return toC(shapes::BallOptions{});
}

SulfurResult sulfur_shape_ball(const SulfurBallOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::ball(orDefault<shapes::BallOptions>(options)); });
}

SulfurWheelOptions sulfur_wheel_options_default(void) {
    return toC(shapes::WheelOptions{});
}

SulfurResult sulfur_shape_wheel(const SulfurWheelOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::wheel(orDefault<shapes::WheelOptions>(options)); });
}

SulfurRopeOptions sulfur_rope_options_default(void) {
    return toC(shapes::RopeOptions{});
}

SulfurResult sulfur_shape_rope(const SulfurRopeOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::rope(orDefault<shapes::RopeOptions>(options)); });
}

SulfurChainOptions sulfur_chain_options_default(void) {
    return toC(shapes::ChainOptions{});
}

SulfurResult sulfur_shape_chain(const SulfurChainOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::chain(orDefault<shapes::ChainOptions>(options)); });
}

SulfurBridgeOptions sulfur_bridge_options_default(void) {
    return toC(shapes::BridgeOptions{});
}

SulfurResult sulfur_shape_bridge(const SulfurBridgeOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint,
                [&] { return shapes::bridge(orDefault<shapes::BridgeOptions>(options)); });
}

SulfurJellyOptions sulfur_jelly_options_default(void) {
    return toC(shapes::JellyOptions{});
}

SulfurResult sulfur_shape_jelly(const SulfurJellyOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::jelly(orDefault<shapes::JellyOptions>(options)); });
}

SulfurClothOptions sulfur_cloth_options_default(void) {
    return toC(shapes::ClothOptions{});
}

SulfurResult sulfur_shape_cloth(const SulfurClothOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::cloth(orDefault<shapes::ClothOptions>(options)); });
}

SulfurWallOptions sulfur_wall_options_default(void) {
    return toC(shapes::WallOptions{});
}

SulfurResult sulfur_shape_wall(const SulfurWallOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::wall(orDefault<shapes::WallOptions>(options)); });
}

SulfurBlobOptions sulfur_blob_options_default(void) {
    return toC(shapes::BlobOptions{});
}

SulfurResult sulfur_shape_blob(const SulfurBlobOptions* options, SulfurBlueprint** blueprint) {
    return make(blueprint, [&] { return shapes::blob(orDefault<shapes::BlobOptions>(options)); });
}

// --- the paper's ---------------------------------------------------------------------------------

SulfurWorldSettings sulfur_preset_world(void) {
    return toC(presets::world());
}

SulfurRopeOptions sulfur_preset_rope(double stiffness) {
    SulfurRopeOptions options = toC(presets::rope());
    options.stiffness = stiffness;
    return options;
}

SulfurBoxOptions sulfur_preset_plain_box(SulfurVec size, double mass) {
    SulfurBoxOptions options = toC(presets::plainBox());
    options.size = size;
    options.mass = mass;
    return options;
}

}  // extern "C"

}  // namespace sulfur::c
