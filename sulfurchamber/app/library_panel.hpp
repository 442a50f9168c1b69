// A page of the side panel: all templates with pictures, and what the selection has to do with
// them.
#pragma once

#include <wx/button.h>
#include <wx/listbox.h>
#include <wx/panel.h>
#include <wx/srchctrl.h>
#include <wx/stattext.h>

#include <functional>
#include <string>
#include <vector>

#include "../model/template_desk.hpp"
#include "picture_grid.hpp"

namespace sulfurchamber {

class LibraryPanel final : public wxPanel {
public:
    /// `run` performs an action of the menus; `refuse` tells in one sentence what did not work.
    LibraryPanel(wxWindow* parent, Workbench& bench, TemplateDesk& desk, Thumbnails& thumbnails,
                 std::function<void(const std::string&)> run,
                 std::function<void(const std::string&)> refuse);

    /// Shows what the library and the document say now. Cheap; may be called often.
    void refresh();
    /// Shows templates whose names or categories have these words; for scripts.
    void search(const wxString& words);
    PictureGrid& grid() { return *grid_; }
    /// The template that is chosen; "" where none is.
    std::string chosen() const;
    /// The trait that is chosen in the list of what differs; "" where none is: all of them.
    std::string chosenOverride() const;

    /// A template was dragged to a place of the screen.
    std::function<void(const std::string&, wxPoint)> onDropped;

private:
    void showEntries();
    void showInstance();
    void makeInstance(wxSizer* sizer);

    Workbench& bench_;
    TemplateDesk& desk_;
    std::function<void(const std::string&)> run_;
    std::function<void(const std::string&)> refuse_;
    wxSearchCtrl* search_ = nullptr;
    PictureGrid* grid_ = nullptr;
    wxPanel* instance_ = nullptr;  ///< all of what is told of the selection
    wxStaticText* text_ = nullptr;
    wxListBox* overrides_ = nullptr;
    wxButton* update_ = nullptr;
    wxButton* newer_ = nullptr;
    std::vector<Override> shownOverrides_;
    std::string shownKey_;  ///< of what the list was made of
    std::uint64_t shownRevision_ = ~std::uint64_t{0};
    std::vector<sulfur::BodyId> shownSelection_;
    bool fresh_ = true;
};

}  // namespace sulfurchamber
