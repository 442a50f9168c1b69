#include "bench/spread.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sulfur::lab::bench {

Spread spreadOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    const double median = n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
    return {median, values.front(), values.back(), n};
}

double percentile(std::vector<double> values, double p) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const double rank = std::ceil(p * static_cast<double>(values.size()));
    const auto place = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
    return values[std::min(place, values.size() - 1)];
}

double mean(const std::vector<double>& values) {
    if (values.empty()) return 0;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

PowerLaw fitPowerLaw(const std::vector<std::pair<double, double>>& points) {
    const auto n = static_cast<double>(points.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& [px, py] : points) {
        const double x = std::log(px), y = std::log(py);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    return {std::exp((sy - exponent * sx) / n), exponent};
}

}  // namespace sulfur::lab::bench
