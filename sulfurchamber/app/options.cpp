#include "options.hpp"

#include <CLI/CLI.hpp>
#include <atlax/arguments.hpp>
#include <string>
#include <vector>

#include "../model/words.hpp"

namespace sulfurchamber {

Parsed parseCommandLine(int argc, char** argv) {
    Parsed parsed;
    Options& options = parsed.options;
    CLI::App app{"SulfurChamber: build things out of particles and joints, and play with them.",
                 "sulfurchamber"};
    app.set_version_flag("--version", std::string("sulfurchamber ") + SULFURCHAMBER_VERSION);
    app.add_option("FILE", options.file, "Scene or level to open");
    app.add_flag("--play", options.play, "Start playing at once");
    app.add_option("--drop", options.drop, "Let this many boxes fall into the scene")
        ->check(CLI::Range(0, 4000));
    app.add_option("--rain", options.rain, "Let this many boxes per second fall")
        ->check(atlax::between(0, 100), "0 to 100");
    app.add_option("--screenshot", options.screenshot,
                   "Write a picture of the window (PNG) at the time --at, then quit");
    auto* picture = app.add_option(
        "--picture", options.picture,
        "Write a picture of the drawing area (PNG) at the time --at; needs no display");
    app.add_option("--at", options.at, "Seconds of simulated time for the pictures")
        ->check(atlax::between(0, 3600), "0 to 3600");
    app.add_option("--script", options.script, "Run a script of commands (see --script-help)")
        ->excludes(picture);  // which has no window to act on
    app.add_option("--autosave", options.autosave,
                   "Seconds after which unsaved work is kept for a crash (default 30)")
        ->check(CLI::Range(1, 3600));
    const auto* theme =
        app.add_option("--theme", options.theme,
                       "Scene and panels: dark (default), light, or as the system has it")
            ->check(CLI::IsMember({"dark", "light", "system"}));
    std::vector<std::string> spoken = languages();
    spoken.emplace_back("system");
    const auto* language =
        app.add_option("--language", options.language,
                       "Of menus and texts: en, de, it, or as the system has it (default)")
            ->check(CLI::IsMember(spoken));
    const auto* width = app.add_option("--width", options.width, "Width of the window in pixels")
                            ->check(CLI::Range(320, 8192));
    const auto* height =
        app.add_option("--height", options.height, "Height of the window in pixels")
            ->check(CLI::Range(240, 8192));
    app.footer(
        "Settings: $XDG_CONFIG_HOME/sulfurchamber; log and crash reports: "
        "$XDG_STATE_HOME/sulfurchamber.");
    bool scriptHelp = false;
    app.add_flag("--script-help", scriptHelp, "List the commands of scripts");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        parsed.exitCode = app.exit(error);
    }
    options.themeGiven = theme->count() > 0;
    options.languageGiven = language->count() > 0;
    if (options.language == "system") options.language.clear();
    options.sizeGiven = width->count() + height->count() > 0;
    if (scriptHelp && !parsed.exitCode) parsed.exitCode = -1;
    return parsed;
}

}  // namespace sulfurchamber
