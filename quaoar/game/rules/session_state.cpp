// A session's state: hashed, saved, restored, begun anew.
#include <bit>
#include <quaoar/session.hpp>

#include "hash.hpp"

namespace quaoar {

using sulfur::Point;

std::uint64_t Session::hash() const {
    Hash hash;
    hash.add(world_->hash()).add(rope_.hash());
    hash.add(static_cast<std::uint64_t>(state_.phase)).add(state_.ticks);
    hash.add(state_.firstAction).add(state_.finishTick);
    hash.add(static_cast<std::uint64_t>(state_.buffer));
    hash.add(static_cast<std::uint64_t>(state_.cooldown));
    hash.add(static_cast<std::uint64_t>(state_.fireHeld ? 1 : 0)).add(state_.aim);
    hash.add(static_cast<std::uint64_t>(state_.touching ? 1 : 0));
    hash.add(static_cast<std::uint64_t>(state_.squeezed));
    hash.add(static_cast<std::uint64_t>(state_.deaths));
    hash.add(state_.reached).add(state_.pickedUp).add(state_.savedHash);
    return hash.add(workings_.hash()).value();
}

std::shared_ptr<const Session::Snapshot> Session::snapshot() const {
    return std::make_shared<const Snapshot>(Snapshot{world_->snapshot(), rope_, workings_, state_});
}

void Session::restore(const Snapshot& snapshot) {
    world_->restore(snapshot.world);
    rope_ = snapshot.rope;
    workings_ = snapshot.workings;
    state_ = snapshot.state;
    events_ = {};
    touch_.clear();
}

void Session::restart() {
    restore(*start_);
    ++restarts_;
    events_.restarted = true;
}

/// The end of the countdown ends the attempt, whatever was reached.
void Session::die(Death death) {
    const Point place = heroPosition();
    if (state_.saved && death != Death::late) {
        backToCheckpoint();
    } else {
        restart();
    }
    events_.died = true;
    events_.death = death;
    events_.diedAt = place;
}

/// Of the attempt, the clock and the player's hand go on; all else is as it was.
void Session::backToCheckpoint() {
    const State now = state_;
    restore(*now.saved);
    state_ = now;
    state_.pickedUp = now.saved->state.pickedUp;
    state_.buffer = 0;
    state_.cooldown = 0;
    state_.squeezed = 0;
    state_.touching = false;
    ++state_.deaths;
    rope_.release(*world_);
    placeHero(level_->checkpoints[static_cast<std::size_t>(state_.checkpoint)].position);
}

/// In his shape of rest, without motion.
void Session::placeHero(Point at) {
    const sulfur::Blueprint plan = heroBlueprint(heroRules_);
    const auto particles = world_->particles(hero_);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        world_->setPosition(particles[i], at + plan.particles[i].position.cast<double>());
    }
    world_->setVelocity(hero_, {0, 0}, 0);
}

std::optional<std::size_t> Session::checkpoint() const {
    if (state_.checkpoint < 0) return std::nullopt;
    return static_cast<std::size_t>(state_.checkpoint);
}

int Session::pickups() const {
    return std::popcount(state_.pickedUp);
}

}  // namespace quaoar
