#include "fitting_properties.hpp"

#include "words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sulfurchamber {
namespace {

using sulfur::Drive;
using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::scene::SceneField;
using sulfur::scene::SceneMechanism;
using Number = std::optional<double>;

constexpr double boundless = std::numeric_limits<double>::infinity();
constexpr double degreesPerRadian = 180 / 3.14159265358979;

// What only is called where it is there.
template <class Value>
Value& present(Value* value) {
    if (value == nullptr) throw std::logic_error("it has no such number");
    return *value;
}
Drive& changed(const Drive* drive) {
    return const_cast<Drive&>(present(drive));
}

template <class Spec>
const Spec* specOf(const Fitting& fitting) {
    const auto* mechanism = std::get_if<SceneMechanism>(&fitting);
    return mechanism == nullptr ? nullptr : std::get_if<Spec>(&mechanism->spec);
}
template <class Spec>
Spec* specOf(Fitting& fitting) {
    return const_cast<Spec*>(specOf<Spec>(std::as_const(fitting)));
}

// Drives by the unit of their coordinate.
const Drive* turning(const Fitting& fitting) {
    if (const auto* hinge = specOf<sulfur::scene::Hinge>(fitting)) return &hinge->options.drive;
    if (const auto* wheel = specOf<sulfur::scene::Wheel>(fitting)) return &wheel->options.motor;
    return nullptr;
}
const Drive* sliding(const Fitting& fitting) {
    const auto* slider = specOf<sulfur::scene::Slider>(fitting);
    return slider == nullptr ? nullptr : &slider->options.drive;
}
const Drive* stretching(const Fitting& fitting) {
    const auto* distance = specOf<sulfur::scene::Distance>(fitting);
    return distance == nullptr ? nullptr : &distance->options.drive;
}
const Drive* winding(const Fitting& fitting) {
    const Drive* drive = stretching(fitting);
    return drive != nullptr && drive->motorMax > 0 ? drive : sliding(fitting);
}
const Drive* hinging(const Fitting& fitting) {
    return specOf<sulfur::scene::Hinge>(fitting) != nullptr ? turning(fitting) : nullptr;
}
const Drive* springing(const Fitting& fitting) {
    if (const auto* wheel = specOf<sulfur::scene::Wheel>(fitting)) return &wheel->options.spring;
    const Drive* drive = stretching(fitting);
    return drive != nullptr && drive->stiffness > 0 ? drive : nullptr;
}
using Choose = const Drive* (*)(const Fitting&);

// A number of a drive: by which member, in which unit, and for whom.
template <Choose choose, Real Drive::*member, int factor = 1>
Number getDrive(const Fitting& fitting) {
    const Drive* drive = choose(fitting);
    if (drive == nullptr) return std::nullopt;
    return factor * static_cast<double>(drive->*member);
}
template <Choose choose, Real Drive::*member, int factor = 1>
void setDriveNumber(Fitting& fitting, double value) {
    changed(choose(fitting)).*member = static_cast<Real>(factor * value);
}
// Angles are shown in degrees.
template <Choose choose, Real Drive::*member, int sign = 1>
Number getAngle(const Fitting& fitting) {
    const auto value = getDrive<choose, member, sign>(fitting);
    return value ? Number(*value * degreesPerRadian) : value;
}
template <Choose choose, Real Drive::*member, int sign = 1>
void setAngle(Fitting& fitting, double value) {
    setDriveNumber<choose, member, sign>(fitting, value / degreesPerRadian);
}

template <Choose choose, bool angle>
Number getTarget(const Fitting& fitting) {
    const Drive* drive = choose(fitting);
    if (drive == nullptr || !(drive->motorMax > 0)) return std::nullopt;
    if (!drive->motorTarget) return boundless;
    return static_cast<double>(*drive->motorTarget) * (angle ? degreesPerRadian : 1);
}
template <Choose choose, bool angle>
void setTarget(Fitting& fitting, double value) {
    auto& target = changed(choose(fitting)).motorTarget;
    if (std::isinf(value))
        target.reset();
    else
        target = static_cast<Real>(value / (angle ? degreesPerRadian : 1));
}

Real* strengthOf(Fitting& fitting) {
    if (auto* hinge = specOf<sulfur::scene::Hinge>(fitting)) return &hinge->options.strength;
    if (auto* weld = specOf<sulfur::scene::Weld>(fitting)) return &weld->options.strength;
    if (auto* pulley = specOf<sulfur::scene::Pulley>(fitting)) return &pulley->options.strength;
    if (auto* rope = specOf<sulfur::scene::Distance>(fitting)) return &rope->options.drive.strength;
    if (auto* joint = std::get_if<JointPart>(&fitting)) return &joint->spec.strength;
    return nullptr;
}
template <Real sulfur::ParticleSpec::* member>
Real* ofParticle(Fitting& fitting) {
    auto* part = std::get_if<ParticlePart>(&fitting);
    return part == nullptr ? nullptr : &(part->spec.*member);
}
template <Real sulfur::JointSpec::* member>
Real* ofJoint(Fitting& fitting) {
    auto* part = std::get_if<JointPart>(&fitting);
    return part == nullptr ? nullptr : &(part->spec.*member);
}
template <int axis>
Real* placeOf(Fitting& fitting) {
    auto* part = std::get_if<ParticlePart>(&fitting);
    return part == nullptr ? nullptr : &part->spec.position[axis];
}
Number getPinned(const Fitting& fitting) {
    const auto* part = std::get_if<ParticlePart>(&fitting);
    return part == nullptr ? std::nullopt : Number(part->spec.pinned ? 1 : 0);
}
void setPinned(Fitting& fitting, double value) {
    present(std::get_if<ParticlePart>(&fitting)).spec.pinned = value > 0.5;
}
Real* ratioOf(Fitting& fitting) {
    if (auto* pulley = specOf<sulfur::scene::Pulley>(fitting)) return &pulley->options.ratio;
    if (auto* gear = specOf<sulfur::scene::Gear>(fitting)) return &gear->ratio;
    return nullptr;
}
Real* bendingOf(Fitting& fitting) {
    if (auto* weld = specOf<sulfur::scene::Weld>(fitting)) return &weld->options.stiffness;
    if (auto* hinge = specOf<sulfur::scene::Hinge>(fitting)) return &hinge->options.drive.stiffness;
    return nullptr;
}
Real* bendingDamperOf(Fitting& fitting) {
    if (auto* weld = specOf<sulfur::scene::Weld>(fitting)) return &weld->options.damping;
    if (auto* hinge = specOf<sulfur::scene::Hinge>(fitting)) return &hinge->options.drive.damping;
    return nullptr;
}
bool* collideOf(Fitting& fitting) {
    auto* mechanism = std::get_if<SceneMechanism>(&fitting);
    if (mechanism == nullptr) return nullptr;
    return std::visit(
        [](auto& spec) -> bool* {
            if constexpr (requires { spec.options.collide; }) return &spec.options.collide;
            return nullptr;
        },
        mechanism->spec);
}

template <Real* (*of)(Fitting&)>
Number getReal(const Fitting& fitting) {
    const Real* value = of(const_cast<Fitting&>(fitting));
    return value == nullptr ? std::nullopt : Number(static_cast<double>(*value));
}
template <Real* (*of)(Fitting&)>
void setReal(Fitting& fitting, double value) {
    present(of(fitting)) = static_cast<Real>(value);
}
Number getCollide(const Fitting& fitting) {
    const bool* on = collideOf(const_cast<Fitting&>(fitting));
    return on == nullptr ? std::nullopt : Number(*on ? 1 : 0);
}
void setCollide(Fitting& fitting, double value) {
    present(collideOf(fitting)) = value > 0.5;
}
Number getTurns(const Fitting& fitting) {
    const auto* slider = specOf<sulfur::scene::Slider>(fitting);
    return slider == nullptr ? std::nullopt : Number(slider->options.turns ? 1 : 0);
}
void setTurns(Fitting& fitting, double value) {
    present(specOf<sulfur::scene::Slider>(fitting)).options.turns = value > 0.5;
}
// A ratio of 0 is none.
void setRatio(Fitting& fitting, double value) {
    present(ratioOf(fitting)) =
        static_cast<Real>(std::abs(value) < 0.01 ? std::copysign(0.01, value) : value);
}

// --- what pushes everywhere in a zone, and thrusters -----------------------------------------

Vec2* vectorOf(Fitting& fitting) {
    if (auto* thruster = std::get_if<Thruster>(&fitting)) return &thruster->force;
    auto* zone = std::get_if<SceneField>(&fitting);
    if (zone == nullptr) return nullptr;
    if (auto* wind = std::get_if<sulfur::WindField>(&zone->field)) return &wind->velocity;
    if (auto* uniform = std::get_if<sulfur::UniformField>(&zone->field))
        return &uniform->acceleration;
    return nullptr;
}
enum class Pushing { thruster, wind, gravity };
template <Pushing what>
Number getSize(const Fitting& fitting) {
    const auto* zone = std::get_if<SceneField>(&fitting);
    const bool fits = what == Pushing::thruster ? std::holds_alternative<Thruster>(fitting)
                      : zone == nullptr         ? false
                      : what == Pushing::wind
                          ? std::holds_alternative<sulfur::WindField>(zone->field)
                          : std::holds_alternative<sulfur::UniformField>(zone->field);
    if (!fits) return std::nullopt;
    return static_cast<double>(present(vectorOf(const_cast<Fitting&>(fitting))).norm());
}
// Of what is 0 the direction is lost: it goes up again.
void setSize(Fitting& fitting, double value) {
    Vec2& vector = present(vectorOf(fitting));
    const Vec2 way = vector.norm() > 0 ? Vec2(vector.normalized()) : Vec2(0, 1);
    vector = static_cast<Real>(value) * way;
}
Number getDirection(const Fitting& fitting) {
    const Vec2* vector = vectorOf(const_cast<Fitting&>(fitting));
    if (vector == nullptr) return std::nullopt;
    return degreesPerRadian *
           std::atan2(static_cast<double>(vector->y()), static_cast<double>(vector->x()));
}
void setDirection(Fitting& fitting, double value) {
    Vec2& vector = present(vectorOf(fitting));
    const double angle = value / degreesPerRadian;
    vector = vector.norm() * Point(std::cos(angle), std::sin(angle)).cast<Real>();
}
Number getDrag(const Fitting& fitting) {
    const auto* zone = std::get_if<SceneField>(&fitting);
    const auto* wind = zone == nullptr ? nullptr : std::get_if<sulfur::WindField>(&zone->field);
    return wind == nullptr ? std::nullopt : Number(static_cast<double>(wind->drag));
}
void setDrag(Fitting& fitting, double value) {
    std::get<sulfur::WindField>(std::get<SceneField>(fitting).field).drag =
        static_cast<Real>(value);
}

// --- the rectangle of a zone -----------------------------------------------------------------

sulfur::BoxZone* boxOf(Fitting& fitting) {
    auto* zone = std::get_if<SceneField>(&fitting);
    if (zone == nullptr) return nullptr;
    return std::visit(
        [](auto& field) -> sulfur::BoxZone* {
            if constexpr (requires { field.zone; })
                return std::get_if<sulfur::BoxZone>(&field.zone);
            return nullptr;
        },
        zone->field);
}
template <int axis>
Number getExtent(const Fitting& fitting) {
    const auto* box = boxOf(const_cast<Fitting&>(fitting));
    return box == nullptr ? std::nullopt : Number(box->high[axis] - box->low[axis]);
}
template <int axis>
void setExtent(Fitting& fitting, double value) {
    sulfur::BoxZone& box = present(boxOf(fitting));
    const double middle = (box.high[axis] + box.low[axis]) / 2;
    box.low[axis] = middle - value / 2;
    box.high[axis] = middle + value / 2;
}
template <int axis>
Number getMiddle(const Fitting& fitting) {
    const auto* box = boxOf(const_cast<Fitting&>(fitting));
    return box == nullptr ? std::nullopt : Number((box->high[axis] + box->low[axis]) / 2);
}
template <int axis>
void setMiddle(Fitting& fitting, double value) {
    sulfur::BoxZone& box = present(boxOf(fitting));
    const double by = value - (box.high[axis] + box.low[axis]) / 2;
    box.low[axis] += by;
    box.high[axis] += by;
}

Number getBrake(const Fitting& fitting) {
    const auto keys = keysOf(fitting);
    const bool motor = turning(fitting) != nullptr || sliding(fitting) != nullptr;
    if (!keys || !motor || !keys->any()) return std::nullopt;
    return keys->brake;
}
void setBrake(Fitting& fitting, double value) {
    auto& mechanism = std::get<SceneMechanism>(fitting);
    DriveKeys keys = keysOf(mechanism);
    keys.brake = value;
    setKeys(mechanism, keys);
}

constexpr auto log = Scale::logarithmic;
constexpr auto lin = Scale::linear;
constexpr auto cub = Scale::cubic;
constexpr const char* degree = "\xC2\xB0";

constexpr std::array allProperties{
    FittingProperty{"speed", "Motor speed", "rad/s", "Positive turns anticlockwise", -60, 60, lin,
                    "", false, true, getDrive<turning, &Drive::motorSpeed>,
                    setDriveNumber<turning, &Drive::motorSpeed>},
    FittingProperty{"torque", "Largest torque", "N m", "The most that the motor gives; 0: no motor",
                    0, 1e5, cub, "any", false, true, getDrive<turning, &Drive::motorMax>,
                    setDriveNumber<turning, &Drive::motorMax>},
    FittingProperty{"target", "Target", degree, "The motor goes there and stays", -720, 720, lin,
                    "none", false, true, getTarget<turning, true>, setTarget<turning, true>},
    FittingProperty{"speed", "Motor speed", "m/s", "Negative pulls in", -20, 20, lin, "", false,
                    true, getDrive<winding, &Drive::motorSpeed>,
                    setDriveNumber<winding, &Drive::motorSpeed>},
    FittingProperty{"pull", "Largest pull", "N", "The most that the motor gives; 0: no motor", 0,
                    1e6, cub, "any", false, true, getDrive<winding, &Drive::motorMax>,
                    setDriveNumber<winding, &Drive::motorMax>},
    FittingProperty{"target", "Target", "m", "The motor goes there and stays", -100, 100, lin,
                    "none", false, true, getTarget<sliding, false>, setTarget<sliding, false>},
    FittingProperty{"brake", "Brake", "", "Of the largest torque, while no key is held", 0, 1, lin,
                    "", false, true, getBrake, setBrake},
    FittingProperty{"turn-back", "Turns back", degree, "How far it turns clockwise at most", -720,
                    720, lin, "free", false, true, getAngle<hinging, &Drive::lower, -1>,
                    setAngle<hinging, &Drive::lower, -1>},
    FittingProperty{"turn-on", "Turns on", degree, "How far it turns anticlockwise at most", -720,
                    720, lin, "free", false, true, getAngle<hinging, &Drive::upper>,
                    setAngle<hinging, &Drive::upper>},
    FittingProperty{"slide-back", "Slides back", "m", "How far it goes back at most", -100, 100,
                    lin, "free", false, true, getDrive<sliding, &Drive::lower, -1>,
                    setDriveNumber<sliding, &Drive::lower, -1>},
    FittingProperty{"slide-on", "Slides on", "m", "How far it goes on at most", -100, 100, lin,
                    "free", false, true, getDrive<sliding, &Drive::upper>,
                    setDriveNumber<sliding, &Drive::upper>},
    FittingProperty{"turns", "Turns", "", "1: what slides turns freely; 0: it keeps its angle", 0,
                    1, lin, "", true, false, getTurns, setTurns},
    FittingProperty{"longest", "Longest", "m", "The distance that it allows", 0.01, 1000, log,
                    "any", false, true, getDrive<stretching, &Drive::upper>,
                    setDriveNumber<stretching, &Drive::upper>},
    FittingProperty{"stiffness", "Stiffness", "N/m", "Of the spring", 0, 1e6, cub, "", false, true,
                    getDrive<springing, &Drive::stiffness>,
                    setDriveNumber<springing, &Drive::stiffness>},
    FittingProperty{"damping", "Damping", "N s/m", "How soon the spring comes to rest", 0, 1e5, cub,
                    "", false, true, getDrive<springing, &Drive::damping>,
                    setDriveNumber<springing, &Drive::damping>},
    FittingProperty{"rest", "Rest length", "m", "Where the spring is at rest", -100, 100, lin, "",
                    false, true, getDrive<springing, &Drive::rest>,
                    setDriveNumber<springing, &Drive::rest>},
    FittingProperty{"bending", "Stiffness", "N m/rad", "Against turning", 0, 1e6, cub, "rigid",
                    false, false, getReal<bendingOf>, setReal<bendingOf>},
    FittingProperty{"bend-damping", "Damping", "N m s/rad", "How soon turning comes to rest", 0,
                    1e5, cub, "", false, false, getReal<bendingDamperOf>, setReal<bendingDamperOf>},
    FittingProperty{"ratio", "Ratio", "", "How many times the second one counts", -100, 100, lin,
                    "", false, false, getReal<ratioOf>, setRatio},
    FittingProperty{"joint-stiffness", "Stiffness", "N/m", "Of the joint", 0, 1e9, cub, "rigid",
                    false, true, getReal<ofJoint<&sulfur::JointSpec::stiffness>>,
                    setReal<ofJoint<&sulfur::JointSpec::stiffness>>},
    FittingProperty{"joint-damping", "Damping", "N s/m", "Along the joint", 0, 1e6, cub, "", false,
                    true, getReal<ofJoint<&sulfur::JointSpec::damping>>,
                    setReal<ofJoint<&sulfur::JointSpec::damping>>},
    FittingProperty{"joint-radius", "Radius", "m", "Half its thickness; 0: it touches nothing", 0,
                    10, cub, "", false, true, getReal<ofJoint<&sulfur::JointSpec::radius>>,
                    setReal<ofJoint<&sulfur::JointSpec::radius>>},
    FittingProperty{"particle-mass", "Mass", "kg", "Of the particle", 1e-3, 1e4, log, "", false,
                    true, getReal<ofParticle<&sulfur::ParticleSpec::mass>>,
                    setReal<ofParticle<&sulfur::ParticleSpec::mass>>},
    FittingProperty{"particle-radius", "Radius", "m", "Of its disc; 0: it touches nothing", 0, 10,
                    cub, "", false, true, getReal<ofParticle<&sulfur::ParticleSpec::radius>>,
                    setReal<ofParticle<&sulfur::ParticleSpec::radius>>},
    FittingProperty{"particle-pinned", "Pinned", "", "1: it is held where it is", 0, 1, lin, "",
                    true, true, getPinned, setPinned},
    FittingProperty{"particle-x", "x", "m", "In the frame of its body", -1000, 1000, lin, "", false,
                    true, getReal<placeOf<0>>, setReal<placeOf<0>>},
    FittingProperty{"particle-y", "y", "m", "In the frame of its body", -1000, 1000, lin, "", false,
                    true, getReal<placeOf<1>>, setReal<placeOf<1>>},
    FittingProperty{"strength", "Strength", "N", "The force at which it breaks", 1, 1e7, log,
                    "never", false, false, getReal<strengthOf>, setReal<strengthOf>},
    FittingProperty{"collide", "Bodies touch", "", "1: its bodies touch each other; 0: they pass",
                    0, 1, lin, "", true, false, getCollide, setCollide},
    FittingProperty{"force", "Force", "N", "How strongly it pushes", 0, 1e5, cub, "", false, true,
                    getSize<Pushing::thruster>, setSize},
    FittingProperty{"wind", "Wind", "m/s", "How fast the air moves", 0, 100, cub, "", false, true,
                    getSize<Pushing::wind>, setSize},
    FittingProperty{"drag", "Drag", "1/s", "How strongly the air takes along", 0, 100, cub, "",
                    false, true, getDrag, setDrag},
    FittingProperty{"acceleration", "Acceleration", "m/s\xC2\xB2", "Beside gravity, for all in it",
                    0, 200, cub, "", false, true, getSize<Pushing::gravity>, setSize},
    FittingProperty{"direction", "Direction", degree, "0 is to the right, 90 up", -180, 180, lin,
                    "", false, true, getDirection, setDirection},
    FittingProperty{"width", "Width", "m", "Of the zone", 0.05, 1000, log, "", false, true,
                    getExtent<0>, setExtent<0>},
    FittingProperty{"height", "Height", "m", "Of the zone", 0.05, 1000, log, "", false, true,
                    getExtent<1>, setExtent<1>},
    FittingProperty{"x", "x", "m", "Of its middle", -1000, 1000, lin, "", false, true, getMiddle<0>,
                    setMiddle<0>},
    FittingProperty{"y", "y", "m", "Of its middle", -1000, 1000, lin, "", false, true, getMiddle<1>,
                    setMiddle<1>},
};

std::string shortNumber(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

std::span<const FittingProperty> fittingProperties() {
    return allProperties;
}

const FittingProperty* fittingProperty(std::string_view key, const Fitting& fitting) {
    for (const FittingProperty& property : allProperties)
        if (property.key == key && property.get(fitting)) return &property;
    return nullptr;
}

void setFittingProperty(Document& document, const FittingRef& ref, const FittingProperty& property,
                        double value) {
    const bool endless = std::isinf(value) && value > 0 && !property.endless.empty();
    if (!endless && !(value >= property.low && value <= property.high))
        throw std::runtime_error(tr("{} is out of range; allowed is {} to {}",
                                    {tr(std::string(property.name)), shortNumber(property.low),
                                     shortNumber(property.high)}));
    if (property.whole) value = std::round(value);
    document.refit(
        ref, [&](Fitting& fitting) { property.set(fitting, value); }, property.live);
}

std::optional<DriveKeys> keysOf(const Fitting& fitting) {
    if (const auto* thruster = std::get_if<Thruster>(&fitting)) return thruster->keys;
    const auto* mechanism = std::get_if<SceneMechanism>(&fitting);
    const Drive* drive = mechanism == nullptr ? nullptr : driveOf(*mechanism);
    if (drive == nullptr || !(drive->motorMax > 0)) return std::nullopt;
    return keysOf(*mechanism);
}

void setFittingKeys(Document& document, const FittingRef& ref, const DriveKeys& keys) {
    for (const std::string& key : {keys.forward, keys.back})
        if (!key.empty() && !isControlKey(key))
            throw std::runtime_error(
                tr("“{}” drives nothing; allowed is a letter, Right, Left, Up or Down", {key}));
    document.refit(
        ref,
        [&](Fitting& fitting) {
            if (auto* thruster = std::get_if<Thruster>(&fitting))
                thruster->keys = keys;
            else
                setKeys(std::get<SceneMechanism>(fitting), keys);
        },
        true);
}

}  // namespace sulfurchamber
