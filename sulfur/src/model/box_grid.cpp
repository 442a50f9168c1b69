#include "model/box_grid.hpp"

#include <algorithm>

namespace sulfur::detail {

std::uint32_t BoxGrid::find(std::uint32_t level, std::int64_t x, std::int64_t y) const {
    const std::size_t mask = cells_.size() - 1;
    for (std::size_t at = hash(level, x, y) & mask;; at = (at + 1) & mask) {
        const Cell& cell = cells_[at];
        if (cell.level == none || (cell.level == level && cell.x == x && cell.y == y))
            return static_cast<std::uint32_t>(at);
    }
}

void BoxGrid::insert(std::vector<Chunk>& chunks, std::uint32_t index) {
    if (2 * (used_ + 1) > cells_.size()) grow(chunks);
    Chunk& chunk = chunks[index];
    const double extent =
        std::max({chunk.high[0] - chunk.low[0], chunk.high[1] - chunk.low[1], 1e-6});
    int exponent = 0;
    std::frexp(extent, &exponent);  // extent < 2^exponent
    chunk.level =
        static_cast<std::uint32_t>(std::clamp(exponent - finest, 0, static_cast<int>(levels) - 1));
    const double size = sizeOf(chunk.level);
    const auto x = cellOf((chunk.low[0] + chunk.high[0]) / 2, size);
    const auto y = cellOf((chunk.low[1] + chunk.high[1]) / 2, size);
    chunk.cell = find(chunk.level, x, y);
    Cell& cell = cells_[chunk.cell];
    if (cell.level == none) {
        cell = {x, y, chunk.level, none};
        ++used_;
    }
    chunk.previousInCell = none;
    chunk.nextInCell = cell.first;
    if (cell.first != none) chunks[cell.first].previousInCell = index;
    cell.first = index;
    ++count_[chunk.level];
}

void BoxGrid::remove(std::vector<Chunk>& chunks, std::uint32_t index) {
    Chunk& chunk = chunks[index];
    if (chunk.cell == none) return;
    if (chunk.previousInCell != none)
        chunks[chunk.previousInCell].nextInCell = chunk.nextInCell;
    else
        cells_[chunk.cell].first = chunk.nextInCell;
    if (chunk.nextInCell != none) chunks[chunk.nextInCell].previousInCell = chunk.previousInCell;
    chunk.cell = chunk.nextInCell = chunk.previousInCell = none;
    --count_[chunk.level];
}

void BoxGrid::grow(std::vector<Chunk>& chunks) {
    const std::vector<Cell> before = std::move(cells_);
    const auto live = std::count_if(before.begin(), before.end(),
                                    [](const Cell& cell) { return cell.first != none; });
    std::size_t size = 64;
    while (size < 4 * static_cast<std::size_t>(live + 1)) size *= 2;
    cells_.assign(size, {});
    used_ = 0;
    for (const Cell& cell : before) {
        if (cell.first == none) continue;
        const auto at = find(cell.level, cell.x, cell.y);
        cells_[at] = cell;
        ++used_;
        for (auto c = cell.first; c != none; c = chunks[c].nextInCell) chunks[c].cell = at;
    }
}

}  // namespace sulfur::detail
