// What the four worlds look like, beyond the colours that a level chooses.
#pragma once

#include <atlax/color.hpp>
#include <cstdint>
#include <quaoar/level.hpp>

namespace quaoar {

/// What drifts through the air.
enum class Weather : std::uint8_t { snow, spores, embers, bubbles };

struct WorldLook {
    atlax::Color horizon;  ///< glow low in the sky
    atlax::Color haze;     ///< between the layers of the backdrop
    atlax::Color far;      ///< the farthest layer
    atlax::Color near;     ///< the nearest layer
    atlax::Color accent;   ///< lights far away, glints in the rock
    atlax::Color seep;     ///< light that has got into the rock
    atlax::Color cap;      ///< what lies on ground: snow, moss, plates, crystals
    Weather weather = Weather::snow;
    bool stars = true;  ///< and the ring and the moon
    bool sun = true;
};

const WorldLook& lookOf(Theme::World world);

}  // namespace quaoar
