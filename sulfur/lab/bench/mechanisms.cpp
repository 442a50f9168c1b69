#include "bench/mechanisms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bench/spread.hpp"

namespace sulfur::lab::bench {

namespace {

constexpr Variant mechanisms[] = {
    {"car", cars},       {"doohickey", doohickeys},     {"ragdoll", ragdollHeap},
    {"door", doors},     {"scissor-lift", scissorLift}, {"gear-lift", gearLift},
    {"driving", driving}};

}  // namespace

double beyond(const JointPlan& plan, double value) {
    const double below = plan.lower ? *plan.lower - value : 0;
    const double above = plan.upper ? value - *plan.upper : 0;
    return std::max({0.0, below, above});
}

double worse(double sofar, double now) {
    return now <= sofar || std::isnan(sofar) ? sofar : now;
}

void Contraption::begin(EngineWorld& world) {
    build(workshop_.emplace(world));
    energy_ = energy(world);
}

/// J, of what moves: of its motion and its height.
double Contraption::energy(const EngineWorld& world) const {
    double sum = 0;
    for (std::size_t i = 0; i < workshop_->bodies(); ++i) {
        const BodyPlan& plan = workshop_->plan(i);
        if (plan.mover != Mover::physics) continue;
        const Motion now = world.body(i);
        sum += plan.mass() * (now.velocity.squaredNorm() / 2 + weight() * now.place.y()) +
               world.inertia(i, plan) * now.spin * now.spin / 2;
    }
    return sum;
}

void Contraption::look(const EngineWorld& world, double time) {
    using enum JointPlan::Kind;
    for (std::size_t i = 0; i < workshop_->joints(); ++i) {
        const JointPlan& plan = workshop_->joint(i);
        const Anchors& anchors = workshop_->anchors(i);
        if (plan.kind == distance) {
            const double length = anchors.gap(world).norm();
            beyondWay_ = worse(beyondWay_, beyond(plan, length));
            continue;
        }
        const double opening = anchors.opening(world);
        opening_ = worse(opening_, opening);
        openings_ += opening;
        ++looks_;
        if (plan.kind == hinge)
            beyondAngle_ = worse(beyondAngle_, beyond(plan, anchors.value(world)));
        else
            beyondWay_ = worse(beyondWay_, beyond(plan, anchors.slid(world)));
    }
    note(world, time);
}

Figures Contraption::figures(const EngineWorld& world) {
    Figures all{{"max opening", "mm", opening_ * millimetres},
                {"mean opening", "mm", openings_ / std::max(1.0, looks_) * millimetres},
                {"beyond a limit", "deg", beyondAngle_ * 180 / std::numbers::pi},
                {"slid beyond one", "mm", beyondWay_ * millimetres},
                {"energy gained", "J", energy(world) - energy_}};
    for (Figure& figure : more(world)) all.push_back(std::move(figure));
    return all;
}

BodyPlan road(const std::vector<Point>& line, double friction) {
    constexpr double radius = 0.1;  // m
    BodyPlan plan;
    plan.mover = Mover::nobody;
    plan.friction = friction;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        plan.parts.push_back(
            capsule(line[i] - Point(0, radius), line[i + 1] - Point(0, radius), radius));
    return plan;
}

Point centre(std::vector<Point>& corners) {
    double area = 0;
    Point sum(0, 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &p = corners[i], &q = corners[(i + 1) % corners.size()];
        const double part = cross(p, q) / 2;
        area += part;
        sum += part / 3 * (p + q);
    }
    const Point middle = sum / area;
    for (Point& p : corners) p -= middle;
    return middle;
}

const std::vector<std::string>& mechanismNames() {
    static const std::vector<std::string> names = namesOf(mechanisms);
    return names;
}

Scene mechanism(const std::string& name, Extent extent) {
    return variantOf("S9", Feature::joints, "max opening", mechanisms, name, extent);
}

}  // namespace sulfur::lab::bench
