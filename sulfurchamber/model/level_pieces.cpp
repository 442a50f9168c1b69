#include "level_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry.hpp"
#include "lattice.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;

constexpr double leastZone = 0.2;      // metres: a click makes one of the usual size
constexpr double moverSpeed = 1.5;     // m/s at first
constexpr double groundRadius = 0.05;  // metres

constexpr LevelPieceInfo pieceTable[] = {
    {LevelPiece::ground, "ground", "&Ground", Placing::corners,
     "Click the corners of a block of ground, or drag a rectangle; the rope holds on it"},
    {LevelPiece::spawn, "spawn", "&Spawn", Placing::click, "Click where the hero begins"},
    {LevelPiece::exit, "exit", "E&xit", Placing::click, "Click where the level ends"},
    {LevelPiece::bounds, "bounds", "&Camera bounds", Placing::frame,
     "Drag a rectangle: what the camera may show"},
    {LevelPiece::hint, "hint", "&Hint", Placing::click, "Click where a text floats"},
    {LevelPiece::checkpoint, "checkpoint", "Chec&kpoint", Placing::click,
     "Click where the hero comes back to when he dies"},
    {LevelPiece::pickup, "pickup", "&Pick-up", Placing::click, "Click where a shard lies"},
    {LevelPiece::gravity, "gravity", "Zone of &gravity", Placing::frame,
     "Drag a rectangle with another gravity"},
    {LevelPiece::wind, "wind", "Zone of &wind", Placing::frame, "Drag a rectangle with wind"},
    {LevelPiece::liquid, "liquid", "&Liquid", Placing::frame, "Drag a rectangle of liquid"},
    {LevelPiece::deadlyZone, "deadly", "&Deadly zone", Placing::frame,
     "Drag a rectangle that kills the hero"},
    {LevelPiece::trigger, "switch", "S&witch", Placing::frame,
     "Drag a rectangle that turns a signal on when it is touched"},
    {LevelPiece::mover, "mover", "&Mover", Placing::way,
     "Drag from a body to where it shall go: a lift, a crusher, a door"},
    {LevelPiece::monster, "monster", "M&onster", Placing::body,
     "Click for a slug, or on a body that shall behave"},
    {LevelPiece::rock, "rock", "Falling &rock", Placing::body,
     "Click for a rock that falls again and again, or on a body that shall"},
    {LevelPiece::hazard, "hazard", "Ha&zard", Placing::body,
     "Click on a body that shall kill, or drag a row of spikes"},
};

// Bodies that come with a piece, as a file has them.
constexpr const char* slugBlueprint = R"({
  "format": "sulfur-scene", "version": 1,
  "blueprints": {"slug": {
    "shape": "polygon",
    "points": [[-0.45, -0.2], [-0.18, -0.2], [0.135, -0.2], [0.432, -0.2], [0.45, -0.08],
      [0.378, 0.088], [0.198, 0.192], [-0.045, 0.2], [-0.252, 0.136], [-0.387, 0.02],
      [-0.468, -0.12]],
    "mass": 1.5, "radius": 0.03, "stiffness": 2500, "damping": 2,
    "material": {"staticFriction": 1.0, "kineticFriction": 0.9, "restitution": 0},
    "skin": {"texture": "jelly.svg"}}},
  "bodies": []})";
constexpr const char* rockBlueprint = R"({
  "format": "sulfur-scene", "version": 1,
  "blueprints": {"rock": {
    "shape": "polygon", "mass": 1.6, "radius": 0.02,
    "points": [[0.16, 0], [0.099, 0.117], [0, 0.149], [-0.11, 0.116], [-0.178, 0],
      [-0.126, -0.126], [0, -0.142], [0.103, -0.122]],
    "material": {"staticFriction": 0.6, "kineticFriction": 0.5, "restitution": 0.05}}},
  "bodies": []})";

std::string placed(std::string_view id, const Point& at, std::string_view more = "") {
    return "{\"id\": " + jsonOf(id) + ", \"position\": " + jsonOf(at.x(), at.y()) +
           std::string(more) + '}';
}

Bounds frameOf(const Point& a, const Point& b, const Point& usual) {
    if (std::abs(a.x() - b.x()) < leastZone && std::abs(a.y() - b.y()) < leastZone)
        return {a - usual / 2, a + usual / 2};
    Bounds box{a, a};
    box.include(b);
    box.high = box.high.cwiseMax(Point(box.low.array() + 0.05));
    return box;
}

