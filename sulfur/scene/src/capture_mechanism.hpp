// Mechanisms of a running world as those of a scene.
#pragma once

#include <map>
#include <string>
#include <sulfur/scene/instance.hpp>
#include <vector>

namespace sulfur::scene {

/// A drive as a file can say it: what is beyond its bounds counts as without bound.
Drive withinFile(Drive drive);
/// Whether two drives are the same.
bool same(const Drive& a, const Drive& b);

/// Describes the mechanisms of a world as they are now.
class MechanismCapture {
public:
    /// `ids`: of the bodies that the scene has. Mechanisms of others are left out.
    MechanismCapture(const World& world, const std::map<BodyId, std::string>& ids);

    /// A mechanism of an older scene keeps its id and its unknown members; a wheel stays one if
    /// it is as it was made.
    void know(const SceneMechanism& mechanism, const MadeMechanism& made);
    std::vector<SceneMechanism> run();

private:
    bool isAsMade(const Wheel& wheel, const MadeMechanism& made) const;
    void add(MechanismId id);
    SceneMechanism describe(const MechanismInfo& info);
    std::string nameOf(MechanismId part);

    const World& world_;
    const std::map<BodyId, std::string>& ids_;
    std::map<MechanismId, const SceneMechanism*> known_;
    std::map<MechanismId, const SceneMechanism*> wheels_;  ///< by their motors
    std::map<MechanismId, MechanismId> springs_;           ///< of these wheels, their motors
    std::map<MechanismId, std::size_t> places_;            ///< in the list
    std::vector<SceneMechanism> list_;
    std::size_t lastName_ = 0;
};

}  // namespace sulfur::scene
