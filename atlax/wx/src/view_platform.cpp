#include "view_platform.hpp"

#include <wx/clipbrd.h>
#include <wx/dataobj.h>
#include <wx/filedlg.h>
#include <wx/toplevel.h>

#include <algorithm>
#include <array>

namespace atlax::wx {
namespace {

// Null while the view is being put together or taken apart.
wxTopLevelWindow* topLevel(const wxWindow& window) {
    return dynamic_cast<wxTopLevelWindow*>(wxGetTopLevelParent(const_cast<wxWindow*>(&window)));
}

/// In the order of Cursor.
constexpr std::array<wxStockCursor, cursorCount> stockCursors{
    wxCURSOR_ARROW,  wxCURSOR_IBEAM,  wxCURSOR_HAND, wxCURSOR_CROSS,    wxCURSOR_SIZING,
    wxCURSOR_SIZEWE, wxCURSOR_SIZENS, wxCURSOR_WAIT, wxCURSOR_NO_ENTRY,
};

// "PNG pictures (*.png)|*.png|..." as wxWidgets wants it; '|' would begin another kind.
wxString wildcards(const std::vector<FileKind>& kinds) {
    wxString out;
    for (const FileKind& kind : kinds) {
        wxString patterns;
        for (const std::string& ending : kind.endings)
            patterns += (patterns.empty() ? "*." : ";*.") + wxString::FromUTF8(ending);
        if (patterns.empty()) patterns = "*";
        wxString name = wxString::FromUTF8(kind.name);
        name.Replace("|", "/");
        patterns.Replace("|", "");
        out += (out.empty() ? "" : "|") + name + " (" + patterns + ")|" + patterns;
    }
    return out.empty() ? wxString("*") : out;
}

}  // namespace

void View::ViewPlatform::setTitle(const std::string& utf8) {
    if (auto* window = topLevel(view_)) window->SetTitle(wxString::FromUTF8(utf8));
}

void View::ViewPlatform::setFullscreen(bool fullscreen) {
    if (auto* window = topLevel(view_)) window->ShowFullScreen(fullscreen);
}

bool View::ViewPlatform::fullscreen() const {
    const auto* window = topLevel(view_);
    return window != nullptr && window->IsFullScreen();
}

void View::ViewPlatform::setWindowSize(PixelSize size) {
    auto* window = topLevel(view_);
    if (window == nullptr || window->IsFullScreen()) return;
    window->SetClientSize(std::clamp(size.width, 64, 8192), std::clamp(size.height, 64, 8192));
}

void View::ViewPlatform::setMinimised(bool minimised) {
    if (auto* window = topLevel(view_)) minimised ? window->Iconize() : window->Restore();
}

bool View::ViewPlatform::minimised() const {
    const auto* window = topLevel(view_);
    return window != nullptr && window->IsIconized();
}

void View::ViewPlatform::setCursorVisible(bool visible) {
    cursorVisible_ = visible;
    showCursor();
}

void View::ViewPlatform::setCursor(Cursor cursor) {
    if (static_cast<std::size_t>(cursor) >= stockCursors.size()) return;
    cursor_ = cursor;
    showCursor();
}

void View::ViewPlatform::showCursor() {
    const wxStockCursor shape = stockCursors[static_cast<std::size_t>(cursor_)];
    view_.SetCursor(wxCursor(cursorVisible_ ? shape : wxCURSOR_BLANK));
}

std::string View::ViewPlatform::clipboard() {
    const wxClipboardLocker locked(wxTheClipboard);
    wxTextDataObject text;
    if (!locked || !wxTheClipboard->GetData(text)) return {};
    return std::string(text.GetText().utf8_string());
}

void View::ViewPlatform::setClipboard(const std::string& utf8) {
    const wxClipboardLocker locked(wxTheClipboard);
    if (!locked) return;
    // The clipboard takes over the object.
    wxTheClipboard->SetData(new wxTextDataObject(wxString::FromUTF8(utf8)));
}

std::optional<std::filesystem::path> View::ViewPlatform::chooseFile(const FileDialog& dialog) {
    const View::DialogGuard nothingElse(view_);
    const long style =
        dialog.save ? wxFD_SAVE | wxFD_OVERWRITE_PROMPT : wxFD_OPEN | wxFD_FILE_MUST_EXIST;
    // The window that has the focus gets it back.
    wxWindow* const focus = wxWindow::FindFocus();
    wxWindow* const parent = wxGetTopLevelParent(focus != nullptr ? focus : &view_);
    wxFileDialog window(parent, wxString::FromUTF8(dialog.title),
                        wxString::FromUTF8(dialog.folder.string()), wxString::FromUTF8(dialog.name),
                        wildcards(dialog.kinds), style);
    if (window.ShowModal() != wxID_OK) return {};
    return std::filesystem::path(window.GetPath().utf8_string());
}

}  // namespace atlax::wx