LevelThing setPlaceOf(Document& document, LevelKind kind, const Point& at) {
    const LevelThing thing{kind, 0, {}};
    moveThing(document, thing, at - shapeOf(document, thing).at);
    return thing;
}

LevelThing addZone(Document& document, const std::string& base, const Bounds& box,
                   std::string_view effect) {
    const std::string id = freeLevelId(document, LevelKind::zone, base);
    return addThing(document, LevelKind::zone,
                    "{\"id\": " + jsonOf(std::string_view(id)) +
                        ", \"min\": " + jsonOf(box.low.x(), box.low.y()) + ", \"max\": " +
                        jsonOf(box.high.x(), box.high.y()) + ", " + std::string(effect) + '}');
}

LevelThing addTrigger(Document& document, const Bounds& box) {
    const std::string id = freeLevelId(document, LevelKind::trigger, "switch");
    return addThing(document, LevelKind::trigger,
                    "{\"id\": " + jsonOf(std::string_view(id)) +
                        ", \"position\": " + jsonOf(box.centre().x(), box.centre().y()) +
                        ", \"size\": " + jsonOf(box.size().x(), box.size().y()) +
                        ", \"signal\": " + jsonOf(std::string_view(id)) + '}');
}

// The id of a body of the plan that has nothing of this kind yet.
std::string freeBody(const Document& document, BodyId body, LevelKind kind, const char* what) {
    if (!body) throw std::runtime_error(tr("there is no body here; {}", {tr(what)}));
    const std::string id = document.idOf(body);
    if (id.empty()) throw std::runtime_error("this is a piece of a body that broke; press Reset");
    for (const LevelThing& thing : levelThings(document))
        if (thing.kind == kind && bodyOf(document, thing) == id)
            throw std::runtime_error(tr("\"{}\" has one already; it can be selected", {id}));
    return id;
}

void makeKind(Document& document, BodyId body, sulfur::BodyKind kind) {
    if (document.world().kind(body) == kind) return;
    document.change({&body, 1}, [&](auto& prefab) { prefab.blueprint.kind = kind; });
}

LevelThing addMover(Document& document, BodyId body, const Point& from, const Point& to) {
    const std::string id =
        freeBody(document, body, LevelKind::mover, "a mover begins at the body that it moves");
    makeKind(document, body, sulfur::BodyKind::kinematic);
    const Point end = document.plan().body(id).pose.position + (to - from);
    const double seconds = std::max(0.5, (to - from).norm() / moverSpeed);
    if ((to - from).norm() < leastZone)
        return addThing(document, LevelKind::mover,
                        "{\"body\": " + jsonOf(std::string_view(id)) + ", \"spin\": -0.7}");
    return addThing(document, LevelKind::mover,
                    "{\"body\": " + jsonOf(std::string_view(id)) + ", \"path\": [" +
                        jsonOf(end.x(), end.y()) +
                        "], \"seconds\": " + jsonOf(std::round(seconds * 10) / 10) + '}');
}

// Sets members of the surface of a body, which may be new.
LevelThing addSurface(Document& document, const std::string& id,
                      std::initializer_list<std::pair<const char*, const char*>> members) {
    JsonText text(document.levelText());
    if (!text.has({"surfaces"})) text.set({"surfaces"}, "{}");
    if (!text.has({"surfaces", id})) text.set({"surfaces", id}, "{}");
    for (const auto& [key, json] : members) text.set({"surfaces", id, key}, json);
    document.setLevelText(text.text());
    return {LevelKind::surface, 0, id};
}

BodyId addBody(Document& document, const char* scene, const Point& at) {
    const auto made = sulfur::scene::parse(scene, "piece");
    sulfur::scene::Placement placement;
    placement.pose.position = at;
    return document.add(made.blueprints.front(), placement);
}

LevelThing addMonster(Document& document, BodyId body, const Point& at) {
    std::string id;
    if (body && document.world().kind(body) == sulfur::BodyKind::dynamic) {
        id = freeBody(document, body, LevelKind::monster, "");
    } else {
        id = document.idOf(addBody(document, slugBlueprint, at));
        addSurface(document, id, {{"deadly", "true"}});
    }
    return addThing(document, LevelKind::monster,
                    "{\"body\": " + jsonOf(std::string_view(id)) +
                        ", \"behaviour\": \"patrol\", \"speed\": 0.6, \"between\": " +
                        jsonOf(at.x() - 1, at.x() + 1) + '}');
}

