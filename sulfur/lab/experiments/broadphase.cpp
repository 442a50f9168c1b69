// broadphase: what the grid misses and costs.
#include <CLI/CLI.hpp>

#include "broadphase/show.hpp"
#include "experiments/experiment.hpp"
#include "experiments/number.hpp"

namespace sulfur::lab {

namespace {

class BroadPhase final : public Experiment {
public:
    std::string name() const override { return "broadphase"; }
    std::string description() const override {
        return "pairs that the paper's Bresenham line misses, and the time of every way";
    }

    void declare(CLI::App& app) override {
        app.add_option("--capsules", capsules_, "In each case")
            ->check(between(10, 20'000))
            ->capture_default_str();
        app.add_option("--grains", grains_, "In each world")
            ->check(between(100, 20'000))
            ->capture_default_str();
        app.add_flag("--quick", quick_, "Fewer cases, shorter measurements");
    }

    Report run() override {
        BroadPhaseResults results{{}, {}, quick_ ? 3 : 9};
        const std::vector<double> thicknesses =
            quick_ ? std::vector{0.1, 0.5} : std::vector{0.02, 0.1, 0.3, 1.0};
        const std::vector<double> lengths =
            quick_ ? std::vector{0.5, 2.0} : std::vector{0.0, 0.5, 1.0, 2.0, 5.0, 20.0};
        for (const double thickness : thicknesses)
            for (const double length : lengths)
                results.cases.push_back(
                    measureMethods({length, thickness, capsules_}, results.repeats));
        for (const WorldCase& world : broadPhaseWorlds(grains_))
            results.worlds.push_back(measureWorld(world, quick_ ? 20 : 200));
        Report report{asText(results), asCsv(results), asJson(results)};
        report.pictures = {{"broadphase_misses.svg", missesAsSvg(results)},
                           {"broadphase_times.svg", timesAsSvg(results)}};
        for (const CaseResult& c : results.cases)
            for (const MethodResult& m : c.methods)
                if (m.key == "covering" && m.missed > 0) report.passed = false;
        return report;
    }

private:
    int capsules_ = 2000, grains_ = 2000;
    bool quick_ = false;
};

}  // namespace

std::unique_ptr<Experiment> makeBroadPhase() {
    return std::make_unique<BroadPhase>();
}

}  // namespace sulfur::lab
