#include "fitting_marks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rail.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::scene::SceneField;
using sulfur::scene::SceneMechanism;
using Shape = FittingMark::Shape;

constexpr double endlessRail = 3;  // metres that are drawn of a rail without ends

double distanceToSegment(const Point& p, const Point& a, const Point& b) {
    const Point way = b - a;
    const double along =
        std::clamp((p - a).dot(way) / std::max(1e-12, way.squaredNorm()), 0.0, 1.0);
    return (a + along * way - p).norm();
}

Shape shapeOf(const SceneMechanism& mechanism) {
    const sulfur::Drive* drive = driveOf(mechanism);
    const bool motor = drive != nullptr && drive->motorMax > 0;
    // In the order of the variant.
    static constexpr std::array shapes{Shape::hinge, Shape::weld,   Shape::slider, Shape::axle,
                                       Shape::cable, Shape::pulley, Shape::gear};
    const Shape shape = shapes.at(mechanism.spec.index());
    if (shape == Shape::hinge && motor) return Shape::motor;
    if (shape != Shape::cable) return shape;
    if (motor) return Shape::winch;
    return drive->stiffness > 0 ? Shape::spring : Shape::cable;
}

std::vector<Point> railOf(const sulfur::World& world, const sulfur::MechanismInfo& info) {
    if (!info.rail.empty()) {
        std::vector<Point> line = lineOf(world, info.rail);
        line.push_back(info.pointB);
        return line;
    }
    const Point axis = info.axis.cast<double>();
    const auto end = [&](sulfur::Real limit, double otherwise) -> Point {
        const double to = std::isfinite(limit) ? static_cast<double>(limit) : otherwise;
        return info.pointB + (to - info.value) * axis;
    };
    return {end(info.drive.lower, -endlessRail), end(info.drive.upper, endlessRail), info.pointB};
}

// Points of a mechanism that is there; gears know theirs from their parts.
void placeMark(FittingMark& mark, const sulfur::World& world, const sulfur::MechanismInfo& info) {
    switch (mark.shape) {
        case Shape::slider:
            mark.points = railOf(world, info);
            mark.at = info.pointB;
            return;
        case Shape::spring:
        case Shape::cable:
        case Shape::winch:
            mark.length = static_cast<double>(info.drive.upper);
            mark.points = {info.pointA, info.pointB};
            mark.at = (info.pointA + info.pointB) / 2;
            return;
        case Shape::pulley:
            mark.points = {info.pointA, info.overA, info.overB, info.pointB};
            mark.at = (info.overA + info.overB) / 2;
            return;
        default:
            mark.points = {info.pointB};
            mark.at = info.pointB;
            return;
    }
}

std::optional<FittingMark> markOfZone(const Document& document, std::size_t index) {
    const sulfur::Field& field = document.scene().fields[index].field;
    FittingMark mark;
    mark.ref = {FittingRef::Kind::zone, index};
    mark.shape = Shape::zone;
    const auto place = [&](const sulfur::Zone& zone) {
        if (const auto* box = std::get_if<sulfur::BoxZone>(&zone)) {
            mark.points = {box->low, box->high};
        } else if (const auto* circle = std::get_if<sulfur::CircleZone>(&zone)) {
            const auto radius = static_cast<double>(circle->radius);
            const Point half(radius, radius);
            mark.points = {circle->centre - half, circle->centre + half};
        }
    };
    if (const auto* wind = std::get_if<sulfur::WindField>(&field)) {
        mark.shape = Shape::wind;
        mark.direction = wind->velocity;
        place(wind->zone);
    } else if (const auto* uniform = std::get_if<sulfur::UniformField>(&field)) {
        mark.direction = uniform->acceleration;
        place(uniform->zone);
    } else {
        const auto& radial = std::get<sulfur::RadialField>(field);
        place(sulfur::CircleZone{radial.centre, std::max(radial.core, sulfur::Real(0.3))});
    }
    if (mark.points.empty()) return std::nullopt;  // everywhere
    mark.at = (mark.points[0] + mark.points[1]) / 2;
    return mark;
}

