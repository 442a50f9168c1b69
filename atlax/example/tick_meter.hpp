#pragma once

#include <atlax/platform.hpp>
#include <cstdint>
#include <string>

/// Measures how well ticks keep to real time. Told of every frame, between its ticks and its
/// drawing, it compares the simulated time, with the fraction of a tick, to the monotonic clock.
class TickMeter {
public:
    /// `seconds` of real time are measured after half a second in which everything settles.
    explicit TickMeter(double seconds) : seconds_(seconds) {}

    /// True when the measurement is complete.
    bool frame(const atlax::FixedTimestep& clock, double alpha);

    /// One line with the rate that was asked for, what was held, and what the frames did.
    std::string report(const atlax::FixedTimestep& clock) const;

private:
    double seconds_;
    std::int64_t firstFrameNs_ = 0;
    std::int64_t startNs_ = 0;
    std::int64_t lastNs_ = 0;
    double startTicks_ = 0;
    double ticks_ = 0;
    std::int64_t startLostNs_ = 0;
    std::int64_t longestNs_ = 0;
    int frames_ = 0;
};
