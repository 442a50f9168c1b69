#include "ideas.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "player.hpp"

namespace quaoar {
namespace {

constexpr int aims = 96;
/// Slower than this (metres a tick) the hero's place is no clock.
constexpr double slowest = 0.8 / Session::tickRate;
/// How much later than meant an intention ends whose line is never passed: 0.5 s.
constexpr int patience = Session::tickRate / 2;

int ticksBetween(std::mt19937_64& random, double low, double high) {
    return static_cast<int>((low + (high - low) * unit(random)) * Session::tickRate);
}

}  // namespace

bool pickAnchor(const Session& session, const DistanceField& field, std::mt19937_64& random,
                sulfur::Point& anchor) {
    const double offset = unit(random);
    // One of each stretch of surface, so that a small peg counts as much as half a metre of floor.
    std::map<std::pair<int, int>, std::pair<double, sulfur::Point>> stretches;
    for (int i = 0; i < aims; ++i) {
        const double angle = 6.283185307179586 * (i + offset) / aims;
        const sulfur::Vec2 direction(static_cast<sulfur::Real>(std::cos(angle)),
                                     static_cast<sulfur::Real>(std::sin(angle)));
        const AimPreview preview = session.preview(direction);
        if (!preview.sticks || (preview.to - preview.from).norm() < 0.2) continue;
        // The surface itself may lie in no free cell: look a little before it.
        const sulfur::Point before = preview.to - (preview.to - preview.from) * 0.15;
        const std::pair<int, int> stretch(static_cast<int>(std::floor(preview.to.x() / 0.6)),
                                          static_cast<int>(std::floor(preview.to.y() / 0.6)));
        const bool fresh = !stretches.contains(stretch);
        if (fresh || whole(random, 3) == 0) stretches[stretch] = {field.at(before), preview.to};
    }
    if (stretches.empty()) return false;
    std::vector<std::pair<double, sulfur::Point>> holds;
    for (const auto& [stretch, hold] : stretches) holds.push_back(hold);
    std::size_t best = static_cast<std::size_t>(whole(random, static_cast<int>(holds.size())));
    for (int round = whole(random, 5); round > 0; --round) {
        const auto other = static_cast<std::size_t>(whole(random, static_cast<int>(holds.size())));
        if (holds[other].first < holds[best].first) best = other;
    }
    anchor = holds[best].second;
    return true;
}

Intention randomIdea(const Session& session, const DistanceField& field, std::mt19937_64& random,
                     int shots) {
    const bool tied = session.rope().state() == Rope::State::attached;
    Intention idea;
    const int kind = whole(random, 100);
    const bool shoots =
        kind >= (tied ? 100 - shots : 20) && pickAnchor(session, field, random, idea.aim);
    if (shoots) {
        idea.hook = Intention::Hook::shoot;
        idea.until.latest = pressGap + ticksBetween(random, 0.1, 0.9);
    } else if (tied && kind >= (100 - shots) / 3) {
        idea.hook = Intention::Hook::keep;
        idea.until.latest = ticksBetween(random, 0.05, whole(random, 4) == 0 ? 2 : 0.7);
    } else {
        idea.until.latest = ticksBetween(random, 0.05, 0.5);
    }
    if (idea.hook != Intention::Hook::loose) {
        idea.reel = std::min(1, whole(random, 5) - 1);
        if (idea.reel > 0 && whole(random, 2) == 0) idea.reel = -1;
        idea.boost = idea.reel != 0 && whole(random, 3) == 0;
        constexpr int ways[] = {-1, 0, 1, 0, 2};
        idea.push = ways[whole(random, 5)];
    }
    if (kind % 12 == 0) idea = steadily(idea);
    makeExact(idea);
    return idea;
}

Intention steadily(Intention idea) {
    idea.until.kind = Until::Kind::calm;
    idea.until.earliest = 0;
    idea.until.latest = 4 * Session::tickRate;
    idea.push = idea.hook == Intention::Hook::loose ? 0 : -2;
    return idea;
}

Intention varied(Intention idea, std::mt19937_64& random) {
    const auto shift = [&](double size) { return size * (2 * unit(random) - 1); };
    if (idea.hook == Intention::Hook::shoot) {
        idea.aim += sulfur::Point(shift(0.25), shift(0.15));
    }
    switch (whole(random, 4)) {
        case 0:
            idea.push = whole(random, 3) - 1;
            break;
        case 1:
            idea.reel = whole(random, 3) - 1;
            idea.boost = idea.reel != 0 && whole(random, 2) == 0;
            break;
        case 2:
            idea.until.place += sulfur::Point(shift(0.25), shift(0.25));
            break;
        default:
            break;
    }
    if (idea.until.kind == Until::Kind::time) {
        idea.until.latest = std::max(5, idea.until.latest + static_cast<int>(shift(75)));
    }
    makeExact(idea);
    return idea;
}

Intention endedBySight(Intention intention, const std::vector<sulfur::Point>& trace) {
    if (intention.until.kind != Until::Kind::time || trace.size() < 2) return intention;
    const std::size_t last = trace.size() - 1;
    const sulfur::Point step = trace[last] - trace[last - 1];
    const double size = step.norm();
    if (size < slowest) return intention;
    Intention seen = intention;
    seen.until.kind = Until::Kind::line;
    seen.until.place = (trace[last] + trace[last - 1]) / 2;
    seen.until.across = step / size;
    makeExact(seen);
    const auto beyond = [&](std::size_t i) {
        return (trace[i] - seen.until.place).dot(seen.until.across) >= 0;
    };
    if (!beyond(last)) return intention;
    std::size_t earliest = last;
    while (earliest > 0 && !beyond(earliest - 1)) --earliest;
    seen.until.earliest = static_cast<int>(earliest) + 1;
    seen.until.latest = static_cast<int>(trace.size()) + patience;
    // A line that was only just passed the other way is no sign.
    if (last - earliest < 15) return intention;
    return seen;
}

}  // namespace quaoar
