// What counts as slow in a world.
#pragma once

#include <algorithm>
#include <cmath>
#include <sulfur/world.hpp>

#include "core/settings.hpp"

namespace sulfur::detail {

/// m/s; see core/settings.hpp, where the values for ordinary gravity are.
struct SlowSpeeds {
    Real creep = 0, restingPush = 0, settledChange = 0, sticking = 0, rebound = 0, vain = 0,
         wild = 0;
};

/// In what proportion speeds count as slow under a gravity of so many m/s^2. What is thrown up
/// slower than v takes 2 v / g to be as fast again, and that time must stay far below the one after
/// which it falls asleep. Without gravity nothing turns around.
inline double slownessUnder(double gravity) {
    using tuned::leastGravity, tuned::mostGravity;
    if (gravity == 0) return 1;
    return gravity / std::clamp(gravity, leastGravity, mostGravity);
}

inline SlowSpeeds slowSpeedsOf(const WorldSettings& settings) {
    const double slowness = slownessUnder(static_cast<double>(settings.gravity.norm()));
    const auto scaled = [&](double speed) { return static_cast<Real>(slowness * speed); };
    SlowSpeeds slow;
    slow.creep = scaled(tuned::creepSpeed);
    slow.restingPush = scaled(tuned::restingPush);
    slow.settledChange = scaled(tuned::settledChange);
    slow.sticking = scaled(tuned::stickingSpeed);
    slow.rebound = settings.reboundSpeed.value_or(scaled(tuned::slowestRebound));
    slow.wild = scaled(tuned::wildChange);
    slow.vain = scaled(tuned::vainSpeed);
    return slow;
}

/// m/s: what is slower for long enough falls asleep, of a body on which so much of gravity acts.
inline double restingSpeedUnder(const WorldSettings& settings, Real gravityScale, bool damped) {
    if (settings.sleepSpeed) return static_cast<double>(*settings.sleepSpeed);
    const double all = static_cast<double>(settings.gravity.norm());
    const double own = static_cast<double>(std::abs(gravityScale)) * all;
    const bool drifts = own == 0 && !damped && settings.airFriction == 0;
    const double slowness =
        drifts ? tuned::driftingShare : std::min(slownessUnder(all), slownessUnder(own));
    return slowness * tuned::restingSpeed;
}

}  // namespace sulfur::detail
