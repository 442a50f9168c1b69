// The forces that act in a world, as arrows.
#pragma once

#include <cstdint>
#include <sulfur/world.hpp>
#include <vector>

namespace sulfurchamber {

enum class ForceKind : std::uint8_t { gravity, contact, joint };

struct ForceArrow {
    sulfur::Point at{0, 0};     ///< metres
    sulfur::Point force{0, 0};  ///< N, on what is there
    ForceKind kind = ForceKind::gravity;
};

/// Most arrows of joints: those with the largest forces.
inline constexpr std::size_t mostJointArrows = 300;

/// The weight of each body that moves, at its centre of mass.
std::vector<ForceArrow> gravityForces(const sulfur::World& world);
/// What contacts push in the last tick, on each of both that moves.
std::vector<ForceArrow> contactForces(const sulfur::World& world);
/// What joints pull and push at both of their ends: those between bodies, mechanisms, elastic
/// joints and those of ropes. The rigid ones inside of solid bodies are left out.
std::vector<ForceArrow> jointForces(const sulfur::World& world);

/// N: the weight of the heaviest body that moves, on Earth; 1 where nothing moves. It says how long
/// arrows are.
double typicalForce(const sulfur::World& world);

}  // namespace sulfurchamber
