// A page of the side panel: all that the scene has, as a tree with a search.
#pragma once

#include <wx/listctrl.h>
#include <wx/panel.h>
#include <wx/srchctrl.h>

#include <functional>
#include <string>
#include <vector>

#include "../model/outliner.hpp"
#include "../view/scene_view.hpp"

namespace sulfurchamber {

class OutlinePanel final : public wxPanel {
public:
    /// `refuse` tells the user in one sentence why something was not taken.
    OutlinePanel(wxWindow* parent, Workbench& bench, SceneView& view,
                 std::function<void(const std::string&)> refuse);

    /// Shows what there is and what is selected. Cheap; may be called often.
    void refresh();
    void search(const std::string& text);
    /// For scripts: a place of a row on the screen. Parts are "name", "eye", "lock" and "arrow".
    wxPoint placeOnScreen(std::size_t row, const std::string& part) const;
    std::size_t rowCount() const { return rows_ == nullptr ? 0 : rows_->size(); }

private:
    // Asks for the rows that are seen, and for no others.
    class List;

    void bind();
    void clicked(wxMouseEvent& event);
    void select();
    void showSelection();
    void zoom(std::size_t row);
    void rename(std::size_t row);
    void popUp(std::size_t row);
    void guarded(const std::function<void()>& change);

    Workbench& bench_;
    SceneView& view_;
    std::function<void(const std::string&)> refuse_;
    Outliner outliner_;
    wxSearchCtrl* search_ = nullptr;
    List* list_ = nullptr;
    const std::vector<OutlineRow>* rows_ = nullptr;
    std::uint64_t shownVersion_ = 0;
    std::vector<sulfur::BodyId> shownSelection_;
    bool clickedRow_ = false;  // the button is down on a row
    bool showing_ = false;     // events of the list are its own
    bool selecting_ = false;   // select() is called soon
};

}  // namespace sulfurchamber
