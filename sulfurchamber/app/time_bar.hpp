// The slider of time below the scene, with pictures of the past, marks and other futures.
#pragma once

#include <wx/button.h>
#include <wx/panel.h>

#include <functional>

#include "../view/scene_view.hpp"
#include "../view/time_bar_layout.hpp"

namespace sulfurchamber {

class TimeBar final : public wxPanel {
public:
    /// `chooseSpeed` is called with the button that was pressed: it shows a menu there.
    TimeBar(wxWindow* parent, Workbench& bench, SceneView& view,
            std::function<void(wxWindow&)> chooseSpeed);

    /// Shows what the document says now. Cheap; may be called often.
    void refresh();
    /// How high its pictures of the past are, pixels; the caller lays it out again if that is new.
    bool setPictureHeight(int height);
    /// How many of them it has shown last.
    int pictures() const;
    /// The part of it that shows time, in pixels of the screen; for scripts.
    wxRect trackOnScreen() const;

private:
    class Track;

    Workbench& bench_;
    SceneView& view_;
    Track* track_ = nullptr;
    wxButton* speed_ = nullptr;
};

}  // namespace sulfurchamber
