// Drives, options of mechanisms, what they are and what they do.
#include "convert.hpp"

namespace sulfur::c {

static_assert(SULFUR_WELD == static_cast<int>(MechanismKind::weld));

// --- from C --------------------------------------------------------------------------------------

Drive fromC(const SulfurDrive& drive) {
    Drive result;
    result.lower = real(drive.lower);
    result.upper = real(drive.upper);
    result.stiffness = real(drive.stiffness);
    result.damping = real(drive.damping);
    result.rest = real(drive.rest);
    result.motorSpeed = real(drive.motor_speed);
    result.motorMax = real(drive.motor_max);
    if (drive.has_motor_target) result.motorTarget = real(drive.motor_target);
    result.strength = real(drive.strength);
    return result;
}

HingeOptions fromC(const SulfurHingeOptions& options) {
    return {fromC(options.drive), options.collide, options.pin, real(options.strength),
            options.value};
}

WeldOptions fromC(const SulfurWeldOptions& options) {
    return {real(options.stiffness), real(options.damping),         options.collide,
            real(options.strength),  real(options.torque_strength), options.value};
}

SliderOptions fromC(const SulfurSliderOptions& options) {
    return {fromC(options.drive), options.collide, options.turns, options.value};
}

WheelOptions fromC(const SulfurWheelMechanismOptions& options) {
    return {fromC(options.spring), fromC(options.motor), options.collide};
}

DistanceOptions fromC(const SulfurDistanceOptions& options) {
    return {fromC(options.drive), options.collide};
}

PulleyOptions fromC(const SulfurPulleyOptions& options) {
    PulleyOptions result;
    result.ratio = real(options.ratio);
    if (options.has_length) result.length = real(options.length);
    result.strength = real(options.strength);
    return result;
}

// --- to C ----------------------------------------------------------------------------------------

SulfurDrive toC(const Drive& drive) {
    return {toC(drive.lower),
            toC(drive.upper),
            toC(drive.stiffness),
            toC(drive.damping),
            toC(drive.rest),
            toC(drive.motorSpeed),
            toC(drive.motorMax),
            drive.motorTarget.has_value(),
            toC(drive.motorTarget.value_or(0)),
            toC(drive.strength)};
}

SulfurHingeOptions toC(const HingeOptions& options) {
    return {toC(options.drive), options.collide, options.pin, toC(options.strength), options.value};
}

SulfurWeldOptions toC(const WeldOptions& options) {
    return {toC(options.stiffness), toC(options.damping),        options.collide,
            toC(options.strength),  toC(options.torqueStrength), options.value};
}

SulfurSliderOptions toC(const SliderOptions& options) {
    return {toC(options.drive), options.collide, options.turns, options.value};
}

SulfurWheelMechanismOptions toC(const WheelOptions& options) {
    return {toC(options.spring), toC(options.motor), options.collide};
}

SulfurDistanceOptions toC(const DistanceOptions& options) {
    return {toC(options.drive), options.collide};
}

SulfurPulleyOptions toC(const PulleyOptions& options) {
    return {toC(options.ratio), options.length.has_value(), toC(options.length.value_or(0)),
            toC(options.strength)};
}

SulfurWheelIds toC(const WheelIds& ids) {
    return {toC(ids.spring), toC(ids.motor)};
}

SulfurMechanismInfo toC(const MechanismInfo& info) {
    return {static_cast<SulfurMechanismKind>(info.kind),
            toC(info.a),
            toC(info.b),
            toC(info.pointA),
            toC(info.pointB),
            info.value,
            info.speed,
            toC(info.force),
            toC(info.holding),
            info.atLower,
            info.atUpper,
            toC(info.drive),
            toC(info.ratio),
            info.collide,
            info.vetoes,
            info.pin,
            toC(info.strength),
            info.turns,
            toC(info.axis),
            info.railBegin,
            toC(info.overA),
            toC(info.overB),
            toC(info.frame),
            toC(info.first),
            toC(info.second),
            toC(info.pins[0]),
            toC(info.pins[1]),
            toC(info.own[0]),
            toC(info.own[1])};
}

SulfurLimitEvent toC(const LimitReached& event) {
    return {toC(event.mechanism), event.upper, toC(event.angle)};
}

SulfurLimitEvent toC(const LimitLeft& event) {
    return {toC(event.mechanism), event.upper, toC(event.angle)};
}

SulfurMechanismBroken toC(const MechanismBroken& event) {
    return {toC(event.mechanism), toC(event.a), toC(event.b), toC(event.force)};
}

SulfurAngleBroken toC(const AngleBroken& event) {
    return {toC(event.angle), toC(event.body), toC(event.corner), toC(event.torque)};
}

}  // namespace sulfur::c
