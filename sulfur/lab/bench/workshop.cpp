#include "bench/workshop.hpp"

#include <cmath>
#include <numbers>

namespace sulfur::lab::bench {

namespace {

/// A direction in the frame of a body.
Point turnedBack(const Motion& motion, const Point& direction) {
    return Motion{.place = {0, 0}, .angle = -motion.angle}.at(direction);
}

}  // namespace

Point Anchors::gap(const EngineWorld& world) const {
    return world.body(b).at(onB) - world.body(a).at(onA);
}

double Anchors::opening(const EngineWorld& world) const {
    const Point apart = gap(world);
    if (axis.isZero()) return apart.norm();
    return std::abs(cross(axis, turnedBack(world.body(a), apart)));
}

double Anchors::slid(const EngineWorld& world) const {
    return axis.dot(turnedBack(world.body(a), gap(world)));
}

double Anchors::value(const EngineWorld& world) const {
    const double now = world.body(b).angle - world.body(a).angle - angle;
    return std::remainder(now, 2 * std::numbers::pi);
}

std::size_t Workshop::add(const BodyPlan& plan) {
    world_.addBody(plan);
    plans_.push_back(plan);
    return plans_.size() - 1;
}

std::size_t Workshop::addNail(const Point& place) {
    return add({.parts = {disc(0.05)}, .mover = Mover::nobody, .place = place, .group = 1});
}

std::size_t Workshop::join(const JointPlan& plan) {
    const Motion a = world_.body(plan.a), b = world_.body(plan.b);
    const bool slides = plan.kind == JointPlan::Kind::slider || plan.kind == JointPlan::Kind::wheel;
    const Point onB = plan.kind == JointPlan::Kind::distance ? plan.atB : plan.at;
    anchors_.push_back({.a = plan.a,
                        .b = plan.b,
                        .onA = turnedBack(a, plan.at - a.place),
                        .onB = turnedBack(b, onB - b.place),
                        .angle = b.angle - a.angle,
                        .axis = slides ? turnedBack(a, plan.axis) : Point(0, 0)});
    joints_.push_back(plan);
    world_.addJoint(plan, plans_[plan.a], plans_[plan.b]);
    return anchors_.size() - 1;
}

}  // namespace sulfur::lab::bench
