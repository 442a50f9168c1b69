/// \file
/// Mechanisms: what turns, slides and pulls between two bodies, with limits, motors and springs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur {

/// What acts along the coordinate of a mechanism: the angle of a hinge, the place on a slider, a
/// distance. Its unit is the radian or the metre, that of its forces N m or N. All of them act
/// together, and each is implicit (backward Euler), so that it may be as stiff as it likes; but the
/// amplitude of a spring without damping falls as exp(-h w^2 t / 2) after t seconds, in steps of h
/// seconds, at w rad/s. Drives that contradict each other, such as two rigid ones that want
/// different angles of the same bodies, push with what they have, and may throw these bodies.
struct Drive {
    Real lower = -infinite;  ///< rad or m, the least value
    Real upper = infinite;   ///< rad or m, the largest one, not less than `lower`
    Real stiffness = 0;   ///< N m/rad or N/m, 0 to 1e12 or `infinite`: of a spring towards `rest`
    Real damping = 0;     ///< N m s/rad or N s/m, 0 to 1e12
    Real rest = 0;        ///< rad or m: where the spring is at rest
    Real motorSpeed = 0;  ///< rad/s or m/s, -1e6 to 1e6: what the motor wants
    Real motorMax = 0;    ///< N m or N, 0 to `infinite`: the most that it gives; 0: no motor
    /// rad or m: a motor that goes there and stays, at most as fast as the size of `motorSpeed`.
    std::optional<Real> motorTarget = std::nullopt;
    /// N m or N, above 0, or `infinite`: it breaks when motor and spring, or the limits, give more.
    Real strength = infinite;
};

/// How World::hinge joins two bodies.
struct HingeOptions {
    Drive drive = {};      ///< radians
    bool collide = false;  ///< whether the two bodies touch each other
    /// Whether a pin holds them together. Without one only their angle is driven: something else
    /// holds them, or nothing.
    bool pin = true;
    Real strength = infinite;  ///< N, above 0, or `infinite`, of the pin
    double value = 0;  ///< rad, -1e6 to 1e6: what the angle counts as when the hinge is made
};

/// How World::slider leads a point of a body along a line of another one.
struct SliderOptions {
    Drive drive = {};      ///< metres along the axis or the rail
    bool collide = false;  ///< whether the two bodies touch each other
    bool turns = true;     ///< whether b turns freely; else it keeps its angle against a
    /// m, -1e6 to 1e6: what the place counts as when the slider is made; on a rail what its begin
    /// counts as.
    double value = 0;
};

/// How World::wheel hangs a wheel on a body.
struct WheelOptions {
    Drive spring = {};     ///< metres along the axis; 0 is the place when it is made
    Drive motor = {};      ///< radians of the wheel against the body
    bool collide = false;  ///< whether the two bodies touch each other
};

/// How World::weld joins two bodies.
struct WeldOptions {
    Real stiffness = infinite;       ///< N m/rad, 0 to 1e12 or `infinite`: against bending
    Real damping = 0;                ///< N m s/rad, 0 to 1e12
    bool collide = false;            ///< whether the two bodies touch each other
    Real strength = infinite;        ///< N, above 0, or `infinite`, of the pin
    Real torqueStrength = infinite;  ///< N m, above 0, or `infinite`
    double value = 0;  ///< rad, -1e6 to 1e6: how far it counts as bent when it is made
};

/// How World::distance keeps two points of bodies apart or together.
struct DistanceOptions {
    Drive drive = {};     ///< metres between both points
    bool collide = true;  ///< whether the two bodies touch each other
};

/// The rope of World::pulley, which only pulls.
struct PulleyOptions {
    Real ratio = 1;  ///< 1e-6 to 1e6: how many times the far side counts, as with blocks
    std::optional<Real> length = std::nullopt;  ///< m, of both sides; as it is when not given
    Real strength = infinite;                   ///< N, above 0, or `infinite`
};

/// What a mechanism is.
enum class MechanismKind : std::uint8_t {
    hinge,     ///< its value is the angle of b against a
    slider,    ///< its value is the place along the line
    distance,  ///< its value is the distance of both points
    pulley,    ///< its value is the length of the rope, the far side times the ratio
    gear,      ///< its value is what two mechanisms keep, the second times the ratio
    weld,      ///< its value is how far it has bent
};

/// What a mechanism is at the moment.
struct MechanismInfo {
    MechanismKind kind = MechanismKind::hinge;  ///< what it is
    BodyId a = {};                              ///< one body
    BodyId b = {};                              ///< the other body
    Point pointA{0, 0};    ///< metres: where it takes hold of a; of a gear the origin
    Point pointB{0, 0};    ///< metres: where it takes hold of b
    double value = 0;      ///< rad or m; angles count whole turns
    double speed = 0;      ///< rad/s or m/s
    Real force = 0;        ///< N m or N of its drive in the last tick, positive to larger values
    Vec2 holding{0, 0};    ///< N on b in the last tick, of a pin or across a slider's line
    bool atLower = false;  ///< whether the lower limit pushed in the last tick
    bool atUpper = false;  ///< the same of the upper one
    Drive drive = {};      ///< as it was set last
    Real ratio = 1;        ///< of a pulley or gear

    // How it was made.
    bool collide = true;                 ///< whether it lets the two bodies touch each other
    bool vetoes = false;                 ///< whether they touch again when it is gone
    bool pin = false;                    ///< of a hinge or weld: whether a pin holds both together
    Real strength = infinite;            ///< N, of the pin
    bool turns = true;                   ///< of a slider: whether b turns freely
    Vec2 axis{0, 0};                     ///< of a slider: where its line points now, 1 long
    std::vector<JointId> rail = {};      ///< of a slider: what is left of its rail, in order
    double railBegin = 0;                ///< m: what the begin of that counts as
    Point overA{0, 0};                   ///< metres, of a pulley: where the rope of a turns
    Point overB{0, 0};                   ///< metres, of a pulley: where that of b does
    BodyId frame = {};                   ///< of a pulley
    MechanismId first = {};              ///< of a gear
    MechanismId second = {};             ///< of a gear
    std::array<AttachmentId, 2> pins{};  ///< its own among World::attachments, or null
    std::array<BodyId, 2> own{};         ///< its own among World::bodies, of one particle, or null
};

/// The two mechanisms of a wheel.
struct WheelIds {
    MechanismId spring;  ///< the slider
    MechanismId motor;   ///< the hinge without a pin
};

}  // namespace sulfur
