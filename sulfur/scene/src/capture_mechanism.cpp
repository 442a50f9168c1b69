#include "capture_mechanism.hpp"

#include <algorithm>
#include <cmath>

namespace sulfur::scene {

namespace {

constexpr double sameValue = 1e-9;  // rad or m
constexpr double sameAxis = 1e-6;   // rad, which float can tell

/// What is beyond all that a file can say counts as without bound.
Real bounded(Real value, double most) {
    return static_cast<double>(std::abs(value)) > most ? std::copysign(infinite, value) : value;
}

}  // namespace

Drive withinFile(Drive drive) {
    drive.lower = std::min(bounded(drive.lower, Limits::driven), static_cast<Real>(Limits::driven));
    drive.upper =
        std::max(bounded(drive.upper, Limits::driven), static_cast<Real>(-Limits::driven));
    drive.motorMax = bounded(drive.motorMax, Limits::strength);
    drive.strength = bounded(drive.strength, Limits::strength);
    return drive;
}

bool same(const Drive& a, const Drive& b) {
    return a.lower == b.lower && a.upper == b.upper && a.stiffness == b.stiffness &&
           a.damping == b.damping && a.rest == b.rest && a.motorSpeed == b.motorSpeed &&
           a.motorMax == b.motorMax && a.motorTarget == b.motorTarget && a.strength == b.strength;
}

namespace {

double valueOf(const MechanismInfo& info) {
    return std::clamp(info.value, -Limits::driven, Limits::driven);
}

Weld weldOf(const MechanismInfo& info) {
    Weld weld;
    weld.at = info.pointB;
    const Drive drive = withinFile(info.drive);
    weld.options.stiffness = drive.stiffness;
    weld.options.damping = drive.damping;
    weld.options.torqueStrength = drive.strength;
    weld.options.strength = bounded(info.strength, Limits::strength);
    weld.options.collide = info.collide;
    weld.options.value = valueOf(info);
    Drive plain;
    plain.stiffness = drive.stiffness;
    plain.damping = drive.damping;
    plain.strength = drive.strength;
    if (!same(plain, drive)) weld.drive = drive;
    return weld;
}

Pulley pulleyOf(const MechanismInfo& info) {
    Pulley pulley;
    pulley.atA = info.pointA;
    pulley.atB = info.pointB;
    pulley.overA = info.overA;
    pulley.overB = info.overB;
    const Drive drive = withinFile(info.drive);
    pulley.options.ratio = info.ratio;
    pulley.options.strength = drive.strength;
    Drive plain;
    plain.upper = drive.upper;
    plain.strength = drive.strength;
    if (same(plain, drive) && drive.upper >= 0 && drive.upper != infinite)
        pulley.options.length = drive.upper;
    else
        pulley.drive = drive;
    return pulley;
}

Slider sliderOf(const World& world, const MechanismInfo& info) {
    Slider slider;
    slider.at = info.pointB;
    if (info.rail.empty() && !info.axis.isZero(0)) slider.axis = info.axis;
    slider.options.drive = withinFile(info.drive);
    slider.options.collide = info.collide;
    slider.options.turns = info.turns;
    slider.options.value = valueOf(info);
    if (info.rail.empty()) return slider;
    slider.options.value = std::clamp(info.railBegin, -Limits::driven, Limits::driven);
    const auto joints = world.joints(info.a);
    for (const JointId link : info.rail)
        slider.rail.push_back(static_cast<std::uint32_t>(
            std::find(joints.begin(), joints.end(), link) - joints.begin()));
    return slider;
}

Hinge hingeOf(const MechanismInfo& info) {
    Hinge hinge;
    hinge.at = info.pointB;
    hinge.options.drive = withinFile(info.drive);
    hinge.options.collide = info.collide;
    hinge.options.pin = info.pin;
    hinge.options.strength = bounded(info.strength, Limits::strength);
    hinge.options.value = valueOf(info);
    return hinge;
}

Distance distanceOf(const MechanismInfo& info) {
    Distance distance;
    distance.atA = info.pointA;
    distance.atB = info.pointB;
    distance.options.drive = withinFile(info.drive);
    distance.options.collide = info.collide;
    return distance;
}

}  // namespace

MechanismCapture::MechanismCapture(const World& world, const std::map<BodyId, std::string>& ids)
    : world_(world), ids_(ids) {}

void MechanismCapture::know(const SceneMechanism& mechanism, const MadeMechanism& made) {
    known_.emplace(made.id, &mechanism);
    const auto* wheel = std::get_if<Wheel>(&mechanism.spec);
    if (wheel == nullptr || !isAsMade(*wheel, made)) return;
    wheels_.emplace(made.id, &mechanism);
    springs_.emplace(made.spring, made.id);
}

bool MechanismCapture::isAsMade(const Wheel& wheel, const MadeMechanism& made) const {
    if (!world_.contains(made.id) || !world_.contains(made.spring)) return false;
    const auto spring = world_.info(made.spring), motor = world_.info(made.id);
    const Point axis = wheel.axis.cast<double>().normalized();
    const Point axisNow = spring.axis.cast<double>();
    if ((axisNow - axis).norm() > sameAxis || spring.collide != wheel.options.collide) return false;
    return std::abs(spring.value) < sameValue && std::abs(motor.value) < sameValue &&
           (spring.pointB - wheel.at).norm() < sameValue &&
           same(spring.drive, wheel.options.spring) && same(motor.drive, wheel.options.motor);
}

std::vector<SceneMechanism> MechanismCapture::run() {
    for (const MechanismId id : world_.mechanisms())
        if (!springs_.contains(id)) add(id);
    return std::move(list_);
}

void MechanismCapture::add(MechanismId id) {
    const MechanismInfo info = world_.info(id);
    const bool isGear = info.kind == MechanismKind::gear;
    if (isGear && (!places_.contains(info.first) || !places_.contains(info.second))) return;
    if (!isGear && (!ids_.contains(info.a) || !ids_.contains(info.b))) return;
    if (info.kind == MechanismKind::pulley && !ids_.contains(info.frame)) return;
    SceneMechanism mechanism;
    if (const auto wheel = wheels_.find(id); wheel != wheels_.end())
        mechanism = *wheel->second;
    else
        mechanism = describe(info);
    if (const auto old = known_.find(id); old != known_.end()) {
        mechanism.id = old->second->id;
        mechanism.extra = old->second->extra;
    }
    places_.emplace(id, list_.size());
    list_.push_back(std::move(mechanism));
}

SceneMechanism MechanismCapture::describe(const MechanismInfo& info) {
    SceneMechanism result;
    switch (info.kind) {
        case MechanismKind::hinge:
            result.spec = hingeOf(info);
            break;
        case MechanismKind::weld:
            result.spec = weldOf(info);
            break;
        case MechanismKind::slider:
            result.spec = sliderOf(world_, info);
            break;
        case MechanismKind::distance:
            result.spec = distanceOf(info);
            break;
        case MechanismKind::pulley:
            result.spec = pulleyOf(info);
            break;
        case MechanismKind::gear: {
            Gear gear{nameOf(info.first), nameOf(info.second), info.ratio, std::nullopt};
            Drive plain;
            plain.stiffness = infinite;
            if (const Drive drive = withinFile(info.drive); !same(drive, plain)) gear.drive = drive;
            result.spec = gear;
            return result;
        }
    }
    const auto names = bodiesOf(result);
    *names[0] = ids_.at(info.a);
    *names[1] = ids_.at(info.b);
    if (names.size() > 2) *names[2] = ids_.at(info.frame);
    return result;
}

/// A part of a gear needs an id.
std::string MechanismCapture::nameOf(MechanismId part) {
    std::string& id = list_[places_.at(part)].id;
    const auto isTaken = [&](const std::string& name) {
        const auto isOf = [&](const auto& known) { return known.second->id == name; };
        return std::any_of(known_.begin(), known_.end(), isOf);
    };
    while (id.empty()) {
        const std::string name = "part" + std::to_string(++lastName_);
        if (!isTaken(name)) id = name;
    }
    return id;
}

}  // namespace sulfur::scene
