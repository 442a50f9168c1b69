#include "level_clipboard.hpp"

#include <algorithm>

namespace sulfurchamber {
namespace {

using sulfur::Point;
using Names = std::map<std::string, std::string>;

// Where the numbers of a place stand in an item; a patrol has no height.
struct PlaceInItem {
    JsonPath x;
    std::optional<JsonPath> y;
};

std::vector<PlaceInItem> placesIn(const JsonText& item) {
    std::vector<PlaceInItem> places;
    const auto add = [&](const JsonPath& place) {
        places.push_back({pathOf(place, "0"), pathOf(place, "1")});
    };
    for (const char* corner : {"position", "min", "max"})
        if (item.has({corner})) add({corner});
    for (std::size_t i = 0; i < item.size({"path"}); ++i) add({"path", i});
    for (std::size_t i = 0; i < item.size({"between"}); ++i)
        places.push_back({{"between", i}, std::nullopt});
    return places;
}

void moveItem(JsonText& item, const Point& by) {
    const auto add = [&](const JsonPath& path, double way) {
        if (const auto before = item.number(path)) item.set(path, jsonOf(*before + way));
    };
    for (const PlaceInItem& place : placesIn(item)) {
        add(place.x, by.x());
        if (place.y) add(*place.y, by.y());
    }
}

// An id that others of the list have is counted on.
void freshenId(const Document& document, LevelKind kind, JsonText& item) {
    const auto id = item.string({"id"});
    if (!id) return;
    const auto taken = levelIds(document, kind);
    if (std::find(taken.begin(), taken.end(), *id) == taken.end()) return;
    const std::string base = id->substr(0, id->find_last_not_of("0123456789-") + 1);
    const std::string fresh = freeLevelId(document, kind, base.empty() ? *id : base);
    item.set({"id"}, jsonOf(std::string_view(fresh)));
}

// Lets a member name a body by its other id; false where it names one that has none.
bool renameBody(JsonText& item, const char* member, const Names& bodies) {
    const auto id = item.string({member});
    if (!id) return true;
    const auto found = bodies.find(*id);
    if (found == bodies.end()) return false;
    item.set({member}, jsonOf(std::string_view(found->second)));
    return true;
}

bool isSomebody(const Document& document, const std::string& word) {
    return word == "hero" || word == "rope" || word == "any" || document.plan().contains(word);
}

// The surface of a body: its own one, or that of all whose ids begin so.
std::optional<std::string> surfaceOf(const JsonText& level, const std::string& body) {
    if (auto own = level.get({"surfaces", body})) return own;
    for (const std::string& key : level.keys({"surfaces"}))
        if (isAbout(key, body)) return level.get({"surfaces", key});
    return std::nullopt;
}

void addItem(JsonText& part, const LevelKindInfo& info, const std::string& json) {
    const std::string list(info.key);
    if (!part.has({list})) part.set({list}, "[]");
    part.append({list}, json);
}

void addSurfaces(Document& document, const JsonText& part, const Names& bodies,
                 std::vector<LevelThing>& made) {
    JsonText text(document.levelText());
    for (const std::string& key : part.keys({"surfaces"})) {
        const auto body = bodies.find(key);
        if (body == bodies.end() || surfaceOf(text, body->second)) continue;
        if (!text.has({"surfaces"})) text.set({"surfaces"}, "{}");
        text.set({"surfaces", body->second}, *part.get({"surfaces", key}));
        made.push_back({LevelKind::surface, 0, body->second});
    }
    document.setLevelText(text.text());
}

}  // namespace

bool isCopyable(const Document& document, const LevelThing& thing) {
    const LevelKindInfo& info = infoOf(thing.kind);
    if (!info.ofBody) return info.list;
    return !thing.key.ends_with('*') && document.bodyOf(bodyOf(document, thing));
}

std::string levelPart(const Document& document, const std::vector<LevelThing>& things,
                      const Names& bodies) {
    const JsonText level(document.levelText());
    JsonText part("{}");
    for (const LevelThing& thing : levelThings(document)) {
        const LevelKindInfo& info = infoOf(thing.kind);
        if (!info.list) continue;
        JsonText item(*level.get(pathOf(thing)));
        const bool chosen = std::find(things.begin(), things.end(), thing) != things.end();
        if (info.ofBody ? !renameBody(item, "body", bodies) : !chosen) continue;
        renameBody(item, "by", bodies);
        addItem(part, info, item.text());
    }
    for (const auto& [here, there] : bodies) {
        const auto surface = surfaceOf(level, here);
        if (!surface) continue;
        if (!part.has({"surfaces"})) part.set({"surfaces"}, "{}");
        part.set({"surfaces", there}, *surface);
    }
    return part.text() == "{}" ? "" : part.text();
}

std::optional<Bounds> boundsOfPart(const std::string& part) {
    const JsonText level(part);
    std::optional<Bounds> all;
    for (const LevelKindInfo& info : levelKinds()) {
        if (!info.list || info.ofBody) continue;
        const std::string list(info.key);
        for (std::size_t i = 0; i < level.size({list}); ++i) {
            const JsonText item(*level.get({list, i}));
            for (const PlaceInItem& place : placesIn(item)) {
                const Point at(item.number(place.x).value_or(0), item.number(*place.y).value_or(0));
                if (!all) all = Bounds{at, at};
                all->include(at);
            }
        }
    }
    return all;
}

std::vector<LevelThing> addPart(Document& document, const std::string& part, const Point& by,
                                const Names& bodies) {
    const JsonText level(part);
    std::vector<LevelThing> made;
    for (const LevelKindInfo& info : levelKinds()) {
        const std::string list(info.key);
        for (std::size_t i = 0; info.list && i < level.size({list}); ++i) {
            JsonText item(*level.get({list, i}));
            if (info.ofBody && !renameBody(item, "body", bodies)) continue;
            const auto who = item.string({"by"});
            if (who && !renameBody(item, "by", bodies) && !isSomebody(document, *who))
                item.erase({"by"});
            freshenId(document, info.kind, item);
            moveItem(item, by);
            made.push_back(addThing(document, info.kind, item.text()));
        }
    }
    addSurfaces(document, level, bodies, made);
    return made;
}

}  // namespace sulfurchamber
