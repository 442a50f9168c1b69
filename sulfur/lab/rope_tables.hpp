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
    LimitFound found;
    std::optional<double> theory;  ///< N/m; nothing: linear theory knows no limit
    std::optional<double> paper;   ///< N/m; nothing: not printed there
};

struct RopeTableResult {
    const PaperTable* table = nullptr;
    RopeConstants rope;
    SearchOptions search;
    std::vector<std::vector<Cell>> rows;  ///< by integrators(), then by column
};

/// Measures every integrator in every column, on all cores. The result does not depend on how
/// many there are.
RopeTableResult measure(const PaperTable& table, const RopeConstants& rope,
                        const SearchOptions& search);

std::string asText(const RopeTableResult& result);
std::string asCsv(const RopeTableResult& result);
std::string asJson(const RopeTableResult& result);
/// A picture, on logarithmic axes where the columns allow it.
std::string asSvg(const RopeTableResult& result);

}  // namespace sulfur::lab
