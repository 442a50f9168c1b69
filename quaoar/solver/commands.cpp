#include "commands.hpp"

#include <chrono>
#include <cstdio>

#include "fresh_check.hpp"

namespace quaoar {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Level> load(const std::string& file) {
    return std::make_shared<const Level>(readLevel(file));
}

fs::path proofFile(const SolverArguments& arguments, const std::string& level) {
    return arguments.out.empty() ? proofOf(level) : fs::path(arguments.out);
}

fs::path wayFile(const SolverArguments& arguments, const std::string& level) {
    return wayOf(arguments.out.empty() ? fs::path(level) : fs::path(arguments.out));
}

int checkProof(const SolverArguments& arguments, const std::string& file) {
    const auto level = load(file);
    const Verdict verdict = verify(level, Recording::read(arguments.check));
    if (verdict.finished && verdict.sameAsRecorded) {
        if (!arguments.solve.quiet) {
            std::printf("%s holds: %s is finished after %.3f s\n", arguments.check.c_str(),
                        level->id.c_str(), verdict.seconds);
        }
        return 0;
    }
    std::fprintf(stderr, "%s does not hold: %s.\n", arguments.check.c_str(),
                 verdict.finished ? "the level is finished, but not as it was recorded"
                                  : "the level is not finished when it ends");
    return 1;
}

/// The proof that lies there, if it holds in this build.
std::optional<Recording> knownProof(const std::shared_ptr<const Level>& level,
                                    const fs::path& file) {
    if (!fs::exists(file)) return std::nullopt;
    try {
        Recording proof = Recording::read(file);
        const Verdict verdict = verify(level, proof);
        if (verdict.finished && verdict.sameAsRecorded) return proof;
    } catch (const RecordingError&) {
    }
    return std::nullopt;
}

/// The way that lies there, whatever version of the level it was made for.
std::optional<WayFile> knownWay(const fs::path& file) {
    if (!fs::exists(file)) return std::nullopt;
    return WayFile::read(file);
}

void printSurvival(const Survival& survival) {
    std::printf("robust bot: %d of %d games finished (%.1f %%), median %.0f lives, %.1f s\n",
                survival.finished, survival.games, 100 * survival.share(), survival.tries,
                survival.seconds);
}

void keep(const SolverArguments& arguments, const std::string& file, const Ground& ground,
          Solution& solution) {
    if (!acceptedByFreshProcess(file, solution.proof)) {
        throw std::runtime_error("the way that was found does not replay in a fresh process");
    }
    const fs::path proof = proofFile(arguments, file);
    solution.proof.write(proof);
    std::printf("%s  %.3f s, replayed by a fresh process, after %.0f simulated s in all\n",
                proof.string().c_str(),
                static_cast<double>(solution.proof.ticks()) / Session::tickRate,
                solution.simulated);
    if (solution.policy.places().empty()) return;
    WayFile way{ground.level->id, ground.level->contentHash, solution.survival,
                std::move(solution.policy)};
    way.write(wayFile(arguments, file));
    printSurvival(way.survival);
}

int solveLevel(const SolverArguments& arguments, const std::string& file) {
    const Ground ground(load(file));
    std::optional<WayFile> known;
    if (!arguments.fresh) known = knownWay(wayFile(arguments, file));
    Solution solution = solve(ground, arguments.solve, known ? &known->policy : nullptr);
    auto proof = knownProof(ground.level, proofFile(arguments, file));
    if (proof && proof->ticks() < solution.proof.ticks()) solution.proof = std::move(*proof);
    keep(arguments, file, ground, solution);
    return 0;
}

int playBot(const SolverArguments& arguments, const std::string& file) {
    const Ground ground(load(file));
    const auto known = knownWay(wayFile(arguments, file));
    if (!known) throw std::runtime_error(wayFile(arguments, file).string() + " is missing");
    BotOptions bot;
    bot.skill = arguments.solve.skill;
    bot.seed = arguments.solve.seed;
    std::printf("%s  skill %d  ", ground.level->id.c_str(), arguments.skill);
    printSurvival(measureSurvival(ground, known->policy, bot, arguments.bot, arguments.solve.jobs));
    return 0;
}

}  // namespace

int runSolver(const SolverArguments& arguments) {
    int status = 0;
    for (const std::string& file : arguments.levels) {
        if (!arguments.check.empty()) return checkProof(arguments, file);
        if (arguments.bot > 0) {
            status = std::max(status, playBot(arguments, file));
        } else {
            status = std::max(status, solveLevel(arguments, file));
        }
    }
    return status;
}

}  // namespace quaoar
