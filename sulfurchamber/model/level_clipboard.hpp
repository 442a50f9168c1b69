// Things of a level in a clipboard: a member "level" of its scene that holds no more than them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "level_things.hpp"

namespace sulfurchamber {

/// Whether a copy of a thing can be made: what a level has once cannot be there twice. What is said
/// of a body is copied along with it.
bool isCopyable(const Document& document, const LevelThing& thing);

/// These things, those of them that stand free, and all that the level says of bodies: `bodies` has
/// the ids in the document and those in the clipboard. Empty where that is nothing.
std::string levelPart(const Document& document, const std::vector<LevelThing>& things,
                      const std::map<std::string, std::string>& bodies);

/// Around the places of what stands free in such a text, metres.
std::optional<Bounds> boundsOfPart(const std::string& part);

/// Adds what such a text holds to the level, moved by `by` metres, under free ids; returns it.
/// `bodies` has the ids in the clipboard and those in the document; what is said of others is left
/// out. A part of an edit.
std::vector<LevelThing> addPart(Document& document, const std::string& part,
                                const sulfur::Point& by,
                                const std::map<std::string, std::string>& bodies);

}  // namespace sulfurchamber
