#include "side_panel.hpp"

#include <wx/sizer.h>

#include <algorithm>

#include "constants_panel.hpp"
#include "library_panel.hpp"
#include "measure_panel.hpp"
#include "outline_panel.hpp"
#include "properties_panel.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {

SidePanel::SidePanel(wxWindow* parent, Workbench& bench, SceneView& view, TemplateDesk& desk,
                     Thumbnails& thumbnails, const std::function<void(const std::string&)>& run,
                     const std::function<void(const std::string&)>& refuse)
    : wxChoicebook(parent, wxID_ANY), bench_(bench) {
    constants_ = new ConstantsPanel(this, bench, view, refuse);
    properties_ = new PropertiesPanel(this, bench, run, refuse);
    library_ = new LibraryPanel(this, bench, desk, thumbnails, run, refuse);
    outline_ = new OutlinePanel(this, bench, view, refuse);
    addPage("scene", constants_, "Scene");
    addPage("object", properties_, "Object");
    makeHistory();
    measures_ = new MeasurePanel(this, bench, view);
    addPage("measure", measures_, "Measure");
    addPage("outline", outline_, "Outline");
    addPage("library", library_, "Library");
}

// A click goes to the moment after a step.
void SidePanel::makeHistory() {
    history_ = new wxListBox(this, wxID_ANY, wxDefaultPosition, wxDefaultSize, 0, nullptr,
                             wxLB_SINGLE | wxBORDER_NONE);
    history_->SetToolTip(wxTr("All steps; a click goes back or forth to one"));
    addPage("history", history_, "History");
    history_->Bind(wxEVT_LISTBOX, [this](wxCommandEvent& event) {
        bench_.goToStep(static_cast<std::size_t>(std::max(0, event.GetInt())));
    });
}

void SidePanel::refreshHistory() {
    const Document& document = bench_.document();
    std::vector<std::string> labels{"As it was opened"};
    for (std::string& label : document.history()) labels.push_back(std::move(label));
    const std::size_t place = document.historyPlace();
    if (labels == shownHistory_ && place == shownPlace_) return;
    if (labels != shownHistory_) {
        wxArrayString lines;
        for (const std::string& label : labels) lines.Add(wxTr(label));
        history_->Set(lines);
    }
    history_->SetSelection(static_cast<int>(place));
    history_->EnsureVisible(static_cast<int>(place));
    shownHistory_ = std::move(labels);
    shownPlace_ = place;
}

void SidePanel::refresh() {
    if (GetCurrentPage() == constants_) constants_->refresh();
    if (GetCurrentPage() == properties_) properties_->refresh();
    if (GetCurrentPage() == history_) refreshHistory();
    // Stages are timed only while somebody looks.
    const bool looking = GetCurrentPage() == measures_ && IsShownOnScreen();
    measures_->watch(looking);
    if (looking) measures_->refresh();
    if (GetCurrentPage() == outline_) outline_->refresh();
    if (GetCurrentPage() == library_) library_->refresh();
}

void SidePanel::addPage(const std::string& name, wxWindow* page, const char* title) {
    names_.push_back(name);
    AddPage(page, wxTr(title));
}

bool SidePanel::showPage(const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return false;
    ChangeSelection(static_cast<std::size_t>(found - names_.begin()));
    refresh();
    return true;
}

}  // namespace sulfurchamber
