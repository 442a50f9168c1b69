// stability: heat maps of the integrators, and the battery of the library.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "battery/battery.hpp"
#include "battery/contacts/shots.hpp"
#include "battery/random_worlds.hpp"
#include "battery/show.hpp"
#include "experiments/experiment.hpp"
#include "experiments/number.hpp"
#include "stability/stability_map.hpp"
#include "svg_scene.hpp"

namespace sulfur::lab {

namespace {

class Stability final : public Experiment {
public:
    std::string name() const override { return "stability"; }
    std::string description() const override {
        return "largest stable stiffness over rate and damping; --battery: the library's tests";
    }

    void declare(CLI::App& app) override {
        app.add_flag("--battery", battery_, "Run the battery; fails when a row does");
        const std::map<std::string, Damper> dampers{{"paper", Damper::full},
                                                    {"axial", Damper::axial}};
        app.add_option("--damper", map_.rope.damper,
                       "Of the heat maps; paper: on the whole relative velocity (default); axial: "
                       "along the spring")
            ->transform(CLI::CheckedTransformer(dampers));
        std::vector<std::string> names;
        for (const IntegratorEntry& entry : integrators()) names.push_back(entry.key);
        app.add_option("--integrator", integrators_, "Only heat maps of these")
            ->check(CLI::IsMember(names));
        app.add_flag("--quick", quick_, "Coarser heat maps; shorter runs in the battery");
        std::vector<std::string> keys;
        for (const BatteryGroup& group : batteryGroups()) keys.push_back(group.key);
        app.add_option("--group", groups_, "Only these groups of the battery")
            ->check(CLI::IsMember(keys));
        app.add_option("--sweeps", setup_.sweeps, "Passes over the constraints in a tick")
            ->check(between(1, 100))
            ->capture_default_str();
        app.add_option("--rate", setup_.tickRate, "Hz, where a scene says no other")
            ->check(between(60, 10000))
            ->capture_default_str();
        app.add_option("--shots", setup_.shots, "Random shots of each kind in the battery")
            ->check(between(1, 10'000'000))
            ->capture_default_str();
        app.add_option("--shot", shot_, "Only this shot of the battery, tick by tick")
            ->check(between(0, 20'000'000));
        app.add_option_function<std::uint64_t>(
               "--seed",
               [this](std::uint64_t seed) {
                   setup_.seeds = SeedRange{seed, seed};
               },
               "Only this random world")
            ->check(between(std::uint64_t{0}, maxSeed));
        app.add_option_function<std::string>(
               "--seeds", [this](const std::string& text) { setup_.seeds = seedRange(text); },
               "Random worlds: how many, or FROM-TO")
            ->check(&checkSeedRange);
        app.add_flag("--shrink", shrink_,
                     "Print the random worlds that break a law, made smaller, as C++");
    }

    Report run() override {
        setup_.quick = quick_;
        if (shrink_) return {.text = shrunkWorlds(setup_), .csv = {}, .json = {}};
        return shot_ ? replay() : battery_ ? runBattery() : drawMaps();
    }

private:
    Report drawMaps() {
        if (quick_) {
            map_.rates = 6;
            map_.dampings = 5;
        }
        std::vector<StabilityMap> maps;
        for (const IntegratorEntry& entry : integrators())
            if (wanted(integrators_, entry.key)) maps.push_back(measureStabilityMap(entry, map_));
        Report report{asText(maps, map_), asCsv(maps), asJson(maps)};
        for (const StabilityMap& map : maps)
            report.pictures.push_back({"stability_" + map.key + ".svg", asSvg(map)});
        return report;
    }

    Report runBattery() {
        std::vector<GroupResult> results;
        Album album;
        setup_.album = &album;
        for (const BatteryGroup& group : batteryGroups())
            if (wanted(groups_, group.key) && (!group.onlyByName || !groups_.empty()))
                results.push_back({group.key, group.title, group.run(setup_)});
        Report report{.text = asText(results, setup_),
                      .csv = asCsv(results),
                      .json = asJson(results, setup_),
                      .passed = allPassed(results)};
        for (auto& [file, svg] : album.pictures) report.pictures.push_back({file, std::move(svg)});
        return report;
    }

    Report replay() {
        Album album;
        setup_.album = &album;
        const ShotReplay replay = replayShot(*shot_, setup_);
        Report report{asText(replay), asCsv(replay), asJson(replay)};
        for (auto& [file, svg] : album.pictures) report.pictures.push_back({file, std::move(svg)});
        return report;
    }

    /// "50" is the first fifty, "51-60" ten of them.
    static SeedRange seedRange(const std::string& text) {
        const std::size_t dash = text.find('-');
        if (dash == std::string::npos) return {1, std::stoull(text)};
        return {std::stoull(text.substr(0, dash)), std::stoull(text.substr(dash + 1))};
    }
    static std::string checkSeedRange(const std::string& text) {
        const std::size_t dash = text.find('-');
        const auto isNumber = [](const std::string& part) {
            return !part.empty() && part.size() < 19 &&
                   part.find_first_not_of("0123456789") == std::string::npos;
        };
        const bool fine = dash == std::string::npos
                              ? isNumber(text)
                              : isNumber(text.substr(0, dash)) && isNumber(text.substr(dash + 1));
        if (!fine) return "'" + text + "' is neither a count nor FROM-TO";
        const SeedRange range = seedRange(text);
        return range.first <= range.last ? "" : "'" + text + "' holds no random world";
    }
    /// Whether `key` is among the named ones, or none is named.
    static bool wanted(const std::vector<std::string>& named, const std::string& key) {
        return named.empty() || std::find(named.begin(), named.end(), key) != named.end();
    }

    static constexpr std::uint64_t maxSeed = 999'999'999'999'999'999;  // of 18 digits

    bool battery_ = false, quick_ = false, shrink_ = false;
    std::optional<long> shot_;
    std::vector<std::string> groups_, integrators_;
    StabilityMapOptions map_;
    Setup setup_;
};

}  // namespace

std::unique_ptr<Experiment> makeStability() {
    return std::make_unique<Stability>();
}

}  // namespace sulfur::lab
