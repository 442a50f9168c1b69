#include "glyph_atlas.hpp"

#include <algorithm>

namespace atlax::detail {

namespace {

constexpr int pageSide = 1024;
constexpr std::size_t mostPages = 4;
constexpr int margin = 1;  // so that neighbours do not bleed into each other when scaled

}  // namespace

void GlyphAtlas::clear() {
    glyphs_.clear();
    pages_.clear();
}

const GlyphAtlas::Glyph& GlyphAtlas::get(const Font& font, std::uint32_t glyph, int size64,
                                         int phase, int& uploads) {
    const Key key{font.id(), glyph, size64, phase};
    const auto known = glyphs_.find(key);
    if (known != glyphs_.end()) return known->second;
    const GlyphBitmap bitmap = font.rasterise(glyph, static_cast<float>(size64) / 64.0f, phase);
    Glyph made;
    if (bitmap.width > 0 && bitmap.height > 0) {
        made = upload(bitmap);
        ++uploads;
    }
    return glyphs_.insert_or_assign(key, std::move(made)).first->second;
}

bool GlyphAtlas::place(Page& page, int width, int height, int& x, int& y) {
    if (page.shelfX + width > pageSide) {
        page.shelfTop += page.shelfHeight;
        page.shelfX = 0;
        page.shelfHeight = 0;
    }
    if (page.shelfTop + height > pageSide || width > pageSide) return false;
    x = page.shelfX;
    y = page.shelfTop;
    page.shelfX += width;
    page.shelfHeight = std::max(page.shelfHeight, height);
    return true;
}

GlyphAtlas::Page& GlyphAtlas::newPage() {
    // Batches that are not drawn yet keep the old textures alive, so this may happen at any time.
    if (pages_.size() >= mostPages) clear();
    GLuint name = 0;
    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, name);
    const std::vector<std::uint8_t> blank(std::size_t{pageSide} * pageSide, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, pageSide, pageSide, 0, GL_RED, GL_UNSIGNED_BYTE,
                 blank.data());
    // Coverage in every channel is premultiplied white.
    const GLint swizzle[4] = {GL_RED, GL_RED, GL_RED, GL_RED};
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    pages_.push_back(
        {std::make_shared<TextureObject>(graveyard_, name, PixelSize{pageSide, pageSide})});
    return pages_.back();
}

GlyphAtlas::Glyph GlyphAtlas::upload(const GlyphBitmap& bitmap) {
    const int width = bitmap.width + 2 * margin;
    const int height = bitmap.height + 2 * margin;
    int x = 0;
    int y = 0;
    if (pages_.empty() || !place(pages_.back(), width, height, x, y)) {
        if (!place(newPage(), width, height, x, y)) return {};  // larger than a page
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, pages_.back().texture->name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, x + margin, y + margin, bitmap.width, bitmap.height, GL_RED,
                    GL_UNSIGNED_BYTE, bitmap.coverage.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    // The quad takes the empty margin along, so that text between pixels has soft borders.
    const float scale = 1.0f / pageSide;
    return {pages_.back().texture,
            {Vec2(static_cast<float>(x), static_cast<float>(y)) * scale,
             Vec2(static_cast<float>(width), static_cast<float>(height)) * scale},
            {static_cast<float>(width), static_cast<float>(height)},
            {static_cast<float>(bitmap.left - margin), static_cast<float>(-bitmap.top - margin)}};
}

}  // namespace atlax::detail
