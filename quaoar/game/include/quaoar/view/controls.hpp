// From keyboard, mouse and gamepad to the inputs of a tick.
#pragma once

#include <atlax/camera.hpp>
#include <atlax/input.hpp>
#include <quaoar/tick_input.hpp>

namespace quaoar {

/// Turns what the devices say into TickInputs. Whichever of mouse and right stick moved last aims.
///
/// Mouse aims, left button fires; W, Up or wheel up reels in, S, Down or wheel down reels out,
/// Shift doubles the speed, A and D or Left and Right push, R restarts. Gamepad: right stick aims,
/// right trigger fires, left trigger reels in, left bumper out, left stick pushes, North restarts.
class Controls {
public:
    /// `hero` in metres; `camera` and `size` are those of the last picture.
    TickInput read(const atlax::InputState& input, const atlax::Camera& camera,
                   atlax::PixelSize size, atlax::Vec2 hero);
    /// Whether the mouse aims at the moment, so that a crosshair makes sense.
    bool mouseAims() const { return !padAims_; }
    /// Ignores a fire button that is already held, until it is let go: the click that closed a
    /// menu must not shoot.
    void requireFreshFire() { fireBlocked_ = true; }

private:
    void aim(const atlax::InputState& input, const atlax::Camera& camera, atlax::PixelSize size,
             atlax::Vec2 hero);
    void wheel(const atlax::InputState& input);

    TickInput last_;
    bool padAims_ = false;
    bool fireBlocked_ = false;
    int sinceAim_ = 0;    ///< ticks since the mouse was last turned into a direction
    int wheelTicks_ = 0;  ///< ticks of reeling that the wheel has asked for; negative: in
};

}  // namespace quaoar
