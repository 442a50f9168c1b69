#include <quaoar/skin/outline.hpp>
#include <quaoar/view/open_space.hpp>

#include <algorithm>
#include <cmath>

namespace quaoar {

using atlax::Rect;
using atlax::Vec2;

namespace {
/// Metres around the bounds that the grid knows: a camera that follows a fall looks there.
constexpr float gridMargin = 6;
constexpr float mostCells = 2e6f;
}  // namespace

std::vector<FixedShape> fixedShapes(const Session& session) {
    std::vector<FixedShape> shapes;
    const Level& level = session.level();
    for (const sulfur::scene::Placement& body : level.scene.bodies) {
        const sulfur::Blueprint plan = sulfur::scene::blueprintOf(level.scene, body);
        if (plan.kind != sulfur::BodyKind::fixed) continue;
        const Surface surface = level.surface(body.id);
        if (surface.look == Surface::Look::peg || surface.crumbles) continue;
        const std::vector<std::uint32_t> loop = outlineOf(plan);
        const sulfur::BodyId id = session.instance().body(body.id);
        if (loop.empty() || !session.world().contains(id)) continue;
        FixedShape shape;
        shape.id = id;
        shape.name = body.id;
        for (const std::uint32_t i : loop) {
            shape.loop.emplace_back(session.world().position(session.world().particles(id)[i]));
        }
        for (const auto& joint : plan.joints) {
            shape.radius = std::max(shape.radius, static_cast<float>(joint.radius));
        }
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

OpenSpace::OpenSpace(const Level& level, const std::vector<FixedShape>& shapes) {
    low_ = Vec2(level.boundsMin) - Vec2{gridMargin, gridMargin};
    const Vec2 size = Vec2(level.boundsMax) + Vec2{gridMargin, gridMargin} - low_;
    cell_ = std::max(0.1f, std::sqrt(size.x * size.y / mostCells));
    columns_ = static_cast<int>(size.x / cell_) + 1;
    rows_ = static_cast<int>(size.y / cell_) + 1;
    cells_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    for (const FixedShape& shape : shapes) fill(shape.loop);
    rock_ = summed(cells_);
    std::vector<char> closed = cells_;
    const Rect bounds{Vec2(level.boundsMin), Vec2(level.boundsMax) - Vec2(level.boundsMin)};
    for (int y = 0; y < rows_; ++y) {
        for (int x = 0; x < columns_; ++x) {
            const Vec2 at =
                low_ + Vec2{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f} * cell_;
            if (!bounds.contains(at)) closed[static_cast<std::size_t>(y * columns_ + x)] = 1;
        }
    }
    closed_ = summed(closed);
}

/// Row by row between every other crossing of the border.
void OpenSpace::fill(const std::vector<Vec2>& loop) {
    std::vector<float> crossings;
    for (int row = 0; row < rows_; ++row) {
        const float y = low_.y + (static_cast<float>(row) + 0.5f) * cell_;
        crossings.clear();
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
            const Vec2 a = loop[i], b = loop[j];
            if ((a.y > y) == (b.y > y)) continue;
            crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const auto column = [&](float x) {
                const float part = std::round((x - low_.x) / cell_);
                return static_cast<int>(std::clamp(part, 0.0f, static_cast<float>(columns_)));
            };
            const int from = column(crossings[k]), to = column(crossings[k + 1]);
            const auto start = cells_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
            std::fill(start + from, start + to, char{1});
        }
    }
}

OpenSpace::Sums OpenSpace::summed(const std::vector<char>& cells) const {
    const auto width = static_cast<std::size_t>(columns_) + 1;
    Sums sums(width * (static_cast<std::size_t>(rows_) + 1), 0);
    for (std::size_t y = 0; y < static_cast<std::size_t>(rows_); ++y) {
        float row = 0;
        for (std::size_t x = 0; x < static_cast<std::size_t>(columns_); ++x) {
            row += static_cast<float>(cells[y * (width - 1) + x]);
            sums[(y + 1) * width + x + 1] = sums[y * width + x + 1] + row;
        }
    }
    return sums;
}

/// Between the corners of the grid the sum of cells of one value each is bilinear.
float OpenSpace::sumAt(const Sums& sums, Vec2 at) const {
    const float x = std::clamp((at.x - low_.x) / cell_, 0.0f, static_cast<float>(columns_));
    const float y = std::clamp((at.y - low_.y) / cell_, 0.0f, static_cast<float>(rows_));
    const auto column =
        std::min(static_cast<std::size_t>(x), static_cast<std::size_t>(columns_ - 1));
    const auto row = std::min(static_cast<std::size_t>(y), static_cast<std::size_t>(rows_ - 1));
    const float u = x - static_cast<float>(column), v = y - static_cast<float>(row);
    const std::size_t width = static_cast<std::size_t>(columns_) + 1;
    const float* below = &sums[row * width + column];
    const float* above = below + width;
    return (below[0] * (1 - u) + below[1] * u) * (1 - v) + (above[0] * (1 - u) + above[1] * u) * v;
}

float OpenSpace::share(const Sums& sums, Rect rect) const {
    const Vec2 a = rect.min, b = rect.max();
    const float sum =
        sumAt(sums, b) - sumAt(sums, {a.x, b.y}) - sumAt(sums, {b.x, a.y}) + sumAt(sums, a);
    const float cells = rect.size.x * rect.size.y / (cell_ * cell_);
    return cells > 0 ? std::clamp(sum / cells, 0.0f, 1.0f) : 0;
}

bool OpenSpace::isRock(Vec2 at) const {
    const int x = static_cast<int>(std::floor((at.x - low_.x) / cell_));
    const int y = static_cast<int>(std::floor((at.y - low_.y) / cell_));
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return false;
    return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(x)] != 0;
}

}  // namespace quaoar
