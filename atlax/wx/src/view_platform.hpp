// The platform of a View: the window's side of atlax::Platform.
#pragma once

#include <wx/weakref.h>

#include <atlax/backend.hpp>
#include <atlax/wx/view.hpp>

#include "swap_interval.hpp"

namespace atlax::wx {

class View::ViewPlatform final : public BackendPlatform {
public:
    ViewPlatform(View& view, Application& application, const WindowOptions& options)
        : BackendPlatform(application, options), view_(view) {}
    ~ViewPlatform() override { end(); }

    using BackendPlatform::begin;
    using BackendPlatform::end;
    using BackendPlatform::exitCode;
    using BackendPlatform::finished;
    using BackendPlatform::frame;
    using BackendPlatform::handle;

    void setTitle(const std::string& utf8) override;
    void setFullscreen(bool fullscreen) override;
    bool fullscreen() const override;
    void setWindowSize(PixelSize size) override;
    void setMinimised(bool minimised) override;
    bool minimised() const override;
    void setVsync(bool on) override { setSwapInterval(on); }
    void setCursorVisible(bool visible) override;
    void setCursor(Cursor cursor) override;
    void setTextInput(bool on) override { textInput_ = on; }
    bool textInput() const { return textInput_; }
    std::string clipboard() override;
    void setClipboard(const std::string& utf8) override;
    bool hasFileDialogs() const override { return true; }
    std::optional<std::filesystem::path> chooseFile(const FileDialog& dialog) override;

protected:
    void remakeContext() override { view_.openContext(); }

private:
    void showCursor();

    View& view_;
    Cursor cursor_ = Cursor::Arrow;
    bool cursorVisible_ = true;
    bool textInput_ = false;
};

/// While it lives the application is not called: a dialog's event loop runs inside of one of its
/// own callbacks. What became of size and focus meanwhile is told afterwards.
class View::DialogGuard {
public:
    explicit DialogGuard(View& view);
    ~DialogGuard();
    DialogGuard(const DialogGuard&) = delete;
    DialogGuard& operator=(const DialogGuard&) = delete;

private:
    View& view_;
    wxWeakRef<wxWindow> focus_;  // where it was
};

}  // namespace atlax::wx
