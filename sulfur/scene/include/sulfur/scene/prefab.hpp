/// \file
/// A named blueprint in a file: explicit, or made by one of the ready-made shapes.
#pragma once

#include <string>
#include <sulfur/blueprint.hpp>
#include <sulfur/scene/extra.hpp>
#include <sulfur/shapes.hpp>
#include <variant>

namespace sulfur::scene {

/// shapes::floor's parameters as one thing.
struct FloorOptions {
    Vec2 from{-10, 0};         ///< metres
    Vec2 to{10, 0};            ///< metres
    Real radius = Real(0.05);  ///< metres, > 0: half the thickness
    Material material;         ///< of the surface
};

/// The recipe of a generated blueprint; std::monostate: none, it is explicit.
using Generator = std::variant<std::monostate, FloorOptions, shapes::GroundOptions,
                               shapes::BoxOptions, shapes::BallOptions, shapes::RopeOptions,
                               shapes::JellyOptions, shapes::BlobOptions, shapes::PolygonOptions,
                               shapes::WheelOptions, shapes::ChainOptions, shapes::BridgeOptions,
                               shapes::ClothOptions, shapes::WallOptions>;

/// Runs the recipe. Throws sulfur::Error when a number is out of range, or when there is no
/// recipe.
Blueprint build(const Generator& generator);

/// Dresses a generated box, jelly, blob, wheel, cloth or wall: texture coordinates from its
/// outline's bounding rectangle (collision radius left out) and the triangles between its
/// particles. Other shapes get coordinates without triangles.
Skin fitSkin(const Generator& generator, const Blueprint& blueprint, std::string texture);

/// A blueprint as files hold it.
struct Prefab {
    Blueprint blueprint;  ///< ready for World::add; its name is the prefab's
    /// How the blueprint was made. Writing then writes the recipe with name, kind, filter, sensor,
    /// self-collision and skin of `blueprint` and nothing else of it: whoever edits particles,
    /// joints or the material of `blueprint` sets `generator` back to std::monostate.
    Generator generator;
    /// The skin was made by fitSkin: only its texture is written.
    bool skinFitted = false;
    ExtraTree extra;  ///< unknown members
};

/// A prefab made by `generator`, with a fitted skin when `texture` is not empty.
Prefab makePrefab(std::string name, const Generator& generator, const std::string& texture = "");

}  // namespace sulfur::scene
