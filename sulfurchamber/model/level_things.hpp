// The things of a level: where they are, how they are moved and changed. All that is read and
// written is the text of the member "level"; what is not touched keeps its bytes.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "document.hpp"
#include "json_text.hpp"
#include "level_fields.hpp"

namespace sulfurchamber {

/// One thing of a level, by its place in the file.
struct LevelThing {
    LevelKind kind = LevelKind::spawn;
    std::size_t index = 0;  ///< in its list
    std::string key;        ///< of a surface: its body, or the beginning of ids and a star

    friend auto operator<=>(const LevelThing&, const LevelThing&) = default;
};

/// How a thing is seen in the picture.
struct LevelShape {
    enum class Form : std::uint8_t {
        none,       ///< nowhere: it has fields only
        point,      ///< a mark, with a circle around it where it has a radius
        rectangle,  ///< its corners are handles
        level,      ///< a height
        way,        ///< places one after the other, which are handles
    };
    LevelThing thing;
    Form form = Form::none;
    sulfur::Point at{0, 0};              ///< of the mark, metres
    double radius = 0;                   ///< metres; 0: none
    Bounds box;                          ///< of a rectangle
    std::vector<sulfur::Point> way;      ///< of a way; the first is where the body is
    std::vector<sulfur::Point> handles;  ///< what is dragged to change its size
    std::string label;                   ///< a few words for people
};

bool isLevel(const Document& document);
/// All things, in the order of the kinds. Empty where the scene is no level.
std::vector<LevelThing> levelThings(const Document& document);
/// Whether the thing is there still.
bool contains(const Document& document, const LevelThing& thing);
/// The way to it in the text of the level.
JsonPath pathOf(const LevelThing& thing);
LevelShape shapeOf(const Document& document, const LevelThing& thing);
/// Whether a surface is about a body: its key is the body's id, or its beginning and a star.
bool isAbout(const std::string& surfaceKey, const std::string& id);
/// "Zone “lake”", for lists.
std::string titleOf(const Document& document, const LevelThing& thing);
/// The id of the body that a thing is about; "" where it is about none.
std::string bodyOf(const Document& document, const LevelThing& thing);

/// What a field says, as one types it: numbers, words, "yes" and "no", places as "3 4, 5 6". What
/// is not given is the usual. Nothing where the field means nothing, because the part that it
/// belongs to is not there.
std::optional<std::string> fieldText(const Document& document, const LevelThing& thing,
                                     const LevelField& field);

// -- changing, inside of an edit of the document --

/// Sets a field from what one typed. Throws std::runtime_error with what is allowed.
void setField(Document& document, const LevelThing& thing, const LevelField& field,
              const std::string& text);
/// Moves all of it, metres. What stands where its body is does not move.
void moveThing(Document& document, const LevelThing& thing, const sulfur::Point& by);
/// Puts one of the handles of its shape at a place.
void dragHandle(Document& document, const LevelThing& thing, std::size_t handle,
                const sulfur::Point& to);
/// Whether a level can be without it.
bool isRemovable(const LevelThing& thing);
/// Takes things out, if they are removable.
void removeThings(Document& document, std::vector<LevelThing> things);
/// Adds an item to the list of a kind, which is made if it is not there; returns it.
LevelThing addThing(Document& document, LevelKind kind, const std::string& json);
/// The ids of the items of a list, in order; "" for those without.
std::vector<std::string> levelIds(const Document& document, LevelKind kind);
/// `base`-1, `base`-2, ...: the first id that no item of the list has.
std::string freeLevelId(const Document& document, LevelKind kind, const std::string& base);
/// Takes out all that is said about bodies that are about to go.
void forgetBodies(Document& document, const std::vector<std::string>& ids);
/// Lets all that names a body name it by another id.
void renameInLevel(Document& document, const std::string& from, const std::string& to);

}  // namespace sulfurchamber
