#include "make_mechanisms.hpp"

#include "placing.hpp"

namespace sulfur::scene {

MadeMechanism MechanismMaker::make(const SceneMechanism& mechanism) {
    const MadeMechanism made =
        std::visit([this](const auto& spec) { return add(spec); }, mechanism.spec);
    if (!mechanism.id.empty()) parts_.emplace(mechanism.id, made.id);
    return made;
}

MadeMechanism MechanismMaker::add(const Hinge& spec) {
    return {world_.hinge(body(spec.a), body(spec.b), spec.at, spec.options), {}};
}

MadeMechanism MechanismMaker::add(const Weld& spec) {
    return driven(world_.weld(body(spec.a), body(spec.b), spec.at, spec.options), spec.drive);
}

MadeMechanism MechanismMaker::add(const Slider& spec) {
    if (!spec.rail.empty()) {
        const std::vector<JointId> rail = railOf(spec);
        return {world_.slider(body(spec.a), body(spec.b), spec.at, rail, spec.options), {}};
    }
    return {world_.slider(body(spec.a), body(spec.b), spec.at, spec.axis, spec.options), {}};
}

MadeMechanism MechanismMaker::add(const Wheel& spec) {
    const WheelIds ids = world_.wheel(body(spec.a), body(spec.b), spec.at, spec.axis, spec.options);
    return {ids.motor, ids.spring};
}

MadeMechanism MechanismMaker::add(const Distance& spec) {
    return {world_.distance(body(spec.a), spec.atA, body(spec.b), spec.atB, spec.options), {}};
}

MadeMechanism MechanismMaker::add(const Pulley& spec) {
    return driven(world_.pulley(body(spec.a), spec.atA, spec.overA, body(spec.b), spec.atB,
                                spec.overB, body(spec.frame), spec.options),
                  spec.drive);
}

MadeMechanism MechanismMaker::add(const Gear& spec) {
    return driven(world_.gear(part(spec.first), part(spec.second), spec.ratio), spec.drive);
}

/// What only World::setDrive can say.
MadeMechanism MechanismMaker::driven(MechanismId id, const std::optional<Drive>& drive) {
    if (!drive) return {id, {}};
    try {
        world_.setDrive(id, *drive);
    } catch (...) {
        world_.remove(id);
        throw;
    }
    return {id, {}};
}

std::vector<JointId> MechanismMaker::railOf(const Slider& spec) const {
    const auto joints = world_.joints(body(spec.a));
    std::vector<JointId> rail;
    for (const auto place : spec.rail) {
        if (place >= joints.size())
            throw ReadError("", 0, spec.a,
                            "has " + std::to_string(joints.size()) + " joints and no joint " +
                                std::to_string(place) + ", which is in a rail");
        rail.push_back(joints[place]);
    }
    return rail;
}

BodyId MechanismMaker::body(const std::string& id) const {
    const auto found = bodies_.find(id);
    if (found == bodies_.end()) throw ReadError("", 0, id, "is not the id of a body of the scene");
    return found->second;
}

MechanismId MechanismMaker::part(const std::string& id) const {
    const auto found = parts_.find(id);
    if (found == parts_.end())
        throw ReadError("", 0, id, "is not the id of a mechanism before the gear that names it");
    return found->second;
}

std::vector<std::string> refusals(const Scene& scene) {
    std::vector<std::string> result(scene.mechanisms.size());
    if (result.empty()) return result;
    std::map<std::string_view, const Placement*> placements;
    for (const Placement& body : scene.bodies) placements.emplace(body.id, &body);
    World trial(scene.settings);
    std::map<std::string, BodyId, std::less<>> made;
    MechanismMaker maker(made, trial);
    std::size_t searched = 0;
    for (std::size_t i = 0; i < result.size(); ++i) {
        SceneMechanism mechanism = scene.mechanisms[i];
        try {
            for (const std::string* name : bodiesOf(mechanism)) {
                const auto found = placements.find(*name);
                if (found == placements.end()) continue;
                if (!made.contains(*name)) {
                    const Placement& body = *found->second;
                    const BodyId id = trial.add(blueprintOf(scene, body), body.pose);
                    if (body.state) applyState(scene, body, trial, id);
                    made.emplace(*name, id);
                }
                searched += trial.particles(made.at(*name)).size();
            }
            if (searched > Limits::searchedParticles) {
                result[i] = "its bodies and those of mechanisms before it have " +
                            std::to_string(searched) +
                            " particles, each body counted for each of its mechanisms; allowed are "
                            "at most " +
                            std::to_string(Limits::searchedParticles);
                continue;
            }
            maker.make(mechanism);
        } catch (const Error& e) {
            result[i] = e.what();
        } catch (const ReadError& e) {
            result[i] = e.what();
        }
    }
    return result;
}

std::vector<MadeMechanism> makeMechanisms(std::span<const SceneMechanism> mechanisms,
                                          const std::map<std::string, BodyId, std::less<>>& bodies,
                                          World& world) {
    MechanismMaker maker(bodies, world);
    std::vector<MadeMechanism> made;
    for (const SceneMechanism& mechanism : mechanisms) made.push_back(maker.make(mechanism));
    return made;
}

}  // namespace sulfur::scene
