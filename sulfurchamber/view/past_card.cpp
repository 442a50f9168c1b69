#include "past_card.hpp"

#include <algorithm>

#include "palette.hpp"

namespace sulfurchamber {
namespace {

constexpr float cardBorder = 3;  // logical pixels, as what follows
constexpr float cardGap = 6;
constexpr float mostOfView = 0.33f;  // either way
constexpr double sameSeconds = 0.1;

}  // namespace

void PastCard::ask(const std::optional<Moment>& moment, double x) {
    moment_ = moment;
    x_ = x;
}

const PastPictures::Picture* PastCard::wanted(const PastPictures& past,
                                              const Document& document) const {
    const auto& now = document.timeline().now();
    if (!moment_ || !now || now->branch != moment_->branch) return nullptr;
    // What the scene itself shows needs no card.
    const auto [low, high] = std::minmax(moment_->tick, now->tick);
    if (static_cast<double>(high - low) * static_cast<double>(document.world().tickDuration()) <
        sameSeconds)
        return nullptr;
    return past.near(document, *moment_);
}

void PastCard::paint(atlax::Canvas& canvas, const PastPictures& past, const Document& document) {
    const PastPictures::Picture* picture = wanted(past, document);
    shown_ = picture != nullptr;
    if (!shown_) return;
    if (serial_ != picture->serial) texture_ = canvas.createTexture(picture->image);
    serial_ = picture->serial;
    const float scale = canvas.scaleFactor();
    canvas.setScreenSpace(scale);
    const atlax::Vec2 view = canvas.size().toVec() / scale;
    const atlax::Vec2 full = PastPictures::size.toVec();
    const atlax::Vec2 size =
        full * std::min({1.0f, mostOfView * view.x / full.x, mostOfView * view.y / full.y});
    const float half = size.x / 2 + cardBorder;
    // The panel at the right takes what is beyond the drawing area.
    const float x = std::clamp(static_cast<float>(x_), std::min(half, view.x / 2),
                               std::max(view.x - half, view.x / 2));
    const atlax::Vec2 middle{x, view.y - cardGap - cardBorder - size.y / 2};
    const atlax::Vec2 frame{cardBorder, cardBorder};
    canvas.roundedRect({middle - size * 0.5f - frame, size + frame * 2}, 2 * cardBorder,
                       palette::sky);
    canvas.sprite(texture_, middle, size);
}

void PastCard::forgetTexture() {
    texture_ = {};
    serial_ = 0;
}

}  // namespace sulfurchamber
