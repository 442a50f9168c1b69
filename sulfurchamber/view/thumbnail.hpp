// Small pictures of scenes.
#pragma once

#include <atlax/canvas.hpp>
#include <atlax/image.hpp>
#include <optional>

#include "../model/workbench.hpp"

namespace sulfurchamber {

/// A camera that shows what is wanted, or else all that is interesting in a scene, on a picture of
/// this size.
atlax::Camera fittingCamera(const Document& document, atlax::PixelSize size,
                            const std::optional<Bounds>& wanted);

/// Draws what is open in `bench`, as it is now, into a picture of its own. In a frame of the
/// canvas. Throws atlax::Error when the card has no room.
atlax::Image thumbnail(atlax::Canvas& canvas, const Workbench& bench, atlax::PixelSize size);

}  // namespace sulfurchamber
