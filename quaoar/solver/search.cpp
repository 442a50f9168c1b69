#include "search.hpp"

#include <algorithm>
#include <cmath>

namespace quaoar {
namespace {

constexpr double tickSeconds = 1.0 / Session::tickRate;

std::uint32_t ticksOf(double seconds) {
    return std::max(1u, static_cast<std::uint32_t>(seconds * Session::tickRate));
}

}  // namespace

Search::Search(std::shared_ptr<const Level> level, const SearchOptions& options)
    : options_(options),
      level_(level),
      session_(std::move(level)),
      field_(session_),
      random_(options.seed) {
    report_.nearest = DistanceField::unreachable;
    nodes_.push_back({});
    states_.push_back({0, session_.snapshot(), field_.at(session_.heroPosition()), 0});
    cells_[cellOf()] = 0;
}

/// Not std::uniform_real_distribution, whose results may differ between standard libraries.
double Search::unit() {
    return static_cast<double>(random_() >> 11) * 0x1p-53;
}

int Search::whole(int below) {
    return static_cast<int>(unit() * below);
}

Search::Cell Search::cellOf() const {
    const sulfur::Point p = session_.heroPosition();
    const sulfur::Vec2 v = session_.heroVelocity();
    const auto step = [](double value, double size) {
        return static_cast<std::int32_t>(std::floor(value / size));
    };
    return {step(p.x(), 0.5), step(p.y(), 0.5), step(static_cast<double>(v.x()) + 1.5, 3),
            step(static_cast<double>(v.y()) + 1.5, 3),
            session_.rope().state() == Rope::State::attached};
}

/// A small tournament: few metres to go and few tries win.
Search::State& Search::choose() {
    const int rounds = 1 + whole(12);
    std::size_t best = 0;
    double bestScore = 0;
    for (int i = 0; i < rounds; ++i) {
        const auto k = static_cast<std::size_t>(whole(static_cast<int>(states_.size())));
        const double score = states_[k].distance + 0.35 * std::sqrt(states_[k].tries);
        if (i > 0 && score >= bestScore) continue;
        best = k;
        bestScore = score;
    }
    ++states_[best].tries;
    return states_[best];
}

std::vector<InputRun> Search::randomAction() {
    std::vector<InputRun> action;
    TickInput input;
    const double angle = 6.283185307179586 * whole(64) / 64;
    setAim(input, std::cos(angle), std::sin(angle));
    const bool tied = session_.rope().state() == Rope::State::attached;
    const int kind = whole(10);
    if (kind < 2) {
        action.push_back({ticksOf(0.05 + 0.45 * unit()), input});
        return action;
    }
    const bool keep = tied && kind < 7;
    if (!keep) action.push_back({ticksOf(0.02), input});  // let go, so that the press counts
    input.fire = true;
    const int reel = whole(3);
    input.reelIn = reel == 1;
    input.reelOut = reel == 2;
    input.boost = reel != 0 && whole(3) == 0;
    input.push = static_cast<std::int8_t>(127 * (whole(3) - 1));
    action.push_back({ticksOf(0.05 + 0.6 * unit()), input});
    return action;
}

bool Search::carryOut(std::vector<InputRun>& action) {
    for (std::size_t i = 0; i < action.size(); ++i) {
        for (std::uint32_t n = 0; n < action[i].ticks; ++n) {
            session_.tick(action[i].input);
            report_.simulated += tickSeconds;
            if (session_.phase() != Session::Phase::finished) continue;
            action[i].ticks = n + 1;
            action.resize(i + 1);
            return true;
        }
    }
    return false;
}

void Search::insert(std::size_t parent, std::vector<InputRun> action) {
    std::uint64_t ticks = nodes_[parent].ticks;
    for (const InputRun& run : action) ticks += run.ticks;
    if (session_.ticks() != ticks) return;  // it died on the way: the session is at the spawn
    const double distance = field_.at(session_.heroPosition());
    if (distance >= DistanceField::unreachable) return;
    report_.nearest = std::min(report_.nearest, distance);
    const auto [place, fresh] = cells_.try_emplace(cellOf(), states_.size());
    if (!fresh && nodes_[states_[place->second].node].ticks <= ticks) return;
    nodes_.push_back({parent, std::move(action), ticks});
    State state{nodes_.size() - 1, session_.snapshot(), distance, 0};
    if (fresh) {
        states_.push_back(std::move(state));
    } else {
        states_[place->second] = std::move(state);
    }
}

Recording Search::trace(std::size_t parent, const std::vector<InputRun>& last) const {
    std::vector<const std::vector<InputRun>*> actions{&last};
    for (std::size_t node = parent; node != 0; node = nodes_[node].parent) {
        actions.push_back(&nodes_[node].action);
    }
    Recording recording(*level_);
    for (auto action = actions.rbegin(); action != actions.rend(); ++action) {
        for (const InputRun& run : **action) {
            for (std::uint32_t n = 0; n < run.ticks; ++n) recording.append(run.input);
        }
    }
    recording.finalHash = session_.hash();
    return recording;
}

std::optional<Recording> Search::run() {
    while (report_.simulated < options_.budget) {
        const State& from = choose();
        std::size_t parent = from.node;
        session_.restore(*from.snapshot);
        // A few actions in a row reach further than one before the archive cuts in again.
        const int actions = 1 + whole(4);
        for (int n = 0; n < actions; ++n) {
            std::vector<InputRun> action = randomAction();
            if (carryOut(action)) return trace(parent, action);
            const std::size_t before = nodes_.size();
            insert(parent, std::move(action));
            if (nodes_.size() == before) break;
            parent = nodes_.size() - 1;
        }
        report_.cells = states_.size();
    }
    return std::nullopt;
}

}  // namespace quaoar
