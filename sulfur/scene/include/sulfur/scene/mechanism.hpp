/// \file
/// Mechanisms between bodies of a scene, as plain data.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <sulfur/mechanisms.hpp>
#include <sulfur/scene/extra.hpp>
#include <variant>
#include <vector>

namespace sulfur::scene {

// Bodies are ids of placements. Points are of the world, where bodies are when the scene begins.

/// World::hinge.
struct Hinge {
    std::string a;         ///< one body
    std::string b;         ///< the other one
    Point at{0, 0};        ///< metres: about which they turn
    HingeOptions options;  ///< the rest
};

/// World::weld.
struct Weld {
    std::string a;               ///< one body
    std::string b;               ///< the other one
    Point at{0, 0};              ///< metres: where they are joined
    WeldOptions options;         ///< the rest
    std::optional<Drive> drive;  ///< where given, instead of what the options say
};

/// World::slider.
struct Slider {
    std::string a;                    ///< the body with the line
    std::string b;                    ///< the one that is led along it
    Point at{0, 0};                   ///< metres: the point of b
    Vec2 axis{1, 0};                  ///< the direction of the line, not zero; nothing on a rail
    SliderOptions options;            ///< the rest
    std::vector<std::uint32_t> rail;  ///< where given, the places of its links among a's joints
};

/// World::wheel.
struct Wheel {
    std::string a;         ///< the body that rides
    std::string b;         ///< the wheel
    Point at{0, 0};        ///< metres: the hub
    Vec2 axis{0, 1};       ///< the direction of the spring, not zero
    WheelOptions options;  ///< the rest
};

/// World::distance.
struct Distance {
    std::string a;            ///< one body
    std::string b;            ///< the other one
    Point atA{0, 0};          ///< metres
    Point atB{0, 0};          ///< metres
    DistanceOptions options;  ///< the rest
};

/// World::pulley.
struct Pulley {
    std::string a;               ///< the body on one end
    std::string b;               ///< that on the other one
    std::string frame;           ///< over which the rope runs
    Point atA{0, 0};             ///< metres
    Point atB{0, 0};             ///< metres
    Point overA{0, 0};           ///< metres, of the frame
    Point overB{0, 0};           ///< metres, of the frame
    PulleyOptions options;       ///< the rest
    std::optional<Drive> drive;  ///< where given, instead of what the options say
};

/// World::gear.
struct Gear {
    std::string first;           ///< id of a mechanism before this one; of a wheel, its motor
    std::string second;          ///< the same
    Real ratio = 1;              ///< how many times the second counts
    std::optional<Drive> drive;  ///< where given, instead of a rigid one
};

/// A mechanism of a scene.
struct SceneMechanism {
    std::string id;  ///< may be empty; else unique among mechanisms, for gears to name it
    std::variant<Hinge, Weld, Slider, Wheel, Distance, Pulley, Gear> spec;  ///< what it is
    ExtraTree extra;                                                        ///< unknown members
};

/// The ids of bodies that a mechanism names, to be read or changed; a gear names none.
std::vector<std::string*> bodiesOf(SceneMechanism& mechanism);
/// The points of a mechanism that go with a body when that is moved: what is between two bodies
/// goes with b.
std::vector<Point*> pointsOf(SceneMechanism& mechanism, std::string_view body);
/// Takes out mechanisms that name a body for which `gone` holds, and gears that lose a part.
void removeMechanisms(std::vector<SceneMechanism>& mechanisms,
                      const std::function<bool(const std::string&)>& gone);

}  // namespace sulfur::scene
