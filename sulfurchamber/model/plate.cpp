#include "plate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include "dimensions.hpp"
#include "geometry.hpp"
#include "lattice.hpp"
#include "loop_region.hpp"
#include "words.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;
using sulfur::scene::Prefab;
using Loop = std::vector<std::uint32_t>;

constexpr double pointedMitre = 4;  // radii that a corner moves at most
constexpr double plateSlit = 1e-4;  // metres by which corners of a slit go to their sides

double thickness(const sulfur::Blueprint& plan) {
    double radius = 0;
    for (const auto& joint : plan.joints)
        radius = std::max(radius, static_cast<double>(joint.radius));
    return radius;
}

std::vector<Point> particlePlaces(const sulfur::Blueprint& plan) {
    std::vector<Point> points;
    for (const auto& particle : plan.particles)
        points.emplace_back(particle.position.cast<double>());
    return points;
}

// The loop with its sides moved by `by` to the right of the way around.
std::vector<Point> moved(const std::vector<Point>& loop, double by) {
    std::vector<Point> result;
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point in = (loop[i] - loop[(i + n - 1) % n]).normalized();
        const Point out = (loop[(i + 1) % n] - loop[i]).normalized();
        const Point sum = Point(in.y(), -in.x()) + Point(out.y(), -out.x());
        const double size = std::max(sum.norm(), 2 / pointedMitre);
        result.emplace_back(loop[i] + sum * (2 * by / (size * size)));
    }
    return result;
}

std::vector<Point> anticlockwise(std::vector<Point> loop, bool wanted) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        twice += sulfur::cross(loop[i], loop[(i + 1) % loop.size()]);
    if ((twice > 0) != wanted) std::reverse(loop.begin(), loop.end());
    return loop;
}

// Distance between two closed lines that do not cross, metres.
double gapBetween(const std::vector<Point>& a, const std::vector<Point>& b) {
    double least = std::numeric_limits<double>::infinity();
    const auto measure = [&](const std::vector<Point>& corners, const std::vector<Point>& line) {
        for (const Point& p : corners)
            for (std::size_t i = 0; i < line.size(); ++i) {
                const Point& from = line[i];
                const Point way = line[(i + 1) % line.size()] - from;
                const double along =
                    std::clamp((p - from).dot(way) / std::max(1e-18, way.squaredNorm()), 0.0, 1.0);
                least = std::min(least, (from + along * way - p).norm());
            }
    };
    measure(a, b);
    measure(b, a);
    return least;
}

bool linesCross(const std::vector<Point>& a, const std::vector<Point>& b) {
    const auto side = [](const Point& p, const Point& q, const Point& r) {
        return sulfur::cross(Point(q - p), Point(r - p));
    };
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k) {
            const Point &p = a[i], &q = a[(i + 1) % a.size()];
            const Point &r = b[k], &s = b[(k + 1) % b.size()];
            if (side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0) return true;
        }
    return false;
}

double plateArea(const Plate& plate) {
    double area = areaWithin(plate.outer);
    for (const auto& hole : plate.holes) area -= areaWithin(hole);
    return area;
}

// The axes of all capsules as one loop, so that the physics takes the holes for outside: a slit
// leads to each of them, too narrow to be seen or entered.
struct Axes {
    std::vector<Point> points;
    std::vector<bool> slits;  // whether the side from a point to the next is one of a slit
};

