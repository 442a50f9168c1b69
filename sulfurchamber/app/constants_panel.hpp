// A page of the side panel: sliders for what one wants to feel, numbers for what one wants to know.
#pragma once

#include <wx/scrolwin.h>
#include <wx/stattext.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../view/scene_view.hpp"
#include "value_row.hpp"

namespace sulfurchamber {

class ConstantsPanel final : public wxScrolledWindow {
public:
    /// `refuse` tells the user in one sentence why a number was not taken.
    ConstantsPanel(wxWindow* parent, Workbench& bench, SceneView& view,
                   std::function<void(const std::string&)> refuse);
    ~ConstantsPanel() override;

    /// Shows what the document and the simulation say now. Cheap; may be called often.
    void refresh();

private:
    void addHeading(const wxString& text, wxSizer* sizer);
    void addStatistics(wxSizer* sizer);
    void addConstants(wxSizer* sizer);
    void addRain(wxSizer* sizer);

    Workbench& bench_;
    SceneView& view_;
    std::function<void(const std::string&)> refuse_;
    std::vector<std::unique_ptr<ValueRow>> rows_;
    std::vector<wxStaticText*> statistics_;
};

}  // namespace sulfurchamber
