// The members of the simple objects of a file, each told once: the reader, the writer and the list
// of keys are three visitors of these descriptions, so they cannot disagree.
//
// describe(visitor, object) calls one function of the visitor per member, with the member's key, a
// reference to it, the value that it has when the file says nothing, and its bounds.
#pragma once

#include <array>
#include <concepts>
#include <sulfur/scene/scene.hpp>
#include <type_traits>

namespace sulfur::scene {

/// `Object` is `Plain` or const `Plain`.
template <class Object, class Plain>
concept Is = std::same_as<std::remove_const_t<Object>, Plain>;

inline constexpr double largestSize = 2 * Limits::coordinate;  ///< metres
inline constexpr double largestRadius = 100;                   ///< metres

/// How choices are called in files, in the order of the alternatives.
inline constexpr std::array<const char*, 2> frictionNames{"coulomb", "sliding"};

template <class Visitor, Is<WorldSettings> Object>
void describe(Visitor& v, Object& o) {
    const WorldSettings d;
    v.vec("gravity", o.gravity, d.gravity, Limits::gravity);
    v.number("airFriction", o.airFriction, d.airFriction, 0, 10000);
    v.integer("tickRate", o.tickRate, d.tickRate, 60, 10000);
    v.flag("sleeping", o.sleeping, d.sleeping);
    v.integer("sweeps", o.sweeps, d.sweeps, 1, 100);
    v.choice("friction", o.friction, d.friction, frictionNames);
    v.optionalNumber("sleepSpeed", o.sleepSpeed, 0, Limits::speed);
    v.optionalNumber("reboundSpeed", o.reboundSpeed, 0, Limits::speed);
}

template <class Visitor, Is<Material> Object>
void describe(Visitor& v, Object& o) {
    const Material d;
    v.number("staticFriction", o.staticFriction, d.staticFriction, 0, Limits::friction);
    v.number("kineticFriction", o.kineticFriction, d.kineticFriction, 0, Limits::friction);
    v.number("restitution", o.restitution, d.restitution, 0, 1);
    v.number("surfaceSpeed", o.surfaceSpeed, d.surfaceSpeed, -Limits::surfaceSpeed,
             Limits::surfaceSpeed);
    v.number("rollingResistance", o.rollingResistance, d.rollingResistance, 0,
             Limits::rollingResistance);
}

template <class Visitor, Is<Filter> Object>
void describe(Visitor& v, Object& o) {
    const Filter d;
    v.integer("category", o.category, d.category, 0, 0xffffffff);
    v.integer("mask", o.mask, d.mask, 0, 0xffffffff);
    v.integer("group", o.group, d.group, -2147483648LL, 2147483647);
}

template <class Visitor, Is<ParticleSpec> Object>
void describe(Visitor& v, Object& o) {
    const ParticleSpec d;
    v.vec("position", o.position, d.position, Limits::coordinate);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.number("radius", o.radius, d.radius, 0, largestRadius);
    v.flag("pinned", o.pinned, d.pinned);
}

/// What joints inside a body and joints between bodies have in common.
template <class Visitor, class Object>
void describeJoint(Visitor& v, Object& o) {
    const ConnectOptions d;
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.optionalNumber("restLength", o.restLength, 0, 2 * largestSize);
    v.number("radius", o.radius, d.radius, 0, largestRadius);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.optionalMaterial("material", o.material);
}

template <class Visitor, Is<JointSpec> Object>
void describe(Visitor& v, Object& o) {
    v.index("a", o.a);
    v.index("b", o.b);
    describeJoint(v, o);
    v.number("bend", o.bend, JointSpec{}.bend, -Limits::angle, Limits::angle);
}

/// What drives and angular joints have in common.
template <class Visitor, class Object>
void describeLimits(Visitor& v, Object& o) {
    const Drive d;
    v.number("lower", o.lower, d.lower, -Limits::driven, Limits::driven);
    v.number("upper", o.upper, d.upper, -Limits::driven, Limits::driven);
}

template <class Visitor, class Object>
void describeMotor(Visitor& v, Object& o) {
    const Drive d;
    v.number("motorSpeed", o.motorSpeed, d.motorSpeed, -Limits::driven, Limits::driven);
    v.infinite("motorMax", o.motorMax, d.motorMax, Limits::strength, "unlimited");
    v.optionalNumber("motorTarget", o.motorTarget, -Limits::driven, Limits::driven);
    v.strength("strength", o.strength);
}

template <class Visitor, Is<AngularJointSpec> Object>
void describe(Visitor& v, Object& o) {
    const AngularJointSpec d;
    v.index("a", o.a);
    v.index("b", o.b);
    v.index("c", o.c);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::angularStiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.optionalNumber("restAngle", o.restAngle, -Limits::angle, Limits::angle);
    describeLimits(v, o);
    describeMotor(v, o);
}

template <class Visitor, Is<FloorOptions> Object>
void describe(Visitor& v, Object& o) {
    const FloorOptions d;
    v.vec("from", o.from, d.from, Limits::coordinate);
    v.vec("to", o.to, d.to, Limits::coordinate);
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::GroundOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::GroundOptions d;
    v.points("points", o.points, 2, Limits::particles, Limits::coordinate);
    v.flag("closed", o.closed, d.closed);
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.material("material", o.material);
    v.numbers("bends", o.bends, Limits::particles, -Limits::angle, Limits::angle);
}

template <class Visitor, Is<shapes::BoxOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::BoxOptions d;
    v.size("size", o.size, d.size, largestSize);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.flag("solidInertia", o.solidInertia, d.solidInertia);
    v.flag("rounded", o.rounded, d.rounded);
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::BallOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::BallOptions d;
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::RopeOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::RopeOptions d;
    v.vec("from", o.from, d.from, Limits::coordinate);
    v.vec("to", o.to, d.to, Limits::coordinate);
    v.integer("links", o.links, d.links, 0, Limits::particles - 1);
    v.optionalNumber("slack", o.slack, 0, 10);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.number("radius", o.radius, d.radius, 0, largestRadius);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.number("bending", o.bending, d.bending, 0, Limits::bending);
    v.number("bendingDamping", o.bendingDamping, d.bendingDamping, 0, Limits::bending);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.flag("pinFirst", o.pinFirst, d.pinFirst);
    v.flag("pinLast", o.pinLast, d.pinLast);
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::JellyOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::JellyOptions d;
    v.size("size", o.size, d.size, largestSize);
    v.integer("columns", o.columns, d.columns, 2, 1000);
    v.integer("rows", o.rows, d.rows, 2, 1000);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::BlobOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::BlobOptions d;
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.integer("segments", o.segments, d.segments, 3, 1000);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.positive("skinRadius", o.skinRadius, d.skinRadius, largestRadius);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::PolygonOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::PolygonOptions d;
    v.points("points", o.points, 3, 200, Limits::coordinate);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.flag("rounded", o.rounded, d.rounded);
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::WheelOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::WheelOptions d;
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.integer("segments", o.segments, d.segments, 3, 1000);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.positive("rimRadius", o.rimRadius, d.rimRadius, largestRadius);
    v.infinite("spokeStiffness", o.spokeStiffness, d.spokeStiffness, Limits::stiffness, "rigid");
    v.number("spokeDamping", o.spokeDamping, d.spokeDamping, 0, Limits::damping);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::ChainOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::ChainOptions d;
    v.vec("from", o.from, d.from, Limits::coordinate);
    v.vec("to", o.to, d.to, Limits::coordinate);
    v.integer("links", o.links, d.links, 0, Limits::particles - 1);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.number("radius", o.radius, d.radius, 0, largestRadius);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.flag("pinFirst", o.pinFirst, d.pinFirst);
    v.flag("pinLast", o.pinLast, d.pinLast);
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::BridgeOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::BridgeOptions d;
    v.vec("from", o.from, d.from, Limits::coordinate);
    v.vec("to", o.to, d.to, Limits::coordinate);
    v.integer("planks", o.planks, d.planks, 1, 10000);
    v.number("sag", o.sag, d.sag, 0, Limits::coordinate);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::ClothOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::ClothOptions d;
    v.size("size", o.size, d.size, largestSize);
    v.integer("columns", o.columns, d.columns, 3, 1000);
    v.integer("rows", o.rows, d.rows, 3, 1000);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.number("radius", o.radius, d.radius, 0, largestRadius);
    v.flag("diagonals", o.diagonals, d.diagonals);
    v.flag("pinCorners", o.pinCorners, d.pinCorners);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.material("material", o.material);
}

