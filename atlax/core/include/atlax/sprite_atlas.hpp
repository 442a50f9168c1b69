#pragma once

#include <atlax/canvas.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atlax {

struct AtlasImage {
    std::string name{};
    Image image{};
};

struct AtlasOptions {
    int pageSide = 2048;  ///< pixels; 64 to Image::maxSide
    bool smooth = true;
};

/// One picture of an atlas: what to draw with, and its size in pixels.
///
///     canvas.sprite(tree.texture, centre, size, {.uv = tree.uv});
struct AtlasSprite {
    Texture texture{};
    Rect uv{};
    PixelSize size{};
};

/// Puts many small pictures on few large ones, so that sprites of all of them cost one draw call.
///
/// Around each picture its border is repeated, so that neighbours never bleed into it, also when it
/// is drawn at up to a quarter of its size. Owns its textures as handles; sprites that were taken
/// out keep them alive. Making one belongs to the thread and the context of the canvas; looking up
/// to one thread at a time.
class SpriteAtlas {
public:
    SpriteAtlas() = default;
    /// Throws Error that names the picture which is empty, larger than a page, or has the name of
    /// another one; and as Canvas::createTexture does.
    SpriteAtlas(Canvas& canvas, std::span<const AtlasImage> images,
                const AtlasOptions& options = {});

    /// Throws Error when there is none of that name.
    const AtlasSprite& at(std::string_view name) const;
    bool contains(std::string_view name) const { return sprites_.find(name) != sprites_.end(); }
    std::size_t size() const { return sprites_.size(); }
    int pages() const { return pages_; }

private:
    std::map<std::string, AtlasSprite, std::less<>> sprites_;
    int pages_ = 0;
};

}  // namespace atlax
