// A lesson above the scene: what to do now, and buttons to be shown it or to skip it.
#pragma once

#include <wx/button.h>
#include <wx/panel.h>
#include <wx/sizer.h>
#include <wx/stattext.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "../model/lessons.hpp"
#include "../view/scene_view.hpp"

namespace sulfurchamber {

class LessonPanel final : public wxPanel {
public:
    /// All must outlive the panel, which is hidden at first. `act` runs an action of the menus,
    /// `played` tells the seconds of the play-test that goes on, 0 while none does.
    LessonPanel(wxWindow* parent, Workbench& bench, SceneView& view,
                std::function<void(const std::string&)> act, std::function<double()> played);

    /// Begins a lesson with what is open, and appears.
    void start(const Lesson& lesson);
    /// Ends it, wherever it is, and disappears.
    void stop();
    bool running() const { return run_.has_value(); }
    /// The one that is taken; null when there is none.
    const LessonRun* run() const { return run_ ? &*run_ : nullptr; }
    /// Lets the hand do the present step.
    void showStep();
    bool showing() const { return hand_.has_value(); }
    void skipStep();
    /// Each frame: moves the hand, looks what was done.
    void refresh();

private:
    void tell();
    void wrap();
    void guarded(const std::function<void()>& body);

    Workbench& bench_;
    SceneView& view_;
    std::function<void(const std::string&)> act_;
    std::function<double()> played_;
    std::optional<LessonRun> run_;
    std::optional<Hand> hand_;
    std::int64_t movedNs_ = 0;
    wxBoxSizer* top_ = nullptr;  // title and buttons
    wxStaticText* title_ = nullptr;
    wxStaticText* text_ = nullptr;
    wxButton* show_ = nullptr;
    wxButton* skip_ = nullptr;
    wxString words_;
};

}  // namespace sulfurchamber
