/// \file
/// From a scene to a running world, and back.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <sulfur/scene/scene.hpp>
#include <sulfur/world.hpp>
#include <vector>

namespace sulfur::scene {

/// What a mechanism of a scene has become in a world.
struct MadeMechanism {
    MechanismId id;      ///< of a wheel, its motor
    MechanismId spring;  ///< of a wheel, its slider; else null
};

/// What a scene has become in a world.
struct Instance {
    std::map<std::string, BodyId, std::less<>> bodies;  ///< by id of the placement
    std::vector<JointId> connections;                   ///< in the order of the scene
    std::vector<AttachmentId> attachments;              ///< in the order of the scene
    std::vector<FieldId> fields;                        ///< in the order of the scene
    std::vector<MadeMechanism> mechanisms;              ///< in the order of the scene

    /// The handle of a body, null when the scene has no such id.
    BodyId body(std::string_view id) const;
    /// The id of a body, "" when it does not come from the scene.
    std::string id(BodyId body) const;
};

/// Adds everything of a scene to a world, which must have been made with `scene.settings` for the
/// scene to behave as it was meant. Throws sulfur::Error or ReadError when the scene is not one
/// that read() would accept; the world then holds a part of it.
Instance instantiate(const Scene& scene, World& world);

/// Puts the particles of a body that was made at the pose of its placement where the state of that
/// says, with their velocities; a disc also turns and spins so. The placement must have a state.
/// Throws ReadError when that has another number of particles, before anything changes.
void applyState(const Scene& scene, const Placement& placement, World& world, BodyId body);

/// Adds mechanisms of a scene between bodies that are in a world, with their ids in the scene.
/// Throws sulfur::Error or ReadError when one cannot be made; those before it are there then.
std::vector<MadeMechanism> makeMechanisms(std::span<const SceneMechanism> mechanisms,
                                          const std::map<std::string, BodyId, std::less<>>& bodies,
                                          World& world);

/// The state of a running world as a scene. Bodies of `instance` keep their id, and their prefab
/// while it still describes them; bodies that came later, broke or were changed get explicit
/// blueprints of their own. `base` gives title, sections and all other unknown members.
/// Mechanisms go on where they are, a wheel as a slider and a hinge; where a soft body has bent, it
/// is held near the same point. Left out are mechanisms at points that bodies can no longer hold,
/// attachments to a joint between bodies, those of a particle to its own body, and what holds on to
/// the pin of a mechanism, which scenes cannot say.
Scene capture(const World& world, const Scene& base = {}, const Instance& instance = {});

/// A body as it is now as a blueprint, with its name, its particles in their places less `origin`.
Blueprint blueprintNow(const World& world, BodyId body, const Point& origin);

}  // namespace sulfur::scene
