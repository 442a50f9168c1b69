#include "gallery.hpp"

#include <wx/bitmap.h>
#include <wx/button.h>
#include <wx/image.h>
#include <wx/sizer.h>

#include <algorithm>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <sulfur/scene.hpp>
#include <utility>

#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

constexpr int pictureWidth = 208;
constexpr int pictureHeight = 130;

wxBitmap bitmapOf(const atlax::Image& picture) {
    wxImage image(picture.width(), picture.height());
    const auto bytes = picture.bytes();
    unsigned char* out = image.GetData();
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) out = std::copy_n(&bytes[i], 3, out);
    return wxBitmap(image);
}

wxBitmap empty() {
    wxImage image(pictureWidth, pictureHeight);
    image.SetRGB(wxRect(0, 0, pictureWidth, pictureHeight), 0x13, 0x1D, 0x42);
    return wxBitmap(image);
}

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
              [](const Example& a, const Example& b) { return tr(a.title) < tr(b.title); });
    return examples;
}

GalleryDialog::GalleryDialog(wxWindow* parent, SceneView& view,
                             std::function<void(const std::filesystem::path&)> open)
    : wxDialog(parent, wxID_ANY, wxTr("Example scenes"), wxDefaultPosition, wxDefaultSize,
               wxDEFAULT_DIALOG_STYLE | wxRESIZE_BORDER),
      examples_(findExamples()),
      view_(view),
      open_(std::move(open)),
      images_(pictureWidth, pictureHeight, false, static_cast<int>(examples_.size())) {
    list_ = new wxListCtrl(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(720, 430)),
                           wxLC_ICON | wxLC_SINGLE_SEL | wxLC_AUTOARRANGE);
    list_->SetImageList(&images_, wxIMAGE_LIST_NORMAL);
    for (std::size_t i = 0; i < examples_.size(); ++i) {
        images_.Add(empty());
        list_->InsertItem(static_cast<long>(i), wxTr(examples_[i].title), static_cast<int>(i));
        askPicture(i);
    }
    text_ = new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, FromDIP(wxSize(-1, 54)),
                             wxST_NO_AUTORESIZE);
    auto* rows = new wxBoxSizer(wxVERTICAL);
    rows->Add(list_, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(12)));
    rows->Add(text_, wxSizerFlags(0).Expand().Border(wxLEFT | wxRIGHT, FromDIP(16)));
    rows->Add(CreateButtonSizer(wxOK | wxCANCEL),
              wxSizerFlags(0).Expand().Border(wxALL, FromDIP(12)));
    SetSizerAndFit(rows);
    if (auto* ok = FindWindow(wxID_OK)) ok->SetLabel(wxTr("Open"));
    if (auto* cancel = FindWindow(wxID_CANCEL)) cancel->SetLabel(wxTr("Cancel"));
    list_->Bind(wxEVT_LIST_ITEM_SELECTED, [this](wxListEvent&) { tell(); });
    list_->Bind(wxEVT_LIST_ITEM_ACTIVATED, [this](wxListEvent&) { openChosen(); });
    Bind(
        wxEVT_BUTTON, [this](wxCommandEvent&) { openChosen(); }, wxID_OK);
    Bind(
        wxEVT_BUTTON, [this](wxCommandEvent&) { Close(); }, wxID_CANCEL);
    Bind(wxEVT_CLOSE_WINDOW, [this](wxCloseEvent&) { Destroy(); });
    if (!examples_.empty()) list_->SetItemState(0, wxLIST_STATE_SELECTED, wxLIST_STATE_SELECTED);
    tell();
    CentreOnParent();
}

GalleryDialog::~GalleryDialog() {
    view_.forgetThumbnails();
}

void GalleryDialog::askPicture(std::size_t example) {
    view_.askThumbnail(examples_[example].file, {pictureWidth, pictureHeight},
                       [this, example](const atlax::Image& picture) {
                           images_.Replace(static_cast<int>(example), bitmapOf(picture));
                           list_->RefreshItem(static_cast<long>(example));
                           ++pictures_;
                       });
}

void GalleryDialog::tell() {
    const long at = list_->GetNextItem(-1, wxLIST_NEXT_ALL, wxLIST_STATE_SELECTED);
    text_->SetLabel(at < 0 ? wxString()
                           : wxTr(examples_[static_cast<std::size_t>(at)].description));
    text_->Wrap(std::max(FromDIP(200), text_->GetClientSize().GetWidth()));
}

void GalleryDialog::openChosen() {
    const long at = list_->GetNextItem(-1, wxLIST_NEXT_ALL, wxLIST_STATE_SELECTED);
    if (at < 0) return;
    const std::filesystem::path file = examples_[static_cast<std::size_t>(at)].file;
    const auto open = open_;
    Close();
    open(file);
}

}  // namespace sulfurchamber
