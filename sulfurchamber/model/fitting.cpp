#include "fitting.hpp"

#include "words.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace sulfurchamber {
namespace {

using sulfur::Drive;
using sulfur::Vec2;
using sulfur::scene::Node;
using sulfur::scene::ReadError;
using sulfur::scene::Scene;
using sulfur::scene::SceneMechanism;

constexpr std::string_view devicesKey = "devices";

constexpr std::array<std::string_view, 30> keyNames{
    "Right", "Left", "Up", "Down", "A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K",
    "L",     "M",    "N",  "O",    "P", "Q", "R", "S", "T", "U", "V", "W", "X", "Y", "Z"};

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value));
    return {text.data(), end.ptr};
}

std::string pairText(const Vec2& v) {
    return "[" + numberText(static_cast<double>(v.x())) + ", " +
           numberText(static_cast<double>(v.y())) + "]";
}

std::string keysText(const DriveKeys& keys) {
    std::string text = R"({"forward": ")" + keys.forward + R"(", "back": ")" + keys.back + '"';
    if (keys.brake > 0) text += ", \"brake\": " + numberText(keys.brake);
    return text + "}";
}

// A name may hold what JSON escapes.
std::string quotedText(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"";
}

DriveKeys readKeys(const Node& node) {
    node.requireObject();
    DriveKeys keys;
    const auto read = [&](std::string_view member, std::string& into) {
        const auto key = node.find(member);
        if (!key) return;
        into = key->string(0, 8);
        if (!into.empty() && !isControlKey(into))
            key->fail(tr("is “{}”; allowed is a letter, Right, Left, Up, Down or “”", {into}));
    };
    read("forward", keys.forward);
    read("back", keys.back);
    if (const auto brake = node.find("brake")) keys.brake = brake->number(0, 1);
    return keys;
}

Thruster readThruster(const Node& node, const Scene& scene) {
    Thruster made;
    const Node body = node.at("body");
    made.body = body.string(1, sulfur::scene::Limits::nameBytes);
    if (scene.body(made.body) == nullptr)
        body.fail(tr("is “{}”; allowed is the id of a body of the scene", {made.body}));
    made.at = node.at("at").vec2(DeviceLimits::at);
    made.force = node.at("force").vec2(DeviceLimits::force);
    if (const auto keys = node.find("keys")) made.keys = readKeys(*keys);
    return made;
}

bool isThruster(const Node& node) {
    node.requireObject();
    return node.at("type").string(1, 100) == "thruster";
}

std::string textOfThruster(const Thruster& thruster) {
    std::string text = R"({"type": "thruster", "body": )" + quotedText(thruster.body) +
                       ", \"at\": " + pairText(thruster.at) +
                       ", \"force\": " + pairText(thruster.force);
    if (thruster.keys.any()) text += ", \"keys\": " + keysText(thruster.keys);
    return text + "}";
}

std::string_view nameOf(const SceneMechanism& mechanism) {
    using namespace sulfur::scene;
    const Drive* drive = driveOf(mechanism);
    const bool motor = drive != nullptr && drive->motorMax > 0;
    if (std::holds_alternative<Hinge>(mechanism.spec)) return motor ? "Motor" : "Hinge";
    if (std::holds_alternative<Weld>(mechanism.spec)) return "Weld";
    if (std::holds_alternative<Slider>(mechanism.spec)) return "Slider";
    if (std::holds_alternative<Wheel>(mechanism.spec)) return "Axle";
    if (std::holds_alternative<Pulley>(mechanism.spec)) return "Pulley";
    if (std::holds_alternative<Gear>(mechanism.spec)) return "Gear";
    if (motor) return "Winch";
    return drive->stiffness > 0 ? "Spring" : "Cable";
}

}  // namespace

std::span<const std::string_view> controlKeys() {
    return keyNames;
}

bool isControlKey(std::string_view name) {
    return std::find(keyNames.begin(), keyNames.end(), name) != keyNames.end();
}

std::vector<Thruster> thrustersOf(const Scene& scene) {
    std::vector<Thruster> found;
    if (sulfur::scene::findExtra(scene.extra, devicesKey) == nullptr) return found;
    const auto section = scene.section(devicesKey);
    for (const Node& node : section->root().array(0, DeviceLimits::devices))
        if (isThruster(node)) found.push_back(readThruster(node, scene));
    return found;
}

void setThrusters(Scene& scene, const std::vector<Thruster>& thrusters) {
    std::vector<std::string> texts;
    for (const Thruster& one : thrusters) texts.push_back(textOfThruster(one));
    if (sulfur::scene::findExtra(scene.extra, devicesKey) != nullptr) {
        const auto section = scene.section(devicesKey);
        for (const Node& node : section->root().array(0, DeviceLimits::devices))
            if (!isThruster(node)) texts.emplace_back(node.text());
    }
    if (texts.empty()) {
        sulfur::scene::eraseExtra(scene.extra, devicesKey);
        return;
    }
    std::string all = "[";
    for (const std::string& text : texts) all += (all.size() > 1 ? ", " : "") + text;
    sulfur::scene::setExtra(scene.extra, devicesKey, all + "]");
}

DriveKeys keysOf(const SceneMechanism& mechanism) {
    const auto own = mechanism.extra.find("");
    if (own == mechanism.extra.end()) return {};
    const auto* member = sulfur::scene::findExtra(own->second, "keys");
    if (member == nullptr) return {};
    try {
        return readKeys(sulfur::scene::Document::parse(
                            member->json, {.file = "keys", .firstLine = 1, .object = {}})
                            .root());
    } catch (const ReadError&) {
        return {};
    }
}

void setKeys(SceneMechanism& mechanism, const DriveKeys& keys) {
    auto& extra = mechanism.extra[""];
    if (keys.any() || keys.brake > 0)
        sulfur::scene::setExtra(extra, "keys", keysText(keys));
    else
        sulfur::scene::eraseExtra(extra, "keys");
}

const Drive* driveOf(const SceneMechanism& mechanism) {
    return std::visit(
        [](const auto& spec) -> const Drive* {
            if constexpr (requires { spec.options.drive; }) return &spec.options.drive;
            if constexpr (requires { spec.options.motor; }) return &spec.options.motor;
            return nullptr;
        },
        mechanism.spec);
}

Drive* driveOf(SceneMechanism& mechanism) {
    return const_cast<Drive*>(driveOf(std::as_const(mechanism)));
}

std::string_view kindName(const Fitting& fitting) {
    if (const auto* mechanism = std::get_if<SceneMechanism>(&fitting)) return nameOf(*mechanism);
    if (std::holds_alternative<Thruster>(fitting)) return "Thruster";
    if (std::holds_alternative<ParticlePart>(fitting)) return "Particle";
    if (std::holds_alternative<JointPart>(fitting)) return "Joint";
    const auto& field = std::get<sulfur::scene::SceneField>(fitting).field;
    if (std::holds_alternative<sulfur::WindField>(field)) return "Wind";
    return std::holds_alternative<sulfur::UniformField>(field) ? "Gravity zone" : "Attraction";
}

}  // namespace sulfurchamber
