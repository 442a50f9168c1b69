// The actions of templates, and the dialog that asks for a new one's name.
#include <wx/checkbox.h>
#include <wx/combobox.h>
#include <wx/dialog.h>
#include <wx/sizer.h>
#include <wx/textctrl.h>

#include <set>

#include "library_panel.hpp"
#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

/// Asks for name and category, and where the file shall lie.
class TemplateDialog final : public wxDialog {
public:
    TemplateDialog(wxWindow* parent, const Library& library, const std::string& name)
        : wxDialog(parent, wxID_ANY, wxTr("Save as a template")) {
        std::set<std::string> categories;
        for (const auto& entry : library.entries()) categories.insert(entry.category);
        wxArrayString known;
        for (const auto& category : categories) known.Add(wxString::FromUTF8(category));
        name_ = new wxTextCtrl(this, wxID_ANY, wxString::FromUTF8(name), wxDefaultPosition,
                               FromDIP(wxSize(220, -1)));
        category_ = new wxComboBox(this, wxID_ANY, known.empty() ? wxString("Other") : known[0],
                                   wxDefaultPosition, wxDefaultSize, known);
        beside_ = new wxCheckBox(this, wxID_ANY, wxTr("Keep it beside the scene, for others"));
        beside_->Enable(!library.sceneFolder().empty());
        auto* table = new wxFlexGridSizer(2, FromDIP(6), FromDIP(10));
        table->AddGrowableCol(1);
        const auto add = [&](const char* label, wxWindow* window) {
            table->Add(new wxStaticText(this, wxID_ANY, wxTr(label)),
                       wxSizerFlags(0).CentreVertical());
            table->Add(window, wxSizerFlags(1).Expand());
        };
        add("Name", name_);
        add("Category", category_);
        auto* rows = new wxBoxSizer(wxVERTICAL);
        rows->Add(table, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(16)));
        rows->Add(beside_, wxSizerFlags(0).Border(wxLEFT | wxRIGHT, FromDIP(16)));
        rows->Add(CreateButtonSizer(wxOK | wxCANCEL),
                  wxSizerFlags(0).Expand().Border(wxALL, FromDIP(16)));
        SetSizerAndFit(rows);
        if (auto* ok = FindWindow(wxID_OK)) ok->SetLabel(wxTr("Save"));
        name_->SelectAll();
        name_->SetFocus();
        CentreOnParent();
    }
    std::string name() const { return name_->GetValue().Strip(wxString::both).utf8_string(); }
    std::string category() const {
        return category_->GetValue().Strip(wxString::both).utf8_string();
    }
    bool beside() const { return beside_->GetValue(); }

private:
    wxTextCtrl* name_ = nullptr;
    wxComboBox* category_ = nullptr;
    wxCheckBox* beside_ = nullptr;
};

}  // namespace

void MainFrame::saveTemplateDialog() {
    desk_.followSceneFolder();
    const auto& selection = bench_.selection();
    const std::string first = selection.empty() ? "" : bench_.document().idOf(selection.front());
    TemplateDialog dialog(this, desk_.library(), first);
    if (dialog.ShowModal() != wxID_OK) return;
    desk_.save(dialog.name(), dialog.category(), dialog.beside());
}

void MainFrame::dropTemplate(const std::string& name, wxPoint screen) {
    const wxPoint at = canvas_->ScreenToClient(screen);
    if (!wxRect(canvas_->GetClientSize()).Contains(at)) return;
    const auto scale = static_cast<float>(canvas_->GetContentScaleFactor());
    const atlax::Vec2 pixels{static_cast<float>(at.x) * scale, static_cast<float>(at.y) * scale};
    try {
        desk_.place(name, view_.toWorld(pixels));
    } catch (const std::exception& problem) {
        tell(problem.what());
    }
    canvas_->SetFocus();
}

std::string MainFrame::templateInQuestion() const {
    std::string name = side_->library().chosen();
    return name.empty() ? desk_.selectedTemplate() : name;
}

// One of the program's own templates is copied first: its file is not the user's.
void MainFrame::editTemplate() {
    const LibraryEntry* entry = desk_.library().find(templateInQuestion());
    if (entry == nullptr || !mayDiscard()) return;
    std::filesystem::path file = entry->file;
    if (entry->origin == LibraryEntry::Origin::starter)
        file = desk_.library().save(Library::load(*entry), false);
    openFile(file);
}

void MainFrame::addTemplateActions() {
    const auto m = MenuId::edit;
    const wxString under = "Template";
    const auto any = [this] { return !bench_.selection().empty(); };
    const auto member = [this] { return desk_.anySelected(); };
    // A template follows one instance only.
    const auto oneInstance = [this] {
        return instancesOf(bench_.document(), bench_.selection()).size() == 1;
    };
    const auto inLibrary = [this] {
        return desk_.library().find(desk_.selectedTemplate()) != nullptr;
    };
    const auto entry = [&](const char* name, const wxString& label, const char* help,
                           std::function<void()> run, std::function<bool()> enabled) {
        add({name, m, label, 0, help, "", std::move(run), std::move(enabled)}).under = under;
    };
    entry(
        "template-save", wxString::FromUTF8("&Save the selection as a template\xE2\x80\xA6"),
        "Keep what is selected, with what ties it together, to place it again",
        [this] { saveTemplateDialog(); }, any);
    entry(
        "template-place", "&Place the chosen template",
        "Each click into the scene places the template that is chosen in the library",
        [this] {
            const std::string name = side_->library().chosen();
            if (!name.empty()) desk_.hold(name);
        },
        [this] { return !side_->library().chosen().empty(); });
    entry(
        "template-update", "&Update the template from this instance",
        "The template becomes as the one instance that is selected; all others follow",
        [this] { desk_.updateFromSelection(); }, oneInstance);
    entry(
        "template-reset", "&Reset what differs", "Back to what the template has",
        [this] { desk_.resetSelection(side_->library().chosenOverride()); }, member);
    entry(
        "template-apply", "&Apply what differs to the template",
        "Give it to the template; all instances follow",
        [this] { desk_.applySelection(side_->library().chosenOverride()); }, member);
    entry(
        "template-take", "&Take the library's version",
        "The template of the scene becomes as the library has it; all instances follow",
        [this] { desk_.takeFromLibrary(); }, inLibrary);
    entry(
        "template-unlink", "U&nlink from the template", "It no longer follows the template",
        [this] { desk_.unlinkSelection(); }, member);
    entry(
        "template-edit", "&Edit the template's file",
        "Open the file of the template that is chosen or selected; saving it changes the template",
        [this] { editTemplate(); },
        [this] { return desk_.library().find(templateInQuestion()) != nullptr; });
}

// Only what says so is a template: any scene could be one.
void MainFrame::addTemplateDropUse() {
    const auto fits = [](const DroppedFile& dropped) {
        return dropped.kind == FileKind::scene &&
               sulfur::scene::read(dropped.file).section("template").has_value();
    };
    dropUses_.push_back(
        {"place", "&Place this template here", fits,
         [this](const DroppedFile& dropped) { desk_.placeFile(dropped.file, dropped.place); }});
}

}  // namespace sulfurchamber
