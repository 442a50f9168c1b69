#pragma once

#include <atlax/canvas.hpp>
#include <span>
#include <variant>
#include <vector>

namespace atlax {

/// Light that spreads from what is brighter than the threshold.
struct Bloom {
    float threshold = 0.7f;  ///< 0..1, of the brightest channel
    float strength = 0.6f;   ///< 0 for none, 1 for a flood
    float radius = 24;       ///< pixels that light reaches about, 2 or more; rounded to powers of 2
};

/// Darkens the picture towards its corners.
struct Vignette {
    float strength = 0.5f;  ///< 0 for none to 1 for black corners
    float begin = 0.5f;     ///< where it begins, in parts of the way from the middle to a corner
};

/// A caller's own pass: Shader::paint gets the picture so far as `picture`.
struct ShaderPass {
    Shader shader{};
    std::vector<ShaderValue> values{};
};

using PostEffect = std::variant<Bloom, Vignette, ShaderPass>;

/// Draws a frame into a picture of its own, lets effects change it one after the other, and puts it
/// into the frame.
///
///     post.begin();  draw the world;  post.end(effects);  draw what shall stay sharp
///
/// Owns its pictures, a bit more than two of the canvas's size, which follow that size. The thread
/// and the context of its canvas. Nothing but what is said throws.
class PostProcess {
public:
    /// The canvas must outlive it. Throws Error when the driver refuses the shaders.
    explicit PostProcess(Canvas& canvas);

    /// From now on everything is drawn into a transparent picture of the frame's size, in screen
    /// space at first. Within a frame. Throws Error when the card has no room for the pictures; the
    /// frame is then as it was.
    void begin();
    /// Applies the effects in their order and draws the result over the frame in which begin() was
    /// called, whose space and clip come back. Leaves alpha blending, full opacity and no shader.
    void end(std::span<const PostEffect> effects);

private:
    void resize(PixelSize size);
    void apply(const Bloom& bloom);
    void apply(const Vignette& vignette);
    void apply(const ShaderPass& pass);
    void draw(const RenderTarget& into, const Texture& picture, const Shader& shader,
              std::span<const ShaderValue> values, Blend blend);

    Canvas& canvas_;
    Shader bright_;
    Shader spread_;
    Shader vignette_;
    RenderTarget picture_;
    RenderTarget other_;
    std::vector<RenderTarget> halves_;  ///< each half of the one before
};

}  // namespace atlax
