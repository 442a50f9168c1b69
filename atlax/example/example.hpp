#pragma once

#include <atlax/application.hpp>
#include <atlax/font.hpp>
#include <atlax/post_process.hpp>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>

#include "load.hpp"
#include "tick_meter.hpp"

struct ExampleOptions {
    bool still = false;                ///< draws no motion, so that pictures can be compared
    std::optional<double> seconds{};   ///< measures ticks for so long, then ends
    bool load = false;                 ///< draws the benchmark's load
    bool effects = false;              ///< bloom and a vignette
    std::filesystem::path pictures{};  ///< folder of the pictures that F12 takes
};

/// Shows all that a platform offers, and writes every event as a line to standard output.
///
///   F1 choose a file   F2 text input on or off    F3 put the typed text on the clipboard
///   F4 read the clipboard   F5 next cursor   F6 hide the cursor   F7 smaller, F8 larger window
///   F9 minimise   F10 pause   F11 fullscreen   F12 picture
///
/// While text input is on, closing the window is refused.
class Example final : public atlax::Application {
public:
    explicit Example(ExampleOptions options);

    void start(atlax::Platform& platform) override;
    void event(const atlax::Event& event) override;
    void tick() override;
    void draw(atlax::Canvas& canvas, double alpha) override;
    bool restoreGraphics() override;
    bool mayClose() override { return !textInput_; }
    void stop() override;

private:
    void command(atlax::Key key);
    void commandWindow(atlax::Key key);
    void takePicture();
    void chooseFile();
    void makePictures();
    void say(const std::string& line);
    void drawScene(atlax::Canvas& canvas, double alpha);
    void drawState(atlax::Canvas& canvas);

    ExampleOptions options_;
    std::optional<TickMeter> meter_;
    atlax::Platform* platform_ = nullptr;
    std::optional<atlax::Font> font_;
    atlax::Texture checker_;
    std::optional<atlax::PostProcess> post_;
    std::optional<Load> load_;
    std::string typed_;
    std::string pasted_;
    bool textInput_ = false;
    bool cursorVisible_ = true;
    int cursor_ = 0;
    int pictures_ = 0;
    float turned_ = 0;   ///< notches of the wheel
    double angle_ = 0;   ///< of the wheel that turns, radians
    double before_ = 0;  ///< one tick earlier
};
