// A level: a scene of the physics library with what the game adds to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <quaoar/mechanics.hpp>
#include <string>
#include <string_view>
#include <sulfur/scene.hpp>
#include <vector>

namespace quaoar {

/// How the surface of a body looks and what it does to what touches it. (Friction, and the speed of
/// a conveyor belt, are the scene's.) Pieces that break off keep it.
struct Surface {
    enum class Look : std::uint8_t { ice, mirror, metal, rock, peg };
    bool sticky = true;   ///< the rope holds on it
    bool deadly = false;  ///< kills the hero
    /// m/s at which it must meet the hero, by its own motion, to kill him: falling rocks, hammers.
    std::optional<double> deadlySpeed;
    bool cuts = false;  ///< cuts the rope
    /// Seconds of being touched by the hero or hooked by the rope after which it comes loose: a
    /// fixed body then falls.
    std::optional<double> crumbles;
    Look look = Look::ice;

    friend bool operator==(const Surface&, const Surface&) = default;
};

/// A sentence that floats in the world.
struct Hint {
    sulfur::Point position{0, 0};  ///< metres, the middle of the text
    std::string text;
};

/// Where the level ends.
struct Exit {
    sulfur::Point position{0, 0};  ///< metres
    double radius = 0.5;           ///< metres: the hero's middle must come this near
    std::string needs;             ///< a signal without which it is closed; empty: always open
};

/// Times in seconds that earn a medal, each at least as long as the one before.
struct MedalTimes {
    double gold = 0;
    double silver = 0;
    double bronze = 0;
};

enum class Medal : std::uint8_t { none, bronze, silver, gold };
/// "gold", "silver", "bronze" or "none".
const char* name(Medal medal);

/// How a level looks. Colours as 0xRRGGBB; those that a level does not name are its world's.
struct Theme {
    /// The four worlds: their skies, materials, weather and music.
    enum class World : std::uint8_t { dawn, bog, machine, deep };
    World world = World::dawn;
    std::uint32_t skyTop = 0x0B1026;
    std::uint32_t skyBottom = 0x1F3A5F;
    std::uint32_t ice = 0x1F3A5F;
    std::uint32_t rim = 0xE8F4FF;
    std::uint32_t seed = 1;  ///< of stars, mountains and cracks

    friend bool operator==(const Theme&, const Theme&) = default;
};

/// The colours of a world.
Theme themeOf(Theme::World world);

/// Everything of one level. Plain data; reading it has checked all of it.
struct Level {
    sulfur::scene::Scene scene;
    std::string id;  ///< file name without folder and extension
    std::string name;
    int number = 0;
    sulfur::Point spawn{0, 0};  ///< metres: the hero's middle
    Exit exit;
    sulfur::Point boundsMin{0, 0};  ///< metres: what the camera may show
    sulfur::Point boundsMax{0, 0};
    double viewHeight = 5;  ///< metres over the height of the screen at full speed
    double killDepth = 0;   ///< metres: below this height the attempt ends
    std::vector<Hint> hints;
    MedalTimes medals;
    /// By id of a body, or by the beginning of ids with a star: "icicle-*".
    std::map<std::string, Surface, std::less<>> surfaces;
    std::vector<Checkpoint> checkpoints;
    std::vector<Pickup> pickups;
    std::vector<Zone> zones;
    std::vector<Mover> movers;
    std::vector<Switch> switches;
    std::vector<Monster> monsters;
    std::vector<Respawn> respawns;
    std::optional<double> countdown;         ///< seconds, after which the attempt ends
    std::optional<sulfur::Real> speedLimit;  ///< m/s of the hero, instead of HeroRules'
    std::optional<sulfur::Real> reach;       ///< m of the rope, instead of RopeRules'
    std::vector<std::string> signals;        ///< all that something turns on, sorted
    Theme theme;
    std::uint64_t contentHash = 0;  ///< of the file's bytes

    /// The surface of a body of the scene; sticky ice when the level says nothing about it.
    Surface surface(std::string_view bodyId) const;
    /// The medal for a time in seconds.
    Medal medalFor(double seconds) const;
    /// The place of a name in `signals`, or nothing.
    std::optional<std::size_t> signal(std::string_view name) const;
};

/// Whether a key of Level::surfaces ends in a star, and so names all bodies whose ids begin so.
bool namesSeveral(std::string_view surfaceKey);
/// Whether a key of Level::surfaces names a body.
bool namesBody(std::string_view surfaceKey, std::string_view bodyId);

/// Reads a level file: a scene (see sulfur/scene) with a top-level member "level", described by
/// levels/level.schema.json. Throws sulfur::scene::ReadError naming file, line, object and remedy;
/// also what checkLevel finds (level_check.hpp).
Level readLevel(const std::filesystem::path& file);

/// The same from a text, without checkLevel; `id` and messages use the name of the file.
Level parseLevel(const std::string& text, const std::filesystem::path& file);

/// 64-bit FNV-1a.
std::uint64_t contentHash(std::string_view bytes);

}  // namespace quaoar
