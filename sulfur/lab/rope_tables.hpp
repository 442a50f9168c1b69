// The experiments table2 and table3: the paper's rope under every integrator.
#pragma once

#include <string>
#include <vector>

#include "integrators/linear_theory.hpp"
#include "limit_search.hpp"
#include "paper_tables.hpp"

namespace sulfur::lab {

/// One integrator in one column.
struct Cell {
    std::vector<LimitFound> found;  ///< by RopeTableResult::dampers
    std::optional<double> theory;   ///< N/m; nothing: linear theory knows no limit
    std::optional<double> paper;    ///< N/m; nothing: not printed there
};

struct RopeTableResult {
    const PaperTable* table = nullptr;
    RopeConstants rope;  ///< its damper and damping are those of the dampers and columns
    std::vector<Damper> dampers;
    SearchOptions search;
    std::vector<std::vector<Cell>> rows;  ///< by integrators(), then by column
};

/// Measures every integrator in every column with every damper, on all cores. The result does not
/// depend on how many there are.
RopeTableResult measure(const PaperTable& table, const RopeConstants& rope,
                        const std::vector<Damper>& dampers, const SearchOptions& search);

/// "paper" or "axial", as on the command line.
const char* keyOf(Damper damper);

std::string asText(const RopeTableResult& result);
std::string asCsv(const RopeTableResult& result);
std::string asJson(const RopeTableResult& result);
/// A picture of the first damper's limits, on logarithmic axes where the columns allow it.
std::string asSvg(const RopeTableResult& result);

}  // namespace sulfur::lab
