#include "lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "geometry.hpp"
#include "region.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct Triangle {
    std::array<std::uint32_t, 3> corners;
};

double fromLine(const Point& a, const Point& b, const Point& point) {
    const Point way = b - a;
    const double square = way.squaredNorm();
    const double along = square > 0 ? std::clamp((point - a).dot(way) / square, 0.0, 1.0) : 0;
    return (a + along * way - point).norm();
}

void keepFarthest(const Outline& line, std::size_t first, std::size_t last, double error,
                  std::vector<bool>& kept) {
    double most = error;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double off = fromLine(line[first], line[last], line[i]);
        if (off <= most) continue;
        most = off;
        at = i;
    }
    if (at == first) return;
    kept[at] = true;
    keepFarthest(line, first, at, error, kept);
    keepFarthest(line, at, last, error, kept);
}

bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto side = [](const Point& p, const Point& q, const Point& r) {
        return sulfur::cross(q - p, r - p);
    };
    return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

// Points at equal distances along a closed outline.
Outline resampled(const Outline& outline, double spacing) {
    double length = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    const int count = std::max(6, static_cast<int>(std::lround(length / spacing)));
    const double step = length / count;
    Outline points;
    double along = 0;
    double next = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point& a = outline[i];
        const Point way = outline[(i + 1) % outline.size()] - a;
        const double size = way.norm();
        while (next < along + size - 1e-9 && static_cast<int>(points.size()) < count) {
            points.emplace_back(a + way * ((next - along) / size));
            next += step;
        }
        along += size;
    }
    return points;
}

// In a triangular grid, no nearer to the outline than half a spacing.
void addInside(const Outline& outline, double spacing, Outline& points) {
    Point low = outline[0];
    Point high = outline[0];
    for (const Point& point : outline) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const double rise = spacing * std::sqrt(0.75);
    int row = 0;
    for (double y = low.y() + rise / 2; y < high.y(); y += rise, ++row)
        for (double x = low.x() + (row % 2 == 0 ? 0.25 : 0.75) * spacing; x < high.x();
             x += spacing) {
            const Point point(x, y);
            if (!inside(outline, point)) continue;
            bool free = true;
            for (std::size_t i = 0; i < outline.size() && free; ++i)
                free =
                    fromLine(outline[i], outline[(i + 1) % outline.size()], point) > 0.55 * spacing;
            if (free) points.push_back(point);
        }
}

bool inCircle(const Outline& p, const Triangle& t, const Point& at) {
    const Point a = p[t.corners[0]] - at;
    const Point b = p[t.corners[1]] - at;
    const Point c = p[t.corners[2]] - at;
    const double sign = sulfur::cross(b - a, c - a);
    const double in = a.squaredNorm() * sulfur::cross(b, c) -
                      b.squaredNorm() * sulfur::cross(a, c) + c.squaredNorm() * sulfur::cross(a, b);
    return sign > 0 ? in > 0 : in < 0;
}

// Edges of Delaunay's triangulation (Bowyer and Watson 1981). Quadratic in the points.
std::set<Edge> delaunay(Outline points) {
    const auto count = static_cast<std::uint32_t>(points.size());
    Point low = points[0];
    Point high = points[0];
    for (const Point& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const Point middle = (low + high) / 2;
    const double far = 20 * (high - low).maxCoeff() + 1;
    points.emplace_back(middle + Point(-far, -far));
    points.emplace_back(middle + Point(far, -far));
    points.emplace_back(middle + Point(0, far));
    std::vector<Triangle> triangles{{{count, count + 1, count + 2}}};
    for (std::uint32_t i = 0; i < count; ++i) {
        std::map<Edge, int> rim;
        std::erase_if(triangles, [&](const Triangle& t) {
            if (!inCircle(points, t, points[i])) return false;
            for (std::size_t k = 0; k < 3; ++k)
                ++rim[std::minmax(t.corners[k], t.corners[(k + 1) % 3])];
            return true;
        });
        for (const auto& [edge, times] : rim)
            if (times == 1) triangles.push_back({{edge.first, edge.second, i}});
    }
    std::set<Edge> edges;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge = std::minmax(t.corners[k], t.corners[(k + 1) % 3]);
            if (edge.second < count) edges.insert(edge);
        }
    return edges;
}

}  // namespace

Outline simplified(const Outline& outline, double error, bool closed) {
    if (outline.size() < 3) return outline;
    Outline line = outline;
    if (closed) line.push_back(outline.front());
    std::vector<bool> kept(line.size(), false);
    kept.front() = kept.back() = true;
    if (closed) {
        // Both ends are one point: the line is cut at the one that is farthest from it.
        std::size_t far = 0;
        for (std::size_t i = 0; i < line.size(); ++i)
            if ((line[i] - line[0]).norm() > (line[far] - line[0]).norm()) far = i;
        kept[far] = true;
        keepFarthest(line, 0, far, error, kept);
        keepFarthest(line, far, line.size() - 1, error, kept);
    } else {
        keepFarthest(line, 0, line.size() - 1, error, kept);
    }
    Outline result;
    const std::size_t count = line.size() - (closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
        if (kept[i]) result.push_back(line[i]);
    return result;
}

bool meetsItself(const Outline& outline) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue;
            if (cross(outline[i], outline[(i + 1) % n], outline[j], outline[(j + 1) % n]))
                return true;
        }
    return false;
}

double areaWithin(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        twice += sulfur::cross(outline[i], outline[(i + 1) % outline.size()]);
    return std::abs(twice) / 2;
}

sulfur::Blueprint lattice(const Outline& outline, double spacing, double mass, double stiffness,
                          double damping, const std::vector<Outline>& holes) {
    using sulfur::Real;
    if (outline.size() < 3 || areaWithin(outline) < spacing * spacing)
        throw std::runtime_error("this outline encloses too little; draw a larger one");
    if (meetsItself(outline))
        throw std::runtime_error("this outline crosses itself; draw it round once");
    // The way to a hole is a slit, across which springs hold it together.
    const Region region{outline, holes};
    Outline points = resampled(keyholed(region, spacing / 6), spacing);
    const auto rim = static_cast<std::uint32_t>(points.size());
    const Outline around = points;
    addInside(around, spacing, points);
    const auto within = [&](const Point& point) {
        if (holes.empty()) return inside(around, point);
        return inside(outline, point) &&
               std::none_of(holes.begin(), holes.end(),
                            [&](const Outline& hole) { return inside(hole, point); });
    };
    const auto radius = static_cast<Real>(std::min(0.03, spacing / 6));
    sulfur::Blueprint blueprint;
    for (const Point& point : points) {
        sulfur::ParticleSpec particle;
        particle.position = point.cast<Real>();
        particle.mass = static_cast<Real>(mass / static_cast<double>(points.size()));
        blueprint.particles.push_back(particle);
    }
    const auto join = [&](std::uint32_t a, std::uint32_t b, Real thickness) {
        sulfur::JointSpec joint;
        joint.a = a;
        joint.b = b;
        joint.stiffness = static_cast<Real>(stiffness);
        joint.damping = static_cast<Real>(damping);
        joint.radius = thickness;
        blueprint.joints.push_back(joint);
    };
    for (std::uint32_t i = 0; i < rim; ++i) join(i, (i + 1) % rim, radius);
    for (const auto& [a, b] : delaunay(points)) {
        const bool side = b < rim && (b == a + 1 || (a == 0 && b == rim - 1));
        if (!side && within((points[a] + points[b]) / 2)) join(a, b, 0);
    }
    blueprint.validate();
    return blueprint;
}

}  // namespace sulfurchamber
