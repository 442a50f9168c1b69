#include "level_painter.hpp"

#include <algorithm>
#include <array>

#include "../model/level_hand.hpp"
#include "label_layout.hpp"
#include "palette.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {
namespace {

using atlax::Color;
using atlax::Vec2;

constexpr Color fresh = Color::hex(0x7CE0A3);
constexpr Color danger = Color::hex(0xE0457B);

constexpr float widestText = 0.4f;  // of the view
constexpr float leastTextWidth = 140;
constexpr float mostTextWidth = 320;  // logical pixels, as what follows
constexpr float shortTextWidth = 90;
constexpr Vec2 textMargin{4, 2};
constexpr Vec2 markSize{18, 18};
constexpr Vec2 clockSize{180, 58};  // at the upper right
constexpr float leftOfTexts = 40;   // rulers
constexpr float belowTexts = 20;

// Of glyphs, in units of the mark's radius.
constexpr std::array<Vec2, 4> flag{{{-0.3f, -0.55f}, {-0.3f, 0.55f}, {0.45f, 0.25f}, {-0.3f, 0}}};
constexpr std::array<Vec2, 5> shard{{{0, -0.6f}, {0.4f, 0}, {0, 0.6f}, {-0.4f, 0}, {0, -0.6f}}};
constexpr std::array<Vec2, 7> arrows{{{-0.25f, 0.3f},
                                      {-0.55f, 0},
                                      {-0.25f, -0.3f},
                                      {-0.55f, 0},
                                      {0.55f, 0},
                                      {0.25f, 0.3f},
                                      {0.55f, 0}}};
constexpr std::array<Vec2, 5> teeth{
    {{-0.6f, -0.35f}, {-0.3f, 0.45f}, {0, -0.35f}, {0.3f, 0.45f}, {0.6f, -0.35f}}};
constexpr std::array<Vec2, 4> button{{{-0.5f, -0.3f}, {-0.3f, 0.2f}, {0.3f, 0.2f}, {0.5f, -0.3f}}};
constexpr std::array<Vec2, 3> fall{{{-0.35f, 0.1f}, {0, -0.5f}, {0.35f, 0.1f}}};
constexpr std::array<Vec2, 4> lines{{{-0.4f, 0.25f}, {0.4f, 0.25f}, {-0.4f, -0.2f}, {0.1f, -0.2f}}};

}  // namespace

Color colourOf(LevelKind kind) {
    switch (kind) {
        case LevelKind::spawn:
        case LevelKind::checkpoint:
            return fresh;
        case LevelKind::exit:
        case LevelKind::pickup:
            return palette::amber;
        case LevelKind::killDepth:
        case LevelKind::monster:
        case LevelKind::surface:
            return danger;
        case LevelKind::zone:
        case LevelKind::mover:
            return palette::cold;
        case LevelKind::trigger:
        case LevelKind::respawn:
            return Color::hex(0xC9A0FF);
        default:
            return palette::ice;
    }
}

void LevelPainter::read(const Document& document) {
    const bool moves = document.canReset();  // marks of bodies follow them
    if (!moves && revision_ == document.revision()) return;
    revision_ = document.revision();
    shapes_.clear();
    for (const LevelThing& thing : levelThings(document))
        shapes_.push_back(shapeOf(document, thing));
}

void LevelPainter::paint(atlax::Canvas& canvas, const atlax::Camera& camera,
                         const atlax::Font& font, const Workbench& bench) {
    const Document& document = bench.document();
    read(document);
    if (shapes_.empty()) return;
    canvas.setCamera(camera);
    canvas_ = &canvas;
    pixel_ = canvas.pixel() * canvas.scaleFactor();
    const auto isSelected = [&](const LevelShape& shape) {
        return std::binary_search(bench.things().begin(), bench.things().end(), shape.thing);
    };
    for (const LevelShape& shape : shapes_)
        if (shape.thing.kind == LevelKind::bounds) paintOutside(shape.box);
    for (const LevelShape& shape : shapes_)
        if (isSelected(shape) || isShown(document, shape.thing))
            paintShape(shape, isSelected(shape));
    for (const LevelShape& shape : shapes_)
        if (isSelected(shape)) paintHandles(shape);
    canvas.setScreenSpace(canvas.scaleFactor());
    const auto isNamed = [&](const LevelShape& shape) {
        const LevelKind kind = shape.thing.kind;
        return isShown(document, shape.thing) && shape.form != LevelShape::Form::none &&
               (kind == LevelKind::hint || kind == LevelKind::zone || kind == LevelKind::trigger);
    };
    paintTexts(camera, font, isSelected, isNamed);
}