template <class Visitor, Is<shapes::WallOptions> Object>
void describe(Visitor& v, Object& o) {
    const shapes::WallOptions d;
    v.size("size", o.size, d.size, largestSize);
    v.integer("columns", o.columns, d.columns, 1, 999);
    v.integer("rows", o.rows, d.rows, 1, 999);
    v.positive("mass", o.mass, d.mass, Limits::mass);
    v.positive("radius", o.radius, d.radius, largestRadius);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::stiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.infinite("strength", o.strength, d.strength, Limits::strength, "unbreakable");
    v.flag("pinBottom", o.pinBottom, d.pinBottom);
    v.material("material", o.material);
}

template <class Visitor, Is<BoxZone> Object>
void describe(Visitor& v, Object& o) {
    v.point("low", o.low);
    v.point("high", o.high);
}

template <class Visitor, Is<CircleZone> Object>
void describe(Visitor& v, Object& o) {
    const CircleZone d;
    v.point("centre", o.centre);
    v.number("radius", o.radius, d.radius, 1e-9, largestSize);
}

template <class Visitor, Is<UniformField> Object>
void describe(Visitor& v, Object& o) {
    const UniformField d;
    v.zone("zone", o.zone);
    v.vec("acceleration", o.acceleration, d.acceleration, 1e6);
    v.integer("mask", o.mask, d.mask, 0, 0xffffffff);
}

