// A hashed grid of boxes in levels: a box stands in the cell of its middle, in the level whose
// cells are as large as itself. So grains and halls live in one world, each thing costs one entry,
// and whatever overlaps a box is found in the few cells around it in every level that is in use.
// (Hierarchical hash grid: Eitz and Lixu 2007.)
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "shape/shapes.hpp"

namespace sulfur::detail {

class BoxGrid {
public:
    /// Enters a chunk by its box.
    void insert(std::vector<Chunk>& chunks, std::uint32_t chunk);
    void remove(std::vector<Chunk>& chunks, std::uint32_t chunk);

    /// Calls f(chunk) for every chunk whose box meets a box, in a fixed order.
    template <class Function>
    void forEachIn(const std::vector<Chunk>& chunks, const std::array<double, 2>& low,
                   const std::array<double, 2>& high, Function&& f) const {
        for (std::uint32_t level = 0; level < levels; ++level)
            if (count_[level] > 0) lookIn(chunks, level, low, high, f);
    }

    template <class Archive>
    void archive(Archive& a) {
        a(cells_);
        a(used_);
        a(count_);
    }

private:
    static constexpr std::uint32_t levels = 64;
    static constexpr int finest = -20;  // cells of 2^-20 m

    struct Cell {
        std::int64_t x = 0, y = 0;
        std::uint32_t level = none;  // none: nothing was ever here
        std::uint32_t first = none;  // chunk
    };

    static double sizeOf(std::uint32_t level) { return std::ldexp(1.0, finest + int(level)); }
    static std::int64_t cellOf(double at, double size) {
        return static_cast<std::int64_t>(std::floor(at / size));
    }
    static bool meets(const Chunk& c, const std::array<double, 2>& low,
                      const std::array<double, 2>& high) {
        return c.low[0] <= high[0] && low[0] <= c.high[0] && c.low[1] <= high[1] &&
               low[1] <= c.high[1];
    }
    static std::size_t hash(std::uint32_t level, std::int64_t x, std::int64_t y) {
        std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u +
                          static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu + level;
        h ^= h >> 29;
        h *= 0xbf58476d1ce4e5b9u;
        return static_cast<std::size_t>(h ^ (h >> 32));
    }
    /// The cell, or where it would be.
    std::uint32_t find(std::uint32_t level, std::int64_t x, std::int64_t y) const;
    void grow(std::vector<Chunk>& chunks);

    template <class Function>
    void lookIn(const std::vector<Chunk>& chunks, std::uint32_t level,
                const std::array<double, 2>& low, const std::array<double, 2>& high,
                Function&& f) const {
        // A box reaches half a cell beyond the cell of its middle.
        const double size = sizeOf(level), around = size / 2;
        const double wide = (high[0] - low[0]) / size + 2, tall = (high[1] - low[1]) / size + 2;
        if (wide * tall > static_cast<double>(used_)) {
            for (const Cell& cell : cells_)
                if (cell.level == level) lookThrough(chunks, cell.first, low, high, f);
            return;
        }
        const auto x1 = cellOf(high[0] + around, size), y1 = cellOf(high[1] + around, size);
        for (auto y = cellOf(low[1] - around, size); y <= y1; ++y)
            for (auto x = cellOf(low[0] - around, size); x <= x1; ++x) {
                const Cell& cell = cells_[find(level, x, y)];
                lookThrough(chunks, cell.first, low, high, f);
            }
    }
    template <class Function>
    static void lookThrough(const std::vector<Chunk>& chunks, std::uint32_t first,
                            const std::array<double, 2>& low, const std::array<double, 2>& high,
                            Function&& f) {
        for (auto c = first; c != none;) {
            const auto next = chunks[c].nextInCell;
            if (meets(chunks[c], low, high)) f(c);
            c = next;
        }
    }

    std::vector<Cell> cells_ = std::vector<Cell>(64);
    std::uint64_t used_ = 0;                     // cells that something has been in
    std::array<std::uint32_t, levels> count_{};  // chunks by level
};

}  // namespace sulfur::detail
