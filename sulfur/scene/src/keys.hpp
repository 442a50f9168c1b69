// Which members each kind of object may have.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sulfur::scene {

using KeyList = std::vector<std::string_view>;

/// The keys that the reader knows in an object: "scene", "blueprintFile", "world", "particle",
/// "joint", "material", "filter", "skin", "body", "state", "connection", "attachment", "boxZone",
/// "circleZone", "uniformField", "radialField", "windField", "drive", "hingeMechanism",
/// "weldMechanism", "sliderMechanism", "wheelMechanism", "distanceMechanism", "pulleyMechanism",
/// "gearMechanism", "explicit" (a blueprint without a shape), or the name of a shape. The published
/// schema must list the same.
const KeyList& keysOf(std::string_view part);

/// All parts.
const std::vector<std::string_view>& parts();

}  // namespace sulfur::scene
