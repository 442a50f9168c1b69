// Drawings (SVG) and pictures with transparency as shapes.
#pragma once

#include <atlax/image.hpp>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "outline_body.hpp"

namespace sulfurchamber {

/// How large a drawing becomes.
struct DrawingOptions {
    double size = 2;           ///< metres of its longer side, 0.01 to 100
    double tolerance = 0.005;  ///< metres by which lines may miss its curves, 1e-5 to 1
};

/// What drawings may hold; all else is refused or left out, and said.
struct DrawingLimits {
    static constexpr std::size_t bytes = std::size_t{4} << 20;  ///< of the text
    static constexpr std::size_t elements = 20'000;
    static constexpr int depth = 100;              ///< of groups in groups
    static constexpr std::size_t shapes = 500;     ///< of a drawing
    static constexpr std::size_t outlines = 200;   ///< of one path
    static constexpr std::size_t points = 60'000;  ///< of all outlines together
    static constexpr double leastSize = 0.01;      ///< metres
    static constexpr double mostSize = 100;        ///< metres
};

/// Shapes about the middle of all of them, y up.
struct Drawing {
    std::vector<DrawnShape> shapes;
    std::vector<std::string> leftOut;  ///< what could not be used, with the reason, a line each
};

/// Outlines of path, rect, circle, ellipse, polygon and polyline, in groups and with transforms; a
/// stroke has no width here. Closed outlines count, and open ones that are filled. What refers to
/// other elements or files is not followed. `name` is for messages. Throws std::runtime_error.
Drawing readDrawing(std::string_view svg, const std::string& name, const DrawingOptions& options);

/// The outline of what is at least half opaque; specks of less than a 2000th of the picture are
/// left out. Throws std::runtime_error when nothing or everything is opaque.
Drawing traced(const atlax::Image& picture, const std::string& name, const DrawingOptions& options);

/// Either of them from a file. Throws std::runtime_error, or atlax::Error for what cannot be read.
Drawing readOutlines(const std::filesystem::path& file, const DrawingOptions& options);

}  // namespace sulfurchamber
