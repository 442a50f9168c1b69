#include "level_fields.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace sulfurchamber {
namespace {

using LK = LevelKind;
using FT = FieldType;

constexpr double farOut = 1000;      // metres
constexpr double longestTime = 600;  // seconds

constexpr LevelKindInfo kindTable[] = {
    {LK::spawn, "spawn", "Spawn"},
    {LK::exit, "exit", "Exit"},
    {LK::bounds, "bounds", "Camera"},
    {LK::killDepth, "killDepth", "Kill depth"},
    {LK::hint, "hints", "Hint", true},
    {LK::checkpoint, "checkpoints", "Checkpoint", true},
    {LK::pickup, "pickups", "Pick-up", true},
    {LK::zone, "zones", "Zone", true},
    {LK::trigger, "switches", "Switch", true},
    {LK::mover, "movers", "Mover", true, true},
    {LK::monster, "monsters", "Monster", true, true},
    {LK::respawn, "respawns", "Respawn", true, true},
    {LK::surface, "surfaces", "Surface", false, true},
    {LK::medals, "medals", "Medals"},
    {LK::theme, "theme", "Theme"},
    {LK::rules, "", "Level"},
};

constexpr std::string_view needsHelp = "Acts only while this signal is on";
constexpr std::string_view idHelp = "Unique in its list";

constexpr LevelField fieldTable[] = {
    {LK::spawn, "0", "x", "m", FT::number, -farOut, farOut},
    {LK::spawn, "1", "y", "m", FT::number, -farOut, farOut},

    {LK::exit, "position.0", "x", "m", FT::number, -farOut, farOut},
    {LK::exit, "position.1", "y", "m", FT::number, -farOut, farOut},
    {LK::exit, "radius", "Radius", "m", FT::number, 0.1, 10},
    {LK::exit, "needs", "Needs", "", FT::text, 0, 60, "", true, "", "", "Closed until this is on"},

    {LK::bounds, "min.0", "Left", "m", FT::number, -farOut, farOut},
    {LK::bounds, "min.1", "Bottom", "m", FT::number, -farOut, farOut},
    {LK::bounds, "max.0", "Right", "m", FT::number, -farOut, farOut},
    {LK::bounds, "max.1", "Top", "m", FT::number, -farOut, farOut},

    {LK::killDepth, "", "Height", "m", FT::number, -farOut, farOut},

    {LK::hint, "text", "Text", "", FT::lines, 1, 300},
    {LK::hint, "position.0", "x", "m", FT::number, -farOut, farOut},
    {LK::hint, "position.1", "y", "m", FT::number, -farOut, farOut},

    {LK::checkpoint, "id", "Name", "", FT::text, 1, 100, "", false, "", "", idHelp},
    {LK::checkpoint, "position.0", "x", "m", FT::number, -farOut, farOut},
    {LK::checkpoint, "position.1", "y", "m", FT::number, -farOut, farOut},
    {LK::checkpoint, "radius", "Radius", "m", FT::number, 0.1, 50, "0.5"},

    {LK::pickup, "id", "Name", "", FT::text, 1, 100, "", false, "", "", idHelp},
    {LK::pickup, "position.0", "x", "m", FT::number, -farOut, farOut},
    {LK::pickup, "position.1", "y", "m", FT::number, -farOut, farOut},
    {LK::pickup, "hidden", "Hidden", "", FT::flag, 0, 0, "no", false, "", "",
     "Off the way; drawn only from near"},
    {LK::pickup, "signal", "Signal", "", FT::text, 0, 60, "", true, "", "",
     "On once it is collected, as by a key"},

    {LK::zone, "id", "Name", "", FT::text, 1, 100, "", false, "", "", idHelp},
    {LK::zone, "min.0", "Left", "m", FT::number, -farOut, farOut},
    {LK::zone, "min.1", "Bottom", "m", FT::number, -farOut, farOut},
    {LK::zone, "max.0", "Right", "m", FT::number, -farOut, farOut},
    {LK::zone, "max.1", "Top", "m", FT::number, -farOut, farOut},
    {LK::zone, "gravity", "Gravity", "", FT::part, 0, 0, "no", false, "", "[0, 1.5]",
     "Instead of the world's"},
    {LK::zone, "gravity.0", "right", "m/s\xC2\xB2", FT::number, -100, 100, "", false, "gravity"},
    {LK::zone, "gravity.1", "up", "m/s\xC2\xB2", FT::number, -100, 100, "", false, "gravity"},
    {LK::zone, "wind", "Wind", "", FT::part, 0, 0, "no", false, "",
     R"({"velocity": [0, 9], "drag": 4})", "Nothing is blown faster than this"},
    {LK::zone, "wind.velocity.0", "right", "m/s", FT::number, -100, 100, "", false, "wind"},
    {LK::zone, "wind.velocity.1", "up", "m/s", FT::number, -100, 100, "", false, "wind"},
    {LK::zone, "wind.drag", "drag", "1/s", FT::number, 0.01, 100, "3", false, "wind", "",
     "How fast things take it up"},
    {LK::zone, "liquid", "Liquid", "", FT::part, 0, 0, "no", false, "", R"({"density": 60})",
     "Lighter bodies float; the hero has about 44 kg/m\xC2\xB2"},
    {LK::zone, "liquid.density", "density", "kg/m\xC2\xB2", FT::number, 0.1, 1e5, "60", false,
     "liquid"},
    {LK::zone, "liquid.drag", "drag", "1/s", FT::number, 0, 100, "2", false, "liquid"},
    {LK::zone, "deadly", "Deadly", "", FT::flag, 0, 0, "no", false, "", "",
     "Kills a hero whose middle is in it, and monsters"},
    {LK::zone, "pulse", "Pulse", "", FT::part, 0, 0, "no", false, "", R"({"period": 4, "on": 1.5})",
     "On for the first seconds of each period, for geysers"},
    {LK::zone, "pulse.period", "period", "s", FT::number, 0.1, longestTime, "", false, "pulse"},
    {LK::zone, "pulse.on", "on", "s", FT::number, 0.01, longestTime, "", false, "pulse"},
    {LK::zone, "pulse.phase", "phase", "s", FT::number, 0, longestTime, "0", false, "pulse"},
    {LK::zone, "needs", "Needs", "", FT::text, 0, 60, "", true, "", "", needsHelp},

    {LK::trigger, "id", "Name", "", FT::text, 1, 100, "", false, "", "", idHelp},
    {LK::trigger, "signal", "Signal", "", FT::text, 1, 60, "", false, "", "",
     "The name of what it turns on"},
    {LK::trigger, "position.0", "x", "m", FT::number, -farOut, farOut},
    {LK::trigger, "position.1", "y", "m", FT::number, -farOut, farOut},
    {LK::trigger, "size.0", "Width", "m", FT::number, 0.05, 100},
    {LK::trigger, "size.1", "Height", "m", FT::number, 0.05, 100},
    {LK::trigger, "by", "By", "", FT::text, 1, 100, "hero", false, "", "",
     "hero, rope (its tied end), any (what physics moves), or the name of a body"},
    {LK::trigger, "weight", "Weight", "kg", FT::number, 0.01, 1e6, "", true, "", "",
     "That must lie in it; only by any"},
    {LK::trigger, "mode", "Mode", "", FT::choice, 0, 0, "hold", false, "", "hold|toggle|once",
     "hold: on while pressed; toggle: changes with every press; once: on for good"},
    {LK::trigger, "lasts", "Lasts", "s", FT::number, 0, longestTime, "0", true, "", "",
     "How long it stays on when it is let go; only with hold"},

    {LK::mover, "body", "Body", "", FT::text, 1, 100},
    {LK::mover, "path", "Way", "m", FT::points, 1, 200, "", true, "", "",
     "Places after the one that the body has: 3 4, 5 6"},
    {LK::mover, "seconds", "Seconds", "s", FT::number, 0.05, longestTime, "", true, "", "",
     "Of the whole way there; of a loop, of one round"},
    {LK::mover, "secondsBack", "Back", "s", FT::number, 0.05, longestTime, "", true, "", "",
     "Of the whole way back; as long as the way there when empty"},
    {LK::mover, "mode", "Mode", "", FT::choice, 0, 0, "pingpong", false, "",
     "pingpong|loop|once|door", "A door is at its end while the signal is on"},
    {LK::mover, "needs", "Needs", "", FT::text, 0, 60, "", true, "", "", needsHelp},
    {LK::mover, "pauseStart", "Rest at start", "s", FT::number, 0, longestTime, "0"},
    {LK::mover, "pauseEnd", "Rest at end", "s", FT::number, 0, longestTime, "0"},
    {LK::mover, "phase", "Ahead", "s", FT::number, 0, longestTime, "0"},
    {LK::mover, "turn", "Turn", "rad", FT::number, -100, 100, "0", false, "", "",
     "By which it has turned at the end of its way"},
    {LK::mover, "spin", "Spin", "rad/s", FT::number, -100, 100, "0", false, "", "",
     "For ever, beside its way"},
    {LK::mover, "ease", "Gently", "", FT::flag, 0, 0, "yes", false, "", "",
     "Sets out and arrives gently; not in a loop"},

    {LK::monster, "body", "Body", "", FT::text, 1, 100},
    {LK::monster, "behaviour", "Behaviour", "", FT::choice, 0, 0, "", false, "",
     "patrol|lunge|chase|flee|hang"},
    {LK::monster, "target", "Looks for", "", FT::choice, 0, 0, "hero", false, "", "hero|rope"},
    {LK::monster, "range", "Sees", "m", FT::number, 0, 50, "3"},
    {LK::monster, "speed", "Speed", "m/s", FT::number, 0.05, 30, "1"},
    {LK::monster, "flies", "Flies", "", FT::flag, 0, 0, "no"},
    {LK::monster, "between", "Patrols", "", FT::part, 0, 0, "no", false, "", "",
     "To and fro between two places"},
    {LK::monster, "between.0", "from", "m", FT::number, -farOut, farOut, "", false, "between"},
    {LK::monster, "between.1", "to", "m", FT::number, -farOut, farOut, "", false, "between"},
    {LK::monster, "toughness", "Toughness", "N s", FT::number, 0.01, 1e6, "", true, "", "",
     "A stronger blow defeats it; none does when empty"},
    {LK::monster, "onDefeat", "On defeat", "", FT::text, 0, 60, "", true, "", "",
     "A signal that its defeat turns on"},

    {LK::respawn, "body", "Body", "", FT::text, 1, 100},
    {LK::respawn, "every", "Every", "s", FT::number, 0.1, longestTime},
    {LK::respawn, "phase", "First after", "s", FT::number, 0, longestTime, "0"},
    {LK::respawn, "needs", "Needs", "", FT::text, 0, 60, "", true, "", "", needsHelp},

    {LK::surface, "look", "Look", "", FT::choice, 0, 0, "ice", false, "",
     "ice|mirror|metal|rock|peg"},
    {LK::surface, "sticky", "Rope holds", "", FT::flag, 0, 0, "yes"},
    {LK::surface, "deadly", "Deadly", "", FT::flag, 0, 0, "no", false, "", "",
     "Touching it kills the hero"},
    {LK::surface, "cuts", "Cuts", "", FT::flag, 0, 0, "no", false, "", "",
     "Touching it cuts the rope"},
    {LK::surface, "deadlySpeed", "Deadly from", "m/s", FT::number, 0.1, 100, "", true, "", "",
     "At which it must meet the hero to kill him"},
    {LK::surface, "crumbles", "Crumbles", "s", FT::number, 0, 60, "", true, "", "",
     "Seconds of being touched until it comes loose"},

    {LK::medals, "gold", "Gold", "s", FT::number, 0.1, 36000},
    {LK::medals, "silver", "Silver", "s", FT::number, 0.1, 36000},
    {LK::medals, "bronze", "Bronze", "s", FT::number, 0.1, 36000},

    {LK::theme, "world", "World", "", FT::choice, 0, 0, "dawn", false, "", "dawn|bog|machine|deep",
     "Sky, materials, weather and music"},
    {LK::theme, "skyTop", "Sky above", "", FT::colour, 0, 0, "", true},
    {LK::theme, "skyBottom", "Sky below", "", FT::colour, 0, 0, "", true},
    {LK::theme, "ice", "Ground", "", FT::colour, 0, 0, "", true},
    {LK::theme, "rim", "Rim", "", FT::colour, 0, 0, "", true},
    {LK::theme, "seed", "Seed", "", FT::whole, 0, 4294967295.0, "1", false, "", "",
     "Of stars, mountains and cracks"},

    {LK::rules, "name", "Name", "", FT::text, 1, 60},
    {LK::rules, "number", "Number", "", FT::whole, 1, 999},
    {LK::rules, "viewHeight", "View", "m", FT::number, 2, 50, "5", false, "", "",
     "Over the height of the picture when the hero is fastest"},
    {LK::rules, "countdown", "Countdown", "s", FT::number, 1, 3600, "", true, "", "",
     "After which the attempt starts again"},
    {LK::rules, "speedLimit", "Fastest", "m/s", FT::number, 1, 60, "", true, "", "",
     "Of the hero; 11 when empty"},
    {LK::rules, "reach", "Rope", "m", FT::number, 0.5, 20, "", true, "", "",
     "How far the rope reaches; 3 when empty"},
};

}  // namespace

std::span<const LevelKindInfo> levelKinds() {
    return kindTable;
}

const LevelKindInfo& infoOf(LevelKind kind) {
    return kindTable[static_cast<std::size_t>(kind)];
}

std::span<const LevelField> levelFields() {
    return fieldTable;
}

std::vector<std::string> choicesOf(const LevelField& field) {
    std::vector<std::string> words;
    if (field.type != FieldType::choice) return words;
    for (std::string_view rest = field.choices; !rest.empty();) {
        const std::size_t bar = std::min(rest.find('|'), rest.size());
        words.emplace_back(rest.substr(0, bar));
        rest.remove_prefix(std::min(bar + 1, rest.size()));
    }
    return words;
}

const LevelField* levelField(LevelKind kind, std::string_view path) {
    const auto found =
        std::find_if(std::begin(fieldTable), std::end(fieldTable),
                     [&](const auto& field) { return field.kind == kind && field.path == path; });
    return found == std::end(fieldTable) ? nullptr : &*found;
}

}  // namespace sulfurchamber
