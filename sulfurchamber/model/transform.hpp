// Turning, scaling and mirroring what is selected.
#pragma once

#include <array>
#include <optional>

#include "workbench.hpp"

namespace sulfurchamber {

/// Upright rectangle around what is selected; nothing where nothing is.
std::optional<Bounds> selectionBounds(const Workbench& bench);

/// Where the handles of a selection are, for a pointer that reaches so far (metres).
struct Handles {
    std::array<sulfur::Point, 4> corners;  ///< anticlockwise from the lower left: they scale
    sulfur::Point turn{0, 0};
    sulfur::Point middle{0, 0};  ///< about which both go
};
Handles handlesOf(const Bounds& bounds, double reach);

// All of these are a part of the open edit. They keep recipes where those can say it.

/// By an angle in radians, anticlockwise.
void turnSelection(Workbench& bench, const sulfur::Point& about, double angle);
/// By a factor above 0; masses go with the area. What is bent has its own shape again.
void scaleSelection(Workbench& bench, const sulfur::Point& about, double factor);
/// Left becomes right.
void mirrorSelection(Workbench& bench, const sulfur::Point& about);

}  // namespace sulfurchamber
