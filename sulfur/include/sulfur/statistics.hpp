// Counters and timings of the last tick, stage by stage.
#pragma once

#include <array>
#include <cstdint>

namespace sulfur {

/// The stages of a tick, in the order in which they run.
enum class Stage : std::uint8_t {
    changes,
    broadPhase,
    forces,
    fields,
    predict,
    narrowPhase,
    constraints,
    velocities,
    breakage,
    sleep,
    count
};

/// The name of a stage, for tables.
const char* name(Stage stage);

/// What the last tick did. Times are filled only while World::setProfiling is on.
struct Statistics {
    std::uint32_t particles = 0;
    std::uint32_t joints = 0;
    std::uint32_t bodies = 0;
    std::uint32_t awakeParticles = 0;
    std::uint32_t explicitJoints = 0;  ///< elastic, integrated by NSV
    std::uint32_t implicitJoints = 0;  ///< elastic, beyond the explicit limit
    std::uint32_t rigidJoints = 0;
    std::uint32_t candidates = 0;  ///< pairs that the narrow phase looked at
    std::uint32_t contacts = 0;
    std::uint64_t broadPhases = 0;  ///< since the world was made
    std::array<double, static_cast<std::size_t>(Stage::count)> seconds{};
};

}  // namespace sulfur
