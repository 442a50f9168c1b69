#include "commands.hpp"

#include <chrono>
#include <cstdio>
#include <new>
#include <utility>

#include "fairness.hpp"
#include "fresh_check.hpp"
#include "wander.hpp"

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

/// A proof that finishes its level in this build, with the hash that it has in this build.
struct FinishingProof {
    Recording recording;
    bool holds = false;  ///< it had that hash
};

/// The proof that lies there, if it is one.
std::optional<FinishingProof> finishingProof(const std::shared_ptr<const Level>& level,
                                             const fs::path& file) {
    if (!fs::exists(file)) return std::nullopt;
    try {
        Recording proof = Recording::read(file);
        const Verdict verdict = verify(level, proof);
        proof.finalHash = verdict.hash;
        if (verdict.finished) return FinishingProof{std::move(proof), verdict.sameAsRecorded};
    } catch (const RecordingError&) {
    }
    return std::nullopt;
}

/// The same, if it holds.
std::optional<Recording> knownProof(const std::shared_ptr<const Level>& level,
                                    const fs::path& file) {
    auto proof = finishingProof(level, file);
    if (!proof || !proof->holds) return std::nullopt;
    return std::move(proof->recording);
}

/// The way that lies there, whatever version of the level it was made for. One that is damaged is
/// told and counts as none.
std::optional<WayFile> knownWay(const fs::path& file) {
    if (!fs::exists(file)) return std::nullopt;
    try {
        return WayFile::read(file);
    } catch (const WayError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return std::nullopt;
    }
}

/// The same if it was made for the level as it is now.
std::optional<WayFile> fittingWay(const Level& level, const fs::path& file) {
    auto way = knownWay(file);
    if (way && way->levelHash != level.contentHash) way.reset();
    return way;
}

void printSurvival(const Survival& survival) {
    std::printf("robust bot: %d of %d games finished (%.1f %%), median %.0f lives, %.1f s\n",
                survival.finished, survival.games, 100 * survival.share(), survival.tries,
                survival.seconds);
}

/// Writes the proof, and the way unless `known` survives more.
void keep(const SolverArguments& arguments, const std::string& file, const Ground& ground,
          const std::optional<WayFile>& known, Solution& solution) {
    if (!acceptedByFreshProcess(file, solution.proof)) {
        throw std::runtime_error("the way that was found does not replay in a fresh process");
    }
    const fs::path proof = proofFile(arguments, file);
    solution.proof.write(proof);
    std::printf("%s  %.3f s, replayed by a fresh process, after %.0f simulated s in all\n",
                proof.string().c_str(), secondsOf(solution.proof.ticks()), solution.simulated);
    if (solution.survival.games > 0) printSurvival(solution.survival);
    if (known && known->survival.share() > solution.survival.share()) return;
    if (solution.policy.places().empty()) return;
    WayFile way{ground.level->id, ground.level->contentHash, solution.searched, solution.survival,
                std::move(solution.policy)};
    way.write(wayFile(arguments, file));
}

int solveLevel(const SolverArguments& arguments, const std::string& file) {
    const Ground ground(load(file));
    auto known = knownWay(wayFile(arguments, file));
    auto proof = knownProof(ground.level, proofFile(arguments, file));
    SolveOptions options = arguments.solve;
    options.proven = [&](const Recording& first) {
        if (!proof && acceptedByFreshProcess(file, first)) first.write(proofFile(arguments, file));
    };
    const bool begins = known && !arguments.fresh;
    Solution solution =
        begins ? solve(ground, options, &known->policy, proof) : solve(ground, options, nullptr);
    if (known && solution.searched == 0) solution.searched = known->searched;
    // What was measured in another version of the level, or of the physics, is worth nothing.
    if (known && (!proof || known->levelHash != ground.level->contentHash)) known.reset();
    if (proof && proof->ticks() < solution.proof.ticks()) solution.proof = std::move(*proof);
    keep(arguments, file, ground, known, solution);
    return 0;
}

int playBot(const SolverArguments& arguments, const std::string& file) {
    const Ground ground(load(file));
    auto known = fittingWay(*ground.level, wayFile(arguments, file));
    if (!known) {
        throw std::runtime_error(wayFile(arguments, file).string() +
                                 " is missing or was made for another version of the level");
    }
    BotOptions bot;
    bot.skill = arguments.solve.skill;
    bot.seed = arguments.solve.seed;
    std::printf("%s  skill %d  ", ground.level->id.c_str(), arguments.skill);
    known->survival =
        measureSurvival(ground, known->policy, bot, arguments.bot, arguments.solve.jobs);
    printSurvival(known->survival);
    std::fflush(stdout);
    if (arguments.keep) known->write(wayFile(arguments, file));
    return 0;
}

