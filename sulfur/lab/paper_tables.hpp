// The figures of the paper, as printed there:
//
// Maggiorini, Ripamonti, Sauro: "Unifying Rigid and Soft Bodies Representation: The Sulfur Physics
// Engine", 2014, section 3.1, tables 2 and 3: the largest elastic constant (N/m) before a rope of
// 40 particles explodes. The paper leaves out values below 50. Table 4: the share of processor time
// that physics takes while boxes drop, by the number of boxes a second.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sulfur::lab {

/// One column of a table: a refresh rate and a damping constant.
struct PaperColumn {
    double rate;     ///< Hz
    double damping;  ///< N s/m
};

struct PaperTable {
    std::string name;  ///< "table2"
    std::string title;
    std::string variable;  ///< what the columns differ in, with its unit
    std::vector<PaperColumn> columns;
    bool byRate;  ///< columns differ in the rate, otherwise in the damping
    struct Row {
        std::string name;
        std::vector<std::optional<double>> limits;  ///< N/m, one per column
    };
    std::vector<Row> rows;

    std::optional<double> limit(std::string_view row, std::size_t column) const;
};

const PaperTable& paperTable2();
const PaperTable& paperTable3();

/// Table 4: a machine, and what it needed.
struct PaperMachine {
    std::string name;
    std::vector<double> percent;  ///< of processor time, one for each of paperBoxRates()
};
/// Boxes a second, the columns of Table 4.
const std::vector<int>& paperBoxRates();
const std::vector<PaperMachine>& paperTable4();

}  // namespace sulfur::lab
