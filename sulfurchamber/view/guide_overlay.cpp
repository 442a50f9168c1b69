#include "guide_overlay.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "../model/words.hpp"
#include "palette.hpp"

namespace sulfurchamber {
namespace {

using atlax::Vec2;

constexpr float cardWidth = 304;  // logical pixels, as what follows
constexpr float cardMargin = 10;
constexpr float filmShape = 192.0f / 284;  // height by width
constexpr float textSize = 13;
constexpr float rowHeight = 17;

// The pointer as it is known, its tip at a place of the present world space.
void paintHand(atlax::Canvas& canvas, Vec2 tip, bool pressed, float pixel) {
    static constexpr std::array<Vec2, 7> shape{{{0, 0},
                                                {0, -17},
                                                {4.2f, -13.2f},
                                                {7.2f, -19.6f},
                                                {9.8f, -18.4f},
                                                {6.8f, -12.2f},
                                                {12, -12}}};
    if (pressed) canvas.circleOutline(tip, 9 * pixel, 2 * pixel, palette::amber);
    std::array<Vec2, shape.size()> points{};
    for (std::size_t i = 0; i < shape.size(); ++i) points[i] = tip + shape[i] * pixel;
    canvas.polygon(points, palette::ice);
    canvas.polygonOutline(points, 1.2f * pixel, palette::deep);
}

// A camera that shows the frame of films in a rectangle of the canvas, in pixels.
atlax::Camera filmCamera(const atlax::Rect& picture, atlax::PixelSize canvas) {
    const Bounds frame = toolDemoFrame();
    atlax::Camera camera;
    camera.pixelsPerMetre = picture.size.x / static_cast<float>(frame.size().x());
    const Vec2 off = (picture.centre() - canvas.toVec() * 0.5f) / camera.pixelsPerMetre;
    camera.centre = Vec2(frame.centre()) + Vec2{-off.x, off.y};
    return camera;
}

}  // namespace

std::string invitation(const Document& document) {
    // Quickly told first: it is asked for each frame.
    if (document.canUndo() || document.canReset() || document.world().bodies().size() > 1)
        return "";
    if (interestingBounds(document.world())) return "";
    return tr("Choose a tool at the left and drag here to build; F1 opens examples");
}

void GuideOverlay::showFilm(std::optional<ToolKind> tool, std::string name) {
    if (tool == film()) return;
    filmName_ = std::move(name);
    film_.reset();
    painter_ = {};
    if (tool) film_ = std::make_unique<ToolDemo>(*tool);
}

std::optional<ToolKind> GuideOverlay::film() const {
    return film_ ? std::optional(film_->tool()) : std::nullopt;
}

void GuideOverlay::showHand(std::optional<sulfur::Point> place, bool pressed) {
    hand_ = place;
    handPressed_ = pressed;
}

void GuideOverlay::paint(atlax::Canvas& canvas, const atlax::Font& font, const Workbench& bench,
                         const atlax::Camera& camera, float inset, double seconds) {
    const float scale = canvas.scaleFactor();
    if (hand_) {
        canvas.setCamera(camera);
        paintHand(canvas, Vec2(*hand_), handPressed_, scale / camera.pixelsPerMetre);
    }
    canvas.setScreenSpace(scale);
    if (const std::string words = invitation(bench.document()); !words.empty() && !film_) {
        const Vec2 size = canvas.size().toVec() / scale;
        const float width = size.x - inset - 40;
        canvas.text(font, font.wrap(words, 17, width), {(size.x + inset) / 2, size.y * 0.4f},
                    {17, palette::ice.withAlpha(0.85f), atlax::AlignX::Centre});
    }
    if (!film_) return;
    film_->advance(seconds);
    paintFilm(canvas, font, inset);
}

void GuideOverlay::paintFilm(atlax::Canvas& canvas, const atlax::Font& font, float inset) {
    const float scale = canvas.scaleFactor();
    const float width = std::min(cardWidth, canvas.size().toVec().x / scale - inset - 24);
    const float inner = width - 2 * cardMargin;
    const std::string hint = font.wrap(tr(film_->bench().hint()), textSize, inner);
    const auto rows = static_cast<float>(2 + std::count(hint.begin(), hint.end(), '\n'));
    const atlax::Rect card{{inset + 12, 12},
                           {width, inner * filmShape + rows * rowHeight + 3 * cardMargin}};
    const atlax::Rect picture{card.min + Vec2{cardMargin, cardMargin}, {inner, inner * filmShape}};
    canvas.roundedRect(card, 8, palette::steel.withAlpha(0.97f));
    canvas.gradientRect(picture, palette::above, palette::deep);
    canvas.pushClip(picture);
    const atlax::Camera camera =
        filmCamera({picture.min * scale, picture.size * scale}, canvas.size());
    canvas.setCamera(camera);
    ViewOptions options;
    options.grid = options.rulers = false;
    painter_.paint(canvas, film_->bench(), options, 1);
    canvas.setCamera(camera);
    paintHand(canvas, Vec2(film_->hand().place()), film_->hand().pressed(),
              scale / camera.pixelsPerMetre);
    canvas.popClip();
    canvas.setScreenSpace(scale);
    const auto share = static_cast<float>(film_->time() / ToolDemo::seconds);
    canvas.rect({{picture.min.x, picture.max().y}, {picture.size.x * share, 2}}, palette::amber);
    const Vec2 below{picture.min.x, picture.max().y + cardMargin + rowHeight * 0.8f};
    canvas.text(font, filmName_, below, {textSize + 1, palette::amber});
    canvas.text(font, hint, below + Vec2{0, rowHeight}, {textSize, palette::ice});
}

}  // namespace sulfurchamber
