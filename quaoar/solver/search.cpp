#include "search.hpp"

#include <algorithm>
#include <cmath>

#include "ideas.hpp"

namespace quaoar {

Ground::Ground(std::shared_ptr<const Level> of) : level(std::move(of)), field(Session(level)) {}

std::optional<Way> Explorer::run(double until) {
    while (report_.simulated < until) {
        if (auto way = explore()) return way;
    }
    return std::nullopt;
}

bool Explorer::entersStage() {
    const int reached = checkpointsReached(session_);
    const bool leads = field_.at(session_.heroPosition()) < DistanceField::unreachable;
    if (reached <= stage_ || !leads) return false;
    stage_ = reached;
    return true;
}

Search::Search(Session& session, const DistanceField& field, const SearchOptions& options)
    : Explorer(session, field, options.seed), options_(options) {
    if (options.start) {
        session_.restore(*options.start);
    } else {
        session_.restart();
    }
    stage_ = checkpointsReached(session_);
    const Situation here = situationOf(session_);
    report_.nearest = field_.at(here.place);
    nodes_.push_back({0, {}, 0});
    states_.push_back({0, session_.snapshot(), report_.nearest, 0});
    cells_[cellOf(here)] = 0;
}

Search::Cell Search::cellOf(const Situation& situation) {
    const auto step = [](double value, double size) {
        return static_cast<std::int32_t>(std::floor(value / size));
    };
    return {step(situation.place.x(), cellSide),
            step(situation.place.y(), cellSide),
            step(situation.velocity.x() + 1.5, 3),
            step(situation.velocity.y() + 1.5, 3),
            situation.tied,
            situation.signals};
}

std::vector<sulfur::Point> Search::frontier() const {
    std::vector<sulfur::Point> places;
    for (const auto& [cell, state] : cells_) {
        const sulfur::Point place((cell.x + 0.5) * cellSide, (cell.y + 0.5) * cellSide);
        // Cells of one place that differ in velocity follow each other.
        if (places.empty() || places.back() != place) places.push_back(place);
    }
    return places;
}

/// A small tournament: few metres to go and few tries win.
Search::State& Search::choose() {
    const int rounds = 1 + whole(random_, 12);
    std::size_t best = 0;
    double bestScore = 0;
    for (int i = 0; i < rounds; ++i) {
        const auto k = static_cast<std::size_t>(whole(random_, static_cast<int>(states_.size())));
        const double score = states_[k].distance + 0.35 * std::sqrt(states_[k].tries);
        if (i > 0 && score >= bestScore) continue;
        best = k;
        bestScore = score;
    }
    ++states_[best].tries;
    return states_[best];
}

void Search::insert(std::size_t parent, const Intention& intention, std::uint64_t ticks) {
    const Situation here = situationOf(session_);
    const double distance = field_.at(here.place);
    if (distance >= DistanceField::unreachable) return;
    report_.nearest = std::min(report_.nearest, distance);
    const auto [place, fresh] = cells_.try_emplace(cellOf(here), states_.size());
    if (!fresh && nodes_[states_[place->second].node].ticks <= ticks) return;
    nodes_.push_back({parent, intention, ticks});
    const State state{nodes_.size() - 1, session_.snapshot(), distance, 0};
    if (fresh) {
        states_.push_back(state);
    } else {
        states_[place->second] = state;
    }
}

Way Search::trace(std::size_t parent, const Intention& last, std::uint64_t ticks) const {
    Way way{{last}, ticks};
    for (std::size_t node = parent; node != 0; node = nodes_[node].parent) {
        way.steps.push_back(nodes_[node].intention);
    }
    std::reverse(way.steps.begin(), way.steps.end());
    return way;
}

/// A few ideas in a row reach further than one before the archive cuts in again.
std::optional<Way> Search::explore() {
    const State& from = choose();
    std::size_t parent = from.node;
    session_.restore(*from.snapshot);
    Player player(session_);
    for (int n = 1 + whole(random_, 4); n > 0; --n) {
        const Intention idea = randomIdea(session_, field_, random_);
        const std::uint64_t before = player.ticks();
        const Ending ending = player.carryOut(idea);
        const std::uint64_t spent = player.ticks() - before;
        count(spent);
        const std::uint64_t ticks = nodes_[parent].ticks + spent;
        if (ending == Ending::finished) return trace(parent, idea, ticks);
        if (ending != Ending::done) break;
        const Intention seen = endedBySight(idea, player.trace());
        if (options_.goal && options_.goal(situationOf(session_))) {
            return trace(parent, seen, ticks);
        }
        if (entersStage()) {
            states_.clear();
            cells_.clear();
        }
        const std::size_t known = nodes_.size();
        insert(parent, seen, ticks);
        report_.cells = states_.size();
        if (nodes_.size() == known) break;
        parent = nodes_.size() - 1;
    }
    return std::nullopt;
}

}  // namespace quaoar
