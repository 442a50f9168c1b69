// What the player can do, and the keys and buttons of it at first.
#pragma once

#include <atlax/actions.hpp>

namespace quaoar {

/// The game's actions in their contexts "menu" (as at first), "play", and "capture", in which none
/// acts: there a key is waited for that an action is to be bound to. Owns the bindings. One thread.
struct PlayerActions {
    PlayerActions();

    atlax::Actions all{{"menu", "play", "capture"}};

    // -- play; in the order in which a menu lists them --
    atlax::Action fire{}, reelIn{}, reelOut{}, boost{}, left{}, right{}, restart{}, pause{};
    static constexpr int changeable = 8;  ///< so many of them the player may bind anew

    atlax::Action notchIn{}, notchOut{};                      ///< a notch of the wheel
    atlax::Action point{};                                    ///< the mouse aims again
    atlax::Action aimLeft{}, aimRight{}, aimDown{}, aimUp{};  ///< a stick

    // -- menus --
    atlax::Action menuUp{}, menuDown{}, choose{}, click{};

    // -- both --
    atlax::Action fullscreen{}, picture{};
};

}  // namespace quaoar
