// What stands beside the scene.
#pragma once

#include <wx/choicebk.h>
#include <wx/listbox.h>

#include <functional>
#include <string>
#include <vector>

#include "../view/scene_view.hpp"

namespace sulfurchamber {

class ConstantsPanel;
class LibraryPanel;
class MeasurePanel;
class OutlinePanel;
class PropertiesPanel;
class TemplateDesk;
class Thumbnails;

class SidePanel final : public wxChoicebook {
public:
    /// `refuse` tells the user in one sentence why something was not taken.
    /// `run` performs an action of the menus.
    SidePanel(wxWindow* parent, Workbench& bench, SceneView& view, TemplateDesk& desk,
              Thumbnails& thumbnails, const std::function<void(const std::string&)>& run,
              const std::function<void(const std::string&)>& refuse);

    LibraryPanel& library() { return *library_; }
    /// Shows what the document and the simulation say now. Cheap; may be called often.
    void refresh();
    /// `title` is the English that is translated.
    void addPage(const std::string& name, wxWindow* page, const char* title);
    /// Brings a page to the front: "scene", "object", "history", "measure", "outline", "library",
    /// or one that was added. False when there is no such page.
    bool showPage(const std::string& name);
    const PropertiesPanel& properties() const { return *properties_; }
    MeasurePanel& measures() { return *measures_; }
    OutlinePanel& outline() { return *outline_; }

private:
    void makeHistory();
    void refreshHistory();

    Workbench& bench_;
    std::vector<std::string> names_;  // of the pages, in their order
    LibraryPanel* library_ = nullptr;
    ConstantsPanel* constants_ = nullptr;
    PropertiesPanel* properties_ = nullptr;
    MeasurePanel* measures_ = nullptr;
    OutlinePanel* outline_ = nullptr;
    wxListBox* history_ = nullptr;
    std::vector<std::string> shownHistory_;
    std::size_t shownPlace_ = 0;
};

}  // namespace sulfurchamber
