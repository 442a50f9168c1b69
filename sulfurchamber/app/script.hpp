// Drives the window as a person would: for tests and for pictures.
#pragma once

#include <wx/uiaction.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "main_frame.hpp"

namespace sulfurchamber {

/// What --script-help prints.
std::string scriptHelp();

/// Runs one command after the other between the frames. Clicks and keys are real events of the
/// window system; a command waits until its events have arrived, however long that takes,
/// so that nothing depends on the speed of the machine. The first command that fails ends the
/// program with code 1 and a sentence on standard error.
class Script {
public:
    /// Reads options.script, or makes the commands that --screenshot needs. Throws
    /// std::runtime_error when the file cannot be read.
    Script(MainFrame& frame, const Options& options);

private:
    using Words = std::vector<std::string>;
    struct Line {
        int number = 0;
        Words words;
    };

    void step();
    void goOn();
    void start(const Words& words);
    bool startPointer(const Words& words);
    void setOfSelection(const std::string& key, double value);
    bool startWorld(const Words& words);
    bool startTemplate(const Words& words);
    bool startFile(const Words& words);
    // level_script.cpp
    bool startLevel(const Words& words);
    void swing(const sulfur::Point& at, int key, double seconds);
    std::optional<double> levelQuantity(const std::string& name) const;
    bool holds(const Words& words) const;
    bool startOutline(const Words& words);
    // script_actions.cpp
    struct Round {
        std::filesystem::path file;      ///< what each action has before it
        int ticks = 0;                   ///< that have passed then
        std::vector<std::string> names;  ///< of actions
        bool byKey = false;              ///< their keys are pressed
    };
    void everyAction(const Words& words);
    void tryAction(const std::shared_ptr<const Round>& round, std::size_t index);
    void pressKeyOf(const std::string& name, std::function<void()> then);
    void takeBack(const std::string& name, const std::string& before);
    void clickScreen(const wxPoint& place, bool twice);
    void expect(const Words& words);
    double quantity(const std::string& name) const;
    /// Goes on with `then` once `done` says so.
    void waitFor(std::function<bool()> done, std::function<void()> then = {});
    void slide(double from, double to);
    void dragPlot(double from, double to);
    void press(const sulfur::Point& at, std::function<void()> then);
    void moveMouse(const sulfur::Point& at, std::function<void()> then);
    /// Of the drawing area; false where that has no such place.
    bool moveMouseTo(const atlax::Vec2& pixels, std::function<void()> then);
    void strokeThrough(const std::vector<sulfur::Point>& places, std::size_t next,
                       const std::function<void()>& then);
    void waitForFrames(int frames, std::function<void()> then);
    [[noreturn]] static void fail(const std::string& why);
    static double number(const std::string& word);

    MainFrame& frame_;
    std::string name_;
    std::vector<Line> lines_;
    std::size_t next_ = 0;
    std::function<bool()> waiting_;
    std::function<void()> then_;
    std::uint64_t waitedFrames_ = 0;
    double slideCost_ = 0;        ///< ms of processor time a frame
    std::set<std::string> done_;  ///< actions that were available in a round
    bool busy_ = false;           // the simulator lets events through while it works
    wxUIActionSimulator simulator_;
    std::chrono::steady_clock::time_point lastPress_;
};

}  // namespace sulfurchamber
