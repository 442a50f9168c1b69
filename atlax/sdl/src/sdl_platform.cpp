#include "sdl_platform.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <chrono>
#include <thread>
#include <utility>

#include "sdl_events.hpp"

namespace atlax::sdl {

namespace {

/// A hidden window needs no frames, but its program goes on ticking.
constexpr int hiddenFramesPerSecond = 30;

/// In the order of Cursor.
constexpr std::array<SDL_SystemCursor, cursorCount> systemCursors{
    SDL_SYSTEM_CURSOR_ARROW,     SDL_SYSTEM_CURSOR_IBEAM,   SDL_SYSTEM_CURSOR_HAND,
    SDL_SYSTEM_CURSOR_CROSSHAIR, SDL_SYSTEM_CURSOR_SIZEALL, SDL_SYSTEM_CURSOR_SIZEWE,
    SDL_SYSTEM_CURSOR_SIZENS,    SDL_SYSTEM_CURSOR_WAIT,    SDL_SYSTEM_CURSOR_NO,
};

[[noreturn]] void fail(const std::string& what) {
    throw Error(what + ": " + SDL_GetError());
}

int windowSide(int wanted) {
    return std::clamp(wanted, 64, Image::maxSide);
}

}  // namespace

Video::Video() {
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0)
        fail("no window can be opened (is there a display?)");
}

Video::~Video() {
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

SdlPlatform::SdlPlatform(Application& application, const WindowOptions& options)
    : BackendPlatform(application, options),
      maxFramesPerSecond_(options.maxFramesPerSecond),
      vsync_(options.vsync) {
    try {
        openWindow(options);
        openContext();
    } catch (...) {
        close();
        throw;
    }
    // SDL begins with text input on, which would open input methods during play.
    SDL_StopTextInput();
}

SdlPlatform::~SdlPlatform() {
    end();
    close();
}

void SdlPlatform::openWindow(const WindowOptions& options) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    // So that the driver says when it was reset, where it can.
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, SDL_GL_CONTEXT_RESET_LOSE_CONTEXT);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_ROBUST_ACCESS_FLAG);
    Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_ALLOW_HIGHDPI;
    if (options.resizable) flags |= SDL_WINDOW_RESIZABLE;
    if (options.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    window_ =
        SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                         windowSide(options.size.width), windowSide(options.size.height), flags);
    if (window_ == nullptr) fail("no window can be opened");
}

void SdlPlatform::openContext() {
    context_ = SDL_GL_CreateContext(window_);
    if (context_ == nullptr) {
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION,
                            SDL_GL_CONTEXT_RESET_NO_NOTIFICATION);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, 0);
        context_ = SDL_GL_CreateContext(window_);
    }
    if (context_ == nullptr) fail("OpenGL 3.3 is needed, but this display does not offer it");
    setVsync(vsync_);
}

void SdlPlatform::setVsync(bool on) {
    vsync_ = on;
    if (!on)
        SDL_GL_SetSwapInterval(0);
    else if (SDL_GL_SetSwapInterval(-1) != 0)  // late frames are shown at once where possible
        SDL_GL_SetSwapInterval(1);
}

void SdlPlatform::remakeContext() {
    SDL_GL_DeleteContext(std::exchange(context_, nullptr));
    openContext();
}

void SdlPlatform::close() {
    for (SDL_Cursor*& cursor : cursors_) {
        if (cursor != nullptr) SDL_FreeCursor(cursor);
        cursor = nullptr;
    }
    if (context_ != nullptr) SDL_GL_DeleteContext(context_);
    if (window_ != nullptr) SDL_DestroyWindow(window_);
    context_ = nullptr;
    window_ = nullptr;
}

int SdlPlatform::loop() {
    updateSize();
    begin();
    while (!finished()) {
        const std::int64_t start = monotonicNs();
        pumpEvents();
        frame(visible());
        if (visible()) SDL_GL_SwapWindow(window_);
        pace(start);
    }
    end();
    return exitCode();
}

void SdlPlatform::pumpEvents() {
    SDL_PumpEvents();
    SDL_Event event;
    // Gamepads take their own events from the queue, before and after this range.
    const auto next = [&](Uint32 first, Uint32 last) {
        return SDL_PeepEvents(&event, 1, SDL_GETEVENT, first, last) > 0;
    };
    while (next(SDL_FIRSTEVENT, SDL_JOYAXISMOTION - 1) ||
           next(SDL_CONTROLLERSENSORUPDATE + 1, SDL_LASTEVENT)) {
        if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED)
            updateSize();
        else if (const auto translated = translate(event, scaleFactor()))
            handle(*translated);
    }
}

void SdlPlatform::updateSize() {
    PixelSize drawable;
    PixelSize logical;
    SDL_GL_GetDrawableSize(window_, &drawable.width, &drawable.height);
    SDL_GetWindowSize(window_, &logical.width, &logical.height);
    const float scale = logical.width > 0
                            ? static_cast<float>(drawable.width) / static_cast<float>(logical.width)
                            : 1.0f;
    if (drawable == size() && scale == scaleFactor()) return;
    handle(WindowResized{drawable, scale});
}

bool SdlPlatform::visible() const {
    return (SDL_GetWindowFlags(window_) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) == 0;
}

void SdlPlatform::pace(std::int64_t frameStart) const {
    const int most = visible() ? maxFramesPerSecond_ : hiddenFramesPerSecond;
    if (most <= 0) return;
    const std::int64_t left = 1'000'000'000 / most - (monotonicNs() - frameStart);
    if (left > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(left));
}

void SdlPlatform::setTitle(const std::string& utf8) {
    SDL_SetWindowTitle(window_, utf8.c_str());
}

void SdlPlatform::setFullscreen(bool fullscreen) {
    if (SDL_SetWindowFullscreen(window_, fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0) != 0)
        log(LogLevel::Warning, std::string("fullscreen cannot be changed: ") + SDL_GetError());
    updateSize();
}

bool SdlPlatform::fullscreen() const {
    return (SDL_GetWindowFlags(window_) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
}

void SdlPlatform::setWindowSize(PixelSize size) {
    SDL_SetWindowSize(window_, windowSide(size.width), windowSide(size.height));
}

void SdlPlatform::setMinimised(bool minimised) {
    minimised ? SDL_MinimizeWindow(window_) : SDL_RestoreWindow(window_);
}

bool SdlPlatform::minimised() const {
    return (SDL_GetWindowFlags(window_) & SDL_WINDOW_MINIMIZED) != 0;
}

void SdlPlatform::setCursorVisible(bool visible) {
    SDL_ShowCursor(visible ? SDL_ENABLE : SDL_DISABLE);
}

void SdlPlatform::setCursor(Cursor cursor) {
    const auto index = static_cast<std::size_t>(cursor);
    if (index >= cursors_.size()) return;
    SDL_Cursor*& made = cursors_[index];
    if (made == nullptr) made = SDL_CreateSystemCursor(systemCursors[index]);
    SDL_SetCursor(made == nullptr ? SDL_GetDefaultCursor() : made);
}

void SdlPlatform::setTextInput(bool on) {
    on ? SDL_StartTextInput() : SDL_StopTextInput();
}

std::string SdlPlatform::clipboard() {
    char* text = SDL_GetClipboardText();
    if (text == nullptr) return {};
    std::string out(text);
    SDL_free(text);
    return out;
}

void SdlPlatform::setClipboard(const std::string& utf8) {
    SDL_SetClipboardText(utf8.c_str());
}

}  // namespace atlax::sdl
