// A car on wheels with springs over half discs.
#include <cmath>

#include "battery/joints/joints.hpp"
#include "battery/joints/subjects.hpp"
#include "battery/measure.hpp"

namespace sulfur::lab {

namespace {

using bench::JointPlan;

constexpr double carWheel = 0.4, carSpeed = 5;  // m, m/s

/// Drives it for some seconds on a flat floor, then over bumps of 0.1 m.
class BumpyDrive {
public:
    explicit BumpyDrive(const JointSubject& subject)
        : subject_(subject), world_(subject.world(false)), workshop_(*world_) {
        workshop_.add({.parts = {bench::rectangle({100, 1})},
                       .mover = bench::Mover::nobody,
                       .place = {80, -1}});
        for (int i = 0; i < 12; ++i)
            workshop_.add({.parts = {bench::disc(0.3)},
                           .mover = bench::Mover::nobody,
                           .place = {20 + 2.5 * i, -0.2}});
        chassis_ = workshop_.add({.parts = {bench::rectangle({1.2, 0.25})},
                                  .place = {0, carWheel + 0.4},
                                  .density = 100,
                                  .group = 1});
        for (const double x : {-0.9, 0.9}) {
            const auto wheel = workshop_.add({.parts = {bench::disc(carWheel)},
                                              .place = {x, carWheel},
                                              .density = 40,
                                              .friction = 0.9,
                                              .group = 1});
            axles_.push_back(workshop_.join({.kind = JointPlan::Kind::wheel,
                                             .a = chassis_,
                                             .b = wheel,
                                             .at = {x, carWheel},
                                             .axis = {0, 1},
                                             .lower = -0.25,
                                             .upper = 0.25,
                                             .motorSpeed = -carSpeed / carWheel,
                                             .motorMax = 200,
                                             .hertz = 4,
                                             .dampingRatio = 0.7}));
        }
    }

    Rows run() {
        double off = 0, beyond = 0, steady = unmeasured;
        for (long i = 0; i < subject_.ticks(12); ++i) {
            world_->step();
            const bench::Motion car = world_->body(chassis_);
            const Point along(-std::sin(car.angle), std::cos(car.angle));
            for (const std::size_t axle : axles_) {
                const Point gap = workshop_.anchors(axle).gap(*world_);
                off = worst(off, std::abs(gap.x() * along.y() - gap.y() * along.x()));
                beyond = worst(beyond, std::abs(gap.dot(along)) - 0.25);
            }
            if (i == subject_.ticks(3)) steady = std::abs(car.velocity.x() / carSpeed - 1);
        }
        const double reached = world_->body(chassis_).place.x();
        return {subject_.row("car on the flat: error of its speed (share)", steady, 0.005),
                subject_.row("car over bumps: a wheel off its axis (m)", off, 1e-3),
                subject_.row("car over bumps: a spring beyond its end (m)", std::max(0.0, beyond),
                             1e-3),
                subject_.row("car over bumps: short of 50 m in 12 s (m)",
                             std::max(0.0, 50 - reached), 0)};
    }

private:
    JointSubject subject_;
    std::unique_ptr<bench::EngineWorld> world_;
    Workshop workshop_;
    std::size_t chassis_ = 0;
    std::vector<std::size_t> axles_;
};

}  // namespace

Rows bumps(const Setup& setup) {
    Rows rows;
    for (const JointSubject& subject : jointSubjects(setup))
        for (Row& row : BumpyDrive(subject).run()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
