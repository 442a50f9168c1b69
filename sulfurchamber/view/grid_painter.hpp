// The grid of the background and the rulers at the edges, in metres.
#pragma once

#include <array>
#include <atlax/camera.hpp>
#include <atlax/canvas.hpp>

namespace sulfurchamber {

/// Steps of the fine lines that one can choose, metres.
inline constexpr std::array<double, 4> gridStepChoices{0.1, 0.25, 0.5, 1};

/// Distances in metres of the labelled lines and of the fine ones, fit for a zoom.
struct GridSteps {
    double labelled = 1;
    double fine = 0.2;
};
/// `chosen` is the step of the fine lines; 0: it follows the zoom.
GridSteps gridSteps(float pixelsPerMetre, float scaleFactor, double chosen = 0);

/// Fine lines that would stand too close are left out.
void paintGrid(atlax::Canvas& canvas, const atlax::Camera& camera, double chosen = 0);
void paintRulers(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
                 double chosen = 0);

}  // namespace sulfurchamber