template <class Visitor, Is<RadialField> Object>
void describe(Visitor& v, Object& o) {
    const RadialField d;
    v.point("centre", o.centre);
    v.number("strength", o.strength, d.strength, -1e12, 1e12);
    v.integer("falloff", o.falloff, d.falloff, 0, 4);
    v.number("core", o.core, d.core, 1e-3, 1e6);
    v.infinite("reach", o.reach, d.reach, 1e9, "unlimited");
    v.integer("mask", o.mask, d.mask, 0, 0xffffffff);
}

template <class Visitor, Is<WindField> Object>
void describe(Visitor& v, Object& o) {
    const WindField d;
    v.zone("zone", o.zone);
    v.vec("velocity", o.velocity, d.velocity, Limits::speed);
    v.number("drag", o.drag, d.drag, 0, 10000);
    v.integer("mask", o.mask, d.mask, 0, 0xffffffff);
}

template <class Visitor, Is<Drive> Object>
void describe(Visitor& v, Object& o) {
    const Drive d;
    describeLimits(v, o);
    v.infinite("stiffness", o.stiffness, d.stiffness, Limits::angularStiffness, "rigid");
    v.number("damping", o.damping, d.damping, 0, Limits::damping);
    v.number("rest", o.rest, d.rest, -Limits::driven, Limits::driven);
    describeMotor(v, o);
}

template <class Visitor, Is<Hinge> Object>
void describe(Visitor& v, Object& o) {
    const HingeOptions d;
    v.name("a", o.a);
    v.name("b", o.b);
    v.point("at", o.at);
    v.flag("collide", o.options.collide, d.collide);
    v.flag("pin", o.options.pin, d.pin);
    v.strength("strength", o.options.strength);
    v.precise("value", o.options.value, d.value, -Limits::driven, Limits::driven);
    v.drive("drive", o.options.drive);
}

template <class Visitor, Is<Weld> Object>
void describe(Visitor& v, Object& o) {
    const WeldOptions d;
    v.name("a", o.a);
    v.name("b", o.b);
    v.point("at", o.at);
    v.infinite("stiffness", o.options.stiffness, d.stiffness, Limits::angularStiffness, "rigid");
    v.number("damping", o.options.damping, d.damping, 0, Limits::damping);
    v.flag("collide", o.options.collide, d.collide);
    v.strength("strength", o.options.strength);
    v.strength("torqueStrength", o.options.torqueStrength);
    v.precise("value", o.options.value, d.value, -Limits::driven, Limits::driven);
    v.optionalDrive("drive", o.drive);
}