// The loop with the corners that come twice apart: each one goes a little into its own side.
Axes slitOpen(const Loop& loop, const std::vector<Point>& places) {
    Axes axes;
    const std::size_t n = loop.size();
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (std::size_t i = 0; i < n; ++i) sides.emplace(loop[i], loop[(i + 1) % n]);
    for (std::size_t i = 0; i < n; ++i) {
        const Point& before = places[loop[(i + n - 1) % n]];
        const Point& at = places[loop[i]];
        const Point& after = places[loop[(i + 1) % n]];
        const bool twice = std::count(loop.begin(), loop.end(), loop[i]) > 1;
        const double out = directionOf(after - at);
        const double wedge =
            std::fmod(directionOf(before - at) - out + 4 * std::numbers::pi, 2 * std::numbers::pi);
        const double inward = out + wedge / 2;
        axes.points.push_back(
            twice ? Point(at + plateSlit * Point(std::cos(inward), std::sin(inward))) : at);
        axes.slits.push_back(sides.contains({loop[(i + 1) % n], loop[i]}));
    }
    return axes;
}

Axes axesOf(const Plate& plate, double radius) {
    std::vector<Point> places;
    const auto add = [&](const std::vector<Point>& loop) {
        Loop indices(loop.size());
        std::iota(indices.begin(), indices.end(), static_cast<std::uint32_t>(places.size()));
        places.insert(places.end(), loop.begin(), loop.end());
        return indices;
    };
    LoopRegion region;
    region.outer = add(moved(anticlockwise(plate.outer, true), -radius));
    for (const auto& hole : plate.holes)
        region.holes.push_back(add(moved(anticlockwise(hole, false), -radius)));
    return slitOpen(oneLoop(region, places), places);
}

// Takes slits out of a loop: the loop around first, then those of the holes. Sides of slits come
// in pairs, there and back.
std::vector<Loop> withoutSlits(const Loop& loop, const std::vector<bool>& slits,
                               const std::vector<Point>& points) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!slits[i]) continue;
        // The side back is the one whose ends are nearest to those of this one.
        std::size_t back = n;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i || !slits[k]) continue;
            const double apart = (points[loop[k]] - points[loop[(i + 1) % n]]).norm() +
                                 (points[loop[(k + 1) % n]] - points[loop[i]]).norm();
            if (apart < nearest) {
                nearest = apart;
                back = k;
            }
        }
        if (back == n) return {loop};
        const auto part = [&](std::size_t from, std::size_t to) {
            std::pair<Loop, std::vector<bool>> piece;
            for (std::size_t k = from; k != to; k = (k + 1) % n) {
                piece.first.push_back(loop[k]);
                piece.second.push_back(slits[k]);
            }
            return piece;
        };
        // Behind the slit, without its last corner, and all the rest.
        const auto inner = part((i + 1) % n, back);
        const auto rest = part((back + 1) % n, i);
        auto loops = withoutSlits(rest.first, rest.second, points);
        const auto more = withoutSlits(inner.first, inner.second, points);
        loops.insert(loops.end(), more.begin(), more.end());
        return loops;
    }
    return {loop};
}

}  // namespace

std::optional<Plate> plateOf(const Prefab& prefab) {
    using namespace sulfur::shapes;
    const auto& g = prefab.generator;
    const auto& plan = prefab.blueprint;
    const bool isRecipe =
        std::holds_alternative<BoxOptions>(g) || std::holds_alternative<PolygonOptions>(g);
    if ((g.index() != 0 && !isRecipe) || plan.joints.empty()) return std::nullopt;
    for (const auto& joint : plan.joints)
        if (joint.restLength || (!isRecipe && std::isfinite(joint.stiffness))) return std::nullopt;
    const auto rims = outlines(plan);
    if (rims.size() != 1) return std::nullopt;
    const Loop& rim = rims[0];
    // Other rigid bodies have particles of their own inside.
    if (plan.particles.size() > rim.size() + std::max<std::size_t>(2, rim.size() - 2))
        return std::nullopt;
    const double thick = thickness(plan);
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> radii;
    for (const auto& joint : plan.joints)
        radii[std::minmax(joint.a, joint.b)] = static_cast<double>(joint.radius);
    std::vector<bool> slits;
    for (std::size_t i = 0; i < rim.size(); ++i)
        slits.push_back(radii[std::minmax(rim[i], rim[(i + 1) % rim.size()])] < thick / 10);
    const auto points = particlePlaces(plan);
    Plate plate;
    for (const Loop& loop : withoutSlits(rim, slits, points)) {
        std::vector<Point> places;
        for (const std::uint32_t index : loop) places.push_back(points[index]);
        if (places.size() < 3) return std::nullopt;
        plate.holes.push_back(std::move(places));
    }
    // The largest one is around the others.
    std::sort(plate.holes.begin(), plate.holes.end(),
              [](const auto& a, const auto& b) { return areaWithin(a) > areaWithin(b); });
    plate.outer = moved(anticlockwise(plate.holes.front(), true), thick);
    plate.holes.erase(plate.holes.begin());
    for (auto& hole : plate.holes) hole = moved(anticlockwise(hole, false), thick);
    return plate;
}

