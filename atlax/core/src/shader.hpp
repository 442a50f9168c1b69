#pragma once

#include <epoxy/gl.h>

namespace atlax::detail {

/// The one program that draws everything; see shader.cpp for its modes. Throws Error with the
/// driver's message when it does not compile. The context must be current.
GLuint buildCanvasProgram();

}  // namespace atlax::detail
