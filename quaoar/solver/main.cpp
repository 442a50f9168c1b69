// quaoar_solve: searches for a way through a level and writes its proof.
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atlax/arguments.hpp>
#include <cstdio>
#include <filesystem>
#include <new>
#include <quaoar/recording.hpp>
#include <random>
#include <sulfur/version.hpp>

#include "search.hpp"

extern char** environ;

namespace {

using quaoar::Level;
using quaoar::Recording;

struct Arguments {
    std::string level;
    std::string out;
    std::uint64_t seed = 1;
    int tries = 1;
    double budget = 20000;
    int jitter = 40;
    std::string check;
};

/// A file in memory, which this process and those that it starts find under a name.
class MemoryFile {
public:
    explicit MemoryFile(const std::string& text) : number_(::memfd_create("proof", 0)) {
        if (::write(number_, text.data(), text.size()) == static_cast<ssize_t>(text.size())) return;
        ::close(number_);
        throw std::runtime_error("there is no memory for checking the proof");
    }
    ~MemoryFile() { ::close(number_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string name() const { return "/proc/self/fd/" + std::to_string(number_); }

private:
    int number_;
};

/// Starts this program again to replay the proof: nothing that the search left in memory can
/// help it. The disk sees no proof that has not been accepted.
bool acceptedByFreshProcess(const std::string& level, const Recording& proof) {
    const MemoryFile file(proof.format());
    std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    std::string check = "--check", levelArgument = level, proofArgument = file.name();
    char* arguments[] = {program.data(), levelArgument.data(), check.data(), proofArgument.data(),
                         nullptr};
    pid_t child = 0;
    if (posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ) != 0) {
        throw std::runtime_error("a fresh process for checking the proof could not be started");
    }
    int status = 0;
    if (waitpid(child, &status, 0) != child) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int checkProof(const std::shared_ptr<const Level>& level, const std::string& proof) {
    const quaoar::Verdict verdict = quaoar::verify(level, Recording::read(proof));
    if (verdict.finished && verdict.sameAsRecorded) return 0;
    std::fprintf(stderr, "%s does not hold: %s.\n", proof.c_str(),
                 verdict.finished ? "the level is finished, but not as it was recorded"
                                  : "the level is not finished when it ends");
    return 1;
}

/// How often the proof still finishes when every action ends up to 20 ms earlier or later.
int survivors(const std::shared_ptr<const Level>& level, const Recording& proof, int count) {
    constexpr int most = quaoar::Session::tickRate / 50;
    std::mt19937_64 random(1);
    int survived = 0;
    for (int i = 0; i < count; ++i) {
        quaoar::Session session(level);
        for (const quaoar::InputRun& run : proof.runs()) {
            const int change = static_cast<int>(random() % (2 * most + 1)) - most;
            const int ticks = std::max(1, static_cast<int>(run.ticks) + change);
            for (int n = 0; n < ticks; ++n) session.tick(run.input);
        }
        // Whoever is late may wait for what still swings.
        for (int n = 0; n < quaoar::Session::tickRate; ++n) session.tick({});
        if (session.phase() == quaoar::Session::Phase::finished) ++survived;
    }
    return survived;
}

std::optional<Recording> searchAll(const std::shared_ptr<const Level>& level,
                                   const Arguments& arguments) {
    std::optional<Recording> best;
    for (int i = 0; i < arguments.tries; ++i) {
        const std::uint64_t seed = arguments.seed + static_cast<std::uint64_t>(i);
        quaoar::Search search(level, {.seed = seed, .budget = arguments.budget});
        auto found = search.run();
        const quaoar::SearchReport& report = search.report();
        std::printf("seed %llu: %s after %.0f simulated s, %zu cells",
                    static_cast<unsigned long long>(seed), found ? "found a way" : "gave up",
                    report.simulated, report.cells);
        if (found) {
            std::printf(", %.2f s long\n",
                        static_cast<double>(found->ticks()) / quaoar::Session::tickRate);
        } else {
            std::printf(", %.2f m short of the exit\n", report.nearest);
        }
        std::fflush(stdout);
        if (found && (!best || found->ticks() < best->ticks())) best = std::move(found);
    }
    return best;
}

int solve(const Arguments& arguments) {
    const auto level = std::make_shared<const Level>(quaoar::readLevel(arguments.level));
    if (!arguments.check.empty()) return checkProof(level, arguments.check);
    const std::filesystem::path out = arguments.out.empty() ? quaoar::proofOf(arguments.level)
                                                            : std::filesystem::path(arguments.out);
    const auto proof = searchAll(level, arguments);
    if (!proof) throw std::runtime_error("no way through " + arguments.level + " was found");

    if (!acceptedByFreshProcess(arguments.level, *proof))
        throw std::runtime_error("the way that was found does not replay in a fresh process");
    proof->write(out);
    std::printf("%s  %.3f s, replayed by a fresh process\n", out.string().c_str(),
                static_cast<double>(proof->ticks()) / quaoar::Session::tickRate);
    if (arguments.jitter > 0) {
        std::printf("with every action up to 20 ms off it still finishes %d times of %d\n",
                    survivors(level, *proof, arguments.jitter), arguments.jitter);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("Searches for a way through a level of Escape from Quaoar and writes its proof",
                 "quaoar_solve");
    app.set_version_flag("--version", std::string("quaoar_solve ") + sulfur::version());
    app.add_option("level", arguments.level, "Level file")->required()->type_name("FILE");
    app.add_option("--out", arguments.out, "Where the proof goes; beside the level if not given")
        ->type_name("PROOF");
    app.add_option("--seed", arguments.seed, "First seed of the random choices")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--tries", arguments.tries, "Search with so many seeds, keep the shortest way")
        ->check(CLI::Range(1, 10000));
    app.add_option("--budget", arguments.budget, "Simulated seconds before a search gives up")
        ->check(atlax::between(1, 1e7), "1 to 1e7");
    app.add_option("--jitter", arguments.jitter, "Replays with shaken timing, for the report")
        ->check(CLI::Range(0, 10000));
    app.add_option("--check", arguments.check, "Only replay this proof; exit status 0 if it holds")
        ->type_name("PROOF");
    CLI11_PARSE(app, argc, argv);
    try {
        return solve(arguments);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "quaoar_solve: there is not enough memory\n");
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "quaoar_solve: %s\n", error.what());
        return 1;
    }
}
