// What the game's tests share: a small level, and a hand that plays.
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <quaoar/level.hpp>
#include <quaoar/recording.hpp>
#include <quaoar/session.hpp>
#include <sstream>
#include <string>

namespace quaoar::test {

/// A closed room of 8 by 3 m with a crate, lines numbered for the tests of messages.
inline const std::string roomText = R"({
  "format": "sulfur-scene",
  "version": 1,
  "level": {
    "name": "Room",
    "number": 1,
    "spawn": [0, 0.3],
    "exit": {"position": [3.2, 0.3], "radius": 0.4},
    "bounds": {"min": [-4, -1], "max": [4, 4]},
    "killDepth": -3,
    "medals": {"gold": 5, "silver": 10, "bronze": 20}
  },
  "blueprints": {
    "room": {"shape": "ground", "kind": "fixed", "closed": true,
             "points": [[-4, 0], [4, 0], [4, 3], [-4, 3]]},
    "box": {"shape": "box", "size": [0.4, 0.4], "mass": 1}
  },
  "bodies": [
    {"id": "room", "blueprint": "room"},
    {"id": "box-1", "blueprint": "box", "position": [-2, 0.3]}
  ]
}
)";

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the test's own text lacks: " + from);
    return text.replace(at, from.size(), to);
}

/// A room with all that levels can hold.
inline const std::string everythingText = R"({
  "format": "sulfur-scene",
  "version": 1,
  "level": {
    "name": "Everything",
    "number": 1,
    "spawn": [-3, 0.4],
    "exit": {"position": [7.4, 2.5], "radius": 0.3, "needs": "won"},
    "bounds": {"min": [-4, -1], "max": [8, 4]},
    "killDepth": -3,
    "medals": {"gold": 5, "silver": 10, "bronze": 20},
    "countdown": 60, "speedLimit": 12, "reach": 4,
    "surfaces": {
      "spikes": {"deadly": true, "sticky": false},
      "leech": {"cuts": true},
      "shelf": {"crumbles": 0.3},
      "rock*": {"deadlySpeed": 4, "look": "rock"}
    },
    "checkpoints": [{"id": "start", "position": [-3, 0.4], "radius": 0.3},
                    {"id": "half", "position": [2, 1], "radius": 1}],
    "pickups": [{"id": "spark", "position": [-2, 1], "hidden": true}],
    "zones": [
      {"id": "geyser", "min": [-1, 0], "max": [0, 3], "wind": {"velocity": [0, 8], "drag": 4},
       "pulse": {"period": 1.5, "on": 0.6, "phase": 0.2}},
      {"id": "pool", "min": [0.5, 0], "max": [3, 0.8], "liquid": {"density": 55, "drag": 2}},
      {"id": "drift", "min": [3, 1], "max": [5, 3], "gravity": [0, 1], "needs": "pressed"},
      {"id": "void", "min": [7, 0], "max": [8, 0.4], "deadly": true}
    ],
    "movers": [
      {"body": "lift", "path": [[-1.5, 2], [-1, 2]], "seconds": 1.2, "secondsBack": 0.4,
       "pauseStart": 0.2, "pauseEnd": 0.3, "phase": 0.5},
      {"body": "gear", "spin": 1.5},
      {"body": "gate", "path": [[6, 2.4]], "seconds": 0.4, "mode": "door", "needs": "pressed"}
    ],
    "switches": [
      {"id": "plate", "position": [1.5, 0.2], "size": [0.8, 0.4], "by": "any", "weight": 0.5,
       "signal": "pressed"},
      {"id": "hook", "position": [-3, 3], "size": [1, 0.4], "by": "rope", "mode": "toggle",
       "signal": "pressed"}
    ],
    "monsters": [
      {"body": "slug", "behaviour": "patrol", "between": [3.5, 5.5], "speed": 0.7,
       "toughness": 3, "onDefeat": "won"},
      {"body": "leech", "behaviour": "lunge", "target": "rope", "range": 5, "speed": 5,
       "flies": true}
    ],
    "respawns": [{"body": "rock-1", "every": 1.1, "phase": 0.4}]
  },
  "blueprints": {
    "room": {"shape": "ground", "kind": "fixed", "closed": true,
             "points": [[-4, 0], [8, 0], [8, 3], [-4, 3]]},
    "plank": {"shape": "box", "size": [0.8, 0.15], "kind": "kinematic"},
    "gear": {"shape": "polygon", "kind": "kinematic",
             "points": [[0.4, 0], [0.1, 0.1], [0, 0.4], [-0.1, 0.1], [-0.4, 0], [-0.1, -0.1],
                        [0, -0.4], [0.1, -0.1]]},
    "slab": {"shape": "wall", "size": [0.8, 0.3], "columns": 4, "rows": 2, "mass": 3,
             "strength": 60, "kind": "fixed"},
    "spikes": {"shape": "box", "size": [0.5, 0.1], "kind": "fixed"},
    "rock": {"shape": "box", "size": [0.3, 0.3], "mass": 2},
    "slug": {"shape": "jelly", "size": [0.5, 0.25], "columns": 4, "rows": 3, "mass": 2,
             "stiffness": 900, "damping": 2}
  },
  "bodies": [
    {"id": "room", "blueprint": "room"},
    {"id": "lift", "blueprint": "plank", "position": [-1.5, 0.3]},
    {"id": "gate", "blueprint": "plank", "position": [6, 0.6]},
    {"id": "gear", "blueprint": "gear", "position": [4.2, 2.2]},
    {"id": "shelf", "blueprint": "slab", "position": [-2.6, 2]},
    {"id": "spikes", "blueprint": "spikes", "position": [6.5, 0.1]},
    {"id": "rock-1", "blueprint": "rock", "position": [0.3, 2.6]},
    {"id": "rock-2", "blueprint": "rock", "position": [1.5, 1]},
    {"id": "slug", "blueprint": "slug", "position": [4.5, 0.2]},
    {"id": "leech", "blueprint": "slug", "position": [2.5, 2.5]}
  ]
}
)";

