// sulfur_lab: accuracy, stability and speed experiments.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sulfur/version.hpp>

#include "rope_tables.hpp"

namespace {

using namespace sulfur::lab;

struct Experiment {
    std::string name;
    std::string description;
    const PaperTable& (*table)();
};

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{
        {"table2", "the paper's Table 2: largest elastic constant over damping", paperTable2},
        {"table3", "the paper's Table 3: largest elastic constant over the refresh rate",
         paperTable3},
    };
    return all;
}

std::string listing() {
    std::string text;
    for (const auto& experiment : experiments())
        text += fmt::format("{:<10}{}\n", experiment.name, experiment.description);
    return text;
}

struct Options {
    std::string name;
    bool list = false, csv = false, json = false, onlyExplosions = false;
    std::string plotFolder;
    RopeConstants rope;
    SearchOptions search;
};

/// Written beside its name and then renamed, so that no half picture is ever there.
void writeWhole(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::path half = file;
    half += ".new";
    std::ofstream stream(half, std::ios::binary);
    stream << text;
    stream.close();
    std::error_code problem;
    if (stream) std::filesystem::rename(half, file, problem);
    if (stream && !problem) return;
    std::error_code ignored;
    std::filesystem::remove(half, ignored);
    throw std::runtime_error(file.string() +
                             " cannot be written; choose a folder with --plot that can");
}

int run(Options options) {
    if (options.list) {
        std::cout << listing();
        return 0;
    }
    if (options.name.empty())
        throw std::runtime_error("no experiment is named; name one of those that --list shows");
    const auto& all = experiments();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.name == options.name; });
    if (found == all.end())
        throw std::runtime_error("there is no experiment \"" + options.name +
                                 "\"; --list shows those that there are");
    if (!options.plotFolder.empty()) std::filesystem::create_directories(options.plotFolder);
    options.search.mustRest = !options.onlyExplosions;
    const auto result = measure(found->table(), options.rope, options.search);
    std::cout << (options.csv ? asCsv(result) : options.json ? asJson(result) : asText(result));
    if (!options.plotFolder.empty())
        writeWhole(std::filesystem::path(options.plotFolder) / (options.name + ".svg"),
                   asSvg(result));
    std::cout.flush();
    if (!std::cout) throw std::runtime_error("the result cannot be written to standard output");
    return 0;
}

void declare(CLI::App& app, Options& options) {
    app.set_version_flag("--version", std::string("sulfur_lab ") + sulfur::version());
    app.add_option("experiment", options.name, "Name of an experiment");
    app.add_flag("--list", options.list, "Name the experiments");
    auto* csv = app.add_flag("--csv", options.csv, "Print comma-separated values");
    app.add_flag("--json", options.json, "Print JSON")->excludes(csv);
    app.add_option("--plot", options.plotFolder, "Also write an SVG picture into this folder");
    const std::map<std::string, Damper> dampers{{"paper", Damper::full}, {"axial", Damper::axial}};
    app.add_option("--damper", options.rope.damper,
                   "paper: on the whole relative velocity (default); axial: along the spring")
        ->transform(CLI::CheckedTransformer(dampers));
    app.add_flag("--only-explosions", options.onlyExplosions,
                 "A rope that never comes to rest but stays bounded counts as stable");
    app.add_option("--seconds", options.search.seconds, "Simulated time of a trial")
        ->check(CLI::Range(2.0, 1000.0))
        ->capture_default_str();
    app.add_option("--resolution", options.search.resolution, "Relative width of the last bracket")
        ->check(CLI::Range(1e-4, 1.0))
        ->capture_default_str();
    app.add_option("--highest", options.search.highest, "Where the search ends, N/m")
        ->check(CLI::Range(100.0, 1e12))
        ->capture_default_str();
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Accuracy, stability and speed experiments of Sulfur", "sulfur_lab"};
    declare(app, options);
    try {
        app.parse(argc, argv);
        return run(options);
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const std::exception& e) {
        std::cerr << "sulfur_lab: " << e.what() << '\n';
        return 1;
    }
}
