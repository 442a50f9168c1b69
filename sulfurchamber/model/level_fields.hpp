// What a level of the game is made of beside its scene: kinds of things, and the fields of each.
// A table that the palette, the panel and the file agree on.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sulfurchamber {

enum class LevelKind : std::uint8_t {
    spawn,
    exit,
    bounds,
    killDepth,
    hint,
    checkpoint,
    pickup,
    zone,
    trigger,
    mover,
    monster,
    respawn,
    surface,
    medals,
    theme,
    rules
};

/// One kind of thing.
struct LevelKindInfo {
    LevelKind kind;
    std::string_view key;   ///< of its member, or of its list
    std::string_view name;  ///< for people
    bool list = false;      ///< one of several in a list
    bool ofBody = false;    ///< says something about a body, and stands where that is
};
std::span<const LevelKindInfo> levelKinds();
const LevelKindInfo& infoOf(LevelKind kind);

/// What a field holds.
enum class FieldType : std::uint8_t {
    number,
    whole,   ///< a number without a fraction
    text,    ///< not empty unless it may be left out
    lines,   ///< a text that may have several lines
    flag,    ///< yes or no
    choice,  ///< one of several words
    part,    ///< an object that is there or not, with the fields that need it
    points,  ///< places one after the other: "3 4, 5 6"
    colour,  ///< "#rrggbb"
};

/// A field of a kind.
struct LevelField {
    LevelKind kind;
    std::string_view path;  ///< from the thing on: "wind.velocity.0"
    std::string_view name;  ///< for people
    std::string_view unit;
    FieldType type = FieldType::number;
    double low = 0;            ///< of numbers
    double high = 0;           ///< of numbers
    std::string_view usual{};  ///< what it is where it is not given, as one types it
    bool optional = false;     ///< it may be left out by an empty text
    std::string_view needs{};  ///< the path of the part to which it belongs
    /// Of a choice: words with a bar between them. Of a part: the JSON with which it begins.
    std::string_view choices{};
    std::string_view help{};
};
/// The words of a choice one by one; nothing for other fields.
std::vector<std::string> choicesOf(const LevelField& field);
/// All fields, those of a kind side by side in the order in which a panel shows them.
std::span<const LevelField> levelFields();
/// Null when the kind has no such field.
const LevelField* levelField(LevelKind kind, std::string_view path);

}  // namespace sulfurchamber
