// Turning, stretching and mirroring what is selected; where it is, in numbers.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "handles.hpp"

namespace sulfurchamber {

// All of these are a part of the open edit. They keep recipes where those can say it.

/// By an angle in radians, anticlockwise.
void turnSelection(Workbench& bench, const sulfur::Point& about, double angle);
/// By a factor above 0; masses go with the area. What is bent has its own shape again.
void scaleSelection(Workbench& bench, const sulfur::Point& about, double factor);
/// Left becomes right.
void mirrorSelection(Workbench& bench, const sulfur::Point& about);
/// Whether its width can change without its height: round bodies, pieces, and bodies that stand
/// aslant in the frame keep their proportions.
bool canStretch(const Workbench& bench);
/// Widths and heights by factors of their own, which canStretch() allows; or scales. Masses go
/// with the area, those of ropes and of other lines with their length; capsules stay as thick.
void stretchSelection(Workbench& bench, const Stretch& stretch);
/// Kilograms that the selection would have then.
double massAfter(const Workbench& bench, const Stretch& stretch);

/// A number that says where the selection is, or how large.
struct PlaceProperty {
    std::string_view key;   ///< for scripts: "x"
    std::string_view name;  ///< for people
    std::string_view unit;  ///< UTF-8
    std::string_view help;  ///< one line
    double low = 0;         ///< allowed at least
    double high = 1;        ///< allowed at most
    double (*get)(const Frame&) = nullptr;
    /// As a part of the open edit.
    void (*set)(Workbench&, const Frame&, double) = nullptr;
};
/// x, y, angle, width and height of the frame. Several bodies change together, as one.
std::span<const PlaceProperty> placeProperties();
/// Null when there is none of this key.
const PlaceProperty* placeProperty(std::string_view key);
/// Throws std::runtime_error with the range when the value is outside, or nothing is selected.
void setPlace(Workbench& bench, const PlaceProperty& property, double value);

}  // namespace sulfurchamber
