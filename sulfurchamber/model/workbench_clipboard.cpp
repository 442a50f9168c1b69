// Copies of what is selected, as text: bodies and things of a level.
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "cpp_source.hpp"
#include "level_clipboard.hpp"
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

// A member of the clipboard's scene, as of a level's.
constexpr const char* levelMember = "level";

sulfur::scene::Scene pastedScene(const std::string& text) {
    return isShareText(text) ? parseShareText(text) : sulfur::scene::parse(text, "the clipboard");
}

}  // namespace

// Those that are selected, and those that selected things are about.
std::vector<BodyId> Workbench::chosenBodies() const {
    std::vector<BodyId> bodies = selection_;
    for (const LevelThing& thing : things_)
        if (infoOf(thing.kind).ofBody && isCopyable(document_, thing))
            bodies.push_back(document_.bodyOf(bodyOf(document_, thing)));
    return document_.withPegs(bodies);
}

bool Workbench::canCopy() const {
    return !selection_.empty() ||
           std::any_of(things_.begin(), things_.end(),
                       [&](const LevelThing& thing) { return isCopyable(document_, thing); });
}

std::string Workbench::copy() const {
    if (!canCopy()) return {};
    auto [scene, bodies] = document_.captureForClipboard();
    std::set<std::string> ids;
    std::map<std::string, std::string> names;  // in the document and in the copy
    const auto chosen = chosenBodies();
    for (std::size_t i = 0; i < bodies.size() && i < scene.bodies.size(); ++i) {
        if (std::find(chosen.begin(), chosen.end(), bodies[i]) == chosen.end()) continue;
        ids.insert(scene.bodies[i].id);
        names.emplace(document_.idOf(bodies[i]), scene.bodies[i].id);
    }
    scene = only(std::move(scene), ids);
    if (isLevel(document_))
        if (std::string part = levelPart(document_, things_, names); !part.empty())
            sulfur::scene::setExtra(scene.extra, levelMember, std::move(part));
    return sulfur::scene::format(scene);
}

std::string Workbench::cut() {
    std::string text = copy();
    if (text.empty()) return text;
    tool_->cancel();
    const auto things = things_;
    const auto bodies = chosenBodies();
    select({});
    document_.edit("Cut to the clipboard", [&] {
        if (!things.empty()) removeThings(document_, things);
        document_.remove(bodies);
    });
    return text;
}

std::string Workbench::cppSource() const {
    if (selection_.empty()) return sulfurchamber::cppSource(document_.planScene());
    return sulfurchamber::cppSource(sulfur::scene::parse(copy(), "the selection"));
}

void Workbench::insertScene(const sulfur::scene::Scene& scene, const Point& by) {
    std::vector<BodyId> bodies = document_.insert(scene, by);
    std::vector<LevelThing> things;
    const auto* level = sulfur::scene::findExtra(scene.extra, levelMember);
    if (level != nullptr && isLevel(document_)) {
        std::map<std::string, std::string> names;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            names.emplace(scene.bodies[i].id, document_.idOf(bodies[i]));
        things = addPart(document_, level->json, by, names);
    }
    if (bodies.empty())
        selectThings(std::move(things));
    else
        select(std::move(bodies));
}

void Workbench::pasteAs(const char* name, const std::string& text, const Point& by) {
    auto scene = pastedScene(text);
    if (scene.bodies.empty() && !isLevel(document_) &&
        sulfur::scene::findExtra(scene.extra, levelMember) != nullptr)
        throw std::runtime_error("this scene is no level yet; \"Make a level of this scene\" does");
    freshenGroups(scene, document_.scene());
    tool_->cancel();
    document_.edit(name, [&] { insertScene(scene, by); });
}

void Workbench::paste(const std::string& text, const Point& by) {
    pasteAs("Paste", text, by);
}

void Workbench::insertCopy() {
    auto scene = sulfur::scene::parse(copy(), "the selection");
    freshenGroups(scene, document_.scene());
    insertScene(scene, {0, 0});
}

void Workbench::pasteAt(const std::string& text, const Point& place) {
    const auto scene = pastedScene(text);
    World trial(scene.settings);
    sulfur::scene::instantiate(scene, trial);
    const auto* level = sulfur::scene::findExtra(scene.extra, levelMember);
    std::optional<Bounds> all = level == nullptr ? std::nullopt : boundsOfPart(level->json);
    for (const BodyId body : trial.bodies()) {
        const auto bounds = trial.bounds(body);
        if (!all) all = Bounds{bounds.low, bounds.high};
        all->include(bounds.low);
        all->include(bounds.high);
    }
    paste(text, all ? Point(place - all->centre()) : Point(0, 0));
}

void Workbench::duplicate() {
    if (const std::string text = copy(); !text.empty()) pasteAs("Duplicate", text, {0.5, 0.5});
}

}  // namespace sulfurchamber
