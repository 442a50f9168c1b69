// What a tick has come to: touched, cut, collected, dead, finished.
#include <algorithm>
#include <array>
#include <quaoar/session.hpp>

namespace quaoar {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

namespace {

bool near(const Point& a, const Point& b, double distance) {
    return (a - b).squaredNorm() <= distance * distance;
}

}  // namespace

void Session::lookAtContacts() {
    touch_.resize(16);
    const std::size_t count = world_->contacts(hero_, touch_);
    if (count > touch_.size()) {
        touch_.resize(count);
        world_->contacts(hero_, touch_);
    }
    touch_.resize(count);
}

/// Whether the other body comes at its deadly speed, whatever the hero's own share is.
bool Session::strikes(const sulfur::ContactBegun& contact, const Vec2& velocityBefore) const {
    const bool first = contact.a == hero_;
    const sulfur::BodyId other = first ? contact.b : contact.a;
    if (!surface(other).deadlySpeed || harmless(other)) return false;
    const Vec2 towardsHero = first ? contact.normal : Vec2(-contact.normal);
    const Real its = contact.speed + velocityBefore.dot(towardsHero);
    return static_cast<double>(its) >= *surface(other).deadlySpeed;
}

void Session::noticeContacts(const Vec2& velocityBefore) {
    lookAtContacts();
    struck_ = false;
    state_.touching = !touch_.empty();
    for (const sulfur::ContactBegun& contact : world_->events().contactsBegun) {
        if (contact.a != hero_ && contact.b != hero_) continue;
        events_.impact = std::max(events_.impact, static_cast<float>(contact.speed));
        struck_ = struck_ || strikes(contact, velocityBefore);
    }
}

/// A defeated monster, or a piece of it.
bool Session::harmless(sulfur::BodyId body) const {
    const auto place = origin(body);
    return place && workings_.monsters.harmless(*place);
}

/// Where a blade touches it the rope is gone: what would hang from the hand is let go.
void Session::cutRope() {
    if (rope_.state() != Rope::State::attached) return;
    std::array<sulfur::ContactInfo, 64> contacts;
    for (const sulfur::BodyId blade : blades_) {
        if (!world_->contains(blade) || harmless(blade)) continue;
        const std::size_t count = std::min(world_->contacts(blade, contacts), contacts.size());
        for (std::size_t i = 0; i < count; ++i) {
            const sulfur::BodyId other = contacts[i].a == blade ? contacts[i].b : contacts[i].a;
            if (world_->filter(other).category != Category::rope) continue;
            events_.cut = true;
            events_.cutAt = contacts[i].point;
            rope_.release(*world_);
            state_.cooldown = cooldown;
            return;
        }
    }
}

void Session::judge() {
    forgetFallen();
    if (state_.phase == Phase::finished) return;
    if (const Death death = deathNow(); death != Death::none) {
        die(death);
        return;
    }
    collect();
    if (exitOpen() && near(heroPosition(), level_->exit.position, level_->exit.radius)) finish();
}

bool Session::outside() const {
    constexpr double margin = 10;  // m: he may fly out of the picture and come back
    const Point hero = heroPosition();
    return hero.y() < level_->killDepth || hero.y() > level_->boundsMax.y() + margin ||
           hero.x() < level_->boundsMin.x() - margin || hero.x() > level_->boundsMax.x() + margin;
}

/// What has fallen out of the level would fall for ever. One body is looked at in each tick.
void Session::forgetFallen() {
    constexpr double margin = 5;  // m
    const auto bodies = world_->bodies();
    const sulfur::BodyId body = bodies[world_->ticks() % bodies.size()];
    if (world_->kind(body) != sulfur::BodyKind::dynamic || !world_->isEnabled(body)) return;
    if (!origin(body) || world_->centreOfMass(body).y() > level_->killDepth - margin) return;
    if (rope_.hooked(*world_) == body) rope_.release(*world_);
    world_->setEnabled(body, false);
}

Death Session::deathNow() {
    if (outside()) return Death::fell;
    if (struck_) return Death::struck;
    if (squeezedFlat()) return Death::crushed;
    if (workings_.zones.deadly(*level_, heroPosition())) return Death::zone;
    if (level_->countdown && timerTicks() > 0 && *secondsLeft() <= 0) return Death::late;
    const bool touched =
        deadly_ && std::any_of(touch_.begin(), touch_.end(), [this](const auto& contact) {
            const sulfur::BodyId other = contact.a == hero_ ? contact.b : contact.a;
            return surface(other).deadly && !harmless(other);
        });
    return touched ? Death::touched : Death::none;
}

bool Session::touchedOnBothSides() const {
    const auto normal = [this](const sulfur::ContactInfo& contact) {
        return contact.a == hero_ ? contact.normal : Vec2(-contact.normal);
    };
    for (const sulfur::ContactInfo& one : touch_) {
        for (const sulfur::ContactInfo& other : touch_) {
            if (normal(one).dot(normal(other)) < Real(-0.5)) return true;
        }
    }
    return false;
}

/// Flatter than any landing makes him, between two things that touch him on opposite sides.
bool Session::squeezedFlat() {
    const auto particles = world_->particles(hero_);
    const std::size_t half = (particles.size() - 1) / 2;
    double least = 1e9;
    for (std::size_t i = 1; i <= half; ++i) {
        const Point across = world_->position(particles[i]) - world_->position(particles[i + half]);
        least = std::min(least, across.squaredNorm());
    }
    const double flat =
        2 * static_cast<double>((heroRules_.radius - heroRules_.skinRadius) * heroRules_.flat);
    const bool squeezed = least < flat * flat && touchedOnBothSides();
    state_.squeezed = squeezed ? state_.squeezed + 1 : 0;
    return state_.squeezed >= heroRules_.flatTicks;
}

void Session::collect() {
    const Point hero = heroPosition();
    for (std::size_t i = 0; i < level_->pickups.size(); ++i) {
        if (pickedUp(i) || !near(hero, level_->pickups[i].position, Pickup::radius)) continue;
        state_.pickedUp |= std::uint64_t{1} << i;
        events_.pickedUp = true;
    }
    for (std::size_t i = 0; i < level_->checkpoints.size(); ++i) {
        const Checkpoint& checkpoint = level_->checkpoints[i];
        if (reached(i) || !near(hero, checkpoint.position, checkpoint.radius)) continue;
        state_.reached |= std::uint64_t{1} << i;
        state_.checkpoint = static_cast<int>(i);
        state_.saved = nullptr;  // or every snapshot would keep all before it
        state_.savedHash = hash();
        state_.saved = snapshot();
        events_.checkpoint = true;
    }
}

void Session::finish() {
    state_.phase = Phase::finished;
    state_.finishTick = state_.ticks;
    rope_.release(*world_);
    events_.finished = true;
}

std::uint64_t Session::timerTicks() const {
    if (state_.firstAction == 0) return 0;
    const std::uint64_t end = state_.phase == Phase::finished ? state_.finishTick : state_.ticks;
    return end - state_.firstAction + 1;
}

std::optional<double> Session::secondsLeft() const {
    if (!level_->countdown) return std::nullopt;
    return std::max(0.0, *level_->countdown - seconds());
}

Medal Session::medal() const {
    return state_.phase == Phase::finished ? level_->medalFor(seconds()) : Medal::none;
}

}  // namespace quaoar
