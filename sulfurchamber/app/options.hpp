// The command line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sulfurchamber {

struct Options {
    std::filesystem::path file;  ///< empty: a new scene
    int drop = 0;                ///< boxes that fall at the start
    double rain = 0;             ///< boxes per second
    bool play = false;
    double at = 0;                     ///< seconds of simulated time before a picture
    std::filesystem::path picture;     ///< drawing area, without a window
    std::filesystem::path screenshot;  ///< the whole window
    std::filesystem::path script;
    int autosave = 30;           ///< seconds after which unsaved work is kept
    std::string language;        ///< "de" and so on; empty: as the system has it
    bool languageGiven = false;  ///< else that of the settings counts, and English for scripts
    std::string theme = "dark";  ///< dark, light or system
    bool themeGiven = false;     ///< else that of the settings counts, but not for scripts
    int width = 1280;
    int height = 800;
    bool sizeGiven = false;  ///< else the last window's size counts

    /// Driven by a script or for a picture: no questions, no settings read or written.
    bool unattended() const { return !screenshot.empty() || !script.empty(); }
};

/// The options, or the exit code with which to end at once (after --help, --version and
/// mistakes, which were told).
struct Parsed {
    Options options;
    std::optional<int> exitCode;
};
Parsed parseCommandLine(int argc, char** argv);

}  // namespace sulfurchamber
