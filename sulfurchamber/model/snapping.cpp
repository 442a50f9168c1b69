#include "snapping.hpp"

#include <algorithm>
#include <cmath>

#include "geometry.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::World;

constexpr double leastBend = 0.35;       // radians: a corner turns by more
constexpr double longestMitre = 3;       // radii by which a pointed corner is lengthened at most
constexpr double snapAngleCatch = 0.07;  // radians on either side of a step

double thicknessOf(const World& world, BodyId body) {
    double radius = 0;
    for (const sulfur::JointId joint : world.joints(body))
        radius = std::max(radius, static_cast<double>(world.info(joint).radius));
    return radius;
}

// Where the sides beside b would meet without the roundness of their capsules; nothing where the
// line hardly bends. `outside` is +1 where the outside is to the right of the way a, b, c.
std::optional<Point> sharpCorner(const Point& a, const Point& b, const Point& c, double radius,
                                 double outside) {
    const Point in = (b - a).normalized();
    const Point out = (c - b).normalized();
    const double bend = std::atan2(sulfur::cross(in, out), in.dot(out));
    if (std::abs(bend) < leastBend) return std::nullopt;
    const Point normals = Point(in.y(), -in.x()) + Point(out.y(), -out.x());
    const double size = normals.norm();
    if (size < 1e-9) return b;
    const double mitre = std::min(2 / size, longestMitre);  // 1 / cos of half the bend
    return b + normals / size * (mitre * radius * outside);
}

void addCorners(const World& world, BodyId body, std::vector<SnapPlace>& places) {
    const auto particles = world.particles(body);
    const auto loops = outlines(world, body);
    const double radius = thicknessOf(world, body);
    for (const auto& loop : loops) {
        std::vector<Point> corners;
        for (const std::uint32_t index : loop) corners.push_back(world.position(particles[index]));
        double twice = 0;
        const std::size_t n = corners.size();
        for (std::size_t i = 0; i < n; ++i)
            twice += sulfur::cross(corners[i], corners[(i + 1) % n]);
        for (std::size_t i = 0; i < n; ++i)
            if (const auto corner = sharpCorner(corners[(i + n - 1) % n], corners[i],
                                                corners[(i + 1) % n], radius, twice > 0 ? 1 : -1))
                places.push_back({*corner, SnapPlace::Kind::corner});
    }
    // Lines have ends instead: each particle where few are, else the first and the last.
    if (!loops.empty() || world.joints(body).empty()) return;
    constexpr std::size_t few = 12;
    const std::size_t step = particles.size() <= few ? 1 : particles.size() - 1;
    for (std::size_t i = 0; i < particles.size(); i += step)
        places.push_back({world.position(particles[i]), SnapPlace::Kind::corner});
}

Point gridPoint(const Point& point, double grid) {
    return {std::round(point.x() / grid) * grid, std::round(point.y() / grid) * grid};
}

}  // namespace

std::vector<SnapPlace> snapPlaces(const World& world, BodyId body, const SnapOptions& options) {
    std::vector<SnapPlace> places;
    if (options.centres) {
        const auto bounds = world.bounds(body);
        const bool fixed = world.kind(body) == sulfur::BodyKind::fixed;
        places.push_back({fixed ? Point((bounds.low + bounds.high) / 2) : world.centreOfMass(body),
                          SnapPlace::Kind::centre});
    }
    if (options.corners) addCorners(world, body, places);
    return places;
}

std::vector<SnapPlace> snapPlacesNear(const World& world, const Point& point, double reach,
                                      const SnapOptions& options, const SnapCounts& counts) {
    std::vector<SnapPlace> places;
    if (!options.corners && !options.centres) return places;
    for (const BodyId body : world.bodies()) {
        const auto bounds = world.bounds(body);
        const bool near = (point.array() >= bounds.low.array() - reach).all() &&
                          (point.array() <= bounds.high.array() + reach).all();
        if (!near || (counts && !counts(body))) continue;
        const auto own = snapPlaces(world, body, options);
        places.insert(places.end(), own.begin(), own.end());
    }
    return places;
}

Snapped snapPoint(const World& world, const Point& point, double reach, const SnapOptions& options,
                  std::optional<Point> from, const SnapCounts& counts) {
    const SnapPlace* best = nullptr;
    const auto places = snapPlacesNear(world, point, reach, options, counts);
    for (const SnapPlace& place : places) {
        const double distance = (place.at - point).norm();
        if (distance <= reach && (best == nullptr || distance < (best->at - point).norm()))
            best = &place;
    }
    if (best != nullptr) return {best->at, *best};
    if (options.grid > 0) {
        const Point at = gridPoint(point, options.grid);
        return {at, SnapPlace{at, SnapPlace::Kind::grid}};
    }
    if (!options.angles || !from || (point - *from).norm() <= reach) return {point, std::nullopt};
    const Point way = point - *from;
    const double angle = std::atan2(way.y(), way.x());
    const double snapped = snapAngle(angle, snapAngleCatch);
    const Point along(std::cos(snapped), std::sin(snapped));
    const Point at = *from + way.dot(along) * along;
    const bool isOnStep = std::abs(std::remainder(snapped, snapAngleStep)) < 1e-9;
    if (!isOnStep || (at - point).norm() > reach) return {point, std::nullopt};
    return {at, SnapPlace{at, SnapPlace::Kind::angle, *from}};
}

Snapped snapMove(std::span<const SnapPlace> own, std::span<const SnapPlace> others, const Point& by,
                 double reach, const SnapOptions& options) {
    const SnapPlace* best = nullptr;
    Point way = by;
    double nearest = reach;
    for (const SnapPlace& mine : own) {
        const Point wanted = mine.at + by;
        for (const SnapPlace& other : others) {
            if (other.kind != mine.kind) continue;
            const double distance = (other.at - wanted).norm();
            if (distance > nearest) continue;
            nearest = distance;
            best = &other;
            way = other.at - mine.at;
        }
    }
    if (best != nullptr) return {way, *best};
    if (!(options.grid > 0) || own.empty()) return {by, std::nullopt};
    const Point at = gridPoint(own[0].at + by, options.grid);
    return {at - own[0].at, SnapPlace{at, SnapPlace::Kind::grid}};
}

double snapAngle(double angle, double within) {
    const double step = std::round(angle / snapAngleStep) * snapAngleStep;
    return std::abs(angle - step) <= within ? step : angle;
}

}  // namespace sulfurchamber
