#include "view_platform.hpp"

#include <wx/clipbrd.h>
#include <wx/dataobj.h>
#include <wx/toplevel.h>

#include <algorithm>

namespace atlax::wx {
namespace {

// Null while the view is being put together or taken apart.
wxTopLevelWindow* topLevel(const wxWindow& window) {
    return dynamic_cast<wxTopLevelWindow*>(wxGetTopLevelParent(const_cast<wxWindow*>(&window)));
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

void View::ViewPlatform::setCursorVisible(bool visible) {
    view_.SetCursor(visible ? wxNullCursor : wxCursor(wxCURSOR_BLANK));
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

}  // namespace atlax::wx
