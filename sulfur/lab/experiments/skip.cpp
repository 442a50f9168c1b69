// skip: what each feature costs that is switched on alone, and so what is saved without it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bench/clock.hpp"
#include "bench/show.hpp"
#include "bench/ticks.hpp"
#include "experiments/experiment.hpp"
#include "experiments/number.hpp"

namespace sulfur::lab {

namespace {

struct Cost {
    bench::Option option;
    bench::Spread off, on;  ///< s a tick

    double percent() const { return 100 * (on.median / off.median - 1); }
};

class Skip final : public Experiment {
public:
    std::string name() const override { return "skip"; }
    std::string description() const override {
        return "what each feature costs in a tick, switched on alone";
    }

    void declare(CLI::App& app) override {
        app.add_option("--bodies", bodies_, "In each scene")
            ->check(between(10, 20'000))
            ->capture_default_str();
        app.add_option("--rounds", rounds_, "Measurements of each, in turns")
            ->check(between(1, 1000))
            ->capture_default_str();
    }

    Report run() override {
        const bench::Pinned pin;
        std::vector<Cost> costs;
        for (bench::Option& option : bench::options(bodies_))
            costs.push_back(measure(std::move(option)));
        return {asText(costs), asCsv(costs), asJson(costs)};
    }

private:
    /// Both worlds in turns, so that a busy moment of the machine meets both.
    Cost measure(bench::Option option) const {
        const auto off = option.make(false), on = option.make(true);
        bench::TickOptions once{.warmUp = 50, .ticks = 20, .repeats = 1};
        std::vector<double> without, with;
        for (int r = 0; r < rounds_; ++r) {
            without.push_back(bench::tickTime(*off, once).median);
            with.push_back(bench::tickTime(*on, once).median);
            once.warmUp = 0;
        }
        return {std::move(option), bench::spreadOf(without), bench::spreadOf(with)};
    }

    std::string asText(const std::vector<Cost>& costs) const {
        std::string out = fmt::format(
            "A tick without and with each feature, alone, microseconds of processor time: the "
            "median of {}\nmeasurements in turns (least - most). {} bodies; ropes: a tenth.\n\n"
            "{:<32}{:>26}{:>26}{:>10}  scene\n",
            rounds_, bodies_, "feature", "without", "with", "costs");
        const auto cell = [](const bench::Spread& s) {
            return fmt::format("{:.1f} ({:.1f} - {:.1f})", 1e6 * s.median, 1e6 * s.least,
                               1e6 * s.most);
        };
        for (const Cost& c : costs)
            out += fmt::format("{:<32}{:>26}{:>26}{:>+8.1f} %  {}\n", c.option.name, cell(c.off),
                               cell(c.on), c.percent(), c.option.scene);
        return out;
    }

    static std::string asCsv(const std::vector<Cost>& costs) {
        std::string out = "feature,scene,without_s,with_s,percent\n";
        for (const Cost& c : costs)
            out += fmt::format("{},{},{},{},{}\n", bench::csvField(c.option.name),
                               bench::csvField(c.option.scene), c.off.median, c.on.median,
                               c.percent());
        return out;
    }

    static std::string asJson(const std::vector<Cost>& costs) {
        std::string out = "{\n  \"features\": [";
        const char* separator = "\n";
        for (const Cost& c : costs) {
            out += fmt::format(
                "{}    {{\"feature\": {}, \"scene\": {}, \"without\": {}, \"with\": {}}}",
                separator, bench::jsonText(c.option.name), bench::jsonText(c.option.scene),
                bench::jsonNumber(c.off.median), bench::jsonNumber(c.on.median));
            separator = ",\n";
        }
        return out + "\n  ]\n}\n";
    }

    int bodies_ = 300, rounds_ = 9;
};

}  // namespace

std::unique_ptr<Experiment> makeSkip() {
    return std::make_unique<Skip>();
}

}  // namespace sulfur::lab
