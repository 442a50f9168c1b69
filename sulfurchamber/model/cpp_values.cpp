#include "cpp_values.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace sulfurchamber::cpp {
namespace {

using namespace sulfur;

// The shortest decimal that is read back as the same number.
template <class Number>
std::string shortest(Number value, const char* ending) {
    if (std::isinf(value)) return value < 0 ? "-infinite" : "infinite";
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    std::string word(digits.data(), end);
    if (word.find_first_of(".e") == std::string::npos) word += ".0";
    return word + ending;
}

// Members of a struct that differ from what they are anyway, in the order of their declaration.
class Members {
public:
    template <class T>
    Members& add(const char* name, const T& value, const T& usual) {
        std::string is = text(value);
        if (is == text(usual)) return *this;
        all_ += (all_.empty() ? "." : ", .") + std::string(name) + " = " + is;
        return *this;
    }
    std::string done(const char* type = "") const { return std::string(type) + "{" + all_ + "}"; }

private:
    std::string all_;
};

std::string zoneText(const Zone& zone) {
    if (const auto* box = std::get_if<BoxZone>(&zone))
        return "BoxZone{" + text(box->low) + ", " + text(box->high) + "}";
    if (const auto* circle = std::get_if<CircleZone>(&zone))
        return "CircleZone{" + text(circle->centre) + ", " + text(circle->radius) + "}";
    return "Everywhere{}";
}

std::string fieldText(const UniformField& f) {
    return "UniformField{" + zoneText(f.zone) + ", " + text(f.acceleration) + ", " + text(f.mask) +
           "}";
}
std::string fieldText(const RadialField& f) {
    const RadialField d;
    return Members()
        .add("centre", f.centre, d.centre)
        .add("strength", f.strength, d.strength)
        .add("falloff", f.falloff, d.falloff)
        .add("core", f.core, d.core)
        .add("reach", f.reach, d.reach)
        .add("mask", f.mask, d.mask)
        .done("RadialField");
}
std::string fieldText(const WindField& f) {
    return "WindField{" + zoneText(f.zone) + ", " + text(f.velocity) + ", " + text(f.drag) + ", " +
           text(f.mask) + "}";
}

// --- recipes ---------------------------------------------------------------------------------

std::string callOf(std::monostate) {
    return "";
}
std::string callOf(const scene::FloorOptions& o) {
    return "shapes::floor(" + text(o.from) + ", " + text(o.to) + ", " + text(o.radius) + ")";
}
std::string callOf(const shapes::GroundOptions& o) {
    const shapes::GroundOptions d;
    return "shapes::ground(" +
           Members()
               .add("points", o.points, d.points)
               .add("closed", o.closed, d.closed)
               .add("radius", o.radius, d.radius)
               .add("material", o.material, d.material)
               .add("bends", o.bends, d.bends)
               .done() +
           ")";
}
std::string callOf(const shapes::BoxOptions& o) {
    const shapes::BoxOptions d;
    return "shapes::box(" +
           Members()
               .add("size", o.size, d.size)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("strength", o.strength, d.strength)
               .add("solidInertia", o.solidInertia, d.solidInertia)
               .add("rounded", o.rounded, d.rounded)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::BallOptions& o) {
    const shapes::BallOptions d;
    return "shapes::ball(" +
           Members()
               .add("radius", o.radius, d.radius)
               .add("mass", o.mass, d.mass)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::RopeOptions& o) {
    const shapes::RopeOptions d;
    return "shapes::rope(" +
           Members()
               .add("from", o.from, d.from)
               .add("to", o.to, d.to)
               .add("links", o.links, d.links)
               .add("slack", o.slack, d.slack)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("bending", o.bending, d.bending)
               .add("bendingDamping", o.bendingDamping, d.bendingDamping)
               .add("strength", o.strength, d.strength)
               .add("pinFirst", o.pinFirst, d.pinFirst)
               .add("pinLast", o.pinLast, d.pinLast)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::JellyOptions& o) {
    const shapes::JellyOptions d;
    return "shapes::jelly(" +
           Members()
               .add("size", o.size, d.size)
               .add("columns", o.columns, d.columns)
               .add("rows", o.rows, d.rows)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("strength", o.strength, d.strength)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::BlobOptions& o) {
    const shapes::BlobOptions d;
    return "shapes::blob(" +
           Members()
               .add("radius", o.radius, d.radius)
               .add("segments", o.segments, d.segments)
               .add("mass", o.mass, d.mass)
               .add("skinRadius", o.skinRadius, d.skinRadius)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::PolygonOptions& o) {
    const shapes::PolygonOptions d;
    return "shapes::polygon(" +
           Members()
               .add("points", o.points, d.points)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("strength", o.strength, d.strength)
               .add("rounded", o.rounded, d.rounded)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::WheelOptions& o) {
    const shapes::WheelOptions d;
    return "shapes::wheel(" +
           Members()
               .add("radius", o.radius, d.radius)
               .add("segments", o.segments, d.segments)
               .add("mass", o.mass, d.mass)
               .add("rimRadius", o.rimRadius, d.rimRadius)
               .add("spokeStiffness", o.spokeStiffness, d.spokeStiffness)
               .add("spokeDamping", o.spokeDamping, d.spokeDamping)
               .add("strength", o.strength, d.strength)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::ChainOptions& o) {
    const shapes::ChainOptions d;
    return "shapes::chain(" +
           Members()
               .add("from", o.from, d.from)
               .add("to", o.to, d.to)
               .add("links", o.links, d.links)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("strength", o.strength, d.strength)
               .add("pinFirst", o.pinFirst, d.pinFirst)
               .add("pinLast", o.pinLast, d.pinLast)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::BridgeOptions& o) {
    const shapes::BridgeOptions d;
    return "shapes::bridge(" +
           Members()
               .add("from", o.from, d.from)
               .add("to", o.to, d.to)
               .add("planks", o.planks, d.planks)
               .add("sag", o.sag, d.sag)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("strength", o.strength, d.strength)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::ClothOptions& o) {
    const shapes::ClothOptions d;
    return "shapes::cloth(" +
           Members()
               .add("size", o.size, d.size)
               .add("columns", o.columns, d.columns)
               .add("rows", o.rows, d.rows)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("diagonals", o.diagonals, d.diagonals)
               .add("pinCorners", o.pinCorners, d.pinCorners)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("strength", o.strength, d.strength)
               .add("material", o.material, d.material)
               .done() +
           ")";
}
std::string callOf(const shapes::WallOptions& o) {
    const shapes::WallOptions d;
    return "shapes::wall(" +
           Members()
               .add("size", o.size, d.size)
               .add("columns", o.columns, d.columns)
               .add("rows", o.rows, d.rows)
               .add("mass", o.mass, d.mass)
               .add("radius", o.radius, d.radius)
               .add("stiffness", o.stiffness, d.stiffness)
               .add("damping", o.damping, d.damping)
               .add("strength", o.strength, d.strength)
               .add("pinBottom", o.pinBottom, d.pinBottom)
               .add("material", o.material, d.material)
               .done() +
           ")";
}

}  // namespace

