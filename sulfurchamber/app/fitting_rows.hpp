// What the property panel shows of a mechanism, a zone or a thruster.
#pragma once

#include <wx/choice.h>
#include <wx/sizer.h>
#include <wx/stattext.h>
#include <wx/window.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../model/fitting_properties.hpp"
#include "../model/workbench.hpp"
#include "value_row.hpp"

namespace sulfurchamber {

class FittingRows {
public:
    /// The windows belong to the parent; the rows must live as long as they.
    FittingRows(wxWindow* parent, wxSizer* sizer, Workbench& bench,
                std::function<void(const std::string&)> refuse);

    /// Shows the fitting that is selected; nothing where none is. Returns whether rows have come or
    /// gone, so that the parent lays itself out.
    bool refresh();

private:
    void addKeyChoice(wxWindow* parent, wxSizer* sizer, const char* label, bool forward);
    void addRow(wxWindow* parent, wxSizer* sizer, const FittingProperty& property);
    void chooseKey(bool forward, const std::string& key);
    void showKeys(const std::optional<DriveKeys>& keys);
    /// Of the fitting that is selected.
    std::optional<double> valueOf(const FittingProperty& property) const;

    Workbench& bench_;
    std::function<void(const std::string&)> refuse_;
    wxBoxSizer* keys_ = nullptr;
    wxChoice* forward_ = nullptr;
    wxChoice* back_ = nullptr;
    struct Row {
        const FittingProperty* property = nullptr;
        std::unique_ptr<ValueRow> row;
        std::optional<double> first;
        bool shown = false;
    };
    std::vector<Row> rows_;
    std::optional<FittingRef> shown_;
    std::uint64_t revision_ = 0;
    bool fresh_ = true;
};

}  // namespace sulfurchamber
