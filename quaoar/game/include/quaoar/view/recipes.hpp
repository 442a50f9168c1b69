// Sounds made from recipes: no recordings, no files.
#pragma once

#include <cstdint>
#include <vector>

namespace quaoar {

inline constexpr int soundRate = 44100;

/// All short sounds of the game.
enum class Effect : std::uint8_t {
    shoot,
    miss,  ///< the rope flew to its end and falls
    release,
    slip,
    cut,
    stickIce,
    stickMetal,
    stickRock,
    stickSoft,
    bumpIce,
    bumpMetal,
    bumpRock,
    bumpSoft,
    snap,  ///< something broke
    crumble,
    switched,
    checkpoint,
    pickup,
    notice,  ///< a monster has seen somebody
    defeat,
    die,
    finish,
    restart,
    click,
};
inline constexpr std::size_t effectCount = static_cast<std::size_t>(Effect::click) + 1;

/// Mono samples, soundRate a second.
std::vector<float> recipeOf(Effect effect);
/// A loop: grains of filtered noise, like a taut cord under load.
std::vector<float> creakLoop();
/// A loop: the hum of a cord that is about to burst.
std::vector<float> humLoop();

}  // namespace quaoar
