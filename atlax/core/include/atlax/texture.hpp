#pragma once

#include <memory>

#include <atlax/vec.hpp>

namespace atlax {

class Canvas;
class Texture;

namespace detail {
struct TextureObject;
struct TargetObject;
unsigned nameOf(const Texture& texture);
}  // namespace detail

struct TextureOptions {
    bool smooth = true;     ///< linear filter; false keeps hard pixels
    bool repeat = false;    ///< the picture repeats outside of 0..1, else its border is stretched
    bool mipmaps = true;    ///< smooth when drawn much smaller
    int mipmapLevels = 14;  ///< how often it is halved at most, for pictures on one page
};

/// A picture on the graphics card, made by Canvas::createTexture. A cheap handle: copies share the
/// picture, which lives as long as a handle or an unfinished frame needs it. It may outlive the
/// canvas; to another canvas, also to the one that follows a lost graphics context, it is no
/// picture. Thread of its canvas only; nothing here throws, only Canvas::createTexture.
class Texture {
public:
    /// No picture: what is drawn with it is plain white times the tint.
    Texture() = default;

    PixelSize size() const;
    bool valid() const { return object_ != nullptr; }

private:
    friend class Canvas;
    friend class RenderTarget;
    friend unsigned detail::nameOf(const Texture& texture);
    explicit Texture(std::shared_ptr<detail::TextureObject> object) : object_(std::move(object)) {}
    std::shared_ptr<detail::TextureObject> object_;
};

/// A picture to draw into, made by Canvas::createTarget. Handle with the same rules as Texture.
class RenderTarget {
public:
    RenderTarget() = default;

    PixelSize size() const;
    bool valid() const { return object_ != nullptr; }
    /// What was drawn, for drawing it on; premultiplied, row 0 at the top.
    Texture texture() const;

private:
    friend class Canvas;
    explicit RenderTarget(std::shared_ptr<detail::TargetObject> object)
        : object_(std::move(object)) {}
    std::shared_ptr<detail::TargetObject> object_;
};

}  // namespace atlax
