#pragma once

#include <atlax/font.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "gl_objects.hpp"

namespace atlax::detail {

/// Keeps drawn glyphs in textures of 8-bit coverage, in shelves. When all pages are full it starts
/// afresh.
class GlyphAtlas {
public:
    struct Glyph {
        std::shared_ptr<TextureObject> page;  ///< null for a glyph without ink
        Rect uv;
        Vec2 size;    ///< pixels
        Vec2 corner;  ///< from the pen to the top left corner, pixels, y down
    };

    explicit GlyphAtlas(std::shared_ptr<Graveyard> graveyard) : graveyard_(std::move(graveyard)) {}

    /// The glyph at a size in 64ths of a pixel, moved right by quarters of a pixel. Rasterises and
    /// uploads it the first time; `uploads` then grows. The reference is valid until the next call.
    const Glyph& get(const Font& font, std::uint32_t glyph, int size64, int phase, int& uploads);

    void clear();

private:
    /// Font, glyph, size in 64ths of a pixel, phase.
    using Key = std::tuple<std::uint64_t, std::uint32_t, int, int>;
    struct Page {
        std::shared_ptr<TextureObject> texture;
        int shelfTop = 0;
        int shelfHeight = 0;
        int shelfX = 0;
    };

    /// Finds room on a page; false when it is full.
    static bool place(Page& page, int width, int height, int& x, int& y);
    Page& newPage();
    Glyph upload(const GlyphBitmap& bitmap);

    std::shared_ptr<Graveyard> graveyard_;
    std::vector<Page> pages_;
    std::map<Key, Glyph> glyphs_;
};

}  // namespace atlax::detail
