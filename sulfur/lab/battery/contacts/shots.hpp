// Random shots, each of which its number repeats.
#pragma once

#include <string>
#include <vector>

#include "battery/row.hpp"

namespace sulfur::lab {

/// What became of a shot.
struct ShotResult {
    std::string projectile, target;
    bool through = false;   ///< it is where it can only be by passing through, or is not finite
    bool inner = false;     ///< a particle without a surface, which touches nothing, ended there
    double energyGain = 0;  ///< largest gain of World::energy over the start, share of that
};

/// One tick of a shot.
struct ShotTick {
    double time = 0;                ///< s
    double x = 0, y = 0;            ///< m, the projectile's centre of mass
    double speedX = 0, speedY = 0;  ///< m/s, of that
    double energy = 0;              ///< J
    int contacts = 0;
    bool through = false;
};

/// Even numbers: a rod, a crate, a jelly or a ball at up to 300 m/s in a closed room of walls of
/// 2 to 10 cm, for 0.2 s; nothing of its surface may be behind the walls' axes. Odd numbers: the
/// same at the middle of a plank, a crate, a jelly, a rope or a large ball, which rests or moves;
/// the middle of the projectile's surface may never be behind the surface at which it was aimed,
/// and at the end no particle of it.
/// `ticks` gets each tick, `setup.album` a picture of the end, if they are there.
ShotResult shoot(long number, const Setup& setup, std::vector<ShotTick>* ticks = nullptr);

/// A shot with all its ticks.
struct ShotReplay {
    long number = 0;
    ShotResult result;
    std::vector<ShotTick> ticks;
};
ShotReplay replayShot(long number, const Setup& setup);

std::string asText(const ShotReplay& replay);
std::string asCsv(const ShotReplay& replay);
std::string asJson(const ShotReplay& replay);

}  // namespace sulfur::lab
