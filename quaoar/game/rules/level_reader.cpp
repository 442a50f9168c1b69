// The game's part of a level file: everything is checked here, nothing later.
#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <cmath>
#include <quaoar/level.hpp>
#include <quaoar/level_check.hpp>
#include <quaoar/session.hpp>

#include "reading.hpp"

namespace quaoar {
namespace {

using reading::farthest;
using reading::refuseUnknown;
using reading::requireInside;
using sulfur::scene::Node;

std::uint32_t readColour(const Node& node) {
    const std::string text = node.string(0, 20);
    const bool shaped = text.size() == 7 && text[0] == '#' &&
                        text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!shaped) node.fail("is not a colour; allowed is \"#rrggbb\" such as \"#1F3A5F\"");
    return static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16));
}

Exit readExit(const Node& node) {
    refuseUnknown(node, {"position", "radius", "needs"});
    Exit exit;
    exit.position = node.at("position").point(farthest);
    exit.radius = node.at("radius").number(0.1, 10);
    if (const auto needs = node.find("needs")) exit.needs = reading::signalName(*needs);
    return exit;
}

void readBounds(const Node& node, Level& level) {
    refuseUnknown(node, {"min", "max"});
    level.boundsMin = node.at("min").point(farthest);
    level.boundsMax = node.at("max").point(farthest);
    const sulfur::Point size = level.boundsMax - level.boundsMin;
    if (size.x() < 1 || size.y() < 1) {
        node.fail("is too small; \"max\" must be at least 1 m right of and above \"min\"");
    }
}

std::vector<Hint> readHints(const Node& node) {
    std::vector<Hint> hints;
    for (const Node& item : node.array(0, 100)) {
        refuseUnknown(item, {"position", "text"});
        hints.push_back({item.at("position").point(farthest), item.at("text").string(1, 300)});
    }
    return hints;
}

MedalTimes readMedals(const Node& node) {
    refuseUnknown(node, {"gold", "silver", "bronze"});
    MedalTimes medals;
    medals.gold = node.at("gold").number(0.1, 36000);
    medals.silver = node.at("silver").number(0.1, 36000);
    medals.bronze = node.at("bronze").number(0.1, 36000);
    if (medals.gold > medals.silver || medals.silver > medals.bronze) {
        node.fail("has its times out of order; allowed is gold <= silver <= bronze");
    }
    return medals;
}

void readSurfaces(const Node& node, Level& level) {
    node.requireObject();
    for (const Node& member : node.members()) {
        const auto& bodies = level.scene.bodies;
        const bool known = std::any_of(bodies.begin(), bodies.end(), [&](const auto& body) {
            return namesBody(member.key(), body.id);
        });
        if (!known) {
            member.fail(
                "names no body of this scene; allowed are the ids under \"bodies\", or their "
                "beginning and a star");
        }
        refuseUnknown(member, {"sticky", "deadly", "deadlySpeed", "cuts", "crumbles", "look"});
        Surface surface;
        if (const auto sticky = member.find("sticky")) surface.sticky = sticky->boolean();
        if (const auto deadly = member.find("deadly")) surface.deadly = deadly->boolean();
        if (const auto v = member.find("deadlySpeed")) surface.deadlySpeed = v->number(0.1, 100);
        if (const auto cuts = member.find("cuts")) surface.cuts = cuts->boolean();
        if (const auto c = member.find("crumbles")) surface.crumbles = c->number(0, 60);
        if (const auto look = member.find("look")) {
            surface.look =
                static_cast<Surface::Look>(look->choice({"ice", "mirror", "metal", "rock", "peg"}));
        }
        level.surfaces.emplace(member.key(), surface);
    }
}

