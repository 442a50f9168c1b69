#include "dimensions.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace sulfurchamber {
namespace {

std::string formatted(const char* format, double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace

std::string metresText(double length) {
    return formatted("%.2f m", length);
}

std::string kilogramsText(double mass) {
    return formatted(mass < 10 ? "%.2f kg" : "%.0f kg", mass);
}

std::string degreesText(double radians) {
    const double degrees = radians * 180 / std::numbers::pi;
    return formatted("%.1f\xC2\xB0", std::abs(degrees) < 0.05 ? 0 : degrees);
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