LevelThing addRock(Document& document, BodyId body, const Point& at) {
    std::string id;
    if (body && document.world().kind(body) == sulfur::BodyKind::dynamic) {
        id = freeBody(document, body, LevelKind::respawn, "");
    } else {
        id = document.idOf(addBody(document, rockBlueprint, at));
        addSurface(document, id, {{"look", "\"rock\""}, {"deadlySpeed", "2"}});
    }
    return addThing(document, LevelKind::respawn,
                    "{\"body\": " + jsonOf(std::string_view(id)) + ", \"every\": 4}");
}

// Teeth on a low base, from the left to the right.
std::vector<Point> spikes(const Point& from, const Point& to) {
    constexpr double tooth = 0.22, base = 0.06, height = 0.3;  // metres
    const double left = std::min(from.x(), to.x());
    const double width = std::max(tooth, std::abs(to.x() - from.x()));
    const double bottom = std::min(from.y(), to.y());
    const int teeth = std::max(1, static_cast<int>(std::lround(width / tooth)));
    std::vector<Point> outline{{left, bottom}, {left + width, bottom}};
    for (int i = teeth; i > 0; --i) {
        const double right = left + width * i / teeth;
        outline.emplace_back(right, bottom + base);
        outline.emplace_back(right - width / teeth / 2, bottom + height);
    }
    outline.emplace_back(left, bottom + base);
    return outline;
}

BodyId addOutline(Document& document, const std::string& name, const std::vector<Point>& outline,
                  double radius) {
    sulfur::shapes::GroundOptions options;
    options.closed = true;
    options.radius = static_cast<Real>(radius);
    options.material.staticFriction = Real(0.5);
    options.material.kineticFriction = Real(0.35);
    for (const Point& point : outline) options.points.push_back(point.cast<Real>());
    return document.add(name, options, {});
}

LevelThing addHazard(Document& document, BodyId body, const Point& from, const Point& to) {
    if (body && (to - from).norm() < leastZone) {
        const std::string id = document.idOf(body);
        if (id.empty()) throw std::runtime_error("this is a piece that broke; press Reset");
        return addSurface(document, id, {{"deadly", "true"}});
    }
    const BodyId made = addOutline(document, "spikes", spikes(from, to), 0.02);
    return addSurface(document, document.idOf(made),
                      {{"look", "\"rock\""}, {"sticky", "false"}, {"deadly", "true"}});
}

double signedArea(const std::vector<Point>& outline) {
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        area += sulfur::cross(outline[i], outline[(i + 1) % outline.size()]);
    return area / 2;
}

}  // namespace

std::span<const LevelPieceInfo> levelPieces() {
    return pieceTable;
}

const LevelPieceInfo& infoOf(LevelPiece piece) {
    return pieceTable[static_cast<std::size_t>(piece)];
}

LevelThing addGround(Document& document, std::vector<Point> outline) {
    if (outline.size() < 3) throw std::runtime_error("ground has three corners or more");
    if (meetsItself(outline))
        throw std::runtime_error("this outline crosses itself; go round it once");
    if (signedArea(outline) < 0) std::reverse(outline.begin(), outline.end());
    const BodyId made = addOutline(document, "ground", outline, groundRadius);
    return addSurface(document, document.idOf(made), {{"look", "\"ice\""}});
}

LevelThing placePiece(Document& document, LevelPiece piece, const Point& from, const Point& to,
                      BodyId body) {
    if (!isLevel(document))
        throw std::runtime_error("this scene is no level yet; \"Make a level of this scene\" does");
    const auto id = [&](LevelKind kind, const char* base) {
        return freeLevelId(document, kind, base);
    };
    switch (piece) {
        case LevelPiece::spawn:
            return setPlaceOf(document, LevelKind::spawn, to);
        case LevelPiece::exit:
            return setPlaceOf(document, LevelKind::exit, to);
        case LevelPiece::bounds: {
            const Bounds box = frameOf(from, to, {12, 7});
            const LevelThing bounds{LevelKind::bounds, 0, {}};
            dragHandle(document, bounds, 0, box.low.cwiseMin(shapeOf(document, bounds).box.low));
            dragHandle(document, bounds, 2, box.high);
            dragHandle(document, bounds, 0, box.low);
            return bounds;
        }
        case LevelPiece::hint:
            return addThing(document, LevelKind::hint,
                            "{\"position\": " + jsonOf(to.x(), to.y()) + ", \"text\": \"Text\"}");
        case LevelPiece::checkpoint:
            return addThing(document, LevelKind::checkpoint,
                            placed(id(LevelKind::checkpoint, "checkpoint"), to));
        case LevelPiece::pickup:
            return addThing(document, LevelKind::pickup,
                            placed(id(LevelKind::pickup, "shard"), to));
        case LevelPiece::gravity:
            return addZone(document, "drift", frameOf(from, to, {2, 2}), "\"gravity\": [0, 1.5]");
        case LevelPiece::wind:
            return addZone(document, "wind", frameOf(from, to, {1, 3}),
                           "\"wind\": {\"velocity\": [0, 9], \"drag\": 4}");
        case LevelPiece::liquid:
            return addZone(document, "pool", frameOf(from, to, {3, 1}),
                           "\"liquid\": {\"density\": 60}");
        case LevelPiece::deadlyZone:
            return addZone(document, "deadly", frameOf(from, to, {1, 1}), R"("deadly": true)");
        case LevelPiece::trigger:
            return addTrigger(document, frameOf(from, to, {0.8, 0.24}));
        case LevelPiece::mover:
            return addMover(document, body, from, to);
        case LevelPiece::monster:
            return addMonster(document, body, to);
        case LevelPiece::rock:
            return addRock(document, body, to);
        case LevelPiece::hazard:
            return addHazard(document, body, from, to);
        case LevelPiece::ground:
            break;
    }
    const Bounds box = frameOf(from, to, {2, 1});
    return addGround(document,
                     {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}});
}

