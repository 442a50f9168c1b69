#include <quaoar/view/player_actions.hpp>

namespace quaoar {

using atlax::Binding;
using atlax::Key;
using atlax::MouseButton;
using atlax::PadAxis;
using atlax::PadButton;
using atlax::WheelWay;

PlayerActions::PlayerActions() {
    const auto key = Binding::key;
    const auto pad = Binding::pad;
    const auto axis = [](PadAxis a, bool negative = false) { return Binding::axis(a, negative); };

    fire =
        all.add("fire", {"play"}, {Binding::mouse(MouseButton::Left), axis(PadAxis::RightTrigger)});
    reelIn = all.add("reel_in", {"play"}, {key(Key::W), key(Key::Up), axis(PadAxis::LeftTrigger)});
    reelOut =
        all.add("reel_out", {"play"}, {key(Key::S), key(Key::Down), pad(PadButton::LeftShoulder)});
    boost = all.add("boost", {"play"},
                    {key(Key::LeftShift), key(Key::RightShift), pad(PadButton::RightShoulder)});
    left = all.add("left", {"play"}, {key(Key::A), key(Key::Left), axis(PadAxis::LeftX, true)});
    right = all.add("right", {"play"}, {key(Key::D), key(Key::Right), axis(PadAxis::LeftX)});
    restart = all.add("restart", {"play", "menu"}, {key(Key::R), pad(PadButton::North)});
    pause = all.add("pause", {"play", "menu"}, {key(Key::Escape), pad(PadButton::Start)});

    notchIn = all.add("notch_in", {"play"}, {Binding::wheel(WheelWay::Up)});
    notchOut = all.add("notch_out", {"play"}, {Binding::wheel(WheelWay::Down)});
    point = all.add("point", {"play"}, {Binding::mouse(MouseButton::Left)});
    aimLeft = all.add("aim_left", {"play"}, {axis(PadAxis::RightX, true)});
    aimRight = all.add("aim_right", {"play"}, {axis(PadAxis::RightX)});
    aimDown = all.add("aim_down", {"play"}, {axis(PadAxis::RightY, true)});
    aimUp = all.add("aim_up", {"play"}, {axis(PadAxis::RightY)});

    menuUp = all.add("menu_up", {"menu"}, {key(Key::Up), key(Key::W), pad(PadButton::DpadUp)});
    menuDown =
        all.add("menu_down", {"menu"}, {key(Key::Down), key(Key::S), pad(PadButton::DpadDown)});
    choose = all.add("choose", {"menu"},
                     {key(Key::Enter), key(Key::PadEnter), key(Key::Space), pad(PadButton::South)});
    click = all.add("click", {"menu"}, {Binding::mouse(MouseButton::Left)});

    fullscreen = all.add("fullscreen", {"play", "menu"}, {key(Key::F11)});
    picture = all.add("picture", {"play", "menu"}, {key(Key::F12)});
}

}  // namespace quaoar
