// Colours of the scene, as wxWidgets takes them.
#pragma once

#include <wx/colour.h>

#include <algorithm>

#include "../view/palette.hpp"

namespace sulfurchamber {

inline wxColour wxOf(const atlax::Color& color) {
    const auto byte = [](float value) {
        return static_cast<unsigned char>(std::clamp(value, 0.0f, 1.0f) * 255);
    };
    return {byte(color.r), byte(color.g), byte(color.b), byte(color.a)};
}

}  // namespace sulfurchamber
