#include "steady_search.hpp"

#include <algorithm>
#include <cmath>

#include "ideas.hpp"

namespace quaoar {
namespace {

/// Slower than this the hero rests, m/s.
constexpr double restSpeed = 0.35;
constexpr int repeats = 4;
/// A step that comes to the same less often is not kept.
constexpr double leastReliable = 0.55;
/// Two places of rest that are so near (metres) are the same.
constexpr double samePlace = 0.6;

}  // namespace

SteadySearch::SteadySearch(Session& session, const DistanceField& field, const Skill& skill,
                           std::uint64_t seed)
    : Explorer(session, field, seed), nerves_(skill, seed) {
    session_.restart();
    const Situation here = situationOf(session_);
    report_.nearest = field_.at(here.place);
    nodes_.push_back({});
    states_.push_back({0, session_.snapshot(), here, report_.nearest, 0});
    cells_[cellOf(here)] = 0;
}

SteadySearch::Cell SteadySearch::cellOf(const Situation& situation) {
    const auto step = [](double value) {
        return static_cast<std::int32_t>(std::floor(value / 0.4));
    };
    return {step(situation.place.x()), step(situation.place.y()),
            situation.tied ? 1 + step(situation.length) : 0, situation.signals};
}

/// Few metres to go, few tries and a reliable way so far win.
SteadySearch::State& SteadySearch::choose() {
    std::size_t best = 0;
    double bestScore = 0;
    for (int i = 1 + whole(random_, 20); i > 0; --i) {
        const auto k = static_cast<std::size_t>(whole(random_, static_cast<int>(states_.size())));
        const State& state = states_[k];
        const double doubt = 1 - nodes_[state.node].reliability;
        const double score = state.distance + 0.7 * std::sqrt(state.tries) + 2 * doubt;
        if (bestScore > 0 && score >= bestScore) continue;
        best = k;
        bestScore = score;
    }
    ++states_[best].tries;
    return states_[best];
}

Ending SteadySearch::attempt(const Session::Snapshot& from,
                             const std::vector<Intention>& intentions) {
    session_.restore(from);
    Player player(session_);
    Ending ending = Ending::done;
    for (const Intention& intention : intentions) {
        ending = player.carryOut(intention, nerves_.next());
        if (ending != Ending::done) break;
    }
    count(player.ticks());
    return ending;
}

/// The share of repetitions with slips that come to as good a place.
double SteadySearch::reliability(const State& from, const std::vector<Intention>& intentions,
                                 const Situation& wanted, bool finished) {
    int good = 0;
    for (int n = 0; n < repeats; ++n) {
        const Ending ending = attempt(*from.snapshot, intentions);
        if (ending == Ending::finished) ++good;
        if (ending == Ending::done && !finished) {
            const Situation after = situationOf(session_);
            const bool same = after.tied == wanted.tied && after.signals == wanted.signals &&
                              (after.place - wanted.place).norm() < samePlace &&
                              after.velocity.norm() < 3 * restSpeed;
            if (same) ++good;
        }
        if (good + repeats - 1 - n < leastReliable * repeats) break;
    }
    return static_cast<double>(good) / repeats;
}

void SteadySearch::insert(std::size_t index, const std::vector<Intention>& intentions,
                          std::uint64_t spent) {
    const Situation here = situationOf(session_);
    const double distance = field_.at(here.place);
    if (here.velocity.norm() > restSpeed || distance >= DistanceField::unreachable) return;
    const auto known = cells_.find(cellOf(here));
    const State from = states_[index];
    const Node& parent = nodes_[from.node];
    if (known != cells_.end()) {
        const Node& rival = nodes_[states_[known->second].node];
        if (rival.reliability >= 0.9 * parent.reliability || rival.parent == from.node) return;
    }
    const auto snapshot = session_.snapshot();
    const int reached = checkpointsReached(session_);
    const double certain = parent.reliability * reliability(from, intentions, here, false);
    if (certain < leastReliable * parent.reliability) return;
    if (known != cells_.end() && nodes_[states_[known->second].node].reliability >= certain) return;
    report_.nearest = std::min(report_.nearest, distance);
    // As in search.hpp: from a new checkpoint on, what was before does not count.
    const bool stage = reached > stage_;
    nodes_.push_back({from.node, intentions, parent.ticks + spent, stage ? 1 : certain});
    const State state{nodes_.size() - 1, snapshot, here, distance, 0};
    if (stage) {
        stage_ = reached;
        cells_ = {{cellOf(here), 0}};
        states_ = {state};
        return;
    }
    if (known == cells_.end()) {
        cells_[cellOf(here)] = states_.size();
        states_.push_back(state);
    } else {
        states_[known->second] = state;
    }
    report_.cells = states_.size();
}

Way SteadySearch::trace(std::size_t parent, const std::vector<Intention>& last,
                        std::uint64_t ticks) const {
    Way way;
    way.ticks = ticks;
    std::vector<const std::vector<Intention>*> parts{&last};
    for (std::size_t node = parent; node != 0; node = nodes_[node].parent) {
        parts.push_back(&nodes_[node].intentions);
    }
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        for (const Intention& intention : **part) way.steps.push_back(intention);
    }
    return way;
}

/// Most swings come to rest soon on a short rope.
Intention SteadySearch::atRest(const Intention& idea) {
    Intention last = steadily(idea);
    if (last.hook == Intention::Hook::loose || whole(random_, 4) == 0) return last;
    last.reel = -1;
    last.boost = whole(random_, 4) == 0;
    return last;
}

/// One to three ideas, and then a rest.
std::optional<Way> SteadySearch::explore() {
    const State& chosen = choose();
    const auto index = static_cast<std::size_t>(&chosen - states_.data());
    const State from = chosen;
    session_.restore(*from.snapshot);
    Player player(session_);
    std::vector<Intention> intentions;
    Ending ending = Ending::done;
    for (int n = std::max(0, whole(random_, 5) - 2); n >= 0 && ending == Ending::done; --n) {
        Intention idea = randomIdea(session_, field_, random_, n == 0 ? 85 : 45);
        if (n == 0) idea = atRest(idea);
        ending = player.carryOut(idea);
        intentions.push_back(ending == Ending::done ? endedBySight(idea, player.trace()) : idea);
    }
    count(player.ticks());
    if (ending == Ending::done) insert(index, intentions, player.ticks());
    if (ending != Ending::finished) return std::nullopt;
    if (reliability(from, intentions, {}, true) < leastReliable) return std::nullopt;
    return trace(from.node, intentions, nodes_[from.node].ticks + player.ticks());
}

}  // namespace quaoar
