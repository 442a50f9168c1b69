#include "keep_layout.hpp"

#include <algorithm>
#include <sulfur/scene.hpp>
#include <vector>

#include "json_text.hpp"

namespace sulfurchamber {
namespace {

JsonPath under(JsonPath path, JsonStep step) {
    path.push_back(std::move(step));
    return path;
}

// The ids of the items of a list, in their order.
std::vector<std::string> idsIn(const JsonText& text, const JsonPath& list) {
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < text.size(list); ++i)
        ids.push_back(text.string(under(under(list, i), "id")).value_or(""));
    return ids;
}

void mergeMembers(JsonText& made, const JsonText& before, const JsonText& now,
                  const JsonPath& object) {
    const auto keys = now.keys(object);
    for (const std::string& key : keys) {
        const JsonPath path = under(object, key);
        const auto value = now.get(path);
        if (before.get(path) != value) made.set(path, *value);
    }
    for (const std::string& key : before.keys(object))
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) made.erase(under(object, key));
}

void mergeItems(JsonText& made, const JsonText& before, const JsonText& now, const JsonPath& list) {
    auto ids = idsIn(made, list);
    const auto oldIds = idsIn(before, list);
    const auto newIds = idsIn(now, list);
    const auto placeIn = [](const std::vector<std::string>& all, const std::string& id) {
        return static_cast<std::size_t>(std::find(all.begin(), all.end(), id) - all.begin());
    };
    for (std::size_t i = ids.size(); i-- > 0;) {
        if (placeIn(newIds, ids[i]) < newIds.size()) continue;
        made.erase(under(list, i));
        ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(i));
    }
    for (std::size_t i = 0; i < newIds.size(); ++i) {
        const std::string item = *now.get(under(list, i));
        const std::size_t place = placeIn(ids, newIds[i]);
        if (place == ids.size()) {
            made.append(list, item);
            ids.push_back(newIds[i]);
        } else if (before.get(under(list, placeIn(oldIds, newIds[i]))) != item) {
            made.set(under(list, place), item);
        }
    }
}

std::string merged(const std::string& file, const std::string& before, const std::string& now) {
    JsonText made(file);
    const JsonText old(before), fresh(now);
    const auto keys = fresh.keys({});
    for (const std::string& key : keys) {
        const auto value = fresh.get({key});
        if (old.get({key}) == value) continue;
        const bool both = made.has({key}) && old.has({key});
        if (both && key == "blueprints")
            mergeMembers(made, old, fresh, {key});
        else if (both && key == "bodies")
            mergeItems(made, old, fresh, {key});
        else
            made.set({key}, *value);
    }
    for (const std::string& key : old.keys({}))
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) made.erase({key});
    return made.text();
}

}  // namespace

std::string keepLayout(const std::string& file, const std::string& before, const std::string& now) {
    if (before == now) return file;
    try {
        std::string made = merged(file, before, now);
        if (sulfur::scene::format(sulfur::scene::parse(made, "the scene")) == now) return made;
    } catch (const std::exception&) {
        // It cannot be kept: the program's own layout says the same.
    }
    return now;
}

}  // namespace sulfurchamber
