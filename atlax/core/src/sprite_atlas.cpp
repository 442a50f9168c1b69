#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/sprite_atlas.hpp>
#include <numeric>

namespace atlax {

namespace {

/// Pixels of repeated border on each side. Two levels of mipmaps, of quarters, stay inside it.
constexpr int gutter = 4;

struct Place {
    std::size_t page = 0;
    int x = 0;
    int y = 0;
};

/// Pictures from the highest to the lowest in rows from left to right; a row is as high as its
/// first. Returns the place of each, in the order of `images`, and how many pages they need.
std::vector<Place> arrange(std::span<const AtlasImage> images, int side, std::size_t& pages) {
    std::vector<std::size_t> order(images.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return images[a].image.height() > images[b].image.height();
    });
    std::vector<Place> places(images.size());
    Place next;
    int rowHeight = 0;
    for (const std::size_t i : order) {
        const int width = images[i].image.width() + 2 * gutter;
        const int height = images[i].image.height() + 2 * gutter;
        if (next.x + width > side) {
            next = {next.page, 0, next.y + rowHeight};
            rowHeight = 0;
        }
        if (next.y + height > side) next = {next.page + 1, 0, 0};
        if (next.x == 0) rowHeight = height;
        places[i] = {next.page, next.x + gutter, next.y + gutter};
        next.x += width;
    }
    pages = images.empty() ? 0 : next.page + 1;
    return places;
}

void copyWithBorder(Image& page, const Image& image, const Place& place) {
    for (int y = -gutter; y < image.height() + gutter; ++y)
        for (int x = -gutter; x < image.width() + gutter; ++x)
            page.setPixel(place.x + x, place.y + y,
                          image.pixel(std::clamp(x, 0, image.width() - 1),
                                      std::clamp(y, 0, image.height() - 1)));
}

void check(std::span<const AtlasImage> images, int side) {
    if (side < 64 || side > Image::maxSide)
        throw Error("an atlas with pages of " + std::to_string(side) +
                    " pixels was asked for; allowed are 64 to " + std::to_string(Image::maxSide));
    for (const AtlasImage& one : images) {
        if (one.image.empty()) throw Error("the picture \"" + one.name + "\" of an atlas is empty");
        if (one.image.width() + 2 * gutter > side || one.image.height() + 2 * gutter > side)
            throw Error("the picture \"" + one.name + "\" does not fit on a page of " +
                        std::to_string(side) + " pixels with its border of " +
                        std::to_string(gutter));
    }
}

}  // namespace

SpriteAtlas::SpriteAtlas(Canvas& canvas, std::span<const AtlasImage> images,
                         const AtlasOptions& options) {
    check(images, options.pageSide);
    std::size_t count = 0;
    const std::vector<Place> places = arrange(images, options.pageSide, count);
    const auto side = static_cast<float>(options.pageSide);
    for (std::size_t page = 0; page < count; ++page) {
        Image picture({options.pageSide, options.pageSide});
        for (std::size_t i = 0; i < images.size(); ++i)
            if (places[i].page == page) copyWithBorder(picture, images[i].image, places[i]);
        const Texture texture = canvas.createTexture(
            picture, {.smooth = options.smooth, .mipmaps = true, .mipmapLevels = 2});
        for (std::size_t i = 0; i < images.size(); ++i) {
            if (places[i].page != page) continue;
            const Vec2 at{static_cast<float>(places[i].x), static_cast<float>(places[i].y)};
            const PixelSize size = images[i].image.size();
            const Rect uv{at / side, size.toVec() / side};
            if (!sprites_.emplace(images[i].name, AtlasSprite{texture, uv, size}).second)
                throw Error("two pictures of an atlas are named \"" + images[i].name + "\"");
        }
    }
    pages_ = static_cast<int>(count);
}

const AtlasSprite& SpriteAtlas::at(std::string_view name) const {
    const auto found = sprites_.find(name);
    if (found == sprites_.end())
        throw Error("the atlas has no picture \"" + std::string(name) + "\"");
    return found->second;
}

}  // namespace atlax
