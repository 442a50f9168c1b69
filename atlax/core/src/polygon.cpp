#include "polygon.hpp"

#include <numeric>

namespace atlax::detail {

namespace {

bool finite(Vec2 p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

bool insideTriangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
    return cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0;
}

bool convex(std::span<const Vec2> points) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = points[i];
        const Vec2 b = points[(i + 1) % n];
        if (cross(b - a, points[(i + 2) % n] - b) < 0) return false;
    }
    return true;
}

/// Whether the corner `at` of what is left can be cut off: it turns left and no other point is in
/// it.
bool isEar(std::span<const Vec2> points, const std::vector<std::uint32_t>& left, std::size_t at) {
    const std::size_t n = left.size();
    const Vec2 a = points[left[(at + n - 1) % n]];
    const Vec2 b = points[left[at]];
    const Vec2 c = points[left[(at + 1) % n]];
    if (cross(b - a, c - b) <= 0) return false;
    for (std::size_t i = 0; i + 3 < n; ++i) {
        const Vec2 p = points[left[(at + 2 + i) % n]];
        if (p == a || p == b || p == c) continue;
        if (insideTriangle(p, a, b, c)) return false;
    }
    return true;
}

}  // namespace

float doubleArea(std::span<const Vec2> points) {
    float sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
    return sum;
}

void removeRepeats(std::vector<Vec2>& points) {
    std::size_t kept = 0;
    for (const Vec2 p : points)
        if (finite(p) && (kept == 0 || !(p == points[kept - 1]))) points[kept++] = p;
    while (kept > 1 && points[kept - 1] == points[0]) --kept;
    points.resize(kept);
}

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> points) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    if (points.size() < 3) return triangles;
    std::vector<std::uint32_t> left(points.size());
    std::iota(left.begin(), left.end(), 0u);
    if (convex(points)) {
        for (std::size_t i = 1; i + 1 < left.size(); ++i)
            triangles.push_back({left[0], left[i], left[i + 1]});
        return triangles;
    }
    std::size_t at = 0;
    std::size_t refused = 0;
    while (left.size() > 3) {
        const std::size_t n = left.size();
        at %= n;
        // A polygon that crosses itself may have no ear; then any corner goes, to come to an end.
        if (refused < n && !isEar(points, left, at)) {
            ++refused;
            ++at;
            continue;
        }
        triangles.push_back({left[(at + n - 1) % n], left[at], left[(at + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
        refused = 0;
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

}  // namespace atlax::detail
