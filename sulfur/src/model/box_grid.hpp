// A hashed grid of boxes in levels: a box stands in the cell of its middle, in the level whose
// cells are as large as itself. So grains and halls live in one world, each thing costs one entry,
// and whatever overlaps a box is found in the few cells around it in every level that is in use.
// (Hierarchical hash grid: Eitz and Lixu 2007.)
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "model/shapes.hpp"

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
        forEachWhile(chunks, low, high, [&](std::uint32_t c) {
            f(c);
            return true;
        });
    }
    /// The same, but that no more of a level are shown once f has returned false.
    template <class Function>
    void forEachWhile(const std::vector<Chunk>& chunks, const std::array<double, 2>& low,
                      const std::array<double, 2>& high, Function&& f) const {
        for (std::uint32_t level = 0; level < levels; ++level)
            if (count_[level] > 0) lookIn(chunks, level, low, high, f);
    }

    /// The same for every chunk whose box a disc may meet on its straight way, those of large boxes
    /// first. `enough`: the fraction of the way beyond which nothing interests; f may lessen it.
    template <class Function>
    void forEachAlong(const std::vector<Chunk>& chunks, const Point& from, const Point& way,
                      double radius, const double& enough, Function&& f) const {
        for (std::uint32_t level = levels; level-- > 0;)
            if (count_[level] > 0)
                lookAlong(level, {from, way, radius}, enough,
                          [&](std::uint32_t first, const Course& course) {
                              for (auto c = first; c != none; c = chunks[c].nextInCell)
                                  if (course.spanIn(chunks[c].low, chunks[c].high).enter <= enough)
                                      f(c);
                          });
    }
    /// The size of the cells of the finest level in use, m; 0 where there is nothing.
    double finestInUse() const {
        for (std::uint32_t level = 0; level < levels; ++level)
            if (count_[level] > 0) return sizeOf(level);
        return 0;
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

    /// A part of a way, as fractions; wrong way round for none.
    struct Span {
        double enter = 0, leave = 1;
    };
    /// The way of a disc.
    struct Course {
        Point from{0, 0}, way{0, 0};  // m
        double radius = 0;            // m

        void clip(std::size_t axis, double low, double high, Span& span) const {
            const auto k = static_cast<Eigen::Index>(axis);
            if (way[k] == 0) {
                if (from[k] < low - radius || from[k] > high + radius) span = {2, -1};
                return;
            }
            const double a = (low - radius - from[k]) / way[k];
            const double b = (high + radius - from[k]) / way[k];
            span.enter = std::max(span.enter, std::min(a, b));
            span.leave = std::min(span.leave, std::max(a, b));
        }
        /// Where it may be within a box; it enters beyond its end where it is not.
        Span spanIn(const std::array<double, 2>& low, const std::array<double, 2>& high) const {
            Span span;
            clip(0, low[0], high[0], span);
            clip(1, low[1], high[1], span);
            return span.enter <= span.leave ? span : Span{2, -1};
        }
    };

    /// m, of cells, a power of two; and how many of them are a metre long.
    static double sizeOf(std::uint32_t level) { return powerOfTwo(finest + int(level)); }
    static double perMetre(std::uint32_t level) { return powerOfTwo(-finest - int(level)); }
    static double powerOfTwo(int exponent) {
        constexpr std::uint64_t bias = 1023;
        return std::bit_cast<double>((bias + static_cast<std::uint64_t>(exponent)) << 52);
    }
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
        const double around = sizeOf(level) / 2, perM = perMetre(level);
        const double wide = (high[0] - low[0]) * perM + 2, tall = (high[1] - low[1]) * perM + 2;
        if (wide * tall > static_cast<double>(used_)) {
            for (const Cell& cell : cells_)
                if (cell.level == level && !lookThrough(chunks, cell.first, low, high, f)) return;
            return;
        }
        const auto cellAt = [&](double at) {
            return static_cast<std::int64_t>(std::floor(at * perM));
        };
        const auto x0 = cellAt(low[0] - around), x1 = cellAt(high[0] + around);
        const auto y0 = cellAt(low[1] - around), y1 = cellAt(high[1] + around);
        for (auto y = y0; y <= y1; ++y)
            for (auto x = x0; x <= x1; ++x) {
                const Cell& cell = cells_[find(level, x, y)];
                if (!lookThrough(chunks, cell.first, low, high, f)) return;
            }
    }
    /// Calls look(first chunk, course) for the cells whose boxes the course may meet: column by
    /// column along the longer side of the way, or all cells where these are fewer.
    template <class Function>
    void lookAlong(std::uint32_t level, const Course& course, const double& enough,
                   Function&& look) const {
        const double size = sizeOf(level), around = size / 2;
        const Eigen::Index major = std::abs(course.way[0]) >= std::abs(course.way[1]) ? 0 : 1,
                           minor = 1 - major;
        const double room = around + course.radius, length = course.way[major];
        const double first = course.from[major] - std::copysign(room, length);
        const double last = course.from[major] + length + std::copysign(room, length);
        const double columns = std::abs(last - first) / size + 1;
        if (columns * (2 * room / size + 3) > static_cast<double>(used_)) {
            for (const Cell& cell : cells_)
                if (cell.level == level) look(cell.first, course);
            return;
        }
        const std::int64_t step = length < 0 ? -1 : 1, end = cellOf(last, size) + step;
        for (auto column = cellOf(first, size); column != end; column += step) {
            Span span;
            const double low = static_cast<double>(column) * size;
            course.clip(static_cast<std::size_t>(major), low - around, low + size + around, span);
            if (span.enter > span.leave) continue;
            if (span.enter > enough) return;
            const double a = course.from[minor] + span.enter * course.way[minor];
            const double b = course.from[minor] + span.leave * course.way[minor];
            const auto top = cellOf(std::max(a, b) + room, size);
            for (auto row = cellOf(std::min(a, b) - room, size); row <= top; ++row) {
                const std::uint32_t at =
                    major == 0 ? find(level, column, row) : find(level, row, column);
                look(cells_[at].first, course);
            }
        }
    }
    template <class Function>
    static bool lookThrough(const std::vector<Chunk>& chunks, std::uint32_t first,
                            const std::array<double, 2>& low, const std::array<double, 2>& high,
                            Function&& f) {
        for (auto c = first; c != none;) {
            const auto next = chunks[c].nextInCell;
            if (meets(chunks[c], low, high) && !f(c)) return false;
            c = next;
        }
        return true;
    }

    std::vector<Cell> cells_ = std::vector<Cell>(64);
    std::uint64_t used_ = 0;                     // cells that something has been in
    std::array<std::uint32_t, levels> count_{};  // chunks by level
};

}  // namespace sulfur::detail
