#include "fairness.hpp"

#include "ideas.hpp"
#include "workers.hpp"

namespace quaoar {
namespace {

enum class Fate : std::uint8_t { goesOn, dies, stuck };

/// Plays at random for 2 to 30 s and lets go; false if that was a death or the exit.
bool playToRest(Session& session, const DistanceField& field, std::mt19937_64& random) {
    session.restart();
    Player player(session);
    const double seconds = 2 + 28 * unit(random);
    while (player.seconds() < seconds) {
        const Ending ending = player.carryOut(randomIdea(session, field, random));
        if (ending == Ending::finished) return false;
        if (ending == Ending::missed) player.wait(1);
    }
    return player.carryOut(steadily({})) == Ending::done;
}

bool dies(Session& session, double patience) {
    Player player(session);
    return player.wait(static_cast<int>(patience * Session::tickRate)) == Ending::died;
}

Fate fateOf(Session& session, const Ground& ground, const Policy* policy,
            const FairOptions& options, std::uint64_t seed) {
    SearchOptions search;
    search.seed = seed;
    search.start = session.snapshot();
    const double nearer = ground.field.at(session.heroPosition()) - 2;
    search.goal = [&](const Situation& now) {
        if (ground.field.at(now.place) < nearer) return true;
        if (policy == nullptr) return false;
        for (const Place& place : policy->places()) {
            if (place.value > 0 && unlikeness(place.here, now) < 1) return true;
        }
        return false;
    };
    if (search.goal(situationOf(session))) return Fate::goesOn;
    if (Search(session, ground.field, search).run(options.budget)) return Fate::goesOn;
    session.restore(*search.start);
    return dies(session, options.patience) ? Fate::dies : Fate::stuck;
}

}  // namespace

FairReport checkFairness(const Ground& ground, const Policy* policy, const FairOptions& options) {
    struct Result {
        Fate fate = Fate::goesOn;
        sulfur::Point place{0, 0};
    };
    std::vector<Result> results(static_cast<std::size_t>(options.states));
    forAll(ground.level, options.jobs, options.states, [&](int i, Session& session) {
        const std::uint64_t seed = options.seed * 100000 + static_cast<std::uint64_t>(i);
        std::mt19937_64 random(seed);
        Result& result = results[static_cast<std::size_t>(i)];
        // Where letting go always kills there is no place of rest, and nobody is stuck.
        constexpr int mostTries = 100;
        int tries = 0;
        while (tries < mostTries && !playToRest(session, ground.field, random)) ++tries;
        result.place = session.heroPosition();
        result.fate =
            tries == mostTries ? Fate::dies : fateOf(session, ground, policy, options, seed);
    });
    FairReport report;
    for (const Result& result : results) {
        if (result.fate == Fate::goesOn) ++report.goOn;
        if (result.fate == Fate::dies) ++report.die;
        if (result.fate == Fate::stuck) report.stuck.push_back(result.place);
    }
    return report;
}

}  // namespace quaoar
