#include "bench/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace sulfur::lab::bench {

namespace {

using std::numbers::pi;

/// Area, and the integral of the squared distance from the origin.
std::pair<double, double> polygonMoments(const std::vector<Point>& points) {
    double area = 0, second = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point &p = points[i], &q = points[(i + 1) % points.size()];
        const double twice = cross(p, q);
        area += twice / 2;
        second += twice / 12 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    }
    return {area, second};
}

double distanceToSegment(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0;
    return (p - a - share * along).norm();
}

/// The distance of two cores that are apart.
double distanceOf(const std::vector<Point>& a, const std::vector<Point>& b) {
    double least = std::numeric_limits<double>::max();
    const auto look = [&](const std::vector<Point>& corners, const std::vector<Point>& sides) {
        for (const Point& p : corners)
            for (std::size_t i = 0; i < sides.size(); ++i)
                least =
                    std::min(least, distanceToSegment(p, sides[i], sides[(i + 1) % sides.size()]));
    };
    look(a, b);
    look(b, a);
    return least;
}

/// The largest gap between two cores along a normal of a side of `a`; below 0 when none parts them.
/// A capsule has two normals, a disc has none.
double gapAlongNormals(const std::vector<Point>& a, const std::vector<Point>& b) {
    double most = -std::numeric_limits<double>::max();
    for (std::size_t i = 0; a.size() > 1 && i < a.size(); ++i) {
        const Point side = a[(i + 1) % a.size()] - a[i];
        const Point normal = Point(side.y(), -side.x()).normalized();
        double nearest = std::numeric_limits<double>::max();
        for (const Point& p : b) nearest = std::min(nearest, (p - a[i]).dot(normal));
        most = std::max(most, nearest);
    }
    return most;
}

struct Bounds {
    Point low, high;
};

Bounds boundsOf(const Outline& outline) {
    Bounds bounds{outline.points.front(), outline.points.front()};
    for (const Point& p : outline.points) {
        bounds.low = bounds.low.cwiseMin(p);
        bounds.high = bounds.high.cwiseMax(p);
    }
    bounds.low -= Point(outline.radius, outline.radius);
    bounds.high += Point(outline.radius, outline.radius);
    return bounds;
}

bool mayTouch(const Piece& a, const Piece& b) {
    if (a.body == b.body || (!a.moves && !b.moves)) return false;
    return a.group == 0 || a.group != b.group;
}

}  // namespace

double Outline::area() const {
    const double round = pi * radius * radius;
    if (points.size() == 1) return round;
    double around = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        around += (points[(i + 1) % points.size()] - points[i]).norm();
    return polygonMoments(points).first + around * radius + round;
}

double Outline::gyration2() const {
    const double r2 = radius * radius;
    if (points.size() == 1) return points[0].squaredNorm() + r2 / 2;
    if (points.size() == 2) {
        // A rectangle and two half discs, whose centres of mass lie 4 r / (3 pi) beyond the ends.
        const double length = (points[1] - points[0]).norm();
        const double middle2 = ((points[0] + points[1]) / 2).squaredNorm();
        const double straight = 2 * radius * length, round = pi * r2;
        const double second =
            straight * (length * length / 12 + r2 / 3) +
            round * (r2 / 2 + length * length / 4 + length * 4 * radius / (3 * pi));
        return middle2 + second / (straight + round);
    }
    const auto [area, second] = polygonMoments(points);
    return second / area;
}

Outline disc(double radius) {
    return {{Point(0, 0)}, radius};
}

Outline capsule(const Point& a, const Point& b, double radius) {
    return {{a, b}, radius};
}

Outline rectangle(const Point& half, double radius) {
    return {{-half, Point(half.x(), -half.y()), half, Point(-half.x(), half.y())}, radius};
}

double BodyPlan::mass() const {
    double sum = 0;
    for (const Outline& part : parts) sum += density * part.area();
    return sum;
}

double BodyPlan::inertia() const {
    double sum = 0;
    for (const Outline& part : parts) sum += density * part.area() * part.gyration2();
    return sum;
}

bool Motion::finite() const {
    return place.allFinite() && velocity.allFinite() && std::isfinite(angle) && std::isfinite(spin);
}

Point Motion::at(const Point& local) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return place + Point(c * local.x() - s * local.y(), s * local.x() + c * local.y());
}

Outline placed(const Outline& outline, const Motion& motion) {
    Outline there{{}, outline.radius};
    for (const Point& p : outline.points) there.points.push_back(motion.at(p));
    return there;
}

double overlapOf(const Outline& a, const Outline& b) {
    const double thickness = a.radius + b.radius;
    const double gap =
        std::max(gapAlongNormals(a.points, b.points), gapAlongNormals(b.points, a.points));
    if (gap > thickness) return thickness - gap;
    // Two discs have no sides; of two lines end to end, rounding may see a crossing.
    const bool sides = a.points.size() > 1 || b.points.size() > 1;
    if (!sides || gap > -1e-9) return thickness - distanceOf(a.points, b.points);
    return thickness - gap;
}

std::vector<double> overlaps(const std::vector<Piece>& pieces) {
    std::vector<std::pair<Bounds, const Piece*>> sorted;
    for (const Piece& piece : pieces) sorted.emplace_back(boundsOf(piece.outline), &piece);
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.first.low.x() < b.first.low.x(); });
    std::vector<double> depths;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const auto& [box, piece] = sorted[i];
        for (std::size_t j = i + 1; j < sorted.size(); ++j) {
            const auto& [other, partner] = sorted[j];
            if (other.low.x() > box.high.x()) break;
            if (other.low.y() > box.high.y() || other.high.y() < box.low.y()) continue;
            if (!mayTouch(*piece, *partner)) continue;
            const double depth = overlapOf(piece->outline, partner->outline);
            if (depth > 0) depths.push_back(depth);
        }
    }
    return depths;
}

}  // namespace sulfur::lab::bench