inline std::shared_ptr<const Level> room(const std::string& text = roomText) {
    return std::make_shared<const Level>(parseLevel(text, "room.json"));
}

inline std::filesystem::path levelsFolder() {
    return QUAOAR_TEST_LEVELS;
}

inline std::shared_ptr<const Level> firstLevel() {
    return std::make_shared<const Level>(readLevel(levelsFolder() / "01-cold-wake.json"));
}

/// The room with more members of "level", on line 10.
inline std::string roomWith(const std::string& members, const std::string& text = roomText) {
    return replaced(text, "\"killDepth\": -3,", "\"killDepth\": -3, " + members + ",");
}

/// A level with one more body, of a blueprint of its own given as members, at a place such as "[1,
/// 2]".
inline std::string withBody(const std::string& text, const std::string& id,
                            const std::string& blueprint, const std::string& position) {
    const std::string planned =
        replaced(text, "\"box\":", "\"" + id + "\": {" + blueprint + "},\n    \"box\":");
    return replaced(planned, "{\"id\": \"box-1\"",
                    "{\"id\": \"" + id + "\", \"blueprint\": \"" + id +
                        "\", \"position\": " + position + "},\n    {\"id\": \"box-1\"");
}

/// A folder of its own for every test, removed afterwards.
class Folder {
public:
    explicit Folder(const std::string& name)
        : path_(std::filesystem::temp_directory_path() /
                ("quaoar-test-" + name + "-" + std::to_string(::getpid()))) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

inline void writeText(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

inline std::string readText(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Aims and holds fire.
inline TickInput fireAt(double x, double y) {
    TickInput input;
    setAim(input, x, y);
    input.fire = true;
    return input;
}

inline void play(Session& session, const TickInput& input, int ticks) {
    for (int n = 0; n < ticks; ++n) session.tick(input);
}

/// Puts the hero somewhere, at rest.
inline void put(Session& session, double x, double y) {
    const sulfur::Point by = sulfur::Point(x, y) - session.heroPosition();
    for (const sulfur::ParticleId particle : session.world().particles(session.hero())) {
        session.world().setPosition(particle, session.world().position(particle) + by);
    }
    session.world().setVelocity(session.hero(), {0, 0}, 0);
}

/// Where a body of the scene is.
inline sulfur::Point placeOf(const Session& session, const std::string& id) {
    return session.world().centreOfMass(session.instance().body(id));
}

/// Plays the same from a snapshot twice, and in a second session from the start: gives the hashes
/// of all three, which must be equal.
template <class Play>
std::array<std::uint64_t, 3> threeWays(const std::shared_ptr<const Level>& level, Play playOn) {
    Session one(level), other(level);
    play(one, {}, 300);
    play(other, {}, 300);
    const auto snapshot = one.snapshot();
    playOn(one);
    const std::uint64_t first = one.hash();
    one.restart();
    play(one, {}, 17);
    one.restore(*snapshot);
    playOn(one);
    playOn(other);
    return {first, one.hash(), other.hash()};
}

}  // namespace quaoar::test
