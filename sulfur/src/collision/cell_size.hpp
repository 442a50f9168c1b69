// How large the cells of the grid should be.
#pragma once

#include <array>
#include <cstddef>

namespace sulfur::detail {

/// More cells than this are too many for one moving collider: it stands in a coarser grid instead.
inline constexpr double mostCellsMoving = 2000;

/// The sizes of the moving colliders, by powers of two, and what grids of any cell size would cost
/// with them.
///
/// The cost of a cell size s, in units of one cell, is the sum over the colliders of
/// - the cells that it covers: with length L and thickness T, on average over all places and
///   directions about ((L + T) / s + 1) (1.2 T / s + 1.5), but no more than mostCellsMoving;
/// - the others that it shares its cell with, each a pair to be sorted out. They are at most as
///   many as lie in a cell when things of its size d = L + T are packed, (s / d)^2, and at most as
///   many as there are of its size.
///
/// With things of one size this gives cells of about that size. Among many different ones it is
/// the number of the small ones and the length of the large ones that decide: the mean, or any
/// quantile, can be off so far that grains lie by the hundred in a cell which suits crates, or
/// that a crate covers thousands of cells which suit one grain.
class SizeCensus {
public:
    /// Counts a collider; metres.
    void add(double length, double radius);
    /// In units of one cell, for cells of `size` metres.
    double cost(double size) const;
    /// The cheapest power of two, or `present` if that is no more than a quarter dearer: with the
    /// cell size changes what all fixed geometry covers. 1 without colliders.
    double choose(double present) const;

private:
    struct Bucket {
        double count = 0, area = 0, length = 0;  // sums of 1, 1.2 (L + T) T, 1.5 (L + T) + 1.2 T
    };
    static constexpr int smallest = -20, largest = 31;  // of sizes in metres, as powers of two
    std::array<Bucket, static_cast<std::size_t>(largest - smallest + 1)> buckets_;
};

}  // namespace sulfur::detail
