#include "refusals.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <vector>

#include "words.hpp"

namespace sulfurchamber {
namespace {

constexpr std::string_view patternsOfRefusals[] = {
    // --- values of a file ---
    "object \"{}\"",
    "null",
    "a boolean",
    "a number",
    "a string",
    "an array",
    "an object",
    "is {}; allowed is {}",
    "is {}; allowed is {} to {}",
    "is {}; allowed is true or false",
    "is {}; allowed is a number: more than 0, at most {}",
    "is {}; allowed is more than 0, at most {}",
    "is {}; allowed is a number from {} to {}",
    "is {}; allowed is a whole number from {} to {}",
    "is {}; allowed is a string of {} to {} bytes",
    "has {} bytes; allowed is a string of {} to {} bytes",
    "contains a control character; allowed are letters, line breaks and tabs",
    "is {}; allowed is one of {}",
    "is {}; allowed is an array of {} to {}",
    "is {}; allowed is an array of {}",
    "has {} members; allowed is an array of {} to {}",
    "has {} members; allowed is an array of {}",
    "is {}; allowed is an object, {...}",
    "has no \"{}\"; needed is one",
    "is \"{}\"; allowed is a relative path such as \"crate.png\" without \"..\", \"\\\" and \":\"",
    "is neither a number nor \"{}\"; allowed is a number of at least 0, or \"{}\"",
    "contains a line break or a tab; allowed is one line",
    "is {}; allowed is 1, the only version that this program reads",
    // --- text of a file ---
    "contains a zero byte; allowed is JSON text in UTF-8",
    "has more than {} values; split the file or make it simpler",
    "arrays and objects are more than {} deep inside each other; make it flatter",
    "the key \"{}\" is there twice in one object, first on line {}; remove one",
    "has {} bytes; allowed are at most {}",
    "has more than {} bytes; allowed are at most {}",
    "unknown key \"{}\"; it is kept but means nothing here",
    "is not there; check the name of the file",
    "is a folder; needed is a file",
    "is a pipe; needed is a file",
    "cannot be opened; check its permissions",
    "cannot be read to its end; check the disk",
    "is not JSON",
    "is not JSON: {}",
    "the text ends in the middle; it is cut off, so take a complete copy of the file",
    "a number is beyond 1.8e308; allowed are finite numbers",
    "{}; nothing was changed, choose another place or make room",
    "is a link that leads nowhere",
    "cannot be written: {}",
    "cannot be brought to the disk: {}",
    "cannot be replaced: {}",
    "is a folder; needed is the name of a file",
    "is no regular file; allowed is a file, or a name that is free",
    "cannot be opened: {}",
    "cannot be read: {}",
    "No such file or directory",
    "Permission denied",
    "No space left on device",
    "Read-only file system",
    "Not a directory",
    "is not a regular file",
    "is larger than the {} bytes allowed here",
    "its folder cannot be made: {}",
    // --- blueprints ---
    "staticFriction is less than kineticFriction; allowed is the same or more",
    "joins particle {} to itself; allowed are two different particles",
    "has length 0; a rigid joint or one with a radius needs two particles that are apart, or a "
    "restLength above 0",
    "is of a joint that is not rigid or has no radius; allowed is one of a rigid joint with a "
    "radius",
    "names a particle twice; allowed are three different particles",
    "has its corner b where a or c stands; allowed are places that differ",
    "lower is above upper; allowed is the same or less",
    "columns times rows are {} particles; allowed are at most {}",
    "particle {} has less than 1e-9 kg; allowed is 1e-9 to 1e9 for each particle",
    "has neither \"shape\" nor \"particles\"; needed is one of them",
    "is too large; allowed are at most 24000 particles and 72000 joints",
    "has an unusable name; allowed is one line of 1 to {} bytes",
    "the generator is empty; allowed is one of the ready-made shapes",
    // --- bodies and what ties them ---
    "brings the {} to {} particles; allowed are at most {}",
    "brings the {} to {} joints; allowed are at most {}",
    "airFriction is more than tickRate; allowed is 0 to tickRate",
    "is the id of the body on line {} too; allowed is each id once",
    "is \"{}\"; allowed is a name from \"blueprints\"",
    "is given to a fixed body; allowed are dynamic and kinematic ones",
    "is given to a body of {} particles; allowed are those of one",
    "a particle is at [{}, {}]; allowed are world coordinates from -1000 to 1000",
    "is \"{}\"; allowed is the id of a body in \"bodies\"",
    "joins a particle to itself; allowed are two different particles",
    "joins two particles that cannot move; allowed is at least one of a dynamic body",
    "has length 0; a rigid joint or one with a radius needs two particles that are apart, or a "
    "restLength above 0; to hold them together use \"attachments\"",
    "holds a particle at its own body; allowed is another body",
    "names \"{}\" twice; allowed are two different bodies",
    "drag is more than the world's tickRate; allowed is 0 to tickRate",
    "couples \"{}\" with itself; allowed are two mechanisms",
    "is the id of the mechanism on line {} too; allowed is each id once",
    "joins \"{}\" to itself; allowed are two bodies",
    "joins two bodies that cannot move; allowed is at least one that is dynamic",
    "is \"{}\"; allowed is the id of a mechanism before this one",
    "is \"{}\", a gear; allowed are all other mechanisms",
    "cannot be made: {}",
    "is not the id of a body of the scene",
    "is not the id of a mechanism before the gear that names it",
    "has no particle {}; allowed is 0 to {}",
    "state has not one position and one velocity for each of the {} particles",
    "blueprint \"{}\" is not among the scene's blueprints",
    "has neither \"low\" and \"high\" nor \"centre\"; needed is one of them",
    "has a low corner that is not below its high corner; allowed is an extent on both axes",
    "is 0; allowed is more than 0, or \"{}\"",
    "is [0, 0]; allowed is any other vector",
    "has an upper limit of 0 or less; allowed is more than 0, and a hinge for points that meet",
    "is too near 0; allowed is 1e-6 to 1e6, or the same below 0",
    // --- the physics ---
    "{} is {}; allowed is {} to {}",
    "{} is {}; allowed is a finite number",
    "{} is {}; allowed is more than 0",
    "{} is {}; allowed is 0 to infinity",
    "{} of {} kg beside {} kg in what is tied together; allowed is a ratio of at most {}",
    "particle {}",
    "joint {}",
    "angle {}",
    "particle mass",
    "kinetic friction",
    "static friction",
    "restitution",
    "surface speed",
    "rolling resistance",
    "air friction",
    "rest angle",
    "its bodies and those of mechanisms before it have {} particles, each body counted for each of "
    "its mechanisms; allowed are at most {}",
    "rest length",
    "stiffness",
    "damping",
    "mass",
    "radius",
    "strength",
    "position",
    "gravity scale",
    "rest length is 0; a rigid or colliding joint needs more than 0",
    "a particle cannot be attached to itself; allowed is a point of another body",
    "a joint from a particle to itself; allowed are two different particles",
    "a joint between two particles that never move; at least one must be of a dynamic body",
    "refers to particle {}; allowed is 0 to {}",
    "is bent; allowed is that of rigid joints with a radius",
    "has its corner where a neighbour stands; allowed are particles that are apart",
    "has {} texture coordinates; needed is one for each of the {} particles",
    "triangle refers to particle {}; allowed is 0 to {}",
    "blueprint has no particles; needed is at least one",
    "a fixed body cannot have a velocity; allowed are dynamic and kinematic ones",
    "a joint of rest length 0 cannot be rigid; allowed is a finite stiffness",
    "a joint whose capsule is bent is rigid; allowed is an infinite stiffness",
    "the zone's low corner is not below its high corner; allowed is a box with an extent on both "
    "axes",
    "a mechanism between a body and itself; allowed are two bodies",
    "a mechanism between two bodies that physics does not move; at least one must be dynamic",
    "the particles of {} cannot hold that point; allowed are places of its particles (of a ball: "
    "its centre), on the line between two of them, or within some fifty sizes of a body that is no "
    "line",
    "the first body",
    "the second body",
    "the axis is zero; allowed is any other vector",
    "the rail has no joint; allowed is at least one",
    "joint {} of the rail refers to nothing; allowed is one that is there",
    "joint {} of the rail is not of the first body; allowed are joints of that body",
    "a joint is in the rail twice; allowed is each joint once",
    "joint {} of the rail does not begin where the one before ends; allowed are joints in the "
    "order of a line",
    "the point is {} m beside the rail; allowed is half of the rail's length, {} m",
    "has {} joints and no joint {}, which is in a rail",
    "limits of {} to {}; allowed is a lower one that is not above the upper one",
    "the upper limit of a distance is {}; allowed is more than 0",
    "the upper limit is {}; allowed is more than 0, and a hinge for points that meet",
    "ratio is {}; allowed is 1e-6 to 1e6, or the same below 0",
    "a part is a gear; allowed are all other mechanisms",
    "both parts are one mechanism; allowed are two of them",
    "a fixed or kinematic body cannot be grabbed; allowed is a dynamic one",
    // --- levels ---
    "is not known here; allowed are {}",
    "lies outside of the level; allowed is a place within \"bounds\"",
    "is not a colour; allowed is \"#rrggbb\" such as \"#1F3A5F\"",
    "is too small; \"max\" must be at least 1 m right of and above \"min\"",
    "has its times out of order; allowed is gold <= silver <= bronze",
    "names no body of this scene; allowed are the ids under \"bodies\", or their beginning and a "
    "star",
    "is not below the spawn; the hero would never live",
    "\"tickRate\" is {}; allowed in a level is {}",
    "is a scene but no level; a level has a top-level member \"level\" (see "
    "levels/level.schema.json)",
    "\"{}\" is taken; allowed is an id that no other one of this list has",
    "\"{}\" names no body of this scene; allowed are the ids under \"bodies\"",
    "\"{}\" is not {}; allowed here is a body of the kind \"{}\"",
    "\"{}\" is named twice; allowed is one member for each body",
    "is longer than the period; allowed is at most \"period\"",
    "is too near; allowed is at least 0.05 m right of and above \"min\"",
    "does nothing; allowed is a zone with one or more of \"gravity\", \"wind\", \"liquid\" and "
    "\"deadly\": true",
    "does not move; allowed is a mover with one or more of \"path\", \"turn\" and \"spin\"",
    "is a door without a signal; allowed is a door that \"needs\" one",
    "cannot go round; allowed for \"loop\" is a \"path\", and \"spin\" for \"turn\"",
    "is too small; allowed is 0.05 m or more both ways",
    "is nobody; allowed are \"hero\", \"rope\", \"any\" and the ids under \"bodies\"",
    "is of no use here; allowed is it with \"by\": \"any\"",
    "is of no use here; allowed is it with the mode \"hold\"",
    "patrols nowhere; allowed is a patrol with \"between\": [x, x]",
    "is too narrow; allowed is [x, x] with the second 0.1 m or more to the right",
    "is a signal that nothing turns on; allowed are those of \"switches\", \"pickups\" and "
    "\"onDefeat\"",
    "is a signal that nothing turns on; allowed are those of \"switches\", \"pickups\" and "
    "\"onDefeat\": {}",
    "lies in {}; allowed is a place where the hero has room",
    "lies in {}; allowed is a place that the hero can come to",
    "lies within the closed outline of \"{}\", and the exit does not; allowed are both on the same "
    "side of it",
    "lies within the closed outline of \"{}\", and the spawn does not; allowed are both on the "
    "same side of it",
    // --- pictures ---
    "cannot be decoded: {}",
    "names two sizes",
    "is larger than 64 MiB",
    "is larger than 4 MiB",
    "is neither PNG nor JPEG, or is cut off",
    "its sides must be 1 to {} pixels",
    "is not an SVG drawing",
    "is not an SVG drawing: {}",
    "the frames of an animated picture must have one size",
    "a picture of {} x {} pixels is outside of 1 to {}",
    "an empty picture cannot be written as PNG",
    "out of memory",
    "cannot be drawn",
    "cannot be drawn: {}",
    "was asked for at a size outside of 1 to {}",
    "a pixel outside of the picture was asked for",
    "\"{}\" is not a name below the assets' folders",
    "\"{}\" was not found; searched: {}",
    "a picture cannot be encoded as PNG: {}",
};

constexpr std::string_view gapMark = "{}";
constexpr std::string_view placeEnd = ": ";  // a place and what is wrong there

std::size_t wordsIn(std::string_view pattern) {
    std::size_t gaps = 0;
    for (auto at = pattern.find(gapMark); at != pattern.npos;
         at = pattern.find(gapMark, at + gapMark.size()))
        ++gaps;
    return pattern.size() - gaps * gapMark.size();
}

// Those that say most come first, so that a general one takes only what no other one does.
const std::vector<std::string_view>& patternsByLength() {
    static const std::vector<std::string_view> sorted = [] {
        std::vector<std::string_view> all(std::begin(patternsOfRefusals),
                                          std::end(patternsOfRefusals));
        std::stable_sort(all.begin(), all.end(), [](std::string_view a, std::string_view b) {
            return wordsIn(a) > wordsIn(b);
        });
        return all;
    }();
    return sorted;
}

struct FilledGap {
    std::string_view text;
    bool quoted;
};

// What stands in the gaps of a pattern; nothing where the text is another sentence. A sentence that
// begins with a value has no place before it: that is taken off first.
std::optional<std::vector<FilledGap>> gapsOf(std::string_view pattern, std::string_view text) {
    std::vector<FilledGap> gaps;
    std::size_t at = pattern.find(gapMark);
    if (at == pattern.npos || !text.starts_with(pattern.substr(0, at))) return std::nullopt;
    text.remove_prefix(at);
    while (at != pattern.npos) {
        const bool quoted = at > 0 && pattern[at - 1] == '"';
        const std::size_t begin = at + gapMark.size();
        at = pattern.find(gapMark, begin);
        const bool last = at == pattern.npos;
        const std::string_view words = pattern.substr(begin, last ? at : at - begin);
        std::size_t end =
            last ? text.size() - std::min(text.size(), words.size()) : text.find(words);
        if (end == text.npos || end == 0 || !text.substr(end).starts_with(words))
            return std::nullopt;
        if (quoted && text.substr(0, end).find('"') != text.npos) return std::nullopt;
        gaps.push_back({text.substr(0, end), quoted});
        text.remove_prefix(end + words.size());
    }
    const bool place =
        pattern.starts_with(gapMark) && gaps[0].text.find(placeEnd) != gaps[0].text.npos;
    return place ? std::nullopt : std::optional(gaps);
}

// What a translation quotes are the own words of a library that refuses, such as a parser's.
bool quotes(std::string_view before) {
    return before.ends_with("\xE2\x80\x9E") || before.ends_with("\xC2\xAB");
}

std::optional<std::string> bySentence(std::string_view text) {
    for (const std::string_view pattern : patternsByLength()) {
        const auto gaps = gapsOf(pattern, text);
        if (!gaps) continue;
        std::string said = tr(std::string(pattern));
        std::size_t from = 0;
        for (const FilledGap& one : *gaps) {
            const std::string value(one.text);
            from = said.find(gapMark, from);
            if (from == said.npos) break;
            const bool own = one.quoted || quotes(std::string_view(said).substr(0, from));
            const std::string shown = own ? value : trRefusal(value);
            said.replace(from, gapMark.size(), shown);
            from += shown.size();
        }
        return said;
    }
    return std::nullopt;
}

}  // namespace

std::string trRefusal(const std::string& english) {
    if (std::string known = tr(english); known != english) return known;
    if (auto said = bySentence(english)) return *said;
    const std::size_t colon = english.find(placeEnd);
    if (colon == english.npos) return english;
    // A place may have the name of anything, so that only sentences are translated in it.
    const std::string place = english.substr(0, colon);
    return bySentence(place).value_or(place) + std::string(placeEnd) +
           trRefusal(english.substr(colon + placeEnd.size()));
}

std::span<const std::string_view> refusalPatterns() {
    return patternsOfRefusals;
}

}  // namespace sulfurchamber
