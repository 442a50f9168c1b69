/// \file
/// What a reader does not know: kept, so that it can be written back.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sulfur::scene {

/// A member of a JSON object that sulfur::scene has no use for.
struct ExtraMember {
    std::string key;   ///< its name
    std::string json;  ///< the value exactly as it was written
    int line = 0;      ///< of the file it was read from, counted from 1
};

/// Members in the order of the file.
using Extra = std::vector<ExtraMember>;

/// Extra members of the parts of one object by the path of the part: "" is the object itself,
/// others are such as "material" or "particles[3]".
using ExtraTree = std::map<std::string, Extra>;

/// The member called `key`, or null.
const ExtraMember* findExtra(const Extra& extra, std::string_view key);
/// Adds a member or replaces it. Throws ReadError unless `json` is one JSON value.
void setExtra(Extra& extra, std::string_view key, std::string json);
/// Removes a member if it is there.
void eraseExtra(Extra& extra, std::string_view key);

}  // namespace sulfur::scene
