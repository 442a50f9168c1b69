#include "library_panel.hpp"
#include "small_button.hpp"
#include "wx_words.hpp"

#include <wx/sizer.h>
#include <wx/wrapsizer.h>

#include <algorithm>

namespace sulfurchamber {

LibraryPanel::LibraryPanel(wxWindow* parent, Workbench& bench, TemplateDesk& desk,
                           Thumbnails& thumbnails, std::function<void(const std::string&)> run,
                           std::function<void(const std::string&)> refuse)
    : wxPanel(parent, wxID_ANY),
      bench_(bench),
      desk_(desk),
      run_(std::move(run)),
      refuse_(std::move(refuse)) {
    search_ = new wxSearchCtrl(this, wxID_ANY);
    search_->SetDescriptiveText(wxTr("Search templates"));
    search_->ShowCancelButton(true);
    grid_ = new PictureGrid(this, thumbnails);
    grid_->setEmptyText(wxTr("No template has these words"));
    auto* save = smallButton(this, wxTr("Save the selection\xE2\x80\xA6"));
    save->SetToolTip(wxTr("Make a template of what is selected"));
    save->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) { run_("template-save"); });
    auto* all = new wxBoxSizer(wxVERTICAL);
    const int gap = FromDIP(6);
    all->Add(search_, wxSizerFlags(0).Expand().Border(wxALL, gap));
    all->Add(grid_, wxSizerFlags(1).Expand());
    makeInstance(all);
    all->Add(save, wxSizerFlags(0).Expand().Border(wxALL, gap));
    SetSizer(all);

    search_->Bind(wxEVT_TEXT, [this](wxCommandEvent&) { showEntries(); });
    search_->Bind(wxEVT_SEARCHCTRL_CANCEL_BTN, [this](wxCommandEvent&) { search(""); });
    grid_->onChosen = [this](std::size_t) { run_("template-place"); };
    grid_->onDragged = [this](std::size_t item, wxPoint at) {
        if (onDropped) onDropped(grid_->items()[item].name, at);
    };
}

// What is told of instances only where one is selected.
void LibraryPanel::makeInstance(wxSizer* sizer) {
    instance_ = new wxPanel(this);
    auto* column = new wxBoxSizer(wxVERTICAL);
    text_ = new wxStaticText(instance_, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                             wxST_NO_AUTORESIZE | wxST_ELLIPSIZE_END);
    text_->SetFont(text_->GetFont().Bold());
    overrides_ = new wxListBox(instance_, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(-1, 74)));
    overrides_->SetToolTip(
        wxTr("What differs from the template; choose one to reset or apply it alone"));
    column->Add(text_, wxSizerFlags(0).Expand());
    column->Add(overrides_, wxSizerFlags(0).Expand().Border(wxTOP, FromDIP(4)));
    auto* buttons = new wxGridSizer(2, FromDIP(4), FromDIP(4));
    const auto button = [&](const char* label, const char* action, const char* help) {
        auto* made = new wxButton(instance_, wxID_ANY, wxTr(label), wxDefaultPosition,
                                  wxDefaultSize, wxBU_EXACTFIT);
        made->SetToolTip(wxTr(help));
        made->Bind(wxEVT_BUTTON, [this, action](wxCommandEvent&) { run_(action); });
        buttons->Add(made, wxSizerFlags(1).Expand());
        return made;
    };
    button("Reset", "template-reset", "Back to what the template has");
    button("Apply", "template-apply", "Give it to the template; all instances follow");
    update_ =
        button("Update template", "template-update",
               "The template becomes as the one instance that is selected; all others follow");
    button("Unlink", "template-unlink", "It no longer follows the template");
    newer_ = button("Take from library", "template-take",
                    "The library has another version; all instances become as it is");
    column->Add(buttons, wxSizerFlags(0).Expand().Border(wxTOP, FromDIP(4)));
    instance_->SetSizer(column);
    instance_->Hide();
    sizer->Add(instance_, wxSizerFlags(0).Expand().Border(wxLEFT | wxRIGHT | wxTOP, FromDIP(6)));
}

void LibraryPanel::search(const wxString& words) {
    search_->ChangeValue(words);
    showEntries();
}

std::string LibraryPanel::chosen() const {
    const auto item = grid_->chosen();
    return item ? grid_->items()[*item].name : "";
}

std::string LibraryPanel::chosenOverride() const {
    const int at = overrides_->GetSelection();
    return at == wxNOT_FOUND || !instance_->IsShown()
               ? ""
               : shownOverrides_[static_cast<std::size_t>(at)].key;
}

void LibraryPanel::showEntries() {
    std::vector<PictureGrid::Item> items;
    const auto known = definitions(bench_.document().scene());
    for (const LibraryEntry& entry : desk_.library().matching(search_->GetValue().utf8_string())) {
        PictureGrid::Item item;
        item.group = tr(entry.category);
        item.name = entry.name;
        item.label = tr(entry.name);
        item.help = item.label + ": " + tr(entry.description);
        const auto also = [&](const char* text) { item.help += "\n" + tr(text); };
        if (entry.origin == LibraryEntry::Origin::own) also("One of your own.");
        if (entry.origin == LibraryEntry::Origin::scene) also("It lies beside the scene.");
        item.file = entry.file;
        item.marked = std::find(known.begin(), known.end(), entry.name) != known.end() &&
                      differsFromLibrary(bench_.document().scene(), entry);
        if (item.marked) also("The scene has another version of it.");
        items.push_back(std::move(item));
    }
    grid_->show(std::move(items));
}

void LibraryPanel::showInstance() {
    const auto told = desk_.told();
    if (instance_->IsShown() == told.text.empty()) {
        instance_->Show(!told.text.empty());
        Layout();
    }
    if (told.text.empty()) return;
    wxString text = wxString::FromUTF8(told.text);
    if (told.ofInstance > 0)
        text = wxTr("{}: {} differ", {told.text, std::to_string(told.ofInstance)});
    text_->SetLabel(text);
    text_->SetToolTip(text);
    wxArrayString lines;
    for (const Override& one : told.overrides) lines.Add(wxTr(one.name));
    overrides_->Set(lines);
    shownOverrides_ = told.overrides;
    update_->Enable(instancesOf(bench_.document(), bench_.selection()).size() == 1);
    newer_->Enable(told.newerInLibrary);
}

void LibraryPanel::refresh() {
    grid_->refreshPictures();
    if (!IsShownOnScreen() && !fresh_) return;
    if (fresh_) {
        desk_.library().rescan();
        for (const std::string& problem : desk_.library().problems()) refuse_(problem);
    }
    desk_.followSceneFolder();
    // What the list shows, in one text: it is made anew only when that changes.
    std::string key;
    for (const LibraryEntry& entry : desk_.library().entries())
        key += entry.name + '\n' + entry.file.string() + '\n' + entry.description + '\n';
    const bool edited = shownRevision_ != bench_.document().revision();
    if (fresh_ || edited || key != shownKey_) showEntries();
    if (fresh_ || edited || shownSelection_ != bench_.selection()) showInstance();
    shownKey_ = std::move(key);
    shownRevision_ = bench_.document().revision();
    shownSelection_ = bench_.selection();
    fresh_ = false;
}

}  // namespace sulfurchamber
