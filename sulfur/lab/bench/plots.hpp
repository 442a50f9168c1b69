// Logarithmic plots with axes that fit what they show.
#pragma once

#include <string>

#include "svg_plot.hpp"

namespace sulfur::lab::bench {

/// Sets the ticks and the range of a plot whose two axes are logarithmic so that all points are
/// within; points that are not positive or not finite are left out. Without any point the axes
/// run from 1 to 10.
void fitAxes(Plot& plot);

}  // namespace sulfur::lab::bench
