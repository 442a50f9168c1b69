#include "battery/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

/// JSON knows neither NaN nor infinity.
std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace

bool allPassed(const std::vector<GroupResult>& groups) {
    return std::all_of(groups.begin(), groups.end(), [](const GroupResult& group) {
        return std::all_of(group.rows.begin(), group.rows.end(),
                           [](const Row& row) { return row.passed; });
    });
}

std::string asText(const std::vector<GroupResult>& groups, const Setup& setup) {
    std::string out = fmt::format(
        "The battery: {} build, {} Hz unless a row says another rate, {} sweeps.\n"
        "A row passes when what was measured is at most the bound.\n",
        doubleBuild ? "double" : "float", setup.tickRate, setup.sweeps);
    std::size_t passed = 0, all = 0;
    for (const GroupResult& group : groups) {
        out += fmt::format("\n{} ({})\n         measured      bound\n", group.title, group.key);
        for (const Row& row : group.rows) {
            out += fmt::format(
                "{}  {:>9.3g}  {:>9}  {}\n", row.passed ? "pass " : "FAIL ", row.measured,
                std::isinf(row.bound) ? "-" : fmt::format("{:.3g}", row.bound), row.name);
            passed += row.passed ? 1 : 0;
            ++all;
        }
    }
    return out + fmt::format("\n{} of {} rows pass.\n", passed, all);
}

std::string asCsv(const std::vector<GroupResult>& groups) {
    std::string out = "group,row,measured,bound,passed\n";
    for (const GroupResult& group : groups)
        for (const Row& row : group.rows)
            out += fmt::format("{},\"{}\",{},{},{}\n", group.key, row.name, row.measured, row.bound,
                               row.passed);
    return out;
}

std::string asJson(const std::vector<GroupResult>& groups, const Setup& setup) {
    std::string out = fmt::format(
        "{{\n  \"build\": \"{}\",\n  \"tickRate\": {},\n  \"sweeps\": {},\n  \"rows\": [",
        doubleBuild ? "double" : "float", setup.tickRate, setup.sweeps);
    const char* separator = "\n";
    for (const GroupResult& group : groups) {
        for (const Row& row : group.rows) {
            out += fmt::format(
                "{}    {{\"group\": \"{}\", \"name\": \"{}\", \"measured\": {}, \"bound\": {}, "
                "\"passed\": {}}}",
                separator, group.key, row.name, number(row.measured), number(row.bound),
                row.passed);
            separator = ",\n";
        }
    }
    return out + "\n  ]\n}\n";
}

}  // namespace sulfur::lab
