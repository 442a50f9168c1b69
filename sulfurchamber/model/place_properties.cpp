// Where what is selected lies, in numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "stretch.hpp"
#include "transform.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

void moveFrame(Workbench& bench, const Point& by) {
    bench.document().translate(bench.selection(), by);
}

void resizeFrame(Workbench& bench, const Frame& frame, const Point& factors) {
    if (!factors.allFinite()) return;  // what has no extent has none to change
    Stretch stretch{frame.middle, factors, frame.angle};
    if (!canStretch(bench)) stretch.factors = Point::Constant(factors.prod());
    stretchSelection(bench, stretch);
}

constexpr double halfTurn = 3.14159265358979;
constexpr double oneDegree = halfTurn / 180;

constexpr std::array places{
    PlaceProperty{"x", "x", "m", "Of the middle", -1000, 1000,
                  [](const Frame& frame) { return frame.middle.x(); },
                  [](Workbench& bench, const Frame& frame, double value) {
                      moveFrame(bench, {value - frame.middle.x(), 0});
                  }},
    PlaceProperty{"y", "y", "m", "Of the middle", -1000, 1000,
                  [](const Frame& frame) { return frame.middle.y(); },
                  [](Workbench& bench, const Frame& frame, double value) {
                      moveFrame(bench, {0, value - frame.middle.y()});
                  }},
    PlaceProperty{
        "angle", "Angle", "\xC2\xB0", "Anticlockwise; of many together from now on", -180, 180,
        [](const Frame& frame) { return std::remainder(frame.angle, 2 * halfTurn) / oneDegree; },
        [](Workbench& bench, const Frame& frame, double value) {
            turnSelection(bench, frame.middle, value * oneDegree - frame.angle);
        }},
    PlaceProperty{"frame-width", "Width", "m", "Outer width; what cannot be stretched is scaled",
                  0.02, 1000, [](const Frame& frame) { return 2 * frame.half.x(); },
                  [](Workbench& bench, const Frame& frame, double value) {
                      resizeFrame(bench, frame, {value / (2 * frame.half.x()), 1});
                  }},
    PlaceProperty{"frame-height", "Height", "m", "Outer height; what cannot be stretched is scaled",
                  0.02, 1000, [](const Frame& frame) { return 2 * frame.half.y(); },
                  [](Workbench& bench, const Frame& frame, double value) {
                      resizeFrame(bench, frame, {1, value / (2 * frame.half.y())});
                  }},
};

}  // namespace

std::span<const PlaceProperty> placeProperties() {
    return places;
}

const PlaceProperty* placeProperty(std::string_view key) {
    const auto* found = std::find_if(places.begin(), places.end(),
                                     [&](const auto& property) { return property.key == key; });
    return found == places.end() ? nullptr : found;
}

void setPlace(Workbench& bench, const PlaceProperty& property, double value) {
    const auto frame = selectionFrame(bench);
    if (!frame) throw std::runtime_error("nothing is selected");
    if (!(value >= property.low && value <= property.high))
        throw std::runtime_error(tr("{} is out of range", {tr(std::string(property.name))}));
    property.set(bench, *frame, value);
}

}  // namespace sulfurchamber
