// quaoar: plays Escape from Quaoar, verifies its levels, takes pictures of them.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atlax/arguments.hpp>
#include <atlax/backend.hpp>
#include <atlax/records.hpp>
#include <cstdio>
#include <new>
#include <quaoar/view/art.hpp>
#include <sulfur/version.hpp>

#include "commands.hpp"
#include "daily_course.hpp"
#include "game.hpp"

namespace {

struct Arguments {
    std::string level;
    bool headless = false;
    std::vector<std::string> verify;
    std::string screenshot;
    double at = 0;
    std::string replay;
    std::string size;
    std::string language;
    std::string record;
    std::string play;
    bool fullscreen = false;
    bool unlockAll = false;
};

void describe(CLI::App& app, Arguments& arguments) {
    app.set_version_flag("--version", std::string("quaoar ") + sulfur::version());
    app.add_option("--level", arguments.level,
                   "Level file, played at once; else the title screen of the game's levels")
        ->type_name("FILE");
    auto* headless =
        app.add_flag("--headless", arguments.headless, "No window; only together with --verify");
    auto* verify = app.add_option("--verify", arguments.verify,
                                  "Replay the proof beside each level file and tell whether it "
                                  "finishes")
                       ->type_name("FILE...");
    headless->needs(verify);
    auto* screenshot = app.add_option("--screenshot", arguments.screenshot,
                                      "Draw one picture offscreen and write it as PNG")
                           ->type_name("OUT.png");
    app.add_option("--at", arguments.at, "Seconds after the start at which the picture is taken")
        ->check(atlax::between(0, 3600), "0 to 3600")
        ->needs(screenshot);
    app.add_option("--replay", arguments.replay, "Recording that is played up to the picture")
        ->type_name("FILE")
        ->needs(screenshot);
    app.add_option("--size", arguments.size,
                   "Size of the picture or the window in pixels; the last window's, or 1280x720")
        ->type_name("WIDTHxHEIGHT");
    app.add_option("--language", arguments.language,
                   "\"en\", \"de\", \"it\"; else as set in the game")
        ->type_name("CODE");
    app.add_option("--record", arguments.record, "Write the inputs of the last attempt")
        ->type_name("FILE");
    app.add_option("--play", arguments.play, "Watch a recording")->type_name("FILE");
    app.add_flag("--fullscreen", arguments.fullscreen, "Fill the screen");
    app.add_flag("--unlock-all", arguments.unlockAll, "Every level may be played");
    app.footer(
        "Mouse: aim, hold left to fire.  W S: reel.  A D: swing.  R: again.  Esc: pause.\n"
        "Levels are searched in $QUAOAR_LEVELS, the installed and the source folder.\n"
        "Settings: $XDG_CONFIG_HOME/quaoar; progress and replays: $XDG_DATA_HOME/quaoar; log and "
        "crash reports: $XDG_STATE_HOME/quaoar.");
}

atlax::PixelSize readSize(const std::string& text) {
    int width = 0, height = 0;
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &rest);
    if (read != 2 || width < 64 || width > 8192 || height < 64 || height > 8192) {
        throw std::runtime_error("--size \"" + text +
                                 "\" is no size; allowed is WIDTHxHEIGHT, each from 64 to 8192");
    }
    return {width, height};
}

/// A file as given, or a level of the game by its name.
std::filesystem::path levelFile(const Arguments& arguments) {
    if (!arguments.level.empty()) return arguments.level;
    return quaoar::levelAssets().find("01-cold-wake.json");
}

/// Those of the first folder that has any.
quaoar::LevelList gameLevels() {
    std::string searched;
    const atlax::Assets assets = quaoar::levelAssets();
    for (const auto& folder : assets.folders()) {
        quaoar::LevelList levels = quaoar::LevelList::ofFolder(folder);
        if (!levels.empty()) return levels;
        searched += " " + folder.string();
    }
    throw std::runtime_error("there is no level; searched were:" + searched);
}

/// The level that was asked for among those of its folder, or all of the game.
quaoar::GameOptions levelsOf(const Arguments& arguments) {
    quaoar::GameOptions options;
    if (arguments.level.empty()) {
        options.levels = gameLevels();
        options.levels.addOwn(quaoar::LevelList::ownFolder());
        options.story = true;
        options.daily.emplace(quaoar::Daily::usualFolder(), quaoar::today());
        return options;
    }
    std::size_t index = 0;
    options.levels = quaoar::LevelList::around(arguments.level, index);
    options.level = options.levels.level(index);
    options.skipTitle = true;
    return options;
}

/// That of a recording. Throws when there is none, or when another one was asked for.
std::shared_ptr<const quaoar::Level> levelOf(const quaoar::GameOptions& options,
                                             const quaoar::Recording& recording) {
    if (options.level) {
        quaoar::requireMatch(*options.level, recording);
        return options.level;
    }
    if (const auto index = options.levels.find(recording)) return options.levels.level(*index);
    quaoar::requireMatch(options.levels[0], recording);
    return nullptr;
}

int playGame(const Arguments& arguments) {
    quaoar::GameOptions options = levelsOf(arguments);
    options.unlockAll = arguments.unlockAll;
    options.progress = quaoar::Progress::folder();
    if (!arguments.record.empty()) options.record = arguments.record;
    if (!arguments.play.empty()) {
        options.replay =
            std::make_shared<const quaoar::Recording>(quaoar::Recording::read(arguments.play));
        options.level = levelOf(options, *options.replay);
    }
    if (!arguments.language.empty()) options.language = arguments.language;
    atlax::WindowOptions window;
    window.title = "Escape from Quaoar";
    if (!arguments.size.empty()) window.size = readSize(arguments.size);
    atlax::keepRecords("quaoar", sulfur::version());
    quaoar::Preferences preferences(quaoar::Preferences::settingsFile());
    quaoar::Game game(std::move(options), preferences);
    if (arguments.size.empty()) window.size = preferences.windowSize();
    window.fullscreen = arguments.fullscreen || preferences.on(quaoar::Choice::fullscreen);
    window.vsync = preferences.on(quaoar::Choice::vsync);
    window.tickRateHz = quaoar::Session::tickRate;
    return atlax::run(game, window);
}

void requireLanguage(const std::string& code) {
    const std::vector<std::string> all = quaoar::Texts().languages();
    if (code.empty() || std::find(all.begin(), all.end(), code) != all.end()) return;
    std::string allowed;
    for (const std::string& language : all) allowed += (allowed.empty() ? "" : ", ") + language;
    throw std::runtime_error("--language \"" + code +
                             "\" is none that the game speaks; allowed: " + allowed);
}

int runProgram(const Arguments& arguments) {
    requireLanguage(arguments.language);
    if (!arguments.verify.empty()) {
        return quaoar::verifyLevels({arguments.verify.begin(), arguments.verify.end()});
    }
    if (!arguments.screenshot.empty()) {
        quaoar::PictureOptions picture;
        picture.file = arguments.screenshot;
        picture.level = levelFile(arguments);
        picture.at = arguments.at;
        if (!arguments.replay.empty()) picture.replay = arguments.replay;
        if (!arguments.size.empty()) picture.size = readSize(arguments.size);
        if (!arguments.language.empty()) picture.language = arguments.language;
        quaoar::takePicture(picture);
        return 0;
    }
    return playGame(arguments);
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("Escape from Quaoar: a game of ropes on a dwarf planet", "quaoar");
    describe(app, arguments);
    CLI11_PARSE(app, argc, argv);
    try {
        return runProgram(arguments);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "quaoar: there is not enough memory\n");
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "quaoar: %s\n", error.what());
        return 1;
    }
}
