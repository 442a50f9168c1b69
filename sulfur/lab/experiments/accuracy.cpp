// accuracy: work-precision diagrams.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "accuracy/piles.hpp"
#include "accuracy/show.hpp"
#include "experiments/experiment.hpp"
#include "experiments/number.hpp"

namespace sulfur::lab {

namespace {

class Accuracy final : public Experiment {
public:
    std::string name() const override { return "accuracy"; }
    std::string description() const override {
        return "work-precision diagrams: error against run time, scene by scene";
    }

    void declare(CLI::App& app) override {
        std::vector<std::string> keys = sceneKeys();
        keys.insert(keys.end(), pileKeys().begin(), pileKeys().end());
        app.add_option("--scene", scenes_, "Only these scenes")->check(CLI::IsMember(keys));
        app.add_option("--load", loads_,
                       "Loads of rope, net, cloth and grid, in masses of a link, node or square")
            ->delimiter(',')
            ->check(between(1.0, 1e6))
            ->capture_default_str();
        app.add_flag("--quick", quick_,
                     "Fewer rates, shorter measurements, nets and grids of 10 x 10");
    }

    Report run() override {
        CostOptions cost;
        if (quick_) cost = {.least = 2e-4, .repeats = 3, .most = 0.1};
        const auto subjects = accuracySubjects(quick_);
        std::vector<WorkPrecision> results;
        for (const std::string& key : sceneKeys()) {
            if (!wanted(key)) continue;
            const bool loaded = isLoaded(key);
            for (const double load : loaded ? loads_ : std::vector{1.0}) {
                AccuracyScene scene = makeScene(key, {.load = load, .quick = quick_});
                if (loaded) scene.key = fmt::format("{}-{:g}", key, load);
                results.push_back(measureWorkPrecision(std::move(scene), subjects, cost));
            }
        }
        for (const std::string& key : pileKeys())
            if (wanted(key)) results.push_back(measurePile(key, quick_));
        Report report{asText(results, cost), asCsv(results), asJson(results)};
        for (const WorkPrecision& work : results) {
            const std::string name = "accuracy_" + work.scene.key;
            report.pictures.push_back({name + ".svg", asSvg(work)});
            if (work.scene.isTied())
                report.pictures.push_back({name + "_strain.svg", asSvg(work, &WorkPoint::strain)});
        }
        return report;
    }

private:
    bool wanted(const std::string& key) const {
        return scenes_.empty() || std::find(scenes_.begin(), scenes_.end(), key) != scenes_.end();
    }

    std::vector<std::string> scenes_;
    std::vector<double> loads_{1, 100, 1000};
    bool quick_ = false;
};

}  // namespace

std::unique_ptr<Experiment> makeAccuracy() {
    return std::make_unique<Accuracy>();
}

}  // namespace sulfur::lab
