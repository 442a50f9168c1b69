// Outlines as SVG 1.1 has them: path data, transforms, curves that become lines.
#pragma once

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "lattice.hpp"

namespace sulfurchamber {

/// A cubic Bezier curve that begins where the one before it ends, or a straight line.
struct Curve {
    bool straight = true;
    sulfur::Point first{0, 0};  ///< control points; of a straight line nobody reads them
    sulfur::Point second{0, 0};
    sulfur::Point end{0, 0};
};

/// One stroke of the pen.
struct SubPath {
    sulfur::Point start{0, 0};
    std::vector<Curve> curves;
    bool closed = false;  ///< by the command Z
};

using PenPath = std::vector<SubPath>;
using Affine = Eigen::Affine2d;

/// What drawings may be made of.
struct PathLimits {
    static constexpr std::size_t curves = 100'000;  ///< of one path
    static constexpr double coordinate = 1e9;       ///< either way
};

/// The attribute "d" of a path, with all its commands. Arcs become curves that are off by less than
/// a hundred thousandth of their radius. Throws std::runtime_error that names the place of what is
/// wrong.
PenPath readPathData(std::string_view data);
/// An ellipse as a path of four arcs.
PenPath ellipsePath(const sulfur::Point& centre, double radiusX, double radiusY);
/// Lines through points.
PenPath linePath(const std::vector<sulfur::Point>& points, bool closed);
/// The numbers of an attribute such as "points", apart by space or commas. Throws
/// std::runtime_error.
std::vector<double> readNumbers(std::string_view text);
/// The attribute "transform": matrix, translate, scale, rotate, skewX, skewY, one after the other.
/// Throws std::runtime_error.
Affine readTransform(std::string_view text);

PenPath transformed(const PenPath& path, const Affine& by);
/// Lines that stay within `tolerance` of the curves (in the path's unit), without points that
/// repeat their predecessor.
Outline flattened(const SubPath& path, double tolerance);

}  // namespace sulfurchamber
