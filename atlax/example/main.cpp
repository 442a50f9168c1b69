// atlax_example: what an application of atlax looks like, once for every backend.
#include <CLI/CLI.hpp>
#include <atlax/arguments.hpp>
#include <atlax/backend.hpp>

#include "example.hpp"

int main(int argc, char** argv) {
    CLI::App app("Shows what atlax offers: window, input, clipboard, cursor, ticks.");
    ExampleOptions example;
    atlax::WindowOptions window;
    window.title = "Atlax example";
    window.size = {640, 480};
    double seconds = 0;
    app.add_option("--ticks", window.tickRateHz, "Ticks a second")
        ->check(CLI::Range(atlax::FixedTimestep::minRateHz, atlax::FixedTimestep::maxRateHz));
    auto* measured = app.add_option("--seconds", seconds,
                                    "Measure so long how ticks keep to real time, then end")
                         ->check(atlax::between(0.1, 3600), "0.1 to 3600");
    app.add_option("--pictures", example.pictures, "Folder of the pictures that F12 takes")
        ->check(CLI::ExistingDirectory);
    app.add_flag("--still", example.still, "Draw no motion");
    app.add_flag("--load", example.load, "Draw 100,000 textured triangles and 10,000 capsules");
    app.add_flag("--effects", example.effects, "Draw with bloom and vignette");
    app.add_flag("--fullscreen", window.fullscreen, "Fill the screen");
    app.add_flag("--offscreen", window.offscreen, "No window: draw into memory");
    CLI11_PARSE(app, argc, argv);
    if (measured->count() > 0) example.seconds = seconds;
    return atlax::guarded([&] {
        Example application(std::move(example));
        return atlax::run(application, window);
    });
}
