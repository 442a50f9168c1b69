// The pictures on buttons and on the window, drawn here as SVG.
#pragma once

#include <wx/bmpbndl.h>

#include <string_view>

namespace sulfurchamber {

/// A picture of `size` by `size` logical pixels that fits the theme (light strokes on dark panels
/// or the other way round). An unknown name gives an empty bundle.
wxBitmapBundle icon(std::string_view name, int size = 24);

/// The program's own picture.
wxBitmapBundle programIcon();

}  // namespace sulfurchamber
