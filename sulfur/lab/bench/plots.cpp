#include "bench/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/show.hpp"

namespace sulfur::lab::bench {

namespace {

/// Powers of ten round a range.
struct Decades {
    double low = 0, high = -1;  // exponents

    void add(double value) {
        const double below = std::floor(std::log10(value)), above = std::ceil(std::log10(value));
        if (high < low) {
            low = below;
            high = above;
        }
        low = std::min(low, below);
        high = std::max(high, above);
    }
    void close() {
        if (high < low) low = high = 0;
        if (high == low) high = low + 1;
    }
};

std::string fileOf(const Scene& scene) {
    std::string file = "bench_" + scene.key + "_" + scene.variant + ".svg";
    for (char& c : file)
        if (c == ' ' || c == '/' || c == ':') c = '-';
    return file;
}

std::string errorPicture(const std::vector<const Row*>& rows) {
    const Scene& scene = rows.front()->scene;
    Plot plot;
    plot.title = scene.key + ": " + scene.title;
    plot.xTitle = "processor time (ms for a simulated second)";
    for (const Figure& figure : rows.front()->figures)
        if (figure.name == scene.error)
            plot.yTitle =
                figure.unit.empty() ? figure.name : figure.name + " (" + figure.unit + ")";
    plot.xLogarithmic = true;
    for (const Row* row : rows) {
        const Engine& engine = engineOf(row->setting.engine);
        plot.series.push_back(
            {.title = engine.title + ", " + row->setting.label(),
             .colour = colourOf(engine.key),
             .hollow = engine.ours,
             .line = false,
             .points = {{row->msPerSecond.median, std::abs(row->figure(scene.error))}}});
    }
    fitAxes(plot);
    return draw(plot);
}

std::string sizePicture(const std::vector<const Row*>& rows) {
    Plot plot;
    plot.title = "S1: boxes of 1 m dropped for 10 s";
    plot.xTitle = "boxes a second";
    plot.yTitle = "processor time (ms for a simulated second)";
    plot.xLogarithmic = true;
    std::map<std::string, std::size_t> place;
    for (const Row* row : rows) {
        const Engine& engine = engineOf(row->setting.engine);
        const std::string title = engine.title + ", " + row->setting.label();
        const auto [at, fresh] = place.try_emplace(title, plot.series.size());
        if (fresh)
            plot.series.push_back({.title = title,
                                   .colour = colourOf(engine.key),
                                   .dashed = row->setting.rate == 240,
                                   .hollow = engine.ours,
                                   .points = {}});
        if (!row->cut())
            plot.series[at->second].points.emplace_back(row->scene.size, row->msPerSecond.median);
    }
    plot.series.push_back(
        {.title = "1000: real time", .colour = "none", .line = false, .points = {}});
    fitAxes(plot);
    return draw(plot);
}

}  // namespace

void fitAxes(Plot& plot) {
    Decades x, y;
    for (Series& series : plot.series) {
        std::erase_if(series.points, [](const auto& p) {
            return !(p.first > 0 && p.second > 0 && std::isfinite(p.first) &&
                     std::isfinite(p.second));
        });
        for (const auto& [px, py] : series.points) {
            x.add(px);
            y.add(py);
        }
    }
    x.close();
    y.close();
    plot.xTicks.clear();
    for (double e = x.low; e <= x.high; ++e) plot.xTicks.push_back(std::pow(10, e));
    plot.yLow = std::pow(10, y.low);
    plot.yHigh = std::pow(10, y.high);
}

std::string colourOf(const std::string& engine) {
    static const std::map<std::string, std::string> colours{
        {"sulfur", "#117a65"},   {"box2d3", "#c0392b"}, {"box2d2", "#d68910"},
        {"chipmunk", "#2471a3"}, {"bullet", "#707070"}, {"liquidfun", "#6c3483"}};
    const auto found = colours.find(engine);
    return found == colours.end() ? "black" : found->second;
}

std::vector<std::pair<std::string, std::string>> asSvg(const Comparison& comparison) {
    std::map<std::string, std::vector<const Row*>> tables;
    std::vector<const Row*> drops;
    for (const Row& row : comparison.rows) {
        tables[fileOf(row.scene)].push_back(&row);
        if (row.scene.key == "S1") drops.push_back(&row);
    }
    std::vector<std::pair<std::string, std::string>> pictures;
    for (const auto& [file, rows] : tables) pictures.emplace_back(file, errorPicture(rows));
    if (!drops.empty()) pictures.emplace_back("bench_S1_sizes.svg", sizePicture(drops));
    return pictures;
}

}  // namespace sulfur::lab::bench
