#include "arrange.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "words.hpp"
#include "workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::scene::Placement;

constexpr std::size_t longestGroup = 400;  // bytes of all names together
constexpr int outmostOrder = 1'000'000;

// A member as a value; nothing where it is none.
template <class Value, class Read>
std::optional<Value> memberOf(const Placement& body, std::string_view key, const Read& read) {
    const auto own = body.extra.find("");
    if (own == body.extra.end()) return std::nullopt;
    const auto* member = sulfur::scene::findExtra(own->second, key);
    if (member == nullptr) return std::nullopt;
    try {
        return read(sulfur::scene::Document::parse(member->json, {}).root());
    } catch (const sulfur::scene::ReadError&) {
        return std::nullopt;
    }
}

bool isMarked(const Placement& body, std::string_view key) {
    return memberOf<bool>(body, key, [](const auto& node) { return node.boolean(); })
        .value_or(false);
}

void setMember(Placement& body, std::string_view key, const std::string& json) {
    auto& extra = body.extra[""];
    if (json.empty())
        sulfur::scene::eraseExtra(extra, key);
    else
        sulfur::scene::setExtra(extra, key, json);
    if (extra.empty()) body.extra.erase("");
}

bool isGroupName(const std::string& name) {
    return !name.empty() && name.size() <= sulfur::scene::Limits::nameBytes &&
           name.find_first_of("/\n\t\"\\") == std::string::npos;
}

std::string withoutOutermost(const std::string& group) {
    const auto slash = group.find('/');
    return slash == std::string::npos ? "" : group.substr(slash + 1);
}

std::set<std::string> outermostGroups(const sulfur::scene::Scene& scene) {
    std::set<std::string> names;
    for (const Placement& body : scene.bodies)
        if (std::string name = outermost(marksOf(body).group); !name.empty())
            names.insert(std::move(name));
    return names;
}

std::string freshName(const std::set<std::string>& taken) {
    for (int n = 1;; ++n)
        if (std::string name = "group " + std::to_string(n); !taken.contains(name)) return name;
}

// Changes the marks of bodies of the plan, in the open edit.
void changeMarks(Document& document, std::span<const BodyId> bodies,
                 const std::function<void(BodyMarks&)>& change) {
    for (const BodyId body : bodies) {
        const std::string id = document.idOf(body);
        if (id.empty()) continue;
        Placement& placement = document.placementForEditing(id);
        BodyMarks marks = marksOf(placement);
        change(marks);
        setMarks(placement, marks);
    }
}

void markAsStep(Workbench& bench, const char* label, std::span<const BodyId> bodies,
                const std::function<void(BodyMarks&)>& change) {
    bench.cancel();
    const std::vector<BodyId> kept(bodies.begin(), bodies.end());
    bench.document().edit(label, [&] { changeMarks(bench.document(), kept, change); });
}

std::vector<BodyId> allBodies(const Workbench& bench) {
    const auto bodies = bench.document().world().bodies();
    return {bodies.begin(), bodies.end()};
}

// What moves as a whole: a body, or a group, with the rectangle around it.
struct Unit {
    std::vector<BodyId> bodies;
    Bounds bounds;
};

std::vector<Unit> unitsOf(const Workbench& bench) {
    std::vector<Unit> units;
    std::map<std::string, std::size_t> places;
    for (const BodyId body : bench.selection()) {
        const auto around = bench.document().world().bounds(body);
        const Bounds own{around.low, around.high};
        const std::string group = outermost(bench.marks(body).group);
        const auto known = group.empty() ? places.end() : places.find(group);
        if (known != places.end()) {
            Unit& unit = units[known->second];
            unit.bodies.push_back(body);
            unit.bounds.include(own.low);
            unit.bounds.include(own.high);
            continue;
        }
        if (!group.empty()) places.emplace(group, units.size());
        units.push_back({{body}, own});
    }
    return units;
}

Point wayToAlign(const Bounds& own, const Bounds& all, Alignment alignment) {
    switch (alignment) {
        case Alignment::left:
            return {all.low.x() - own.low.x(), 0};
        case Alignment::centre:
            return {all.centre().x() - own.centre().x(), 0};
        case Alignment::right:
            return {all.high.x() - own.high.x(), 0};
        case Alignment::top:
            return {0, all.high.y() - own.high.y()};
        case Alignment::middle:
            return {0, all.centre().y() - own.centre().y()};
        case Alignment::bottom:
            break;
    }
    return {0, all.low.y() - own.low.y()};
}

}  // namespace

