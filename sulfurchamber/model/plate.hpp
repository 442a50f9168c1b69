// Rigid polygons with holes.
#pragma once

#include <optional>
#include <sulfur/scene.hpp>
#include <vector>

namespace sulfurchamber {

/// A polygon with holes in the frame of a body, metres: the outer side of its capsules.
struct Plate {
    std::vector<sulfur::Point> outer;
    std::vector<std::vector<sulfur::Point>> holes;
};

/// The plate that a blueprint is: a box, a polygon, or one that withHoles() has made; nothing for
/// all else.
std::optional<Plate> plateOf(const sulfur::scene::Prefab& prefab);
/// Whether another hole fits: wholly inside, and clear of the rim and of other holes by more than
/// `room` metres.
bool fits(const Plate& plate, const std::vector<sulfur::Point>& hole, double room);
/// Makes the blueprint anew as this plate: with the density, the thickness of capsules, the joints,
/// the surface and all else that it had. It has no recipe then. Throws std::runtime_error where
/// capsules have no room.
void setPlate(sulfur::scene::Prefab& prefab, const Plate& plate);

}  // namespace sulfurchamber
