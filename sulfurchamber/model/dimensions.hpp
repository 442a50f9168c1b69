// How lengths, angles and masses are written while one draws.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfurchamber {

std::string metresText(double length);    ///< "1.20 m"
std::string kilogramsText(double mass);   ///< "2.40 kg", from 10 kg on "24 kg"
std::string degreesText(double radians);  ///< "45.0°"
/// The direction of a way as an angle against the horizontal, radians.
double directionOf(const sulfur::Point& way);

/// A text that stands at a place while one draws.
struct Label {
    sulfur::Point at{0, 0};  ///< metres
    std::string text;
};
/// Width, height and mass of a rectangle, beside its sides and in its middle. Corners
/// anticlockwise from the lower left; no mass: none is shown.
std::vector<Label> sizeLabels(const std::array<sulfur::Point, 4>& corners,
                              std::optional<double> mass);
/// Length and direction of a line, in its middle, with a mass where it has one.
std::vector<Label> lineLabels(const sulfur::Point& from, const sulfur::Point& to,
                              std::optional<double> mass = {});

}  // namespace sulfurchamber
