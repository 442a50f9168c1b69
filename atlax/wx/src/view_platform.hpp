// The platform of a View: the window's side of atlax::Platform.
#pragma once

#include <atlax/backend.hpp>
#include <atlax/wx/view.hpp>

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
    void setCursorVisible(bool visible) override;
    void setTextInput(bool on) override { textInput_ = on; }
    bool textInput() const { return textInput_; }
    std::string clipboard() override;
    void setClipboard(const std::string& utf8) override;

private:
    View& view_;
    bool textInput_ = false;
};

}  // namespace atlax::wx
