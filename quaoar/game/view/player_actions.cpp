#include <algorithm>
#include <quaoar/view/player_actions.hpp>

namespace quaoar {

using atlax::Action;
using atlax::Binding;
using atlax::Key;
using atlax::MouseButton;
using atlax::PadAxis;
using atlax::PadButton;
using atlax::WheelWay;

namespace {

constexpr std::size_t mostBindings = 8;  ///< what atlax::Actions takes

Binding axis(PadAxis a, bool negative = false) {
    return Binding::axis(a, negative);
}

bool contains(const std::vector<Binding>& bindings, const Binding& binding) {
    return std::find(bindings.begin(), bindings.end(), binding) != bindings.end();
}

std::vector<Binding> without(std::vector<Binding> bindings, const Binding& binding) {
    std::erase(bindings, binding);
    return bindings;
}

/// The same with `binding` in the place of `instead`, or at the end of its kind when there is none.
std::vector<Binding> with(std::vector<Binding> bindings, const Binding& binding,
                          const std::optional<Binding>& instead) {
    std::erase(bindings, binding);
    if (instead) {
        const auto place = std::find(bindings.begin(), bindings.end(), *instead);
        if (place != bindings.end()) {
            *place = binding;
            return bindings;
        }
    }
    bindings.push_back(binding);
    return bindings;
}

bool down(const Binding& binding, const atlax::InputState& input) {
    constexpr float pushed = 0.5f;
    if (binding.device == Binding::Device::Key) return input.isDown(static_cast<Key>(binding.code));
    if (binding.device == Binding::Device::Mouse)
        return input.isDown(static_cast<MouseButton>(binding.code));
    return std::any_of(input.pads.begin(), input.pads.end(), [&](const atlax::PadState& pad) {
        if (binding.device == Binding::Device::PadButton)
            return pad.isDown(static_cast<PadButton>(binding.code));
        if (binding.device != Binding::Device::PadAxis) return false;
        const float value = pad.axis(static_cast<PadAxis>(binding.code));
        return (binding.negative ? -value : value) >= pushed;
    });
}

}  // namespace

bool ofPad(const Binding& binding) {
    return binding.device == Binding::Device::PadButton ||
           binding.device == Binding::Device::PadAxis;
}

PlayerActions::PlayerActions() {
    const auto key = Binding::key;
    const auto pad = Binding::pad;
    const auto mouse = Binding::mouse;

    fire = all.add("fire", {"play"}, {mouse(MouseButton::Left), axis(PadAxis::RightTrigger)});
    reelIn =
        all.add("reel_in", {"play"},
                {key(Key::W), key(Key::Up), mouse(MouseButton::Right), axis(PadAxis::LeftTrigger)});
    reelOut =
        all.add("reel_out", {"play"}, {key(Key::S), key(Key::Down), pad(PadButton::LeftShoulder)});
    boost = all.add("boost", {"play"},
                    {key(Key::LeftShift), key(Key::RightShift), pad(PadButton::RightShoulder)});
    left = all.add("left", {"play"}, {key(Key::A), key(Key::Left), axis(PadAxis::LeftX, true)});
    right = all.add("right", {"play"}, {key(Key::D), key(Key::Right), axis(PadAxis::LeftX)});
    retry = all.add("retry", {"play"}, {key(Key::Backspace), key(Key::C), pad(PadButton::West)});
    restart = all.add("restart", {"play", "menu"}, {key(Key::R), pad(PadButton::North)});
    pause = all.add("pause", {"play", "menu"},
                    {key(Key::Escape), mouse(MouseButton::Middle), pad(PadButton::Start)});

    notchIn = all.add("notch_in", {"play"}, {Binding::wheel(WheelWay::Up)});
    notchOut = all.add("notch_out", {"play"}, {Binding::wheel(WheelWay::Down)});
    point = all.add("point", {"play"}, {mouse(MouseButton::Left)});
    aimLeft = all.add("aim_left", {"play"}, {axis(PadAxis::RightX, true)});
    aimRight = all.add("aim_right", {"play"}, {axis(PadAxis::RightX)});
    aimDown = all.add("aim_down", {"play"}, {axis(PadAxis::RightY, true)});
    aimUp = all.add("aim_up", {"play"}, {axis(PadAxis::RightY)});

    menuUp = all.add("menu_up", {"menu"},
                     {key(Key::Up), key(Key::W), Binding::wheel(WheelWay::Up),
                      pad(PadButton::DpadUp), axis(PadAxis::LeftY)});
    menuDown = all.add("menu_down", {"menu"},
                       {key(Key::Down), key(Key::S), Binding::wheel(WheelWay::Down),
                        pad(PadButton::DpadDown), axis(PadAxis::LeftY, true)});
    menuLeft = all.add(
        "menu_left", {"menu"},
        {key(Key::Left), key(Key::A), pad(PadButton::DpadLeft), axis(PadAxis::LeftX, true)});
    menuRight =
        all.add("menu_right", {"menu"},
                {key(Key::Right), key(Key::D), pad(PadButton::DpadRight), axis(PadAxis::LeftX)});
    choose = all.add("choose", {"menu"},
                     {key(Key::Enter), key(Key::PadEnter), key(Key::Space), pad(PadButton::South)});
    click = all.add("click", {"menu"}, {mouse(MouseButton::Left)});
    back = all.add("back", {"menu"},
                   {key(Key::Backspace), mouse(MouseButton::Right), pad(PadButton::East)});

    fullscreen = all.add("fullscreen", {"play", "menu"}, {key(Key::F11)});
    picture = all.add("picture", {"play", "menu"}, {key(Key::F12)});
}

bool PlayerActions::essential(Action action) const {
    return action == fire || action == reelIn || action == reelOut || action == pause;
}

bool PlayerActions::held(Action action, const atlax::InputState& input) const {
    const std::vector<Binding>& bindings = all.bindings(action);
    return std::any_of(bindings.begin(), bindings.end(),
                       [&](const Binding& binding) { return down(binding, input); });
}

bool PlayerActions::suffices(Action action, const std::vector<Binding>& bindings) const {
    if (bindings.size() > mostBindings) return false;
    if (!essential(action)) return true;
    const auto pads = std::count_if(bindings.begin(), bindings.end(), ofPad);
    return pads > 0 && static_cast<std::size_t>(pads) < bindings.size();
}

std::optional<Action> PlayerActions::owner(Action action, const Binding& binding) const {
    for (const Action other : all.conflicts(action, binding))
        if (other < changeable) return other;
    return {};
}

bool PlayerActions::canBind(Action action, const Binding& binding,
                            const std::optional<Binding>& instead) const {
    if (!suffices(action, with(all.bindings(action), binding, instead))) return false;
    const auto other = owner(action, binding);
    if (!other) return true;
    const std::vector<Binding>& theirs = all.bindings(*other);
    return suffices(*other, instead ? with(without(theirs, *instead), *instead, binding)
                                    : without(theirs, binding));
}

void PlayerActions::bind(Action action, const Binding& binding,
                         const std::optional<Binding>& instead) {
    if (!canBind(action, binding, instead)) return;
    if (const auto other = owner(action, binding)) {
        const std::vector<Binding>& theirs = all.bindings(*other);
        all.rebind(*other, instead ? with(without(theirs, *instead), *instead, binding)
                                   : without(theirs, binding));
    }
    all.rebind(action, with(all.bindings(action), binding, instead));
}

bool PlayerActions::unbind(Action action, const Binding& binding) {
    const std::vector<Binding> rest = without(all.bindings(action), binding);
    if (!suffices(action, rest)) return false;
    all.rebind(action, rest);
    return true;
}

void PlayerActions::mend() {
    const PlayerActions fresh;
    for (Action action = 0; action < changeable; ++action) {
        if (suffices(action, all.bindings(action))) continue;
        std::vector<Binding> bindings = all.bindings(action);
        const auto pads = std::count_if(bindings.begin(), bindings.end(), ofPad);
        const bool lacksPad = pads == 0;
        const bool lacksKey = static_cast<std::size_t>(pads) == bindings.size();
        for (const Binding& first : fresh.all.bindings(action)) {
            const bool wanted = ofPad(first) ? lacksPad : lacksKey;
            if (wanted && !contains(bindings, first)) bindings.push_back(first);
        }
        if (bindings.size() > mostBindings) bindings = fresh.all.bindings(action);
        all.rebind(action, bindings);
    }
}

}  // namespace quaoar
