#include "collision/hollows.hpp"

#include <algorithm>
#include <cmath>

#include "collision/skins.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

constexpr double mostCells = 100;  // of one body

}  // namespace

void Hollows::derive(const State& state) {
    const BroadPhase& broad = state.broad;
    boxes_.clear();
    for (std::uint32_t body = 0; body < state.bodies.size(); ++body) {
        const auto edges = broad.outlines.of(body);
        if (edges.empty()) continue;
        Box box{body, broad.reference[edges.front().from], broad.reference[edges.front().from]};
        for (const OutlineEdge& edge : edges) {
            const double skin = static_cast<double>(skinOf(broad, broad.step[edge.from]));
            box.low = box.low.cwiseMin((broad.reference[edge.from].array() - skin).matrix());
            box.high = box.high.cwiseMax((broad.reference[edge.from].array() + skin).matrix());
        }
        boxes_.push_back(box);
    }
    chooseCellSize();
    grid_.clear();
    large_.clear();
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
        const Cell low = cellOf(boxes_[i].low), high = cellOf(boxes_[i].high);
        const double columns = static_cast<double>(high.x) - low.x + 1;
        const double rows = static_cast<double>(high.y) - low.y + 1;
        if (columns * rows > mostCells) {
            large_.push_back(i);
            continue;
        }
        for (std::int32_t y = low.y; y <= high.y; ++y)
            for (std::int32_t x = low.x; x <= high.x; ++x) grid_.insert({x, y}, i);
    }
    grid_.build();
    run_ = broad.runs;
}

/// As large as the boxes on average, so that a box covers a few cells and a cell holds a few boxes.
void Hollows::chooseCellSize() {
    double sum = 0;
    for (const Box& box : boxes_) sum += (box.high - box.low).maxCoeff();
    if (!boxes_.empty()) cellSize_ = std::max(0.02, sum / static_cast<double>(boxes_.size()));
}

Cell Hollows::cellOf(const Point& point) const {
    const Point scaled = (point / cellSize_).cwiseMax(-1e9).cwiseMin(1e9);
    return {static_cast<std::int32_t>(std::floor(scaled[0])),
            static_cast<std::int32_t>(std::floor(scaled[1]))};
}

}  // namespace sulfur::detail
