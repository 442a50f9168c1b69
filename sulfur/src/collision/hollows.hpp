// Which bodies might enclose a point.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "collision/grid.hpp"

namespace sulfur::detail {

struct State;

/// Boxes round the bodies that have an outline, in a grid of their own: the grid of the colliders
/// holds nothing where a body is hollow. Made only when a query asks what encloses a point, and
/// valid as long as the grid of the colliders: the boxes have the same skins.
class Hollows {
public:
    /// Complexity: linear in particles of bodies with outlines.
    void derive(const State& state);
    /// Whether it was made for another run of the broad phase than the one with this number.
    bool stale(std::uint64_t run) const { return run_ != run; }

    /// Calls visit(body) for each body whose box contains the point, each once.
    template <class Visit>
    void forEachNear(const Point& point, Visit&& visit) const {
        const auto test = [&](std::uint32_t i) {
            const Box& box = boxes_[i];
            if ((point.array() >= box.low.array()).all() &&
                (point.array() <= box.high.array()).all())
                visit(box.body);
        };
        grid_.forEachIn(cellOf(point), test);
        for (const auto i : large_) test(i);
    }

private:
    struct Box {
        std::uint32_t body = 0;
        Point low{0, 0}, high{0, 0};
    };

    void chooseCellSize();
    Cell cellOf(const Point& point) const;

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> large_;  // those that would cover too many cells
    Grid grid_;
    double cellSize_ = 1;  // m
    std::uint64_t run_ = ~std::uint64_t{0};
};

}  // namespace sulfur::detail
