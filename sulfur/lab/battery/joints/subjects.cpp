#include "battery/joints/subjects.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace sulfur::lab {

using bench::BodyPlan;
using bench::EngineWorld;
using bench::JointPlan;

namespace {

/// In the frame of a body.
Point localOf(const bench::Motion& motion, const Point& place) {
    return bench::Motion{.place = {0, 0}, .angle = -motion.angle}.at(place - motion.place);
}

}  // namespace

std::string JointSubject::label() const {
    return ours ? fmt::format("{} Hz", setting.rate)
                : fmt::format("Box2D 3 at {} Hz x {}", setting.rate, setting.iterations);
}

std::unique_ptr<EngineWorld> JointSubject::world(bool weightless) const {
    bench::Setting own = setting;
    own.weightless = weightless;
    return bench::engineOf(setting.engine).make(own);
}

Row JointSubject::row(const std::string& what, double measured, double bound) const {
    const std::string name = label() + ": " + what;
    return ours && std::isfinite(bound) ? atMost(name, measured, bound) : reported(name, measured);
}

long JointSubject::ticks(double seconds) const {
    return std::lround(seconds * setting.rate);
}

double JointSubject::step() const {
    const int steps = ours ? (479 + setting.rate) / setting.rate : setting.iterations;
    return 1.0 / setting.rate / steps;
}

std::vector<int> jointRates() {
    return {500, 240, 120, 60};
}

std::vector<JointSubject> jointSubjects(const Setup& setup) {
    constexpr int substeps = 4;
    std::vector<JointSubject> all;
    for (const int rate : jointRates()) {
        all.push_back({{.engine = "sulfur", .rate = rate, .iterations = setup.sweeps}, true});
        if (bench::engineOf("box2d3").found())
            all.push_back({{.engine = "box2d3", .rate = rate, .iterations = substeps}, false});
    }
    return all;
}

Point Anchors::gap(const EngineWorld& world) const {
    return world.body(b).at(onB) - world.body(a).at(onA);
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
    return add(
        {.parts = {bench::disc(0.05)}, .mover = bench::Mover::nobody, .place = place, .group = 1});
}

std::size_t Workshop::join(const JointPlan& plan) {
    const bench::Motion a = world_.body(plan.a), b = world_.body(plan.b);
    anchors_.push_back(
        {plan.a, plan.b, localOf(a, plan.at), localOf(b, plan.at), b.angle - a.angle});
    world_.addJoint(plan, plans_[plan.a], plans_[plan.b]);
    return anchors_.size() - 1;
}

}  // namespace sulfur::lab