Theme readTheme(const Node& node) {
    refuseUnknown(node, {"world", "skyTop", "skyBottom", "ice", "rim", "seed"});
    Theme theme;
    if (const auto w = node.find("world")) {
        theme = themeOf(static_cast<Theme::World>(w->choice({"dawn", "bog", "machine", "deep"})));
    }
    if (const auto c = node.find("skyTop")) theme.skyTop = readColour(*c);
    if (const auto c = node.find("skyBottom")) theme.skyBottom = readColour(*c);
    if (const auto c = node.find("ice")) theme.ice = readColour(*c);
    if (const auto c = node.find("rim")) theme.rim = readColour(*c);
    if (const auto s = node.find("seed")) {
        theme.seed = static_cast<std::uint32_t>(s->integer(0, 0xffffffffll));
    }
    return theme;
}

void readSection(const Node& node, Level& level) {
    refuseUnknown(
        node,
        {"name",        "number",  "spawn",    "exit",   "bounds",    "viewHeight", "killDepth",
         "hints",       "medals",  "surfaces", "theme",  "countdown", "speedLimit", "reach",
         "checkpoints", "pickups", "zones",    "movers", "switches",  "monsters",   "respawns"});
    level.name = node.at("name").string(1, 60);
    level.number = static_cast<int>(node.at("number").integer(1, 999));
    readBounds(node.at("bounds"), level);
    level.spawn = node.at("spawn").point(farthest);
    requireInside(node.at("spawn"), level, level.spawn);
    level.exit = readExit(node.at("exit"));
    requireInside(node.at("exit").at("position"), level, level.exit.position);
    level.killDepth = node.at("killDepth").number(-farthest, farthest);
    if (level.killDepth >= level.spawn.y()) {
        node.at("killDepth").fail("is not below the spawn; the hero would never live");
    }
    if (const auto v = node.find("viewHeight")) level.viewHeight = v->number(2, 50);
    if (const auto h = node.find("hints")) level.hints = readHints(*h);
    level.medals = readMedals(node.at("medals"));
    if (const auto s = node.find("surfaces")) readSurfaces(*s, level);
    if (const auto t = node.find("theme")) level.theme = readTheme(*t);
    if (const auto c = node.find("countdown")) level.countdown = c->number(1, 3600);
    if (const auto s = node.find("speedLimit")) level.speedLimit = s->real(1, 60);
    if (const auto r = node.find("reach")) level.reach = r->real(0.5, 20);
    reading::readMechanics(node, level);
}

void requireTickRate(const Level& level, const std::filesystem::path& file) {
    const int rate = level.scene.settings.tickRate;
    if (rate == Session::tickRate) return;
    throw sulfur::scene::ReadError(file.string(), 0, "world",
                                   "\"tickRate\" is " + std::to_string(rate) +
                                       "; allowed in a level is " +
                                       std::to_string(Session::tickRate));
}

}  // namespace

Level parseLevel(const std::string& text, const std::filesystem::path& file) {
    Level level;
    level.scene = sulfur::scene::parse(text, file.string());
    level.id = file.stem().string();
    level.contentHash = contentHash(text);
    const auto section = level.scene.section("level");
    if (!section) {
        throw sulfur::scene::ReadError(
            file.string(), 0, "",
            "is a scene but no level; a level has a top-level member \"level\" "
            "(see levels/level.schema.json)");
    }
    readSection(section->root(), level);
    requireTickRate(level, file);
    return level;
}

Level readLevel(const std::filesystem::path& file) {
    std::string text;
    try {
        text = atlax::readFile(file, sulfur::scene::DocumentLimits{}.bytes);
    } catch (const atlax::Error& error) {
        std::string problem = error.what();  // may begin with the file, as ReadError's text will
        const std::string prefix = file.string() + ": ";
        if (problem.starts_with(prefix)) problem.erase(0, prefix.size());
        throw sulfur::scene::ReadError(file.string(), 0, "", problem);
    }
    Level level = parseLevel(text, file);
    if (const auto found = checkLevel(level)) {
        throw sulfur::scene::ReadError(file.string(), 0, found->object, found->problem);
    }
    return level;
}

}  // namespace quaoar