// --- levels to begin with --------------------------------------------------------------------

sulfur::scene::Scene newLevel() {
    static constexpr const char* text = R"({
  "format": "sulfur-scene",
  "version": 1,
  "title": "New Level",
  "world": {"gravity": [0, -9.81], "airFriction": 0.05, "tickRate": 500, "sweeps": 4},
  "level": {
    "name": "New Level",
    "number": 100,
    "spawn": [1, 0.3],
    "exit": {"position": [11, 0.6], "radius": 0.6},
    "bounds": {"min": [-1, -1.5], "max": [13, 4.5]},
    "killDepth": -1.2,
    "hints": [{"position": [2, 1.4], "text": "{fire} shoots the rope."}],
    "medals": {"gold": 12, "silver": 20, "bronze": 45},
    "surfaces": {"ground": {"look": "ice"}, "ceiling": {"look": "ice"}},
    "theme": {"world": "dawn", "seed": 1}
  },
  "blueprints": {
    "ground": {
      "shape": "ground", "kind": "fixed", "closed": true, "radius": 0.05,
      "material": {"staticFriction": 0.5, "kineticFriction": 0.35, "restitution": 0},
      "points": [[-3, -3], [15, -3], [15, 0], [6.5, 0], [6.3, -0.2], [6.2, -2], [5.3, -2],
        [5.2, -0.2], [5, 0], [-3, 0]]
    },
    "ceiling": {
      "shape": "ground", "kind": "fixed", "closed": true, "radius": 0.05,
      "material": {"staticFriction": 0.5, "kineticFriction": 0.35, "restitution": 0},
      "points": [[-3, 3], [1, 2.9], [4, 2.6], [7, 2.6], [10, 2.9], [15, 3], [15, 6], [-3, 6]]
    }
  },
  "bodies": [
    {"id": "ground", "blueprint": "ground"},
    {"id": "ceiling", "blueprint": "ceiling"}
  ]
})";
    return sulfur::scene::parse(text, "level");
}

void makeLevel(Document& document) {
    if (isLevel(document)) return;
    const Bounds all = interestingBounds(document.world())
                           .value_or(Bounds{{-4, floorHeight(document.world())},
                                            {4, floorHeight(document.world()) + 1}});
    const Point low = all.low - Point(2, 1.5), high = all.high + Point(2, 3);
    const double floor = all.low.y() + 0.4;
    document.planForEditing().settings.tickRate = 500;
    document.setLevelText(
        "{\n    \"name\": \"New Level\",\n    \"number\": 100,\n    \"spawn\": " +
        jsonOf(low.x() + 1, floor) +
        ",\n    \"exit\": {\"position\": " + jsonOf(high.x() - 1, floor) +
        ", \"radius\": 0.6},\n    \"bounds\": {\"min\": " + jsonOf(low.x(), low.y()) +
        ", \"max\": " + jsonOf(high.x(), high.y()) +
        "},\n    \"killDepth\": " + jsonOf(low.y() + 0.3) +
        ",\n    \"medals\": {\"gold\": 12, \"silver\": 20, \"bronze\": 45},\n    \"theme\": "
        "{\"world\": \"dawn\", \"seed\": 1}\n  }");
}

}  // namespace sulfurchamber
