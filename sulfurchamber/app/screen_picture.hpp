// Pictures of the screen, OpenGL windows included.
#pragma once

#include <wx/gdicmn.h>

#include <filesystem>

namespace sulfurchamber {

/// Writes a part of the screen as PNG. Works under X11. Throws std::runtime_error or atlax::Error.
void saveScreen(const wxRect& part, const std::filesystem::path& file);

}  // namespace sulfurchamber
