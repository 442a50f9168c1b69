#pragma once

#include <string>

#include <atlax/canvas.hpp>
#include <atlax/event.hpp>
#include <atlax/platform.hpp>

namespace atlax {

struct WindowOptions {
    std::string title = "atlax";
    PixelSize size{1280, 720};  ///< logical units; clamped to 64..8192
    bool resizable = true;
    bool fullscreen = false;
    bool vsync = true;
    int tickRateHz = 500;          ///< FixedTimestep::minRateHz..maxRateHz
    int maxFramesPerSecond = 144;  ///< for displays without vsync; 0 for no limit
    /// No window, no display, no waiting: frames are drawn into memory and each one advances the
    /// clock by exactly 1/60 s, so that every run is the same. For scripts, tests and pictures.
    bool offscreen = false;
};

/// A program that atlax runs. All calls come in the main thread, one at a time, with the OpenGL
/// context current. An exception that leaves one of them ends the program with its text.
class Application {
public:
    virtual ~Application() = default;

    /// Once, before everything else. Keep the reference; load what needs a canvas here.
    virtual void start(Platform& platform) = 0;
    /// Every event at once when it arrives; for menus and editors. The simulation should read
    /// Platform::input in tick() instead, so that it can be recorded.
    virtual void event(const Event&) {}
    /// One tick of fixed length, 1 / clock().rateHz() seconds.
    virtual void tick() = 0;
    /// One frame, in screen space at first. Nothing is cleared: begin with clear() or a sky that
    /// covers everything. `alpha` (0 <= alpha < 1) says how far the time is
    /// between the last tick and the next one.
    virtual void draw(Canvas& canvas, double alpha) = 0;
    /// Whether the picture stays as it is, or nearly, until the user does something. A window of
    /// wxWidgets then draws, and ticks, five times a second only, half a second after the last
    /// event, and at once with the next one; others draw as always.
    virtual bool atRest() const { return false; }
    /// Whether the window may close now; called for every CloseRequested.
    virtual bool mayClose() { return true; }
    /// The graphics context was lost (its driver was reset) and a new one made, and
    /// Platform::canvas is another canvas: textures, targets, shaders and models of the old one are
    /// refused. Makes its own again and returns true; with false, as here, the program ends and
    /// says why.
    virtual bool restoreGraphics() { return false; }
    /// Once, after everything else, while canvas and sound are still there; also after an error
    /// in another call, but not when start itself failed.
    virtual void stop() {}
};

/// Runs the application until it quits. Every backend defines this function; the link line chooses
/// (atlax::sdl or atlax::wx). Returns the exit code for main: that of Platform::quit, 0 when the
/// window was closed, 1 after an error, which was told on standard error in one sentence.
int run(Application& application, const WindowOptions& options);

}  // namespace atlax
