// sulfur_lab: accuracy, stability and speed experiments.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <new>
#include <sulfur/version.hpp>

#include "experiments/experiment.hpp"
#include "whole_file.hpp"

namespace {

using namespace sulfur::lab;

struct Options {
    bool list = false, csv = false, json = false;
    std::string csvFile, jsonFile;  ///< empty: standard output
    std::string plotFolder;
};

void show(const Report& report, const Options& options) {
    if (!options.csvFile.empty()) files::writeWhole(options.csvFile, report.csv);
    if (!options.jsonFile.empty()) files::writeWhole(options.jsonFile, report.json);
    const bool csv = options.csv && options.csvFile.empty();
    const bool json = options.json && options.jsonFile.empty();
    std::cout << (csv ? report.csv : json ? report.json : report.text);
    if (!options.plotFolder.empty())
        for (const auto& picture : report.pictures)
            files::writeWhole(std::filesystem::path(options.plotFolder) / picture.file,
                              picture.svg);
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
        if (options.csv && options.csvFile.empty() && options.json && options.jsonFile.empty())
            throw std::runtime_error(
                "--csv excludes --json on standard output; give one of them a file");
        if (!options.plotFolder.empty()) std::filesystem::create_directories(options.plotFolder);
        const Report report = experiment->run();
        show(report, options);
        return report.passed ? 0 : 2;
    }
    throw std::runtime_error("no experiment is named; name one of those that --list shows");
}

/// An option that prints a form of the report, or with the name of a file writes it there.
void addOutput(CLI::App& app, const std::string& name, bool& wanted, std::string& file,
               const std::string& form) {
    app.add_option_function<std::vector<std::string>>(
           name,
           [&wanted, &file](const std::vector<std::string>& given) {
               wanted = true;
               if (!given.empty()) file = given.front();
           },
           "Print " + form + "; with a FILE, write it there and print the table")
        ->expected(0, 1)
        ->type_name("[FILE]");
}

void declare(CLI::App& app, Options& options, const Experiments& experiments) {
    app.set_version_flag("--version", std::string("sulfur_lab ") + sulfur::version());
    app.add_flag("--list", options.list, "Name the experiments");
    addOutput(app, "--csv", options.csv, options.csvFile, "comma-separated values");
    addOutput(app, "--json", options.json, options.jsonFile, "JSON");
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
    } catch (const std::bad_alloc&) {
        std::cerr << "sulfur_lab: there is not enough memory\n";
        return 1;
    } catch (const std::exception& e) {
        std::cerr << "sulfur_lab: " << e.what() << '\n';
        return 1;
    }
}
