// The published schema is about the same members as the reader.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "keys.hpp"
#include "samples.hpp"

namespace {

using namespace sulfur::scene;
using namespace sulfur::scene::testing;
using Json = nlohmann::json;

Json schema() {
    return Json::parse(std::ifstream(SULFUR_SCENE_SCHEMA));
}

TEST(Schema, ListsExactlyTheKeysOfTheReader) {
    const Json defs = schema().at("$defs");
    for (const auto part : parts()) {
        std::set<std::string> published, known;
        for (const auto& [key, value] : defs.at(std::string(part)).at("properties").items())
            published.insert(key);
        for (const auto key : keysOf(part)) known.insert(std::string(key));
        EXPECT_EQ(published, known) << part;
    }
    for (const auto& [name, definition] : defs.items()) {
        if (!definition.contains("properties")) continue;
        EXPECT_NE(std::find(parts().begin(), parts().end(), name), parts().end()) << name;
    }
}

TEST(Schema, EveryReferenceLeadsSomewhere) {
    const Json all = schema();
    EXPECT_EQ(all.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
    const Json flat = all.flatten();
    for (const auto& [path, value] : flat.items()) {
        if (!path.ends_with("/$ref")) continue;
        EXPECT_TRUE(all.contains(Json::json_pointer(value.get<std::string>().substr(1)))) << value;
    }
}

/// Places in the full scene where an object of each part is.
const std::map<std::string, std::string> places{
    {"scene", ""},
    {"world", "/world"},
    {"explicit", "/blueprints/plain"},
    {"particle", "/blueprints/plain/particles/0"},
    {"joint", "/blueprints/plain/joints/0"},
    {"angle", "/blueprints/plain/angles/0"},
    {"material", "/blueprints/plain/material"},
    {"filter", "/blueprints/plain/filter"},
    {"skin", "/blueprints/plain/skin"},
    {"floor", "/blueprints/floor"},
    {"ground", "/blueprints/ground"},
    {"box", "/blueprints/box"},
    {"ball", "/blueprints/ball"},
    {"rope", "/blueprints/rope"},
    {"jelly", "/blueprints/jelly"},
    {"blob", "/blueprints/blob"},
    {"polygon", "/blueprints/polygon"},
    {"wheel", "/blueprints/wheel"},
    {"chain", "/blueprints/chain"},
    {"bridge", "/blueprints/bridge"},
    {"cloth", "/blueprints/cloth"},
    {"wall", "/blueprints/wall"},
    {"body", "/bodies/1"},
    {"state", "/bodies/4/state"},
    {"connection", "/connections/0"},
    {"attachment", "/attachments/0"},
    {"uniformField", "/fields/0"},
    {"boxZone", "/fields/0/zone"},
    {"radialField", "/fields/1"},
    {"windField", "/fields/2"},
    {"circleZone", "/fields/2/zone"},
    {"hingeMechanism", "/mechanisms/0"},
    {"drive", "/mechanisms/0/drive"},
    {"weldMechanism", "/mechanisms/1"},
    {"sliderMechanism", "/mechanisms/2"},
    {"wheelMechanism", "/mechanisms/3"},
    {"distanceMechanism", "/mechanisms/4"},
    {"pulleyMechanism", "/mechanisms/5"},
    {"gearMechanism", "/mechanisms/6"},
};

TEST(Schema, EveryListedKeyIsReallyRead) {
    const Json full = Json::parse(fullScene);
    for (const auto part : parts()) {
        if (part == "blueprintFile") continue;
        const Json::json_pointer place(places.at(std::string(part)));
        for (const auto key : keysOf(part)) {
            Json changed = full;
            // No member of the format is ever an array with a null in it.
            changed[place][std::string(key)] = Json::array({nullptr});
            EXPECT_NE(errorOf(changed.dump()).message(), "") << part << '.' << key;
        }
        Json changed = full;
        changed[place]["unheard-of"] = Json::array({nullptr});
        EXPECT_EQ(errorOf(changed.dump()).message(), "") << part;
    }
}

TEST(Schema, BoundsAreTheReaders) {
    // Just beyond each published bound of a plain number the reader refuses; on it, it does not
    // complain about this member's range.
    const Json defs = schema().at("$defs");
    const Json full = Json::parse(fullScene);
    int checked = 0;
    for (const auto& [part, place] : places) {
        for (const auto& [key, published] : defs.at(part).at("properties").items()) {
            if (!published.contains("maximum")) continue;
            Json changed = full;
            const Json::json_pointer at(place + '/' + key);
            const double high = published.at("maximum");
            const bool whole = published.at("type") == "integer";
            changed[at] = whole ? Json(static_cast<std::int64_t>(high) + 1) : Json(high * 1.001);
            EXPECT_NE(errorOf(changed.dump()).message().find(key), std::string::npos) << at;
            const bool open = published.contains("exclusiveMinimum");
            const double low = published.at(open ? "exclusiveMinimum" : "minimum");
            changed[at] =
                whole ? Json(static_cast<std::int64_t>(low) - 1) : Json(open ? low : low - 0.001);
            EXPECT_NE(errorOf(changed.dump()).message(), "") << at;
            ++checked;
        }
    }
    EXPECT_GT(checked, 35);
}

}  // namespace
