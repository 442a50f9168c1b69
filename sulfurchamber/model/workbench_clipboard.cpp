// Copies of what is selected, as text.
#include <algorithm>
#include <set>

#include "cpp_source.hpp"
#include "share_text.hpp"
#include "templates.hpp"
#include "tool.hpp"
#include "workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::World;

// Only the bodies that are wanted, with what connects them to each other.
sulfur::scene::Scene only(sulfur::scene::Scene scene, const std::set<std::string>& ids) {
    std::set<std::string> prefabs;
    std::erase_if(scene.bodies, [&](const auto& body) { return !ids.contains(body.id); });
    for (const auto& body : scene.bodies) prefabs.insert(body.blueprint);
    std::erase_if(scene.blueprints,
                  [&](const auto& p) { return !prefabs.contains(p.blueprint.name); });
    std::erase_if(scene.connections, [&](const auto& c) {
        return !ids.contains(c.a.body) || !ids.contains(c.b.body);
    });
    std::erase_if(scene.attachments, [&](const auto& a) {
        return !ids.contains(a.particle.body) || !ids.contains(a.body);
    });
    std::erase_if(scene.vetoes,
                  [&](const auto& v) { return !ids.contains(v.a) || !ids.contains(v.b); });
    sulfur::scene::removeMechanisms(scene.mechanisms,
                                    [&](const std::string& id) { return !ids.contains(id); });
    scene.fields.clear();
    auto thrusters = thrustersOf(scene);
    std::erase_if(thrusters, [&](const auto& thruster) { return !ids.contains(thruster.body); });
    // Instances take their templates along.
    std::erase_if(scene.extra, [](const auto& member) { return member.key != "templates"; });
    forgetUnusedDefinitions(scene);
    setThrusters(scene, thrusters);
    return scene;
}

sulfur::scene::Scene pastedScene(const std::string& text) {
    return isShareText(text) ? parseShareText(text) : sulfur::scene::parse(text, "the clipboard");
}

}  // namespace

std::string Workbench::copy() const {
    if (selection_.empty()) return {};
    auto [scene, bodies] = document_.captureForClipboard();
    std::set<std::string> ids;
    const auto chosen = document_.withPegs(selection_);
    for (std::size_t i = 0; i < bodies.size() && i < scene.bodies.size(); ++i)
        if (std::find(chosen.begin(), chosen.end(), bodies[i]) != chosen.end())
            ids.insert(scene.bodies[i].id);
    return sulfur::scene::format(only(std::move(scene), ids));
}

std::string Workbench::cppSource() const {
    if (selection_.empty()) return sulfurchamber::cppSource(document_.planScene());
    return sulfurchamber::cppSource(sulfur::scene::parse(copy(), "the selection"));
}

void Workbench::paste(const std::string& text, const Point& by) {
    auto scene = pastedScene(text);
    freshenGroups(scene, document_.scene());
    tool_->cancel();
    document_.edit("Paste", [&] { select(document_.insert(scene, by)); });
}

void Workbench::insertCopy() {
    auto scene = sulfur::scene::parse(copy(), "the selection");
    freshenGroups(scene, document_.scene());
    select(document_.insert(scene, {0, 0}));
}

void Workbench::pasteAt(const std::string& text, const Point& place) {
    const auto scene = pastedScene(text);
    World trial(scene.settings);
    sulfur::scene::instantiate(scene, trial);
    std::optional<Bounds> all;
    for (const BodyId body : trial.bodies()) {
        const auto bounds = trial.bounds(body);
        if (!all) all = Bounds{bounds.low, bounds.high};
        all->include(bounds.low);
        all->include(bounds.high);
    }
    paste(text, all ? Point(place - all->centre()) : Point(0, 0));
}

void Workbench::duplicate() {
    if (!things_.empty()) duplicateThings();
    if (const std::string text = copy(); !text.empty()) paste(text, {0.5, 0.5});
}

}  // namespace sulfurchamber
