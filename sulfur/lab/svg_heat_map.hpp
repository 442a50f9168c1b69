// Heat maps side by side as an SVG picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sulfur::lab {

/// What a cell shows: a value > 0, or one of two words that are no value.
struct HeatCell {
    std::optional<double> value;
    bool unlimited = false;  ///< without a value: beyond every value; otherwise there is none
};

struct HeatMaps {
    std::string title, xTitle, yTitle, valueTitle;
    std::string unlimitedWord, noneWord;        ///< for the legend
    std::vector<std::string> xLabels, yLabels;  ///< one a column, one a row from the bottom
    struct Panel {
        std::string title;
        std::vector<HeatCell> cells;  ///< row by row, from the bottom
    };
    std::vector<Panel> panels;
};

/// Colours are by the logarithm of the value, over the range of all panels.
std::string draw(const HeatMaps& maps);

}  // namespace sulfur::lab
