// Changing the things of a level.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "level_things.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

constexpr double leastSide = 0.05;  // metres, of zones and switches

std::string stripped(const std::string& text) {
    const auto begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

[[noreturn]] void refuseField(const LevelField& field, const std::string& allowed) {
    throw std::runtime_error(tr("{}, {}: allowed is {}", {tr(std::string(infoOf(field.kind).name)),
                                                          tr(std::string(field.name)), allowed}));
}

double numberOf(const LevelField& field, const std::string& text) {
    double value = 0;
    const auto end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    const bool whole = field.type != FieldType::whole || value == std::floor(value);
    const bool fits = read.ec == std::errc() && read.ptr == end && whole;
    if (fits && value >= field.low && value <= field.high) return value;
    const std::string high =
        jsonOf(field.high) + (field.unit.empty() ? "" : ' ' + std::string(field.unit));
    refuseField(field, field.type == FieldType::whole
                           ? tr("a whole number from {} to {}", {jsonOf(field.low), high})
                           : tr("a number from {} to {}", {jsonOf(field.low), high}));
}

std::string pointsJson(const LevelField& field, const std::string& text) {
    LevelField number = field;
    number.type = FieldType::number;
    number.low = -1000;
    number.high = 1000;
    std::string made = "[";
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string pair = stripped(text.substr(at, comma - at));
        const std::size_t space = pair.find(' ');
        if (space == std::string::npos) refuseField(field, tr("places such as 3 4, 5 6 in metres"));
        const double x = numberOf(number, pair.substr(0, space));
        const double y = numberOf(number, stripped(pair.substr(space)));
        made += (made.size() > 1 ? ", " : "") + jsonOf(x, y);
        at = comma + 1;
    }
    return made + ']';
}

std::string choiceJson(const LevelField& field, const std::string& text) {
    std::string allowed;
    for (const std::string& word : choicesOf(field)) {
        if (word == text) return jsonOf(std::string_view(text));
        allowed += (allowed.empty() ? "" : ", ") + word;
    }
    refuseField(field, tr("one of: {}", {allowed}));
}

std::string colourJson(const LevelField& field, const std::string& text) {
    const bool shaped = text.size() == 7 && text[0] == '#' &&
                        text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!shaped) refuseField(field, tr("a colour such as #1F3A5F"));
    return jsonOf(std::string_view(text));
}

std::string textJson(const LevelField& field, const std::string& text) {
    if (text.empty() || static_cast<double>(text.size()) > field.high)
        refuseField(field, tr("a text of 1 to {} bytes", {jsonOf(field.high)}));
    return jsonOf(std::string_view(text));
}

std::string jsonOfField(const LevelField& field, const std::string& text) {
    switch (field.type) {
        case FieldType::number:
        case FieldType::whole:
            return jsonOf(numberOf(field, text));
        case FieldType::flag:
            if (text != "yes" && text != "no") refuseField(field, tr("yes or no"));
            return text == "yes" ? "true" : "false";
        case FieldType::choice:
            return choiceJson(field, text);
        case FieldType::points:
            return pointsJson(field, text);
        case FieldType::colour:
            return colourJson(field, text);
        case FieldType::part:
        case FieldType::text:
        case FieldType::lines:
            break;
    }
    return textJson(field, text);
}

// With what a part begins that is switched on.
std::string partJson(const Document& document, const LevelThing& thing, const LevelField& field) {
    if (!field.choices.empty()) return std::string(field.choices);
    const double x = shapeOf(document, thing).at.x();
    return jsonOf(x - 1, x + 1);  // a patrol, about where the monster is
}

void setPlace(JsonText& text, const JsonPath& thing, std::string_view where, const Point& to) {
    text.set(pathOf(thing, where.empty() ? "0" : std::string(where) + ".0"), jsonOf(to.x()));
    text.set(pathOf(thing, where.empty() ? "1" : std::string(where) + ".1"), jsonOf(to.y()));
}

void setNumber(JsonText& text, const JsonPath& thing, std::string_view where, double to) {
    text.set(pathOf(thing, where), jsonOf(to));
}

// The corner opposite to the one that is dragged stays.
Bounds withCorner(const Bounds& box, std::size_t corner, const Point& to, double least) {
    Bounds made = box;
    const bool left = corner == 0 || corner == 3;
    const bool low = corner < 2;
    if (left)
        made.low.x() = std::min(to.x(), box.high.x() - least);
    else
        made.high.x() = std::max(to.x(), box.low.x() + least);
    if (low)
        made.low.y() = std::min(to.y(), box.high.y() - least);
    else
        made.high.y() = std::max(to.y(), box.low.y() + least);
    return made;
}

void setBox(JsonText& text, const LevelThing& thing, const Bounds& box) {
    const JsonPath path = pathOf(thing);
    if (thing.kind == LevelKind::trigger) {
        setPlace(text, path, "position", box.centre());
        setPlace(text, path, "size", box.size());
        return;
    }
    setPlace(text, path, "min", box.low);
    setPlace(text, path, "max", box.high);
}

}  // namespace

std::vector<std::string> levelIds(const Document& document, LevelKind kind) {
    std::vector<std::string> ids;
    const JsonText text(document.levelText());
    const std::string key(infoOf(kind).key);
    for (std::size_t i = 0; i < text.size({key}); ++i)
        ids.push_back(text.string({key, i, "id"}).value_or(""));
    return ids;
}

