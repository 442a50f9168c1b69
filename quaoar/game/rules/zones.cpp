#include <quaoar/zones.hpp>

#include <cmath>
#include <quaoar/session.hpp>

#include "hash.hpp"

namespace quaoar {

using sulfur::Point;
using sulfur::Real;

namespace {

/// Fields are renewed at every fifth step of a ramp: each change looks at all that sleeps.
constexpr int rampStep = 5;

bool contains(const Zone& zone, const Point& place) {
    return place.x() >= zone.low.x() && place.x() <= zone.high.x() && place.y() >= zone.low.y() &&
           place.y() <= zone.high.y();
}

bool isOn(const Zone& zone, std::uint64_t clock) {
    if (!zone.pulse) return true;
    const double time = static_cast<double>(clock) / Session::tickRate + zone.pulse->phase;
    return std::fmod(time, zone.pulse->period) < zone.pulse->on;
}

sulfur::Field gravityOf(const Attempt& attempt, const Zone& zone, Real strength) {
    sulfur::UniformField field;
    field.zone = sulfur::BoxZone{zone.low, zone.high};
    field.acceleration = (*zone.gravity - attempt.level.scene.settings.gravity) * strength;
    return field;
}

sulfur::Field windOf(const Zone& zone, Real strength) {
    sulfur::WindField field;
    field.zone = sulfur::BoxZone{zone.low, zone.high};
    field.velocity = zone.wind->velocity;
    field.drag = zone.wind->drag * strength;
    return field;
}

}  // namespace

Zones::Zones(const Attempt& attempt) {
    Plan plan;
    for (const Zone& zone : attempt.level.zones) {
        plan.needs.push_back(Signals::place(attempt.level, zone.needs));
        const bool on = zone.needs.empty() && isOn(zone, 0);
        ramps_.push_back(on ? rampTicks : 0);
    }
    addFields(attempt, plan);
    findFloats(attempt, plan);
    plan_ = std::make_shared<const Plan>(std::move(plan));
}

void Zones::addFields(const Attempt& attempt, Plan& plan) const {
    for (std::size_t i = 0; i < attempt.level.zones.size(); ++i) {
        const Zone& zone = attempt.level.zones[i];
        plan.gravity.emplace_back();
        plan.wind.emplace_back();
        const Real strength = static_cast<Real>(ramps_[i]) / rampTicks;
        if (zone.gravity) plan.gravity[i] = attempt.world.add(gravityOf(attempt, zone, strength));
        if (zone.wind) plan.wind[i] = attempt.world.add(windOf(zone, strength));
    }
}

void Zones::act(const Attempt& attempt, const Signals& signals) {
    ++clock_;
    for (std::size_t i = 0; i < ramps_.size(); ++i) {
        const Zone& zone = attempt.level.zones[i];
        const bool on = signals.met(plan_->needs[i]) && isOn(zone, clock_);
        if (ramps_[i] != (on ? rampTicks : 0)) {
            ramps_[i] += on ? 1 : -1;
            if (ramps_[i] % rampStep == 0) setFields(attempt, i);
        }
        if (zone.liquid && ramps_[i] > 0) pushUp(attempt, i);
    }
}

void Zones::setFields(const Attempt& attempt, std::size_t place) const {
    const Zone& zone = attempt.level.zones[place];
    if (zone.gravity) {
        attempt.world.set(plan_->gravity[place], gravityOf(attempt, zone, strength(place)));
    }
    if (zone.wind) attempt.world.set(plan_->wind[place], windOf(zone, strength(place)));
    if (zone.liquid) wakeIn(attempt, zone);
}

/// Fields of the library wake what they change; a liquid is a force of ours.
void Zones::wakeIn(const Attempt& attempt, const Zone& zone) {
    for (const sulfur::BodyId body : attempt.world.bodies()) {
        if (!attempt.world.asleep(body)) continue;
        const sulfur::Bounds bounds = attempt.world.bounds(body);
        const bool apart = bounds.low.x() > zone.high.x() || bounds.high.x() < zone.low.x() ||
                           bounds.low.y() > zone.high.y() || bounds.high.y() < zone.low.y();
        if (!apart) attempt.world.wake(body);
    }
}

bool Zones::deadly(const Level& level, Point place) const {
    for (std::size_t i = 0; i < ramps_.size(); ++i) {
        const Zone& zone = level.zones[i];
        if (zone.deadly && 2 * ramps_[i] >= rampTicks && contains(zone, place)) return true;
    }
    return false;
}

std::uint64_t Zones::hash() const {
    Hash hash;
    hash.add(clock_);
    for (const int ramp : ramps_) hash.add(static_cast<std::uint64_t>(ramp));
    return hash.value();
}

}  // namespace quaoar
