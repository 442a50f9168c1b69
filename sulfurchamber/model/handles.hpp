// The frame around what is selected, and its handles.
#pragma once

#include <array>
#include <optional>

#include "workbench.hpp"

namespace sulfurchamber {

/// Upright rectangle around what is selected; nothing where nothing is.
std::optional<Bounds> selectionBounds(const Workbench& bench);

/// A rectangle around what is selected: upright, but turned with a single body.
struct Frame {
    sulfur::Point middle{0, 0};
    sulfur::Point half{0, 0};  ///< half of its width and its height, metres
    double angle = 0;          ///< radians

    /// A place in the world of shares: -1 and 1 are its sides.
    sulfur::Point at(double x, double y) const;
    /// A way in the world, along its sides.
    sulfur::Point along(const sulfur::Point& way) const;
    /// Anticlockwise from the lower left.
    std::array<sulfur::Point, 4> corners() const;
};
std::optional<Frame> selectionFrame(const Workbench& bench);

/// A handle of a frame.
struct Handle {
    enum class Kind : std::uint8_t { corner, side, turn };
    Kind kind = Kind::corner;
    double x = 0;  ///< where it is, in shares of the frame; 0 and 0 for the knob that turns
    double y = 0;
    sulfur::Point at{0, 0};
};
/// All of them for a pointer that reaches so far (metres): corners anticlockwise from the lower
/// left, sides from the lower one, the knob last.
std::array<Handle, 9> handlesOf(const Frame& frame, double reach);

/// How a frame becomes another: by factors along its sides, about a place that stays.
struct Stretch {
    sulfur::Point about{0, 0};
    sulfur::Point factors{1, 1};
    double angle = 0;  ///< of the frame, radians

    sulfur::Point operator()(const sulfur::Point& point) const;
    bool isUniform() const;
};
/// What a handle does when it is dragged by a way (metres): a corner keeps the proportions, a side
/// changes one of them where `freely`. The opposite corner or side stays, or the middle.
Stretch stretchBy(const Frame& frame, const Handle& handle, const sulfur::Point& way, bool freely,
                  bool aboutMiddle);
/// The frame afterwards.
Frame stretched(const Frame& frame, const Stretch& stretch);

}  // namespace sulfurchamber
