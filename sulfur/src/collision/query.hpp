// What all queries share: who is asked, and which colliders are near.
#pragma once

#include <cstdint>
#include <sulfur/queries.hpp>
#include <vector>

#include "collision/convex.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

/// Throws unless both coordinates are in the range of queries.
void requireCoordinates(const Point& point, const char* what);

/// Brings the grid up to date; it is a cache, so that queries may.
void prepareQuery(State& state);

/// Whether a filter lets a query see a body.
bool admits(const State& state, const QueryFilter& filter, std::uint32_t body);

/// The part of a straight way, as fractions, that is within a box; wrong way round for none.
struct Span {
    double enter = 0, leave = 1;

    bool empty() const { return enter > leave; }
};
Span clip(const Point& from, const Point& way, const Point& low, const Point& high);

/// The cells that the grids hold, with one around them, in units of cells.
struct GridExtent {
    Point low{0, 0}, high{0, 0};
    bool empty = true;
};
GridExtent extentOf(const BroadPhase& broad);

/// Appends the numbers of all colliders that are near a box, or near the way of a disc of
/// `radius`, each once and in order. Complexity: the cells covered, or all entries of the grids if
/// these are fewer.
void collectInBox(const BroadPhase& broad, const Point& low, const Point& high,
                  std::vector<std::uint32_t>& found);
void collectAlong(const BroadPhase& broad, const Point& from, const Point& to, double radius,
                  std::vector<std::uint32_t>& found);
/// The same for all that may touch a shape.
void collectAround(const BroadPhase& broad, const QueryShape& shape,
                   std::vector<std::uint32_t>& found);

/// Calls visit(number) for each collider in a cell.
template <class Visit>
void forEachInCell(const BroadPhase& broad, Cell cell, Visit&& visit) {
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    broad.movingGrid.forEachIn(cell, visit);
    broad.fixedGrid.forEachIn(cell, [&](std::uint32_t i) { visit(offset + i); });
}
/// Calls visit(number) for each collider that is in no cell because it would cover too many.
template <class Visit>
void forEachLarge(const BroadPhase& broad, Visit&& visit) {
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    for (const auto i : broad.largeMoving) visit(i);
    for (const auto i : broad.largeFixed) visit(offset + i);
}

/// The bodies whose outlines enclose a point, ascending by dense index, that `filter` admits.
std::vector<std::uint32_t> enclosing(State& state, const Point& point, const QueryFilter& filter);

/// Where the way of something meets a collider.
struct Strike {
    Entry entry;
    std::uint32_t collider = none;

    /// Ties are won by the lower number, so that the order of the cells decides nothing.
    friend bool operator<(const Strike& a, const Strike& b) {
        if (a.entry.fraction != b.entry.fraction) return a.entry.fraction < b.entry.fraction;
        return a.collider < b.collider;
    }
};

/// What a caller is told about a hit at `point`, which need not be on the surface exactly.
CastHit hitAt(const State& state, const Strike& strike, const Point& point);

}  // namespace sulfur::detail
