// The mechanics of a level file: every number in its range, every id and signal known.
#include <algorithm>
#include <set>

#include "reading.hpp"

namespace quaoar::reading {
namespace {

using sulfur::BodyKind;
using sulfur::scene::Node;

constexpr std::size_t mostOfAKind = 500;
constexpr double longest = 600;  // seconds

/// Reads "id" and refuses one that an earlier member of the same list has.
std::string readId(const Node& item, std::set<std::string>& taken) {
    const Node node = item.at("id");
    std::string id = node.string(1, sulfur::scene::Limits::nameBytes);
    if (!taken.insert(id).second) {
        node.fail("\"" + id + "\" is taken; allowed is an id that no other one of this list has");
    }
    return id;
}

/// A body of the scene of one kind, which no earlier member of the list names.
std::string readBody(const Node& item, const Level& level, BodyKind kind, const char* kindName,
                     std::set<std::string>& taken) {
    const Node node = item.at("body");
    std::string id = node.string(1, sulfur::scene::Limits::nameBytes);
    const sulfur::scene::Placement* body = level.scene.body(id);
    if (!body) {
        node.fail("\"" + id +
                  "\" names no body of this scene; allowed are the ids under \"bodies\"");
    }
    if (sulfur::scene::blueprintOf(level.scene, *body).kind != kind) {
        node.fail("\"" + id + "\" is not " + kindName + "; allowed here is a body of the kind \"" +
                  kindName + "\"");
    }
    if (!taken.insert(id).second) {
        node.fail("\"" + id + "\" is named twice; allowed is one member for each body");
    }
    return id;
}

sulfur::Point readPlace(const Node& node, const Level& level) {
    const sulfur::Point place = node.point(farthest);
    requireInside(node, level, place);
    return place;
}

std::vector<Checkpoint> readCheckpoints(const Node& node, const Level& level) {
    std::vector<Checkpoint> checkpoints;
    std::set<std::string> taken;
    for (const Node& item : node.array(0, Checkpoint::most)) {
        refuseUnknown(item, {"id", "position", "radius"});
        Checkpoint checkpoint;
        checkpoint.id = readId(item, taken);
        checkpoint.position = readPlace(item.at("position"), level);
        if (const auto r = item.find("radius")) checkpoint.radius = r->number(0.1, 50);
        checkpoints.push_back(std::move(checkpoint));
    }
    return checkpoints;
}

std::vector<Pickup> readPickups(const Node& node, const Level& level) {
    std::vector<Pickup> pickups;
    std::set<std::string> taken;
    for (const Node& item : node.array(0, Pickup::most)) {
        refuseUnknown(item, {"id", "position", "hidden", "signal"});
        Pickup pickup;
        pickup.id = readId(item, taken);
        pickup.position = readPlace(item.at("position"), level);
        if (const auto hidden = item.find("hidden")) pickup.hidden = hidden->boolean();
        if (const auto signal = item.find("signal")) pickup.signal = signalName(*signal);
        pickups.push_back(std::move(pickup));
    }
    return pickups;
}

Zone::Wind readWind(const Node& node) {
    refuseUnknown(node, {"velocity", "drag"});
    Zone::Wind wind;
    wind.velocity = node.at("velocity").vec2(100);
    readOptional(node, "drag", wind.drag, &Node::real, 0.01, 100);
    return wind;
}

Zone::Liquid readLiquid(const Node& node) {
    refuseUnknown(node, {"density", "drag"});
    Zone::Liquid liquid;
    readOptional(node, "density", liquid.density, &Node::real, 0.1, 1e5);
    readOptional(node, "drag", liquid.drag, &Node::real, 0, 100);
    return liquid;
}

Zone::Pulse readPulse(const Node& node) {
    refuseUnknown(node, {"period", "on", "phase"});
    Zone::Pulse pulse;
    pulse.period = node.at("period").number(0.1, longest);
    pulse.on = node.at("on").number(0.01, longest);
    if (pulse.on > pulse.period) {
        node.at("on").fail("is longer than the period; allowed is at most \"period\"");
    }
    readOptional(node, "phase", pulse.phase, &Node::number, 0, longest);
    return pulse;
}

Zone readZone(const Node& item, std::set<std::string>& taken) {
    refuseUnknown(item,
                  {"id", "min", "max", "gravity", "wind", "liquid", "deadly", "pulse", "needs"});
    Zone zone;
    zone.id = readId(item, taken);
    zone.low = item.at("min").point(farthest);
    zone.high = item.at("max").point(farthest);
    if (zone.high.x() - zone.low.x() < 0.05 || zone.high.y() - zone.low.y() < 0.05) {
        item.at("max").fail("is too near; allowed is at least 0.05 m right of and above \"min\"");
    }
    if (const auto g = item.find("gravity")) zone.gravity = g->vec2(100);
    if (const auto w = item.find("wind")) zone.wind = readWind(*w);
    if (const auto l = item.find("liquid")) zone.liquid = readLiquid(*l);
    if (const auto d = item.find("deadly")) zone.deadly = d->boolean();
    if (const auto p = item.find("pulse")) zone.pulse = readPulse(*p);
    if (const auto n = item.find("needs")) zone.needs = signalName(*n);
    if (!zone.gravity && !zone.wind && !zone.liquid && !zone.deadly) {
        item.fail(
            "does nothing; allowed is a zone with one or more of \"gravity\", \"wind\", "
            "\"liquid\" and \"deadly\": true");
    }
    return zone;
}

std::vector<Zone> readZones(const Node& node) {
    std::vector<Zone> zones;
    std::set<std::string> taken;
    for (const Node& item : node.array(0, mostOfAKind)) zones.push_back(readZone(item, taken));
    return zones;
}

void readTimes(const Node& item, Mover& mover) {
    readOptional(item, "spin", mover.spin, &Node::number, -100, 100);
    readOptional(item, "turn", mover.turn, &Node::number, -100, 100);
    const bool travels = !mover.path.empty() || mover.turn != 0;
    if (!travels && mover.spin == 0) {
        item.fail(
            "does not move; allowed is a mover with one or more of \"path\", \"turn\" and "
            "\"spin\"");
    }
    if (travels) mover.seconds = item.at("seconds").number(0.05, longest);
    mover.secondsBack = mover.seconds;
    readOptional(item, "secondsBack", mover.secondsBack, &Node::number, 0.05, longest);
    readOptional(item, "pauseStart", mover.pauseStart, &Node::number, 0, longest);
    readOptional(item, "pauseEnd", mover.pauseEnd, &Node::number, 0, longest);
    readOptional(item, "phase", mover.phase, &Node::number, 0, longest);
}

Mover readMover(const Node& item, const Level& level, std::set<std::string>& taken) {
    refuseUnknown(item, {"body", "path", "turn", "spin", "seconds", "secondsBack", "pauseStart",
                         "pauseEnd", "phase", "mode", "ease", "needs"});
    Mover mover;
    mover.body = readBody(item, level, BodyKind::kinematic, "kinematic", taken);
    if (const auto path = item.find("path")) {
        for (const Node& place : path->array(1, 200)) mover.path.push_back(place.point(farthest));
    }
    readTimes(item, mover);
    if (const auto mode = item.find("mode")) {
        mover.mode = static_cast<Mover::Mode>(mode->choice({"pingpong", "loop", "once", "door"}));
    }
    if (const auto ease = item.find("ease")) mover.ease = ease->boolean();
    if (const auto needs = item.find("needs")) mover.needs = signalName(*needs);
    if (mover.mode == Mover::Mode::door && mover.needs.empty()) {
        item.fail("is a door without a signal; allowed is a door that \"needs\" one");
    }
    if (mover.mode == Mover::Mode::loop && (mover.turn != 0 || mover.path.empty())) {
        item.fail("cannot go round; allowed for \"loop\" is a \"path\", and \"spin\" for \"turn\"");
    }
    return mover;
}

std::vector<Mover> readMovers(const Node& node, const Level& level) {
    std::vector<Mover> movers;
    std::set<std::string> taken;
    for (const Node& item : node.array(0, mostOfAKind)) {
        movers.push_back(readMover(item, level, taken));
    }
    return movers;
}

Switch readSwitch(const Node& item, const Level& level, std::set<std::string>& taken) {
    refuseUnknown(item, {"id", "position", "size", "by", "weight", "lasts", "mode", "signal"});
    Switch made;
    made.id = readId(item, taken);
    made.position = readPlace(item.at("position"), level);
    made.size = item.at("size").vec2(100);
    if (made.size.x() < sulfur::Real(0.05) || made.size.y() < sulfur::Real(0.05)) {
        item.at("size").fail("is too small; allowed is 0.05 m or more both ways");
    }
    if (const auto by = item.find("by")) {
        made.by = by->string(1, sulfur::scene::Limits::nameBytes);
        const bool known = made.by == "hero" || made.by == "rope" || made.by == "any" ||
                           level.scene.body(made.by) != nullptr;
        if (!known) {
            by->fail(
                "is nobody; allowed are \"hero\", \"rope\", \"any\" and the ids under \"bodies\"");
        }
    }
    if (const auto weight = item.find("weight")) {
        made.weight = weight->number(0.01, 1e6);
        if (made.by != "any") weight->fail("is of no use here; allowed is it with \"by\": \"any\"");
    }
    if (const auto mode = item.find("mode")) {
        made.mode = static_cast<Switch::Mode>(mode->choice({"hold", "toggle", "once"}));
    }
    if (const auto lasts = item.find("lasts")) {
        made.lasts = lasts->number(0, longest);
        if (made.mode != Switch::Mode::hold) {
            lasts->fail("is of no use here; allowed is it with the mode \"hold\"");
        }
    }
    made.signal = signalName(item.at("signal"));
    return made;
}

std::vector<Switch> readSwitches(const Node& node, const Level& level) {
    std::vector<Switch> switches;
    std::set<std::string> taken;
    for (const Node& item : node.array(0, mostOfAKind)) {
        switches.push_back(readSwitch(item, level, taken));
    }
    return switches;
}

void readPatrol(const Node& item, Monster& monster) {
    const auto between = item.find("between");
    if (!between) {
        if (monster.behaviour != Monster::Behaviour::patrol) return;
        item.fail("patrols nowhere; allowed is a patrol with \"between\": [x, x]");
    }
    const std::vector<Node> ends = between->array(2, 2);
    monster.from = ends[0].number(-farthest, farthest);
    monster.to = ends[1].number(-farthest, farthest);
    if (monster.to - monster.from < 0.1) {
        between->fail(
            "is too narrow; allowed is [x, x] with the second 0.1 m or more to the right");
    }
}

Monster readMonster(const Node& item, const Level& level, std::set<std::string>& taken) {
    refuseUnknown(item, {"body", "behaviour", "target", "range", "speed", "flies", "between",
                         "toughness", "onDefeat"});
    Monster monster;
    monster.body = readBody(item, level, BodyKind::dynamic, "dynamic", taken);
    monster.behaviour = static_cast<Monster::Behaviour>(
        item.at("behaviour").choice({"patrol", "lunge", "chase", "flee", "hang"}));
    if (const auto target = item.find("target")) {
        monster.target = static_cast<Monster::Target>(target->choice({"hero", "rope"}));
    }
    readOptional(item, "range", monster.range, &Node::number, 0, 50);
    readOptional(item, "speed", monster.speed, &Node::number, 0.05, 30);
    if (const auto flies = item.find("flies")) monster.flies = flies->boolean();
    readPatrol(item, monster);
    readOptional(item, "toughness", monster.toughness, &Node::number, 0.01, 1e6);
    if (const auto signal = item.find("onDefeat")) monster.onDefeat = signalName(*signal);
    return monster;
}

std::vector<Monster> readMonsters(const Node& node, const Level& level) {
    std::vector<Monster> monsters;
    std::set<std::string> taken;
    for (const Node& item : node.array(0, mostOfAKind)) {
        monsters.push_back(readMonster(item, level, taken));
    }
    return monsters;
}

std::vector<Respawn> readRespawns(const Node& node, const Level& level) {
    std::vector<Respawn> respawns;
    std::set<std::string> taken;
    for (const Node& item : node.array(0, mostOfAKind)) {
        refuseUnknown(item, {"body", "every", "phase", "needs"});
        Respawn respawn;
        respawn.body = readBody(item, level, BodyKind::dynamic, "dynamic", taken);
        respawn.every = item.at("every").number(0.1, longest);
        readOptional(item, "phase", respawn.phase, &Node::number, 0, longest);
        if (const auto needs = item.find("needs")) respawn.needs = signalName(*needs);
        respawns.push_back(std::move(respawn));
    }
    return respawns;
}

std::vector<std::string> signalsOf(const Level& level) {
    std::vector<std::string> signals;
    for (const Switch& one : level.switches) signals.push_back(one.signal);
    for (const Pickup& one : level.pickups) {
        if (!one.signal.empty()) signals.push_back(one.signal);
    }
    for (const Monster& one : level.monsters) {
        if (!one.onDefeat.empty()) signals.push_back(one.onDefeat);
    }
    std::sort(signals.begin(), signals.end());
    signals.erase(std::unique(signals.begin(), signals.end()), signals.end());
    return signals;
}

void requireSignal(const Node& object, const Level& level) {
    const auto needs = object.find("needs");
    if (!needs || level.signal(needs->string(1, 60))) return;
    std::string known;
    for (const std::string& name : level.signals) known += (known.empty() ? "" : ", ") + name;
    needs->fail(
        "is a signal that nothing turns on; allowed are those of \"switches\", \"pickups\" and "
        "\"onDefeat\"" +
        (known.empty() ? "" : ": " + known));
}

}  // namespace

void readMechanics(const Node& section, Level& level) {
    if (const auto n = section.find("checkpoints")) level.checkpoints = readCheckpoints(*n, level);
    if (const auto n = section.find("pickups")) level.pickups = readPickups(*n, level);
    if (const auto n = section.find("zones")) level.zones = readZones(*n);
    if (const auto n = section.find("movers")) level.movers = readMovers(*n, level);
    if (const auto n = section.find("switches")) level.switches = readSwitches(*n, level);
    if (const auto n = section.find("monsters")) level.monsters = readMonsters(*n, level);
    if (const auto n = section.find("respawns")) level.respawns = readRespawns(*n, level);
    level.signals = signalsOf(level);
    requireSignal(section.at("exit"), level);
    for (const char* list : {"zones", "movers", "respawns"}) {
        const auto node = section.find(list);
        if (!node) continue;
        for (const Node& item : node->array(0, mostOfAKind)) requireSignal(item, level);
    }
}

}  // namespace quaoar::reading
