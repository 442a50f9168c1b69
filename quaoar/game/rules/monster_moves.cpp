// How monsters move: by the grip of their surface, by leaps, by flying. Nothing sets their places.
#include <algorithm>
#include <cmath>
#include <quaoar/monsters.hpp>
#include <quaoar/session.hpp>

namespace quaoar {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

namespace {

constexpr Real agility = 5;  // 1/s: how fast a flying or swinging one takes up another velocity
constexpr int patience = Session::tickRate / 2;  // ticks without getting on before it turns round

Vec2 directionTo(const Point& from, const Point& to) {
    const Vec2 way = (to - from).cast<Real>();
    const Real length = way.norm();
    return length > 0 ? Vec2(way / length) : Vec2(0, 0);
}

}  // namespace

void Monsters::One::act() {
    switch (monster.behaviour) {
        case Monster::Behaviour::patrol:
            return patrol();
        case Monster::Behaviour::chase:
            return follow(1);
        case Monster::Behaviour::flee:
            return follow(-1);
        case Monster::Behaviour::lunge:
            return lunge();
        case Monster::Behaviour::hang:
            return swing();
    }
}

/// To and fro; round again where it does not get on.
void Monsters::One::patrol() const {
    state.mood = state.sees ? Mood::alert : Mood::idle;
    const double x = middle().x();
    const Real speed = static_cast<Real>(monster.speed);
    const Real forward = attempt.world.meanVelocity(plan.body).x() * static_cast<Real>(state.way);
    state.stuck = forward < speed / 5 ? state.stuck + 1 : 0;
    const bool turned = state.stuck > patience;
    if (x > monster.to || (turned && state.way > 0)) {
        state.way = -1;
    } else if (x < monster.from || (turned && state.way < 0)) {
        state.way = 1;
    }
    if (turned) state.stuck = 0;
    if (!monster.flies) return crawl(state.way);
    const Real lift = static_cast<Real>(plan.home.y() - middle().y());
    steer({speed * static_cast<Real>(state.way), std::clamp(lift, -speed, speed)});
}

/// After what it sees, or away from it.
void Monsters::One::follow(int sign) const {
    const auto goal = state.sees ? target() : std::nullopt;
    state.mood = goal ? Mood::angry : Mood::idle;
    if (!goal) return monster.flies ? goHome() : crawl(0);
    state.way = (goal->x() > middle().x() ? 1 : -1) * sign;
    if (!monster.flies) return crawl(state.way);
    steer(directionTo(middle(), *goal) * static_cast<Real>(sign * monster.speed));
}

/// Crouches while it sees, leaps, rests.
void Monsters::One::lunge() const {
    if (state.timer > 0) --state.timer;
    if (state.mood == Mood::angry) {
        if (state.timer == 0) {
            state.mood = Mood::idle;
            state.timer = rest;
        }
        return;
    }
    if (monster.flies) goHome();
    const auto goal = state.sees ? target() : std::nullopt;
    if (goal) state.way = goal->x() > middle().x() ? 1 : -1;
    if (state.mood == Mood::idle) {
        if (!goal || state.timer > 0) return;
        state.mood = Mood::alert;
        state.timer = crouch;
        return;
    }
    if (state.timer > 0) return;
    state.mood = Mood::idle;
    if (!goal || !(state.grounded || monster.flies)) return;
    leapAt(*goal);
    state.mood = Mood::angry;
    state.timer = leap;
}

/// At the speed of its leap, as high as to meet the target in spite of its weight.
void Monsters::One::leapAt(const Point& goal) const {
    sulfur::World& world = attempt.world;
    const Real speed = static_cast<Real>(monster.speed);
    Vec2 velocity = directionTo(middle(), goal) * speed;
    if (!monster.flies) {
        const Real time = static_cast<Real>((goal - middle()).norm()) / speed;
        velocity -= world.gravity() * (time / 2);
    }
    const Vec2 change = velocity - world.meanVelocity(plan.body);
    world.applyImpulse(plan.body, change * world.mass(plan.body), middle());
}

/// On ropes of the scene: sideways, towards what it sees.
void Monsters::One::swing() const {
    const auto goal = state.sees ? target() : std::nullopt;
    state.mood = goal ? Mood::angry : Mood::idle;
    if (!goal) return;
    state.way = goal->x() > middle().x() ? 1 : -1;
    const Real now = attempt.world.meanVelocity(plan.body).x();
    const Real wanted = static_cast<Real>(state.way * monster.speed);
    const Real push = agility * (wanted - now) * attempt.world.mass(plan.body);
    attempt.world.applyForce(plan.body, {push, 0}, middle());
}

/// As tracks do: its surface runs backwards where it lies, and friction takes it along, up to what
/// it can hold; so it also pulls what is tied to it. To the right for 1, not at all for 0.
void Monsters::One::crawl(int way) const {
    sulfur::Material material = plan.material;
    material.surfaceSpeed = static_cast<Real>(way * monster.speed);
    if (attempt.world.material(plan.body) == material) return;
    attempt.world.setMaterial(plan.body, material);
}

/// By a force on the whole body.
void Monsters::One::steer(const Vec2& wanted) const {
    const Vec2 change = wanted - attempt.world.meanVelocity(plan.body);
    const Vec2 force = change * (agility * attempt.world.mass(plan.body));
    attempt.world.applyForce(plan.body, force, middle());
}

void Monsters::One::goHome() const {
    const Vec2 away = (plan.home - middle()).cast<Real>();
    const Real speed = static_cast<Real>(monster.speed), distance = away.norm();
    if (distance < Real(0.01) && attempt.world.meanVelocity(plan.body).norm() < Real(0.01)) return;
    steer(distance > speed ? Vec2(away * (speed / distance)) : away);
}

}  // namespace quaoar
