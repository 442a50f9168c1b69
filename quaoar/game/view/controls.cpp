#include <algorithm>
#include <cmath>
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

}  // namespace

void Controls::aim(const atlax::ActionState& state, const atlax::Camera& camera,
                   atlax::PixelSize size, atlax::Vec2 hero) {
    const atlax::Vec2 stick =
        state.stick(actions_.aimLeft, actions_.aimRight, actions_.aimDown, actions_.aimUp);
    const atlax::Vec2 pointer{static_cast<float>(state.pointerX),
                              static_cast<float>(state.pointerY)};
    const bool moved = !(pointer == pointer_);
    pointer_ = pointer;
    if (atlax::length(stick) > leastStick) {
        stickAims_ = true;
        setAim(last_, static_cast<double>(stick.x), static_cast<double>(stick.y));
        return;
    }
    const bool clicked = state.wasPressed(actions_.point);
    if (moved || clicked) stickAims_ = false;
    if (stickAims_) return;
    if (++sinceAim_ < ticksPerAim && !clicked) return;
    sinceAim_ = 0;
    const atlax::Vec2 way = camera.toWorld(pointer, size) - hero;
    setAim(last_, static_cast<double>(way.x), static_cast<double>(way.y));
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

TickInput Controls::read(const atlax::ActionState& state, const atlax::Camera& camera,
                         atlax::PixelSize size, atlax::Vec2 hero) {
    aim(state, camera, size, hero);
    last_.fire = state.isDown(actions_.fire);
    last_.reelIn = state.isDown(actions_.reelIn);
    last_.reelOut = state.isDown(actions_.reelOut);
    last_.boost = state.isDown(actions_.boost);
    last_.restart = state.wasPressed(actions_.restart);
    wheel(state);
    // Sixteen steps a side are finer than a thumb and keep recordings short.
    const float step = std::round(state.axis(actions_.left, actions_.right) * 16) / 16;
    last_.push = static_cast<std::int8_t>(std::lround(step * 127));
    return last_;
}

}  // namespace quaoar
