#include <algorithm>
#include <cmath>
#include <quaoar/session.hpp>
#include <quaoar/view/controls.hpp>

namespace quaoar {
namespace {

/// A mouse speaks about once a frame; asking it every tick would only make recordings eight times
/// longer, because hero and camera move in between.
constexpr int ticksPerAim = 8;
/// One notch of the wheel reels 12 cm.
constexpr int ticksPerNotch = 40;
/// A stick that is hardly moved has no direction to speak of.
constexpr float leastStick = 0.2f;
/// Aims are whole numbers on the edge of a square: directions 0.06 to 0.11 degrees apart, finer
/// than a hand, and few enough that recordings stay small.
constexpr double aimSteps = 512;

void setCoarseAim(TickInput& input, atlax::Vec2 way) {
    const double x = static_cast<double>(way.x), y = static_cast<double>(way.y);
    const double reach = std::max(std::abs(x), std::abs(y));
    if (!(reach > 0) || !std::isfinite(reach)) return;
    input.aimX = static_cast<std::int16_t>(std::lround(x / reach * aimSteps));
    input.aimY = static_cast<std::int16_t>(std::lround(y / reach * aimSteps));
}

}  // namespace

void Controls::aim(const atlax::ActionState& state, const PlayerSight& sight) {
    const atlax::Vec2 stick =
        state.stick(actions_.aimLeft, actions_.aimRight, actions_.aimDown, actions_.aimUp);
    const atlax::Vec2 pointer{static_cast<float>(state.pointerX),
                              static_cast<float>(state.pointerY)};
    const bool moved = !(pointer == pointer_);
    pointer_ = pointer;
    if (atlax::length(stick) > leastStick) {
        stickAims_ = true;
        setCoarseAim(last_, stick);
        return;
    }
    const bool clicked = state.wasPressed(actions_.point);
    if (moved || clicked) stickAims_ = false;
    if (stickAims_) return;
    if (++sinceAim_ < ticksPerAim && !clicked) return;
    sinceAim_ = 0;
    setCoarseAim(last_, sight.camera.toWorld(pointer, sight.size) - sight.hero);
}

void Controls::wheel(const atlax::ActionState& state) {
    const int notches = state.pressCount(actions_.notchOut) - state.pressCount(actions_.notchIn);
    const int asked = notches * ticksPerNotch;
    if (asked != 0 && (asked < 0) != (wheelTicks_ < 0)) wheelTicks_ = 0;
    wheelTicks_ = std::clamp(wheelTicks_ + asked, -6 * ticksPerNotch, 6 * ticksPerNotch);
    if (wheelTicks_ < 0) {
        last_.reelIn = true;
        ++wheelTicks_;
    } else if (wheelTicks_ > 0) {
        last_.reelOut = true;
        --wheelTicks_;
    }
}

void Controls::pause() {
    kept_ = last_.fire && !toggle_;
    heldThrough_ = kept_;
    wasUp_ = false;
    wheelTicks_ = 0;
}

/// The click that chooses "Go on" is still down when the count-in begins, and takes nothing.
void Controls::rest(const atlax::InputState& input, bool countIn) {
    const bool held = actions_.held(actions_.fire, input);
    if (!held) heldThrough_ = false;
    wasUp_ = countIn && (wasUp_ || !held);
    if (wasUp_ && held) heldThrough_ = kept_;
}

void Controls::reset() {
    kept_ = heldThrough_ = toggledOn_ = toggleRoped_ = false;
    wheelTicks_ = 0;
    last_.fire = false;
}

/// The next press after the rope has gone by itself fires again.
bool Controls::toggled(const atlax::ActionState& state, bool roped) {
    if (toggledOn_ && toggleRoped_ && !roped) toggledOn_ = false;
    toggleRoped_ = toggledOn_ && (toggleRoped_ || roped);
    if (state.wasPressed(actions_.fire)) {
        toggledOn_ = !toggledOn_;
        toggleRoped_ = false;
    }
    return toggledOn_;
}

bool Controls::wantsRope(const atlax::ActionState& state, const atlax::InputState& input,
                         bool roped) {
    if (toggle_) return toggled(state, roped);
    const bool pressed = state.isDown(actions_.fire);
    if (!kept_) return pressed;
    if (heldThrough_) {
        heldThrough_ = actions_.held(actions_.fire, input);
        kept_ = heldThrough_;
        return kept_;
    }
    if (pressed) kept_ = false;
    return true;
}

TickInput Controls::read(const atlax::ActionState& state, const atlax::InputState& input,
                         const PlayerSight& sight) {
    aim(state, sight);
    last_.fire = wantsRope(state, input, sight.roped);
    last_.reelIn = state.isDown(actions_.reelIn);
    last_.reelOut = state.isDown(actions_.reelOut);
    last_.boost = state.isDown(actions_.boost);
    last_.restart = state.wasPressed(actions_.restart);
    last_.retry = state.wasPressed(actions_.retry);
    if (last_.restart || last_.retry) kept_ = toggledOn_ = false;
    wheel(state);
    // Sixteen steps a side are finer than a thumb and keep recordings short.
    const float step = std::round(state.axis(actions_.left, actions_.right) * 16) / 16;
    last_.push = static_cast<std::int8_t>(std::lround(step * 127));
    return last_;
}

void assistAim(TickInput& input, const Session& session) {
    constexpr int most = 12;  // half degrees
    const sulfur::Vec2 aim = aimDirection(input);
    const AimPreview straight = session.preview(aim);
    if (straight.hits && straight.sticks) return;
    const double x = static_cast<double>(aim.x()), y = static_cast<double>(aim.y());
    for (int step = 1; step <= most; ++step) {
        for (const int way : {step, -step}) {
            const double angle = 0.5 * way * 3.14159265358979 / 180;
            TickInput turned = input;
            setAim(turned, x * std::cos(angle) - y * std::sin(angle),
                   x * std::sin(angle) + y * std::cos(angle));
            const AimPreview preview = session.preview(aimDirection(turned));
            if (!preview.hits || !preview.sticks) continue;
            input = turned;
            return;
        }
    }
}

}  // namespace quaoar
