// The picture of the past that stands above the pointer on the time bar.
#pragma once

#include <atlax/canvas.hpp>
#include <optional>

#include "past_pictures.hpp"

namespace sulfurchamber {

class PastCard {
public:
    /// The moment of the shown line to show from now on, and where, logical pixels from the left.
    void ask(const std::optional<Moment>& moment, double x);
    /// Over all else, at the lower edge, where the scene shows another moment; leaves the canvas in
    /// logical pixels.
    void paint(atlax::Canvas& canvas, const PastPictures& past, const Document& document);
    /// Whether the last frame had one.
    bool shown() const { return shown_; }
    /// The graphics card has lost it.
    void forgetTexture();

private:
    const PastPictures::Picture* wanted(const PastPictures& past, const Document& document) const;

    std::optional<Moment> moment_;
    double x_ = 0;
    bool shown_ = false;
    std::uint64_t serial_ = 0;  ///< of the picture that the texture has
    atlax::Texture texture_;
};

}  // namespace sulfurchamber
