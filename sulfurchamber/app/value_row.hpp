// One quantity of a panel: its name, a slider, the number with its unit, and a button that resets
// it.
#pragma once

#include <wx/bmpbuttn.h>
#include <wx/sizer.h>
#include <wx/slider.h>
#include <wx/stattext.h>
#include <wx/textctrl.h>

#include <functional>
#include <optional>
#include <string>

#include "../model/properties.hpp"

namespace sulfurchamber {

constexpr int fieldEdges = 20;  ///< of a field beside its text, in pixels of a usual screen

/// What a row shows and does.
struct ValueSpec {
    wxString name;
    wxString unit;
    wxString help;  ///< one line for the tooltip
    double low = 0;
    double high = 1;
    Scale scale = Scale::linear;
    bool whole = false;  ///< without a fraction
    bool moves = false;  ///< changes by itself: what one types is left alone
    wxString endless;    ///< not empty: the slider's upper end is infinity, and this is its word
    /// The value now; nothing: it is not the same for all that is meant.
    std::function<std::optional<double>()> get;
    /// Where the button leads back to; nothing or an empty function: it has no such value.
    std::function<std::optional<double>()> initial;
    /// Sets it as a part of a step of the history.
    std::function<void(double)> set;
    /// Ends the step.
    std::function<void()> finish;
    /// A value was refused: one sentence.
    std::function<void(const std::string&)> refuse;
};

/// The windows of a row. They belong to the parent; the row must live as long as they.
///
/// A drag of the slider is one step of the history, a typed number another. A number that is out of
/// range is refused with the range, and nothing changes. What the document says is shown at once,
/// also while one types: then the document has changed.
class ValueRow {
public:
    ValueRow(wxWindow* parent, wxSizer* sizer, ValueSpec spec);
    ValueRow(const ValueRow&) = delete;
    ValueRow& operator=(const ValueRow&) = delete;

    /// Shows what the document says now. Cheap; may be called often.
    void refresh();
    /// Marks it as something that differs from a template.
    void mark(bool on);
    /// Hides it where it means nothing.
    void show(bool on);
    const ValueSpec& spec() const { return spec_; }

private:
    double share(double value) const;
    double ofShare(double share) const;
    int position(double value) const;
    double value(int position) const;
    wxString text(std::optional<double> value) const;
    void enter(bool leaving);
    void takeBack();
    void makeTop(wxWindow* parent);
    void makeSlider(wxWindow* parent);
    void bind();

    ValueSpec spec_;
    wxBoxSizer* whole_ = nullptr;
    wxBoxSizer* top_ = nullptr;
    wxBoxSizer* bottom_ = nullptr;
    wxStaticText* name_ = nullptr;
    wxTextCtrl* number_ = nullptr;
    wxBitmapButton* revert_ = nullptr;
    wxSlider* slider_ = nullptr;
    std::optional<double> shown_;
    bool fresh_ = true;  ///< nothing was shown yet
    bool sliding_ = false;
    bool marked_ = false;
};

}  // namespace sulfurchamber
