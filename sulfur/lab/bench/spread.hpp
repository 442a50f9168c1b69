// What several measurements of one thing have in common.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sulfur::lab::bench {

/// In a metre; figures of overlaps are given in them.
inline constexpr double millimetres = 1e3;

struct Spread {
    double median = 0, least = 0, most = 0;
    std::size_t count = 0;
};

/// All 0 without values. The median of an even count is the mean of the two in the middle.
Spread spreadOf(std::vector<double> values);

/// The smallest value that at least the share `p` (0 to 1) of all do not exceed; 0 without values.
double percentile(std::vector<double> values, double p);

double mean(const std::vector<double>& values);

/// y = factor x^exponent through points with positive coordinates, by least squares of logarithms.
struct PowerLaw {
    double factor = 0, exponent = 0;
};
/// Needs two points with different x; otherwise not a number.
PowerLaw fitPowerLaw(const std::vector<std::pair<double, double>>& points);

}  // namespace sulfur::lab::bench
