// All mechanics of a level at work in one attempt: what drawing and sound look at.
#pragma once

#include <cstdint>
#include <quaoar/crumbling.hpp>
#include <quaoar/monsters.hpp>
#include <quaoar/movers.hpp>
#include <quaoar/respawns.hpp>
#include <quaoar/signals.hpp>
#include <quaoar/switches.hpp>
#include <quaoar/zones.hpp>

namespace quaoar {

/// Copied with every snapshot; what never changes is shared.
struct Workings {
    Signals signals;
    Switches switches;
    Movers movers;
    Zones zones;
    Crumbling crumbling;
    Respawns respawns;
    Monsters monsters;

    Workings() = default;
    /// Adds to the world what they need and puts bodies where they begin.
    explicit Workings(const Attempt& attempt);
    std::uint64_t hash() const;
};

}  // namespace quaoar
