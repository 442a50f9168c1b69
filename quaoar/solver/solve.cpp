#include "solve.hpp"

#include <algorithm>
#include <cstdio>

#include "workers.hpp"

namespace quaoar {
namespace {

double secondsOf(std::uint64_t ticks) {
    return static_cast<double>(ticks) / Session::tickRate;
}

/// A search with the session that it works in.
struct Effort {
    std::unique_ptr<Session> session;
    std::unique_ptr<Search> search;
    std::optional<Way> way;
};

std::vector<Effort> beginEfforts(const Ground& ground, const SolveOptions& options) {
    std::vector<Effort> efforts(static_cast<std::size_t>(options.searches));
    for (std::size_t i = 0; i < efforts.size(); ++i) {
        efforts[i].session = std::make_unique<Session>(ground.level);
        SearchOptions search;
        search.seed = options.seed + i;
        search.budget = options.budget;
        efforts[i].search = std::make_unique<Search>(*efforts[i].session, ground.field, search);
    }
    return efforts;
}

void reportEfforts(const std::vector<Effort>& efforts, std::uint64_t seed) {
    for (const Effort& effort : efforts) {
        const SearchReport& report = effort.search->report();
        std::printf("seed %llu: %s after %.0f simulated s, %zu cells",
                    static_cast<unsigned long long>(seed++), effort.way ? "a way" : "none",
                    report.simulated, report.cells);
        if (effort.way) {
            std::printf(", %.2f s long\n", secondsOf(effort.way->ticks));
        } else {
            std::printf(", %.2f m short of the exit\n", report.nearest);
        }
    }
    std::fflush(stdout);
}

}  // namespace

std::vector<Way> searchWays(const Ground& ground, const SolveOptions& options, Solution& solution) {
    if (ground.field.at(ground.level->spawn) >= DistanceField::unreachable) {
        throw std::runtime_error(ground.level->id +
                                 ": no free space leads from the spawn to the exit");
    }
    std::vector<Effort> efforts = beginEfforts(ground, options);
    std::size_t found = 0;
    for (double until = 200; found * 2 < efforts.size(); until *= 1.5) {
        share(options.jobs, options.searches, [&] {
            return [&](int i) {
                Effort& effort = efforts[static_cast<std::size_t>(i)];
                if (!effort.way) effort.way = effort.search->run(until);
            };
        });
        found = static_cast<std::size_t>(std::count_if(
            efforts.begin(), efforts.end(), [](const Effort& e) { return e.way.has_value(); }));
        if (until > options.budget) break;
    }
    if (!options.quiet) reportEfforts(efforts, options.seed);
    std::vector<Way> ways;
    double first = options.budget;
    for (const Effort& effort : efforts) {
        solution.simulated += effort.search->report().simulated;
        if (!effort.way) continue;
        first = std::min(first, effort.search->report().simulated);
        ways.push_back(*effort.way);
    }
    solution.searched = first;
    std::sort(ways.begin(), ways.end(),
              [](const Way& a, const Way& b) { return a.ticks < b.ticks; });
    return ways;
}

std::optional<Recording> record(const std::shared_ptr<const Level>& level, const Way& way) {
    Session session(level);
    Recording recording(*level);
    Player player(session, &recording);
    for (const Step& step : way.steps) {
        const Ending ending = player.carryOut(step.intention);
        if (ending == Ending::done) continue;
        if (ending != Ending::finished) return std::nullopt;
        recording.finalHash = session.hash();
        return recording;
    }
    return std::nullopt;
}

std::optional<Recording> record(const Ground& ground, const Policy& policy) {
    Session session(ground.level);
    Recording recording(*ground.level);
    BotOptions bot;
    bot.skill = Skill::perfect();
    bot.tries = 1;
    bot.recording = &recording;
    if (!playGame(session, ground, policy, bot).finished) return std::nullopt;
    recording.finalHash = session.hash();
    return recording;
}

namespace {

void practise(const Ground& ground, const SolveOptions& options, Solution& solution) {
    PracticeOptions practice;
    practice.skill = options.skill;
    practice.seed = options.seed;
    practice.jobs = options.jobs;
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

void keepShorter(std::optional<Recording>& best, std::optional<Recording> other) {
    if (other && (!best || other->ticks() < best->ticks())) best = std::move(other);
}

}  // namespace

Solution solve(const Ground& ground, const SolveOptions& options, const Policy* known) {
    Solution solution;
    std::optional<Recording> proof;
    if (known != nullptr) {
        solution.policy = *known;
        proof = record(ground, *known);
    }
    if (!proof) {
        const std::vector<Way> ways = searchWays(ground, options, solution);
        Session session(ground.level);
        for (const Way& way : ways) {
            keepShorter(proof, record(ground.level, way));
            learnWay(solution.policy, session, way);
        }
        if (!proof) throw std::runtime_error(ground.level->id + ": no way was found");
    }
    if (options.rounds > 0) {
        practise(ground, options, solution);
        keepShorter(proof, record(ground, solution.policy));
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
