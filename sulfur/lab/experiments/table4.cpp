// table4: the paper's boxes, on until real time is lost.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/plots.hpp"
#include "bench/show.hpp"
#include "experiments/experiment.hpp"
#include "experiments/number.hpp"
#include "paper_tables.hpp"

namespace sulfur::lab {

namespace {

using bench::Row;

class Table4 final : public Experiment {
public:
    std::string name() const override { return "table4"; }
    std::string description() const override {
        return "the paper's Table 4: processor time while boxes drop, until real time is lost";
    }

    void declare(CLI::App& app) override {
        app.add_option("--rounds", options_.rounds, "Runs of each cell, whose median counts")
            ->check(between(1, 1000))
            ->capture_default_str();
        app.add_option("--most", most_, "Boxes a second at which the search for the limit ends")
            ->check(between(200, 100'000))
            ->capture_default_str();
        app.add_flag("--quick", quick_, "Three columns, one run, no search for the limit");
    }

    Report run() override {
        options_.stages = false;
        if (quick_) options_.rounds = 1;
        const std::vector<int> rates = quick_ ? std::vector{20, 60, 100} : paperBoxRates();
        std::vector<bench::Scene> scenes;
        for (const int rate : rates) scenes.push_back(bench::droppedBoxes(rate));
        bench::Comparison found = bench::compare(scenes, {}, options_);
        const std::string limit = quick_ ? "" : goOn(found);
        Report report{asText(found, rates) + limit, bench::asCsv(found), bench::asJson(found)};
        report.pictures.push_back({"table4.svg", picture(found)});
        return report;
    }

private:
    static double percent(const Row& row) { return row.msPerSecond.median / 10; }

    /// Ours with more and more boxes until a second takes more than a second. Tells where.
    std::string goOn(bench::Comparison& found) {
        std::string text = "\n";
        for (const bench::Setting& setting :
             bench::settingsFor(bench::engineOf("sulfur"), bench::droppedBoxes(200))) {
            std::vector<Row> more;
            std::string told = fmt::format("Ours, {}: keeps real time up to {} boxes a second.\n",
                                           setting.label(), most_);
            for (int rate = 200; rate <= most_; rate *= 2) {
                const Row row = single(rate, setting);
                if (row.lastSecond.median >= 1000 || row.cut()) {
                    told = describe(setting, more.empty() ? nullptr : &more.back(), row);
                    break;
                }
                more.push_back(row);
            }
            for (Row& row : more)
                if (row.scene.size > 200) found.rows.push_back(std::move(row));
            text += told;
        }
        return text;
    }

    Row single(int rate, const bench::Setting& setting) {
        Row row{bench::droppedBoxes(rate), setting, {}, {}, 0, {}};
        const bench::RunResult run =
            bench::runOnce(row.scene, bench::engineOf("sulfur"), setting, options_.limit);
        row.simulated = run.simulated;
        row.figures = run.figures;
        row.msPerSecond = bench::spreadOf({1e3 * run.seconds / run.simulated});
        if (run.lastSecond > 0) row.lastSecond = bench::spreadOf({1e3 * run.lastSecond});
        return row;
    }

    static std::string describe(const bench::Setting& setting, const Row* before, const Row& row) {
        const int boxes = static_cast<int>(10 * row.scene.size);
        std::string text =
            row.cut() ? fmt::format("Ours, {}: real time is lost below {} boxes (stopped)",
                                    setting.label(), boxes)
                      : fmt::format(
                            "Ours, {}: real time is lost below {} boxes, of which the last "
                            "second takes {:.0f} %",
                            setting.label(), boxes, row.lastSecond.median / 10);
        if (before != nullptr)
            text +=
                fmt::format("; {} boxes take {:.0f} %", static_cast<int>(10 * before->scene.size),
                            before->lastSecond.median / 10);
        return text + ".\n";
    }

    static std::string asText(const bench::Comparison& found, const std::vector<int>& rates) {
        std::string out =
            "Share of a core's time (%) that physics takes while N boxes of 1 m drop each second, "
            "the mean of\n10 s. The arena and the way they drop are scene S1's, because the "
            "paper does not tell its own;\nthe machines are the paper's, of 2014 and before.\n" +
            bench::missingEngines();
        out += fmt::format("{:<36}", "boxes a second");
        for (const int rate : rates) out += fmt::format("{:>8}", rate);
        out += '\n';
        for (const PaperMachine& machine : paperTable4()) {
            out += fmt::format("{:<36}", "paper: " + machine.name);
            for (std::size_t i = 0; i < paperBoxRates().size(); ++i)
                if (std::find(rates.begin(), rates.end(), paperBoxRates()[i]) != rates.end())
                    out += fmt::format("{:>8.0f}", machine.percent[i]);
            out += '\n';
        }
        for (const std::string& title : titles(found)) {
            out += fmt::format("{:<36}", title);
            for (const int rate : rates)
                for (const Row& row : found.rows)
                    if (titleOf(row) == title && row.scene.size == rate)
                        out += fmt::format("{:>8.2f}", percent(row));
            out += '\n';
        }
        return out;
    }

    static std::string titleOf(const Row& row) {
        return bench::engineOf(row.setting.engine).title + ", " + row.setting.label();
    }
    static std::vector<std::string> titles(const bench::Comparison& found) {
        std::vector<std::string> all;
        for (const Row& row : found.rows)
            if (std::find(all.begin(), all.end(), titleOf(row)) == all.end())
                all.push_back(titleOf(row));
        return all;
    }

    static std::string picture(const bench::Comparison& found) {
        Plot plot;
        plot.title = "Processor time while boxes drop, beside the paper's Table 4";
        plot.xTitle = "boxes a second";
        plot.yTitle = "share of a core's time (%)";
        plot.xLogarithmic = true;
        const char* const greys[] = {"#303030", "#707070", "#a0a0a0"};
        for (std::size_t m = 0; m < paperTable4().size(); ++m) {
            Series series{paperTable4()[m].name, greys[m], true, true, true, {}};
            for (std::size_t i = 0; i < paperBoxRates().size(); ++i)
                series.points.emplace_back(paperBoxRates()[i], paperTable4()[m].percent[i]);
            plot.series.push_back(std::move(series));
        }
        for (const std::string& title : titles(found)) {
            Series series{title, "", false, false, true, {}};
            for (const Row& row : found.rows) {
                if (titleOf(row) != title) continue;
                series.colour = bench::colourOf(row.setting.engine);
                series.hollow = bench::engineOf(row.setting.engine).ours;
                series.points.emplace_back(row.scene.size, percent(row));
            }
            plot.series.push_back(std::move(series));
        }
        bench::fitAxes(plot);
        return draw(plot);
    }

    bench::CompareOptions options_{.rounds = 3, .limit = 200};
    int most_ = 12'800;
    bool quick_ = false;
};

}  // namespace

std::unique_ptr<Experiment> makeTable4() {
    return std::make_unique<Table4>();
}

}  // namespace sulfur::lab
