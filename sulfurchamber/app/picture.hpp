// A picture of the drawing area without a window.
#pragma once

#include "../model/workbench.hpp"
#include "options.hpp"

namespace sulfurchamber {

/// Plays `bench` for options.at seconds of simulated time and writes options.picture. Returns the
/// exit code; problems were told on standard error.
int writePicture(Workbench& bench, const Options& options);

}  // namespace sulfurchamber
