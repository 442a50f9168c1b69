#pragma once

#include <algorithm>
#include <atlax/canvas.hpp>
#include <cmath>
#include <vector>

#include "batch.hpp"
#include "glyph_atlas.hpp"
#include "model_renderer.hpp"

namespace atlax {

/// How units of the current space become pixels: pixels = origin + point * scale.
struct Space {
    Vec2 origin;
    Vec2 scale{1, 1};  ///< y is negative in world space
    Vec2 centre;       ///< subtracted first, so that far places keep their precision

    Vec2 toPixels(Vec2 p) const {
        return {origin.x + (p.x - centre.x) * scale.x, origin.y + (p.y - centre.y) * scale.y};
    }
    Rect toPixels(Rect r) const {
        const Vec2 a = toPixels(r.min);
        const Vec2 b = toPixels(r.max());
        return {{std::min(a.x, b.x), std::min(a.y, b.y)},
                {std::abs(b.x - a.x), std::abs(b.y - a.y)}};
    }
    Vec2 fromPixels(Vec2 p) const {
        return {centre.x + (p.x - origin.x) / scale.x, centre.y + (p.y - origin.y) / scale.y};
    }
    float length(float units) const { return units * scale.x; }
    bool world() const { return scale.y < 0; }
};

/// Where drawing goes, with everything that pushTarget saves and popTarget brings back.
struct Frame {
    GLuint framebuffer = 0;
    PixelSize size;
    bool rowZeroIsTop = false;
    std::shared_ptr<detail::TargetObject> target;  ///< kept alive while it is drawn into
    Space space;
    std::vector<Rect> clips;  ///< pixels, each within the one before
};

class Canvas::Implementation {
public:
    std::shared_ptr<detail::Graveyard> graveyard = std::make_shared<detail::Graveyard>();
    detail::Batch batch{graveyard};
    detail::GlyphAtlas glyphs{graveyard};
    std::unique_ptr<detail::ModelRenderer> models;  ///< made when first needed
    RenderTarget modelTarget;
    Frame frame;
    std::vector<Frame> saved;
    float scaleFactor = 1;
    bool tellsOfLoss = false;  ///< whether the driver knows glGetGraphicsResetStatus
    Blend blend = Blend::Alpha;
    float opacity = 1;
    bool recordsTexts = false;
    std::vector<DrawnText> texts;  ///< of this frame, when they are recorded

    /// Premultiplied, with opacity and blend mode in it.
    detail::PackedColor pack(Color color) const;

    /// Chooses a texture for what follows and says which mode draws it: plain when there is none.
    std::array<float, 4> useTexture(const std::shared_ptr<detail::TextureObject>& texture);

    /// Throws Error for an empty target and for one of another canvas, whose name would be some
    /// other target's here.
    const detail::TargetObject& requireOwn(const RenderTarget& target) const;
    /// Throws Error when the context is lost: what was read then is no picture.
    void requireContext() const;
    bool lost() const { return tellsOfLoss && glGetGraphicsResetStatus() != GL_NO_ERROR; }

    /// Puts the frame's framebuffer and clip into force.
    void bindFrame();
    void applyClip();

    /// A rounded box in pixels (shader.cpp), turned so that its x axis is `axis` (unit length).
    struct Box {
        Vec2 centre;
        Vec2 axis{1, 0};
        Vec2 half;
        float radius = 0;
        float halfStroke = 0;
    };
    void box(const Box& box, const detail::PackedColor& color);
    /// Capsule between pixels; thin ones fade.
    void capsule(Vec2 from, Vec2 to, float radius, Color color);
    void outline(Box outer, float width, Color color);
    /// Closed or open line in pixels without repeated points.
    void strokePixels(std::span<const Vec2> points, float width, Color color, bool closed);
    /// What fills a polygon: a colour, or a mode with uv = axes * (pixels - origin).
    struct Fill {
        detail::PackedColor color{};
        std::array<float, 4> shape = detail::shapeOf(detail::Mode::Flat);
        Vec2 origin{};
        Vec2 u{};
        Vec2 v{};
    };
    Fill fillOf(const Gradient& gradient) const;
    void fillPolygon(std::span<const Vec2> points, const Fill& fill);
    /// Simple polygon, doubleArea positive, without repeated points.
    void polygonPixels(std::span<const Vec2> points, const Fill& fill);

    std::vector<Vec2> scratch;  ///< points in pixels, reused
};

/// Premultiplied pixels of a picture with straight alpha, and back.
std::vector<std::uint8_t> premultiplied(const Image& image);
void unpremultiply(Image& image);

}  // namespace atlax
