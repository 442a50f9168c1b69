#include "geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::JointId;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::World;

// Calls visit(joint, its info) for every joint, the bodies' first.
template <class Visit>
void forEachJoint(const World& world, const Visit& visit) {
    for (const BodyId body : world.bodies())
        for (const JointId joint : world.joints(body)) visit(joint, world.info(joint));
    for (const JointId joint : world.connections()) visit(joint, world.info(joint));
}

double alongSegment(const Point& a, const Point& b, const Point& point) {
    const Point edge = b - a;
    const double lengthSquared = edge.squaredNorm();
    if (lengthSquared <= 0) return 0;
    return std::clamp((point - a).dot(edge) / lengthSquared, 0.0, 1.0);
}

bool crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double sideC = sulfur::cross(b - a, c - a);
    const double sideD = sulfur::cross(b - a, d - a);
    const double sideA = sulfur::cross(d - c, a - c);
    const double sideB = sulfur::cross(d - c, b - c);
    return sideC * sideD < 0 && sideA * sideB < 0;
}

// Which particles capsules join to which.
using Neighbours = std::map<std::uint32_t, std::vector<std::uint32_t>>;

// Follows one closed line of neighbours; empty when it ends or branches.
std::vector<std::uint32_t> walkLoop(const Neighbours& next, std::uint32_t start,
                                    std::vector<bool>& seen) {
    std::vector<std::uint32_t> loop;
    std::uint32_t before = start;
    std::uint32_t at = start;
    bool closed = true;
    do {
        seen[at] = true;
        loop.push_back(at);
        const auto& neighbours = next.at(at);
        if (neighbours.size() != 2) closed = false;
        std::uint32_t to = at;
        for (const std::uint32_t candidate : neighbours)
            if (candidate != before && (candidate == start ? loop.size() > 2 : !seen[candidate])) {
                to = candidate;
                break;
            }
        if (to == at) return {};
        before = at;
        at = to;
    } while (at != start);
    return closed ? loop : std::vector<std::uint32_t>{};
}

std::vector<std::vector<std::uint32_t>> loopsOf(const Neighbours& neighbours,
                                                std::size_t particles) {
    std::vector<std::vector<std::uint32_t>> loops;
    std::vector<bool> seen(particles, false);
    for (const auto& [start, around] : neighbours) {
        if (seen[start] || around.size() != 2) continue;
        if (auto loop = walkLoop(neighbours, start, seen); loop.size() > 2)
            loops.push_back(std::move(loop));
    }
    return loops;
}

// What hangs on one pin swings to both sides of it.
void includeSwing(const World& world, BodyId body, Bounds& bounds) {
    std::optional<Point> pin;
    for (const ParticleId particle : world.particles(body)) {
        const auto info = world.info(particle);
        if (!info.pinned) continue;
        if (pin) return;
        pin = info.position;
    }
    if (!pin) return;
    double length = 0;
    for (const ParticleId particle : world.particles(body)) {
        const auto info = world.info(particle);
        length = std::max(length, (info.position - *pin).norm() + static_cast<double>(info.radius));
    }
    bounds.include(*pin - Point(length, length));
    bounds.include(*pin + Point(length, 0));
}

void includeGround(const World& world, Bounds& bounds) {
    const Point size = bounds.size();
    const Bounds moving = bounds;
    const double below = moving.low.y() - std::max(6.0, size.y());
    const double above = moving.high.y() + std::max(2.0, size.y());
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != sulfur::BodyKind::fixed) continue;
        for (const JointId joint : world.joints(body)) {
            const auto info = world.info(joint);
            const Point a = world.position(info.a);
            const Point b = world.position(info.b);
            if (std::max(a.x(), b.x()) < moving.low.x() || std::min(a.x(), b.x()) > moving.high.x())
                continue;
            const Point middle = a + alongSegment(a, b, moving.centre()) * (b - a);
            if (middle.y() > below && middle.y() < above)
                bounds.include(
                    {std::clamp(middle.x(), moving.low.x(), moving.high.x()), middle.y()});
        }
    }
}

}  // namespace

void Bounds::include(const Point& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
}

std::optional<ParticlePick> particleAt(const World& world, const Point& point, double reach) {
    std::optional<ParticlePick> best;
    for (const BodyId body : world.bodies())
        for (const ParticleId particle : world.particles(body)) {
            const auto info = world.info(particle);
            const double distance = (info.position - point).norm();
            if (distance > std::max(reach, static_cast<double>(info.radius))) continue;
            if (!best || distance < best->distance) best = ParticlePick{particle, body, distance};
        }
    return best;
}

