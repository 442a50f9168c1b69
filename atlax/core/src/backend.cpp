#include <algorithm>
#include <atlax/backend.hpp>
#include <atlax/error.hpp>
#include <atlax/image.hpp>
#include <atlax/log.hpp>
#include <atlax/offscreen.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <optional>
#include <utility>

namespace atlax {

namespace {

/// An overloaded program draws about 30 frames a second all the same: ticks have what all else
/// leaves of such a frame (drawing, the display, the toolkit), and a little in any case. What
/// remains is given up, so that time slows down instead.
constexpr double wantedFrameMs = 31;
constexpr double leastTicksMs = 8;
constexpr double mostBesidesDrawingMs = 10;
constexpr std::int64_t statisticsWindowNs = 500'000'000;
/// What seems to last longer is no frame: the clock has leapt, or the machine has slept.
constexpr std::int64_t longestWindowNs = 10'000'000'000;
/// So many contexts that are lost before they have drawn a frame are enough.
constexpr int mostLossesInARow = 5;

}  // namespace

std::int64_t monotonicNs() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

BackendPlatform::BackendPlatform(Application& application, const WindowOptions& options, Now now)
    : application_(application), now_(std::move(now)), clock_(options.tickRateHz) {}

BackendPlatform::~BackendPlatform() = default;

Canvas& BackendPlatform::canvas() {
    if (canvas_ == nullptr) throw Error("the canvas exists only between start and stop");
    return *canvas_;
}

Audio& BackendPlatform::audio() {
    if (audio_ == nullptr) audio_ = std::make_unique<Audio>();
    return *audio_;
}

void BackendPlatform::quit(int exitCode) {
    if (!exitCode_) exitCode_ = exitCode;
}

std::optional<std::filesystem::path> BackendPlatform::chooseFile(const FileDialog& dialog) {
    log(LogLevel::Warning, "this backend has no dialog for \"" + dialog.title + "\"");
    return {};
}

void BackendPlatform::begin() {
    canvas_ = std::make_unique<Canvas>();
    gamepads_ = std::make_unique<Gamepads>();
    application_.start(*this);
    started_ = true;
    clock_.advance(now_());
    window_.start = now_();
}

void BackendPlatform::end() noexcept {
    if (started_) {
        started_ = false;
        try {
            application_.stop();
        } catch (const std::exception& error) {
            log(LogLevel::Error, error.what());
        }
    }
    gamepads_.reset();
    audio_.reset();
    canvas_.reset();
}

void BackendPlatform::handle(const Event& event) {
    if (const auto* resized = std::get_if<WindowResized>(&event)) {
        size_ = resized->size;
        scaleFactor_ = resized->scaleFactor;
    }
    if (const auto* focus = std::get_if<FocusChanged>(&event)) focused_ = focus->focused;
    arrived_.add(event);
    if (!started_) return;
    application_.event(event);
    if (std::holds_alternative<CloseRequested>(event) && application_.mayClose()) quit();
}

void BackendPlatform::frame(bool visible) {
    const std::int64_t start = now_();
    // A handler may post again; such events wait for the next frame.
    for (const Event& event : std::exchange(posted_, {})) handle(event);
    gamepads_->poll([this](const Event& event) { handle(event); });
    clock_.advance(start);
    runTicks();
    if (audio_ != nullptr) audio_->update(static_cast<double>(start - lastFrame_) * 1e-9);
    lastFrame_ = start;
    const std::int64_t ticksEnd = now_();
    if (!finished() && visible && !size_.empty()) drawFrame();
    measure(start, ticksEnd, now_());
}

void BackendPlatform::runTicks() {
    const double budgetMs = std::max(leastTicksMs, wantedFrameMs - otherMilliseconds_);
    const std::int64_t deadline = now_() + static_cast<std::int64_t>(budgetMs * 1e6);
    const std::int64_t due = clock_.due();
    statistics_.ticksLastFrame = 0;
    while (!finished() && clock_.takeTick()) {
        arrived_.feed(input_, statistics_.ticksLastFrame, due);
        input_.sample();
        application_.tick();
        ++statistics_.ticksLastFrame;
        if (now_() > deadline) clock_.giveUp();
    }
    // A click on "continue" must not also be seen by the first tick after the pause.
    if (clock_.paused() && statistics_.ticksLastFrame == 0) {
        arrived_.feed(input_, 0, 1);
        input_.sample();
    }
    arrived_.endFrame();
}

void BackendPlatform::remakeContext() {
    throw Error("the graphics context was lost, and this backend cannot make another");
}

// What the application still holds belongs to the canvas that goes first; nothing of it is used.
void BackendPlatform::restoreGraphics() {
    log(LogLevel::Warning, "the graphics driver was reset: all pictures are made again");
    if (++lossesInARow_ > mostLossesInARow)
        throw Error("the graphics driver is reset again and again; drawing is not possible");
    canvas_.reset();
    remakeContext();
    canvas_ = std::make_unique<Canvas>();
    if (!application_.restoreGraphics())
        throw Error(
            "the graphics driver was reset, and this program cannot make its pictures again; "
            "please start it once more");
}

void BackendPlatform::beginCanvasFrame(Canvas& canvas) {
    canvas.beginFrame(size_, scaleFactor_);
}

void BackendPlatform::drawFrame() {
    if (canvas_->contextLost()) {
        restoreGraphics();
    } else {
        lossesInARow_ = 0;
    }
    beginCanvasFrame(*canvas_);
    application_.draw(*canvas_, clock_.alpha());
    if (screenshot_) takeScreenshot();
    canvas_->endFrame();
    ++statistics_.frames;
}

void BackendPlatform::takeScreenshot() {
    const auto file = *std::exchange(screenshot_, std::nullopt);
    try {
        savePng(canvas_->readFrame(), file);
        log(LogLevel::Info, "wrote " + file.string());
    } catch (const std::exception& error) {
        log(LogLevel::Error, error.what());
    }
}

void BackendPlatform::measure(std::int64_t frameStart, std::int64_t ticksEnd,
                              std::int64_t drawEnd) {
    window_.tickNs += ticksEnd - frameStart;
    window_.drawNs += drawEnd - ticksEnd;
    window_.frames += 1;
    window_.ticks += statistics_.ticksLastFrame;
    const std::int64_t length = drawEnd - window_.start;
    if (length < 0 || length > longestWindowNs) window_ = {.start = drawEnd};
    if (length < statisticsWindowNs || length > longestWindowNs) return;
    constexpr double nsPerMs = 1e6;
    statistics_.framesPerSecond = window_.frames * 1e9 / static_cast<double>(length);
    statistics_.tickMilliseconds =
        static_cast<double>(window_.tickNs) / nsPerMs / std::max(window_.ticks, 1);
    statistics_.drawMilliseconds = static_cast<double>(window_.drawNs) / nsPerMs / window_.frames;
    // What is longer is waiting: for the display, for a dialog, or for the next frame.
    const double other = static_cast<double>(length - window_.tickNs) / nsPerMs / window_.frames;
    otherMilliseconds_ = std::min(other, statistics_.drawMilliseconds + mostBesidesDrawingMs);
    window_ = {.start = drawEnd};
}

namespace {

/// Draws into memory; frames follow each other without waiting, 1/60 s apart on its own clock.
class OffscreenPlatform : public BackendPlatform {
public:
    OffscreenPlatform(Application& application, const WindowOptions& options)
        : BackendPlatform(application, options, [this] { return clockNs(); }),
          screen_(std::in_place, options.size) {}
    ~OffscreenPlatform() override { end(); }

