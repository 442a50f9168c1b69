// Queries the long way: by asking every capsule, with other formulas than the library's.
#pragma once

#include <algorithm>
#include <vector>

#include "helpers.hpp"

namespace sulfur::test {

struct Capsule {
    BodyId body = {};
    Point a{0, 0}, b{0, 0};
    double radius = 0;
};

/// What a body encloses; empty for what has no outline.
struct Hollow {
    BodyId body = {};
    std::vector<Point> corners;
};

/// A world with the list of all that there is in it.
struct Catalogue {
    std::vector<Capsule> capsules;
    std::vector<Hollow> hollows;
};

inline Point nearestOn(const Point& a, const Point& b, const Point& p) {
    const double length2 = (b - a).squaredNorm();
    if (length2 == 0) return a;
    return a + std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) * (b - a);
}

inline double distance(const Point& a, const Point& b, const Point& p) {
    return (p - nearestOn(a, b, p)).norm();
}

/// By even and odd crossings of a ray to the right.
inline bool contains(const std::vector<Point>& corners, const Point& p) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a[1] > p[1]) != (b[1] > p[1]) &&
            p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
            inside = !inside;
    }
    return inside;
}

/// Distance of a segment from a convex polygon (or a segment or point) with these corners.
inline double distance(const Point& a, const Point& b, const std::vector<Point>& shape) {
    if (shape.size() > 2 && (contains(shape, a) || contains(shape, b))) return 0;
    double least = 1e300;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const Point &c = shape[i], &d = shape[(i + 1) % shape.size()];
        const auto side = [](const Point& u, const Point& v, const Point& p) {
            return cross(Point(v - u), Point(p - u));
        };
        if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
        least = std::min(
            {least, distance(a, b, c), distance(a, b, d), distance(c, d, a), distance(c, d, b)});
    }
    return least;
}

inline void list(Catalogue& all, World& world, BodyId body, std::size_t outline) {
    for (const JointId joint : world.joints(body)) {
        const JointInfo info = world.info(joint);
        if (info.radius > 0)
            all.capsules.push_back({body, world.position(info.a), world.position(info.b),
                                    static_cast<double>(info.radius)});
    }
    for (const ParticleId particle : world.particles(body)) {
        const ParticleInfo info = world.info(particle);
        if (info.radius > 0)
            all.capsules.push_back(
                {body, info.position, info.position, static_cast<double>(info.radius)});
    }
    if (outline == 0) return;
    Hollow hollow{body, {}};
    for (std::size_t i = 0; i < outline; ++i)
        hollow.corners.push_back(world.position(world.particles(body)[i]));
    all.hollows.push_back(hollow);
}

/// Bodies of all kinds and sizes in a square of 40 m, from a grain to a floor of 10 km.
struct Zoo {
    World world{{.gravity = {0, 0}}};
    std::vector<std::pair<BodyId, std::size_t>> bodies;  // with the corners of their outlines

    explicit Zoo(std::uint64_t seed) : random_(seed) {
        keep(shapes::floor({-5000, -22}, {5000, Real(-22.5)}, Real(0.3)), {}, 0);
        for (int i = 0; i < 15; ++i) {
            const Vec2 to(real(-4, 4), real(-4, 4));
            keep(shapes::floor({0, 0}, to, real(0.02, 0.3)), pose(), 0);
            keep(shapes::box({.size = {real(0.3, 3), real(0.3, 3)}}), pose(), 4);
            keep(shapes::ball({.radius = real(0.02, 0.5)}), pose(), 0);
            keep(shapes::rope({.from = {0, 0}, .to = to, .links = 8}), pose(), 0);
            keep(shapes::wheel({.radius = real(0.3, 1), .segments = 7}), pose(), 7);
        }
        Blueprint lift = shapes::box({.size = {6, 1}});
        lift.kind = BodyKind::kinematic;
        keep(lift, pose(), 4);
    }

    Catalogue catalogue() {
        Catalogue all;
        for (const auto& [body, outline] : bodies) list(all, world, body, outline);
        return all;
    }
    Point place(double spread = 25) {
        return {random_.uniform(-spread, spread), random_.uniform(-spread, spread)};
    }
    double uniform(double low, double high) { return random_.uniform(low, high); }
    std::size_t below(std::size_t count) { return random_.below(count); }

private:
    Real real(double low, double high) { return static_cast<Real>(random_.uniform(low, high)); }
    Pose pose() { return {place(20), random_.uniform(0, 6)}; }
    void keep(const Blueprint& plan, const Pose& pose, std::size_t outline) {
        bodies.emplace_back(world.add(plan, pose).id(), outline);
    }

    Random random_;
};

}  // namespace sulfur::test
