// A small plot of lines and marks as an SVG picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sulfur::lab {

/// Without points it is a remark in the legend.
struct Series {
    std::string title;
    std::string colour;  ///< as in CSS
    bool dashed = false;
    bool hollow = false;  ///< marks as rings
    bool line = true;
    std::vector<std::pair<double, double>> points;
};

struct Plot {
    std::string title;
    std::string xTitle, yTitle;
    bool xLogarithmic = false;  ///< y always is
    std::vector<double> xTicks;
    double yLow = 10, yHigh = 1e6;  ///< powers of ten
    std::vector<Series> series;
};

std::string draw(const Plot& plot);

}  // namespace sulfur::lab
