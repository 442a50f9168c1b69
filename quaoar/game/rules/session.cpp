#include <quaoar/session.hpp>

#include <algorithm>
#include <cmath>

namespace quaoar {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

namespace {

HeroRules heroRulesOf(const Level& level) {
    HeroRules rules;
    if (level.speedLimit) rules.speedLimit = *level.speedLimit;
    return rules;
}

/// A long rope has longer links rather than more of them than its usual 80 at 4 m: it is as heavy
/// and as stiff a piece of rope for each metre, and costs no more.
RopeRules ropeRulesOf(const Level& level) {
    constexpr Real longest = 4;  // m, with links as they are
    RopeRules rules;
    if (level.reach) rules.reach = *level.reach;
    const Real scale = std::max(Real(1), rules.reach / longest);
    rules.linkLength *= scale;
    rules.linkMass *= scale;
    rules.stiffness /= scale;
    rules.damping /= scale;
    return rules;
}

}  // namespace

Session::Session(std::shared_ptr<const Level> level)
    : level_(std::move(level)), heroRules_(heroRulesOf(*level_)), rope_(ropeRulesOf(*level_)) {
    build();
    start_ = snapshot();
}

Session::~Session() = default;

void Session::build() {
    world_ = std::make_unique<sulfur::World>(level_->scene.settings);
    instance_ = sulfur::scene::instantiate(level_->scene, *world_);
    for (const sulfur::scene::Placement& placement : level_->scene.bodies) {
        const sulfur::BodyId body = instance_.body(placement.id);
        surfaces_.push_back(level_->surface(placement.id));
        world_->setUserData(body, surfaces_.size());  // pieces that break off inherit it
        if (surfaces_.back().cuts) blades_.push_back(body);
        deadly_ = deadly_ || surfaces_.back().deadly;
    }
    const sulfur::Body hero = world_->add(heroBlueprint(heroRules_), {.position = level_->spawn});
    hero_ = hero.id();
    hand_ = hero.front();
    workings_ = Workings(attempt());
    exitNeed_ = Signals::place(*level_, level_->exit.needs);
    for (const Pickup& pickup : level_->pickups) {
        pickupSignals_.push_back(Signals::place(*level_, pickup.signal));
    }
}

Attempt Session::attempt() {
    return {*level_, instance_, *world_, rope_, hero_, hand_, heroRules_.radius};
}

std::optional<std::size_t> Session::origin(sulfur::BodyId body) const {
    if (!world_->contains(body)) return std::nullopt;
    const std::uint64_t place = world_->userData(body);
    if (place == 0) return std::nullopt;
    return static_cast<std::size_t>(place - 1);
}

const Surface& Session::surface(sulfur::BodyId body) const {
    static const Surface plain;
    const auto place = origin(body);
    return place ? surfaces_[*place] : plain;
}

void Session::tick(const TickInput& input) {
    if (input.restart) {
        restart();
        return;
    }
    if (input.retry) {
        retry();
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
    work();
    brakeRolling();
    limitSpeed();
    const Vec2 velocity = heroVelocity();
    world_->step();
    noticeContacts(velocity);
    events_.defeated = workings_.monsters.notice(attempt(), workings_.zones);
    cutRope();
    judge();
}

void Session::act(const TickInput& input) {
    state_.aim = aimDirection(input);
    const bool anything = input.fire || input.reelIn || input.reelOut || input.push != 0;
    if (anything && state_.firstAction == 0) state_.firstAction = state_.ticks;
    updateRope(input);
    pushHero(input);
}

/// Signals first, from what the last tick has left; then all that goes by them.
void Session::work() {
    const Attempt attempt = this->attempt();
    Workings& w = workings_;
    events_.switched = w.switches.look(attempt);
    w.signals.clear();
    w.switches.report(w.signals);
    w.monsters.report(w.signals);
    for (std::size_t i = 0; i < pickupSignals_.size(); ++i) {
        if (pickedUp(i)) w.signals.turnOn(pickupSignals_[i]);
    }
    w.movers.move(attempt, w.signals);
    w.zones.act(attempt, w.signals);
    events_.crumbled = w.crumbling.wear(attempt);
    events_.respawned = w.respawns.act(attempt, w.signals);
    events_.noticed = w.monsters.behave(attempt);
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

/// What is soft rolls for ever on flat ground, because no material resists it, and its wobbling
/// walks it along. On the ground and without a rope a couple brakes him as the library's rolling
/// resistance does rigid discs, c R m g and a part that goes with the speed, at most what stops him
/// in this tick; and what his outline does beside the motion of a rigid body dies away. On what is
/// slick he slides all the same.
void Session::brakeRolling() {
    if (rope_.state() == Rope::State::attached || !state_.touching) return;
    if (world_->asleep(hero_)) return;
    const Real spin = static_cast<Real>(world_->angularVelocity(hero_));
    const Real inertia = world_->inertia(hero_);
    const Real weight = heroRules_.mass * world_->gravity().norm();
    const Real couple = heroRules_.rollingResistance * heroRules_.radius * weight +
                        heroRules_.rollingDamping * inertia * std::abs(spin);
    const Real most = inertia * std::abs(spin) / world_->tickDuration();
    world_->applyTorque(hero_, (spin > 0 ? -1 : 1) * std::min(couple, most));

    const Vec2 mean = world_->meanVelocity(hero_);
    const Point middle = world_->centreOfMass(hero_);
    for (const sulfur::ParticleId particle : world_->particles(hero_)) {
        const Vec2 arm = (world_->position(particle) - middle).cast<Real>();
        const Vec2 rigid = mean + spin * Vec2(-arm.y(), arm.x());
        const Vec2 wobble = world_->velocity(particle) - rigid;
        world_->applyForce(particle, wobble * (-heroRules_.settling * world_->info(particle).mass));
    }
}

void Session::limitSpeed() {
    const Vec2 mean = world_->meanVelocity(hero_);
    const Real speed = mean.norm();
    const Real limit = heroRules_.speedLimit;
    if (speed <= limit) return;
    const Vec2 excess = mean * ((speed - limit) / speed);
    // Where a scene bursts, single particles may be so fast that less of the mean is more than the
    // library takes.
    const Vec2 most = Vec2::Constant(1000);
    for (const sulfur::ParticleId particle : world_->particles(hero_)) {
        const Vec2 slower = world_->velocity(particle) - excess;
        world_->setVelocity(particle, slower.cwiseMax(-most).cwiseMin(most));
    }
}

bool Session::holds(sulfur::BodyId body) const {
    return surface(body).sticky;
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

}  // namespace quaoar
