// Finds a way through a level, makes it last, and proves it.
#pragma once

#include <functional>
#include <optional>

#include "practice.hpp"
#include "way_file.hpp"

namespace quaoar {

struct SolveOptions {
    std::uint64_t seed = 1;
    int searches = 4;       ///< with as many seeds
    double budget = 20000;  ///< simulated seconds of each
    double polish = 400;    ///< simulated seconds in which a way is made quicker
    int rounds = 4;         ///< of practice; 0: only a proof
    int games = 200;        ///< of the robust bot
    double enough = 0.95;   ///< survival at which practice ends
    Skill skill;
    int jobs = 1;
    bool quiet = false;
    /// Called with the first proof, before practice, which may take long or be broken off.
    std::function<void(const Recording&)> proven;
};

/// What was found.
struct Solution {
    Recording proof;
    Policy policy;
    Survival survival;
    double searched = 0;   ///< simulated seconds until the first way
    double simulated = 0;  ///< in all
};

/// Ways that searches with several seeds find, the shortest first. Searches go on side by side
/// until half of them have found one or all have spent their budget. Throws std::runtime_error
/// when no free space leads from the spawn to the exit, and when none is found.
std::vector<Way> searchWays(const Ground& ground, const SolveOptions& options, Solution& solution);

/// The same for ways from one place of rest to the next; none is no error.
std::vector<Way> searchSteadyWays(const Ground& ground, const SolveOptions& options,
                                  Solution& solution);

/// The ticks of a way played without slips from the spawn; nothing if that does not finish.
std::optional<Recording> record(const std::shared_ptr<const Level>& level, const Way& way);
/// The same for a policy, which may find its way from wherever it comes to.
/// The slips go by the seed, of an expert; with seed 0 nothing slips.
std::optional<Recording> record(const Ground& ground, const Policy& policy, std::uint64_t seed);
/// The shortest of so many games.
std::optional<Recording> recordBest(const Ground& ground, const Policy& policy, int games);

/// All of it. `known` is a policy to begin with, null if there is none, and `proof` one that holds:
/// with it nothing is searched, however seldom the policy finishes, unless ways are to be made
/// quicker and it misses gold.
Solution solve(const Ground& ground, const SolveOptions& options, const Policy* known,
               std::optional<Recording> proof = std::nullopt);

}  // namespace quaoar
