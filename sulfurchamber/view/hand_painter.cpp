// What the hand works with in the painter of scenes: handles, what snaps, what a tool is about to
// do.
#include <algorithm>
#include <array>
#include <cmath>

#include "../model/transform.hpp"
#include "palette.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {

using atlax::Color;
using atlax::Vec2;

void ScenePainter::paintHandles(const Workbench& bench) {
    const auto frame = selectionFrame(bench);
    if (!frame) return;
    const auto handles = handlesOf(*frame, static_cast<double>(reachPixels * pixel_));
    const Color faint = palette::sky.withAlpha(0.5f);
    std::vector<Vec2> corners;
    for (const Handle& handle : handles)
        if (handle.kind == Handle::Kind::corner) corners.emplace_back(handle.at);
    canvas_->polygonOutline(corners, pixel_, faint);
    canvas_->line(Vec2(handles[6].at), Vec2(handles[8].at), pixel_, faint);
    for (const Handle& handle : handles) {
        const Vec2 at(handle.at);
        const bool corner = handle.kind == Handle::Kind::corner;
        if (handle.kind == Handle::Kind::turn) {
            canvas_->circle(at, 5 * pixel_, palette::ice);
            canvas_->circle(at, 3 * pixel_, palette::amber);
            continue;
        }
        const float half = (corner ? 4.0f : 3.2f) * pixel_;
        const Color inner = corner ? palette::steel : palette::cold;
        canvas_->rect({at - Vec2{half, half}, {2 * half, 2 * half}}, palette::ice);
        canvas_->rect({at - Vec2{half, half} * 0.6f, Vec2{2 * half, 2 * half} * 0.6f}, inner);
    }
}

void ScenePainter::paintFrame(const std::vector<sulfur::Point>& corners) {
    std::vector<Vec2> places;
    for (const sulfur::Point& corner : corners) places.emplace_back(corner);
    canvas_->polygon(places, palette::amber.withAlpha(0.14f));
    canvas_->polygonOutline(places, 1.6f * pixel_, palette::amber);
}

// A cross on the grid, a square at a corner, a circle at a centre, the line of an angle.
void ScenePainter::paintSnap(const SnapPlace& place) {
    const Vec2 at(place.at);
    const float size = 6 * pixel_;
    const float width = 1.6f * pixel_;
    const Color color = palette::hot;
    const std::array<Vec2, 4> square{at + Vec2{-size, -size}, at + Vec2{size, -size},
                                     at + Vec2{size, size}, at + Vec2{-size, size}};
    switch (place.kind) {
        case SnapPlace::Kind::grid:
            canvas_->line(at - Vec2{size, 0}, at + Vec2{size, 0}, width, color);
            canvas_->line(at - Vec2{0, size}, at + Vec2{0, size}, width, color);
            break;
        case SnapPlace::Kind::corner:
            canvas_->polygonOutline(square, width, color);
            break;
        case SnapPlace::Kind::centre:
            canvas_->circleOutline(at, size, width, color);
            canvas_->circle(at, 1.6f * pixel_, color);
            break;
        case SnapPlace::Kind::angle: {
            const Vec2 way = at - Vec2(place.from);
            canvas_->dashedLine(Vec2(place.from), at + way * 0.4f, pixel_, 4 * pixel_, 4 * pixel_,
                                color);
            break;
        }
    }
}

// Where the picture of a body lies, with the handles that move it.
void ScenePainter::paintSkinFrame(const Preview& preview) {
    std::vector<Vec2> corners;
    for (const sulfur::Point& corner : preview.points) corners.emplace_back(corner);
    if (corners.size() != 4) return;
    canvas_->polygonOutline(corners, 1.6f * pixel_, palette::amber);
    const Vec2 knob(preview.to);
    canvas_->line((corners[2] + corners[3]) * 0.5f, knob, 1.2f * pixel_, palette::amber);
    for (const Vec2& corner : corners) {
        const Vec2 half = Vec2{4, 4} * pixel_;
        canvas_->rect({corner - half, half * 2.0f}, palette::ice);
        canvas_->rect({corner - half * 0.6f, half * 1.2f}, palette::amber);
    }
    canvas_->circle(knob, 5 * pixel_, palette::ice);
    canvas_->circle(knob, 3 * pixel_, palette::amber);
}