bool fits(const Plate& plate, const std::vector<Point>& hole, double room) {
    if (hole.size() < 3 || !inside(plate.outer, hole[0]) || linesCross(plate.outer, hole) ||
        gapBetween(plate.outer, hole) <= room)
        return false;
    return std::all_of(plate.holes.begin(), plate.holes.end(), [&](const auto& other) {
        return !inside(other, hole[0]) && !inside(hole, other[0]) && !linesCross(other, hole) &&
               gapBetween(other, hole) > room;
    });
}

void setPlate(Prefab& prefab, const Plate& plate) {
    sulfur::Blueprint& plan = prefab.blueprint;
    const auto before = plateOf(prefab);
    const double radius = thickness(plan);
    const Axes axes = axesOf(plate, radius);
    LoopRegion whole;
    for (std::uint32_t i = 0; i < axes.points.size(); ++i) whole.outer.push_back(i);
    const auto triangles =
        axes.points.empty() ? std::vector<CornerTriple>{} : trianglesOf(whole, axes.points);
    if (!before || triangles.empty())
        throw std::runtime_error(tr("this hole leaves too little around it; draw a smaller one"));
    const double mass = static_cast<double>(plan.mass()) * plateArea(plate) / plateArea(*before);
    const double density = mass / areaOf(whole, axes.points);
    sulfur::JointSpec like = plan.joints.front();
    plan.particles.clear();
    plan.joints.clear();
    plan.angles.clear();
    plan.skin.reset();
    prefab.generator = {};
    for (const Point& point : axes.points)
        plan.particles.push_back({.position = point.cast<Real>(), .mass = 0});
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    const auto join = [&](std::uint32_t a, std::uint32_t b, double thick) {
        if (!known.insert(std::minmax(a, b)).second) return;
        like.a = a;
        like.b = b;
        like.radius = static_cast<Real>(thick);
        plan.joints.push_back(like);
    };
    const auto corners = static_cast<std::uint32_t>(axes.points.size());
    for (std::uint32_t i = 0; i < corners; ++i)
        join(i, (i + 1) % corners, axes.slits[i] ? plateSlit / 2 : radius);
    // Three quarters of a triangle in its middle and the rest in its corners have its mass, its
    // centre and its inertia (Simpson's rule for triangles).
    for (const CornerTriple& triangle : triangles) {
        const auto& [a, b, c] = triangle;
        const Point p = axes.points[a], q = axes.points[b], r = axes.points[c];
        const double own = density * std::abs(sulfur::cross(Point(q - p), Point(r - p))) / 2;
        const auto middle = static_cast<std::uint32_t>(plan.particles.size());
        plan.particles.push_back({.position = Point((p + q + r) / 3).cast<Real>(),
                                  .mass = static_cast<Real>(0.75 * own)});
        join(a, b, 0);
        join(b, c, 0);
        join(c, a, 0);
        for (const std::uint32_t corner : triangle) {
            plan.particles[corner].mass += static_cast<Real>(own / 12);
            join(corner, middle, 0);
        }
    }
    plan.validate();
}

}  // namespace sulfurchamber
