// A page of the side panel: what is selected, one body or many, and its properties.
#pragma once

#include <wx/bmpbuttn.h>
#include <wx/button.h>
#include <wx/checkbox.h>
#include <wx/choice.h>
#include <wx/clrpicker.h>
#include <wx/scrolwin.h>
#include <wx/stattext.h>
#include <wx/textctrl.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "../model/properties.hpp"
#include "../model/switches.hpp"
#include "../model/transform.hpp"
#include "../model/workbench.hpp"
#include "fitting_rows.hpp"
#include "skin_section.hpp"
#include "value_row.hpp"

namespace sulfurchamber {

class PropertiesPanel final : public wxScrolledWindow {
public:
    /// `run` performs an action of the menus, `refuse` tells the user in one sentence why something
    /// was not taken.
    PropertiesPanel(wxWindow* parent, Workbench& bench,
                    const std::function<void(const std::string&)>& run,
                    std::function<void(const std::string&)> refuse);
    ~PropertiesPanel() override;

    /// Shows what is selected now. Cheap; may be called often.
    void refresh();
    /// Of the swatch, which has a stripe for each.
    std::size_t swatchColours() const { return colours_->IsShown() ? stripes_.size() : 1; }

private:
    void makeHead(wxSizer* sizer);
    void makeLook(wxSizer* table);
    void bindHead();
    void makeLayers(wxSizer* sizer);
    void makeSwitches(wxSizer* sizer);
    void showSwitches();
    void addPlace(wxSizer* sizer, const PlaceProperty& property);
    void addNumber(wxSizer* sizer, const NumberProperty& property);
    /// Runs a change of the selection as one step; what is wrong is told.
    void change(const std::string& label, const std::function<void()>& what);
    void rename();
    void readSelection();
    void showHead();
    void showColours();
    void showMembership();

    Workbench& bench_;
    std::function<void(const std::string&)> refuse_;
    wxStaticText* title_ = nullptr;
    wxStaticText* membership_ = nullptr;  ///< of which instance it is a part
    std::unique_ptr<SkinSection> skinSection_;
    wxTextCtrl* name_ = nullptr;
    wxChoice* preset_ = nullptr;
    wxCheckBox* held_ = nullptr;
    wxColourPickerCtrl* colour_ = nullptr;
    wxBitmapButton* colours_ = nullptr;  ///< instead of it where they have several
    std::vector<wxColour> stripes_;      ///< that it shows
    wxButton* ownColour_ = nullptr;
    wxStaticText* colourName_ = nullptr;
    wxTextCtrl* skin_ = nullptr;
    std::vector<wxCheckBox*> switches_;  ///< in the order of switchProperties()
    std::array<wxCheckBox*, layerCount> layers_{};
    wxSizer* body_ = nullptr;               ///< all below the title
    std::unique_ptr<FittingRows> fitting_;  ///< instead of what bodies have
    std::vector<std::unique_ptr<ValueRow>> places_;
    double turned_ = 0;  ///< degrees by which many have been turned in the open step

    /// A row, what the selection has in common, and what it had when it was selected.
    struct Number {
        const NumberProperty* property = nullptr;
        std::unique_ptr<ValueRow> row;
        Common now;
        Common first;
    };
    std::vector<Number> numbers_;
    std::vector<std::string> shownIds_;
    std::uint64_t shownRevision_ = 0;
    bool fresh_ = true;
};

}  // namespace sulfurchamber
