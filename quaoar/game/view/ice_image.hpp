// The inside of a block of ice or rock as a picture.
#pragma once

#include <atlax/color.hpp>
#include <atlax/image.hpp>
#include <atlax/vec.hpp>
#include <cstdint>
#include <vector>

namespace quaoar {

struct InsideLook {
    atlax::Color core, seep;
    float depth = 1.25f;  ///< metres until the light is gone
    float strata = 1;     ///< 0..1: how strongly layers and clouds show
    bool panels = false;  ///< straight plates instead of clouds
    std::uint32_t seed = 1;
};

/// The block within `loop`, as far as it lies in `box`: light that seeps in from the border, and
/// clouds and layers in it. Transparent outside of the border, from which it keeps a pixel away.
atlax::Image insideImage(const std::vector<atlax::Vec2>& loop, atlax::Rect box,
                         const InsideLook& look);

}  // namespace quaoar