// What the player never sees steps back.
void LevelPainter::paintOutside(const Bounds& box) {
    const Vec2 low(box.low), high(box.high);
    const float far = 2000;  // metres
    const Color shade = palette::deep.withAlpha(0.66f);
    canvas_->rect({{low.x - far, high.y}, {high.x - low.x + 2 * far, far}}, shade);
    canvas_->rect({{low.x - far, low.y - far}, {high.x - low.x + 2 * far, far}}, shade);
    canvas_->rect({{low.x - far, low.y}, {far, high.y - low.y}}, shade);
    canvas_->rect({{high.x, low.y}, {far, high.y - low.y}}, shade);
}

void LevelPainter::paintShape(const LevelShape& shape, bool selected) {
    const Color color = selected ? palette::ice : colourOf(shape.thing.kind);
    switch (shape.form) {
        case LevelShape::Form::none:
            return;
        case LevelShape::Form::rectangle:
            paintBox(shape, color, selected);
            break;
        case LevelShape::Form::level: {
            const auto y = static_cast<float>(shape.at.y());
            canvas_->dashedLine({-1000, y}, {1000, y}, (selected ? 2.5f : 1.5f) * pixel_,
                                10 * pixel_, 6 * pixel_, color.withAlpha(0.8f));
            return;
        }
        case LevelShape::Form::way:
            paintWay(shape, color);
            break;
        case LevelShape::Form::point:
            if (shape.radius > 0)
                canvas_->circleOutline(Vec2(shape.at), static_cast<float>(shape.radius),
                                       1.5f * pixel_, color.withAlpha(0.8f));
            break;
    }
    if (shape.thing.kind != LevelKind::bounds) paintMark(shape, color, selected);
}

void LevelPainter::paintBox(const LevelShape& shape, Color color, bool selected) {
    const Vec2 low(shape.box.low), high(shape.box.high);
    const std::array<Vec2, 4> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
    const bool bounds = shape.thing.kind == LevelKind::bounds;
    if (!bounds) canvas_->polygon(corners, color.withAlpha(selected ? 0.16f : 0.08f));
    const float width = (selected ? 2.2f : 1.3f) * pixel_;
    for (std::size_t i = 0; i < 4; ++i)
        canvas_->dashedLine(corners[i], corners[(i + 1) % 4], width, (bounds ? 12 : 6) * pixel_,
                            4 * pixel_, color.withAlpha(bounds ? 0.55f : 0.9f));
}

void LevelPainter::paintWay(const LevelShape& shape, Color color) {
    for (std::size_t i = 1; i < shape.way.size(); ++i) {
        const Vec2 from(shape.way[i - 1]), to(shape.way[i]);
        canvas_->dashedLine(from, to, 1.6f * pixel_, 6 * pixel_, 4 * pixel_, color);
        canvas_->circle(to, 3.5f * pixel_, color);
    }
}

void LevelPainter::paintMark(const LevelShape& shape, Color color, bool selected) {
    const Vec2 at(markOf(shape, static_cast<double>(reachPixels * pixel_)));
    const float radius = 9 * pixel_;
    canvas_->circle(at, radius, palette::deep.withAlpha(0.86f));
    canvas_->circleOutline(at, radius, (selected ? 2.4f : 1.5f) * pixel_, color);
    paintGlyph(shape.thing.kind, at, color);
}

void LevelPainter::paintGlyph(LevelKind kind, Vec2 at, Color color) {
    const float size = 8 * pixel_;
    const auto stroke = [&](const auto& points) {
        std::vector<Vec2> way;
        for (const Vec2 point : points) way.push_back(at + point * size);
        canvas_->polyline(way, 1.5f * pixel_, color);
    };
    switch (kind) {
        case LevelKind::spawn:
            canvas_->circle(at, 0.45f * size, color);
            break;
        case LevelKind::exit:
            canvas_->circleOutline(at, 0.5f * size, 1.8f * pixel_, color);
            canvas_->circle(at, 0.18f * size, color);
            break;
        case LevelKind::checkpoint:
            stroke(flag);
            break;
        case LevelKind::pickup:
            stroke(shard);
            break;
        case LevelKind::mover:
            stroke(arrows);
            break;
        case LevelKind::surface:
            stroke(teeth);
            break;
        case LevelKind::trigger:
            stroke(button);
            break;
        case LevelKind::respawn:
            stroke(fall);
            break;
        case LevelKind::monster:
            canvas_->circle(at + Vec2{-0.28f, 0.1f} * size, 0.2f * size, color);
            canvas_->circle(at + Vec2{0.28f, 0.1f} * size, 0.2f * size, color);
            break;
        case LevelKind::zone:
            canvas_->rect({at - Vec2{0.4f, 0.4f} * size, Vec2{0.8f, 0.8f} * size},
                          color.withAlpha(0.5f));
            break;
        default:
            canvas_->line(at + lines[0] * size, at + lines[1] * size, 1.5f * pixel_, color);
            canvas_->line(at + lines[2] * size, at + lines[3] * size, 1.5f * pixel_, color);
            break;
    }
}

