// bench: ours beside other engines, scene by scene.
#include <CLI/CLI.hpp>
#include <iostream>

#include "bench/clock.hpp"
#include "bench/history.hpp"
#include "bench/show.hpp"
#include "experiments/experiment.hpp"
#include "experiments/number.hpp"

namespace sulfur::lab {

namespace {

class Bench final : public Experiment {
public:
    std::string name() const override { return "bench"; }
    std::string description() const override {
        return "time and error beside other engines on the same scenes";
    }

    void declare(CLI::App& app) override {
        app.add_option("--scene", scenes_, "Only these scenes, with commas between them")
            ->delimiter(',')
            ->check(CLI::IsMember(bench::sceneNames()));
        std::vector<std::string> keys;
        for (const bench::Engine& engine : bench::engines()) keys.push_back(engine.key);
        app.add_option("--engine", engines_, "Only these engines, with commas between them")
            ->delimiter(',')
            ->check(CLI::IsMember(keys));
        auto* quick = app.add_flag("--quick", quick_, "Small sizes, two rounds");
        app.add_flag("--large", large_, "Also the largest sizes")->excludes(quick);
        app.add_option("--rounds", rounds_, "Runs of each row; 5, with --quick 2")
            ->check(between(1, 1000));
        app.add_option("--limit", options_.limit, "Seconds after which a run is stopped")
            ->check(between(0.01, 1e6))
            ->capture_default_str();
        app.add_option("--core", options_.core, "Processor core; the last one by default")
            ->check(between(0, 4095));
        app.add_flag("!--no-stages", options_.stages, "No times of the stages of a tick");
        app.add_flag("--progress", progress_, "Tell on standard error what runs");
        app.add_option("--history", history_,
                       "Add the rows of ours to this file and compare with its last entries");
        app.add_option("--date", date_, "Of the entries; today by default")->needs("--history");
    }

    Report run() override {
        checkOptions();
        options_.rounds = rounds_ > 0 ? rounds_ : quick_ ? 2 : 5;
        if (progress_)
            options_.tell = [](const std::string& line) { std::cerr << line << std::endl; };
        const auto extent = quick_   ? bench::Extent::quick
                            : large_ ? bench::Extent::large
                                     : bench::Extent::usual;
        const bench::Comparison comparison =
            bench::compare(bench::scenes(scenes_, extent), engines_, options_);
        Report report{bench::asText(comparison), bench::asCsv(comparison),
                      bench::asJson(comparison)};
        for (auto& [file, svg] : bench::asSvg(comparison))
            report.pictures.push_back({file, std::move(svg)});
        if (!history_.empty()) report.text += bench::keepHistory(history_, date_, comparison);
        return report;
    }

private:
    /// Before anything runs for minutes.
    void checkOptions() {
        for (const std::string& key : engines_) {
            const bench::Engine& engine = bench::engineOf(key);
            if (!engine.found())
                throw std::runtime_error("--engine " + key + ": " + engine.title +
                                         " was not found when this program was built; " +
                                         engine.how);
        }
        if (date_.empty()) date_ = bench::today();
        bench::checkDate(date_);
        if (options_.core < 0) return;
        if (bench::Pinned(options_.core).core() != options_.core)
            throw std::runtime_error("--core " + std::to_string(options_.core) +
                                     ": this program may not run there; choose one of those that "
                                     "taskset or the system allows");
    }

    std::vector<std::string> scenes_, engines_;
    bench::CompareOptions options_;
    int rounds_ = 0;
    bool quick_ = false, large_ = false, progress_ = false;
    std::string history_, date_;
};

}  // namespace

std::unique_ptr<Experiment> makeBench() {
    return std::make_unique<Bench>();
}

}  // namespace sulfur::lab
