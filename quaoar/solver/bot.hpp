// A player with a human's faults, who knows what a policy knows.
#pragma once

#include <vector>

#include "policy.hpp"

namespace quaoar {

struct BotOptions {
    Skill skill;
    std::uint64_t seed = 1;
    int tries = 3;         ///< lives from the spawn, and from each checkpoint
    double patience = 10;  ///< s without coming nearer to the exit: as bad as a fall
    /// Keep snapshots of decisions that were not foreseen, and of those before a death.
    bool remember = false;
    Recording* recording = nullptr;  ///< for the ticks of the game; not for more than one life
};

/// So many decisions before a death count as what led to it.
constexpr std::size_t lookBack = 3;

/// One decision of a game and what came of it.
struct Decision {
    Situation before;
    std::shared_ptr<const Session::Snapshot> snapshot;
    Policy::Match match;
    int choice = -1;
    Try attempt;
};

struct PlayedGame {
    bool finished = false;
    int tries = 1;  ///< lives that were used, in all
    double seconds = 0;
    std::vector<Decision> decisions;
};

/// Plays from the spawn.
PlayedGame playGame(Session& session, const Ground& ground, const Policy& policy,
                    const BotOptions& options);

struct Survival {
    int games = 0;
    int finished = 0;
    double tries = 0;    ///< median of those that were used
    double seconds = 0;  ///< median of the games that were finished
    double share() const { return games == 0 ? 0 : static_cast<double>(finished) / games; }
};

/// `count` games with the seeds from options.seed on. Marks in `used` the places that were of use.
Survival measureSurvival(const Ground& ground, const Policy& policy, const BotOptions& options,
                         int count, int jobs, std::vector<bool>* used = nullptr);

}  // namespace quaoar