// --- marks -----------------------------------------------------------------------------------

BodyMarks marksOf(const Placement& body) {
    BodyMarks marks;
    if (!body.extra.contains("")) return marks;
    marks.group = memberOf<std::string>(body, "group", [](const auto& node) {
                      return node.string(1, longestGroup);
                  }).value_or("");
    marks.locked = isMarked(body, "locked");
    marks.hidden = isMarked(body, "hidden");
    marks.order = memberOf<int>(body, "order", [](const auto& node) {
                      return static_cast<int>(node.integer(-outmostOrder, outmostOrder));
                  }).value_or(0);
    return marks;
}

void setMarks(Placement& body, const BodyMarks& marks) {
    setMember(body, "group", marks.group.empty() ? "" : '"' + marks.group + '"');
    setMember(body, "locked", marks.locked ? "true" : "");
    setMember(body, "hidden", marks.hidden ? "true" : "");
    setMember(body, "order", marks.order == 0 ? "" : std::to_string(marks.order));
}

std::string outermost(const std::string& group) {
    return group.substr(0, group.find('/'));
}

const BodyMarks& MarkBook::of(const Document& document, BodyId body) {
    if (revision_ != document.revision()) marks_.clear();
    revision_ = document.revision();
    const auto [found, isNew] = marks_.try_emplace(body);
    if (isNew)
        if (const std::string id = document.idOf(body); !id.empty())
            found->second = marksOf(document.plan().body(id));
    return found->second;
}

void freshenGroups(sulfur::scene::Scene& inserted, const sulfur::scene::Scene& into) {
    auto taken = outermostGroups(into);
    std::map<std::string, std::string> names;
    for (Placement& body : inserted.bodies) {
        BodyMarks marks = marksOf(body);
        const std::string first = outermost(marks.group);
        if (first.empty()) continue;
        const auto [found, isNew] = names.try_emplace(first, first);
        if (isNew && !taken.insert(first).second) {
            found->second = freshName(taken);
            taken.insert(found->second);
        }
        marks.group = found->second + marks.group.substr(first.size());
        setMarks(body, marks);
    }
}

// --- groups ----------------------------------------------------------------------------------

bool canGroup(const Workbench& bench) {
    return unitsOf(bench).size() > 1;
}

void groupSelection(Workbench& bench) {
    if (!canGroup(bench)) return;
    const std::string name = freshName(outermostGroups(bench.document().scene()));
    for (const BodyId body : bench.selection())
        if (name.size() + 1 + bench.marks(body).group.size() > longestGroup)
            throw std::runtime_error("these groups lie too deep in each other; ungroup some first");
    markAsStep(bench, "Group", bench.selection(), [&](BodyMarks& marks) {
        marks.group = marks.group.empty() ? name : name + '/' + marks.group;
    });
}

bool canUngroup(const Workbench& bench) {
    const auto& bodies = bench.selection();
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](BodyId body) { return !bench.marks(body).group.empty(); });
}

void ungroupSelection(Workbench& bench) {
    std::set<std::string> names;
    for (const BodyId body : bench.selection()) names.insert(outermost(bench.marks(body).group));
    names.erase("");
    std::vector<BodyId> bodies;
    for (const BodyId body : bench.document().world().bodies())
        if (names.contains(outermost(bench.marks(body).group))) bodies.push_back(body);
    if (bodies.empty()) return;
    markAsStep(bench, "Ungroup", bodies,
               [](BodyMarks& marks) { marks.group = withoutOutermost(marks.group); });
}

void renameGroup(Workbench& bench, const std::string& group, const std::string& name) {
    if (!isGroupName(name))
        throw std::runtime_error(
            tr("\"{}\" is no name of a group; allowed is one line of 1 to {} bytes without /",
               {name, std::to_string(sulfur::scene::Limits::nameBytes)}));
    const auto slash = group.rfind('/');
    const std::string renamed =
        slash == std::string::npos ? name : group.substr(0, slash + 1) + name;
    if (renamed == group) return;
    std::vector<BodyId> bodies;
    for (const BodyId body : bench.document().world().bodies()) {
        const std::string& own = bench.marks(body).group;
        if (own == renamed || own.starts_with(renamed + '/'))
            throw std::runtime_error(
                tr("\"{}\" is the name of another group; choose a free one", {name}));
        if (own == group || own.starts_with(group + '/')) bodies.push_back(body);
    }
    markAsStep(bench, "Rename group", bodies,
               [&](BodyMarks& marks) { marks.group = renamed + marks.group.substr(group.size()); });
}