void setField(Document& document, const LevelThing& thing, const LevelField& field,
              const std::string& typed) {
    const std::string words = stripped(typed);
    JsonText text(document.levelText());
    const JsonPath path = pathOf(pathOf(thing), field.path);
    const bool off = field.type == FieldType::part && words == "no";
    if (off || (words.empty() && field.optional)) {
        text.erase(path);
    } else if (field.type == FieldType::part) {
        if (!text.has(path)) text.set(path, partJson(document, thing, field));
    } else {
        const std::string json = jsonOfField(field, words);
        if (thing.kind == LevelKind::theme && !text.has(pathOf(thing)))
            text.set(pathOf(thing), "{}");
        text.set(path, json);
    }
    document.setLevelText(text.text());
}

void moveThing(Document& document, const LevelThing& thing, const Point& by) {
    const LevelShape shape = shapeOf(document, thing);
    const JsonPath path = pathOf(thing);
    JsonText text(document.levelText());
    switch (thing.kind) {
        case LevelKind::spawn:
            setPlace(text, path, "", shape.at + by);
            break;
        case LevelKind::exit:
        case LevelKind::hint:
        case LevelKind::checkpoint:
        case LevelKind::pickup:
            setPlace(text, path, "position", shape.at + by);
            break;
        case LevelKind::trigger:
            setPlace(text, path, "position", shape.box.centre() + by);
            break;
        case LevelKind::bounds:
        case LevelKind::zone:
            setBox(text, thing, {shape.box.low + by, shape.box.high + by});
            break;
        case LevelKind::killDepth:
            text.set(path, jsonOf(shape.at.y() + by.y()));
            break;
        default:
            return;
    }
    document.setLevelText(text.text());
}

void dragHandle(Document& document, const LevelThing& thing, std::size_t handle, const Point& to) {
    const LevelShape shape = shapeOf(document, thing);
    if (handle >= shape.handles.size()) return;
    const JsonPath path = pathOf(thing);
    JsonText text(document.levelText());
    switch (thing.kind) {
        case LevelKind::exit:
            setNumber(text, path, "radius", std::clamp((to - shape.at).norm(), 0.1, 10.0));
            break;
        case LevelKind::checkpoint:
            setNumber(text, path, "radius", std::clamp((to - shape.at).norm(), 0.1, 50.0));
            break;
        case LevelKind::bounds:
            setBox(text, thing, withCorner(shape.box, handle, to, 1));
            break;
        case LevelKind::zone:
        case LevelKind::trigger:
            setBox(text, thing, withCorner(shape.box, handle, to, leastSide));
            break;
        case LevelKind::mover:
            setPlace(text, path, "path." + std::to_string(handle), to);
            break;
        case LevelKind::monster: {
            const double other = shape.handles[1 - handle].x();
            const double x =
                handle == 0 ? std::min(to.x(), other - 0.1) : std::max(to.x(), other + 0.1);
            setNumber(text, path, handle == 0 ? "between.0" : "between.1", x);
            break;
        }
        default:
            return;
    }
    document.setLevelText(text.text());
}

// --- coming and going ------------------------------------------------------------------------

bool isRemovable(const LevelThing& thing) {
    return infoOf(thing.kind).list || thing.kind == LevelKind::surface;
}

void removeThings(Document& document, std::vector<LevelThing> things) {
    JsonText text(document.levelText());
    // The last of a list first: places of the others stay.
    std::sort(things.rbegin(), things.rend());
    for (const LevelThing& thing : things) {
        if (!isRemovable(thing)) continue;
        text.erase(pathOf(thing));
        const std::string list(infoOf(thing.kind).key);
        if (text.size({list}) == 0) text.erase({list});
    }
    document.setLevelText(text.text());
}

LevelThing addThing(Document& document, LevelKind kind, const std::string& json) {
    JsonText text(document.levelText());
    const std::string list(infoOf(kind).key);
    if (!text.has({list})) text.set({list}, "[]");
    text.append({list}, json);
    document.setLevelText(text.text());
    return {kind, text.size({list}) - 1, {}};
}

std::string freeLevelId(const Document& document, LevelKind kind, const std::string& base) {
    const auto taken = levelIds(document, kind);
    for (int n = 1;; ++n) {
        std::string id = base + '-' + std::to_string(n);
        if (std::find(taken.begin(), taken.end(), id) == taken.end()) return id;
    }
}

void forgetBodies(Document& document, const std::vector<std::string>& ids) {
    std::vector<LevelThing> gone;
    for (const LevelThing& thing : levelThings(document)) {
        if (!infoOf(thing.kind).ofBody || thing.key.ends_with('*')) continue;
        const std::string body = bodyOf(document, thing);
        if (std::find(ids.begin(), ids.end(), body) != ids.end()) gone.push_back(thing);
    }
    if (!gone.empty()) removeThings(document, std::move(gone));
}

void renameInLevel(Document& document, const std::string& from, const std::string& to) {
    if (!isLevel(document)) return;
    JsonText text(document.levelText());
    const std::string json = jsonOf(std::string_view(to));
    if (text.has({"surfaces", from})) text.rename({"surfaces", from}, to);
    for (const LevelKindInfo& info : levelKinds()) {
        if (!info.list) continue;
        const std::string list(info.key);
        const char* member = info.kind == LevelKind::trigger ? "by" : "body";
        for (std::size_t i = 0; i < text.size({list}); ++i)
            if (text.string({list, i, member}) == from) text.set({list, i, member}, json);
    }
    if (text.text() != document.levelText()) document.setLevelText(text.text());
}

}  // namespace sulfurchamber
