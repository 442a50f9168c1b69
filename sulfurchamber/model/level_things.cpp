// Looking at the things of a level; what changes them is in level_edits.cpp.
#include "level_things.hpp"
#include "words.hpp"

#include <algorithm>
#include <charconv>

namespace sulfurchamber {
namespace {

using sulfur::Point;

// A place below a thing, or nothing.
std::optional<Point> placeAt(const JsonText& text, const JsonPath& thing, std::string_view where) {
    const auto x = text.number(pathOf(pathOf(thing, where), "0"));
    const auto y = text.number(pathOf(pathOf(thing, where), "1"));
    if (!x || !y) return std::nullopt;
    return Point(*x, *y);
}

// Where a body is now, or where the plan has it.
std::optional<Bounds> boundsOfBody(const Document& document, const std::string& id) {
    if (const auto body = document.bodyOf(id)) {
        const auto bounds = document.world().bounds(body);
        return Bounds{bounds.low, bounds.high};
    }
    if (!document.plan().contains(id)) return std::nullopt;
    const Point at = document.plan().body(id).pose.position;
    return Bounds{at, at};
}

Point frameOfBody(const Document& document, const std::string& id) {
    return document.plan().contains(id) ? document.plan().body(id).pose.position : Point(0, 0);
}

void addCorners(LevelShape& shape) {
    const Bounds& b = shape.box;
    shape.handles = {b.low, {b.high.x(), b.low.y()}, b.high, {b.low.x(), b.high.y()}};
}

void shapePoint(LevelShape& shape, const JsonText& text, std::string_view where,
                std::string_view radius, double usual) {
    const JsonPath path = pathOf(shape.thing);
    const auto at = placeAt(text, path, where);
    if (!at) return;
    shape.form = LevelShape::Form::point;
    shape.at = *at;
    if (radius.empty()) return;
    shape.radius = text.number(pathOf(path, radius)).value_or(usual);
    shape.handles = {shape.at + Point(shape.radius, 0)};
}

void shapeBox(LevelShape& shape, const JsonText& text) {
    const auto low = placeAt(text, pathOf(shape.thing), "min");
    const auto high = placeAt(text, pathOf(shape.thing), "max");
    if (!low || !high) return;
    shape.form = LevelShape::Form::rectangle;
    shape.box = {*low, *high};
    shape.at = {low->x(), high->y()};
    addCorners(shape);
}

void shapeTrigger(LevelShape& shape, const JsonText& text) {
    const auto at = placeAt(text, pathOf(shape.thing), "position");
    const auto size = placeAt(text, pathOf(shape.thing), "size");
    if (!at || !size) return;
    shape.form = LevelShape::Form::rectangle;
    shape.box = {*at - *size / 2, *at + *size / 2};
    shape.at = {shape.box.low.x(), shape.box.high.y()};
    addCorners(shape);
}

// What is said of a body stands where that is.
void shapeOfBody(LevelShape& shape, const Document& document, const JsonText& text) {
    const std::string id = bodyOf(document, shape.thing);
    const auto bounds = boundsOfBody(document, id);
    if (!bounds) return;
    const JsonPath path = pathOf(shape.thing);
    shape.form = LevelShape::Form::point;
    shape.at = bounds->centre();
    if (shape.thing.kind == LevelKind::mover) {
        shape.way.push_back(frameOfBody(document, id));
        for (std::size_t i = 0; i < text.size(pathOf(path, "path")); ++i)
            if (const auto at = placeAt(text, path, "path." + std::to_string(i)))
                shape.way.push_back(*at);
        shape.handles.assign(shape.way.begin() + 1, shape.way.end());
        shape.form = LevelShape::Form::way;
    }
    if (shape.thing.kind != LevelKind::monster) return;
    const auto from = text.number(pathOf(path, "between.0"));
    const auto to = text.number(pathOf(path, "between.1"));
    if (!from || !to) return;
    shape.form = LevelShape::Form::way;
    shape.way = {{*from, shape.at.y()}, {*to, shape.at.y()}};
    shape.handles = shape.way;
}

std::string wordsOf(const JsonText& text, const LevelThing& thing) {
    const JsonPath path = pathOf(thing);
    for (const char* member : {"id", "body", "text"})
        if (const auto word = text.string(pathOf(path, member))) return *word;
    return thing.key;
}

std::string pointsText(const JsonText& text, const JsonPath& path) {
    std::string made;
    for (std::size_t i = 0; i < text.size(path); ++i) {
        const auto at = placeAt(text, path, std::to_string(i));
        if (at) made += (made.empty() ? "" : ", ") + jsonOf(at->x()) + ' ' + jsonOf(at->y());
    }
    return made;
}

}  // namespace

bool isLevel(const Document& document) {
    return !document.levelText().empty();
}

JsonPath pathOf(const LevelThing& thing) {
    const LevelKindInfo& info = infoOf(thing.kind);
    JsonPath path;
    if (!info.key.empty()) path.emplace_back(std::string(info.key));
    if (info.list) path.emplace_back(thing.index);
    if (thing.kind == LevelKind::surface) path.emplace_back(thing.key);
    return path;
}

std::vector<LevelThing> levelThings(const Document& document) {
    std::vector<LevelThing> things;
    if (!isLevel(document)) return things;
    const JsonText text(document.levelText());
    for (const LevelKindInfo& info : levelKinds()) {
        const std::string key(info.key);
        if (info.kind == LevelKind::surface) {
            for (std::string& body : text.keys({key}))
                things.push_back({info.kind, 0, std::move(body)});
        } else if (info.list) {
            for (std::size_t i = 0; i < text.size({key}); ++i) things.push_back({info.kind, i, {}});
        } else if (text.has(pathOf({}, key)) || info.kind == LevelKind::theme) {
            things.push_back({info.kind, 0, {}});
        }
    }
    return things;
}

bool contains(const Document& document, const LevelThing& thing) {
    if (!isLevel(document)) return false;
    return thing.kind == LevelKind::theme || JsonText(document.levelText()).has(pathOf(thing));
}

bool isAbout(const std::string& surfaceKey, const std::string& id) {
    if (!surfaceKey.ends_with('*')) return surfaceKey == id;
    return id.starts_with(surfaceKey.substr(0, surfaceKey.size() - 1));
}

std::string bodyOf(const Document& document, const LevelThing& thing) {
    if (thing.kind != LevelKind::surface) {
        if (!infoOf(thing.kind).ofBody) return "";
        return JsonText(document.levelText()).string(pathOf(pathOf(thing), "body")).value_or("");
    }
    if (!thing.key.ends_with('*')) return thing.key;
    for (const auto& body : document.scene().bodies)
        if (isAbout(thing.key, body.id)) return body.id;
    return "";
}

LevelShape shapeOf(const Document& document, const LevelThing& thing) {
    const JsonText text(document.levelText());
    LevelShape shape;
    shape.thing = thing;
    shape.label = wordsOf(text, thing);
    if (shape.label.empty()) shape.label = tr(std::string(infoOf(thing.kind).name));
    switch (thing.kind) {
        case LevelKind::spawn:
            shapePoint(shape, text, "", "", 0);
            break;
        case LevelKind::exit:
            shapePoint(shape, text, "position", "radius", 0.5);
            break;
        case LevelKind::checkpoint:
            shapePoint(shape, text, "position", "radius", 0.5);
            break;
        case LevelKind::hint:
        case LevelKind::pickup:
            shapePoint(shape, text, "position", "", 0);
            break;
        case LevelKind::bounds:
        case LevelKind::zone:
            shapeBox(shape, text);
            break;
        case LevelKind::trigger:
            shapeTrigger(shape, text);
            break;
        case LevelKind::killDepth:
            shape.form = LevelShape::Form::level;
            shape.at = {text.number({"bounds", "min", std::size_t{0}}).value_or(0),
                        text.number({"killDepth"}).value_or(0)};
            break;
        case LevelKind::mover:
        case LevelKind::monster:
        case LevelKind::respawn:
        case LevelKind::surface:
            shapeOfBody(shape, document, text);
            break;
        case LevelKind::medals:
        case LevelKind::theme:
        case LevelKind::rules:
            break;
    }
    return shape;
}

std::string titleOf(const Document& document, const LevelThing& thing) {
    constexpr std::size_t most = 28;  // bytes of what it says
    const std::string title = tr(std::string(infoOf(thing.kind).name));
    std::string words = wordsOf(JsonText(document.levelText()), thing);
    std::replace(words.begin(), words.end(), '\n', ' ');
    if (words.size() > most) {
        std::size_t end = most;
        while ((static_cast<unsigned char>(words[end]) & 0xC0u) == 0x80u) --end;
        words = words.substr(0, end) + "\xE2\x80\xA6";
    }
    return words.empty() ? title : tr("{} \xE2\x80\x9C{}\xE2\x80\x9D", {title, words});
}

std::optional<std::string> fieldText(const Document& document, const LevelThing& thing,
                                     const LevelField& field) {
    const JsonText text(document.levelText());
    const JsonPath whole = pathOf(thing);
    if (!field.needs.empty() && !text.has(pathOf(whole, field.needs))) return std::nullopt;
    const JsonPath path = pathOf(whole, field.path);
    const auto raw = text.get(path);
    if (field.type == FieldType::part) return raw ? "yes" : "no";
    if (!raw) return std::string(field.usual);
    switch (field.type) {
        case FieldType::flag:
            return *raw == "true" ? "yes" : "no";
        case FieldType::points:
            return pointsText(text, path);
        case FieldType::number:
        case FieldType::whole:
            return *raw;
        default:
            return text.string(path).value_or("");
    }
}

}  // namespace sulfurchamber
