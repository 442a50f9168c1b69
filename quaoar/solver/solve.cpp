#include "solve.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "shorten.hpp"
#include "steady_search.hpp"
#include "workers.hpp"

namespace quaoar {
namespace {

/// Simulated seconds of a search for a steady way, which is a help and no need.
constexpr double steadyBudget = 6000;

/// A search of either kind with the session that it works in.
struct Effort {
    std::unique_ptr<Session> session;
    std::unique_ptr<Explorer> search;
    std::optional<Way> way;
};

using Begin = std::function<std::unique_ptr<Explorer>(Session& session, std::uint64_t seed)>;

/// Lets searches go on side by side until half of them have found a way or all have spent their
/// budget. Stages that grow make it independent of the number of threads.
void carryOn(std::vector<Effort>& efforts, double budget, const SolveOptions& options) {
    std::size_t found = 0;
    for (double until = 200; found * 2 < efforts.size(); until *= 1.5) {
        share(options.jobs, static_cast<int>(efforts.size()), [&] {
            return [&](int i) {
                Effort& effort = efforts[static_cast<std::size_t>(i)];
                if (!effort.way) effort.way = effort.search->run(std::min(until, budget));
            };
        });
        found = static_cast<std::size_t>(std::count_if(
            efforts.begin(), efforts.end(), [](const auto& e) { return e.way.has_value(); }));
        if (until > budget) break;
        if (options.quiet) continue;
        double nearest = DistanceField::unreachable;
        for (const auto& effort : efforts) {
            nearest = std::min(nearest, effort.search->report().nearest);
        }
        std::printf("... %.0f simulated s, %zu of %zu found, %.2f m to go\n", until, found,
                    efforts.size(), nearest);
        std::fflush(stdout);
    }
}

/// Adds what was found, the shortest first.
void gather(const std::vector<Effort>& efforts, const char* kind, bool quiet, Solution& solution,
            std::vector<Way>& ways) {
    for (const Effort& effort : efforts) {
        const SearchReport& report = effort.search->report();
        solution.simulated += report.simulated;
        if (effort.way) {
            ways.push_back(*effort.way);
            const bool first = solution.searched == 0 || report.simulated < solution.searched;
            if (first) solution.searched = report.simulated;
        }
        if (quiet) continue;
        std::printf("%s: %s after %.0f simulated s, %zu cells, ", kind,
                    effort.way ? "found" : "none", report.simulated, report.cells);
        if (effort.way) {
            std::printf("%.2f s long, %zu intentions\n", secondsOf(effort.way->ticks),
                        effort.way->steps.size());
        } else {
            std::printf("%.2f m short of the exit\n", report.nearest);
        }
    }
    std::fflush(stdout);
    std::sort(ways.begin(), ways.end(),
              [](const Way& a, const Way& b) { return a.ticks < b.ticks; });
}

std::vector<Way> searchSideBySide(const Ground& ground, const char* kind, double budget,
                                  const Begin& begin, const SolveOptions& options,
                                  Solution& solution) {
    std::vector<Effort> efforts(static_cast<std::size_t>(options.searches));
    for (std::size_t i = 0; i < efforts.size(); ++i) {
        efforts[i].session = std::make_unique<Session>(ground.level);
        efforts[i].search = begin(*efforts[i].session, options.seed + i);
    }
    carryOn(efforts, budget, options);
    std::vector<Way> ways;
    gather(efforts, kind, options.quiet, solution, ways);
    return ways;
}

void keepShorter(std::optional<Recording>& best, std::optional<Recording> other) {
    if (other && (!best || other->ticks() < best->ticks())) best = std::move(other);
}

}  // namespace

std::vector<Way> searchWays(const Ground& ground, const SolveOptions& options, Solution& solution) {
    if (ground.field.at(ground.level->spawn) >= DistanceField::unreachable) {
        throw std::runtime_error(ground.level->id +
                                 ": no free space leads from the spawn to the exit");
    }
    const auto begin = [&](Session& session, std::uint64_t seed) {
        SearchOptions search;
        search.seed = seed;
        return std::make_unique<Search>(session, ground.field, search);
    };
    return searchSideBySide(ground, "way", options.budget, begin, options, solution);
}

std::vector<Way> searchSteadyWays(const Ground& ground, const SolveOptions& options,
                                  Solution& solution) {
    const auto begin = [&](Session& session, std::uint64_t seed) {
        return std::make_unique<SteadySearch>(session, ground.field, options.skill, seed);
    };
    const double budget = std::min(steadyBudget, options.budget);
    return searchSideBySide(ground, "steady way", budget, begin, options, solution);
}

std::optional<Recording> record(const std::shared_ptr<const Level>& level, const Way& way) {
    Session session(level);
    Recording recording(*level);
    Player player(session, &recording);
    for (const Intention& step : way.steps) {
        const Ending ending = player.carryOut(step);
        if (ending == Ending::done) continue;
        if (ending != Ending::finished) return std::nullopt;
        recording.finalHash = session.hash();
        return recording;
    }
    return std::nullopt;
}

std::optional<Recording> record(const Ground& ground, const Policy& policy, std::uint64_t seed) {
    Session session(ground.level);
    Recording recording(*ground.level);
    BotOptions bot;
    bot.skill = seed == 0 ? Skill::perfect() : Skill::level(5);
    bot.seed = seed;
    bot.tries = 1;
    bot.recording = &recording;
    if (!playGame(session, ground, policy, bot).finished) return std::nullopt;
    recording.finalHash = session.hash();
    return recording;
}

std::optional<Recording> recordBest(const Ground& ground, const Policy& policy, int games) {
    std::optional<Recording> best;
    for (int seed = 0; seed < games; ++seed) {
        keepShorter(best, record(ground, policy, static_cast<std::uint64_t>(seed)));
    }
    return best;
}

namespace {

void practise(const Ground& ground, const SolveOptions& options, Solution& solution) {
    PracticeOptions practice;
    practice.skill = options.skill;
    practice.seed = options.seed;
    practice.jobs = options.jobs;
    practice.games = std::min(practice.games, options.games);
    practice.studies = practice.games;
    Practice teacher(ground, solution.policy, practice);
    teacher.studyAll();
    for (int round = 1; round <= options.rounds; ++round) {
        const Survival survival = teacher.round();
        if (!options.quiet) {
            std::printf("practice %d: %d of %d games, %zu places, %.0f simulated s\n", round,
                        survival.finished, survival.games, solution.policy.places().size(),
                        teacher.simulated());
            std::fflush(stdout);
        }
        if (survival.share() >= options.enough && round >= 3) break;
    }
    solution.simulated += teacher.simulated();
}

/// The shortest that comes of two of the ways when they are shortened.
std::optional<Recording> shortenAll(const Ground& ground, const SolveOptions& options,
                                    const std::vector<Way>& ways, Solution& solution) {
    const int count = std::min(2, static_cast<int>(ways.size()));
    std::vector<std::optional<Recording>> results(static_cast<std::size_t>(count));
    forAll(ground.level, options.jobs, count, [&](int i, Session& session) {
        const auto at = static_cast<std::size_t>(i);
        results[at] =
            record(ground.level, shortened(session, ways[at], options.seed, options.polish));
    });
    solution.simulated += count * options.polish;
    std::optional<Recording> best;
    for (auto& result : results) keepShorter(best, std::move(result));
    return best;
}

}  // namespace

Solution solve(const Ground& ground, const SolveOptions& options, const Policy* known,
               std::optional<Recording> proof) {
    Solution solution;
    if (known != nullptr) {
        solution.policy = *known;
        keepShorter(proof, recordBest(ground, *known, 12));
    }
    // A proof should show that gold can be had: where a known way has become slower, it searches,
    // unless ways are not to be made quicker.
    const bool wantsGold = options.polish > 0;
    if (!proof || (wantsGold && secondsOf(proof->ticks()) > ground.level->medals.gold)) {
        const std::vector<Way> ways = searchWays(ground, options, solution);
        Session session(ground.level);
        for (const Way& way : ways) keepShorter(proof, record(ground.level, way));
        keepShorter(proof, shortenAll(ground, options, ways, solution));
        std::vector<Way> steady;
        if (options.rounds > 0) steady = searchSteadyWays(ground, options, solution);
        for (const Way& way : steady) keepShorter(proof, record(ground.level, way));
        for (const Way& way : steady.empty() ? ways : steady) {
            learnWay(solution.policy, session, way);
        }
        if (!proof) throw std::runtime_error(ground.level->id + ": no way was found");
    }
    if (options.proven) options.proven(*proof);
    if (options.rounds > 0) {
        practise(ground, options, solution);
        keepShorter(proof, recordBest(ground, solution.policy, 6));
        BotOptions bot;
        bot.skill = options.skill;
        std::vector<bool> used;
        solution.survival =
            measureSurvival(ground, solution.policy, bot, options.games, options.jobs, &used);
        solution.policy = solution.policy.reduced(used);
    }
    solution.proof = std::move(*proof);
    return solution;
}

}  // namespace quaoar
