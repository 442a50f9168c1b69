// Which colliders have been drawn near each other: those that share a cell, and whose boxes meet.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

#include "world/state.hpp"

namespace sulfur::detail {

/// Two colliders, the one of the smaller number first: both numbers in one, so that they are
/// quickly sorted.
class Found {
public:
    Found() = default;
    Found(std::uint32_t i, std::uint32_t j)
        : both_(std::uint64_t{std::min(i, j)} << 32 | std::max(i, j)) {}
    std::uint32_t first() const { return static_cast<std::uint32_t>(both_ >> 32); }
    std::uint32_t second() const { return static_cast<std::uint32_t>(both_); }
    friend auto operator<=>(const Found&, const Found&) = default;

private:
    std::uint64_t both_ = 0;
};

/// Pairs while they are being sorted. Scratch memory only.
struct FoundList {
    std::vector<Found> pairs, scratch;
    std::vector<std::uint32_t> start;

    void reserve(std::size_t count) {
        pairs.reserve(count);
        scratch.reserve(count);
    }
    /// Sorts them, and keeps each once. `colliders`: how many there are.
    void sort(std::size_t colliders);
};

/// A margin for the rounding of places that are 1e9 m away.
inline constexpr double rounding = 1e-6;

/// Of a collider as it is drawn now.
Surroundings surroundingsOf(const State& state, const Collider& c);

/// Whether boxes round two axes are no further apart than `gap`, in m.
inline bool areWithin(const Surroundings& a, const Surroundings& b, double gap) {
    // Twice the way from the middle of one to that of the other.
    const Point way = 2 * (b.start - a.start) + (b.along - a.along);
    return std::abs(way[0]) <= std::abs(a.along[0]) + std::abs(b.along[0]) + 2 * gap &&
           std::abs(way[1]) <= std::abs(a.along[1]) + std::abs(b.along[1]) + 2 * gap;
}

/// Whether two colliders may come to touch before one of them has left its skin.
inline bool areNear(const Surroundings& a, const Surroundings& b) {
    if (a.body == b.body && !a.meetsItself) return false;
    return areWithin(a, b, static_cast<double>(a.margin + b.margin));
}

/// Who comes near one collider after the other, each once. Scratch memory only.
class Neighbours {
public:
    void reserve(std::size_t colliders) {
        seenBy_.reserve(colliders);
        near_.reserve(colliders);
    }
    void begin(std::size_t colliders) { seenBy_.assign(colliders, none); }
    void beginOf(std::uint32_t collider) {
        collider_ = collider;
        near_.clear();
        seenBy_[collider] = collider;
    }
    void see(const BroadPhase& broad, std::uint32_t other) {
        if (seenBy_[other] == collider_) return;
        seenBy_[other] = collider_;
        if (areNear(broad.surroundings[collider_], broad.surroundings[other]))
            near_.push_back(other);
    }
    const std::vector<std::uint32_t>& sorted() {
        std::sort(near_.begin(), near_.end());
        return near_;
    }
    const std::vector<std::uint32_t>& unsorted() const { return near_; }

private:
    std::vector<std::uint32_t> near_, seenBy_;  // by collider: the last that has seen it
    std::uint32_t collider_ = none;
};

/// The pairs that share a cell of the coarser grids, sorted, each once.
void collectCoarsePairs(const State& state, FoundList& list);

/// Those of the pieces that have left their skins and were drawn again, sorted, each once.
void collectPairsOfLeft(const State& state, Neighbours& scratch, FoundList& list);

/// Where the cells of each moving collider begin in the grid's entries, if all were just drawn.
void findEntries(const BroadPhase& broad, std::vector<std::uint32_t>& start);

/// Calls f(first, second), sorted, for all pairs that are near each other and of which the first is
/// a moving collider in [begin, end), if all were just drawn. `start`: see findEntries(); `coarse`:
/// pairs of the coarser grids, sorted.
template <class Function>
void forEachNeighbour(const BroadPhase& broad, const std::vector<std::uint32_t>& start,
                      const std::vector<Found>& coarse, std::size_t begin, std::size_t end,
                      Neighbours& scratch, Function&& f) {
    const auto offset = static_cast<std::uint32_t>(broad.moving.size());
    scratch.begin(broad.surroundings.size());
    auto next = std::find_if(coarse.begin(), coarse.end(),
                             [&](const Found& pair) { return pair.first() >= begin; });
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
        scratch.beginOf(i);
        const auto see = [&](std::uint32_t j) { scratch.see(broad, j); };
        for (auto k = start[i]; k < start[i + 1]; ++k) {
            const Cell cell = broad.movingGrid.entries()[k].cell;
            broad.movingGrid.forEachAfter(cell, i, see);
            broad.fixedGrid.forEachIn(cell, [&](std::uint32_t j) { see(offset + j); });
        }
        for (; next != coarse.end() && next->first() == i; ++next) see(next->second());
        for (const auto j : scratch.sorted()) f(i, j);
    }
}

}  // namespace sulfur::detail
