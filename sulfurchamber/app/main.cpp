// SulfurChamber's start: what can be refused is refused before a window opens.
#include <malloc.h>

#include <atlax/files.hpp>
#include <atlax/records.hpp>
#include <atlax/wx/view.hpp>
#include <clocale>
#include <cstdlib>
#include <iostream>
#include <new>

#include "../model/words.hpp"
#include "chamber_app.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "preferences.hpp"
#include "script.hpp"

namespace {

using sulfurchamber::Options;
using sulfurchamber::Workbench;

/// The steps of the history come and go as long as one works. What they leave goes back to the
/// system: glibc would keep holes of their sizes, which it learns from the first that go, and fill
/// them badly. What frames take and leave on the heap's end stays, as it would have otherwise.
void giveLargeBlocksBack() {
    constexpr int large = 256 << 10, end = 64 << 20;
    ::mallopt(M_MMAP_THRESHOLD, large);
    ::mallopt(M_TRIM_THRESHOLD, end);
}

/// What the command line does not say is in the settings. Scripts and pictures speak English.
void chooseLanguageAndTheme(Options& options) {
    using sulfurchamber::Preferences;
    if (options.unattended() || !options.picture.empty()) {
        if (!options.languageGiven) options.language = "en";
        return;
    }
    if (options.languageGiven && options.themeGiven) return;
    const Preferences preferences(Preferences::settingsFile());
    if (!options.languageGiven) options.language = preferences.language();
    if (!options.themeGiven) options.theme = preferences.theme();
}

int runWindow(Workbench& bench, const Options& options, char* program) {
    if (!options.unattended()) atlax::keepRecords("sulfurchamber", SULFURCHAMBER_VERSION);
    atlax::wx::prepareDisplay();
    if (options.theme != "system")
        setenv("GTK_THEME", options.theme == "dark" ? "Adwaita:dark" : "Adwaita", 0);
    wxApp::SetInstance(new sulfurchamber::ChamberApp(bench, options));
    int argc = 1;
    char* argv[] = {program, nullptr};
    if (!wxEntryStart(argc, argv)) {
        std::cerr << "sulfurchamber: no window can be opened: there is no display (DISPLAY or "
                     "WAYLAND_DISPLAY is not set, or refuses); --picture works without one\n";
        return 1;
    }
    // Numbers are written and read with a point everywhere, as in files.
    std::setlocale(LC_NUMERIC, "C");
    sulfurchamber::setLanguage(options.language);  // after GTK, which sets the locale
    const int code = wxTheApp->CallOnInit() ? wxTheApp->OnRun() : 1;
    wxEntryCleanup();
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    const auto parsed = sulfurchamber::parseCommandLine(argc, argv);
    if (parsed.exitCode == -1) {
        std::cout << sulfurchamber::scriptHelp();
        return 0;
    }
    if (parsed.exitCode) return *parsed.exitCode;
    Options options = parsed.options;
    chooseLanguageAndTheme(options);
    giveLargeBlocksBack();
    try {
        Workbench bench(atlax::stateFolder("sulfurchamber"));
        if (!options.file.empty()) bench.document().open(options.file);
        bench.dropBoxes(options.drop);
        bench.setRain(options.rain);
        sulfurchamber::setLanguage(options.language);
        if (!options.picture.empty()) return sulfurchamber::writePicture(bench, options);
        return runWindow(bench, options, argv[0]);
    } catch (const std::bad_alloc&) {
        std::cerr << "sulfurchamber: there is not enough memory\n";
        return 1;
    } catch (const std::exception& error) {
        std::cerr << "sulfurchamber: " << error.what() << "\n";
        return 1;
    }
}
