// Where meters are seen and taken hold of.
#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "meters.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::World;

double distanceToLine(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a;
    const double squared = along.squaredNorm();
    const double share = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
    return (p - a - share * along).norm();
}

// A body of the plan with the place of a particle in it; nothing for pieces.
std::optional<MeterEnd> endOf(const Document& document, sulfur::ParticleId particle) {
    const World& world = document.world();
    const BodyId body = world.info(particle).body;
    const std::string id = document.idOf(body);
    if (id.empty()) return std::nullopt;
    const auto particles = world.particles(body);
    const auto place = std::find(particles.begin(), particles.end(), particle);
    return MeterEnd{world.toBody(body, world.position(particle)), id,
                    static_cast<std::uint32_t>(place - particles.begin())};
}

// The mechanism whose places are within reach, the nearest.
std::vector<MeterEnd> mechanismEnds(const Document& document, const Point& point, double reach) {
    const World& world = document.world();
    std::vector<MeterEnd> ends;
    double nearest = reach;
    for (const auto mechanism : world.mechanisms()) {
        const auto info = world.info(mechanism);
        if (info.kind == sulfur::MechanismKind::gear) continue;
        const bool rope = info.kind == sulfur::MechanismKind::distance;
        const double distance =
            rope ? distanceToLine(point, info.pointA, info.pointB)
                 : std::min((info.pointA - point).norm(), (info.pointB - point).norm());
        const std::string a = document.idOf(info.a), b = document.idOf(info.b);
        if (distance > nearest || a.empty() || b.empty()) continue;
        nearest = distance;
        ends = {{world.toBody(info.a, info.pointA), a, {}},
                {world.toBody(info.b, info.pointB), b, {}}};
    }
    return ends;
}

}  // namespace

Point dialOf(const Point& anchor, double reach) {
    return anchor + Point(0, 5 * reach);
}

double dialRadius(double reach) {
    return 3 * reach;
}

std::optional<MeterPick> meterAt(const Meters& meters, const Point& point, double reach) {
    std::optional<MeterPick> found;
    double nearest = reach;
    const auto offer = [&](const Meter& meter, double distance, std::optional<std::size_t> end) {
        if (distance > nearest) return;
        nearest = distance;
        found = MeterPick{meter.id, end};
    };
    for (const Meter& meter : meters.all()) {
        std::vector<Point> places;
        for (std::size_t i = 0; i < meter.ends.size(); ++i)
            if (const auto place = meters.place(meter, i)) places.push_back(*place);
        if (places.size() != meter.ends.size()) continue;
        if (meter.kind == MeterKind::gauge) {
            const Point anchor = places.size() == 1 ? places[0] : (places[0] + places[1]) / 2;
            const double off = (dialOf(anchor, reach) - point).norm() - dialRadius(reach);
            offer(meter, std::max(0.0, off), 0);
            continue;
        }
        // Lines first, so that ends, which come later, win.
        for (std::size_t i = 1; i < places.size(); ++i)
            offer(meter, distanceToLine(point, places[0], places[i]), std::nullopt);
        for (std::size_t i = 0; i < places.size(); ++i)
            offer(meter, std::max(0.0, (places[i] - point).norm() - reach / 2), i);
    }
    return found;
}

MeterEnd endAt(const Document& document, const Point& point, double reach) {
    const World& world = document.world();
    const auto moves = [&](BodyId body) { return world.kind(body) != sulfur::BodyKind::fixed; };
    if (const auto pick = particleAt(world, point, reach)) {
        // The ground stays: its corner is a place like any other.
        if (!moves(pick->body)) return {world.position(pick->particle), {}, {}};
        if (const auto end = endOf(document, pick->particle)) return *end;
    }
    const BodyId body = bodyAt(world, point, 0);
    if (!body || !moves(body)) return {point, {}, {}};
    const std::string id = document.idOf(body);
    if (id.empty()) return {point, {}, {}};
    return {world.toBody(body, point), id, {}};
}

std::vector<MeterEnd> gaugeAt(const Document& document, const Point& point, double reach) {
    const World& world = document.world();
    if (auto ends = mechanismEnds(document, point, reach); !ends.empty()) return ends;
    const auto joint = jointAt(world, point, reach);
    const BodyId body = bodyAt(world, point, reach);
    // The joints of what is solid bear nothing that one could tell: its contacts are meant.
    const bool solid = body && world.joints(body).size() > 1 &&
                       !std::isfinite(world.info(world.joints(body)[0]).stiffness) &&
                       !outlines(world, body).empty();
    if (joint && !solid && (!joint->body || world.kind(joint->body) != sulfur::BodyKind::fixed)) {
        const auto info = world.info(joint->joint);
        const auto a = endOf(document, info.a), b = endOf(document, info.b);
        if (a && b) return {*a, *b};
    }
    if (!body) return {};
    const std::string id = document.idOf(body);
    if (id.empty()) return {};
    return {{world.toBody(body, world.centreOfMass(body)), id, {}}};
}

}  // namespace sulfurchamber
