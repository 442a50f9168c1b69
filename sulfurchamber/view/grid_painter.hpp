// The grid of the background and the rulers at the edges, in metres.
#pragma once

#include <atlax/camera.hpp>
#include <atlax/canvas.hpp>

namespace sulfurchamber {

/// Distances in metres of the labelled lines and of the fine ones, fit for a zoom.
struct GridSteps {
    double labelled = 1;
    double fine = 0.2;
};
GridSteps gridSteps(float pixelsPerMetre, float scaleFactor);

void paintGrid(atlax::Canvas& canvas, const atlax::Camera& camera);
void paintRulers(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font);

}  // namespace sulfurchamber