double hitDistance(const FittingMark& mark, const Point& point) {
    double nearest = (mark.at - point).norm();
    if (mark.ref.kind == FittingRef::Kind::zone) {
        const Point low = mark.points[0], high = mark.points[1];
        const std::array<Point, 4> corners{low, Point(high.x(), low.y()), high,
                                           Point(low.x(), high.y())};
        for (std::size_t i = 0; i < 4; ++i)
            nearest =
                std::min(nearest, distanceToSegment(point, corners.at(i), corners.at((i + 1) % 4)));
        return nearest;
    }
    const std::size_t ends = mark.points.size() - (mark.shape == Shape::slider ? 1 : 0);
    for (std::size_t i = 1; i < ends; ++i)
        nearest = std::min(nearest, distanceToSegment(point, mark.points[i - 1], mark.points[i]));
    return nearest;
}

// Lines and borders count as farther away than points.
double rankOf(const FittingMark& mark) {
    if (mark.ref.kind == FittingRef::Kind::zone) return 2;
    return mark.points.size() > 1 ? 1 : 0;
}

}  // namespace

std::vector<FittingMark> fittingMarks(const Document& document) {
    const sulfur::World& world = document.world();
    std::vector<FittingMark> marks;
    for (std::size_t i = 0; i < document.scene().fields.size(); ++i)
        if (auto mark = markOfZone(document, i)) marks.push_back(std::move(*mark));
    const auto& mechanisms = document.scene().mechanisms;
    const auto& made = document.made();
    std::map<std::string, Point> places;
    for (std::size_t i = 0; i < mechanisms.size(); ++i) {
        FittingMark mark;
        mark.ref = {FittingRef::Kind::mechanism, i};
        mark.shape = shapeOf(mechanisms[i]);
        mark.keys = keysOf(mechanisms[i]);
        if (const auto* drive = driveOf(mechanisms[i]); drive != nullptr && drive->motorMax > 0)
            mark.direction.x() = drive->motorSpeed;
        if (const auto* gear = std::get_if<sulfur::scene::Gear>(&mechanisms[i].spec)) {
            if (!places.contains(gear->first) || !places.contains(gear->second)) continue;
            mark.points = {places[gear->first], places[gear->second]};
            mark.at = (mark.points[0] + mark.points[1]) / 2;
        } else {
            const auto id = made[i].spring ? made[i].spring : made[i].id;
            if (!id || !world.contains(id)) continue;
            placeMark(mark, world, world.info(id));
            if (!mechanisms[i].id.empty()) places[mechanisms[i].id] = mark.at;
        }
        marks.push_back(std::move(mark));
    }
    for (std::size_t i = 0; i < document.thrusters().size(); ++i) {
        const Thruster& thruster = document.thrusters()[i];
        const sulfur::BodyId body = document.bodyOf(thruster.body);
        if (!body) continue;
        FittingMark mark;
        mark.ref = {FittingRef::Kind::thruster, i};
        mark.shape = Shape::thruster;
        mark.at = world.toWorld(body, thruster.at.cast<double>());
        mark.points = {mark.at};
        mark.direction = world.vectorToWorld(body, thruster.force);
        mark.keys = thruster.keys;
        marks.push_back(std::move(mark));
    }
    return marks;
}

std::optional<FittingRef> fittingAt(const Document& document, const Point& point, double reach) {
    std::optional<FittingRef> found;
    double best = std::numeric_limits<double>::infinity();
    for (const FittingMark& mark : fittingMarks(document)) {
        const double off = hitDistance(mark, point);
        const double rank = off + rankOf(mark) * 2 * reach;
        if (off > reach || rank > best) continue;
        best = rank;
        found = mark.ref;
    }
    return found;
}

std::optional<FittingRef> partAt(const Document& document, sulfur::BodyId body, const Point& point,
                                 double reach) {
    const sulfur::World& world = document.world();
    if (body) {
        sulfur::ParticleId hit;
        double nearest = std::numeric_limits<double>::infinity();
        for (const sulfur::ParticleId particle : world.particles(body)) {
            const double off = (world.position(particle) - point).norm();
            const double radius = static_cast<double>(world.info(particle).radius);
            if (off > std::max(reach, radius) || off >= nearest) continue;
            hit = particle;
            nearest = off;
        }
        if (hit) return document.partOf(hit);
    }
    sulfur::JointId hit;
    double nearest = reach;
    const auto look = [&](sulfur::JointId joint) {
        const auto info = world.info(joint);
        const double off =
            distanceToSegment(point, world.position(info.a), world.position(info.b)) -
            static_cast<double>(info.radius);
        if (off > nearest) return;
        hit = joint;
        nearest = off;
    };
    if (body)
        for (const sulfur::JointId joint : world.joints(body)) look(joint);
    else
        for (const sulfur::JointId joint : world.connections()) look(joint);
    return hit ? document.partOf(hit) : std::nullopt;
}

