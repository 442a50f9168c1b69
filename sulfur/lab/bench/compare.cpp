#include "bench/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "bench/clock.hpp"

namespace sulfur::lab::bench {

namespace {

struct Job {
    std::size_t row;
    const Engine* engine;
    std::vector<double> all = {}, last = {};
};

void addRun(Row& row, Job& job, RunResult&& run) {
    if (job.all.empty()) {
        row.figures = std::move(run.figures);
        row.simulated = run.simulated;
    }
    job.all.push_back(1e3 * run.seconds / run.simulated);
    // A run that was stopped has no last second.
    if (run.lastSecond > 0) job.last.push_back(1e3 * run.lastSecond);
}

/// Scenes with threads need all cores; the others the one that was asked for.
std::unique_ptr<Pinned> pinFor(const Scene& scene, int core) {
    return scene.onWall ? nullptr : std::make_unique<Pinned>(core);
}

}  // namespace

double Row::figure(const std::string& name) const {
    for (const Figure& figure : figures)
        if (figure.name == name) return figure.value;
    return std::numeric_limits<double>::quiet_NaN();
}

RunResult runOnce(const Scene& scene, const Engine& engine, const Setting& setting, double limit,
                  bool profiling) {
    const auto now = scene.onWall ? wallTime : threadTime;
    const auto world = engine.make(setting);
    const auto play = scene.play();
    play->begin(*world);
    if (profiling) world->setProfiling(true);
    const long ticks = std::lround(scene.seconds * setting.rate);
    // Without looks the clock is read ten times a simulated second, for the limit.
    const int looks = scene.looksPerSecond == 0 ? 10 : scene.looksPerSecond;
    const long stride = std::max(1L, static_cast<long>(setting.rate) / looks);
    RunResult result;
    long tick = 0;
    double worst = 0;
    while (tick < ticks && result.seconds < limit) {
        const bool late = tick >= ticks - setting.rate;
        long end = std::min(tick + stride, ticks);
        if (!late) end = std::min(end, std::max(tick + 1, ticks - setting.rate));
        const double begin = now();
        for (; tick < end; ++tick) {
            play->before(*world, static_cast<double>(tick) / setting.rate);
            world->step();
        }
        const double taken = now() - begin;
        result.seconds += taken;
        worst = std::max(worst, taken);
        if (late) result.lastSecond += taken;
        play->look(*world, static_cast<double>(tick) / setting.rate);
    }
    result.simulated = tick == ticks ? scene.seconds : static_cast<double>(tick) / setting.rate;
    if (tick < ticks) result.lastSecond = 0;
    result.figures = play->figures(*world);
    if (scene.timesTicks && tick > 0) {
        result.figures.push_back(
            {"a tick", "ms", 1e3 * result.seconds / static_cast<double>(tick)});
        result.figures.push_back({"worst tick", "ms", 1e3 * worst});
        result.figures.push_back({"in all", "s", result.seconds});
    }
    if (profiling) result.stages = world->stages();
    return result;
}

Comparison compare(const std::vector<Scene>& scenes, const std::vector<std::string>& wanted,
                   const CompareOptions& options) {
    Comparison comparison{.rows = {}, .options = options, .core = Pinned(options.core).core()};
    std::vector<Job> jobs;
    for (const Scene& scene : scenes) {
        for (const Engine& engine : engines()) {
            const bool named = wanted.empty() ||
                               std::find(wanted.begin(), wanted.end(), engine.key) != wanted.end();
            if (!named || !engine.found()) continue;
            for (const Setting& setting : settingsFor(engine, scene)) {
                jobs.push_back({comparison.rows.size(), &engine});
                comparison.rows.push_back({.scene = scene,
                                           .setting = setting,
                                           .msPerSecond = {},
                                           .lastSecond = {},
                                           .figures = {}});
            }
        }
    }
    for (int round = 0; round < options.rounds; ++round) {
        for (Job& job : jobs) {
            Row& row = comparison.rows[job.row];
            if (round > 0 && row.cut()) continue;
            if (options.tell)
                options.tell(fmt::format("round {} of {}: {} {}, {} {}", round + 1, options.rounds,
                                         row.scene.key, row.scene.variant, job.engine->title,
                                         row.setting.label()));
            const auto pin = pinFor(row.scene, options.core);
            addRun(row, job, runOnce(row.scene, *job.engine, row.setting, options.limit));
        }
    }
    for (Job& job : jobs) {
        Row& row = comparison.rows[job.row];
        row.msPerSecond = spreadOf(job.all);
        row.lastSecond = spreadOf(job.last);
        const auto pin = pinFor(row.scene, options.core);
        if (row.scene.aside)
            for (Figure& figure : row.scene.aside(*job.engine, row.setting))
                row.figures.push_back(std::move(figure));
        const auto tells = [](const Engine& e) { return e.key == "sulfur" || e.key == "box2d3"; };
        if (options.stages && tells(*job.engine))
            row.stages = runOnce(row.scene, *job.engine, row.setting, options.limit, true).stages;
    }
    return comparison;
}

}  // namespace sulfur::lab::bench
