#include "collision/query.hpp"

#include <algorithm>

#include "collision/geometry.hpp"
#include "collision/rasterise.hpp"
#include "core/error_checks.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

constexpr double maxQueryCoordinate = 1e7;  // m: cells are numbered by 32 bits

/// A place in units of cells, as a cell.
Cell cellAt(const Point& p) {
    return {static_cast<std::int32_t>(std::floor(p[0])),
            static_cast<std::int32_t>(std::floor(p[1]))};
}

CellBox common(const CellBox& a, const CellBox& b) {
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

bool contains(const CellBox& box, Cell cell) {
    return cell.x >= box.low.x && cell.x <= box.high.x && cell.y >= box.low.y &&
           cell.y <= box.high.y;
}

double cellCount(const CellBox& box) {
    return (static_cast<double>(box.high.x) - box.low.x + 1) *
           (static_cast<double>(box.high.y) - box.low.y + 1);
}

void collectFrom(const Grid& grid, const CellBox& region, std::uint32_t offset,
                 std::vector<std::uint32_t>& found) {
    const CellBox box = common(region, grid.bounds());
    if (box.empty()) return;
    const auto add = [&](std::uint32_t item) { found.push_back(offset + item); };
    if (cellCount(box) > static_cast<double>(grid.entries().size())) {
        for (const auto& [cell, item] : grid.entries())
            if (contains(box, cell)) add(item);
        return;
    }
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y)
        for (std::int32_t x = box.low.x; x <= box.high.x; ++x) grid.forEachIn({x, y}, add);
}

void tidy(std::vector<std::uint32_t>& found) {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace

void requireCoordinates(const Point& point, const char* what) {
    for (int axis = 0; axis < 2; ++axis)
        requireRange(point[axis], -maxQueryCoordinate, maxQueryCoordinate, what);
}

void prepareQuery(State& state) {
    refreshGrid(state, 0);
}

bool admits(const State& state, const QueryFilter& filter, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    return (body.filter.category & filter.mask) != 0 && body.id != filter.ignore &&
           (filter.sensors || !body.sensor) && (!filter.accept || filter.accept(body.id));
}

Span clip(const Point& from, const Point& way, const Point& low, const Point& high) {
    Span span;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0) {
            if (from[axis] < low[axis] || from[axis] > high[axis]) return {1, 0};
            continue;
        }
        const double a = (low[axis] - from[axis]) / way[axis];
        const double b = (high[axis] - from[axis]) / way[axis];
        span.enter = std::max(span.enter, std::min(a, b));
        span.leave = std::min(span.leave, std::max(a, b));
    }
    return span;
}

GridExtent extentOf(const BroadPhase& broad) {
    GridExtent extent;
    for (const Grid* grid : {&broad.movingGrid, &broad.fixedGrid}) {
        const CellBox& box = grid->bounds();
        if (box.empty()) continue;
        const Point low(box.low.x - 1.0, box.low.y - 1.0);
        const Point high(box.high.x + 2.0, box.high.y + 2.0);
        extent.low = extent.empty ? low : Point(extent.low.cwiseMin(low));
        extent.high = extent.empty ? high : Point(extent.high.cwiseMax(high));
        extent.empty = false;
    }
    return extent;
}

void collectInBox(const BroadPhase& broad, const Point& low, const Point& high,
                  std::vector<std::uint32_t>& found) {
    const CellBox box{cellAt(inCells(broad, low)), cellAt(inCells(broad, high))};
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    collectFrom(broad.movingGrid, box, 0, found);
    collectFrom(broad.fixedGrid, box, offset, found);
    forEachLarge(broad, [&](std::uint32_t i) { found.push_back(i); });
    tidy(found);
}

void collectAlong(const BroadPhase& broad, const Point& from, const Point& to, double radius,
                  std::vector<std::uint32_t>& found) {
    const Point margin(radius, radius);
    const GridExtent extent = extentOf(broad);
    const Point start = from / broad.cellSize, way = (to - from) / broad.cellSize;
    const Point room = margin / broad.cellSize;
    const Span span = clip(start, way, extent.low - room, extent.high + room);
    const Point first = start + span.enter * way, last = start + span.leave * way;
    const auto entries = broad.movingGrid.entries().size() + broad.fixedGrid.entries().size();
    if (extent.empty || span.empty())
        return forEachLarge(broad, [&](std::uint32_t i) { found.push_back(i); });
    if (cellsCovered(first, last, room[0]) > static_cast<double>(entries))
        return collectInBox(broad, from.cwiseMin(to) - margin, from.cwiseMax(to) + margin, found);
    rasteriseCapsule(first, last, room[0], [&](Cell cell) {
        forEachInCell(broad, cell, [&](std::uint32_t i) { found.push_back(i); });
    });
    forEachLarge(broad, [&](std::uint32_t i) { found.push_back(i); });
    tidy(found);
}

void collectAround(const BroadPhase& broad, const QueryShape& shape,
                   std::vector<std::uint32_t>& found) {
    const auto points = shape.points();
    if (points.size() <= 2)
        return collectAlong(broad, points.front(), points.back(), shape.radius(), found);
    Point low = points.front(), high = points.front();
    for (const Point& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Point margin(shape.radius(), shape.radius());
    collectInBox(broad, low - margin, high + margin, found);
}

std::vector<std::uint32_t> enclosing(State& state, const Point& point, const QueryFilter& filter) {
    BroadPhase& broad = state.broad;
    if (broad.hollows.stale(broad.runs)) broad.hollows.derive(state);
    std::vector<std::uint32_t> found;
    broad.hollows.forEachNear(point, [&](std::uint32_t body) {
        if (encloses(state, body, point) && admits(state, filter, body)) found.push_back(body);
    });
    tidy(found);
    return found;
}

CastHit hitAt(const State& state, const Strike& strike, const Point& point) {
    const Collider& c = state.broad.collider(strike.collider);
    const auto& x = state.particles.position;
    CastHit hit;
    hit.body = state.bodies[c.body].id;
    if (c.joint != none) hit.joint = state.joints.id[c.joint];
    hit.point = point;
    hit.normal = strike.entry.normal.cast<Real>();
    hit.fraction = strike.entry.fraction;
    const double along = nearestAlong<Point>(point, x[c.a], x[c.b]);
    hit.along = static_cast<Real>(along);
    hit.particle = state.particles.id[along < 0.5 ? c.a : c.b];
    return hit;
}

}  // namespace sulfur::detail