    int loop() {
        handle(WindowResized{screen_->size(), 1});
        begin();
        while (!finished()) {
            ++frames_;
            frame(!minimised_);
        }
        end();
        return exitCode();
    }

    void setTitle(const std::string&) override {}
    void setFullscreen(bool fullscreen) override { fullscreen_ = fullscreen; }
    bool fullscreen() const override { return fullscreen_; }
    void setWindowSize(PixelSize size) override {
        screen_->resize(size);
        handle(WindowResized{size, 1});
    }
    void setMinimised(bool minimised) override { minimised_ = minimised; }
    bool minimised() const override { return minimised_; }
    void setVsync(bool) override {}
    void setCursorVisible(bool) override {}
    void setCursor(Cursor) override {}
    void setTextInput(bool) override {}
    std::string clipboard() override { return clipboard_; }
    void setClipboard(const std::string& utf8) override { clipboard_ = utf8; }

protected:
    void beginCanvasFrame(Canvas& canvas) override { canvas.beginFrame(screen_->target(), 1); }
    void remakeContext() override {
        const PixelSize before = screen_->size();
        screen_.reset();
        screen_.emplace(before);
    }

private:
    // Multiplied before it is divided, so that frames do not drift against seconds.
    std::int64_t clockNs() const { return frames_ * 1'000'000'000 / 60; }

    std::optional<OffscreenCanvas> screen_;
    std::int64_t frames_ = 0;
    bool fullscreen_ = false;
    bool minimised_ = false;
    std::string clipboard_;
};

}  // namespace

int runOffscreen(Application& application, const WindowOptions& options) {
    return guarded([&] { return OffscreenPlatform(application, options).loop(); });
}

int guarded(const std::function<int()>& body) noexcept {
    try {
        return body();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    } catch (...) {
        std::fprintf(stderr, "the program failed for an unknown reason\n");
    }
    return 1;
}

}  // namespace atlax
