// Draws forces as arrows, and the legend of what is drawn over a scene.
#pragma once

#include <atlax/camera.hpp>
#include <atlax/canvas.hpp>
#include <atlax/font.hpp>
#include <string>
#include <vector>

#include "scene_painter.hpp"

namespace sulfurchamber {

/// Logical pixels of an arrow of a newton: that of the heaviest body's weight is 70 long.
double pixelsPerNewton(const sulfur::World& world);

/// Gravity, contacts and joints, as the options want. Leaves the canvas in screen space.
void paintForces(atlax::Canvas& canvas, const atlax::Camera& camera, const sulfur::World& world,
                 const ViewOptions& options);

/// What arrows and colours mean, with the length of a round number each: in the lower right corner.
/// Leaves the canvas in screen space.
void paintLegend(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
                 const sulfur::World& world, const ViewOptions& options);

}  // namespace sulfurchamber
