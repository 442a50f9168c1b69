#include "collision/cell_size.hpp"

#include <algorithm>
#include <cmath>

namespace sulfur::detail {

namespace {

/// Powers of two, so that places are divided by the cell size without rounding. The smallest is
/// 8 mm: rays count the cells of 10,000 km with 32 bits.
constexpr int smallestCell = -7, largestCell = 12;

/// What a pair costs, in cells; measured (sulfur_lab broadphase).
constexpr double pairCost = 1;

}  // namespace

void SizeCensus::add(double length, double radius) {
    const double thickness = 2 * radius, size = length + thickness;
    int power = 0;
    std::frexp(size, &power);
    const int place = std::clamp(power, smallest, largest) - smallest;
    Bucket& bucket = buckets_[static_cast<std::size_t>(place)];
    bucket.count += 1;
    bucket.area += 1.2 * size * thickness;
    bucket.length += 1.5 * size + 1.2 * thickness;
}

double SizeCensus::cost(double size) const {
    double sum = 0;
    for (int power = smallest; power <= largest; ++power) {
        const Bucket& b = buckets_[static_cast<std::size_t>(power - smallest)];
        if (b.count == 0) continue;
        const double cells = b.area / (size * size) + b.length / size + 1.5 * b.count;
        // frexp's powers: sizes from half of it, so three quarters of it stand for all.
        const double fitting = size / (0.75 * std::ldexp(1.0, power));
        sum += std::min(cells, mostCellsMoving * b.count) +
               pairCost * b.count * std::min(fitting * fitting, b.count);
    }
    return sum;
}

double SizeCensus::choose(double present) const {
    double best = 1, least = cost(best);
    if (least == 0) return best;
    for (int power = smallestCell; power <= largestCell; ++power) {
        const double size = std::ldexp(1.0, power), price = cost(size);
        if (price >= least) continue;
        best = size;
        least = price;
    }
    return cost(present) <= 1.25 * least ? present : best;
}

}  // namespace sulfur::detail
