#include "templates.hpp"
#include "words.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Pose;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::scene::Placement;
using sulfur::scene::Scene;
using sulfur::scene::SceneMechanism;

constexpr const char* memberKey = "template";        // of bodies, mechanisms, template files
constexpr const char* definitionsKey = "templates";  // of scenes
constexpr const char* otherCategory = "Other";

sulfur::scene::Document jsonOf(const sulfur::scene::ExtraMember& member) {
    return sulfur::scene::Document::parse(
        member.json, {.file = "the scene", .firstLine = member.line, .object = member.key});
}

// The members of "templates" as they are written.
std::vector<std::pair<std::string, std::string>> definitionTexts(const Scene& scene) {
    std::vector<std::pair<std::string, std::string>> texts;
    const auto* member = sulfur::scene::findExtra(scene.extra, definitionsKey);
    if (member == nullptr) return texts;
    try {
        const auto json = jsonOf(*member);
        for (const auto& one : json.root().members())
            texts.emplace_back(one.key(), std::string(one.text()));
    } catch (const sulfur::scene::ReadError&) {
        texts.clear();  // another program's
    }
    return texts;
}

void setDefinitionTexts(Scene& scene,
                        const std::vector<std::pair<std::string, std::string>>& texts) {
    if (texts.empty()) {
        sulfur::scene::eraseExtra(scene.extra, definitionsKey);
        return;
    }
    std::string json = "{";
    for (const auto& [name, text] : texts)
        json += (json.size() > 1 ? ",\n" : "\n") + jsonString(name) + ": " + text;
    sulfur::scene::setExtra(scene.extra, definitionsKey, json + "\n}");
}

Point placeOf(const Scene& scene, const sulfur::scene::ParticleRef& ref) {
    const Placement& body = *scene.body(ref.body);
    if (body.state) return body.state->positions.at(ref.particle);
    const auto& particle = scene.prefab(body.blueprint)->blueprint.particles.at(ref.particle);
    return body.pose.position +
           Eigen::Rotation2Dd(body.pose.angle) * particle.position.cast<double>();
}

// Joints between bodies are as long as they are at the start, in each instance alike.
void measureConnections(Scene& scene) {
    for (auto& connection : scene.connections)
        if (!connection.options.restLength)
            connection.options.restLength = static_cast<Real>(
                (placeOf(scene, connection.a) - placeOf(scene, connection.b)).norm());
}

}  // namespace

std::string jsonString(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') json += '\\';
        if (static_cast<unsigned char>(c) >= 0x20)
            json += c;
        else
            json += c == '\n' ? "\\n" : " ";
    }
    return json + '"';
}

// --- template files --------------------------------------------------------------------------

Template readTemplate(Scene scene) {
    if (scene.title.empty()) throw std::runtime_error("a template needs a title as its name");
    if (scene.bodies.empty())
        throw std::runtime_error(tr("the template \"{}\" has no bodies", {scene.title}));
    Template made{otherCategory, std::move(scene)};
    if (const auto section = made.scene.section(memberKey))
        if (const auto category = section->root().find("category"))
            made.category = category->string(1, sulfur::scene::Limits::nameBytes);
    nameMechanisms(made.scene);
    measureConnections(made.scene);
    return made;
}

std::string textOf(const Template& made) {
    Scene scene = made.scene;
    sulfur::scene::setExtra(scene.extra, memberKey,
                            "{\"category\": " + jsonString(made.category) + "}");
    return sulfur::scene::format(scene);
}

Bounds boundsOf(const Scene& scene) {
    sulfur::World trial(scene.settings);
    sulfur::scene::instantiate(scene, trial);
    std::optional<Bounds> all;
    for (const sulfur::BodyId body : trial.bodies()) {
        const auto bounds = trial.bounds(body);
        if (!all) all = Bounds{bounds.low, bounds.high};
        all->include(bounds.low);
        all->include(bounds.high);
    }
    return all.value_or(Bounds{});
}

void moveScene(Scene& scene, const Point& by) {
    const Pose frame{.position = by, .angle = 0};
    for (Placement& body : scene.bodies) carry(body, frame);
    for (SceneMechanism& mechanism : scene.mechanisms) carry(mechanism, frame);
}

// --- membership ------------------------------------------------------------------------------

std::optional<Membership> membershipOf(const Placement& body) {
    const auto own = body.extra.find("");
    if (own == body.extra.end()) return std::nullopt;
    const auto* member = sulfur::scene::findExtra(own->second, memberKey);
    if (member == nullptr) return std::nullopt;
    try {
        const auto json = jsonOf(*member);
        constexpr std::size_t most = sulfur::scene::Limits::nameBytes;
        return Membership{json.root().at("name").string(1, most),
                          json.root().at("instance").string(1, most),
                          json.root().at("part").string(1, most)};
    } catch (const sulfur::scene::ReadError&) {
        return std::nullopt;
    }
}

void setMembership(Placement& body, const Membership& membership) {
    sulfur::scene::setExtra(body.extra[""], memberKey,
                            "{\"name\": " + jsonString(membership.name) +
                                ", \"instance\": " + jsonString(membership.instance) +
                                ", \"part\": " + jsonString(membership.part) + "}");
}

void clearMembership(Placement& body) {
    if (const auto own = body.extra.find(""); own != body.extra.end())
        sulfur::scene::eraseExtra(own->second, memberKey);
}

