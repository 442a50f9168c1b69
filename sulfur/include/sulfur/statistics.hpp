/// \file
/// Counters and timings of the last tick, stage by stage.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sulfur {

/// The stages of a tick, in the order in which they run.
enum class Stage : std::uint8_t {
    changes,
    forces,
    fields,
    predict,
    broadPhase,
    narrowPhase,
    constraints,
    velocities,
    breakage,
    sleep,
    sensors,
    count
};

/// The name of a stage, for tables.
const char* name(Stage stage);

/// What the last tick did. Times are filled only while World::setProfiling is on.
struct Statistics {
    std::uint32_t particles = 0;       ///< in the world
    std::uint32_t joints = 0;          ///< in the world
    std::uint32_t bodies = 0;          ///< in the world
    std::uint32_t awakeParticles = 0;  ///< of bodies that move
    std::uint32_t explicitJoints = 0;  ///< elastic, integrated by NSV alone
    std::uint32_t implicitJoints = 0;  ///< elastic, at least in part beyond the explicit range
    std::uint32_t rigidJoints = 0;     ///< solved as constraints: none inside a rigid component
    std::uint32_t sweptJoints = 0;     ///< of the implicit and rigid ones, those in no tree
    std::uint32_t explicitAngles = 0;  ///< angular joints that are forces alone
    std::uint32_t implicitAngles =
        0;                         ///< those that are constraints of the sweeps, at least in part
    std::uint32_t clusters = 0;    ///< rigid components awake, each moved as one
    std::uint32_t trees = 0;       ///< chains and trees awake that are solved directly
    std::uint32_t chainSteps = 0;  ///< steps that these took in the last tick, in all
    std::uint32_t chainsInLanes = 0;     ///< of these trees, those that went side by side in lanes
    std::uint32_t chainFallbacks = 0;    ///< of these, those that had to give up SHAKE directions
    std::uint32_t networks = 0;          ///< of the trees, those with loops: nets, rings, grids
    std::uint32_t networkFactors = 0;    ///< factorisations that these took in the last tick
    std::uint32_t triangles = 0;         ///< of soft bodies awake, which keep their side
    std::uint32_t pressedTriangles = 0;  ///< of these, those that were nearly flat or turned over
    std::uint32_t candidates = 0;        ///< pairs of things near each other, one of them awake
    std::uint32_t looks = 0;             ///< at such pairs in this tick
    std::uint32_t contacts = 0;          ///< rows of contacts that this has found
    std::uint32_t boxes = 0;             ///< of the broad phase, drawn anew in this tick
    std::uint32_t substeps = 0;          ///< equal steps of a tick, 1 from 480 Hz on
    std::uint32_t dampedJoints = 0;      ///< of the explicit ones, those that brake
    std::uint32_t breakableJoints = 0;   ///< awake ones that have a strength
    std::uint32_t fastPairs = 0;         ///< of the candidates, those whose ways were looked at
    std::uint32_t heldBack = 0;          ///< movers that were kept before what is in their way
    std::uint64_t idleTicks = 0;         ///< since the world was made: all rested, no stage ran
    /// Since the world was made: entries of lists and arrays that were looked through because
    /// bodies were removed. Those of what is awake once a tick, those of all when half are gaps.
    std::uint64_t upkeep = 0;
    /// By Stage: bodies, particles, joints, candidates that it looked at; 0 had nothing to do.
    std::array<std::uint32_t, static_cast<std::size_t>(Stage::count)> items{};
    /// By Stage; zero unless profiling is on.
    std::array<double, static_cast<std::size_t>(Stage::count)> seconds{};
};

/// What a number of arrays of a world hold.
struct MemoryUse {
    const char* name;       ///< "particles", in plain English
    std::size_t items = 0;  ///< that it is counted by
    std::size_t bytes = 0;  ///< in use; what is reserved for growth is not counted
    bool hot = false;       ///< a tick reads or writes it for everything that is awake

    double perItem() const {  ///< bytes an item, 0 where there is none
        return items == 0 ? 0 : static_cast<double>(bytes) / static_cast<double>(items);
    }
};

}  // namespace sulfur
