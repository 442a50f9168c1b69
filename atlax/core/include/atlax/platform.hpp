#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <atlax/audio.hpp>
#include <atlax/canvas.hpp>
#include <atlax/event.hpp>
#include <atlax/input.hpp>
#include <atlax/timestep.hpp>

namespace atlax {

/// What the last frames cost; refreshed about twice a second except where said otherwise.
struct FrameStatistics {
    double framesPerSecond = 0;
    double tickMilliseconds = 0;  ///< average of one tick
    double drawMilliseconds = 0;  ///< average of one draw, without waiting for the display
    int ticksLastFrame = 0;       ///< of the last frame
    std::uint64_t frames = 0;     ///< since the start
};

/// Shapes of the mouse's cursor; the desktop's theme says how each looks. Where a desktop lacks
/// one, its nearest is shown.
enum class Cursor : std::uint8_t {
    Arrow = 0,
    Text,
    Hand,
    Crosshair,
    Move,
    ResizeHorizontal,
    ResizeVertical,
    Wait,
    Forbidden,
};
inline constexpr int cursorCount = 9;

/// A kind of file that a dialog offers: a name for the user and endings without the dot ("png").
struct FileKind {
    std::string name{};
    std::vector<std::string> endings{};
};

/// What Platform::chooseFile asks. All texts are UTF-8.
struct FileDialog {
    std::string title{};
    bool save = false;               ///< a file to write, which may be new; else one that exists
    std::filesystem::path folder{};  ///< where it begins; empty for the desktop's choice
    std::string name{};              ///< proposed name of a file to write
    std::vector<FileKind> kinds{};   ///< empty for all files
};

/// What a backend offers to the application that it runs. The same for every backend. Main thread
/// only; valid from Application::start until Application::stop has returned. The backend owns it
/// and all that it hands out. Only what says so throws: what a desktop refuses (fullscreen, a
/// clipboard that somebody holds) is said in the log or left undone.
class Platform {
public:
    virtual ~Platform() = default;

    // -- drawing, sound, input --
    virtual Canvas& canvas() = 0;
    virtual Audio& audio() = 0;
    /// The input of the current tick; between ticks, that of the last one. While the clock is
    /// paused it is that of the current frame, so that presses in a pause never reach a later tick.
    virtual const InputState& input() const = 0;
    /// Handles an event as if it came from the user, before the next tick: for scripts and tests.
    virtual void post(const Event& event) = 0;

    // -- time --
    /// Tick rate, pause, single tick, slow motion, overload.
    virtual FixedTimestep& clock() = 0;
    virtual const FrameStatistics& statistics() const = 0;

    // -- window --
    /// Drawable area in pixels, and pixels per logical unit (HiDPI).
    virtual PixelSize size() const = 0;
    virtual float scaleFactor() const = 0;
    virtual bool focused() const = 0;
    virtual void setTitle(const std::string& utf8) = 0;
    virtual void setFullscreen(bool fullscreen) = 0;
    virtual bool fullscreen() const = 0;
    /// Logical units; ignored in fullscreen.
    virtual void setWindowSize(PixelSize size) = 0;
    /// Takes the window off the screen or brings it back. A minimised window ticks but is not
    /// drawn.
    virtual void setMinimised(bool minimised) = 0;
    virtual bool minimised() const = 0;
    /// Whether a frame waits for the display; at the start as WindowOptions::vsync says. Where the
    /// driver does not offer the choice, nothing happens.
    virtual void setVsync(bool on) = 0;
    virtual void setCursorVisible(bool visible) = 0;
    /// The shape that the cursor has over the window, while it is visible; an arrow at the start.
    virtual void setCursor(Cursor cursor) = 0;
    /// TextEvents (and an input method's window) come only while this is on; off at the start.
    virtual void setTextInput(bool on) = 0;
    /// UTF-8; empty when there is none.
    virtual std::string clipboard() = 0;
    virtual void setClipboard(const std::string& utf8) = 0;

    /// Whether this backend can show chooseFile: wxWidgets does, SDL2 has no dialogs.
    virtual bool hasFileDialogs() const = 0;
    /// Lets the user choose a file, and waits: no tick, frame or event comes meanwhile, and the
    /// time of it is given up as that of any long pause is. Empty when the user declined, and, with
    /// a warning in the log, where there are no dialogs. Only from within a callback other than
    /// draw.
    virtual std::optional<std::filesystem::path> chooseFile(const FileDialog& dialog) = 0;

    /// Writes the next frame as PNG. A failure goes to the log and changes nothing else.
    virtual void requestScreenshot(const std::filesystem::path& file) = 0;
    /// Ends the program after the current callback with this exit code.
    virtual void quit(int exitCode = 0) = 0;
};

}  // namespace atlax
