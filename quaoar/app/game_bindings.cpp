// Which key, button or stick does what.
#include <array>

#include "game.hpp"

namespace quaoar {

using atlax::Binding;

std::string Game::actionName(atlax::Action action) const {
    /// In the order of PlayerActions.
    const std::array<std::string, PlayerActions::changeable> names{
        texts_("Fire"),       texts_("Reel in"),     texts_("Reel out"),        texts_("Reel fast"),
        texts_("Swing left"), texts_("Swing right"), texts_("Last checkpoint"), texts_("Try again"),
        texts_("Pause")};
    return names[action];
}

std::vector<MenuItem> Game::controlItems() {
    std::vector<MenuItem> items;
    for (atlax::Action action = 0; action < PlayerActions::changeable; ++action) {
        const std::string label =
            actionName(action) + ": " + bindingNames(actions_.all.bindings(action), texts_);
        items.push_back({label, [this, action] {
                             captured_ = action;
                             show(Screen::bindings);
                         }});
    }
    items.push_back({texts_("As at first"), [this] {
                         actions_.all.resetBindings();
                         redo();
                     }});
    items.push_back({texts_("Back"), [this] { leaveWithPause(); }});
    return items;
}

/// One entry for each that the action has, to be changed; and one for another.
std::vector<MenuItem> Game::bindingItems() {
    std::vector<MenuItem> items;
    for (const Binding& binding : actions_.all.bindings(captured_))
        items.push_back({bindingName(binding, texts_), [this, binding] { startCapture(binding); }});
    items.push_back({texts_("Another key or button"), [this] { startCapture(std::nullopt); }});
    items.push_back({texts_("Back"), [this] { leaveWithPause(); }});
    return items;
}

std::vector<MenuItem> Game::conflictItems() {
    return {{texts_(instead_ ? "Swap them" : "Take it"), [this] { bind(*wanted_); }},
            {texts_("Leave it"), [this] { show(Screen::bindings); }}};
}

void Game::startCapture(std::optional<Binding> instead) {
    instead_ = instead;
    show(Screen::capture);
}

/// Escape keeps what there was. A wheel cannot be held, and these actions are.
void Game::capture(const atlax::Event& event) {
    const auto binding = Binding::captured(event);
    if (!binding || binding->device == Binding::Device::Wheel) return;
    if (*binding == Binding::key(atlax::Key::Escape)) return show(Screen::bindings);
    if (instead_ && *binding == Binding::key(atlax::Key::Delete)) {
        if (!actions_.unbind(captured_, *instead_))
            tell(texts_("{} needs a key and a button of the pad", {actionName(captured_)}));
        return show(Screen::bindings);
    }
    offer(*binding);
}

/// What nobody has is taken at once, what another action has is asked about.
void Game::offer(const Binding& binding) {
    wanted_ = binding;
    const auto owner = actions_.owner(captured_, binding);
    if (actions_.canBind(captured_, binding, instead_)) {
        if (owner) return show(Screen::conflict);
        return bind(binding);
    }
    tell(
        texts_("{} needs a key and a button of the pad", {actionName(owner ? *owner : captured_)}));
    show(Screen::bindings);
}

void Game::bind(const Binding& binding) {
    actions_.bind(captured_, binding, instead_);
    savePreferences();
    show(Screen::bindings);
}

}  // namespace quaoar
