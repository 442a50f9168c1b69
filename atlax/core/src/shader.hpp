#pragma once

#include <epoxy/gl.h>

namespace atlax::detail {

/// The program that draws everything; see shader.cpp for its modes. `paint` is a caller's function
/// of Canvas::createShader, or null for the canvas's own program. Throws Error with the driver's
/// message when it does not compile. The context must be current.
GLuint buildCanvasProgram(const char* paint = nullptr);

}  // namespace atlax::detail
