#include <wx/dcclient.h>
#include <wx/dnd.h>
#include <wx/log.h>
#include <wx/timer.h>
#include <wx/toplevel.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <atlax/wx/view.hpp>
#include <bitset>
#include <cmath>
#include <exception>
#include <utility>

#include "swap_interval.hpp"
#include "view_platform.hpp"
#include "wx_keys.hpp"

namespace atlax::wx {
namespace {

constexpr std::int64_t nsPerMs = 1'000'000;
// What is not seen still ticks, but need not hurry.
constexpr std::int64_t hiddenFrameNs = 16 * nsPerMs;
// What is at rest, and for how long nothing has happened then.
constexpr std::int64_t restingFrameNs = 200 * nsPerMs, calmNs = 500 * nsPerMs;

wxGLAttributes displayAttributes() {
    wxGLAttributes attributes;
    attributes.PlatformDefaults().RGBA().DoubleBuffer().EndList();
    return attributes;
}

const wxGLAttributes& checkedAttributes() {
    static const wxGLAttributes attributes = displayAttributes();
    if (!wxGLCanvas::IsDisplaySupported(attributes))
        throw Error(
            "the display offers no OpenGL with double buffering; OpenGL 3.3 is needed (a graphics "
            "driver or Mesa's software renderer)");
    return attributes;
}

/// A context of OpenGL 3.3 core, current in the view: one that says when the driver is reset, where
/// the driver can. Throws Error.
std::unique_ptr<wxGLContext> makeContext(wxGLCanvas& view) {
    const wxLogNull quiet;  // what is wrong is said below
    for (const bool robust : {true, false}) {
        wxGLContextAttrs attributes;
        attributes.PlatformDefaults().CoreProfile().OGLVersion(3, 3);
        if (robust) attributes.Robust().LoseOnReset();
        attributes.EndList();
        auto context = std::make_unique<wxGLContext>(&view, nullptr, &attributes);
        if (context->IsOK() && view.SetCurrent(*context)) return context;
    }
    throw Error(
        "OpenGL 3.3 core is not available on this display; update the graphics driver or "
        "install Mesa's software renderer (libgl1-mesa-dri)");
}

MouseButton buttonOf(int wxButton) {
    switch (wxButton) {
        case wxMOUSE_BTN_MIDDLE:
            return MouseButton::Middle;
        case wxMOUSE_BTN_RIGHT:
            return MouseButton::Right;
        case wxMOUSE_BTN_AUX1:
            return MouseButton::Back;
        case wxMOUSE_BTN_AUX2:
            return MouseButton::Forward;
        default:
            return MouseButton::Left;
    }
}

bool movesFocus(int code) {
    switch (code) {
        case WXK_TAB:
        case WXK_LEFT:
        case WXK_RIGHT:
        case WXK_UP:
        case WXK_DOWN:
            return true;
        default:
            return false;
    }
}

}  // namespace

class View::DropTarget final : public wxFileDropTarget {
public:
    explicit DropTarget(View& view) : view_(view) {}
    // While something is dragged no motion is told: the pointer is where it was dropped.
    bool OnDropFiles(wxCoord x, wxCoord y, const wxArrayString& files) override {
        const double scale = view_.GetContentScaleFactor();
        view_.send(MouseMoved{{static_cast<float>(x * scale), static_cast<float>(y * scale)}});
        for (const wxString& file : files)
            view_.send(FileDropped{std::filesystem::path(file.utf8_string())});
        return true;
    }

private:
    View& view_;
};

// What only the implementation needs to know.
struct View::Handlers {
    explicit Handlers(Application& app) : application(app) {}

