#include <quaoar/session.hpp>

#include <algorithm>

#include "hash.hpp"

namespace quaoar {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

Session::Session(std::shared_ptr<const Level> level) : level_(std::move(level)) {
    build();
    start_ = snapshot();
}

Session::~Session() = default;

void Session::build() {
    world_ = std::make_unique<sulfur::World>(level_->scene.settings);
    instance_ = sulfur::scene::instantiate(level_->scene, *world_);
    for (const auto& [id, surface] : level_->surfaces) {
        if (!surface.sticky) slippery_.push_back(instance_.body(id));
    }
    std::sort(slippery_.begin(), slippery_.end());
    const sulfur::Body hero = world_->add(heroBlueprint(heroRules_), {.position = level_->spawn});
    hero_ = hero.id();
    hand_ = hero.front();
}

void Session::restart() {
    restore(*start_);
    ++restarts_;
    events_ = {};
    events_.restarted = true;
}

void Session::tick(const TickInput& input) {
    if (input.restart || input.retry) {
        restart();
        return;
    }
    events_ = {};
    ++state_.ticks;
    if (state_.phase == Phase::playing) {
        act(input);
    } else {
        drawIntoGate();
    }
    if (rope_.state() == Rope::State::attached && !rope_.tied(*world_)) rope_.release(*world_);
    limitSpeed();
    world_->step();
    noticeImpact();
    judge();
}

void Session::act(const TickInput& input) {
    state_.aim = aimDirection(input);
    const bool anything = input.fire || input.reelIn || input.reelOut || input.push != 0;
    if (anything && state_.firstAction == 0) state_.firstAction = state_.ticks;
    updateRope(input);
    pushHero(input);
}

void Session::updateRope(const TickInput& input) {
    if (input.fire && !state_.fireHeld) state_.buffer = inputBuffer;
    if (!input.fire) state_.buffer = 0;
    state_.fireHeld = input.fire;
    if (state_.cooldown > 0) --state_.cooldown;

    if (!input.fire && rope_.state() != Rope::State::idle) {
        rope_.release(*world_);
        events_.released = true;
    }
    if (state_.buffer > 0 && rope_.state() == Rope::State::idle && state_.cooldown == 0) {
        rope_.shoot(heroPosition(), state_.aim);
        state_.buffer = 0;
        events_.fired = true;
    }
    if (state_.buffer > 0) --state_.buffer;

    if (rope_.state() == Rope::State::attached) {
        const RopeRules& rules = rope_.rules();
        const Real speed = input.boost ? rules.boostSpeed : rules.reelSpeed;
        const int way = (input.reelOut ? 1 : 0) - (input.reelIn ? 1 : 0);
        rope_.hold(*world_, hand_, static_cast<Real>(way) * speed);
    } else if (rope_.state() == Rope::State::flying) {
        const Rope::Landing landing = rope_.fly(*world_, hand_, *this);
        events_.stuck = landing == Rope::Landing::stuck;
        events_.slipped = landing == Rope::Landing::slipped;
        events_.missed = landing == Rope::Landing::missed;
        if (events_.slipped || events_.missed) state_.cooldown = cooldown;
    }
}

void Session::pushHero(const TickInput& input) {
    if (input.push == 0 || rope_.state() != Rope::State::attached) return;
    const Real acceleration =
        heroRules_.push / heroRules_.mass * (static_cast<Real>(input.push) / Real(127));
    for (const sulfur::ParticleId particle : world_->particles(hero_)) {
        world_->applyForce(particle, {acceleration * world_->info(particle).mass, 0});
    }
}

/// A spring towards the middle of the gate, about critically damped, that also carries the hero's
/// weight: who has arrived stays.
void Session::drawIntoGate() {
    const Vec2 away = (level_->exit.position - world_->centreOfMass(hero_)).cast<Real>();
    const Vec2 acceleration =
        Real(36) * away - Real(11) * world_->meanVelocity(hero_) - world_->gravity();
    for (const sulfur::ParticleId particle : world_->particles(hero_)) {
        world_->applyForce(particle, acceleration * world_->info(particle).mass);
    }
}

void Session::limitSpeed() {
    const Vec2 mean = world_->meanVelocity(hero_);
    const Real speed = mean.norm();
    if (speed <= heroRules_.speedLimit) return;
    const Vec2 excess = mean * ((speed - heroRules_.speedLimit) / speed);
    for (const sulfur::ParticleId particle : world_->particles(hero_)) {
        world_->setVelocity(particle, world_->velocity(particle) - excess);
    }
}

void Session::noticeImpact() {
    for (const sulfur::ContactBegun& contact : world_->events().contactsBegun) {
        if (contact.a != hero_ && contact.b != hero_) continue;
        events_.impact = std::max(events_.impact, static_cast<float>(contact.speed));
    }
}

void Session::judge() {
    if (state_.phase == Phase::finished) return;
    const Point hero = heroPosition();
    if (hero.y() < level_->killDepth) {
        restart();
        return;
    }
    const Point gap = hero - level_->exit.position;
    if (gap.squaredNorm() > level_->exit.radius * level_->exit.radius) return;
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

Medal Session::medal() const {
    return state_.phase == Phase::finished ? level_->medalFor(seconds()) : Medal::none;
}

bool Session::holds(sulfur::BodyId body) const {
    return !std::binary_search(slippery_.begin(), slippery_.end(), body);
}

AimPreview Session::preview(Vec2 direction) const {
    AimPreview preview;
    preview.from = heroPosition();
    preview.to = preview.from + (direction * rope_.rules().reach).cast<double>();
    const auto hit =
        world_->castSegment(preview.from, preview.to, {.mask = ~(Category::hero | Category::rope)});
    if (!hit) return preview;
    preview.to = hit->point;
    preview.hits = true;
    preview.sticks = holds(hit->body);
    return preview;
}

std::uint64_t Session::hash() const {
    Hash hash;
    hash.add(world_->hash()).add(rope_.hash());
    hash.add(static_cast<std::uint64_t>(state_.phase)).add(state_.ticks);
    hash.add(state_.firstAction).add(state_.finishTick);
    hash.add(static_cast<std::uint64_t>(state_.buffer));
    hash.add(static_cast<std::uint64_t>(state_.cooldown));
    hash.add(static_cast<std::uint64_t>(state_.fireHeld ? 1 : 0)).add(state_.aim);
    return hash.value();
}

std::shared_ptr<const Session::Snapshot> Session::snapshot() const {
    return std::make_shared<const Snapshot>(Snapshot{world_->snapshot(), rope_, state_});
}

void Session::restore(const Snapshot& snapshot) {
    world_->restore(snapshot.world);
    rope_ = snapshot.rope;
    state_ = snapshot.state;
    events_ = {};
}

}  // namespace quaoar
