#pragma once

#include <cstdint>

namespace atlax {

/// Turns the irregular time of frames into ticks of one fixed length.
///
/// Pure integer arithmetic: time is counted in units of 1/(1000 * rate) nanoseconds, of which every
/// tick has exactly 10^12, so that rates which do not divide a second (60 Hz) never drift.
///
/// When the program cannot keep up, the time that it has no room for is given up and reported:
/// simulated time then runs slower than real time, while the length of a tick never changes.
///
/// The class reads no clock; the caller passes the time (nanoseconds of any monotonic clock, also
/// of a FakeClock), so tests run days in milliseconds. A plain value that owns nothing else; one
/// thread. Only what is said to throws. Use:
///
///     timestep.advance(now());
///     while (timestep.takeTick()) {
///         app.tick();
///         if (now() > deadline) timestep.giveUp();
///     }
///     app.draw(canvas, timestep.alpha());
class FixedTimestep {
public:
    static constexpr int minRateHz = 60;
    static constexpr int maxRateHz = 10'000;
    /// More time than this between two calls of advance() is given up at once (a debugger, a
    /// suspended machine).
    static constexpr std::int64_t maxAdvanceNs = 250'000'000;

    /// Throws Error when the rate is outside minRateHz..maxRateHz.
    explicit FixedTimestep(int rateHz = 500);

    int rateHz() const { return rateHz_; }
    /// Length of a tick in seconds.
    double tickSeconds() const { return 1.0 / rateHz_; }
    /// Changes the rate between two ticks; the fraction of a tick that has passed is kept.
    void setRateHz(int rateHz);

    /// Tells the time. The first call only sets the start. A time before the last one counts as
    /// no time passed.
    void advance(std::int64_t nowNs);

    /// True when a tick is due, and counts it as done.
    bool takeTick();

    /// Takes at most `most` of the ticks that are due, and returns how many.
    std::int64_t takeTicks(std::int64_t most);

    /// Ticks that are due now.
    std::int64_t due() const;

    /// Gives up every tick that is still due; their time is reported as lost.
    void giveUp();

    /// How far the time has gone from the last tick to the next, 0 <= alpha < 1, for drawing
    /// between the last two states.
    double alpha() const;

    /// Ticks taken since the start. Exact simulated time is ticks() / rateHz().
    std::uint64_t ticks() const { return ticks_; }

    /// A change forgets single ticks that were not taken. Time in the pause is not lost time.
    void setPaused(bool paused);
    bool paused() const { return paused_; }
    /// Makes one tick due although the clock is paused; adds up when called again. Without a
    /// pause it does nothing.
    void singleTick();

    /// Speed of simulated time in thousandths of real time: 1000 is real time, 250 is slow motion
    /// by four. Clamped to 1..10000. Slow motion loses no time: fewer ticks become due.
    void setSpeedPermille(int permille);
    int speedPermille() const { return speedPermille_; }

    /// Real time given up since the start, nanoseconds. Nothing is rounded away: at an unchanged
    /// rate and speed, ticks taken, ticks due, the fraction of a tick and this add up to the time
    /// that has passed, within one nanosecond over any number of days.
    std::int64_t lostNs() const { return lostNs_; }
    /// Share of real time given up over about the last second: 0 keeps up, 0.25 means that
    /// simulated time runs a quarter slower than it should.
    double overload() const { return overload_; }

private:
    static constexpr std::int64_t unitsPerTick = 1'000'000'000'000;

    void lose(std::int64_t ns);
    void measureOverload(std::int64_t elapsedNs);

    int rateHz_ = 500;
    int speedPermille_ = 1000;
    bool paused_ = false;
    bool started_ = false;
    std::int64_t lastNs_ = 0;
    std::int64_t units_ = 0;
    std::int64_t singles_ = 0;
    std::uint64_t ticks_ = 0;
    std::int64_t lostNs_ = 0;
    std::int64_t lostUnits_ = 0;  ///< given up, but less than a nanosecond
    std::int64_t windowNs_ = 0;
    std::int64_t windowLostNs_ = 0;
    double overload_ = 0;
};

/// A clock that goes only when it is told to, for tests and for replays faster than time. Starts at
/// 0. A plain value; one thread. Hand `[&] { return clock.now(); }` to whoever wants a clock.
class FakeClock {
public:
    /// Nanoseconds.
    std::int64_t now() const { return now_; }
    /// Lets so many nanoseconds pass; negative ones turn it back, which a real one never does.
    void advance(std::int64_t ns) { now_ += ns; }

private:
    std::int64_t now_ = 0;
};

}  // namespace atlax
