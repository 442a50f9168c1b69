#include "solid.hpp"

#include <cmath>

namespace sulfur::detail {

namespace {
constexpr double leastCore = 0.02;  // of the mass
}

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

}  // namespace sulfur::detail
