#include <map>

#include "rope_tables.hpp"
#include "svg_plot.hpp"

namespace sulfur::lab {

namespace {

/// One colour per row of the paper; readings of the same method are told apart by dashes.
const char* colourOf(const IntegratorEntry& entry) {
    static const std::map<std::string, const char*> colours{
        {"euler", "#c0392b"}, {"suvat", "#d68910"},    {"rk2", "#7d8c1f"}, {"rk2-held", "#7d8c1f"},
        {"rk4", "#2471a3"},   {"rk4-held", "#2471a3"}, {"nsv", "#6c3483"}, {"verlet", "#a569bd"}};
    return colours.at(entry.key);
}

}  // namespace

std::string asSvg(const RopeTableResult& r) {
    Plot plot;
    plot.title = r.table->title;
    plot.xTitle = r.table->variable;
    plot.yTitle = "largest elastic constant (N/m)";
    plot.xLogarithmic = r.table->byRate;
    const auto xOf = [&](std::size_t column) {
        const auto& c = r.table->columns[column];
        return r.table->byRate ? c.rate : c.damping;
    };
    for (std::size_t i = 0; i < r.table->columns.size(); ++i) plot.xTicks.push_back(xOf(i));
    for (std::size_t row = 0; row < r.rows.size(); ++row) {
        const auto& entry = integrators()[row];
        if (!entry.bounded) {
            plot.series.push_back({entry.title + ": beyond", "none", false, false, false, {}});
            continue;
        }
        Series series{entry.title, colourOf(entry), false, false, true, {}};
        series.dashed = entry.key.find("held") != std::string::npos || entry.key == "verlet";
        for (std::size_t i = 0; i < r.rows[row].size(); ++i) {
            const auto& found = r.rows[row][i].found.front();
            if (found.stable >= plot.yLow && found.stable <= plot.yHigh)
                series.points.emplace_back(xOf(i), found.stable);
        }
        plot.series.push_back(std::move(series));
    }
    const std::map<std::string, const char*> colours{
        {"Euler", "#c0392b"}, {"SUVAT/RK2", "#d68910"}, {"RK4", "#2471a3"}, {"NSV/IE", "#6c3483"}};
    for (const auto& row : r.table->rows) {
        Series series{"paper: " + row.name, colours.at(row.name), false, true, false, {}};
        for (std::size_t i = 0; i < row.limits.size(); ++i)
            if (row.limits[i]) series.points.emplace_back(xOf(i), *row.limits[i]);
        plot.series.push_back(std::move(series));
    }
    return draw(plot);
}

}  // namespace sulfur::lab
