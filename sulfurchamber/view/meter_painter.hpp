// Draws the meters that stand in a scene, with what they show.
#pragma once

#include <atlax/camera.hpp>
#include <atlax/canvas.hpp>
#include <atlax/font.hpp>
#include <string>

#include "../model/workbench.hpp"

namespace sulfurchamber {

/// Over the bodies, `alpha` as Application::draw has it. Leaves the canvas in screen space.
void paintMeters(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
                 const Workbench& bench, double alpha);

/// "1.204 m", "30.0°", "-12.4 N": what stands at a meter; "–" where there is nothing to read.
std::string meterText(const Meters& meters, const Meter& meter);

}  // namespace sulfurchamber
