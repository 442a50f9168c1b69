// quaoar_solve: searches for ways through levels, writes their proofs, and tells how well a human
// could go them.
#include <CLI/CLI.hpp>
#include <atlax/arguments.hpp>
#include <cstdio>
#include <new>
#include <sulfur/version.hpp>

#include "commands.hpp"

namespace {

void describe(CLI::App& app, quaoar::SolverArguments& arguments) {
    quaoar::SolveOptions& solve = arguments.solve;
    app.set_version_flag("--version", std::string("quaoar_solve ") + sulfur::version());
    // Not required here: else an unknown option is passed over for the level that is missing too.
    app.add_option("level", arguments.levels, "Level files")->type_name("FILE...");
    app.add_option("--out", arguments.out,
                   "Where the proof goes (the way beside it); beside the level if not given")
        ->type_name("PROOF");
    app.add_option("--seed", solve.seed, "First seed of the random choices")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--tries", solve.searches,
                   "Search with so many seeds until half have found a way")
        ->check(CLI::Range(1, 64));
    app.add_option("--budget", solve.budget, "Simulated seconds before a search gives up")
        ->check(atlax::between(1, 1e7), "1 to 1e7");
    app.add_option("--polish", solve.polish,
                   "Simulated seconds in which each of two ways is made quicker")
        ->check(atlax::between(0, 1e7), "0 to 1e7");
    app.add_option("--jobs", solve.jobs, "Threads; they do not change the results")
        ->check(CLI::Range(1, 256));
    app.add_option("--practice", solve.rounds,
                   "Rounds in which a way is made to last; 0: a proof is enough")
        ->check(CLI::Range(0, 1000));
    app.add_option("--games", solve.games, "Games of the robust bot, for the report")
        ->check(CLI::Range(1, 100000));
    app.add_option("--skill", arguments.skill, "Of the bot: 1 a beginner, 5 an expert")
        ->check(CLI::Range(1, 5));
    auto* bot =
        app.add_option("--bot", arguments.bot, "Only play so many games with the way that is known")
            ->check(CLI::Range(1, 100000));
    app.add_flag("--keep", arguments.keep, "With --bot: the way tells its survival from then on")
        ->needs(bot);
    app.add_flag("--repair", arguments.repair,
                 "Only mend what does not hold, beginning with the ways that are known");
    app.add_flag("--table", arguments.table,
                 "Only print, of each level: seconds of gold, simulated seconds to the first way, "
                 "metres, survival, lives, seconds of the proof, how much faster than real time it "
                 "simulates, seconds to load");
    app.add_option("--fair", arguments.fair,
                   "Only look for places without a way on, in so many states of rest")
        ->check(CLI::Range(1, 100000));
    app.add_option(
           "--wander", arguments.wander,
           "Only play at random for so many simulated hours, each trip from a moment of the "
           "proof, and look for what must never be; exit status 0 if there is none")
        ->check(atlax::between(1e-4, 1e5), "0.0001 to 100000");
    app.add_flag("--fresh", arguments.fresh, "Search anew, even where a way is known");
    app.add_option("--check", arguments.check, "Only replay this proof; exit status 0 if it holds")
        ->type_name("PROOF");
    app.add_flag("--quiet", solve.quiet, "No progress");
    app.footer(
        "The bot reacts after 200 ms to what was not foreseen (standard deviation 40 ms), aims\n"
        "with a standard deviation of 2 degrees, presses and releases with one of 30 ms, and has\n"
        "three lives from each checkpoint. Skills 1 to 5 have 2, 1.5, 1, 0.6 and 0.3 of that.");
}

}  // namespace

int main(int argc, char** argv) {
    quaoar::SolverArguments arguments;
    CLI::App app("Searches for ways through levels of Escape from Quaoar and writes their proofs",
                 "quaoar_solve");
    describe(app, arguments);
    CLI11_PARSE(app, argc, argv);
    arguments.solve.skill = quaoar::Skill::level(arguments.skill);
    try {
        if (arguments.levels.empty()) throw std::runtime_error("no level is given; see --help");
        const bool any = arguments.out.empty() && arguments.check.empty();
        if (!any && arguments.levels.size() > 1) {
            throw std::runtime_error("--out and --check are for one level, not for several");
        }
        return quaoar::runSolver(arguments);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "quaoar_solve: there is not enough memory\n");
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "quaoar_solve: %s\n", error.what());
        return 1;
    }
}
