// What the player can do, and the keys and buttons of it at first.
#pragma once

#include <atlax/actions.hpp>
#include <optional>

namespace quaoar {

/// The game's actions in their contexts "menu" (as at first), "play", and "capture", in which none
/// acts: there a key is waited for that an action is to be bound to. Owns the bindings. One thread.
struct PlayerActions {
    PlayerActions();

    atlax::Actions all{{"menu", "play", "capture"}};

    // -- play; in the order in which a menu lists them --
    atlax::Action fire{}, reelIn{}, reelOut{}, boost{}, left{}, right{}, retry{}, restart{},
        pause{};
    static constexpr int changeable = 9;  ///< so many of them the player may bind anew

    atlax::Action notchIn{}, notchOut{};                      ///< a notch of the wheel
    atlax::Action point{};                                    ///< the mouse aims again
    atlax::Action aimLeft{}, aimRight{}, aimDown{}, aimUp{};  ///< a stick

    // -- menus --
    atlax::Action menuUp{}, menuDown{}, menuLeft{}, menuRight{}, choose{}, click{}, back{};

    // -- both --
    atlax::Action fullscreen{}, picture{};

    /// Whether the game cannot be played without this action: firing, both ways of reeling, and the
    /// pause. Such a one keeps a key or mouse button, and a button of the gamepad.
    bool essential(atlax::Action action) const;
    /// Whether a key, button or trigger of the action is down, whatever the context.
    bool held(atlax::Action action, const atlax::InputState& input) const;

    /// Gives the action another binding, in place of `instead` where it is one of the action's,
    /// else beside those that it has. Another changeable action that had the binding gets `instead`
    /// for it, or, without `instead`, loses it. What canBind() refuses is not done.
    void bind(atlax::Action action, const atlax::Binding& binding,
              const std::optional<atlax::Binding>& instead = std::nullopt);
    /// The changeable action that bind() would take the binding from.
    std::optional<atlax::Action> owner(atlax::Action action, const atlax::Binding& binding) const;
    /// Whether bind() leaves every essential action a binding, and none more than 8.
    bool canBind(atlax::Action action, const atlax::Binding& binding,
                 const std::optional<atlax::Binding>& instead = std::nullopt) const;
    /// Takes a binding away, unless the action is essential and it is its last one of a device.
    bool unbind(atlax::Action action, const atlax::Binding& binding);
    /// Gives essential actions without a key or button their first ones again: for settings that
    /// somebody has written by hand.
    void mend();

private:
    /// Whether the action, if essential, can do with these bindings.
    bool suffices(atlax::Action action, const std::vector<atlax::Binding>& bindings) const;
};

/// Whether it belongs to a gamepad, else to keyboard and mouse.
bool ofPad(const atlax::Binding& binding);

}  // namespace quaoar
