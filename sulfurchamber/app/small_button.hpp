// Buttons of panels, where there is little room.
#pragma once

#include <wx/button.h>

namespace sulfurchamber {

/// A button that is as wide as its words and a little room beside them, which GTK leaves out.
inline wxButton* smallButton(wxWindow* parent, const wxString& label) {
    auto* made =
        new wxButton(parent, wxID_ANY, label, wxDefaultPosition, wxDefaultSize, wxBU_EXACTFIT);
    made->SetMinSize(made->GetBestSize() + parent->FromDIP(wxSize(12, 0)));
    return made;
}

}  // namespace sulfurchamber
