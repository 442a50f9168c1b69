// From the player's actions to the inputs of a tick.
#pragma once

#include <atlax/camera.hpp>
#include <quaoar/tick_input.hpp>
#include <quaoar/view/player_actions.hpp>

namespace quaoar {

class Session;

/// What the player sees while playing: the last picture and what is in it.
struct PlayerSight {
    atlax::Camera camera;
    atlax::PixelSize size;
    atlax::Vec2 hero;    ///< metres
    bool roped = false;  ///< the rope flies or holds
};

/// Turns what the player does into TickInputs. Whichever of mouse and stick moved last aims.
///
/// A rope that is held when a pause begins is held through it: it hangs on until the button is let
/// go after going on, or, when it was let go during the pause, pressed and let go again.
class Controls {
public:
    /// `actions` must outlive the controls.
    explicit Controls(const PlayerActions& actions) : actions_(actions) {}

    /// In each tick of play. `input` is what `state` was sampled from.
    TickInput read(const atlax::ActionState& state, const atlax::InputState& input,
                   const PlayerSight& sight);
    /// When a pause begins, and in each tick of it. `countIn`: play is about to go on, and the
    /// button may be taken in hand again.
    void pause();
    void rest(const atlax::InputState& input, bool countIn);
    /// A new attempt: nothing is held.
    void reset();

    /// One press fires, the next lets go, instead of holding.
    void setToggle(bool on) { toggle_ = on; }
    /// Whether the mouse aims at the moment, so that a crosshair makes sense.
    bool mouseAims() const { return !stickAims_; }

private:
    void aim(const atlax::ActionState& state, const PlayerSight& sight);
    void wheel(const atlax::ActionState& state);
    bool wantsRope(const atlax::ActionState& state, const atlax::InputState& input, bool roped);
    bool toggled(const atlax::ActionState& state, bool roped);

    const PlayerActions& actions_;
    TickInput last_;
    atlax::Vec2 pointer_;  ///< pixels
    bool stickAims_ = false;
    int sinceAim_ = 0;          ///< ticks since the mouse was last turned into a direction
    int wheelTicks_ = 0;        ///< ticks of reeling that the wheel has asked for; negative: in
    bool kept_ = false;         ///< the rope hangs on from before a pause
    bool heldThrough_ = false;  ///< and the button is in hand: letting it go lets the rope go
    bool wasUp_ = false;        ///< the button, during the count-in
    bool toggle_ = false;
    bool toggledOn_ = false;
    bool toggleRoped_ = false;  ///< since it was toggled on there was a rope
};

/// Turns the aim of a shot by at most 6 degrees to the nearest place where the rope holds, when it
/// would miss or slip as it is.
void assistAim(TickInput& input, const Session& session);

}  // namespace quaoar