void LevelPainter::paintHandles(const LevelShape& shape) {
    const float half = 4 * pixel_;
    for (const sulfur::Point& handle : shape.handles) {
        const Vec2 at(handle);
        canvas_->rect({at - Vec2{half, half}, {2 * half, 2 * half}}, palette::ice);
        canvas_->rect({at - Vec2{half, half} * 0.6f, Vec2{2 * half, 2 * half} * 0.6f},
                      palette::amber);
    }
}

// Hints are read as the player sees them; names are for zones, switches, and what is selected. What
// is selected is placed first: where many stand together, others are shortened or have no room.
void LevelPainter::paintTexts(const atlax::Camera& camera, const atlax::Font& font,
                              const ShapeTest& isSelected, const ShapeTest& isNamed) {
    const float scale = canvas_->scaleFactor();
    const Vec2 view = canvas_->size().toVec() / scale;
    std::vector<Text> texts;
    std::vector<LabelWish> wishes;
    std::vector<atlax::Rect> taken{{{view.x - clockSize.x, 0}, clockSize}};
    const auto markAt = [&](const LevelShape& shape) {
        const sulfur::Point place = markOf(shape, static_cast<double>(reachPixels * pixel_));
        return camera.toScreen(Vec2(place), canvas_->size()) / scale;
    };
    const auto add = [&](const LevelShape& shape, bool selected) {
        texts.push_back(textOf(shape, font, selected, view.x));
        wishes.push_back({markAt(shape), texts.back().extent(font, texts.back().words),
                          texts.back().extent(font, texts.back().shorter), selected});
    };
    for (const LevelShape& shape : shapes_)
        if (isSelected(shape) && shape.form != LevelShape::Form::none) add(shape, true);
    for (const LevelShape& shape : shapes_) {
        if (!isSelected(shape) && isNamed(shape)) add(shape, false);
        if (shape.form != LevelShape::Form::none && shape.form != LevelShape::Form::level &&
            shape.thing.kind != LevelKind::bounds)
            taken.push_back(atlax::Rect::around(markAt(shape), markSize));
    }
    const atlax::Rect area{{leftOfTexts, 0}, {view.x - leftOfTexts, view.y - belowTexts}};
    const auto places = placeLabels(wishes, area, taken);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (!places[i]) continue;
        canvas_->roundedRect(places[i]->plate, 4, palette::deep.withAlpha(0.7f));
        canvas_->text(font, places[i]->isShort ? texts[i].shorter : texts[i].words,
                      places[i]->plate.min + textMargin,
                      {texts[i].size, texts[i].color, atlax::AlignX::Left, atlax::AlignY::Top});
    }
}

LevelPainter::Text LevelPainter::textOf(const LevelShape& shape, const atlax::Font& font,
                                        bool selected, float viewWidth) {
    Text text;
    text.size = shape.thing.kind == LevelKind::hint ? 14 : 12;
    text.color = selected ? palette::ice : colourOf(shape.thing.kind);
    text.words = font.wrap(shape.label, text.size,
                           std::clamp(viewWidth * widestText, leastTextWidth, mostTextWidth));
    const std::string parts = font.wrap(shape.label, text.size, shortTextWidth);
    const std::size_t end = parts.find('\n');
    text.shorter = end == std::string::npos ? parts : parts.substr(0, end) + "…";
    return text;
}

Vec2 LevelPainter::Text::extent(const atlax::Font& font, const std::string& what) const {
    const auto extent = font.measure(what, size);
    return Vec2{extent.width, extent.height} + textMargin * 2.0f;
}

}  // namespace sulfurchamber
