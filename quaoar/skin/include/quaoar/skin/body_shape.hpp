// What of a body can be filled, bordered and dressed, found in its joints.
#pragma once

#include <array>
#include <atlax/vec.hpp>
#include <string>
#include <sulfur/sulfur.hpp>
#include <vector>

namespace quaoar {

/// Found anew whenever the body has lost joints, so that skins tear where they break. Indices are
/// those of the body's particles.
struct BodyShape {
    using Edge = std::array<std::uint32_t, 2>;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Edge> border;  ///< edges of one triangle only, the body to their left
    std::vector<Edge> loose;   ///< joints that belong to no triangle: chains, ropes, threads
    std::vector<std::uint32_t> outline;  ///< the loop of its capsules, counter-clockwise, or empty
    std::vector<atlax::Vec2> uv;         ///< by particle; 0..1, v points down
    std::string texture;                 ///< of its skin; empty without
    float thickness = 0;                 ///< metres, the largest radius of its joints
    float width = 0, height = 0;         ///< metres, as its blueprint
    bool soft = false;                   ///< it gives way
    std::size_t particles = 0, joints = 0;

    bool fits(const sulfur::World& world, sulfur::BodyId body) const;
};

/// `plan` is what the body was made of, also when this one is a piece of it; null: it is not known,
/// and only a skin that fits is worn. Complexity: n log n in joints, for lattices.
BodyShape shapeOf(const sulfur::World& world, sulfur::BodyId body, const sulfur::Blueprint* plan);

/// Triangles between three joints of a plan, or of its meshes of four, counter-clockwise: what a
/// picture can lie on.
std::vector<std::array<std::uint32_t, 3>> trianglesOf(const sulfur::Blueprint& plan);

}  // namespace quaoar
