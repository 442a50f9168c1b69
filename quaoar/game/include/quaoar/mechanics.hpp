// What a level may hold beside its scene, as plain data: what saves, kills, blows, moves, switches
// and lives. What these do in an attempt is in rules/, one concept a file.
//
// Signals tie them together: a name that is on or off. Switches, defeated monsters and pick-ups
// turn signals on; a mover, a zone, a respawn or the exit that "needs" a signal acts only while it
// is on.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <sulfur/math.hpp>
#include <vector>

namespace quaoar {

/// A place to which the hero comes back when he dies.
struct Checkpoint {
    static constexpr std::size_t most = 64;
    std::string id;
    sulfur::Point position{0, 0};  ///< metres: where he begins anew, at rest
    double radius = 0.5;           ///< metres: his middle must come this near to reach it
};

/// Something to be collected by touching it.
struct Pickup {
    static constexpr double radius = 0.35;  ///< metres: the hero's middle must come this near
    static constexpr std::size_t most = 64;
    std::string id;
    sulfur::Point position{0, 0};  ///< metres
    bool hidden = false;           ///< off the way; drawn only from near
    std::string signal;            ///< that it turns on, as a key does; may be empty
};

/// An upright rectangle in which other rules hold. All that is given acts together, and zones that
/// overlap add up.
struct Zone {
    /// Moving air.
    struct Wind {
        sulfur::Vec2 velocity{0, 0};  ///< m/s: nothing is blown faster
        sulfur::Real drag = 3;        ///< 1/s: how fast things take it up
    };
    /// What bodies float or sink in: it pushes each particle up by the weight of the liquid that
    /// its share of the body displaces, and brakes it.
    struct Liquid {
        sulfur::Real density = 60;  ///< kg/m^2; the hero has about 44
        sulfur::Real drag = 2;      ///< 1/s
    };
    /// Comes and goes: on for the first `on` seconds of each period.
    struct Pulse {
        double period = 4;  ///< seconds
        double on = 2;      ///< seconds, at most the period
        double phase = 0;   ///< seconds of the first period that have already passed at the start
    };
    std::string id;
    sulfur::Point low{0, 0};              ///< metres, lower left corner
    sulfur::Point high{0, 0};             ///< metres, upper right corner
    std::optional<sulfur::Vec2> gravity;  ///< m/s^2, instead of the world's
    std::optional<Wind> wind;
    std::optional<Liquid> liquid;
    bool deadly = false;  ///< kills a hero whose middle is in it, and monsters
    std::optional<Pulse> pulse;
    std::string needs;  ///< a signal; empty: always
};

/// A kinematic body on its way: a lift, a crusher, a door, a gear.
struct Mover {
    enum class Mode : std::uint8_t {
        pingpong,  ///< to the end of its path and back, for ever
        loop,      ///< along its path and straight on to the start, for ever
        once,      ///< to the end, when its signal comes on for the first time (or at once)
        door,      ///< towards the end while its signal is on, towards the start while it is not
    };
    std::string body;
    /// Metres: places of the body's frame after the one in which the scene has it.
    std::vector<sulfur::Point> path;
    double turn = 0;         ///< radians by which it has turned at the path's end
    double spin = 0;         ///< rad/s, beside its path: a gear
    double seconds = 2;      ///< of the whole way there; of a loop, of one round
    double secondsBack = 2;  ///< of the whole way back
    double pauseStart = 0;   ///< seconds of rest at the start
    double pauseEnd = 0;     ///< seconds of rest at the end
    double phase = 0;        ///< seconds that it is ahead at the start
    Mode mode = Mode::pingpong;
    bool ease = true;   ///< sets out and arrives gently; not in a loop
    std::string needs;  ///< a signal; empty: always. Without it pingpong, loop and spin stand still
};

/// Turns a signal on.
struct Switch {
    enum class Mode : std::uint8_t {
        hold,    ///< on while something presses it
        toggle,  ///< changes whenever something begins to press it
        once,    ///< on for good
    };
    std::string id;
    sulfur::Point position{0, 0};  ///< metres, the middle
    sulfur::Vec2 size{1, 1};       ///< metres, of the rectangle that must be touched
    /// "hero", "rope" (its tied end), "any" (the hero and whatever physics moves) or a body's id.
    std::string by = "hero";
    double weight = 0;  ///< kg that must lie in it; only by "any"
    double lasts = 0;   ///< seconds for which it stays on when it is let go; only of hold
    Mode mode = Mode::hold;
    std::string signal;
};

/// A body of the scene that behaves. Whether it kills or cuts says its surface.
struct Monster {
    enum class Behaviour : std::uint8_t {
        patrol,  ///< crawls to and fro between two places
        lunge,   ///< waits; leaps at what it sees
        chase,   ///< goes after what it sees
        flee,    ///< goes away from what it sees
        hang,    ///< hangs on the scene's ropes, and swings at what it sees
    };
    enum class Target : std::uint8_t { hero, rope };
    std::string body;
    Behaviour behaviour = Behaviour::patrol;
    Target target = Target::hero;  ///< what it looks for
    double range = 3;              ///< metres: how far it sees, unless something is in the way
    double speed = 1;              ///< m/s: of its crawling, its flight, its leap
    bool flies = false;            ///< moves through air or liquid, without weight
    double from = 0;               ///< metres: patrols go from this x ...
    double to = 0;                 ///< ... to this one
    /// N s: a blow by something that moves, the hero too, beyond it defeats the monster: its speed
    /// times m M / (m + M). It is also defeated when a tenth of its joints is gone, in a deadly
    /// zone and below the level's kill depth.
    double toughness = std::numeric_limits<double>::infinity();
    std::string onDefeat;  ///< a signal that this turns on; may be empty
};

/// A dynamic body that comes back to its place in the scene again and again: falling rocks, ore.
struct Respawn {
    std::string body;
    double every = 4;   ///< seconds
    double phase = 0;   ///< seconds before it appears for the first time
    std::string needs;  ///< a signal; empty: always
};

}  // namespace quaoar
