#include "handles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

constexpr double knobReaches = 2.6;  // the knob stands so far above the frame
constexpr double leastFactor = 0.02;
constexpr double mostFactor = 50;

// Around one body, along its own frame.
Frame frameAlong(const sulfur::World& world, BodyId body) {
    const auto pose = world.pose(body);
    const Eigen::Rotation2Dd back(-pose.angle);
    std::optional<Bounds> all;
    const auto include = [&](const Point& place, sulfur::Real radius) {
        const Point at = back * (place - pose.position);
        const Point room = Point::Constant(static_cast<double>(radius));
        if (!all) all = Bounds{at, at};
        all->include(at - room);
        all->include(at + room);
    };
    for (const auto particle : world.particles(body)) {
        const auto info = world.info(particle);
        include(info.position, info.radius);
    }
    for (const auto joint : world.joints(body)) {
        const auto info = world.info(joint);
        if (!(info.radius > 0)) continue;
        include(world.position(info.a), info.radius);
        include(world.position(info.b), info.radius);
    }
    const Bounds bounds = all.value_or(Bounds{});
    return {pose.position + Eigen::Rotation2Dd(pose.angle) * bounds.centre(), bounds.size() / 2,
            pose.angle};
}

double kept(double factor) {
    return std::clamp(factor, leastFactor, mostFactor);
}

}  // namespace

std::optional<Bounds> selectionBounds(const Workbench& bench) {
    std::optional<Bounds> all;
    for (const BodyId body : bench.selection()) {
        const auto own = bench.document().world().bounds(body);
        if (!all) all = Bounds{own.low, own.high};
        all->include(own.low);
        all->include(own.high);
    }
    return all;
}

std::optional<Frame> selectionFrame(const Workbench& bench) {
    const auto& bodies = bench.selection();
    const auto& world = bench.document().world();
    if (bodies.size() == 1 && world.particles(bodies[0]).size() > 1)
        return frameAlong(world, bodies[0]);
    const auto bounds = selectionBounds(bench);
    if (!bounds) return std::nullopt;
    return Frame{bounds->centre(), bounds->size() / 2, 0};
}

Point Frame::at(double x, double y) const {
    return middle + Eigen::Rotation2Dd(angle) * Point(x * half.x(), y * half.y());
}

Point Frame::along(const Point& way) const {
    return Eigen::Rotation2Dd(-angle) * way;
}

std::array<Point, 4> Frame::corners() const {
    return {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
}

std::array<Handle, 9> handlesOf(const Frame& frame, double reach) {
    using Kind = Handle::Kind;
    Frame around = frame;
    around.half += Point(reach, reach);
    std::array<Handle, 9> handles{{{Kind::corner, -1, -1},
                                   {Kind::corner, 1, -1},
                                   {Kind::corner, 1, 1},
                                   {Kind::corner, -1, 1},
                                   {Kind::side, 0, -1},
                                   {Kind::side, 1, 0},
                                   {Kind::side, 0, 1},
                                   {Kind::side, -1, 0},
                                   {Kind::turn, 0, 0}}};
    for (Handle& handle : handles) handle.at = around.at(handle.x, handle.y);
    around.half.y() += knobReaches * reach;
    handles[8].at = around.at(0, 1);
    return handles;
}

Point Stretch::operator()(const Point& point) const {
    const Point local = Eigen::Rotation2Dd(-angle) * (point - about);
    return about + Eigen::Rotation2Dd(angle) * Point(local.cwiseProduct(factors));
}

bool Stretch::isUniform() const {
    return factors.x() == factors.y();
}

Stretch stretchBy(const Frame& frame, const Handle& handle, const Point& way, bool freely,
                  bool aboutMiddle) {
    Stretch stretch;
    stretch.angle = frame.angle;
    stretch.about = aboutMiddle ? frame.middle : frame.at(-handle.x, -handle.y);
    const Point by = frame.along(way);
    const Point arm =
        Point(handle.x * frame.half.x(), handle.y * frame.half.y()) * (aboutMiddle ? 1.0 : 2.0);
    const double length = arm.norm();
    if (!(length > 1e-9)) return stretch;
    const double factor = kept(1 + by.dot(arm) / (length * length));
    stretch.factors = {factor, factor};
    if (handle.kind != Handle::Kind::side || !freely) return stretch;
    if (handle.x == 0) stretch.factors.x() = 1;
    if (handle.y == 0) stretch.factors.y() = 1;
    return stretch;
}

Frame stretched(const Frame& frame, const Stretch& stretch) {
    Frame after = frame;
    after.middle = stretch(frame.middle);
    after.half = frame.half.cwiseProduct(stretch.factors);
    return after;
}

}  // namespace sulfurchamber