    Application& application;
    std::unique_ptr<wxGLContext> context;
    wxTimer timer;
    Ended ended;
    std::string error;
    std::int64_t framePeriodNs = 0;
    std::int64_t nextFrameNs = 0;
    std::int64_t stirredNs = 0;
    std::bitset<keyCount> keysDown;
    std::bitset<mouseButtonCount> buttonsDown;
    bool vsync = true;
    bool running = false;
    bool resting = false;
    bool inDialog = false;
    bool dialogClosed = false;  // and the application has not been told
    bool over = false;          // ended; never starts again
};

View::View(wxWindow* parent, Application& application, const WindowOptions& options, wxWindowID id)
    : wxGLCanvas(parent, checkedAttributes(), id, wxDefaultPosition, wxDefaultSize, wxWANTS_CHARS),
      platform_(std::make_unique<ViewPlatform>(*this, application, options)),
      handlers_(std::make_unique<Handlers>(application)) {
    handlers_->vsync = options.vsync;
    if (options.maxFramesPerSecond > 0)
        handlers_->framePeriodNs = 1'000'000'000 / options.maxFramesPerSecond;
    SetBackgroundStyle(wxBG_STYLE_PAINT);
    SetDropTarget(new DropTarget(*this));  // owned by the window
    bindEvents();
}

View::~View() {
    stop();
}

void View::bindEvents() {
    Bind(wxEVT_IDLE, &View::onIdle, this);
    Bind(wxEVT_PAINT, &View::onPaint, this);
    Bind(wxEVT_SIZE, &View::onSize, this);
    Bind(wxEVT_KEY_DOWN, &View::onKey, this);
    Bind(wxEVT_KEY_UP, &View::onKey, this);
    Bind(wxEVT_CHAR, &View::onChar, this);
    Bind(wxEVT_MOUSEWHEEL, &View::onMouseWheel, this);
    Bind(wxEVT_SET_FOCUS, &View::onFocus, this);
    Bind(wxEVT_KILL_FOCUS, &View::onFocus, this);
    for (const auto& type : {wxEVT_LEFT_DOWN, wxEVT_LEFT_UP, wxEVT_LEFT_DCLICK, wxEVT_MIDDLE_DOWN,
                             wxEVT_MIDDLE_UP, wxEVT_MIDDLE_DCLICK, wxEVT_RIGHT_DOWN, wxEVT_RIGHT_UP,
                             wxEVT_RIGHT_DCLICK, wxEVT_AUX1_DOWN, wxEVT_AUX1_UP, wxEVT_AUX1_DCLICK,
                             wxEVT_AUX2_DOWN, wxEVT_AUX2_UP, wxEVT_AUX2_DCLICK})
        Bind(type, &View::onMouseButton, this);
    Bind(wxEVT_MOTION, [this](wxMouseEvent& event) {
        send(MouseMoved{pixels(event), modifiersOf(event)});
    });
    // Another window took the mouse away: no release will come for what is held.
    Bind(wxEVT_MOUSE_CAPTURE_LOST, [this](wxMouseCaptureLostEvent&) {
        handlers_->buttonsDown.reset();
        send(FocusChanged{false});
        if (HasFocus()) send(FocusChanged{true});
    });
    handlers_->timer.Bind(wxEVT_TIMER, [](wxTimerEvent&) { wxWakeUpIdle(); });
}

View::DialogGuard::DialogGuard(View& view) : view_(view), focus_(wxWindow::FindFocus()) {
    if (view_.handlers_->inDialog) throw Error("a dialog is open already");
    view_.handlers_->inDialog = true;
}

View::DialogGuard::~DialogGuard() {
    Handlers& handlers = *view_.handlers_;
    handlers.inDialog = false;
    handlers.keysDown.reset();
    handlers.buttonsDown.reset();
    handlers.dialogClosed = true;
    // GTK gives the focus back to nobody. Another window of the program gets it as it had it.
    view_.CallAfter([view = &view_, before = focus_] {
        wxWindow* const window = before.get();
        if (window != nullptr && wxGetTopLevelParent(window) != wxGetTopLevelParent(view))
            window->SetFocus();
        else
            view->SetFocus();
    });
}

Platform& View::platform() {
    return *platform_;
}

bool View::running() const {
    return handlers_->running;
}

void View::setOnEnd(Ended ended) {
    handlers_->ended = std::move(ended);
}

void View::attempt(const std::function<void()>& body) {
    try {
        body();
    } catch (const std::exception& error) {
        handlers_->error = error.what();
        platform_->quit(1);
    } catch (...) {
        handlers_->error = "an unknown error ended the application";
        platform_->quit(1);
    }
}

void View::send(const Event& event) {
    if (!handlers_->running || handlers_->inDialog) return;
    stir();
    attempt([&] { platform_->handle(event); });
}

void View::stop() {
    handlers_->timer.Stop();
    handlers_->over = true;
    if (!handlers_->running) return;
    handlers_->running = false;
    if (handlers_->context) SetCurrent(*handlers_->context);
    platform_->end();
}

void View::finishIfEnded() {
    if (!platform_->finished() || handlers_->over) return;
    const int code = platform_->exitCode();
    stop();
    if (handlers_->ended) {
        const Ended ended = std::move(handlers_->ended);
        ended(code, handlers_->error);
        // What it closed is deleted with the next idle event, for which nothing else may ask.
        wxWakeUpIdle();
    } else if (!handlers_->error.empty()) {
        log(LogLevel::Error, handlers_->error);
    }
}

// In place of the one before, if there was one.
void View::openContext() {
    handlers_->context.reset();
    handlers_->context = makeContext(*this);
    setSwapInterval(handlers_->vsync);
}

// Makes the context and starts the application; false while the window cannot be drawn into.
bool View::start() {
    const wxSize client = GetClientSize();
    if (!IsShownOnScreen() || client.GetWidth() <= 1 || client.GetHeight() <= 1) return false;
    openContext();
    tellSize();
    platform_->handle(FocusChanged{HasFocus()});
    handlers_->running = true;
    try {
        platform_->begin();
        platform_->handle(FocusChanged{HasFocus()});  // said again to who was not there yet
    } catch (...) {
        handlers_->running = false;
        throw;
    }
    return true;
}

void View::stir() {
    handlers_->stirredNs = monotonicNs();
    if (!std::exchange(handlers_->resting, false)) return;
    handlers_->nextFrameNs = 0;
    handlers_->timer.Stop();  // it waits for the next frame of a picture at rest
}

bool View::rests() const {
    return monotonicNs() - handlers_->stirredNs > calmNs && handlers_->application.atRest();
}

// Whether another frame is due at once.
bool View::runFrame() {
    const auto* window = dynamic_cast<wxTopLevelWindow*>(wxGetTopLevelParent(this));
    const bool visible = IsShownOnScreen() && window != nullptr && !window->IsIconized();
    SetCurrent(*handlers_->context);
    if (std::exchange(handlers_->dialogClosed, false)) {
        tellSize();
        platform_->handle(FocusChanged{false});  // lets go of what was held
        platform_->handle(FocusChanged{HasFocus()});
    }
    platform_->frame(visible);
    if (platform_->finished()) return false;
    if (visible) SwapBuffers();
    handlers_->resting = visible && rests();
    const std::int64_t least = visible ? 0 : hiddenFrameNs;
    const std::int64_t period =
        std::max(handlers_->resting ? restingFrameNs : least, handlers_->framePeriodNs);
    const std::int64_t now = monotonicNs();
    handlers_->nextFrameNs = std::max(now, handlers_->nextFrameNs + period);
    return handlers_->nextFrameNs <= now;
}

void View::onIdle(wxIdleEvent& event) {
    event.Skip();
    if (handlers_->over || handlers_->inDialog) return;
    bool again = false;
    attempt([&] {
        if (!handlers_->running && !start()) {
            handlers_->nextFrameNs = monotonicNs() + hiddenFrameNs;
            return;
        }
        if (monotonicNs() >= handlers_->nextFrameNs) again = runFrame();
    });
    finishIfEnded();
    if (handlers_->over) return;
    if (again) {
        event.RequestMore();
        return;
    }
    const std::int64_t wait = handlers_->nextFrameNs - monotonicNs();
    if (wait < nsPerMs)
        event.RequestMore();
    else if (!handlers_->timer.IsRunning())
        handlers_->timer.StartOnce(static_cast<int>(wait / nsPerMs));
}

void View::onPaint(wxPaintEvent&) {
    const wxPaintDC validates(this);
    stir();
    handlers_->nextFrameNs = 0;  // what was uncovered is drawn with the next idle event
}

void View::onSize(wxSizeEvent& event) {
    event.Skip();
    if (handlers_->running && !handlers_->inDialog) attempt([&] { tellSize(); });
    stir();
    handlers_->nextFrameNs = 0;
}

void View::tellSize() {
    const double scale = GetContentScaleFactor();
    const wxSize client = GetClientSize();
    const auto pixelsOf = [&](int logical) {
        return static_cast<int>(std::lround(std::max(0, logical) * scale));
    };
    platform_->handle(WindowResized{{pixelsOf(client.GetWidth()), pixelsOf(client.GetHeight())},
                                    static_cast<float>(scale)});
}

void View::onKey(wxKeyEvent& event) {
    event.Skip();  // wxEVT_CHAR comes only after a skipped key
    const Key key = keyOf(event);
    const bool down = event.GetEventType() == wxEVT_KEY_DOWN;
    auto held = handlers_->keysDown[static_cast<std::size_t>(key)];
    const bool repeat = down && held;
    held = down;  // before it is told: a dialog that it opens lets go of all keys
    // A key that was released elsewhere went up for the application when the focus was lost.
    if (key != Key::Unknown) send(KeyEvent{key, down, repeat, modifiersOf(event)});
}

void View::onChar(wxKeyEvent& event) {
    // GTK would move the focus away with Tab and the arrow keys; everything else that is no text
    // goes on to the accelerators of the frame around.
    const bool command = event.RawControlDown() != event.AltDown();  // AltGr is both
    if (!command && movesFocus(event.GetKeyCode())) return;
    const wxChar character = event.GetUnicodeKey();
    if (command || !platform_->textInput() || character < 32 || character == 127) {
        event.Skip();
        return;
    }
    send(TextEvent{wxString(character).utf8_string()});
}

Vec2 View::pixels(const wxMouseEvent& event) const {
    const double scale = GetContentScaleFactor();
    return {static_cast<float>(event.GetX() * scale), static_cast<float>(event.GetY() * scale)};
}

void View::onMouseButton(wxMouseEvent& event) {
    const MouseButton button = buttonOf(event.GetButton());
    const bool up = event.ButtonUp();
    handlers_->buttonsDown[static_cast<std::size_t>(button)] = !up;
    if (!up) SetFocus();
    // Held buttons keep the mouse, so that a drag may leave the window.
    if (handlers_->buttonsDown.any() && !HasCapture()) CaptureMouse();
    if (handlers_->buttonsDown.none() && HasCapture()) ReleaseMouse();
    send(MouseButtonEvent{button, !up, pixels(event), event.ButtonDClick() ? 2 : 1,
                          modifiersOf(event)});
}

void View::onMouseWheel(wxMouseEvent& event) {
    const float notches = static_cast<float>(event.GetWheelRotation()) /
                          static_cast<float>(std::max(1, event.GetWheelDelta()));
    const bool sideways = event.GetWheelAxis() == wxMOUSE_WHEEL_HORIZONTAL;
    send(WheelEvent{sideways ? Vec2{notches, 0} : Vec2{0, notches}, pixels(event),
                    modifiersOf(event)});
}

// Whoever lets go of them elsewhere, the application is told here, as SDL does it too.
void View::releaseKeys() {
    for (int i = 1; i < keyCount; ++i)
        if (handlers_->keysDown[static_cast<std::size_t>(i)])
            send(KeyEvent{static_cast<Key>(i), false, false, Modifiers::None});
    handlers_->keysDown.reset();
}

void View::onFocus(wxFocusEvent& event) {
    event.Skip();
    const bool focused = event.GetEventType() == wxEVT_SET_FOCUS;
    if (!focused) releaseKeys();
    send(FocusChanged{focused});
}

}  // namespace atlax::wx
