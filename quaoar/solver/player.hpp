// Carries intentions out in a session, as well as a hand can.
#pragma once

#include <atomic>
#include <quaoar/recording.hpp>
#include <quaoar/session.hpp>
#include <random>
#include <vector>

#include "intention.hpp"

namespace quaoar {

/// How well a player sees and aims. All spreads are standard deviations of normal distributions
/// that are cut off at 2.5 of them.
struct Skill {
    double reaction = 0.200;        ///< s until what was not foreseen is answered
    double reactionSpread = 0.040;  ///< s
    double aimSpread = 0.0349;      ///< rad: 2 degrees
    double timingSpread = 0.030;    ///< s, of every press and every release

    /// 1 (a beginner) to 5 (an expert); 3 is the one of the figures above.
    static Skill level(int level);
    static Skill perfect() { return {0, 0, 0, 0}; }
};

/// What goes wrong with one intention.
struct Slip {
    double aim = 0;    ///< rad
    int press = 0;     ///< ticks that the shot comes late (or early)
    int end = 0;       ///< ticks that the end comes late (or early)
    int reaction = 0;  ///< ticks before anything is done that was not foreseen
};

/// Draws slips. Not from std::normal_distribution, whose results differ between libraries.
class Nerves {
public:
    Nerves(const Skill& skill, std::uint64_t seed) : skill_(skill), random_(seed) {}
    Slip next();

private:
    double normal();
    Skill skill_;
    std::mt19937_64 random_;
};

/// Thrown out of a Player, and with it out of all that searches and practises, once the flag of
/// stopPlayersBy() is set.
struct Stopped {};

/// Players of the calling thread stop when the flag is set, which must outlive them; null: never.
/// For programs that search beside something else, in one thread.
void stopPlayersBy(const std::atomic<bool>* flag);

/// How an intention ended.
enum class Ending : std::uint8_t {
    done,      ///< as it was meant
    missed,    ///< the rope did not stick, or there was none to keep
    died,      ///< the hero is at the spawn or at a checkpoint again
    finished,  ///< at the exit
};

inline double secondsOf(std::uint64_t ticks) {
    return static_cast<double>(ticks) / Session::tickRate;
}

/// Ticks between letting go and the next shot of one who does not slip: 80 ms.
constexpr int pressGap = 40;

class Player {
public:
    /// Plays in `session` and writes down what it does in `recording`, if there is one.
    explicit Player(Session& session, Recording* recording = nullptr)
        : session_(session), recording_(recording) {}

    Ending carryOut(const Intention& intention, const Slip& slip = {});
    /// Holds what is held and does nothing else.
    Ending wait(int ticks);
    /// The hero's places after each tick of the last intention.
    const std::vector<sulfur::Point>& trace() const { return trace_; }
    /// Back to the last checkpoint, of the player's own will.
    Ending giveUp();
    /// All ticks that were played, and their seconds.
    std::uint64_t ticks() const { return ticks_; }
    double seconds() const { return secondsOf(ticks_); }

private:
    bool tick(const TickInput& input);
    bool letGo(int ticks);
    Ending shoot(const Intention& intention, const Slip& slip);
    Ending holdOn(const Intention& intention, const Slip& slip);
    std::int8_t pushOf(const Intention& intention) const;
    bool over(const Until& until, int early) const;
    Ending stopped() const;

    Session& session_;
    Recording* recording_;
    TickInput input_;
    std::vector<sulfur::Point> trace_;
    std::uint64_t ticks_ = 0;
    int calm_ = 0;  ///< ticks of rest in a row
    bool died_ = false;
};

}  // namespace quaoar
