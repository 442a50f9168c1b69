// The camera that shows a scene as a whole.
#pragma once

#include <atlax/canvas.hpp>
#include <optional>

#include "../model/document.hpp"
#include "../model/geometry.hpp"

namespace sulfurchamber {

/// A camera that shows what is wanted, or else all that is interesting in a scene, on a picture of
/// this size.
atlax::Camera fittingCamera(const Document& document, atlax::PixelSize size,
                            const std::optional<Bounds>& wanted);

}  // namespace sulfurchamber
