#include "tick_meter.hpp"

#include <algorithm>
#include <atlax/backend.hpp>
#include <cstdio>

namespace {

constexpr std::int64_t settlingNs = 500'000'000;

}  // namespace

bool TickMeter::frame(const atlax::FixedTimestep& clock, double alpha) {
    const std::int64_t now = atlax::monotonicNs();
    if (firstFrameNs_ == 0) firstFrameNs_ = now;
    if (now - firstFrameNs_ < settlingNs) return false;
    ticks_ = static_cast<double>(clock.ticks()) + alpha;
    if (startNs_ == 0) {
        startNs_ = lastNs_ = now;
        startTicks_ = ticks_;
        startLostNs_ = clock.lostNs();
        return false;
    }
    longestNs_ = std::max(longestNs_, now - lastNs_);
    lastNs_ = now;
    ++frames_;
    return static_cast<double>(now - startNs_) * 1e-9 >= seconds_;
}

std::string TickMeter::report(const atlax::FixedTimestep& clock) const {
    const double elapsed = static_cast<double>(lastNs_ - startNs_) * 1e-9;
    const double wanted = elapsed * clock.rateHz();
    const double made = ticks_ - startTicks_;
    char line[256];
    std::snprintf(line, sizeof(line),
                  "%d Hz for %.3f s: %.1f ticks of %.1f, deviation %+.5f %%, given up %.3f ms, "
                  "%.1f frames/s, longest frame %.1f ms",
                  clock.rateHz(), elapsed, made, wanted, (made / wanted - 1) * 100,
                  static_cast<double>(clock.lostNs() - startLostNs_) * 1e-6,
                  static_cast<double>(frames_) / elapsed, static_cast<double>(longestNs_) * 1e-6);
    return line;
}
