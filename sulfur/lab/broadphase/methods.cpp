#include "broadphase/methods.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <core/segments.hpp>
#include <numbers>
#include <random>
#include <sulfur/math.hpp>

#include "broadphase/grid.hpp"
#include "broadphase/rasterise.hpp"

namespace sulfur::lab {

namespace {

using detail::Cell;
using detail::Grid;

struct Capsule {
    Point from, to;
    double radius;
};

using Pairs = std::vector<std::uint64_t>;  // of numbers of capsules, sorted

/// In a square of which two random capsules of this kind share 1 / (count / 4): their Minkowski
/// sum has, on average over all directions, the area 2/pi L^2 + 4 L T + pi T^2.
std::vector<Capsule> scatter(const CapsuleCase& kind) {
    const double l = kind.length, t = kind.thickness;
    const double sum = 2 / std::numbers::pi * l * l + 4 * l * t + std::numbers::pi * t * t;
    const double side = std::sqrt(kind.count * sum / 4);
    std::mt19937_64 bits(7);
    const auto random = [&](double high) {
        return high * static_cast<double>(bits() >> 11) / 9007199254740992.0;
    };
    std::vector<Capsule> capsules;
    for (int i = 0; i < kind.count; ++i) {
        const Point from(random(side), random(side));
        const double angle = random(2 * std::numbers::pi);
        capsules.push_back({from, from + l * Point(std::cos(angle), std::sin(angle)), t / 2});
    }
    return capsules;
}

bool touch(const Capsule& a, const Capsule& b) {
    if (detail::segmentsCross(a.from, a.to, b.from, b.to)) return true;
    const double reach = a.radius + b.radius;
    const auto near = [&](const Point& p, const Capsule& c) {
        const Point nearest =
            c.from + detail::nearestAlong<Point>(p, c.from, c.to) * (c.to - c.from);
        return (p - nearest).squaredNorm() <= reach * reach;
    };
    return near(a.from, b) || near(a.to, b) || near(b.from, a) || near(b.to, a);
}

std::uint64_t pairOf(std::uint32_t i, std::uint32_t k) {
    return static_cast<std::uint64_t>(std::min(i, k)) << 32 | std::max(i, k);
}

Pairs allTouching(const std::vector<Capsule>& capsules) {
    Pairs pairs;
    for (std::uint32_t i = 0; i < capsules.size(); ++i)
        for (std::uint32_t k = i + 1; k < capsules.size(); ++k)
            if (touch(capsules[i], capsules[k])) pairs.push_back(pairOf(i, k));
    return pairs;
}

template <class Function>
void coverBox(const Capsule& c, Function&& emit) {
    const Point low = c.from.cwiseMin(c.to).array() - c.radius;
    const Point high = c.from.cwiseMax(c.to).array() + c.radius;
    const auto number = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
    for (auto x = number(low[0]); x <= number(high[0]); ++x)
        for (auto y = number(low[1]); y <= number(high[1]); ++y) emit(detail::cellAt(x, y));
}

/// What the broad phase does: enter all, sort, look into each cell, sort the pairs.
template <class Rasterise>
std::size_t findPairs(const std::vector<Capsule>& capsules, Grid& grid, Pairs& pairs,
                      Rasterise&& rasterise) {
    grid.clear();
    for (std::uint32_t i = 0; i < capsules.size(); ++i)
        rasterise(capsules[i], [&](Cell cell) { grid.insert(cell, i); });
    grid.build();
    pairs.clear();
    grid.forEachPair([&](std::uint32_t i, std::uint32_t k) { pairs.push_back(pairOf(i, k)); });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return grid.entries().size();
}

template <class Function>
double medianSeconds(int repeats, Function&& function) {
    std::vector<double> times;
    for (int i = 0; i < repeats; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        function();
        times.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
    return times[static_cast<std::size_t>(repeats / 2)];
}

}  // namespace

CaseResult measureMethods(const CapsuleCase& kind, int repeats) {
    const auto capsules = scatter(kind);
    const auto count = static_cast<double>(capsules.size());
    CaseResult result{kind, 0, {}};
    Pairs touching;
    const double slow = medianSeconds(repeats, [&] { touching = allTouching(capsules); });
    result.touching = touching.size();
    const auto measure = [&](const char* key, const char* title, const auto& rasterise) {
        Grid grid;
        Pairs pairs;
        const auto cells = static_cast<double>(findPairs(capsules, grid, pairs, rasterise));
        const double seconds =
            medianSeconds(repeats, [&] { findPairs(capsules, grid, pairs, rasterise); });
        Pairs missed;
        std::set_difference(touching.begin(), touching.end(), pairs.begin(), pairs.end(),
                            std::back_inserter(missed));
        result.methods.push_back(
            {key, title, cells / count, pairs.size(), missed.size(), seconds / count});
    };
    measure("bresenham", "literal Bresenham",
            [](const Capsule& c, const auto& emit) { detail::rasteriseLine(c.from, c.to, emit); });
    measure("covering", "widened", [](const Capsule& c, const auto& emit) {
        detail::rasteriseCapsule(c.from, c.to, c.radius, emit);
    });
    measure("boxes", "bounding boxes",
            [](const Capsule& c, const auto& emit) { coverBox(c, emit); });
    const std::size_t all = capsules.size() * (capsules.size() - 1) / 2;
    result.methods.push_back({"all", "all pairs", 0, all, 0, slow / count});
    return result;
}

}  // namespace sulfur::lab
