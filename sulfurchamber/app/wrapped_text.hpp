// Texts of panels that take as many lines as they need.
#pragma once

#include <wx/stattext.h>

namespace sulfurchamber {

/// Shows words on as many lines as they need at this width, for the next layout.
inline void showWrapped(wxStaticText& text, const wxString& words, int width) {
    text.SetLabel(words);
    text.Wrap(width);
    text.InvalidateBestSize();  // else it keeps the height that it had before it was wrapped
}

}  // namespace sulfurchamber
