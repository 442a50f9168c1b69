#include <algorithm>
#include <cmath>
#include <utility>

#include "placing.hpp"

namespace sulfur::scene {

namespace {

void note(std::vector<std::string>& notes, const std::string& file, const std::string& object,
          const ExtraTree& tree) {
    for (const auto& [path, members] : tree) {
        for (const auto& member : members) {
            const std::string where = path.empty() ? "" : path + ": ";
            notes.push_back(ReadError(file, member.line, object,
                                      where + "unknown key \"" + member.key +
                                          "\"; it is kept but means nothing here")
                                .what());
        }
    }
}

template <class IsTaken>
std::string firstFree(const std::string& base, IsTaken isTaken) {
    if (!isTaken(base)) return base;
    for (int n = 2;; ++n) {
        const std::string name = base + std::to_string(n);
        if (!isTaken(name)) return name;
    }
}

}  // namespace

const Prefab* Scene::prefab(std::string_view name) const {
    const auto found = std::find_if(blueprints.begin(), blueprints.end(),
                                    [&](const Prefab& p) { return p.blueprint.name == name; });
    return found == blueprints.end() ? nullptr : &*found;
}

Prefab* Scene::prefab(std::string_view name) {
    return const_cast<Prefab*>(std::as_const(*this).prefab(name));
}

const Placement* Scene::body(std::string_view id) const {
    const auto found =
        std::find_if(bodies.begin(), bodies.end(), [&](const Placement& b) { return b.id == id; });
    return found == bodies.end() ? nullptr : &*found;
}

Placement* Scene::body(std::string_view id) {
    return const_cast<Placement*>(std::as_const(*this).body(id));
}

std::string Scene::freeId(const std::string& base) const {
    return firstFree(base, [this](const std::string& id) { return body(id) != nullptr; });
}

std::string Scene::freeName(const std::string& base) const {
    return firstFree(base, [this](const std::string& name) { return prefab(name) != nullptr; });
}

std::optional<Document> Scene::section(std::string_view key) const {
    const auto* member = findExtra(extra, key);
    if (member == nullptr) return std::nullopt;
    return Document::parse(
        member->json,
        {.file = file, .firstLine = std::max(member->line, 1), .object = member->key});
}

Blueprint blueprintOf(const Scene& scene, const Placement& body) {
    const auto* prefab = scene.prefab(body.blueprint);
    if (prefab == nullptr)
        throw ReadError(scene.file, 0, body.id,
                        "blueprint \"" + body.blueprint + "\" is not among the scene's blueprints");
    Blueprint plan = prefab->blueprint;
    if (body.kind) plan.kind = *body.kind;
    if (body.material) plan.material = *body.material;
    if (body.filter) plan.filter = *body.filter;
    if (body.sensor) plan.sensor = *body.sensor;
    return plan;
}

std::vector<std::string> unknownKeys(const Scene& scene) {
    std::vector<std::string> notes;
    note(notes, scene.file, "world", {{"", scene.settingsExtra}});
    for (const auto& prefab : scene.blueprints)
        note(notes, scene.file, prefab.blueprint.name, prefab.extra);
    for (const auto& body : scene.bodies) note(notes, scene.file, body.id, body.extra);
    for (std::size_t i = 0; i < scene.connections.size(); ++i)
        note(notes, scene.file, "connections[" + std::to_string(i) + ']',
             scene.connections[i].extra);
    for (std::size_t i = 0; i < scene.attachments.size(); ++i)
        note(notes, scene.file, "attachments[" + std::to_string(i) + ']',
             {{"", scene.attachments[i].extra}});
    for (std::size_t i = 0; i < scene.fields.size(); ++i)
        note(notes, scene.file, "fields[" + std::to_string(i) + ']', scene.fields[i].extra);
    for (std::size_t i = 0; i < scene.mechanisms.size(); ++i)
        note(notes, scene.file, "mechanisms[" + std::to_string(i) + ']', scene.mechanisms[i].extra);
    return notes;
}

std::vector<Point> placed(const Blueprint& blueprint, const Pose& pose) {
    const double c = std::cos(pose.angle);
    const double s = std::sin(pose.angle);
    std::vector<Point> result;
    result.reserve(blueprint.particles.size());
    for (const auto& particle : blueprint.particles) {
        const Point local = particle.position.cast<double>();
        result.push_back(pose.position +
                         Point(c * local.x() - s * local.y(), s * local.x() + c * local.y()));
    }
    return result;
}

}  // namespace sulfur::scene
