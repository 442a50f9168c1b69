#include "player.hpp"

#include <algorithm>
#include <cmath>

namespace quaoar {
namespace {

constexpr double calmSpeed = 0.15;  // m/s
constexpr int calmTicks = 100;
/// Slower swings are neither helped nor braked, m/s.
constexpr double slowPush = 0.1;

int toTicks(double seconds) {
    return static_cast<int>(std::lround(seconds * Session::tickRate));
}

thread_local const std::atomic<bool>* stopFlag = nullptr;

}  // namespace

void stopPlayersBy(const std::atomic<bool>* flag) {
    stopFlag = flag;
}

Skill Skill::level(int level) {
    constexpr double factors[] = {2, 1.5, 1, 0.6, 0.3};
    const double factor = factors[std::clamp(level, 1, 5) - 1];
    Skill skill;
    skill.reaction *= 0.5 + 0.5 * factor;
    skill.reactionSpread *= factor;
    skill.aimSpread *= factor;
    skill.timingSpread *= factor;
    return skill;
}

/// Twelve uniform numbers less six: close to a normal distribution, and with these bits everywhere.
double Nerves::normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random_() >> 11) * 0x1p-53;
    return std::clamp(sum, -2.5, 2.5);
}

Slip Nerves::next() {
    Slip slip;
    slip.aim = skill_.aimSpread * normal();
    slip.press = toTicks(skill_.timingSpread * normal());
    slip.end = toTicks(skill_.timingSpread * normal());
    slip.reaction = toTicks(std::max(0.0, skill_.reaction + skill_.reactionSpread * normal()));
    return slip;
}

/// False when the attempt or the life is over.
bool Player::tick(const TickInput& input) {
    if (stopFlag != nullptr && *stopFlag) throw Stopped{};
    session_.tick(input);
    ++ticks_;
    if (recording_ != nullptr) recording_->append(input);
    trace_.push_back(session_.heroPosition());
    died_ = session_.events().died || session_.events().restarted;
    const bool slow = static_cast<double>(session_.heroVelocity().norm()) < calmSpeed;
    calm_ = slow ? calm_ + 1 : 0;
    return !died_ && session_.phase() == Session::Phase::playing;
}

Ending Player::stopped() const {
    return died_ ? Ending::died : Ending::finished;
}

bool Player::letGo(int ticks) {
    input_.fire = false;
    input_.reelIn = input_.reelOut = input_.boost = false;
    input_.push = 0;
    for (int n = 0; n < ticks; ++n) {
        if (!tick(input_)) return false;
    }
    return true;
}

Ending Player::wait(int ticks) {
    input_.fire = session_.rope().state() != Rope::State::idle;
    input_.reelIn = input_.reelOut = input_.boost = false;
    input_.push = 0;
    for (int n = 0; n < ticks; ++n) {
        if (!tick(input_)) return stopped();
    }
    return Ending::done;
}

Ending Player::giveUp() {
    TickInput input;
    input.retry = true;
    tick(input);
    return Ending::died;
}

Ending Player::carryOut(const Intention& intention, const Slip& slip) {
    trace_.clear();
    calm_ = 0;
    died_ = false;
    if (intention.hook == Intention::Hook::shoot) {
        const Ending shot = shoot(intention, slip);
        return shot == Ending::done ? holdOn(intention, slip) : shot;
    }
    const bool tied = session_.rope().state() == Rope::State::attached;
    if (intention.hook == Intention::Hook::keep && !tied) return Ending::missed;
    if (intention.hook == Intention::Hook::loose && !letGo(1)) return stopped();
    return holdOn(intention, slip);
}

/// Lets go, presses, and waits until the head sticks.
Ending Player::shoot(const Intention& intention, const Slip& slip) {
    const bool held = session_.rope().state() != Rope::State::idle;
    const int gap = held ? std::max(10, pressGap + slip.press) : std::max(1, slip.press);
    if (!letGo(gap)) return stopped();
    const sulfur::Point to = intention.aim - session_.heroPosition();
    const double cosine = std::cos(slip.aim), sine = std::sin(slip.aim);
    setAim(input_, to.x() * cosine - to.y() * sine, to.x() * sine + to.y() * cosine);
    input_.fire = true;
    bool fired = false;
    for (int n = 0; n < Session::tickRate; ++n) {
        if (!tick(input_)) return stopped();
        fired = fired || session_.rope().state() != Rope::State::idle;
        if (session_.rope().state() == Rope::State::attached) return Ending::done;
        const bool gone = fired && session_.rope().state() == Rope::State::idle;
        if (gone || session_.events().missed || session_.events().slipped) break;
    }
    return letGo(1) ? Ending::missed : stopped();
}

/// Whether it is time, `early` ticks before it would be.
bool Player::over(const Until& until, int early) const {
    const int elapsed = static_cast<int>(trace_.size()) + early;
    if (elapsed >= until.latest) return true;
    switch (until.kind) {
        case Until::Kind::time:
            return false;
        case Until::Kind::calm:
            return calm_ >= calmTicks;
        case Until::Kind::line:
            break;
    }
    if (elapsed < until.earliest) return false;
    const double seconds = static_cast<double>(early) / Session::tickRate;
    const sulfur::Point soon =
        session_.heroPosition() + session_.heroVelocity().cast<double>() * seconds;
    return (soon - until.place).dot(until.across) >= 0;
}

std::int8_t Player::pushOf(const Intention& intention) const {
    int way = intention.push;
    if (std::abs(intention.push) == 2) {
        const double sideways = static_cast<double>(session_.heroVelocity().x());
        way = std::abs(sideways) < slowPush ? 0 : sideways > 0 ? 1 : -1;
        if (intention.push < 0) way = -way;
    }
    return static_cast<std::int8_t>(127 * way);
}

Ending Player::holdOn(const Intention& intention, const Slip& slip) {
    input_.fire = intention.hook != Intention::Hook::loose;
    input_.reelIn = intention.reel < 0;
    input_.reelOut = intention.reel > 0;
    input_.boost = intention.boost;
    const int early = std::max(0, -slip.end);
    while (!over(intention.until, early)) {
        input_.push = pushOf(intention);
        if (!tick(input_)) return stopped();
        if (input_.fire && session_.rope().state() == Rope::State::idle) {
            return letGo(1) ? Ending::missed : stopped();
        }
    }
    for (int n = 0; n < slip.end; ++n) {
        if (!tick(input_)) return stopped();
    }
    return Ending::done;
}

}  // namespace quaoar
