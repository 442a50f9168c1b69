#pragma once

#include <epoxy/gl.h>

#include <array>
#include <atlax/canvas.hpp>
#include <cstdint>
#include <memory>
#include <vector>

#include "gl_objects.hpp"

namespace atlax::detail {

/// Colour as the shader wants it: premultiplied, 16 bits so that faint glows keep their steps.
using PackedColor = std::array<std::uint16_t, 4>;

/// What the fragment shader does with a primitive, when it is not a shape (shader.cpp).
enum class Mode : int {
    Textured = -1,
    Flat = -2,
    Gradient = -3,
    Glow = -4,
    Linear = -5,
    Radial = -6
};

struct Vertex {
    Vec2 position;  ///< pixels, y down
    Vec2 uv;        ///< of the texture, or pixels from the middle of a shape
    PackedColor color{};
    std::array<float, 4> shape{};
};

constexpr std::array<float, 4> shapeOf(Mode mode) {
    return {0, 0, 0, static_cast<float>(static_cast<int>(mode))};
}

/// Two colours, of 8 bits a channel, in three whole numbers that a float holds exactly, and how
/// they go over: Mode::Linear along uv.x, Mode::Radial along the length of uv.
std::array<float, 4> gradientShape(const PackedColor& start, const PackedColor& end, Mode mode);

/// Gathers triangles and draws them with as few calls as possible. Needs the context current.
class Batch {
public:
    explicit Batch(std::shared_ptr<Graveyard> graveyard);
    ~Batch();
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    /// Sets OpenGL's state for drawing into a framebuffer. Flushes first.
    void bindTarget(GLuint framebuffer, PixelSize size, bool rowZeroIsTop);
    /// Confines drawing to pixels (y down), or not. Flushes first when it changes.
    void setClip(const Rect* pixels);

    /// Triangles that follow may sample this texture. Flushes when another one was in use.
    void useTexture(const std::shared_ptr<TextureObject>& texture);

    /// Flushes when something changes that a draw call cannot hold twice.
    void setBlend(Blend blend);
    void setShader(std::shared_ptr<ShaderObject> shader, std::span<const ShaderValue> values);

    /// Makes room for this many vertices in one draw call; may flush. Call before nextVertex().
    void reserve(std::size_t count);
    /// Index that the next added vertex will have.
    std::uint32_t nextVertex() const { return static_cast<std::uint32_t>(vertices_.size()); }
    std::uint32_t add(const Vertex& vertex) {
        vertices_.push_back(vertex);
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        indices_.insert(indices_.end(), {a, b, c});
    }
    /// Four corners in turn.
    void quad(const std::array<Vertex, 4>& corners);

    void flush();

    CanvasStatistics statistics;

private:
    void useProgram() const;

    std::shared_ptr<ShaderObject> plain_;
    std::shared_ptr<ShaderObject> shader_;  ///< the caller's, or none
    std::vector<ShaderValue> values_;
    Blend blend_ = Blend::Alpha;  ///< Additive counts as Alpha
    GLuint vertexArray_ = 0;
    GLuint vertexBuffer_ = 0;
    GLuint indexBuffer_ = 0;
    PixelSize size_;
    bool rowZeroIsTop_ = false;
    bool clipped_ = false;
    Rect clip_;
    std::shared_ptr<TextureObject> texture_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace atlax::detail
