// A page of the side panel: what a level is made of, what is wrong with it, and its proof.
#pragma once

#include <wx/button.h>
#include <wx/checkbox.h>
#include <wx/choice.h>
#include <wx/gauge.h>
#include <wx/listbox.h>
#include <wx/scrolwin.h>
#include <wx/sizer.h>
#include <wx/stattext.h>
#include <wx/textctrl.h>
#include <wx/tglbtn.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../level/level_stage.hpp"

namespace sulfurchamber {

/// Changes a field as one step of the history; throws std::runtime_error with what is allowed.
void changeField(Document& document, const LevelThing& thing, const LevelField& field,
                 const std::string& text);

class LevelPanel final : public wxScrolledWindow {
public:
    /// `perform` runs an action of the menus; `refuse` tells in one sentence why something was not
    /// taken.
    LevelPanel(wxWindow* parent, Workbench& bench, LevelStage& stage,
               std::function<void(const std::string&)> perform,
               std::function<void(const std::string&)> refuse);

    /// Shows what is now. Cheap; may be called often.
    void refresh();

private:
    void makeStart(wxSizer* sizer);
    void makePalette(wxSizer* sizer);
    void makeProof(wxSizer* sizer);
    void makeLists(wxSizer* sizer);
    wxStaticText* heading(const wxString& text);
    wxButton* button(const wxString& label, const wxString& help, const char* action);

    void refreshProof();
    void wrapProof();
    void refreshProblems();
    void refreshThings();
    void refreshFields();
    void makeFields();
    wxWindow* makeField(const LevelField& field, const std::string& text);
    void enter(const LevelField& field, const std::string& text);

    Workbench& bench_;
    LevelStage& stage_;
    std::function<void(const std::string&)> perform_;
    std::function<void(const std::string&)> refuse_;

    wxSizer* start_ = nullptr;  ///< where the scene is no level
    wxSizer* level_ = nullptr;  ///< where it is one
    std::vector<wxBitmapToggleButton*> pieces_;
    wxStaticText* proof_ = nullptr;
    wxGauge* gauge_ = nullptr;
    wxButton* solve_ = nullptr;
    wxButton* medals_ = nullptr;
    wxStaticText* problemsTitle_ = nullptr;
    wxListBox* problems_ = nullptr;
    wxListBox* things_ = nullptr;
    wxStaticText* fieldsTitle_ = nullptr;
    wxFlexGridSizer* fields_ = nullptr;

    /// The window of a field, and what it shows.
    struct Row {
        const LevelField* field = nullptr;
        wxWindow* window = nullptr;
        std::string shown;
    };
    std::vector<Row> rows_;
    std::optional<LevelThing> shownThing_;
    std::vector<LevelThing> listed_;
    std::vector<std::string> shownProblems_;
    std::vector<std::string> shownThings_;
    std::string shownProof_;
    int proofWidth_ = 0;  ///< at which it is wrapped
    std::optional<bool> wasLevel_;
};

}  // namespace sulfurchamber
