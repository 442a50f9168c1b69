// Contact rows in blocks of their colours, for as long as they live.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/set_bits.hpp"
#include "kernels/rows.hpp"
#include "model/movers.hpp"

namespace sulfur::detail {

/// Where a row is: the `index`-th of its colour.
struct RowPlace {
    std::uint32_t colour = none, index = 0;

    explicit operator bool() const { return colour != none; }
};

/// Blocks of rows of one kind and colour.
template <class Block, class Shape>
struct RowList {
    std::vector<Block> blocks;
    std::vector<Shape> shapes;
    std::vector<std::uint64_t> dirty;    // a bit for each block that has to be refreshed
    std::vector<std::uint8_t> pressing;  // by block, a bit for each lane: it did when last asked
    std::uint32_t rows = 0;

    template <class Archive>
    void archive(Archive& a) {
        a(blocks);
        a(shapes);
        a(dirty);
        a(pressing);
        a(rows);
    }
};
using ManifoldList = RowList<ManifoldBlock, ManifoldShape>;
using TouchList = RowList<TouchBlock, TouchShape>;

/// Rows by colour: no two of a colour push the same body. A colour lives as long as its rows;
/// a row that is taken away leaves its place to the last one.
struct RowGraph {
    static constexpr std::uint32_t colours = 64;
    /// Rows for which there was no colour left are alone in their blocks.
    static constexpr std::uint32_t overflow = colours - 1;

    std::array<ManifoldList, colours> manifolds;
    std::array<TouchList, colours> touches;

    /// Colours that have rows, from the lowest: most scenes have a few of them.
    SetBits inUse() const { return SetBits(used); }
    bool empty() const { return used == 0; }

    static std::uint32_t blockOf(RowPlace place) {
        return place.colour == overflow ? place.index : place.index / rowLanes;
    }
    /// How many rows a block has.
    template <class List>
    static std::uint32_t rowsIn(const List& list, std::uint32_t colour, std::size_t block) {
        return colour == overflow ? 1 : list.rows - static_cast<std::uint32_t>(block * rowLanes);
    }
    static std::uint32_t laneOf(RowPlace place) {
        return place.colour == overflow ? 0 : place.index % rowLanes;
    }

    /// A row between two bodies, or a corner and the ends of a side, without points or impulses.
    RowPlace addManifold(Movers& movers, std::uint32_t pair, std::uint32_t a, std::uint32_t b);
    RowPlace addTouch(Movers& movers, std::uint32_t touch, std::uint32_t p, std::uint32_t a,
                      std::uint32_t b);
    /// Takes a row away, without what it pushes. Returns which pair or touch now has its place, or
    /// none.
    std::uint32_t removeManifold(Movers& movers, RowPlace place);
    std::uint32_t removeTouch(Movers& movers, RowPlace place);

    /// Add impulses (kg m) to those of a point, of a manifold along its tangent, or of a touch, and
    /// what they push to the bodies.
    static void pressManifold(Movers& movers, ManifoldBlock& block, std::uint32_t lane, int point,
                              Real normal);
    static void rubManifold(Movers& movers, ManifoldBlock& block, std::uint32_t lane, Real tangent);
    static void pressTouch(Movers& movers, TouchBlock& block, std::uint32_t lane, Real normal,
                           Real tangent);

    const ManifoldBlock& manifold(RowPlace p) const {
        return manifolds[p.colour].blocks[blockOf(p)];
    }
    const ManifoldShape& manifoldShape(RowPlace p) const {
        return manifolds[p.colour].shapes[blockOf(p)];
    }
    const TouchBlock& touch(RowPlace p) const { return touches[p.colour].blocks[blockOf(p)]; }
    ManifoldBlock& manifold(RowPlace p) { return manifolds[p.colour].blocks[blockOf(p)]; }
    ManifoldShape& manifoldShape(RowPlace p) { return manifolds[p.colour].shapes[blockOf(p)]; }
    TouchBlock& touch(RowPlace p) { return touches[p.colour].blocks[blockOf(p)]; }
    TouchShape& touchShape(RowPlace p) { return touches[p.colour].shapes[blockOf(p)]; }
    void markManifold(RowPlace p) { mark(manifolds[p.colour].dirty, blockOf(p)); }
    void markTouch(RowPlace p) { mark(touches[p.colour].dirty, blockOf(p)); }

    /// Whether a row pressed when it was last asked.
    template <class Lists>
    static bool pressing(const Lists& lists, RowPlace p) {
        return (lists[p.colour].pressing[blockOf(p)] >> laneOf(p) & 1) != 0;
    }
    template <class Lists>
    static void setPressing(Lists& lists, RowPlace p) {
        auto& bits = lists[p.colour].pressing[blockOf(p)];
        bits = static_cast<std::uint8_t>(bits | 1u << laneOf(p));
    }

    std::size_t size() const {
        std::size_t sum = 0;
        for (const auto c : inUse()) sum += manifolds[c].rows + touches[c].rows;
        return sum;
    }
    std::size_t bytes() const {
        std::size_t sum = 0;
        const auto add = [&](const auto& list) {
            const std::size_t each = sizeof(list.blocks[0]) + sizeof(list.shapes[0]) + 1;
            sum += list.blocks.size() * each;
        };
        for (const auto& list : manifolds) add(list);
        for (const auto& list : touches) add(list);
        return sum;
    }

    template <class Archive>
    void archive(Archive& a) {
        for (auto& list : manifolds) list.archive(a);
        for (auto& list : touches) list.archive(a);
        for (std::uint32_t c = 0; c < colours; ++c) noteUse(c);
    }

private:
    std::uint64_t used = 0;  // a bit for each colour that has rows

    void noteUse(std::uint32_t colour) {
        const std::uint64_t bit = std::uint64_t{1} << colour;
        const bool hasRows = manifolds[colour].rows > 0 || touches[colour].rows > 0;
        used = hasRows ? used | bit : used & ~bit;
    }
    static void mark(std::vector<std::uint64_t>& dirty, std::uint32_t block) {
        dirty[block / 64] |= std::uint64_t{1} << block % 64;
    }
};

}  // namespace sulfur::detail
