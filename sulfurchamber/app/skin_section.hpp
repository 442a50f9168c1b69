// The part of the object page that is about skins: which picture, and where it lies.
#pragma once

#include <wx/button.h>
#include <wx/sizer.h>
#include <wx/stattext.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../model/skins.hpp"
#include "../model/workbench.hpp"
#include "value_row.hpp"

namespace sulfurchamber {

/// Its windows belong to the parent; it must live as long as they.
class SkinSection {
public:
    /// `run` performs an action of the menus; `refuse` tells why something was not taken.
    SkinSection(wxWindow* parent, wxSizer* sizer, Workbench& bench,
                std::function<void(const std::string&)> run,
                std::function<void(const std::string&)> refuse);

    /// Shows what is selected now; to be called when the selection or the document has changed.
    void read();
    /// Cheap; may be called often.
    void refresh();

private:
    void addNumber(wxWindow* parent, wxSizer* sizer, const wxString& name, const wxString& unit,
                   double low, double high, double (*get)(const SkinMapping&),
                   void (*set)(SkinMapping&, double));

    Workbench& bench_;
    std::function<void(const std::string&)> refuse_;
    wxButton* choose_ = nullptr;
    wxButton* handles_ = nullptr;
    wxButton* remove_ = nullptr;
    std::vector<std::unique_ptr<ValueRow>> rows_;
    std::optional<SkinMapping> mapping_;  ///< of the one body that is selected
};

}  // namespace sulfurchamber
