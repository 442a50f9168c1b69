// What the player does in one tick, small and quantised so that recordings replay exactly.
#pragma once

#include <cstdint>
#include <sulfur/math.hpp>

namespace quaoar {

/// The player's wishes during one tick of 1/500 s. Whatever device they come from, they pass
/// through this type: what it cannot hold, the game cannot see.
struct TickInput {
    std::int16_t aimX = 32767;  ///< direction of the arm, y up; only the ratio counts
    std::int16_t aimY = 0;
    bool fire = false;     ///< held: the rope is wanted; its rising edge shoots
    bool reelIn = false;   ///< shorten the rope
    bool reelOut = false;  ///< lengthen it
    bool boost = false;    ///< reel twice as fast
    bool restart = false;  ///< back to the spawn, at once
    bool retry = false;    ///< back to the last checkpoint, at once; without one to the spawn
    std::int8_t push = 0;  ///< -127 left to 127 right; acts weakly, and only while swinging

    friend bool operator==(const TickInput&, const TickInput&) = default;
};

/// Sets the aim to a direction of any length; one that has none, or is not finite, changes nothing.
void setAim(TickInput& input, double x, double y);

/// The aim as a unit vector; the x axis when both components are zero. Uses nothing but a square
/// root, so it gives the same bits everywhere.
sulfur::Vec2 aimDirection(const TickInput& input);

}  // namespace quaoar
