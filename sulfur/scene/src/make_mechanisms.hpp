// Mechanisms of a scene in a world.
#pragma once

#include <map>
#include <string>
#include <sulfur/scene/instance.hpp>
#include <vector>

namespace sulfur::scene {

/// Makes mechanisms one after the other; gears find those that it has made.
class MechanismMaker {
public:
    MechanismMaker(const std::map<std::string, BodyId, std::less<>>& bodies, World& world)
        : bodies_(bodies), world_(world) {}

    /// Throws sulfur::Error or ReadError; nothing is left of the mechanism then.
    MadeMechanism make(const SceneMechanism& mechanism);

private:
    MadeMechanism add(const Hinge& spec);
    MadeMechanism add(const Weld& spec);
    MadeMechanism add(const Slider& spec);
    MadeMechanism add(const Wheel& spec);
    MadeMechanism add(const Distance& spec);
    MadeMechanism add(const Pulley& spec);
    MadeMechanism add(const Gear& spec);
    MadeMechanism driven(MechanismId id, const std::optional<Drive>& drive);
    std::vector<JointId> railOf(const Slider& spec) const;
    BodyId body(const std::string& id) const;
    MechanismId part(const std::string& id) const;

    const std::map<std::string, BodyId, std::less<>>& bodies_;
    World& world_;
    std::map<std::string, MechanismId> parts_;
};

/// Why a world refuses each mechanism of a scene, or "": tried in one with nothing but their
/// bodies.
std::vector<std::string> refusals(const Scene& scene);

}  // namespace sulfur::scene
