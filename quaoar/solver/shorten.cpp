#include "shorten.hpp"

#include "ideas.hpp"

namespace quaoar {
namespace {

/// The states before each step, and how long it all takes.
struct Run {
    std::vector<std::shared_ptr<const Session::Snapshot>> before;
    std::vector<std::uint64_t> at;  ///< ticks before each step
    std::uint64_t ticks = 0;
    bool finished = false;
};

/// Plays the steps from `first` on, in a session that is there; stops when it takes too long.
Run playOn(Session& session, const Way& way, std::size_t first, std::uint64_t begun,
           std::uint64_t limit) {
    Run run;
    Player player(session);
    for (std::size_t i = first; i < way.steps.size() && begun + player.ticks() < limit; ++i) {
        run.before.push_back(session.snapshot());
        run.at.push_back(begun + player.ticks());
        const Ending ending = player.carryOut(way.steps[i]);
        run.finished = ending == Ending::finished;
        if (ending != Ending::done) break;
    }
    run.ticks = begun + player.ticks();
    return run;
}

/// The way with one step left out, varied or cut short.
Way changed(const Way& way, std::size_t step, std::mt19937_64& random) {
    Way other = way;
    Intention& intention = other.steps[step];
    const int kind = whole(random, 4);
    if (kind == 0 && way.steps.size() > 1) {
        other.steps.erase(other.steps.begin() + static_cast<std::ptrdiff_t>(step));
    } else if (kind == 1 && intention.reel != 0 && !intention.boost) {
        intention.boost = true;
    } else if (kind == 2 && intention.until.kind == Until::Kind::calm) {
        intention.until.kind = Until::Kind::time;
        intention.until.latest = static_cast<int>(50 + 700 * unit(random));
    } else {
        intention = varied(intention, random);
    }
    return other;
}

}  // namespace

Way shortened(Session& session, const Way& way, std::uint64_t seed, double budget) {
    std::mt19937_64 random(seed);
    session.restart();
    Way best = way;
    Run known = playOn(session, best, 0, 0, ~std::uint64_t{0});
    if (!known.finished) return way;
    double simulated = 0;
    while (simulated < budget) {
        const auto step =
            static_cast<std::size_t>(whole(random, static_cast<int>(known.at.size())));
        const Way other = changed(best, step, random);
        session.restore(*known.before[step]);
        Run run = playOn(session, other, step, known.at[step], known.ticks);
        simulated += static_cast<double>(run.ticks - known.at[step]) / Session::tickRate;
        if (!run.finished || run.ticks >= known.ticks) continue;
        best = other;
        known.before.resize(step);
        known.at.resize(step);
        known.before.insert(known.before.end(), run.before.begin(), run.before.end());
        known.at.insert(known.at.end(), run.at.begin(), run.at.end());
        known.ticks = run.ticks;
        best.steps.resize(known.at.size());
    }
    best.ticks = known.ticks;
    return best;
}

}  // namespace quaoar
