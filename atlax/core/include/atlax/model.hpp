#pragma once

#include <array>
#include <atlax/color.hpp>
#include <atlax/image.hpp>
#include <atlax/vec.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace atlax {

class Canvas;

namespace detail {
struct ModelObject;
}

struct ModelVertex {
    std::array<float, 3> position{};  ///< units of the file, y up, z towards the viewer
    std::array<float, 3> normal{};    ///< of unit length
    Vec2 uv{};                        ///< (0,0) is the top left of the picture
};

/// Triangles of one material.
struct ModelPart {
    std::vector<ModelVertex> vertices{};
    std::vector<std::uint32_t> indices{};  ///< triples, all within `vertices`
    Color color{};
    Image picture{};  ///< times the colour; empty for none
};

/// A three-dimensional model in memory. A plain value that owns all of it; needs no OpenGL.
struct Model {
    static constexpr std::size_t mostBytes = 64u << 20;     ///< of each file
    static constexpr std::size_t mostVertices = 2'000'000;  ///< and as many triangles
    static constexpr std::size_t mostParts = 1'000;

    std::vector<ModelPart> parts{};
    std::array<float, 3> min{};  ///< bounds of all positions
    std::array<float, 3> max{};
};

/// Reads glTF 2.0 (".gltf", ".glb") or OBJ (".obj", with its materials): triangles with their
/// transforms applied, colours and pictures of materials; no animations. Other files that it names
/// are read only from its folder and below. Throws Error with the file's name and the reason: not a
/// model, beyond the limits, numbers that are not finite, a missing or foreign file; nothing is
/// half-loaded. One thread at a time, as for pictures.
Model loadModel(const std::filesystem::path& file);

/// The same from bytes in memory, which may name no other files; the ending of `name` says which of
/// the formats it is, and `name` appears in messages.
Model decodeModel(std::span<const std::byte> bytes, const std::string& name);

/// A model on the graphics card, made by Canvas::createModel. A cheap handle with the rules of
/// Texture.
class ModelMesh {
public:
    ModelMesh() = default;
    bool valid() const { return object_ != nullptr; }

private:
    friend class Canvas;
    explicit ModelMesh(std::shared_ptr<detail::ModelObject> object) : object_(std::move(object)) {}
    std::shared_ptr<detail::ModelObject> object_;
};

/// One model in a picture.
struct ModelInstance {
    ModelMesh model{};
    Vec2 position{};              ///< of the model's origin, units of the current space
    float depth = 0;              ///< units towards the viewer
    float size = 1;               ///< units of the current space per unit of the model
    std::array<float, 3> turn{};  ///< radians about x, then y, then z; counter-clockwise
    Color tint = colors::white;   ///< its alpha counts for nothing: setOpacity fades
};

/// How models are seen: one light from far away, and light from all sides.
struct ModelView {
    std::array<float, 3> towardsLight{-0.4f, 0.7f, 0.6f};  ///< any length above 0
    Color light{0.9f, 0.9f, 0.85f, 1};
    Color ambient{0.25f, 0.27f, 0.35f, 1};
    /// Distance of the viewer from depth 0 in units of the current space, whose middle of the
    /// picture is looked at; 0 for a viewer infinitely far away. What is behind the viewer is cut
    /// off.
    float eye = 0;
};

}  // namespace atlax
