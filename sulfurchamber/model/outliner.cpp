#include "outliner.hpp"
#include "geometry.hpp"
#include "words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <unordered_map>

namespace sulfurchamber {
namespace {

using sulfur::BodyId;

std::string lowered(std::string text) {
    for (char& letter : text)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

// A group, or the whole scene, while rows are gathered.
struct Branch {
    struct Child {
        std::unique_ptr<Branch> group;  // or a body
        OutlineRow row;
    };
    std::string path;
    std::vector<Child> children;
    std::map<std::string, std::size_t> groups;  // places of groups among the children

    Branch& groupNamed(const std::string& name) {
        const auto [found, isNew] = groups.try_emplace(name, children.size());
        if (isNew) {
            Child child;
            child.group = std::make_unique<Branch>();
            child.group->path = path.empty() ? name : path + '/' + name;
            child.row.kind = OutlineRow::Kind::group;
            child.row.name = name;
            child.row.group = child.group->path;
            child.row.renamable = true;
            children.push_back(std::move(child));
        }
        return *children[found->second].group;
    }
};

Branch& branchOf(Branch& root, const std::string& path) {
    Branch* at = &root;
    for (std::size_t from = 0; from < path.size();) {
        const std::size_t end = std::min(path.find('/', from), path.size());
        at = &at->groupNamed(path.substr(from, end - from));
        from = end + 1;
    }
    return *at;
}

// What groups have of those in them.
void sumUp(Branch& branch, OutlineRow* own) {
    if (own != nullptr) own->hidden = own->locked = true;
    for (auto& child : branch.children) {
        if (child.group) sumUp(*child.group, &child.row);
        if (own == nullptr) continue;
        own->bodies.insert(own->bodies.end(), child.row.bodies.begin(), child.row.bodies.end());
        own->hidden = own->hidden && child.row.hidden;
        own->locked = own->locked && child.row.locked;
    }
}

struct Search {
    const std::string& text;  // in lower case
    const std::set<std::string>& closed;
    std::vector<OutlineRow>& rows;

    bool matches(const OutlineRow& row) const {
        return text.empty() || lowered(row.name).find(text) != std::string::npos;
    }
    // Whether anything of it is shown. All of a group is whose name matches.
    bool add(Branch& branch, int depth, bool all) const {
        bool any = false;
        for (auto& child : branch.children) {
            const bool whole = all || matches(child.row);
            child.row.depth = depth;
            const std::size_t place = rows.size();
            rows.push_back(child.row);
            bool shown = whole;
            if (child.group) {
                // Whoever searches sees what is found.
                const bool open = !text.empty() || !closed.contains(child.row.group);
                rows[place].open = open;
                if (open) shown = add(*child.group, depth + 1, whole) || shown;
            }
            if (!shown) rows.resize(place);
            any = any || shown;
        }
        return any;
    }
};

std::string_view kindOf(const sulfur::scene::SceneMechanism& mechanism) {
    static constexpr std::array<std::string_view, 7> names{"Hinge",    "Weld",   "Slider", "Wheel",
                                                           "Distance", "Pulley", "Gear"};
    return names.at(mechanism.spec.index());
}

std::string_view kindOf(const sulfur::Field& field) {
    if (std::holds_alternative<sulfur::UniformField>(field)) return "Uniform field";
    if (std::holds_alternative<sulfur::WindField>(field)) return "Wind";
    if (std::holds_alternative<sulfur::RadialField>(field)) return "Radial field";
    return "Field";
}

// Mechanisms, zones and thrusters, with the bodies that they are fitted to.
void addFittings(const Document& document, const std::unordered_map<std::string, BodyId>& here,
                 Branch& root) {
    const auto add = [&](OutlineRow::Kind kind, std::string name, FittingRef ref,
                         const std::vector<std::string>& ids) {
        Branch::Child child;
        child.row.kind = kind;
        child.row.fitting = ref;
        std::string of;
        for (const std::string& id : ids) {
            if (document.isPeg(id)) continue;
            of += (of.empty() ? ": " : ", ") + id;
            if (const auto found = here.find(id); found != here.end())
                child.row.bodies.push_back(found->second);
        }
        child.row.name = std::move(name) + of;
        root.children.push_back(std::move(child));
    };
    const auto& scene = document.scene();
    for (std::size_t i = 0; i < scene.mechanisms.size(); ++i) {
        auto mechanism = scene.mechanisms[i];
        std::vector<std::string> ids;
        for (const std::string* id : bodiesOf(mechanism)) ids.push_back(*id);
        add(OutlineRow::Kind::mechanism,
            mechanism.id.empty() ? tr(std::string(kindOf(mechanism))) : mechanism.id,
            {FittingRef::Kind::mechanism, i}, ids);
    }
    for (std::size_t i = 0; i < scene.fields.size(); ++i)
        add(OutlineRow::Kind::field, tr(std::string(kindOf(scene.fields[i].field))),
            {FittingRef::Kind::zone, i}, {});
    const auto& thrusters = document.thrusters();
    for (std::size_t i = 0; i < thrusters.size(); ++i)
        add(OutlineRow::Kind::mechanism, tr("Thruster"), {FittingRef::Kind::thruster, i},
            {thrusters[i].body});
}

}  // namespace

void Outliner::setSearch(const std::string& text) {
    if (lowered(text) == search_) return;
    search_ = lowered(text);
    fresh_ = true;
}

void Outliner::toggle(const std::string& group) {
    if (closed_.erase(group) == 0) closed_.insert(group);
    fresh_ = true;
}

const std::vector<OutlineRow>& Outliner::rows(const Workbench& bench) {
    const Document& document = bench.document();
    if (!fresh_ && revision_ == document.revision()) return rows_;
    fresh_ = false;
    revision_ = document.revision();
    ++version_;
    rows_.clear();

    const auto& world = document.world();
    const auto pins = pinsOf(document.world());
    std::unordered_map<std::string, BodyId> here;
    std::vector<OutlineRow> pieces;
    for (const BodyId body : world.bodies()) {
        if (pins.contains(body)) continue;
        if (std::string id = document.idOf(body); !id.empty()) {
            here.emplace(std::move(id), body);
        } else {
            OutlineRow row;
            row.name = tr("a piece of {}", {world.name(body)});
            row.bodies = {body};
            pieces.push_back(std::move(row));
        }
    }
    Branch root;
    for (const auto& body : document.scene().bodies) {
        if (document.isPeg(body.id)) continue;  // it goes with what is fitted to it
        const auto found = here.find(body.id);
        const BodyMarks marks = marksOf(body);
        Branch::Child child;
        child.row.name = body.id;
        child.row.hidden = marks.hidden;
        child.row.locked = marks.locked;
        child.row.renamable = found != here.end();
        if (found != here.end()) child.row.bodies = {found->second};
        branchOf(root, marks.group).children.push_back(std::move(child));
    }
    for (OutlineRow& row : pieces) root.children.push_back({nullptr, std::move(row)});
    addFittings(document, here, root);
    sumUp(root, nullptr);
    Search{search_, closed_, rows_}.add(root, 0, false);
    return rows_;
}

std::optional<Bounds> boundsOf(const Workbench& bench, const OutlineRow& row) {
    const auto& world = bench.document().world();
    std::optional<Bounds> all;
    for (const BodyId body : row.bodies) {
        if (!world.contains(body)) continue;
        const auto own = world.bounds(body);
        if (!all) all = Bounds{own.low, own.high};
        all->include(own.low);
        all->include(own.high);
    }
    return all;
}

void rename(Workbench& bench, const OutlineRow& row, const std::string& name) {
    if (!row.renamable) throw std::runtime_error(tr("\"{}\" has no name of its own", {row.name}));
    if (row.kind == OutlineRow::Kind::group) {
        renameGroup(bench, row.group, name);
        return;
    }
    bench.cancel();
    bench.document().edit("Rename", [&] { bench.document().rename(row.bodies.front(), name); });
}

}  // namespace sulfurchamber
