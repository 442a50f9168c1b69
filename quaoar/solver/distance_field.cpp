#include "distance_field.hpp"

#include <cmath>
#include <functional>
#include <queue>
#include <tuple>

namespace quaoar {

using sulfur::Point;

namespace {

/// Whether nothing fixed stands between two places.
bool free(const sulfur::World& world, const Point& from, const Point& to) {
    const auto hit = world.castSegment(from, to, {.mask = Category::scenery});
    return !hit || world.kind(hit->body) != sulfur::BodyKind::fixed;
}

/// Whether the rope would reach something above from here.
bool supported(const Session& session, const Point& from) {
    constexpr double across[] = {-0.94, -0.77, -0.5, -0.17, 0.17, 0.5, 0.77, 0.94};
    const double reach = static_cast<double>(session.rope().rules().reach);
    for (const double x : across) {
        const Point to = from + Point(x, std::sqrt(1 - x * x)) * reach;
        if (session.world().castSegment(from, to, {.mask = Category::scenery})) return true;
    }
    return false;
}

}  // namespace

DistanceField::DistanceField(const Session& session) {
    const Level& level = session.level();
    origin_ = level.boundsMin;
    const Point size = level.boundsMax - level.boundsMin;
    width_ = static_cast<int>(std::ceil(size.x() / cell)) + 1;
    height_ = static_cast<int>(std::ceil(size.y() / cell)) + 1;
    distances_.assign(index(0, height_), unreachable);
    const Point exit = level.exit.position - origin_;
    flood(session, static_cast<int>(std::lround(exit.x() / cell)),
          static_cast<int>(std::lround(exit.y() / cell)));
}

Point DistanceField::place(int x, int y) const {
    return origin_ + Point(x * cell, y * cell);
}

void DistanceField::flood(const Session& session, int startX, int startY) {
    using Entry = std::tuple<double, int, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    distances_[index(startX, startY)] = 0;
    open.emplace(0.0, startX, startY);
    while (!open.empty()) {
        const auto [distance, x, y] = open.top();
        open.pop();
        if (distance > distances_[index(x, y)]) continue;
        const double weight = supported(session, place(x, y)) ? 1 : 2;
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const int nx = x + dx, ny = y + dy;
                if (nx < 0 || ny < 0 || nx >= width_ || ny >= height_) continue;
                const double step = cell * std::sqrt(static_cast<double>(dx * dx + dy * dy));
                const double next = distance + weight * step;
                if (next >= distances_[index(nx, ny)]) continue;
                if (place(nx, ny).y() < session.level().killDepth) continue;
                if (!free(session.world(), place(x, y), place(nx, ny))) continue;
                distances_[index(nx, ny)] = next;
                open.emplace(next, nx, ny);
            }
        }
    }
}

double DistanceField::at(const Point& where) const {
    const Point p = (where - origin_) / cell;
    const int x = static_cast<int>(std::lround(p.x())), y = static_cast<int>(std::lround(p.y()));
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return unreachable;
    return distances_[index(x, y)];
}

}  // namespace quaoar
