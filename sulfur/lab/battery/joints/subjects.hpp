// Who runs the scenes of joints: ours at several rates, and Box2D 3.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "battery/row.hpp"
#include "bench/engine.hpp"
#include "bench/workshop.hpp"

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

using bench::Anchors;
using bench::Workshop;

}  // namespace sulfur::lab
