#include "broadphase/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "svg_plot.hpp"

namespace sulfur::lab {

namespace {

const char* const colours[] = {"#c0392b", "#117a65", "#d68910", "#2471a3", "#6c3483", "#707070"};

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string caseKey(const CapsuleCase& c) {
    return fmt::format("length {:g} thickness {:g}", c.length, c.thickness);
}

/// The powers of ten round all values, at least one apart.
void fitHeight(Plot& plot) {
    double low = 1e300, high = 1e-300;
    for (const Series& series : plot.series) {
        for (const auto& point : series.points) {
            low = std::min(low, point.second);
            high = std::max(high, point.second);
        }
    }
    if (low > high) low = high = 1;
    plot.yLow = std::pow(10, std::floor(std::log10(low)));
    plot.yHigh = std::max(std::pow(10, std::ceil(std::log10(high))), 10 * plot.yLow);
}

std::string methodsAsText(const BroadPhaseResults& results) {
    std::string out = fmt::format(
        "Random capsules of one size, each touching about 4 others; lengths and thicknesses in "
        "cells.\nMissed: pairs that touch, by the distance of each, and that were not found. "
        "Times are for\nentering a capsule, sorting and finding pairs: medians of {}.\n\n",
        results.repeats);
    out += fmt::format("{:>6}{:>7}{:>9}   {:<19}{:>8}{:>14}{:>9}{:>13}\n", "length", "thick",
                       "touching", "way", "missed", "pairs/capsule", "cells", "ns/capsule");
    for (const CaseResult& c : results.cases) {
        for (const MethodResult& m : c.methods) {
            const bool first = &m == &c.methods.front();
            const auto& kind = c.capsules;
            out += first ? fmt::format("{:>6g}{:>7g}{:>9}", kind.length, kind.thickness, c.touching)
                         : std::string(22, ' ');
            out += fmt::format("   {:<19}{:>6.1f} %{:>14.1f}{:>9.1f}{:>13.0f}\n", m.title,
                               percent(m.missed, c.touching),
                               static_cast<double>(m.pairs) / kind.count, m.cells, 1e9 * m.seconds);
        }
    }
    return out;
}

std::string worldsAsText(const BroadPhaseResults& results) {
    std::string out =
        "\nWhole worlds. Boxes: drawn anew in a tick. Kept: a tick in which nothing has left its "
        "box; rebuild: one in which something has.\nMedians of the broad phase's share of the "
        "ticks, in microseconds.\n\n";
    out += fmt::format("{:<32}{:>7}{:>9}{:>11}{:>11}{:>10}{:>8}\n", "world", "bodies", "boxes",
                       "candidates", "rebuilds", "rebuild", "kept");
    const auto time = [](double seconds) {
        return seconds > 0 ? fmt::format("{:.1f}", 1e6 * seconds) : std::string("-");
    };
    for (const WorldResult& w : results.worlds)
        out += fmt::format("{:<32}{:>7}{:>9.2f}{:>11}{:>11}{:>10}{:>8}\n", w.title, w.bodies,
                           w.boxes, w.candidates, fmt::format("{}/{}", w.rebuilds, w.ticks),
                           time(w.rebuild), time(w.kept));
    return out;
}

}  // namespace

std::string asText(const BroadPhaseResults& results) {
    return methodsAsText(results) + worldsAsText(results);
}

std::string asCsv(const BroadPhaseResults& results) {
    std::string out = "case,way,items,cells,pairs,touching,missed,rebuild_s,kept_s\n";
    for (const CaseResult& c : results.cases)
        for (const MethodResult& m : c.methods)
            out += fmt::format("{},{},{},{},{},{},{},{},\n", caseKey(c.capsules), m.key,
                               c.capsules.count, m.cells * c.capsules.count, m.pairs, c.touching,
                               m.missed, m.seconds * c.capsules.count);
    for (const WorldResult& w : results.worlds)
        out += fmt::format("{},world,{},{},{},,,{},{}\n", w.key, w.bodies, w.boxes, w.candidates,
                           w.rebuild, w.kept);
    return out;
}

std::string asJson(const BroadPhaseResults& results) {
    std::string out = "{\n  \"ways\": [";
    const char* separator = "\n";
    for (const CaseResult& c : results.cases) {
        for (const MethodResult& m : c.methods) {
            out += fmt::format(
                "{}    {{\"length\": {}, \"thickness\": {}, \"capsules\": {}, \"way\": \"{}\", "
                "\"cells\": {}, \"pairs\": {}, \"touching\": {}, \"missed\": {}, "
                "\"secondsPerCapsule\": {}}}",
                separator, c.capsules.length, c.capsules.thickness, c.capsules.count, m.key,
                m.cells, m.pairs, c.touching, m.missed, m.seconds);
            separator = ",\n";
        }
    }
    out += "\n  ],\n  \"worlds\": [";
    separator = "\n";
    for (const WorldResult& w : results.worlds) {
        out += fmt::format(
            "{}    {{\"world\": \"{}\", \"bodies\": {}, \"boxes\": {}, \"candidates\": {}, "
            "\"ticks\": {}, \"rebuilds\": {}, \"rebuildSeconds\": {}, \"keptSeconds\": {}}}",
            separator, w.key, w.bodies, w.boxes, w.candidates, w.ticks, w.rebuilds, w.rebuild,
            w.kept);
        separator = ",\n";
    }
    return out + "\n  ]\n}\n";
}

std::string missesAsSvg(const BroadPhaseResults& results) {
    Plot plot;
    plot.title = "Touching pairs that Bresenham's literal line misses";
    plot.xTitle = "thickness (cells)";
    plot.yTitle = "missed (%)";
    plot.xLogarithmic = true;
    std::set<double> lengths, thicknesses;
    for (const CaseResult& c : results.cases) {
        lengths.insert(c.capsules.length);
        thicknesses.insert(c.capsules.thickness);
    }
    plot.xTicks.assign(thicknesses.begin(), thicknesses.end());
    std::size_t widenedMissed = 0;
    for (const double length : lengths) {
        Series series{fmt::format("length {:g} cells", length),
                      colours[plot.series.size() % std::size(colours)],
                      false,
                      false,
                      true,
                      {}};
        for (const CaseResult& c : results.cases) {
            if (c.capsules.length != length) continue;
            for (const MethodResult& m : c.methods) {
                if (m.key == "covering") widenedMissed += m.missed;
                if (m.key == "bresenham" && m.missed > 0)
                    series.points.emplace_back(c.capsules.thickness, percent(m.missed, c.touching));
            }
        }
        plot.series.push_back(std::move(series));
    }
    plot.series.push_back(
        {fmt::format("widened: {} missed", widenedMissed), "none", false, false, false, {}});
    fitHeight(plot);
    return draw(plot);
}

std::string timesAsSvg(const BroadPhaseResults& results) {
    Plot plot;
    const double thickness = results.cases.front().capsules.thickness;
    plot.title = fmt::format("Time to find the pairs, thickness {:g} cells", thickness);
    plot.xTitle = "length (cells)";
    plot.yTitle = "ns per capsule";
    for (const CaseResult& c : results.cases) {
        if (c.capsules.thickness != thickness) continue;
        plot.xTicks.push_back(c.capsules.length);
        for (std::size_t i = 0; i < c.methods.size(); ++i) {
            if (plot.series.size() <= i)
                plot.series.push_back({c.methods[i].title, colours[i], false, false, true, {}});
            plot.series[i].points.emplace_back(c.capsules.length, 1e9 * c.methods[i].seconds);
        }
    }
    fitHeight(plot);
    return draw(plot);
}

}  // namespace sulfur::lab
