#include <algorithm>
#include <cmath>

#include "canvas_impl.hpp"

namespace atlax {

using detail::Mode;
using detail::Vertex;

namespace {

/// Calls `visit(line)` for each line between '\n'.
template <class Visit>
void eachLine(std::string_view text, Visit visit) {
    while (true) {
        const auto end = text.find('\n');
        visit(text.substr(0, end));
        if (end == std::string_view::npos) return;
        text.remove_prefix(end + 1);
    }
}

/// Glyphs are rasterised at this size. Coarser steps in world space, where a zoom would else make
/// a new set of glyphs every frame; the quads are scaled by the rest.
int rasterSize64(float pixels, bool world) {
    const float clamped = std::clamp(pixels, Font::minSize, Font::maxSize);
    if (!world) return static_cast<int>(std::lround(clamped * 64.0f));
    constexpr float stepsPerDoubling = 8;
    const float step = std::round(std::log2(clamped) * stepsPerDoubling) / stepsPerDoubling;
    return static_cast<int>(std::lround(std::exp2(step) * 64.0f));
}

float firstBaseline(AlignY align, const FontMetrics& metrics, float height) {
    switch (align) {
        case AlignY::Top:
            return metrics.ascent;
        case AlignY::Middle:
            // The middle of the capitals, which is what the eye takes for the middle of a label.
            return metrics.capHeight / 2 - (height - metrics.lineHeight) / 2;
        case AlignY::Bottom:
            return metrics.ascent - height;
        case AlignY::Baseline:
            break;
    }
    return 0;
}

float lineStart(AlignX align, float width) {
    switch (align) {
        case AlignX::Centre:
            return -width / 2;
        case AlignX::Right:
            return -width;
        case AlignX::Left:
            break;
    }
    return 0;
}

/// One line being drawn: where its baseline starts and how much its glyphs are scaled.
struct Line {
    Vec2 start;  ///< pixels
    float scale = 1;
    int size64 = 0;
    bool snapped = true;  ///< to whole pixels vertically and quarters horizontally
};

void drawLine(detail::Batch& batch, detail::GlyphAtlas& atlas, const Font& font,
              const ShapedLine& shaped, const Line& line, const detail::PackedColor& color) {
    const auto shape = detail::shapeOf(Mode::Textured);
    for (const ShapedGlyph& g : shaped.glyphs) {
        Vec2 pen{line.start.x + g.offset.x * line.scale, line.start.y - g.offset.y * line.scale};
        int phase = 0;
        if (line.snapped) {
            const float quarters = std::round(pen.x * 4);
            pen.x = std::floor(quarters / 4);
            phase = static_cast<int>(quarters - pen.x * 4);
        }
        const auto& glyph =
            atlas.get(font, g.glyph, line.size64, phase, batch.statistics.glyphUploads);
        if (glyph.page == nullptr) continue;
        batch.useTexture(glyph.page);
        const Vec2 low = pen + glyph.corner * line.scale;
        const Vec2 size = glyph.size * line.scale;
        const auto corner = [&](float u, float v) {
            return Vertex{
                {low.x + size.x * u, low.y + size.y * v},
                {glyph.uv.min.x + glyph.uv.size.x * u, glyph.uv.min.y + glyph.uv.size.y * v},
                color,
                shape};
        };
        batch.quad({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
    }
}

}  // namespace

TextExtent Canvas::text(const Font& font, std::string_view utf8, Vec2 position,
                        const TextStyle& style) {
    auto& self = *implementation_;
    const Space& space = self.frame.space;
    const Vec2 at = space.toPixels(position);
    const float pixels = space.length(style.size);
    if (!(pixels > 0) || !std::isfinite(pixels) || !std::isfinite(at.x) || !std::isfinite(at.y))
        return {};
    Line line;
    line.size64 = rasterSize64(pixels, space.world());
    line.snapped = !space.world();
    const float rastered = static_cast<float>(line.size64) / 64.0f;
    line.scale = line.snapped && pixels >= Font::minSize && pixels <= Font::maxSize
                     ? 1.0f
                     : pixels / rastered;
    const FontMetrics metrics = font.metrics(rastered);
    const TextExtent extent = font.measure(utf8, rastered);
    const auto color = self.pack(style.color);
    float baseline = firstBaseline(style.alignY, metrics, extent.height);
    if (self.recordsTexts && self.saved.empty()) {
        const Vec2 corner{lineStart(style.alignX, extent.width), baseline - metrics.capHeight};
        const float height =
            extent.height - metrics.lineHeight + metrics.capHeight + metrics.descent;
        self.texts.push_back({std::string(utf8),
                              {at + corner * line.scale, Vec2{extent.width, height} * line.scale},
                              style.color.a * self.opacity});
    }
    eachLine(utf8, [&](std::string_view piece) {
        const ShapedLine& shaped = font.shape(piece, rastered);
        line.start = at + Vec2{lineStart(style.alignX, shaped.width), baseline} * line.scale;
        if (line.snapped) line.start.y = std::round(line.start.y);
        drawLine(self.batch, self.glyphs, font, shaped, line, color);
        baseline += metrics.lineHeight;
    });
    const float unit = line.scale / space.scale.x;
    return {extent.width * unit, extent.height * unit};
}

void Canvas::recordTexts(bool on) {
    implementation_->recordsTexts = on;
}

const std::vector<DrawnText>& Canvas::recordedTexts() const {
    return implementation_->texts;
}

TextExtent Canvas::measure(const Font& font, std::string_view utf8, float size) const {
    const Space& space = implementation_->frame.space;
    const float pixels = space.length(size);
    if (!(pixels > 0) || !std::isfinite(pixels)) return {};
    const float rastered = static_cast<float>(rasterSize64(pixels, space.world())) / 64.0f;
    const TextExtent extent = font.measure(utf8, rastered);
    const float unit = pixels / rastered / space.scale.x;
    return {extent.width * unit, extent.height * unit};
}

}  // namespace atlax