std::vector<FittingRef> fittingsCrossing(const Document& document, const Point& a, const Point& b) {
    std::vector<FittingRef> found;
    for (const FittingMark& mark : fittingMarks(document)) {
        const bool isLine =
            mark.shape == Shape::spring || mark.shape == Shape::cable || mark.shape == Shape::winch;
        if (!isLine) continue;
        const Point p = mark.points[0], q = mark.points[1];
        const auto side = [](const Point& from, const Point& to, const Point& of) {
            return sulfur::cross(Point(to - from), Point(of - from)) > 0;
        };
        if (side(a, b, p) != side(a, b, q) && side(p, q, a) != side(p, q, b))
            found.push_back(mark.ref);
    }
    return found;
}

void moveFitting(Document& document, const FittingRef& ref, const Point& from, const Point& by) {
    if (ref.kind == FittingRef::Kind::zone) {
        document.refit(
            ref,
            [&](Fitting& fitting) {
                auto& field = std::get<SceneField>(fitting).field;
                const auto move = [&](sulfur::Zone& zone) {
                    if (auto* box = std::get_if<sulfur::BoxZone>(&zone)) {
                        box->low += by;
                        box->high += by;
                    } else if (auto* circle = std::get_if<sulfur::CircleZone>(&zone)) {
                        circle->centre += by;
                    }
                };
                std::visit(
                    [&](auto& one) {
                        if constexpr (requires { one.zone; })
                            move(one.zone);
                        else
                            one.centre += by;
                    },
                    field);
            },
            true);
        return;
    }
    if (ref.kind == FittingRef::Kind::thruster) {
        const auto body = document.bodyOf(document.thrusters().at(ref.index).body);
        if (!body) return;
        const auto local = document.world().vectorToBody(body, by.cast<sulfur::Real>());
        document.refit(
            ref, [&](Fitting& f) { std::get<Thruster>(f).at += local; }, true);
        return;
    }
    if (ref.kind == FittingRef::Kind::particle) {
        const auto body = document.bodyOf(ref.body);
        if (!body) throw std::runtime_error("pieces cannot be changed so; reset the scene first");
        const auto local = document.world().vectorToBody(body, by.cast<sulfur::Real>());
        document.refit(
            ref, [&](Fitting& f) { std::get<ParticlePart>(f).spec.position += local; }, false);
        return;
    }
    if (ref.isPart()) return;
    if (document.canReset())
        throw std::runtime_error("mechanisms are moved before time runs; reset the scene first");
    // Pegs move with the points that they hold.
    SceneMechanism before = document.scene().mechanisms.at(ref.index);
    std::vector<Point> places;
    std::string body;  // whose end is moved
    double nearest = std::numeric_limits<double>::infinity();
    const auto names = bodiesOf(before);
    for (const std::string* name : names)
        for (const Point* place : pointsOf(before, *name))
            if (const double off = (*place - from).norm(); off < nearest) {
                nearest = off;
                body = *name;
            }
    for (const std::string* name : names)
        if (document.isPeg(*name) && (names.size() == 2 || *name == body))
            if (const auto peg = document.bodyOf(*name);
                peg && (*name == body || pointsOf(before, *name).empty())) {
                const auto pose = document.world().pose(peg);
                document.place(peg, {pose.position + by, pose.angle});
            }
    document.refit(
        ref,
        [&](Fitting& fitting) {
            auto& mechanism = std::get<SceneMechanism>(fitting);
            const bool own = document.isPeg(body);
            for (Point* place : pointsOf(mechanism, body))
                if (!own && (*place - from).norm() <= nearest + 1e-6) *place += by;
        },
        false);
}

}  // namespace sulfurchamber
