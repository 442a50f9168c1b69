// How the maps of stability are shown.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stability/stability_map.hpp"
#include "svg_heat_map.hpp"

namespace sulfur::lab {

namespace {

std::string figure(const HangingLimit& limit) {
    if (limit.limit) return fmt::format("{:.3g}", *limit.limit);
    return limit.any ? "none" : "never";
}

/// A method that is never stable grows so slowly at small constants that rounding hides it.
bool isNever(const std::optional<double>& law) {
    return law && *law < 1;
}

std::string figure(const std::optional<double>& law) {
    return !law ? "none" : isNever(law) ? "never" : fmt::format("{:.3g}", *law);
}

const StabilityCell& cellAt(const StabilityMap& map, std::size_t damping, std::size_t rate) {
    return map.cells[damping * map.rates.size() + rate];
}

/// Some of `count` indices, the first and the last among them.
std::vector<std::size_t> some(std::size_t count, std::size_t wanted) {
    std::vector<std::size_t> indices;
    wanted = std::min(count, wanted);
    for (std::size_t i = 0; i < wanted; ++i) indices.push_back(i * (count - 1) / (wanted - 1));
    return indices;
}

}  // namespace

std::string asText(const std::vector<StabilityMap>& maps, const StabilityMapOptions& options) {
    std::string out = fmt::format(
        "Largest stable stiffness (N/m) of a rope of {} particles of {} kg and springs of {} m, "
        "{} damper, air friction {} N s/m,\nover the rate and the damping. Measured: the rope "
        "hangs at rest and no small disturbance grows, from the eigenvalues of one\ntick of the "
        "integrator itself, searched to 2 %. Law: no wave of a long chain grows (without weight "
        "and sideways motion).\nnever: not even 1 N/m; none: no limit up to {:g} N/m. Here "
        "are some of the cells, measured / law; --csv gives all.\n",
        options.rope.particles, options.rope.mass, options.rope.length,
        options.rope.damper == Damper::full ? "the paper's full" : "axial",
        options.rope.airFriction, options.highest);
    for (const StabilityMap& map : maps) {
        out += fmt::format("\n{}{}\n{:>14}", map.title, map.law.empty() ? "" : ", " + map.law,
                           "N s/m \\ Hz");
        const auto columns = some(map.rates.size(), 5), rows = some(map.dampings.size(), 6);
        for (const auto column : columns) out += fmt::format("{:>22.0f}", map.rates[column]);
        for (const auto row : rows) {
            out += fmt::format("\n{:>14.3g}", map.dampings[row]);
            for (const auto column : columns) {
                const StabilityCell& cell = cellAt(map, row, column);
                out += fmt::format("{:>22}", figure(cell.measured) + " / " + figure(cell.law));
            }
        }
        out += '\n';
    }
    return out;
}

std::string asCsv(const std::vector<StabilityMap>& maps) {
    std::string out = "integrator,rate_hz,damping_ns_per_m,measured_n_per_m,law_n_per_m\n";
    for (const StabilityMap& map : maps)
        for (const StabilityCell& cell : map.cells)
            out += fmt::format("{},{},{},{},{}\n", map.key, cell.rate, cell.damping,
                               figure(cell.measured), figure(cell.law));
    return out;
}

std::string asJson(const std::vector<StabilityMap>& maps) {
    std::string out = "{\n  \"cells\": [";
    const char* separator = "\n";
    // A word where there is no number.
    const auto value = [](const std::string& text) {
        return text == "none" || text == "never" ? '"' + text + '"' : text;
    };
    for (const StabilityMap& map : maps) {
        for (const StabilityCell& cell : map.cells) {
            out += fmt::format(
                "{}    {{\"integrator\": \"{}\", \"rate\": {}, \"damping\": {}, "
                "\"measured\": {}, \"law\": {}}}",
                separator, map.key, cell.rate, cell.damping, value(figure(cell.measured)),
                value(figure(cell.law)));
            separator = ",\n";
        }
    }
    return out + "\n  ]\n}\n";
}

std::string asSvg(const StabilityMap& map) {
    HeatMaps maps;
    maps.title = "Largest stable stiffness: " + map.title;
    maps.xTitle = "rate (Hz)";
    maps.yTitle = "damping (N s/m)";
    maps.valueTitle = "N/m";
    maps.unlimitedWord = "no limit";
    maps.noneWord = "never stable";
    for (const double rate : map.rates) maps.xLabels.push_back(fmt::format("{:.0f}", rate));
    for (const double damping : map.dampings)
        maps.yLabels.push_back(fmt::format("{:.2g}", damping));
    HeatMaps::Panel measured{"hanging rope, measured", {}};
    HeatMaps::Panel law{map.law.empty() ? "linear law" : "linear law, " + map.law, {}};
    for (const StabilityCell& cell : map.cells) {
        measured.cells.push_back({cell.measured.limit, cell.measured.any});
        law.cells.push_back({isNever(cell.law) ? std::nullopt : cell.law, !cell.law});
    }
    maps.panels = {std::move(measured), std::move(law)};
    return draw(maps);
}

}  // namespace sulfur::lab
