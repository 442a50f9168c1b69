// table2 and table3.
#include <CLI/CLI.hpp>

#include "experiments/experiment.hpp"
#include "experiments/number.hpp"
#include "rope_tables.hpp"

namespace sulfur::lab {

namespace {

class RopeTable final : public Experiment {
public:
    RopeTable(const PaperTable& table, std::string description)
        : table_(table), description_(std::move(description)) {}

    std::string name() const override { return table_.name; }
    std::string description() const override { return description_; }

    void declare(CLI::App& app) override {
        app.add_option("--damper", damper_,
                       "paper: on the whole relative velocity; axial: along the spring; or both")
            ->check(CLI::IsMember({"paper", "axial", "both"}))
            ->capture_default_str();
        app.add_flag("--only-explosions", onlyExplosions_,
                     "A rope that never comes to rest but stays bounded counts as stable");
        app.add_option("--seconds", search_.seconds, "Simulated time of a trial")
            ->check(between(2.0, 1000.0))
            ->capture_default_str();
        app.add_option("--resolution", search_.resolution, "Relative width of the last bracket")
            ->check(between(1e-4, 1.0))
            ->capture_default_str();
        app.add_option("--highest", search_.highest, "Where the search ends, N/m")
            ->check(between(100.0, 1e12))
            ->capture_default_str();
    }

    Report run() override {
        search_.mustRest = !onlyExplosions_;
        std::vector<Damper> dampers;
        for (const Damper damper : {Damper::full, Damper::axial})
            if (damper_ == "both" || damper_ == keyOf(damper)) dampers.push_back(damper);
        const auto result = measure(table_, {}, dampers, search_);
        return {
            asText(result), asCsv(result), asJson(result), {{table_.name + ".svg", asSvg(result)}}};
    }

private:
    const PaperTable& table_;
    std::string description_;
    std::string damper_ = "both";
    SearchOptions search_;
    bool onlyExplosions_ = false;
};

}  // namespace

std::unique_ptr<Experiment> makeTable2() {
    return std::make_unique<RopeTable>(
        paperTable2(), "the paper's Table 2: largest elastic constant over damping");
}

std::unique_ptr<Experiment> makeTable3() {
    return std::make_unique<RopeTable>(
        paperTable3(), "the paper's Table 3: largest elastic constant over the refresh rate");
}

}  // namespace sulfur::lab
