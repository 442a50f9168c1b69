// Who runs the scenes of joints: ours at several rates, and Box2D 3.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "battery/row.hpp"
#include "bench/engine.hpp"

namespace sulfur::lab {

/// Of what nobody has seen, and of a row that tells something only.
inline constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// An engine at a rate.
struct JointSubject {
    bench::Setting setting;
    bool ours = true;

    std::string label() const;
    /// A world with or without gravity.
    std::unique_ptr<bench::EngineWorld> world(bool weightless) const;
    /// A row that has a bound for ours only.
    Row row(const std::string& what, double measured, double bound) const;
    long ticks(double seconds) const;
    double step() const;  ///< s, of which each tick has some
};

/// Ours at 500, 240, 120 and 60 Hz, each followed by Box2D 3 if it is built in.
std::vector<JointSubject> jointSubjects(const Setup& setup);
/// The rates of ours, Hz.
std::vector<int> jointRates();

/// Where a joint holds each of its bodies, in their frames.
struct Anchors {
    std::size_t a = 0, b = 0;
    Point onA{0, 0}, onB{0, 0};  ///< m
    double angle = 0;            ///< rad, of b against a, when it was made

    /// m, how far apart both places are now.
    Point gap(const bench::EngineWorld& world) const;
    /// rad, of b against a now; within half a turn where an engine does not count turns.
    double value(const bench::EngineWorld& world) const;
};

/// Bodies and joints in one world of an engine, with their plans.
class Workshop {
public:
    explicit Workshop(bench::EngineWorld& world) : world_(world) {}

    std::size_t add(const bench::BodyPlan& plan);
    /// Something fixed that touches nothing.
    std::size_t addNail(const Point& place);
    std::size_t join(const bench::JointPlan& plan);
    const Anchors& anchors(std::size_t joint) const { return anchors_[joint]; }
    const bench::BodyPlan& plan(std::size_t body) const { return plans_[body]; }

private:
    bench::EngineWorld& world_;
    std::vector<bench::BodyPlan> plans_;
    std::vector<Anchors> anchors_;
};

}  // namespace sulfur::lab