std::vector<Instance> instancesOf(const Scene& scene) {
    std::vector<Instance> instances;
    std::map<std::string, std::size_t> places;
    for (const Placement& body : scene.bodies) {
        const auto membership = membershipOf(body);
        if (!membership) continue;
        const auto [found, isNew] = places.emplace(membership->instance, instances.size());
        if (isNew) instances.push_back({membership->name, membership->instance, {}});
        instances[found->second].ids.emplace(membership->part, body.id);
    }
    return instances;
}

std::string freeInstance(const Scene& scene, const std::string& name) {
    std::set<std::string> taken;
    for (const Instance& one : instancesOf(scene)) taken.insert(one.instance);
    std::string free = name;
    for (int n = 2; taken.contains(free); ++n) free = name + " " + std::to_string(n);
    return free;
}

// --- definitions -----------------------------------------------------------------------------

std::optional<Template> definition(const Scene& scene, const std::string& name) {
    for (const auto& [key, text] : definitionTexts(scene)) {
        if (key != name) continue;
        try {
            return readTemplate(sulfur::scene::parse(text, tr("the template \"{}\"", {name})));
        } catch (const std::exception&) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

std::vector<std::string> definitions(const Scene& scene) {
    std::vector<std::string> names;
    for (const auto& [key, text] : definitionTexts(scene)) names.push_back(key);
    return names;
}

void define(Scene& scene, const Template& made) {
    auto texts = definitionTexts(scene);
    const auto found = std::find_if(texts.begin(), texts.end(),
                                    [&](const auto& one) { return one.first == made.name(); });
    if (found == texts.end())
        texts.emplace_back(made.name(), textOf(made));
    else
        found->second = textOf(made);
    setDefinitionTexts(scene, texts);
}

void forgetUnusedDefinitions(Scene& scene) {
    std::set<std::string> used;
    for (const Instance& one : instancesOf(scene)) used.insert(one.name);
    auto texts = definitionTexts(scene);
    if (std::erase_if(texts, [&](const auto& one) { return !used.contains(one.first); }) > 0)
        setDefinitionTexts(scene, texts);
}

void takeDefinitions(Scene& into, const Scene& from) {
    auto texts = definitionTexts(into);
    const std::size_t before = texts.size();
    for (auto& one : definitionTexts(from))
        if (std::none_of(texts.begin(), texts.end(),
                         [&](const auto& known) { return known.first == one.first; }))
            texts.push_back(std::move(one));
    if (texts.size() != before) setDefinitionTexts(into, texts);
}

// --- mechanisms ------------------------------------------------------------------------------

void nameMechanisms(Scene& scene) {
    std::set<std::string> taken;
    for (const auto& mechanism : scene.mechanisms) taken.insert(mechanism.id);
    int number = 1;
    for (auto& mechanism : scene.mechanisms) {
        if (!mechanism.id.empty()) continue;
        do mechanism.id = "tie" + std::to_string(number++);
        while (!taken.insert(mechanism.id).second);
    }
}

std::string partOf(const SceneMechanism& mechanism) {
    const auto own = mechanism.extra.find("");
    if (own == mechanism.extra.end()) return mechanism.id;
    const auto* member = sulfur::scene::findExtra(own->second, memberKey);
    if (member == nullptr) return mechanism.id;
    try {
        return jsonOf(*member).root().string(1, sulfur::scene::Limits::nameBytes);
    } catch (const sulfur::scene::ReadError&) {
        return mechanism.id;
    }
}

void setPart(SceneMechanism& mechanism, const std::string& part) {
    if (!part.empty())
        sulfur::scene::setExtra(mechanism.extra[""], memberKey, jsonString(part));
    else if (const auto own = mechanism.extra.find(""); own != mechanism.extra.end())
        sulfur::scene::eraseExtra(own->second, memberKey);
}

// --- frames ----------------------------------------------------------------------------------

Pose composed(const Pose& frame, const Pose& local) {
    return {.position = frame.position + Eigen::Rotation2Dd(frame.angle) * local.position,
            .angle = frame.angle + local.angle};
}

Pose inverse(const Pose& frame) {
    return {.position = -(Eigen::Rotation2Dd(-frame.angle) * frame.position),
            .angle = -frame.angle};
}

void carry(Placement& body, const Pose& frame) {
    body.pose = composed(frame, body.pose);
    if (frame.angle == 0) {
        if (body.state)
            for (Point& place : body.state->positions) place += frame.position;
        return;
    }
    body.pose.angle = std::remainder(body.pose.angle, 2 * std::numbers::pi);
    const Eigen::Rotation2Dd turned(frame.angle);
    const auto turn = [&](Vec2& v) { v = (turned * v.cast<double>()).cast<Real>(); };
    turn(body.velocity);
    if (!body.state) return;
    for (Point& place : body.state->positions) place = frame.position + turned * place;
    for (Vec2& velocity : body.state->velocities) turn(velocity);
    if (auto& angle = body.state->angle)
        angle = std::remainder(*angle + frame.angle, 2 * std::numbers::pi);
}

void carry(SceneMechanism& mechanism, const Pose& frame) {
    const Eigen::Rotation2Dd turned(frame.angle);
    std::set<std::string> bodies;
    for (const std::string* name : bodiesOf(mechanism)) bodies.insert(*name);
    for (const std::string& body : bodies)
        for (Point* point : pointsOf(mechanism, body)) *point = frame.position + turned * *point;
    if (frame.angle == 0) return;
    std::visit(
        [&](auto& spec) {
            if constexpr (requires { spec.axis; })
                spec.axis = (turned * spec.axis.template cast<double>()).template cast<Real>();
        },
        mechanism.spec);
}

}  // namespace sulfurchamber