void ScenePainter::paintPreview(const Preview& preview) {
    const Vec2 from = preview.from;
    const Vec2 to = preview.to;
    const Vec2 low{std::min(from.x, to.x), std::min(from.y, to.y)};
    const atlax::Rect rect{low, {std::abs(to.x - from.x), std::abs(to.y - from.y)}};
    const float width = 1.6f * pixel_;
    const std::array<Vec2, 4> corners{low, Vec2{rect.max().x, low.y}, rect.max(),
                                      Vec2{low.x, rect.max().y}};
    switch (preview.kind) {
        case Preview::Kind::none:
            break;
        case Preview::Kind::rectangle:
            canvas_->polygon(corners, palette::amber.withAlpha(0.14f));
            canvas_->polygonOutline(corners, width, palette::amber);
            break;
        case Preview::Kind::band:
            canvas_->polygon(corners, palette::sky.withAlpha(0.12f));
            canvas_->polygonOutline(corners, width, palette::sky);
            break;
        case Preview::Kind::circle:
            canvas_->circle(from, static_cast<float>(preview.size),
                            palette::amber.withAlpha(0.14f));
            canvas_->circleOutline(from, static_cast<float>(preview.size), width, palette::amber);
            break;
        case Preview::Kind::line:
            canvas_->line(from, to, 2 * width, palette::amber.withAlpha(0.8f));
            canvas_->circle(from, 4 * pixel_, palette::amber);
            canvas_->circle(to, 4 * pixel_, palette::amber);
            break;
        case Preview::Kind::outline:
            for (std::size_t i = 1; i < preview.points.size(); ++i)
                canvas_->line(Vec2(preview.points[i - 1]), Vec2(preview.points[i]), width,
                              palette::amber);
            canvas_->dashedLine(to, from, width, 6 * pixel_, 4 * pixel_,
                                palette::amber.withAlpha(0.6f));
            canvas_->circle(from, 4 * pixel_, palette::amber);
            break;
        case Preview::Kind::path:
            for (std::size_t i = 0; i < preview.points.size(); ++i) {
                const Vec2 at(preview.points[i]);
                if (i > 0) canvas_->line(Vec2(preview.points[i - 1]), at, width, palette::amber);
                canvas_->circle(at, 4 * pixel_, palette::amber);
            }
            break;
        case Preview::Kind::arrow:
            arrow(from, to, palette::amber);
            canvas_->circle(from, 4 * pixel_, palette::amber);
            break;
        case Preview::Kind::ruler: {
            const float length = atlax::length(to - from);
            if (!(length > 0)) break;
            const Vec2 across = atlax::perpendicular((to - from) / length) * (6 * pixel_);
            canvas_->line(from, to, width, palette::amber);
            canvas_->line(from - across, from + across, width, palette::amber);
            canvas_->line(to - across, to + across, width, palette::amber);
            canvas_->dashedLine(from, from + Vec2{length / 2, 0}, pixel_, 4 * pixel_, 4 * pixel_,
                                palette::amber.withAlpha(0.6f));
            break;
        }
        case Preview::Kind::frame:
            paintFrame(preview.points);
            break;
        case Preview::Kind::skin:
            paintSkinFrame(preview);
            break;
        case Preview::Kind::stroke:
            canvas_->dashedLine(from, to, 2 * pixel_, 8 * pixel_, 5 * pixel_, palette::hot);
            break;
        case Preview::Kind::spring:
            canvas_->dashedLine(from, to, 2 * pixel_, 6 * pixel_, 4 * pixel_, palette::ice);
            canvas_->circle(from, 4 * pixel_, palette::ice);
            canvas_->circleOutline(to, 7 * pixel_, 2 * pixel_, palette::ice);
            break;
    }
}

}  // namespace sulfurchamber
