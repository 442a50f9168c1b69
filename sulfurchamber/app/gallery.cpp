#include "gallery.hpp"

#include <wx/button.h>
#include <wx/sizer.h>

#include <algorithm>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <sulfur/scene.hpp>

#include "wx_words.hpp"

namespace sulfurchamber {
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
    std::sort(examples.begin(), examples.end(), [](const Example& a, const Example& b) {
        return standsBefore(tr(a.title), tr(b.title));
    });
    return examples;
}

GalleryDialog::GalleryDialog(wxWindow* parent, const wxString& title,
                             std::vector<PictureGrid::Item> items, Thumbnails& thumbnails,
                             std::function<void(const std::filesystem::path&)> open)
    : wxDialog(parent, wxID_ANY, title, wxDefaultPosition, wxDefaultSize,
               wxDEFAULT_DIALOG_STYLE | wxRESIZE_BORDER),
      thumbnails_(thumbnails),
      open_(std::move(open)) {
    // Those that are not seen yet, too: one scrolls through pictures, not through gaps.
    for (const PictureGrid::Item& item : items) thumbnails_.of(item.file);
    grid_ = new PictureGrid(this, thumbnails_);
    grid_->setTiles(160, 2);  // titles are longer than the names of templates
    grid_->SetMinSize(FromDIP(wxSize(600, 380)));
    grid_->show(std::move(items));
    text_ = new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(-1, 54)),
                             wxST_NO_AUTORESIZE);
    auto* rows = new wxBoxSizer(wxVERTICAL);
    rows->Add(grid_, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(12)));
    rows->Add(text_, wxSizerFlags(0).Expand().Border(wxLEFT | wxRIGHT, FromDIP(16)));
    rows->Add(CreateButtonSizer(wxOK | wxCANCEL),
              wxSizerFlags(0).Expand().Border(wxALL, FromDIP(12)));
    SetSizerAndFit(rows);
    // Most of the program's window, four pictures wide where that has room.
    const wxSize room = parent->GetClientSize();
    SetSize(std::min(FromDIP(760), room.x), std::min(FromDIP(580), room.y));
    if (auto* ok = FindWindow(wxID_OK)) ok->SetLabel(wxTr("Open"));
    if (auto* cancel = FindWindow(wxID_CANCEL)) cancel->SetLabel(wxTr("Cancel"));
    bind();
    grid_->choose(0);
    tell();
    grid_->SetFocus();
    CentreOnParent();
}

void GalleryDialog::bind() {
    grid_->onChosen = [this](std::size_t) { tell(); };
    grid_->onActivated = [this](std::size_t) { openChosen(); };
    Bind(
        wxEVT_BUTTON, [this](wxCommandEvent&) { openChosen(); }, wxID_OK);
    Bind(
        wxEVT_BUTTON, [this](wxCommandEvent&) { Close(); }, wxID_CANCEL);
    Bind(wxEVT_CLOSE_WINDOW, [this](wxCloseEvent&) { Destroy(); });
    // The frames of the window behind draw the pictures, and are drawn when nothing else is done.
    Bind(wxEVT_IDLE, [this](wxIdleEvent& event) {
        grid_->refreshPictures();
        event.Skip();
    });
}

std::size_t GalleryDialog::pictures() const {
    const auto& items = grid_->items();
    return static_cast<std::size_t>(std::count_if(
        items.begin(), items.end(),
        [this](const PictureGrid::Item& item) { return thumbnails_.of(item.file) != nullptr; }));
}

void GalleryDialog::tell() {
    const auto chosen = grid_->chosen();
    text_->SetLabel(chosen ? wxString::FromUTF8(grid_->items()[*chosen].help) : wxString());
    text_->Wrap(std::max(FromDIP(200), text_->GetClientSize().GetWidth()));
}

void GalleryDialog::openChosen() {
    const auto chosen = grid_->chosen();
    if (!chosen) return;
    const std::filesystem::path file = grid_->items()[*chosen].file;
    const auto open = open_;
    Close();
    open(file);
}

}  // namespace sulfurchamber