// --- locked, hidden, in front ----------------------------------------------------------------

void setLocked(Workbench& bench, std::span<const BodyId> bodies, bool on) {
    markAsStep(bench, on ? "Lock" : "Unlock", bodies,
               [on](BodyMarks& marks) { marks.locked = on; });
    if (on) bench.deselectUnpickable();
}

void setHidden(Workbench& bench, std::span<const BodyId> bodies, bool on) {
    markAsStep(bench, on ? "Hide" : "Show", bodies, [on](BodyMarks& marks) { marks.hidden = on; });
    if (on) bench.deselectUnpickable();
}

void unlockAll(Workbench& bench) {
    markAsStep(bench, "Unlock all", allBodies(bench),
               [](BodyMarks& marks) { marks.locked = false; });
}

void showAll(Workbench& bench) {
    markAsStep(bench, "Show all", allBodies(bench), [](BodyMarks& marks) { marks.hidden = false; });
}

std::size_t lockedCount(const Document& document) {
    const auto& bodies = document.scene().bodies;
    return static_cast<std::size_t>(std::count_if(
        bodies.begin(), bodies.end(), [](const auto& body) { return isMarked(body, "locked"); }));
}

std::size_t hiddenCount(const Document& document) {
    const auto& bodies = document.scene().bodies;
    return static_cast<std::size_t>(std::count_if(
        bodies.begin(), bodies.end(), [](const auto& body) { return isMarked(body, "hidden"); }));
}

void orderSelection(Workbench& bench, bool front) {
    if (bench.selection().empty()) return;
    int outer = 0;
    for (const BodyId body : bench.document().world().bodies())
        if (!bench.selected(body))
            outer = front ? std::max(outer, bench.marks(body).order)
                          : std::min(outer, bench.marks(body).order);
    const int wanted = std::clamp(front ? outer + 1 : outer - 1, -outmostOrder, outmostOrder);
    markAsStep(bench, front ? "Bring to front" : "Send to back", bench.selection(),
               [wanted](BodyMarks& marks) { marks.order = wanted; });
}

// --- in line ---------------------------------------------------------------------------------

bool canAlign(const Workbench& bench) {
    return canGroup(bench);
}

void alignSelection(Workbench& bench, Alignment alignment) {
    const auto units = unitsOf(bench);
    if (units.size() < 2) return;
    Bounds all = units[0].bounds;
    for (const Unit& unit : units) {
        all.include(unit.bounds.low);
        all.include(unit.bounds.high);
    }
    bench.cancel();
    bench.document().edit("Align", [&] {
        for (const Unit& unit : units)
            bench.document().translate(unit.bodies, wayToAlign(unit.bounds, all, alignment));
    });
}

bool canDistribute(const Workbench& bench) {
    return unitsOf(bench).size() > 2;
}

void distributeSelection(Workbench& bench, bool horizontally) {
    auto units = unitsOf(bench);
    if (units.size() < 3) return;
    const int axis = horizontally ? 0 : 1;
    std::sort(units.begin(), units.end(), [axis](const Unit& a, const Unit& b) {
        return a.bounds.centre()[axis] < b.bounds.centre()[axis];
    });
    double taken = 0;
    for (const Unit& unit : units) taken += unit.bounds.size()[axis];
    const double first = units.front().bounds.low[axis];
    const double gap =
        (units.back().bounds.high[axis] - first - taken) / static_cast<double>(units.size() - 1);
    bench.cancel();
    bench.document().edit("Distribute", [&] {
        double at = first;
        for (const Unit& unit : units) {
            Point way(0, 0);
            way[axis] = at - unit.bounds.low[axis];
            bench.document().translate(unit.bodies, way);
            at += unit.bounds.size()[axis] + gap;
        }
    });
}

}  // namespace sulfurchamber
