#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/timestep.hpp>
#include <string>

namespace atlax {

namespace {

void requireRate(int rateHz) {
    if (rateHz < FixedTimestep::minRateHz || rateHz > FixedTimestep::maxRateHz)
        throw Error("a tick rate of " + std::to_string(rateHz) + " Hz is outside of " +
                    std::to_string(FixedTimestep::minRateHz) + " to " +
                    std::to_string(FixedTimestep::maxRateHz));
}

}  // namespace

FixedTimestep::FixedTimestep(int rateHz) : rateHz_(rateHz) {
    requireRate(rateHz);
}

void FixedTimestep::setRateHz(int rateHz) {
    requireRate(rateHz);
    rateHz_ = rateHz;  // units_ is a fraction of a tick, so it needs no conversion
    lostUnits_ = 0;
}

void FixedTimestep::setSpeedPermille(int permille) {
    speedPermille_ = std::clamp(permille, 1, 10'000);
    lostUnits_ = 0;
}

void FixedTimestep::advance(std::int64_t nowNs) {
    if (!started_) {
        started_ = true;
        lastNs_ = nowNs;
        return;
    }
    const std::int64_t elapsed = std::max<std::int64_t>(nowNs - lastNs_, 0);
    lastNs_ = nowNs;
    measureOverload(elapsed);
    if (paused_) return;
    const std::int64_t counted = std::min(elapsed, maxAdvanceNs);
    if (elapsed > counted) lose(elapsed - counted);
    // At most 2.5e8 ns * 1e4 Hz * 1e4 permille = 2.5e16: far from the limit of 64 bits.
    units_ += counted * rateHz_ * speedPermille_;
}

bool FixedTimestep::takeTick() {
    return takeTicks(1) == 1;
}

std::int64_t FixedTimestep::takeTicks(std::int64_t most) {
    const std::int64_t taken = std::clamp<std::int64_t>(most, 0, due());
    if (paused_)
        singles_ -= taken;
    else
        units_ -= taken * unitsPerTick;
    ticks_ += static_cast<std::uint64_t>(taken);
    return taken;
}

std::int64_t FixedTimestep::due() const {
    return paused_ ? singles_ : units_ / unitsPerTick;
}

void FixedTimestep::giveUp() {
    if (paused_) return;
    const std::int64_t dropped = units_ / unitsPerTick * unitsPerTick;
    if (dropped == 0) return;
    units_ -= dropped;
    // The remainder waits for the next time, so that days of overload are not rounded away.
    lostUnits_ += dropped;
    const std::int64_t unitsPerNs = std::int64_t{rateHz_} * speedPermille_;
    lose(lostUnits_ / unitsPerNs);
    lostUnits_ %= unitsPerNs;
}

double FixedTimestep::alpha() const {
    // Backlog that was not taken yet must not draw beyond the next tick.
    return static_cast<double>(units_ % unitsPerTick) / static_cast<double>(unitsPerTick);
}

void FixedTimestep::singleTick() {
    if (paused_) ++singles_;
}

void FixedTimestep::setPaused(bool paused) {
    paused_ = paused;
    singles_ = 0;
}

void FixedTimestep::lose(std::int64_t ns) {
    lostNs_ += ns;
    windowLostNs_ += ns;
}

void FixedTimestep::measureOverload(std::int64_t elapsedNs) {
    constexpr std::int64_t windowLength = 1'000'000'000;
    windowNs_ += elapsedNs;
    if (windowNs_ < windowLength) return;
    overload_ = std::min(static_cast<double>(windowLostNs_) / static_cast<double>(windowNs_), 1.0);
    windowNs_ = 0;
    windowLostNs_ = 0;
}

}  // namespace atlax