/// Mends what does not hold any more, beginning with what is known. A proof that finishes all the
/// same only gets another hash; the survival of its way is that of another physics.
int repairLevel(const SolverArguments& arguments, const std::string& file) {
    const auto level = load(file);
    const auto proof = finishingProof(level, proofFile(arguments, file));
    auto way = fittingWay(*level, wayFile(arguments, file));
    if (!proof || !way) return solveLevel(arguments, file);
    if (!proof->holds) {
        if (!acceptedByFreshProcess(file, proof->recording)) return solveLevel(arguments, file);
        way->survival = {};
        proof->recording.write(proofFile(arguments, file));
        way->write(wayFile(arguments, file));
    }
    std::printf("%s  %s, %.3f s\n", level->id.c_str(),
                proof->holds ? "holds" : "finishes as before", secondsOf(proof->recording.ticks()));
    return 0;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One line of the table; a level without a proof that holds makes it fail.
int printRow(const SolverArguments& arguments, const std::string& file) {
    const auto start = std::chrono::steady_clock::now();
    const auto level = load(file);
    const Session session(level);
    const double loading = secondsSince(start);
    std::printf("%-22s %6.1f", level->id.c_str(), level->medals.gold);
    const auto way = fittingWay(*level, wayFile(arguments, file));
    if (way) {
        std::printf(" %8.0f", way->searched);
    } else {
        std::printf("        -");
    }
    std::printf(" %7.1f", DistanceField(session).at(level->spawn));
    if (way && way->survival.games > 0) {
        std::printf(" %8.1f %5.0f", 100 * way->survival.share(), way->survival.tries);
    } else {
        std::printf("        -     -");
    }
    const auto replay = std::chrono::steady_clock::now();
    const auto proof = knownProof(level, proofFile(arguments, file));
    if (proof) {
        const double length = secondsOf(proof->ticks());
        std::printf(" %8.2f %7.0f", length, length / secondsSince(replay));
    } else {
        std::printf("     none       -");
    }
    std::printf(" %6.2f\n", loading);
    std::fflush(stdout);
    return proof ? 0 : 1;
}

int checkFair(const SolverArguments& arguments, const std::string& file) {
    const Ground ground(load(file));
    const auto way = fittingWay(*ground.level, wayFile(arguments, file));
    FairOptions options;
    options.states = arguments.fair;
    options.seed = arguments.solve.seed;
    options.jobs = arguments.solve.jobs;
    const FairReport report = checkFairness(ground, way ? &way->policy : nullptr, options);
    std::printf("%s  %d resting states: %d with a way on, %d die within 10 s, %zu stuck\n",
                ground.level->id.c_str(), arguments.fair, report.goOn, report.die,
                report.stuck.size());
    for (const sulfur::Point& place : report.stuck) {
        std::printf("    stuck at %.2f %.2f\n", place.x(), place.y());
    }
    return report.stuck.empty() ? 0 : 1;
}

/// Random play; inputs that lead to a fault are kept beside the level.
int wanderAbout(const SolverArguments& arguments, const std::string& file) {
    const auto level = load(file);
    const auto proof = knownProof(level, proofFile(arguments, file));
    if (!proof) throw std::runtime_error(file + " has no proof that holds, from which to wander");
    WanderOptions options;
    options.seconds = 3600 * arguments.wander;
    options.seed = arguments.solve.seed;
    options.jobs = arguments.solve.jobs;
    const WanderReport report = wander(level, *proof, options);
    std::printf("%s  %d trips, %.3f h: %d deaths, %d times at the exit, %zu faults\n",
                level->id.c_str(), report.trips, report.simulated / 3600, report.deaths,
                report.finishes, report.faults.size());
    int number = 0;
    for (const WanderFault& fault : report.faults) {
        fs::path kept = arguments.out.empty() ? fs::path(file) : fs::path(arguments.out);
        kept.replace_extension(".wander" + std::to_string(++number));
        fault.recording.write(kept);
        std::printf("    %s: after %.3f s %s\n", kept.string().c_str(),
                    secondsOf(fault.recording.ticks()), fault.what.c_str());
    }
    std::fflush(stdout);
    return report.faults.empty() ? 0 : 1;
}

int runOne(const SolverArguments& arguments, const std::string& file) {
    if (!arguments.check.empty()) return checkProof(arguments, file);
    if (arguments.table) return printRow(arguments, file);
    if (arguments.fair > 0) return checkFair(arguments, file);
    if (arguments.wander > 0) return wanderAbout(arguments, file);
    if (arguments.bot > 0) return playBot(arguments, file);
    if (arguments.repair) return repairLevel(arguments, file);
    return solveLevel(arguments, file);
}

}  // namespace

int runSolver(const SolverArguments& arguments) {
    int status = 0;
    if (arguments.table) {
        std::printf(
            "level                    gold  first/s  length survival lives  proof/s   speed  "
            "load\n");
    }
    for (const std::string& file : arguments.levels) {
        try {
            status = std::max(status, runOne(arguments, file));
        } catch (const std::bad_alloc&) {
            throw;  // the next one would fare no better
        } catch (const std::exception& error) {
            std::fprintf(stderr, "quaoar_solve: %s\n", error.what());
            status = 1;
        }
    }
    return status;
}

}  // namespace quaoar
