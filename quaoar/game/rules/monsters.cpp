// What monsters see, and how they end.
#include <quaoar/monsters.hpp>

#include <algorithm>
#include <array>
#include <quaoar/hero.hpp>

#include "hash.hpp"

namespace quaoar {

using sulfur::BodyId;
using sulfur::ParticleId;
using sulfur::Point;
using sulfur::Real;

namespace {

/// Ticks between two looks around: 20 ms.
constexpr int blink = 10;

}  // namespace

Monsters::Monsters(const Attempt& attempt) {
    std::vector<Plan> plans;
    for (const Monster& monster : attempt.level.monsters) {
        const BodyId body = attempt.instance.body(monster.body);
        Plan plan;
        plan.body = body;
        plan.origin = *attempt.origin(body);
        plan.material = attempt.world.material(body);
        plan.home = attempt.world.centreOfMass(body);
        plan.joints = attempt.world.joints(body).size();
        plan.onDefeat = Signals::place(attempt.level, monster.onDefeat);
        if (monster.flies) attempt.world.setGravityScale(body, 0);
        plans.push_back(plan);
        states_.emplace_back();
    }
    plans_ = std::make_shared<const std::vector<Plan>>(std::move(plans));
}

Monsters::One Monsters::one(const Attempt& attempt, std::size_t place) {
    return {attempt, attempt.level.monsters[place], (*plans_)[place], states_[place]};
}

bool Monsters::behave(const Attempt& attempt) {
    bool noticed = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        State& state = states_[i];
        const BodyId body = (*plans_)[i].body;
        if (state.mood == Mood::defeated || !attempt.world.isEnabled(body)) continue;
        const Mood before = state.mood;
        One monster = one(attempt, i);
        if ((attempt.world.ticks() + i) % blink == 0) monster.look();
        monster.act();
        noticed = noticed || (before == Mood::idle && state.mood != Mood::idle);
    }
    return noticed;
}

bool Monsters::notice(const Attempt& attempt, const Zones& zones) {
    bool any = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if (states_[i].mood == Mood::defeated) continue;
        const One monster = one(attempt, i);
        if (monster.isDefeated(zones)) {
            monster.defeat();
            any = true;
            continue;
        }
        std::array<sulfur::ContactInfo, 1> contact;
        states_[i].grounded = attempt.world.contacts(monster.plan.body, contact) > 0;
    }
    return any;
}

/// Where what it looks for is: the hero, or of the rope the particle that is nearest.
std::optional<Point> Monsters::One::target() const {
    if (monster.target == Monster::Target::hero) return attempt.heroPosition();
    std::optional<Point> nearest;
    double least = 0;
    for (const ParticleId bead : attempt.rope.particles()) {
        const Point place = attempt.world.position(bead);
        const double distance = (place - middle()).squaredNorm();
        if (nearest && distance >= least) continue;
        nearest = place;
        least = distance;
    }
    return nearest;
}

/// Not through anything but itself, the hero and the rope.
bool Monsters::One::inSight(const Point& target) const {
    const Point from = middle();
    if ((target - from).squaredNorm() > monster.range * monster.range) return false;
    sulfur::QueryFilter filter;
    filter.mask = ~(Category::hero | Category::rope);
    filter.ignore = plan.body;
    return !attempt.world.castSegment(from, target, filter);
}

void Monsters::One::look() {
    const auto place = target();
    state.sees = place && inSight(*place);
}

/// The momentum that a blow without rebound would exchange: what is soft takes it up over many
/// ticks, so that the impulse of the first says little.
double Monsters::One::momentumOf(const sulfur::ContactBegun& contact) const {
    if (contact.a != plan.body && contact.b != plan.body) return 0;
    const sulfur::World& world = attempt.world;
    const BodyId other = contact.a == plan.body ? contact.b : contact.a;
    if (!world.contains(other) || world.kind(other) == sulfur::BodyKind::fixed) return 0;
    const double own = static_cast<double>(world.mass(plan.body));
    const double its = static_cast<double>(world.mass(other));
    const bool driven = world.kind(other) == sulfur::BodyKind::kinematic;
    return static_cast<double>(contact.speed) * (driven ? own : own * its / (own + its));
}

bool Monsters::One::isStruck() const {
    const auto& begun = attempt.world.events().contactsBegun;
    return std::any_of(begun.begin(), begun.end(), [this](const sulfur::ContactBegun& contact) {
        return momentumOf(contact) > monster.toughness;
    });
}

bool Monsters::One::isDefeated(const Zones& zones) const {
    if (!attempt.world.contains(plan.body)) return true;
    if (!attempt.world.isEnabled(plan.body)) return false;
    const Point place = middle();
    if (place.y() < attempt.level.killDepth || zones.deadly(attempt.level, place)) return true;
    const std::size_t joints = attempt.world.joints(plan.body).size();
    return 10 * joints < 9 * plan.joints || isStruck();
}

/// From now on it is a body like any other.
void Monsters::One::defeat() const {
    state = State{};
    state.mood = Mood::defeated;
    if (!attempt.world.contains(plan.body)) return;
    if (monster.flies) attempt.world.setGravityScale(plan.body, 1);
    attempt.world.setMaterial(plan.body, plan.material);
}

void Monsters::report(Signals& signals) const {
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if (states_[i].mood == Mood::defeated) signals.turnOn((*plans_)[i].onDefeat);
    }
}

bool Monsters::harmless(std::size_t origin) const {
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if ((*plans_)[i].origin == origin) return states_[i].mood == Mood::defeated;
    }
    return false;
}

std::uint64_t Monsters::hash() const {
    Hash hash;
    for (const State& state : states_) {
        hash.add(static_cast<std::uint64_t>(state.mood));
        hash.add(static_cast<std::uint64_t>(state.timer)).add(static_cast<double>(state.way));
        hash.add(static_cast<std::uint64_t>(state.stuck));
        hash.add(static_cast<std::uint64_t>((state.grounded ? 1 : 0) + (state.sees ? 2 : 0)));
    }
    return hash.value();
}

}  // namespace quaoar
