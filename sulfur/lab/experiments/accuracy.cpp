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
        app.add_option("--load", loads_, "Loads of the rope, in masses of a link")
            ->delimiter(',')
            ->check(between(1.0, 1e6))
            ->capture_default_str();
        app.add_flag("--quick", quick_, "Fewer rates and shorter measurements");
    }

    Report run() override {
        CostOptions cost;
        if (quick_) cost = {.least = 2e-4, .repeats = 3, .most = 0.1};
        const auto subjects = accuracySubjects(quick_);
        std::vector<WorkPrecision> results;
        for (const std::string& key : sceneKeys()) {
            if (!wanted(key)) continue;
            const bool rope = key == "rope";
            for (const double load : rope ? loads_ : std::vector{1.0}) {
                AccuracyScene scene = makeScene(key, {.load = load});
                if (rope) scene.key = fmt::format("rope-{:g}", load);
                results.push_back(measureWorkPrecision(std::move(scene), subjects, cost));
            }
        }
        for (const std::string& key : pileKeys())
            if (wanted(key)) results.push_back(measurePile(key, quick_));
        Report report{asText(results, cost), asCsv(results), asJson(results)};
        for (const WorkPrecision& work : results)
            report.pictures.push_back({"accuracy_" + work.scene.key + ".svg", asSvg(work)});
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
