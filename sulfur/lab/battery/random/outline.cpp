#include "battery/random/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sulfur::lab {

namespace {

using Vec = Eigen::Vector2d;

double toSegment(const Vec& p, const Vec& a, const Vec& b) {
    const Vec way = b - a;
    const double length = way.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
    return (p - a - t * way).norm();
}

bool cross(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
    const auto side = [](const Vec& from, const Vec& to, const Vec& p) {
        return sulfur::cross(Vec(to - from), Vec(p - from));
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

double between(const Outline::Capsule& p, const Outline::Capsule& q) {
    const double axes = cross(p.a, p.b, q.a, q.b)
                            ? 0
                            : std::min({toSegment(p.a, q.a, q.b), toSegment(p.b, q.a, q.b),
                                        toSegment(q.a, p.a, p.b), toSegment(q.b, p.a, p.b)});
    return axes - p.radius - q.radius;
}

}  // namespace

Outline::Outline(const Blueprint& plan, const Vec& place, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto at = [&](std::uint32_t i) {
        const Vec p = plan.particles[i].position.cast<double>();
        return Vec(place + Vec(c * p.x() - s * p.y(), s * p.x() + c * p.y()));
    };
    for (std::uint32_t i = 0; i < plan.particles.size(); ++i)
        if (plan.particles[i].radius > 0)
            capsules.push_back({at(i), at(i), static_cast<double>(plan.particles[i].radius)});
    for (const JointSpec& joint : plan.joints)
        if (joint.radius > 0)
            capsules.push_back({at(joint.a), at(joint.b), static_cast<double>(joint.radius)});
}

void Outline::move(const Vec& way) {
    for (Capsule& capsule : capsules) {
        capsule.a += way;
        capsule.b += way;
    }
}

double distance(const Outline& one, const Outline& other) {
    double least = std::numeric_limits<double>::infinity();
    for (const Outline::Capsule& p : one.capsules)
        for (const Outline::Capsule& q : other.capsules) least = std::min(least, between(p, q));
    return least;
}

}  // namespace sulfur::lab
