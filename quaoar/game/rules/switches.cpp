#include <quaoar/switches.hpp>

#include <cmath>
#include <quaoar/hero.hpp>
#include <quaoar/session.hpp>

#include "hash.hpp"

namespace quaoar {

using sulfur::BodyId;
using sulfur::Point;

namespace {

/// Ticks between two looks at what lies on a switch: 16 ms. The hero and the rope count at once.
constexpr std::uint64_t weighing = 8;

struct Plate {
    Point low, high;
};

Plate plateOf(const Switch& one) {
    const Point half = one.size.cast<double>() / 2;
    return {one.position - half, one.position + half};
}

bool reaches(const Plate& plate, const Point& middle, double radius) {
    const Point nearest = middle.cwiseMax(plate.low).cwiseMin(plate.high);
    return (middle - nearest).squaredNorm() <= radius * radius;
}

/// kg of what physics moves, the hero among it, that touches the plate.
double weightOn(const sulfur::World& world, const Plate& plate) {
    sulfur::QueryFilter filter;
    filter.mask = ~Category::rope;
    filter.accept = [&world](BodyId body) { return world.kind(body) == sulfur::BodyKind::dynamic; };
    double weight = 0;
    for (const sulfur::Overlap& overlap : world.overlapBox(plate.low, plate.high, filter)) {
        weight += static_cast<double>(world.mass(overlap.body));
    }
    return weight;
}

bool lies(const sulfur::World& world, BodyId body, const Plate& plate) {
    if (!world.contains(body)) return false;
    sulfur::QueryFilter filter;
    filter.accept = [body](BodyId other) { return other == body; };
    return !world.overlapBox(plate.low, plate.high, filter).empty();
}

}  // namespace

Switches::Switches(const Attempt& attempt) : states_(attempt.level.switches.size()) {
    for (const Switch& one : attempt.level.switches) {
        signals_.push_back(Signals::place(attempt.level, one.signal));
    }
}

bool Switches::isPressed(const Attempt& attempt, const Switch& one) {
    const Plate plate = plateOf(one);
    if (one.by == "hero") {
        return reaches(plate, attempt.heroPosition(), static_cast<double>(attempt.heroRadius));
    }
    if (one.by == "rope") {
        return attempt.rope.state() == Rope::State::attached &&
               reaches(plate, attempt.rope.head(attempt.world), 0);
    }
    if (one.by == "any") {
        const double weight = weightOn(attempt.world, plate);
        return weight > 0 && weight >= one.weight;
    }
    return lies(attempt.world, attempt.instance.body(one.by), plate);
}

bool Switches::look(const Attempt& attempt) {
    bool changed = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const Switch& one = attempt.level.switches[i];
        State& state = states_[i];
        const State before = state;
        const bool atOnce = one.by == "hero" || one.by == "rope";
        if (atOnce || (attempt.world.ticks() + i) % weighing == 0) {
            state.pressed = isPressed(attempt, one);
        }
        const bool begun = state.pressed && !before.pressed;
        if (state.lasts > 0) --state.lasts;
        if (state.pressed) {
            state.lasts = static_cast<int>(std::lround(one.lasts * Session::tickRate));
        }
        if (one.mode == Switch::Mode::hold) state.on = state.pressed || state.lasts > 0;
        if (one.mode == Switch::Mode::once) state.on = state.on || state.pressed;
        if (one.mode == Switch::Mode::toggle && begun) state.on = !state.on;
        changed = changed || state.on != before.on;
    }
    return changed;
}

void Switches::report(Signals& signals) const {
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if (states_[i].on) signals.turnOn(signals_[i]);
    }
}

std::uint64_t Switches::hash() const {
    Hash hash;
    for (const State& state : states_) {
        hash.add(static_cast<std::uint64_t>((state.pressed ? 1 : 0) + (state.on ? 2 : 0)));
        hash.add(static_cast<std::uint64_t>(state.lasts));
    }
    return hash.value();
}

}  // namespace quaoar
