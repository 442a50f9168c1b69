#include "outline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sulfur::detail {

namespace {

/// Positive when c is to the left of the line from a to b.
double side(const Point& a, const Point& b, const Point& c) {
    return cross(Point(b - a), Point(c - a));
}

/// Whether c, on the line through a and b, is between them.
bool between(const Point& a, const Point& b, const Point& c) {
    return (c - a).dot(c - b) <= 0;
}

bool touch(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double ac = side(a, b, c), ad = side(a, b, d), ca = side(c, d, a), cb = side(c, d, b);
    if (((ac > 0 && ad < 0) || (ac < 0 && ad > 0)) && ((ca > 0 && cb < 0) || (ca < 0 && cb > 0)))
        return true;
    return (ac == 0 && between(a, b, c)) || (ad == 0 && between(a, b, d)) ||
           (ca == 0 && between(c, d, a)) || (cb == 0 && between(c, d, b));
}

bool inClosedTriangle(const std::array<Point, 3>& t, const Point& p) {
    return side(t[0], t[1], p) >= 0 && side(t[1], t[2], p) >= 0 && side(t[2], t[0], p) >= 0;
}

/// How far a counter-clockwise triangle is from being flat: twice its area over its longest side
/// squared; 0.87 when it is equilateral.
double bluntness(const std::array<Point, 3>& t) {
    const double longest = std::max(
        {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
    return side(t[0], t[1], t[2]) / longest;
}

}  // namespace

double twiceArea(const std::vector<Point>& corners) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += side(corners[0], corners[i], corners[i + 1]);
    return sum;
}

std::optional<std::array<std::size_t, 2>> tangle(const std::vector<Point>& corners) {
    const std::size_t count = corners.size();
    const auto corner = [&](std::size_t i) -> const Point& { return corners[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        const Point edge = corner(i + 1) - corner(i), next = corner(i + 2) - corner(i + 1);
        const bool folds = cross(edge, next) == 0 && edge.dot(next) <= 0;
        if (folds) return std::array{i, i};
        for (std::size_t k = i + 2; k < count; ++k) {
            if (i == 0 && k == count - 1) continue;
            if (touch(corner(i), corner(i + 1), corner(k), corner(k + 1))) return std::array{i, k};
        }
    }
    return std::nullopt;
}

std::optional<std::vector<Point>> inset(const std::vector<Point>& corners, double distance) {
    const std::size_t count = corners.size();
    const double sense = twiceArea(corners) > 0 ? 1 : -1;
    const auto inwards = [&](std::size_t i) {
        const Point edge = (corners[(i + 1) % count] - corners[i]).normalized();
        return Point(sense * Point(-edge[1], edge[0]));
    };
    std::vector<Point> moved;
    for (std::size_t i = 0; i < count; ++i) {
        const Point before = inwards((i + count - 1) % count), after = inwards(i);
        const double open = 1 + before.dot(after);
        if (open < 1e-6) return std::nullopt;
        moved.emplace_back(corners[i] + distance / open * (before + after));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Point edge = corners[(i + 1) % count] - corners[i];
        if (edge.dot(moved[(i + 1) % count] - moved[i]) <= 0) return std::nullopt;
    }
    if (tangle(moved) || twiceArea(moved) * sense <= 0) return std::nullopt;
    return moved;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Point>& corners) {
    std::vector<std::uint32_t> rest(corners.size());
    std::iota(rest.begin(), rest.end(), 0u);
    if (twiceArea(corners) < 0) std::reverse(rest.begin(), rest.end());
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (rest.size() > 3) {
        const std::size_t count = rest.size();
        std::size_t ear = 0;
        double best = -1;
        for (std::size_t i = 0; i < count; ++i) {
            const std::array ends{rest[(i + count - 1) % count], rest[i], rest[(i + 1) % count]};
            const std::array t{corners[ends[0]], corners[ends[1]], corners[ends[2]]};
            const double blunt = bluntness(t);
            if (blunt <= 0 || blunt <= best) continue;
            const bool empty = std::none_of(rest.begin(), rest.end(), [&](std::uint32_t k) {
                return k != ends[0] && k != ends[1] && k != ends[2] &&
                       inClosedTriangle(t, corners[k]);
            });
            if (!empty) continue;
            best = blunt;
            ear = i;
        }
        triangles.push_back({rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({rest[0], rest[1], rest[2]});
    return triangles;
}

}  // namespace sulfur::detail
