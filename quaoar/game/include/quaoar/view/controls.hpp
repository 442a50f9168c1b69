// From the player's actions to the inputs of a tick.
#pragma once

#include <atlax/camera.hpp>
#include <quaoar/tick_input.hpp>
#include <quaoar/view/player_actions.hpp>

namespace quaoar {

/// Turns what the player does into TickInputs. Whichever of mouse and stick moved last aims.
class Controls {
public:
    /// `actions` must outlive the controls.
    explicit Controls(const PlayerActions& actions) : actions_(actions) {}

    /// `hero` in metres; `camera` and `size` are those of the last picture.
    TickInput read(const atlax::ActionState& state, const atlax::Camera& camera,
                   atlax::PixelSize size, atlax::Vec2 hero);
    /// Whether the mouse aims at the moment, so that a crosshair makes sense.
    bool mouseAims() const { return !stickAims_; }

private:
    void aim(const atlax::ActionState& state, const atlax::Camera& camera, atlax::PixelSize size,
             atlax::Vec2 hero);
    void wheel(const atlax::ActionState& state);

    const PlayerActions& actions_;
    TickInput last_;
    atlax::Vec2 pointer_;  ///< pixels
    bool stickAims_ = false;
    int sinceAim_ = 0;    ///< ticks since the mouse was last turned into a direction
    int wheelTicks_ = 0;  ///< ticks of reeling that the wheel has asked for; negative: in
};

}  // namespace quaoar
