#pragma once

#include <SDL.h>

#include <array>
#include <atlax/backend.hpp>
#include <string>

namespace atlax::sdl {

/// SDL's video, started and stopped; a member of its own so that it outlives the window.
class Video {
public:
    Video();
    ~Video();
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;
};

/// One window with an OpenGL 3.3 core context.
///
/// The loop is this class's own (loop()): all events that wait, the ticks that are due, one frame,
/// swapping the buffers, which waits for the display where it has vsync, then sleeping until the
/// next frame is due (WindowOptions::maxFramesPerSecond). A minimised window goes on at 30 frames a
/// second without drawing. Ticks follow the fixed clock, whatever a frame took.
class SdlPlatform : public BackendPlatform {
public:
    /// Opens the window. Throws Error with one sentence when that is not possible.
    SdlPlatform(Application& application, const WindowOptions& options);
    ~SdlPlatform() override;
    SdlPlatform(const SdlPlatform&) = delete;
    SdlPlatform& operator=(const SdlPlatform&) = delete;

    /// Events, ticks, drawing until the application quits. Returns the exit code.
    int loop();

    void setTitle(const std::string& utf8) override;
    void setFullscreen(bool fullscreen) override;
    bool fullscreen() const override;
    void setWindowSize(PixelSize size) override;
    void setMinimised(bool minimised) override;
    bool minimised() const override;
    void setVsync(bool on) override;
    void setCursorVisible(bool visible) override;
    void setCursor(Cursor cursor) override;
    void setTextInput(bool on) override;
    std::string clipboard() override;
    void setClipboard(const std::string& utf8) override;

protected:
    void remakeContext() override;

private:
    void openWindow(const WindowOptions& options);
    void openContext();
    void close();
    void pumpEvents();
    void updateSize();
    bool visible() const;
    /// Sleeps when frames come faster than wanted.
    void pace(std::int64_t frameStart) const;

    Video video_;
    SDL_Window* window_ = nullptr;
    SDL_GLContext context_ = nullptr;
    /// Made when first asked for; null where SDL has none.
    std::array<SDL_Cursor*, cursorCount> cursors_{};
    int maxFramesPerSecond_;
    bool vsync_;
};

}  // namespace atlax::sdl
