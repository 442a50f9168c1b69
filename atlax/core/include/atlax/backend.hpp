#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <atlax/application.hpp>
#include <atlax/gamepad.hpp>

namespace atlax {

/// Nanoseconds of a monotonic clock. Any thread.
std::int64_t monotonicNs();

/// What all backends share, for those who write one: input sampling, gamepads, the fixed clock,
/// overload, statistics, screenshots. A backend derives from it, makes a context current, and calls
///
///     begin();                                  once, context current
///     while (!finished()) { handle(event)...; frame(); swap }
///     end();
///
/// or, driven by another program's loop (a widget), handle() and frame() from its callbacks. How
/// each backend's loop is driven stands at atlax::sdl::SdlPlatform and atlax::wx::View.
///
/// Owns the canvas, the sound and the gamepads, between begin() and end(). Main thread only. Errors
/// of the application's functions pass through begin(), handle() and frame().
class BackendPlatform : public Platform {
public:
    using Now = std::function<std::int64_t()>;

    /// Both references must outlive the platform. `now` is the clock in nanoseconds.
    BackendPlatform(Application& application, const WindowOptions& options, Now now = monotonicNs);
    ~BackendPlatform() override;

    Canvas& canvas() override;
    Audio& audio() override;
    const InputState& input() const override { return input_.current(); }
    void post(const Event& event) override { posted_.push_back(event); }
    FixedTimestep& clock() override { return clock_; }
    const FrameStatistics& statistics() const override { return statistics_; }
    PixelSize size() const override { return size_; }
    float scaleFactor() const override { return scaleFactor_; }
    bool focused() const override { return focused_; }
    bool hasFileDialogs() const override { return false; }
    std::optional<std::filesystem::path> chooseFile(const FileDialog& dialog) override;
    void requestScreenshot(const std::filesystem::path& file) override { screenshot_ = file; }
    void quit(int exitCode = 0) override;

protected:
    /// Makes the canvas and starts the application. The drawable size must have been handled
    /// (WindowResized) before.
    void begin();
    /// Stops the application and drops the canvas. Does nothing when begin() did not succeed.
    void end() noexcept;

    /// Gives an event to the input and to the application.
    void handle(const Event& event);

    /// Posted events, gamepads, due ticks, then one draw, unless the drawable area is empty or
    /// `visible` is false. The caller swaps buffers.
    void frame(bool visible = true);

    /// Ends the context, which is lost, and makes another one current; the canvas has gone before,
    /// and comes after. Throws Error when there is none to be had. This one always does.
    virtual void remakeContext();

    /// Starts the canvas's frame; a backend that does not draw into framebuffer 0 overrides it.
    virtual void beginCanvasFrame(Canvas& canvas);

    bool finished() const { return exitCode_.has_value(); }
    int exitCode() const { return exitCode_.value_or(0); }

private:
    void runTicks();
    void drawFrame();
    void restoreGraphics();
    void takeScreenshot();
    void measure(std::int64_t frameStart, std::int64_t ticksEnd, std::int64_t drawEnd);

    Application& application_;
    Now now_;
    FixedTimestep clock_;
    InputSampler input_;
    InputQueue arrived_;
    std::unique_ptr<Canvas> canvas_;
    std::unique_ptr<Audio> audio_;
    std::unique_ptr<Gamepads> gamepads_;
    std::vector<Event> posted_;
    std::optional<std::filesystem::path> screenshot_;
    std::optional<int> exitCode_;
    FrameStatistics statistics_;
    PixelSize size_;
    float scaleFactor_ = 1;
    bool focused_ = true;
    bool started_ = false;
    int lossesInARow_ = 0;
    std::int64_t lastFrame_ = 0;

    struct Window {
        std::int64_t start = 0;
        std::int64_t tickNs = 0;
        std::int64_t drawNs = 0;
        int frames = 0;
        int ticks = 0;
    } window_;
    double otherMilliseconds_ = 0;  // of a frame, on average: what is no tick
};

/// Runs an application without window and display, as WindowOptions::offscreen says: what run() of
/// every backend does with that option. Needs no backend. Same exit codes as run().
int runOffscreen(Application& application, const WindowOptions& options);

/// Calls `body`, and turns an exception into one sentence on standard error and exit code 1.
int guarded(const std::function<int()>& body) noexcept;

}  // namespace atlax
