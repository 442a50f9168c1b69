#include "gallery.hpp"

#include <wx/button.h>
#include <wx/dialog.h>
#include <wx/listbox.h>
#include <wx/sizer.h>
#include <wx/stattext.h>

#include <algorithm>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <sulfur/scene.hpp>

namespace sulfurchamber {
namespace {

class GalleryDialog final : public wxDialog {
public:
    GalleryDialog(wxWindow* parent, const std::vector<Example>& examples)
        : wxDialog(parent, wxID_ANY, "Example scenes", wxDefaultPosition, wxDefaultSize,
                   wxDEFAULT_DIALOG_STYLE | wxRESIZE_BORDER),
          examples_(examples) {
        wxArrayString titles;
        for (const Example& example : examples) titles.Add(wxString::FromUTF8(example.title));
        list_ = new wxListBox(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(220, 280)), titles);
        text_ = new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(300, 200)),
                                 wxST_NO_AUTORESIZE);
        auto* columns = new wxBoxSizer(wxHORIZONTAL);
        columns->Add(list_, wxSizerFlags(0).Expand());
        columns->Add(text_, wxSizerFlags(1).Expand().Border(wxLEFT, FromDIP(16)));
        auto* rows = new wxBoxSizer(wxVERTICAL);
        rows->Add(columns, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(16)));
        rows->Add(CreateButtonSizer(wxOK | wxCANCEL),
                  wxSizerFlags(0).Expand().Border(wxALL & ~wxTOP, FromDIP(16)));
        SetSizerAndFit(rows);
        if (auto* ok = FindWindow(wxID_OK)) ok->SetLabel("Open");
        list_->Bind(wxEVT_LISTBOX, [this](wxCommandEvent&) { show(); });
        list_->Bind(wxEVT_LISTBOX_DCLICK, [this](wxCommandEvent&) { EndModal(wxID_OK); });
        list_->SetSelection(0);
        show();
        CentreOnParent();
    }

    const Example& chosen() const {
        return examples_[static_cast<std::size_t>(std::max(0, list_->GetSelection()))];
    }

private:
    void show() {
        text_->SetLabel(wxString::FromUTF8(chosen().description));
        text_->Wrap(text_->GetClientSize().GetWidth());
    }

    const std::vector<Example>& examples_;
    wxListBox* list_ = nullptr;
    wxStaticText* text_ = nullptr;
};

}  // namespace

std::vector<Example> findExamples() {
    const atlax::Assets assets({.application = "sulfur/scenes",
                                .environmentVariable = "SULFUR_SCENES",
                                .sourceFolder = SULFURCHAMBER_SOURCE_SCENES});
    std::vector<Example> examples;
    for (const auto& folder : assets.folders()) {
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
            if (entry.path().extension() != ".json") continue;
            try {
                const auto scene = sulfur::scene::read(entry.path());
                examples.push_back({entry.path(), scene.title, scene.description});
            } catch (const std::exception& problem) {
                atlax::log(atlax::LogLevel::Warning, problem.what());
            }
        }
        if (!examples.empty()) break;
    }
    std::sort(examples.begin(), examples.end(),
              [](const Example& a, const Example& b) { return a.title < b.title; });
    return examples;
}

std::optional<std::filesystem::path> chooseExample(wxWindow* parent) {
    const auto examples = findExamples();
    if (examples.empty()) return std::nullopt;
    GalleryDialog dialog(parent, examples);
    if (dialog.ShowModal() != wxID_OK) return std::nullopt;
    return dialog.chosen().file;
}

}  // namespace sulfurchamber
