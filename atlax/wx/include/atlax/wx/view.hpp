// A window of wxWidgets that runs an atlax::Application inside of somebody's frame. The only
// public header of atlax in which types of wxWidgets appear.
#pragma once

#include <wx/glcanvas.h>

#include <atlax/application.hpp>
#include <functional>
#include <memory>
#include <string>

namespace atlax::wx {

/// To be called once, before wxWidgets starts (before wxEntry or wxEntryStart). Where wxWidgets was
/// built with GLX, its OpenGL windows exist only under X11; this makes GTK use X11 (XWayland in a
/// Wayland session) unless the user chose a GDK_BACKEND.
void prepareDisplay();

/// An OpenGL window that runs an application: its events, its ticks and its drawing.
///
/// The loop. Frames are driven by wxWidgets' idle events, which come when no other event waits and
/// nothing else wants to be painted: menus, sliders and panels stay lively however heavy the
/// frames are. A one-shot timer ends the wait until the next frame is due
/// (WindowOptions::maxFramesPerSecond), so that the program sleeps in between. Where the display
/// has vsync, swapping buffers waits for it.
/// The length of ticks is kept by atlax's fixed clock, independent of all that. Where the
/// application is at rest (Application::atRest) frames come seldom, and the processor sleeps.
///
/// The application starts with the first frame after the window has become visible, and stops when
/// it calls Platform::quit, when one of its functions throws, on stop(), or with the destructor.
/// CloseRequested is not sent: closing is a matter of the frame around. Platform::setTitle,
/// setFullscreen and setWindowSize mean the top-level window.
///
/// Main thread only. Like every wxWindow it is made with new and owned by its parent.
class View : public wxGLCanvas {
public:
    /// `application` must outlive the view. Throws atlax::Error when the display has no OpenGL
    /// that fits; whether it is 3.3 core is known only at the start (see setOnEnd).
    View(wxWindow* parent, Application& application, const WindowOptions& options,
         wxWindowID id = wxID_ANY);
    ~View() override;

    Platform& platform();
    /// Between Application::start and Application::stop.
    bool running() const;

    /// Gives an event to the application as if it came from the user, at once.
    void send(const Event& event);
    /// Stops the application now; the view stays, empty.
    void stop();
    /// Something has happened outside of the view that may be seen in it: an application that is at
    /// rest draws with the next idle event, and for a while as often as otherwise.
    void stir();

    /// Called once when the application has ended by itself: with the code of Platform::quit and
    /// an empty text, or with 1 and one sentence that says what went wrong. Not called after
    /// stop() or while the view is destroyed. Without it errors go to the log.
    using Ended = std::function<void(int exitCode, const std::string& error)>;
    void setOnEnd(Ended ended);

private:
    class ViewPlatform;
    class DropTarget;
    class DialogGuard;
    struct Handlers;

    void bindEvents();
    void onIdle(wxIdleEvent& event);
    void onPaint(wxPaintEvent& event);
    void onSize(wxSizeEvent& event);
    void onKey(wxKeyEvent& event);
    void onChar(wxKeyEvent& event);
    void onMouseButton(wxMouseEvent& event);
    void onMouseWheel(wxMouseEvent& event);
    void onFocus(wxFocusEvent& event);
    void releaseKeys();
    void openContext();
    bool start();
    bool runFrame();
    bool rests() const;
    void tellSize();
    Vec2 pixels(const wxMouseEvent& event) const;
    void attempt(const std::function<void()>& body);
    void finishIfEnded();

    std::unique_ptr<ViewPlatform> platform_;
    std::unique_ptr<Handlers> handlers_;
};

}  // namespace atlax::wx
