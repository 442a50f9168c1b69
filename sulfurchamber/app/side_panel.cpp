#include "side_panel.hpp"

#include "constants_panel.hpp"

namespace sulfurchamber {

SidePanel::SidePanel(wxWindow* parent, Workbench& bench, SceneView& view,
                     std::function<void(const std::string&)> refuse)
    : wxNotebook(parent, wxID_ANY) {
    constants_ = new ConstantsPanel(this, bench, view, std::move(refuse));
    AddPage(constants_, "Scene");
}

void SidePanel::refresh() {
    if (GetCurrentPage() == constants_) constants_->refresh();
}

}  // namespace sulfurchamber
