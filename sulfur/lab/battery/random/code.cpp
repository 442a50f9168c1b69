// A scene as C++.
#include <array>
#include <charconv>

#include "battery/random/scene.hpp"

namespace sulfur::lab {

namespace {

constexpr std::array<const char*, kindCount> kinds{
    "ball", "crate",       "plank", "polygon", "hook", "wheel", "springWheel", "rod",
    "rope", "elasticRope", "chain", "jelly",   "blob", "wall",  "cloth"};
constexpr std::array<const char*, 3> roles{"free", "driven", "sensor"};
constexpr std::array<const char*, 4> ties{"rod", "spring", "attachment", "grab"};
constexpr std::array<const char*, 3> influences{"uniform", "radial", "wind"};

/// The shortest number that reads back as the same.
std::string number(double x) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
    return {text.data(), end};
}
std::string number(const Eigen::Vector2d& v) {
    return "{" + number(v.x()) + ", " + number(v.y()) + "}";
}

/// The members that are not as they are by default.
class Members {
public:
    template <class Value, class Text>
    void add(const char* name, const Value& value, const Value& usual, const Text& text) {
        if (value == usual) return;
        out_ += (out_.empty() ? "." : ", .") + std::string(name) + " = " + std::string(text);
    }
    void add(const char* name, double value, double usual) {
        add(name, value, usual, number(value));
    }
    const std::string& text() const { return out_; }

private:
    std::string out_;
};

template <class Enum, std::size_t size>
std::string value(const char* type, Enum e, const std::array<const char*, size>& all) {
    return std::string(type) + "::" + all[static_cast<std::size_t>(e)];
}

std::string textOf(const Thing& t) {
    const Thing usual;
    Members m;
    m.add("kind", t.kind, static_cast<Kind>(kindCount), value("Kind", t.kind, kinds));
    m.add("role", t.role, usual.role, value("Role", t.role, roles));
    m.add("size", t.size, usual.size);
    m.add("mass", t.mass, usual.mass);
    m.add("variant", t.variant, usual.variant);
    m.add("frequency", t.frequency, usual.frequency);
    m.add("friction", t.friction, usual.friction);
    m.add("restitution", t.restitution, usual.restitution);
    m.add("strength", t.strength, usual.strength);
    m.add("place", t.place, usual.place, number(t.place));
    m.add("angle", t.angle, usual.angle);
    m.add("velocity", t.velocity, usual.velocity, number(t.velocity));
    m.add("spin", t.spin, usual.spin);
    return "{" + m.text() + "}";
}

std::string textOf(const Tie& t) {
    const Tie usual;
    Members m;
    m.add("kind", t.kind, static_cast<Tie::Kind>(9), value("Tie::Kind", t.kind, ties));
    m.add("a", t.a, usual.a, std::to_string(t.a));
    m.add("b", t.b, usual.b, std::to_string(t.b));
    m.add("alongA", t.alongA, usual.alongA);
    m.add("alongB", t.alongB, usual.alongB);
    m.add("frequency", t.frequency, usual.frequency);
    return "{" + m.text() + "}";
}

std::string textOf(const Influence& i) {
    Members m;
    m.add("kind", i.kind, static_cast<Influence::Kind>(9),
          value("Influence::Kind", i.kind, influences));
    m.add("strength", i.strength, Influence{}.strength);
    m.add("angle", i.angle, Influence{}.angle);
    return "{" + m.text() + "}";
}

template <class Parts>
std::string listOf(const char* name, const Parts& parts) {
    if (parts.empty()) return "";
    std::string out = std::string(", .") + name + " = {\n";
    for (const auto& part : parts) out += "        " + textOf(part) + ",\n";
    return out + "    }";
}

}  // namespace

std::string asCode(const Scene& s) {
    const Scene usual;
    Members m;
    m.add("rate", s.rate, -1, std::to_string(s.rate));
    m.add("ticks", s.ticks, -1, std::to_string(s.ticks));
    m.add("sleeping", s.sleeping, usual.sleeping, s.sleeping ? "true" : "false");
    m.add("calm", s.calm, usual.calm);
    m.add("gravity", s.gravity, usual.gravity);
    m.add("airFriction", s.airFriction, usual.airFriction);
    m.add("room", s.room, usual.room);
    m.add("restsAfter", s.restsAfter, usual.restsAfter);
    m.add("contacts", s.contacts, usual.contacts, s.contacts ? "true" : "false");
    return "Scene{" + m.text() + listOf("things", s.things) + listOf("ties", s.ties) +
           listOf("influences", s.influences) + "};\n";
}

}  // namespace sulfur::lab
