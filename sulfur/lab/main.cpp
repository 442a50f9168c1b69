// sulfur_lab: accuracy, stability and speed experiments.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sulfur/version.hpp>

#include "experiments/experiment.hpp"

namespace {

using namespace sulfur::lab;

struct Options {
    bool list = false, csv = false, json = false;
    std::string plotFolder;
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

void show(const Report& report, const Options& options) {
    std::cout << (options.csv ? report.csv : options.json ? report.json : report.text);
    if (!options.plotFolder.empty())
        for (const auto& picture : report.pictures)
            writeWhole(std::filesystem::path(options.plotFolder) / picture.file, picture.svg);
    std::cout.flush();
    if (!std::cout) throw std::runtime_error("the result cannot be written to standard output");
}

/// Returns the exit status: 0, or 2 when the experiment found that something does not hold.
int run(const CLI::App& app, const Options& options, const Experiments& experiments) {
    if (options.list) {
        for (const auto& experiment : experiments)
            std::cout << fmt::format("{:<11}{}\n", experiment->name(), experiment->description());
        return 0;
    }
    for (const auto& experiment : experiments) {
        if (!app.got_subcommand(experiment->name())) continue;
        if (!options.plotFolder.empty()) std::filesystem::create_directories(options.plotFolder);
        const Report report = experiment->run();
        show(report, options);
        return report.passed ? 0 : 2;
    }
    throw std::runtime_error("no experiment is named; name one of those that --list shows");
}

void declare(CLI::App& app, Options& options, const Experiments& experiments) {
    app.set_version_flag("--version", std::string("sulfur_lab ") + sulfur::version());
    app.add_flag("--list", options.list, "Name the experiments");
    auto* csv = app.add_flag("--csv", options.csv, "Print comma-separated values");
    app.add_flag("--json", options.json, "Print JSON")->excludes(csv);
    app.add_option("--plot", options.plotFolder, "Also write SVG pictures into this folder");
    app.require_subcommand(0, 1);
    // What an experiment does not know may be one of the options above.
    app.fallthrough();
    for (const auto& experiment : experiments)
        experiment->declare(
            *app.add_subcommand(experiment->name(), experiment->description())->fallthrough());
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    const Experiments experiments = allExperiments();
    CLI::App app{"Accuracy, stability and speed experiments of Sulfur", "sulfur_lab"};
    declare(app, options, experiments);
    try {
        app.parse(argc, argv);
        return run(app, options, experiments);
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ExtrasError& e) {
        std::cerr << "sulfur_lab: " << e.what()
                  << "; --list names the experiments, NAME --help the options of one\n";
        return 1;
    } catch (const std::exception& e) {
        std::cerr << "sulfur_lab: " << e.what() << '\n';
        return 1;
    }
}