// --- numbers and small things ----------------------------------------------------------------

std::string text(float value) {
    return shortest(value, std::isinf(value) ? "" : "f");
}
std::string text(double value) {
    return shortest(value, "");
}
std::string text(int value) {
    return std::to_string(value);
}
std::string text(std::uint32_t value) {
    return std::to_string(value) + "u";
}
std::string text(bool value) {
    return value ? "true" : "false";
}
std::string text(const std::string& value) {
    std::string all = "\"";
    for (const char c : value) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            all += '\\';
            all += c;
        } else if (byte < 32 || byte == 127 || c == '?') {  // '?' may begin a trigraph
            all += '\\';
            for (const int shift : {6, 3, 0}) all += static_cast<char>('0' + (byte >> shift & 7));
        } else {
            all += c;
        }
    }
    return all + "\"";
}
std::string text(const std::vector<Vec2>& points) {
    std::string all = "{";
    for (const Vec2& point : points) all += (all.size() > 1 ? ", " : "") + text(point);
    return all + "}";
}
std::string text(const std::vector<Real>& numbers) {
    std::string all = "{";
    for (const Real number : numbers) all += (all.size() > 1 ? ", " : "") + text(number);
    return all + "}";
}
std::string text(const Pose& value) {
    return "{" + text(value.position) + ", " + text(value.angle) + "}";
}
std::string text(BodyKind value) {
    return value == BodyKind::fixed       ? "BodyKind::fixed"
           : value == BodyKind::kinematic ? "BodyKind::kinematic"
                                          : "BodyKind::dynamic";
}
std::string text(Damper value) {
    return value == Damper::full ? "Damper::full" : "Damper::axial";
}
std::string text(Friction value) {
    return value == Friction::sliding ? "Friction::sliding" : "Friction::coulomb";
}

// --- structs ---------------------------------------------------------------------------------