std::optional<JointPick> jointAt(const World& world, const Point& point, double reach) {
    std::optional<JointPick> best;
    forEachJoint(world, [&](JointId joint, const sulfur::JointInfo& info) {
        const Point a = world.position(info.a);
        const Point b = world.position(info.b);
        const double along = alongSegment(a, b, point);
        const double distance =
            std::max(0.0, (a + along * (b - a) - point).norm() - static_cast<double>(info.radius));
        if (distance > reach || (best && distance >= best->distance)) return;
        best = JointPick{joint, info.body, along, distance};
    });
    return best;
}

namespace {

// What a point is to a body: how far from its surface (metres, not beyond a reach), or within it,
// and in none of its holes.
struct Nearness {
    std::optional<double> surface;
    bool within = false;
};

Nearness nearnessOf(const World& world, BodyId body, const Point& point, double reach) {
    Nearness found;
    const auto loops = outlines(world, body);
    const auto particles = world.particles(body);
    for (const auto& loop : loops) {
        std::vector<Point> polygon;
        for (const std::uint32_t index : loop) polygon.push_back(world.position(particles[index]));
        if (inside(polygon, point)) found.within = !found.within;
    }
    const auto take = [&](double distance, sulfur::Real radius) {
        // Inside of an outline, what touches nothing is no surface.
        if (!(radius > 0) && !loops.empty()) return;
        distance = std::max(0.0, distance - static_cast<double>(radius));
        if (distance <= reach && (!found.surface || distance < *found.surface))
            found.surface = distance;
    };
    for (const JointId joint : world.joints(body)) {
        const auto info = world.info(joint);
        const Point a = world.position(info.a);
        const Point b = world.position(info.b);
        take((a + alongSegment(a, b, point) * (b - a) - point).norm(), info.radius);
    }
    for (const ParticleId particle : particles) {
        const auto info = world.info(particle);
        take((info.position - point).norm(), info.radius);
    }
    return found;
}

}  // namespace

BodyId bodyAt(const World& world, const Point& point, double reach, const Picking& picking) {
    struct Found {
        BodyId body;
        int order = 0;
        double distance = 0;
    };
    std::optional<Found> surface;
    std::optional<Found> within;
    for (const BodyId body : world.bodies()) {
        const auto bounds = world.bounds(body);
        const bool near = (point.array() >= bounds.low.array() - reach).all() &&
                          (point.array() <= bounds.high.array() + reach).all();
        if (!near || (picking.counts && !picking.counts(body))) continue;
        const int order = picking.order ? picking.order(body) : 0;
        const Nearness nearness = nearnessOf(world, body, point, reach);
        if (const auto& distance = nearness.surface) {
            if (!surface || order > surface->order ||
                (order == surface->order && *distance <= surface->distance))
                surface = Found{body, order, *distance};
        } else if (world.kind(body) != sulfur::BodyKind::fixed && nearness.within &&
                   (!within || order >= within->order)) {
            within = Found{body, order, 0};
        }
    }
    if (surface && (!within || surface->order >= within->order)) return surface->body;
    return within ? within->body : BodyId{};
}

std::vector<BodyId> movingBodiesAt(const World& world, const Point& point, double reach) {
    std::vector<BodyId> found;
    const auto bodies = world.bodies();
    for (auto body = bodies.rbegin(); body != bodies.rend(); ++body) {
        if (world.kind(*body) != sulfur::BodyKind::dynamic) continue;
        const auto bounds = world.bounds(*body);
        if ((point.array() < bounds.low.array() - reach).any() ||
            (point.array() > bounds.high.array() + reach).any())
            continue;
        const auto particles = world.particles(*body);
        bool hit = std::any_of(particles.begin(), particles.end(), [&](ParticleId particle) {
            const auto radius = static_cast<double>(world.info(particle).radius);
            return (world.position(particle) - point).norm() <= radius + reach;
        });
        for (const JointId joint : world.joints(*body)) {
            if (hit) break;
            const auto info = world.info(joint);
            const Point a = world.position(info.a), way = world.position(info.b) - a;
            const double along = (point - a).dot(way) / std::max(1e-12, way.squaredNorm());
            const Point nearest = a + std::clamp(along, 0.0, 1.0) * way;
            hit = (nearest - point).norm() <= static_cast<double>(info.radius) + reach;
        }
        for (const auto& loop : outlines(world, *body)) {
            if (hit) break;
            std::vector<Point> polygon;
            for (const std::uint32_t index : loop)
                polygon.push_back(world.position(particles[index]));
            hit = inside(polygon, point);
        }
        if (hit) found.push_back(*body);
    }
    return found;
}

