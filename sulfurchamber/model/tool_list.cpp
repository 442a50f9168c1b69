// The names of the tools, and which stand together.
#include <algorithm>
#include <array>

#include "workbench.hpp"

namespace sulfurchamber {
namespace {

struct ToolEntry {
    ToolKind kind;
    std::string_view name;
    ToolGroup group;
};

using G = ToolGroup;
constexpr std::array toolEntries{
    ToolEntry{ToolKind::select, "select", G::select},
    ToolEntry{ToolKind::box, "box", G::create},
    ToolEntry{ToolKind::ball, "ball", G::create},
    ToolEntry{ToolKind::wheel, "wheel", G::create},
    ToolEntry{ToolKind::polygon, "polygon", G::create},
    ToolEntry{ToolKind::wall, "wall", G::create},
    ToolEntry{ToolKind::ground, "ground", G::create},
    ToolEntry{ToolKind::jelly, "jelly", G::soft},
    ToolEntry{ToolKind::draw, "draw", G::soft},
    ToolEntry{ToolKind::cloth, "cloth", G::soft},
    ToolEntry{ToolKind::rope, "rope", G::soft},
    ToolEntry{ToolKind::chain, "chain", G::soft},
    ToolEntry{ToolKind::bridge, "bridge", G::soft},
    ToolEntry{ToolKind::particle, "particle", G::particles},
    ToolEntry{ToolKind::joint, "joint", G::particles},
    ToolEntry{ToolKind::hinge, "hinge", G::mechanisms},
    ToolEntry{ToolKind::motor, "motor", G::mechanisms},
    ToolEntry{ToolKind::weld, "weld", G::mechanisms},
    ToolEntry{ToolKind::spring, "spring", G::mechanisms},
    ToolEntry{ToolKind::cable, "cable", G::mechanisms},
    ToolEntry{ToolKind::winch, "winch", G::mechanisms},
    ToolEntry{ToolKind::slider, "slider", G::mechanisms},
    ToolEntry{ToolKind::axle, "axle", G::mechanisms},
    ToolEntry{ToolKind::pulley, "pulley", G::mechanisms},
    ToolEntry{ToolKind::gear, "gear", G::mechanisms},
    ToolEntry{ToolKind::thruster, "thruster", G::zones},
    ToolEntry{ToolKind::wind, "wind", G::zones},
    ToolEntry{ToolKind::gravity, "gravity", G::zones},
    ToolEntry{ToolKind::conveyor, "conveyor", G::zones},
    ToolEntry{ToolKind::liquid, "liquid", G::zones},
    ToolEntry{ToolKind::pin, "pin", G::change},
    ToolEntry{ToolKind::cut, "cut", G::change},
    ToolEntry{ToolKind::erase, "erase", G::change},
    ToolEntry{ToolKind::measure, "measure", G::measure},
    ToolEntry{ToolKind::protractor, "protractor", G::measure},
    ToolEntry{ToolKind::tracer, "tracer", G::measure},
    ToolEntry{ToolKind::gauge, "gauge", G::measure},
    ToolEntry{ToolKind::gun, "gun", G::measure},
};

constexpr std::array groupInfos{
    ToolGroupInfo{G::select, "select", "Select", "select"},
    ToolGroupInfo{G::create, "create", "Rigid things", "box"},
    ToolGroupInfo{G::soft, "soft", "Soft things and ropes", "jelly"},
    ToolGroupInfo{G::particles, "particles", "Particles and joints", "joint"},
    ToolGroupInfo{G::mechanisms, "mechanisms", "Mechanisms", "hinge"},
    ToolGroupInfo{G::zones, "zones", "Thrusters, zones, liquid", "wind"},
    ToolGroupInfo{G::change, "change", "Pin, cut, erase", "cut"},
    ToolGroupInfo{G::measure, "measure", "Measure", "measure"},
};

// A menu of its own offers the pieces of levels.
constexpr ToolEntry placing{ToolKind::place, "place", G::select};

const ToolEntry& entryOf(ToolKind tool) {
    const auto found = std::find_if(toolEntries.begin(), toolEntries.end(),
                                    [&](const auto& entry) { return entry.kind == tool; });
    return found == toolEntries.end() ? placing : *found;
}

}  // namespace

std::span<const ToolKind> allTools() {
    static constexpr auto kinds = [] {
        std::array<ToolKind, toolEntries.size()> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = toolEntries[i].kind;
        return all;
    }();
    return kinds;
}

std::string_view toolName(ToolKind tool) {
    return entryOf(tool).name;
}

std::optional<ToolKind> toolFromName(std::string_view name) {
    for (const ToolEntry& entry : toolEntries)
        if (entry.name == name) return entry.kind;
    return std::nullopt;
}

std::span<const ToolGroupInfo> toolGroups() {
    return groupInfos;
}

ToolGroup groupOf(ToolKind tool) {
    return entryOf(tool).group;
}

}  // namespace sulfurchamber
