// The names of keys and buttons, for the device that the player has in hand.
#pragma once

#include <atlax/event.hpp>
#include <quaoar/view/player_actions.hpp>
#include <quaoar/view/texts.hpp>
#include <string>

namespace quaoar {

/// "W", "left mouse button", "pad A" in the player's language.
std::string bindingName(const atlax::Binding& binding, const Texts& texts);
/// All of an action's, separated by commas; "-" for none.
std::string bindingNames(const std::vector<atlax::Binding>& bindings, const Texts& texts);

/// Knows which device was used last, and puts its keys and buttons into sentences.
class Prompts {
public:
    /// Both must outlive the prompts.
    Prompts(const PlayerActions& actions, const Texts& texts) : actions_(actions), texts_(texts) {}

    void event(const atlax::Event& event);
    bool pad() const { return pad_; }

    /// The first binding of the action on the device in hand, else the first of all.
    std::string name(atlax::Action action) const;
    /// Replaces {fire}, {reel_in}, {reel_out}, {boost}, {left}, {right}, {restart}, {pause} and
    /// {aim} by names, the sentence being translated already.
    std::string fill(std::string sentence) const;
    /// The actions that a sentence names in this way, in its order.
    std::vector<atlax::Action> named(const std::string& sentence) const;

    /// What a title screen says: the keys of everything.
    std::string controls() const;
    /// What a menu says: how to choose and to leave.
    std::string menu() const;

private:
    const PlayerActions& actions_;
    const Texts& texts_;
    bool pad_ = false;
};

}  // namespace quaoar
