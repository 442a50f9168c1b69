// Instances of templates: placed, compared with their template, and led after it when it changes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "document.hpp"
#include "templates.hpp"

namespace sulfurchamber {

/// How a part of an instance differs from its template.
struct Override {
    std::string key;   ///< "mass", "colour", "place", ...
    std::string name;  ///< for people
};

/// What differs of a body that is a part of an instance, "" where nothing does or where it is none.
/// A part that was deleted, and ties between parts, are not told here. Complexity: linear in the
/// template and the instance.
std::vector<Override> overridesOf(const Document& document, const std::string& id);
/// How many there are in an instance, with parts that were deleted and ties that differ.
std::size_t overrideCount(const Document& document, const std::string& instance);

// All of these are a part of the open edit.

/// Adds an instance, with the middle of its lower edge at a place; higher where something fixed
/// would be inside of it. A scene that knows a template of this name keeps following its own one.
std::vector<sulfur::BodyId> placeTemplate(Document& document, const Template& made,
                                          const sulfur::Point& at);
/// Makes a template of bodies as they were built, with what ties them to each other; they become
/// its first instance. Throws std::runtime_error when none of them was built, or when the name is
/// unusable or taken in this scene.
Template makeTemplate(Document& document, const std::vector<sulfur::BodyId>& bodies,
                      const std::string& name, const std::string& category);
/// What the template would be if it followed an instance. Throws std::runtime_error when the scene
/// has no such instance.
Template templateFrom(const Document& document, const std::string& instance);
/// Replaces a template of the scene. All its instances follow: each keeps its pose and what was
/// changed of it alone. What is running goes back to how it was built.
void changeTemplate(Document& document, const Template& next);
/// Gives a part back what its template has; all that differs where the key is empty.
void resetOverride(Document& document, const std::string& id, const std::string& key);
/// Gives the template what the part has; the other instances follow.
Template applyOverride(Document& document, const std::string& id, const std::string& key);
/// Makes instances independent: they no longer follow.
void unlink(Document& document, const std::vector<std::string>& instances);
/// The instances to which these bodies belong.
std::vector<std::string> instancesOf(const Document& document,
                                     const std::vector<sulfur::BodyId>& bodies);

/// Gives instances among new bodies names of their own, where others have theirs already.
void renameInstances(sulfur::scene::Scene& scene, const std::vector<std::string>& newBodies);

}  // namespace sulfurchamber