std::string text(const Material& m) {
    const Material d;
    return Members()
        .add("staticFriction", m.staticFriction, d.staticFriction)
        .add("kineticFriction", m.kineticFriction, d.kineticFriction)
        .add("restitution", m.restitution, d.restitution)
        .add("surfaceSpeed", m.surfaceSpeed, d.surfaceSpeed)
        .add("rollingResistance", m.rollingResistance, d.rollingResistance)
        .done("Material");
}
std::string text(const Filter& f) {
    const Filter d;
    return Members()
        .add("category", f.category, d.category)
        .add("mask", f.mask, d.mask)
        .add("group", static_cast<int>(f.group), static_cast<int>(d.group))
        .done("Filter");
}
std::string text(const Drive& v) {
    const Drive d;
    return Members()
        .add("lower", v.lower, d.lower)
        .add("upper", v.upper, d.upper)
        .add("stiffness", v.stiffness, d.stiffness)
        .add("damping", v.damping, d.damping)
        .add("rest", v.rest, d.rest)
        .add("motorSpeed", v.motorSpeed, d.motorSpeed)
        .add("motorMax", v.motorMax, d.motorMax)
        .add("motorTarget", v.motorTarget, d.motorTarget)
        .add("strength", v.strength, d.strength)
        .done("Drive");
}
std::string text(const ConnectOptions& o) {
    const ConnectOptions d;
    return Members()
        .add("stiffness", o.stiffness, d.stiffness)
        .add("damping", o.damping, d.damping)
        .add("restLength", o.restLength, d.restLength)
        .add("radius", o.radius, d.radius)
        .add("strength", o.strength, d.strength)
        .add("material", o.material, d.material)
        .done();
}
std::string text(const HingeOptions& o) {
    const HingeOptions d;
    return Members()
        .add("drive", o.drive, d.drive)
        .add("collide", o.collide, d.collide)
        .add("pin", o.pin, d.pin)
        .add("strength", o.strength, d.strength)
        .add("value", o.value, d.value)
        .done();
}
std::string text(const SliderOptions& o) {
    const SliderOptions d;
    return Members()
        .add("drive", o.drive, d.drive)
        .add("collide", o.collide, d.collide)
        .add("turns", o.turns, d.turns)
        .add("value", o.value, d.value)
        .done();
}
std::string text(const WheelOptions& o) {
    const WheelOptions d;
    return Members()
        .add("spring", o.spring, d.spring)
        .add("motor", o.motor, d.motor)
        .add("collide", o.collide, d.collide)
        .done();
}
std::string text(const WeldOptions& o) {
    const WeldOptions d;
    return Members()
        .add("stiffness", o.stiffness, d.stiffness)
        .add("damping", o.damping, d.damping)
        .add("collide", o.collide, d.collide)
        .add("strength", o.strength, d.strength)
        .add("torqueStrength", o.torqueStrength, d.torqueStrength)
        .add("value", o.value, d.value)
        .done();
}
std::string text(const DistanceOptions& o) {
    const DistanceOptions d;
    return Members().add("drive", o.drive, d.drive).add("collide", o.collide, d.collide).done();
}
std::string text(const PulleyOptions& o) {
    const PulleyOptions d;
    return Members()
        .add("ratio", o.ratio, d.ratio)
        .add("length", o.length, d.length)
        .add("strength", o.strength, d.strength)
        .done();
}
std::string text(const WorldSettings& s) {
    const WorldSettings d;
    return Members()
        .add("gravity", s.gravity, d.gravity)
        .add("airFriction", s.airFriction, d.airFriction)
        .add("tickRate", s.tickRate, d.tickRate)
        .add("sleeping", s.sleeping, d.sleeping)
        .add("damper", s.damper, d.damper)
        .add("friction", s.friction, d.friction)
        .add("tellPersisting", s.tellPersisting, d.tellPersisting)
        .add("sweeps", s.sweeps, d.sweeps)
        .add("sleepSpeed", s.sleepSpeed, d.sleepSpeed)
        .add("reboundSpeed", s.reboundSpeed, d.reboundSpeed)
        .done();
}
std::string text(const ParticleSpec& p) {
    const ParticleSpec d;
    return Members()
        .add("position", p.position, d.position)
        .add("mass", p.mass, d.mass)
        .add("radius", p.radius, d.radius)
        .add("pinned", p.pinned, d.pinned)
        .done();
}
std::string text(const JointSpec& j) {
    const JointSpec d;
    return Members()
        .add("a", j.a, d.a)
        .add("b", j.b, d.b)
        .add("stiffness", j.stiffness, d.stiffness)
        .add("damping", j.damping, d.damping)
        .add("restLength", j.restLength, d.restLength)
        .add("radius", j.radius, d.radius)
        .add("strength", j.strength, d.strength)
        .add("material", j.material, d.material)
        .add("bend", j.bend, d.bend)
        .done();
}
std::string text(const AngularJointSpec& j) {
    const AngularJointSpec d;
    return Members()
        .add("a", j.a, d.a)
        .add("b", j.b, d.b)
        .add("c", j.c, d.c)
        .add("stiffness", j.stiffness, d.stiffness)
        .add("damping", j.damping, d.damping)
        .add("restAngle", j.restAngle, d.restAngle)
        .add("lower", j.lower, d.lower)
        .add("upper", j.upper, d.upper)
        .add("motorSpeed", j.motorSpeed, d.motorSpeed)
        .add("motorMax", j.motorMax, d.motorMax)
        .add("motorTarget", j.motorTarget, d.motorTarget)
        .add("strength", j.strength, d.strength)
        .done();
}
std::string text(const Field& field) {
    return std::visit([](const auto& one) { return fieldText(one); }, field);
}
std::string text(const scene::Generator& generator) {
    return std::visit([](const auto& options) { return callOf(options); }, generator);
}

}  // namespace sulfurchamber::cpp
