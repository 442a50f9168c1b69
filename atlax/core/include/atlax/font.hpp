#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <atlax/vec.hpp>

namespace atlax {

/// Size of a text in pixels. The height counts lines of lineHeight each, not ink.
struct TextExtent {
    float width = 0;
    float height = 0;
};

/// Vertical measures of a font at one size, pixels, all positive.
struct FontMetrics {
    float ascent = 0;
    float descent = 0;
    float lineHeight = 0;
    float capHeight = 0;
};

/// One placed glyph of a shaped line: pixels from the start of the baseline, y up.
struct ShapedGlyph {
    std::uint32_t glyph = 0;
    Vec2 offset;
};

/// One line of text after kerning and ligatures.
struct ShapedLine {
    std::vector<ShapedGlyph> glyphs;
    float width = 0;
};

/// Coverage of one glyph, 0..255, rows from the top; `left` and `top` place the bitmap's top left
/// corner from the pen, pixels, y up.
struct GlyphBitmap {
    int width = 0;
    int height = 0;
    int left = 0;
    int top = 0;
    std::vector<std::uint8_t> coverage;
};

/// A scalable font (FreeType) that shapes UTF-8 text with kerning (HarfBuzz) at any size. Needs no
/// window and no OpenGL; the canvas keeps the glyphs that it draws.
///
/// A cheap handle: copies share the loaded font. A Font may be used by one thread at a time.
/// Bytes that are not UTF-8 are shown as the replacement character, never an error.
class Font {
public:
    /// Smallest and largest size in pixels per em; other sizes are clamped.
    static constexpr float minSize = 4;
    static constexpr float maxSize = 512;

    /// Loads a TrueType or OpenType file. Throws Error with the file's name and the reason.
    static Font load(const std::filesystem::path& file);

    /// The first of these faces ("Jura-Medium", "DejaVuSans": file names without extension) that is
    /// in the system's or the user's font folders. Throws Error naming them when none is there.
    static Font find(std::initializer_list<std::string_view> faces);

    /// Jura if installed, else DejaVu Sans. Throws Error when neither is there.
    static Font standard();

    FontMetrics metrics(float size) const;

    /// Extent of a text; '\n' starts a new line.
    TextExtent measure(std::string_view utf8, float size) const;

    /// Breaks at spaces so that no line is wider than `width` pixels (a longer word stays whole).
    std::string wrap(std::string_view utf8, float size, float width) const;

    /// One line ('\n' is not special here). The reference is valid until the next call.
    const ShapedLine& shape(std::string_view utf8, float size) const;

    /// Draws one glyph into memory, its pen moved right by `phase` quarters of a pixel (0..3).
    GlyphBitmap rasterise(std::uint32_t glyph, float size, int phase) const;

    /// Different for every loaded font of the process, never reused.
    std::uint64_t id() const;

private:
    class Face;
    explicit Font(std::shared_ptr<Face> face);
    std::shared_ptr<Face> face_;
};

}  // namespace atlax
