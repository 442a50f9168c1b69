// The panel at the side: sliders for what one wants to feel, numbers for what one wants to know.
#pragma once

#include <wx/panel.h>
#include <wx/scrolwin.h>
#include <wx/stattext.h>

#include <functional>
#include <memory>
#include <vector>

#include "../view/scene_view.hpp"

namespace sulfurchamber {

class ConstantsPanel final : public wxScrolledWindow {
public:
    ConstantsPanel(wxWindow* parent, Workbench& bench, SceneView& view);
    ~ConstantsPanel() override;

    /// Shows what the document and the simulation say now. Cheap; may be called often.
    void refresh();

private:
    struct Row;
    void addRow(std::unique_ptr<Row> row, wxSizer* sizer);
    void addHeading(const wxString& text, wxSizer* sizer);
    void addStatistics(wxSizer* sizer);
    void makeRows(wxSizer* sizer);

    Workbench& bench_;
    SceneView& view_;
    std::vector<std::unique_ptr<Row>> rows_;
    std::vector<wxStaticText*> statistics_;
};

}  // namespace sulfurchamber
