// What is fitted to bodies, or to the scene: mechanisms, zones and thrusters, as data of the plan.
// And single particles and joints, which are chosen and changed as these are.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sulfur/scene.hpp>
#include <variant>
#include <vector>

namespace sulfurchamber {

/// Keys that drive something while time runs. Files keep them as a member "keys" of a mechanism or
/// thruster, which means nothing to the physics.
struct DriveKeys {
    std::string forward;  ///< one of controlKeys(), or ""
    std::string back;     ///< the same
    /// Of the largest torque or force, 0 to 1: what a motor resists with while no key is held.
    double brake = 0;

    bool any() const { return !forward.empty() || !back.empty(); }
    bool operator==(const DriveKeys&) const = default;
};

/// The keys that may drive: letters and arrows.
std::span<const std::string_view> controlKeys();
bool isControlKey(std::string_view name);

/// A force that is fixed to the frame of a body. Files keep it in a member "devices" of the scene.
struct Thruster {
    std::string body;           ///< id of a placement
    sulfur::Vec2 at{0, 0};      ///< metres, in the frame of the body's blueprint
    sulfur::Vec2 force{0, 10};  ///< newtons, in the same frame
    DriveKeys keys;             ///< without any it always pushes
};

/// Bounds of what files may say of thrusters.
struct DeviceLimits {
    static constexpr std::size_t devices = 1'000;
    static constexpr double at = 1'000;   ///< metres, either way
    static constexpr double force = 1e6;  ///< newtons, on each axis
};

/// A particle of a body.
struct ParticlePart {
    sulfur::ParticleSpec spec;
};
/// A joint of a body, or between two: then its ends are 0.
struct JointPart {
    sulfur::JointSpec spec;
};

using Fitting = std::variant<sulfur::scene::SceneMechanism, sulfur::scene::SceneField, Thruster,
                             ParticlePart, JointPart>;

/// One of them: its place among its kind in the plan.
struct FittingRef {
    enum class Kind : std::uint8_t { mechanism, zone, thruster, particle, joint, connection };
    Kind kind = Kind::mechanism;
    std::size_t index = 0;
    std::string body = {};  ///< id of a placement, of particles and joints
    bool isPart() const { return kind >= Kind::particle; }
    bool operator==(const FittingRef&) const = default;
};

/// The thrusters of a scene. Throws sulfur::scene::ReadError when they are not what they must be.
std::vector<Thruster> thrustersOf(const sulfur::scene::Scene& scene);
/// Writes them back; devices of a type that is not known stay.
void setThrusters(sulfur::scene::Scene& scene, const std::vector<Thruster>& thrusters);

/// The keys of a mechanism, none where it has none or what it has is unusable.
DriveKeys keysOf(const sulfur::scene::SceneMechanism& mechanism);
void setKeys(sulfur::scene::SceneMechanism& mechanism, const DriveKeys& keys);
/// What turns or pulls in a mechanism; null where nothing can. It is a wheel's motor.
sulfur::Drive* driveOf(sulfur::scene::SceneMechanism& mechanism);
const sulfur::Drive* driveOf(const sulfur::scene::SceneMechanism& mechanism);

/// "Hinge", "Motor", "Winch", "Wind", ...: what people call it.
std::string_view kindName(const Fitting& fitting);

}  // namespace sulfurchamber
