// stability: the battery.
#include <CLI/CLI.hpp>

#include "battery/battery.hpp"
#include "battery/show.hpp"
#include "experiments/experiment.hpp"

namespace sulfur::lab {

namespace {

class Stability final : public Experiment {
public:
    std::string name() const override { return "stability"; }
    std::string description() const override {
        return "the battery: what the library's dynamics must hold, row by row";
    }

    void declare(CLI::App& app) override {
        app.add_flag("--battery", battery_, "Run the battery; fails when a row does");
        std::vector<std::string> keys;
        for (const BatteryGroup& group : batteryGroups()) keys.push_back(group.key);
        app.add_option("--group", groups_, "Only these groups of the battery")
            ->check(CLI::IsMember(keys));
        app.add_option("--sweeps", setup_.sweeps, "Passes over the constraints in a tick")
            ->check(CLI::Range(1, 100))
            ->capture_default_str();
        app.add_option("--rate", setup_.tickRate, "Hz, where a scene says no other")
            ->check(CLI::Range(60, 10000))
            ->capture_default_str();
    }

    Report run() override {
        std::vector<GroupResult> results;
        for (const BatteryGroup& group : batteryGroups()) {
            const bool wanted = groups_.empty() || std::find(groups_.begin(), groups_.end(),
                                                             group.key) != groups_.end();
            if (wanted) results.push_back({group.key, group.title, group.run(setup_)});
        }
        return {.text = asText(results, setup_),
                .csv = asCsv(results),
                .json = asJson(results, setup_),
                .passed = allPassed(results)};
    }

private:
    bool battery_ = false;
    std::vector<std::string> groups_;
    Setup setup_;
};

}  // namespace

std::unique_ptr<Experiment> makeStability() {
    return std::make_unique<Stability>();
}

}  // namespace sulfur::lab
