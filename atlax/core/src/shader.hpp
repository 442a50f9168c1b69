#pragma once

#include <epoxy/gl.h>

#include <vector>

namespace atlax::detail {

/// The program that draws everything; see shader.cpp for its modes. `paint` is a caller's function
/// of Canvas::createShader, or null for the canvas's own program. Throws Error with the driver's
/// message when it does not compile. The context must be current.
GLuint buildCanvasProgram(const char* paint = nullptr);

/// A program of any other kind, from sources without their "#version" line. Throws in the same way.
GLuint buildProgram(const char* vertexPart, const std::vector<const char*>& fragmentParts);

}  // namespace atlax::detail
