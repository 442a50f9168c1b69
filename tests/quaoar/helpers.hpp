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
