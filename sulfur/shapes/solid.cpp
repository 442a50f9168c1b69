#include "solid.hpp"

#include <cmath>

#include "core/trigonometry.hpp"
#include "outline.hpp"

namespace sulfur::detail {

namespace {
constexpr double leastCore = 0.02;  // of the mass
constexpr double lobesShare = 0.9;  // of what is outside
constexpr double straight = 1e-6;   // sine of the angle by which a corner at least turns

/// What is added to a solid, or taken from it where `sign` is -1, with masses that are areas.
struct Piece {
    Solid solid;
    double sign = 1;
};

Solid united(const std::vector<Piece>& pieces) {
    Solid whole;
    for (const auto& [solid, sign] : pieces) {
        whole.mass += sign * solid.mass;
        whole.centre += sign * solid.mass * solid.centre;
    }
    whole.centre /= whole.mass;
    for (const auto& [solid, sign] : pieces)
        whole.inertia +=
            sign * (solid.inertia + solid.mass * (solid.centre - whole.centre).squaredNorm());
    return whole;
}

Solid areaOf(const std::vector<Point>& corners) {
    double twiceArea = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twiceArea += cross(corners[i], corners[(i + 1) % corners.size()]);
    Solid solid = solidPolygon(corners, 1);
    solid.mass = std::abs(twiceArea) / 2;
    solid.inertia *= solid.mass;
    return solid;
}

/// A sector about `centre` between two directions of length 1, which are less than half a turn
/// apart.
Solid sector(const Point& centre, double radius, const Point& from, const Point& to) {
    const double half = std::abs(angleOf(Point(from.dot(to), cross(from, to)))) / 2;
    const double area = radius * radius * half;
    const double far = 2 * radius * std::sin(half) / (3 * half);
    return {area, centre + far * (from + to).normalized(),
            area * (radius * radius / 2 - far * far)};
}
}  // namespace

Solid solidRectangle(Vec2 size, Real mass) {
    const double m = static_cast<double>(mass);
    return {m, {0, 0}, m * size.cast<double>().squaredNorm() / 12};
}

Solid solidDisc(Real radius, Real mass) {
    const double m = static_cast<double>(mass), r = static_cast<double>(radius);
    return {m, {0, 0}, m * r * r / 2};
}

Solid solidPolygon(const std::vector<Point>& corners, Real mass) {
    // Sums over the triangles from the first corner; those outside count negative. A triangle 0ab
    // has the centre (a + b) / 3 and, about 0, the mean square distance (a a + a b + b b) / 6.
    const Point origin = corners[0];
    double twiceArea = 0, second = 0;
    Point first(0, 0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Point a = corners[i] - origin, b = corners[i + 1] - origin;
        const double area = cross(a, b);
        twiceArea += area;
        first += area / 3 * (a + b);
        second += area / 6 * (a.dot(a) + a.dot(b) + b.dot(b));
    }
    const Point centre = first / twiceArea;
    const double m = static_cast<double>(mass);
    return {m, origin + centre, m * (second / twiceArea - centre.squaredNorm())};
}

Solid solidRounded(const std::vector<Point>& corners, const std::vector<Point>& inner,
                   double radius, Real mass) {
    const std::size_t count = corners.size();
    const double sense = twiceArea(corners) > 0 ? 1 : -1;
    std::vector<Piece> pieces{{areaOf(corners)}};
    for (std::size_t i = 0; i < count; ++i) {
        const auto outwards = [&](std::size_t edge) {
            const Point along = (corners[(edge + 1) % count] - corners[edge]).normalized();
            return Point(sense * Point(along[1], -along[0]));
        };
        const Point before = outwards((i + count - 1) % count), after = outwards(i);
        if (!(sense * cross(before, after) > straight)) continue;  // bent inwards, or not at all
        const Point start = inner[i] + radius * before, end = inner[i] + radius * after;
        pieces.push_back({areaOf({inner[i], start, corners[i], end}), -1});
        pieces.push_back({sector(inner[i], radius, before, after), 1});
    }
    Solid solid = united(pieces);
    const double density = static_cast<double>(mass) / solid.mass;
    solid.mass = static_cast<double>(mass);
    solid.inertia *= density;
    return solid;
}

std::optional<Shares> shareWithCore(const Solid& solid, const std::vector<Point>& outline,
                                    const std::vector<double>& weights) {
    Point mean(0, 0);
    double spread = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point apart = outline[i] - solid.centre;
        mean += weights[i] * apart;
        spread += weights[i] * apart.squaredNorm();
    }
    // A symmetric outline has its centre exactly there, but for rounding.
    if (mean.squaredNorm() < 1e-20 * spread) mean = Point(0, 0);
    // With the share q at the outline the core must be at -q mean / (1 - q), and
    //   q spread + q^2 mean^2 / (1 - q) = gyration^2,
    // a quadratic equation for q with one root between 0 and 1.
    const double gyration2 = solid.gyration2();
    const double difference = spread - gyration2;
    const double root = std::sqrt(difference * difference + 4 * mean.squaredNorm() * gyration2);
    const double q = 2 * gyration2 / (spread + gyration2 + root);
    if (difference <= 0 || q > 1 - leastCore) return std::nullopt;
    Shares shares;
    for (const double weight : weights)
        shares.outline.push_back(static_cast<Real>(solid.mass * q * weight));
    shares.core = static_cast<Real>(solid.mass * (1 - q));
    shares.corePlace = (solid.centre - q / (1 - q) * mean).cast<Real>();
    return shares;
}

std::vector<Point> lobesOf(const std::vector<Point>& corners, const std::vector<Point>& inner,
                           double radius) {
    std::vector<Point> lobes;
    for (std::size_t i = 0; i < corners.size(); ++i)
        lobes.emplace_back(inner[i] + radius * (corners[i] - inner[i]).normalized());
    return lobes;
}

std::optional<Shares> shareWithLobes(const Solid& solid, const std::vector<Point>& inner,
                                     const std::vector<Point>& lobes,
                                     const std::vector<double>& weights) {
    std::vector<Point> outline = inner;
    outline.insert(outline.end(), lobes.begin(), lobes.end());
    std::vector<double> shares;
    for (const double weight : weights) shares.push_back((1 - lobesShare) * weight);
    for (const double weight : weights) shares.push_back(lobesShare * weight);
    return shareWithCore(solid, outline, shares);
}

}  // namespace sulfur::detail