template <class Visitor, Is<Slider> Object>
void describe(Visitor& v, Object& o) {
    const SliderOptions d;
    v.name("a", o.a);
    v.name("b", o.b);
    v.point("at", o.at);
    v.vec("axis", o.axis, Slider{}.axis, Limits::driven);
    v.indices("rail", o.rail, Limits::joints);
    v.flag("collide", o.options.collide, d.collide);
    v.flag("turns", o.options.turns, d.turns);
    v.precise("value", o.options.value, d.value, -Limits::driven, Limits::driven);
    v.drive("drive", o.options.drive);
}

template <class Visitor, Is<Wheel> Object>
void describe(Visitor& v, Object& o) {
    const WheelOptions d;
    v.name("a", o.a);
    v.name("b", o.b);
    v.point("at", o.at);
    v.vec("axis", o.axis, Wheel{}.axis, Limits::driven);
    v.flag("collide", o.options.collide, d.collide);
    v.drive("spring", o.options.spring);
    v.drive("motor", o.options.motor);
}

template <class Visitor, Is<Distance> Object>
void describe(Visitor& v, Object& o) {
    const DistanceOptions d;
    v.name("a", o.a);
    v.name("b", o.b);
    v.point("atA", o.atA);
    v.point("atB", o.atB);
    v.flag("collide", o.options.collide, d.collide);
    v.drive("drive", o.options.drive);
}

template <class Visitor, Is<Pulley> Object>
void describe(Visitor& v, Object& o) {
    const PulleyOptions d;
    v.name("a", o.a);
    v.name("b", o.b);
    v.name("frame", o.frame);
    v.point("atA", o.atA);
    v.point("atB", o.atB);
    v.point("overA", o.overA);
    v.point("overB", o.overB);
    v.number("ratio", o.options.ratio, d.ratio, Limits::leastRatio, Limits::ratio);
    v.optionalNumber("length", o.options.length, 0, Limits::driven);
    v.strength("strength", o.options.strength);
    v.optionalDrive("drive", o.drive);
}

template <class Visitor, Is<Gear> Object>
void describe(Visitor& v, Object& o) {
    v.name("first", o.first);
    v.name("second", o.second);
    v.number("ratio", o.ratio, Gear{}.ratio, -Limits::ratio, Limits::ratio);
    v.optionalDrive("drive", o.drive);
}

template <class Visitor, Is<std::monostate> Object>
void describe(Visitor&, Object&) {}

/// How generators are called in files, in the order of the alternatives of Generator.
inline constexpr const char* generatorNames[] = {"",      "floor",  "ground", "box",     "ball",
                                                 "rope",  "jelly",  "blob",   "polygon", "wheel",
                                                 "chain", "bridge", "cloth",  "wall"};
static_assert(std::size(generatorNames) == std::variant_size_v<Generator>);
/// How fields are called in files, and the parts of keysOf(), in the order of Field's alternatives.
inline constexpr const char* fieldNames[] = {"uniform", "radial", "wind"};
inline constexpr const char* fieldParts[] = {"uniformField", "radialField", "windField"};
static_assert(std::size(fieldNames) == std::variant_size_v<Field>);
/// The same of mechanisms.
inline constexpr const char* mechanismNames[] = {"hinge",    "weld",   "slider", "wheel",
                                                 "distance", "pulley", "gear"};
inline constexpr const char* mechanismParts[] = {
    "hingeMechanism",    "weldMechanism",   "sliderMechanism", "wheelMechanism",
    "distanceMechanism", "pulleyMechanism", "gearMechanism"};
static_assert(std::size(mechanismNames) == std::variant_size_v<decltype(SceneMechanism::spec)>);
inline constexpr const char* kindNames[] = {"dynamic", "kinematic", "fixed"};

}  // namespace sulfur::scene
