#include "paper_tables.hpp"

namespace sulfur::lab {

namespace {

constexpr std::optional<double> none;

}  // namespace

std::optional<double> PaperTable::limit(std::string_view row, std::size_t column) const {
    for (const Row& candidate : rows)
        if (candidate.name == row) return candidate.limits[column];
    return std::nullopt;
}

const PaperTable& paperTable2() {
    static const PaperTable table{
        "table2",
        "Largest elastic constant (N/m) over the damping constant, at 500 Hz",
        "damping (N s/m)",
        {{500, 0}, {500, 0.1}, {500, 0.2}, {500, 0.3}, {500, 0.4}},
        false,
        {{"Euler", {none, 50, 100, 150, 200}},
         {"SUVAT/RK2", {none, 100, 200, 300, 400}},
         {"RK4", {none, 150, 300, 450, 600}},
         {"NSV/IE", {50, 8500, 9000, 9500, 11000}}}};
    return table;
}

const PaperTable& paperTable3() {
    static const PaperTable table{
        "table3",
        "Largest elastic constant (N/m) over the refresh rate, with a damping of 0.2 N s/m",
        "refresh rate (Hz)",
        {{60, 0.2}, {100, 0.2}, {250, 0.2}, {500, 0.2}, {1000, 0.2}},
        true,
        {{"Euler", {none, none, 50, 100, 1000}},
         {"SUVAT/RK2", {none, none, 100, 200, 400}},
         {"RK4", {none, 60, 150, 300, 600}},
         {"NSV/IE", {150, 450, 2700, 8000, 47500}}}};
    return table;
}

const std::vector<int>& paperBoxRates() {
    static const std::vector<int> rates{20, 40, 60, 80, 100, 150, 200};
    return rates;
}

const std::vector<PaperMachine>& paperTable4() {
    static const std::vector<PaperMachine> machines{
        {"Athlon64 3200, Windows XP", {12, 30, 45, 65, 83, 100, 100}},
        {"Core2Duo T7700, Windows 7", {10, 22, 42, 55, 72, 95, 100}},
        {"Core-i7 930, Ubuntu", {5, 10, 20, 25, 35, 50, 75}}};
    return machines;
}

}  // namespace sulfur::lab
