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

constexpr float triggerPoint = 0.35f;

}  // namespace

void Controls::aim(const atlax::InputState& input, const atlax::Camera& camera,
                   atlax::PixelSize size, atlax::Vec2 hero) {
    for (const atlax::PadState& pad : input.pads) {
        const atlax::Vec2 stick = pad.connected ? pad.rightStick() : atlax::Vec2{};
        if (atlax::length(stick) < 0.35f) continue;
        padAims_ = true;
        setAim(last_, static_cast<double>(stick.x), static_cast<double>(stick.y));
        return;
    }
    const bool moved = atlax::length(input.mouseDelta) > 0;
    const bool clicked = input.wasPressed(atlax::MouseButton::Left);
    if (moved || clicked) padAims_ = false;
    if (padAims_) return;
    if (++sinceAim_ < ticksPerAim && !clicked) return;
    sinceAim_ = 0;
    const atlax::Vec2 way = camera.toWorld(input.mouse, size) - hero;
    setAim(last_, static_cast<double>(way.x), static_cast<double>(way.y));
}

void Controls::wheel(const atlax::InputState& input) {
    const int asked = static_cast<int>(std::lround(-input.wheel.y * ticksPerNotch));
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

TickInput Controls::read(const atlax::InputState& input, const atlax::Camera& camera,
                         atlax::PixelSize size, atlax::Vec2 hero) {
    using atlax::Key;
    aim(input, camera, size, hero);
    bool fire = input.isDown(atlax::MouseButton::Left);
    last_.reelIn = input.isDown(Key::W) || input.isDown(Key::Up);
    last_.reelOut = input.isDown(Key::S) || input.isDown(Key::Down);
    last_.boost = input.isDown(Key::LeftShift) || input.isDown(Key::RightShift);
    last_.restart = input.wasPressed(Key::R);
    float push = 0;
    if (input.isDown(Key::A) || input.isDown(Key::Left)) push -= 1;
    if (input.isDown(Key::D) || input.isDown(Key::Right)) push += 1;
    for (const atlax::PadState& pad : input.pads) {
        if (!pad.connected) continue;
        fire = fire || pad.axis(atlax::PadAxis::RightTrigger) > triggerPoint;
        last_.reelIn = last_.reelIn || pad.axis(atlax::PadAxis::LeftTrigger) > triggerPoint;
        last_.reelOut = last_.reelOut || pad.isDown(atlax::PadButton::LeftShoulder);
        last_.boost = last_.boost || pad.isDown(atlax::PadButton::RightShoulder);
        last_.restart = last_.restart || pad.wasPressed(atlax::PadButton::North);
        push += pad.leftStick().x;
    }
    wheel(input);
    if (fireBlocked_ && !fire) fireBlocked_ = false;
    last_.fire = fire && !fireBlocked_;
    // Sixteen steps a side are finer than a thumb and keep recordings short.
    const float step = std::round(std::clamp(push, -1.0f, 1.0f) * 16) / 16;
    last_.push = static_cast<std::int8_t>(std::lround(step * 127));
    return last_;
}

}  // namespace quaoar
