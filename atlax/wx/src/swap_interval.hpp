#pragma once

namespace atlax::wx {

/// Whether swapping the buffers of the current context waits for the display. wxWidgets 3.2 has no
/// call for this. Where the driver does not offer the choice, nothing happens.
void setSwapInterval(bool waitForDisplay);

}  // namespace atlax::wx
