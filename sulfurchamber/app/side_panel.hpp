// What stands beside the scene.
#pragma once

#include <wx/notebook.h>

#include <functional>
#include <string>

#include "../view/scene_view.hpp"

namespace sulfurchamber {

class ConstantsPanel;

class SidePanel final : public wxNotebook {
public:
    /// `refuse` tells the user in one sentence why something was not taken.
    SidePanel(wxWindow* parent, Workbench& bench, SceneView& view,
              std::function<void(const std::string&)> refuse);

    /// Shows what the document and the simulation say now. Cheap; may be called often.
    void refresh();

private:
    ConstantsPanel* constants_ = nullptr;
};

}  // namespace sulfurchamber