std::vector<BodyId> bodiesIn(const World& world, const Point& a, const Point& b) {
    const Point low = a.cwiseMin(b);
    const Point high = a.cwiseMax(b);
    std::vector<BodyId> found;
    for (const BodyId body : world.bodies()) {
        const auto particles = world.particles(body);
        const bool all = std::all_of(particles.begin(), particles.end(), [&](ParticleId particle) {
            const Point p = world.position(particle);
            return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
        });
        if (all && !particles.empty()) found.push_back(body);
    }
    return found;
}

std::vector<JointId> jointsCrossing(const World& world, const Point& a, const Point& b) {
    std::vector<JointId> found;
    forEachJoint(world, [&](JointId joint, const sulfur::JointInfo& info) {
        if (info.body && world.kind(info.body) == sulfur::BodyKind::fixed) return;
        if (crossing(a, b, world.position(info.a), world.position(info.b))) found.push_back(joint);
    });
    return found;
}

std::vector<std::vector<std::uint32_t>> outlines(const World& world, BodyId body) {
    const auto particles = world.particles(body);
    std::map<ParticleId, std::uint32_t> indices;
    for (std::uint32_t i = 0; i < particles.size(); ++i) indices.emplace(particles[i], i);
    Neighbours neighbours;
    for (const JointId joint : world.joints(body)) {
        const auto info = world.info(joint);
        if (!(info.radius > 0)) continue;
        const auto a = indices.find(info.a);
        const auto b = indices.find(info.b);
        if (a == indices.end() || b == indices.end()) continue;
        neighbours[a->second].push_back(b->second);
        neighbours[b->second].push_back(a->second);
    }
    return loopsOf(neighbours, particles.size());
}

std::vector<std::vector<std::uint32_t>> outlines(const sulfur::Blueprint& blueprint) {
    Neighbours neighbours;
    for (const auto& joint : blueprint.joints) {
        if (!(joint.radius > 0)) continue;
        neighbours[joint.a].push_back(joint.b);
        neighbours[joint.b].push_back(joint.a);
    }
    return loopsOf(neighbours, blueprint.particles.size());
}

bool inside(const std::vector<Point>& polygon, const Point& point) {
    bool in = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point& a = polygon[i];
        const Point& b = polygon[j];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) in = !in;
    }
    return in;
}

std::set<BodyId> pinsOf(const World& world) {
    std::set<BodyId> pins;
    for (const sulfur::MechanismId mechanism : world.mechanisms())
        for (const BodyId body : world.info(mechanism).own)
            if (body) pins.insert(body);
    return pins;
}

Totals totals(const World& world) {
    Totals sums;
    const std::set<BodyId> pins = pinsOf(world);
    for (const BodyId body : world.bodies()) {
        if (pins.contains(body)) continue;
        ++sums.bodies;
        const std::size_t count = world.particles(body).size();
        sums.particles += count;
        if (world.kind(body) != sulfur::BodyKind::fixed && !world.asleep(body))
            sums.awakeParticles += count;
    }
    forEachJoint(world, [&](JointId, const sulfur::JointInfo& info) {
        ++(std::isfinite(info.stiffness) ? sums.elasticJoints : sums.rigidJoints);
    });
    return sums;
}

double floorHeight(const World& world) {
    double height = 0;
    for (const BodyId body : world.bodies()) height = std::max(height, world.bounds(body).high.y());
    return height;
}

std::optional<Bounds> interestingBounds(const World& world) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Bounds moving{{inf, inf}, {-inf, -inf}};
    Bounds standing = moving;
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) == sulfur::BodyKind::dynamic) includeSwing(world, body, moving);
        for (const ParticleId particle : world.particles(body)) {
            const auto info = world.info(particle);
            const Point radius(static_cast<double>(info.radius), static_cast<double>(info.radius));
            Bounds& bounds = world.kind(body) == sulfur::BodyKind::fixed ? standing : moving;
            bounds.include(info.position - radius);
            bounds.include(info.position + radius);
        }
    }
    if (moving.low.x() > moving.high.x()) {
        constexpr double flat = 1;  // metres: what is lower is a floor to build on
        if (standing.low.x() > standing.high.x() || standing.size().y() < flat) return std::nullopt;
        return standing;
    }
    includeGround(world, moving);
    return moving;
}

}  // namespace sulfurchamber
