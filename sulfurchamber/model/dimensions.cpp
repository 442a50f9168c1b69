#include "dimensions.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "words.hpp"

namespace sulfurchamber {

std::string metresText(double length) {
    return fixed(length, 2) + " m";
}

std::string kilogramsText(double mass) {
    return fixed(mass, mass < 10 ? 2 : 0) + " kg";
}

std::string degreesText(double radians) {
    const double degrees = radians * 180 / std::numbers::pi;
    return fixed(std::abs(degrees) < 0.05 ? 0 : degrees, 1) + "\xC2\xB0";
}

std::vector<Label> sizeLabels(const std::array<sulfur::Point, 4>& corners,
                              std::optional<double> mass) {
    using sulfur::Point;
    std::vector<Label> labels{
        {(corners[0] + corners[1]) / 2, metresText((corners[1] - corners[0]).norm())},
        {(corners[1] + corners[2]) / 2, metresText((corners[2] - corners[1]).norm())}};
    if (mass) labels.push_back({(corners[0] + corners[2]) / 2, kilogramsText(*mass)});
    return labels;
}

std::vector<Label> lineLabels(const sulfur::Point& from, const sulfur::Point& to,
                              std::optional<double> mass) {
    const sulfur::Point way = to - from;
    std::string text = metresText(way.norm()) + "  " + degreesText(directionOf(way));
    if (mass) text += "  " + kilogramsText(*mass);
    return {{(from + to) / 2, std::move(text)}};
}

double directionOf(const sulfur::Point& way) {
    return std::atan2(way.y(), way.x());
}

}  // namespace sulfurchamber
