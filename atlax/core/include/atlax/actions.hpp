#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <atlax/binding.hpp>
#include <atlax/input.hpp>

namespace atlax {

class Settings;

inline constexpr std::size_t maxActions = 64;

/// An action by its place in the order in which they were added.
using Action = std::uint8_t;

/// All actions in one tick: a plain value of small integers, so that a recording holds exactly what
/// the application saw.
struct ActionState {
    std::array<std::uint8_t, maxActions> values{};  ///< 0..255: how far a stick or trigger is moved
    std::array<std::uint8_t, maxActions> presses{};  ///< taps, and notches of a wheel, in this tick
    std::bitset<maxActions> down;
    std::bitset<maxActions> pressed;   ///< went down in this tick, or down and up again
    std::bitset<maxActions> released;  ///< went up in this tick
    std::int16_t pointerX = 0;         ///< of the mouse, pixels of the drawable area
    std::int16_t pointerY = 0;         ///< the same, y down

    bool operator==(const ActionState&) const = default;

    bool isDown(Action a) const { return a < maxActions && down[a]; }
    bool wasPressed(Action a) const { return a < maxActions && pressed[a]; }
    bool wasReleased(Action a) const { return a < maxActions && released[a]; }
    int pressCount(Action a) const { return a < maxActions ? presses[a] : 0; }
    /// 0..1
    float value(Action a) const {
        return a < maxActions ? static_cast<float>(values[a]) / 255.0f : 0.0f;
    }
    /// -1..1 from two opposite actions.
    float axis(Action negative, Action positive) const { return value(positive) - value(negative); }
    /// A vector of length 0..1 from four.
    Vec2 stick(Action left, Action right, Action down_, Action up) const;
};

/// What the user can do, and what it is bound to.
///
/// Each action belongs to contexts ("menu", "play", "editor") and acts only while one of them is
/// current. When the context changes, whatever is held must be let go before it acts again: the
/// click that closes a menu does not shoot. The same key may serve several actions; see
/// conflicts().
///
/// sample() is called once per tick with the tick's InputState and depends on nothing else, so the
/// same inputs give the same actions. Owns names and bindings. One thread. Errors are atlax::Error
/// and change nothing.
class Actions {
public:
    /// Throws Error unless there are 1 to 16 names, all different. The first is current.
    explicit Actions(std::vector<std::string> contexts);

    /// Adds an action with what it is bound to at first; no contexts means all of them. `name` is
    /// its key in settings: lower-case letters, digits and '_'. Throws Error for a bad or used
    /// name, an unknown context, or more than maxActions.
    Action add(std::string name, std::span<const std::string_view> contexts,
               std::vector<Binding> bindings);
    Action add(std::string name, std::initializer_list<std::string_view> contexts,
               std::vector<Binding> bindings);
    std::size_t count() const { return actions_.size(); }
    /// Throw Error for an action that does not exist, as all that follows does.
    const std::string& name(Action action) const;
    const std::vector<Binding>& bindings(Action action) const;

    /// Binds an action anew; at most 8 bindings, repeated ones are dropped. What is held must be
    /// let go before it acts.
    void rebind(Action action, std::vector<Binding> bindings);
    void resetBindings();
    /// Actions other than `action` that the binding already serves in a context of `action`.
    std::vector<Action> conflicts(Action action, const Binding& binding) const;

    /// From the next sample() on. Throws Error for an unknown name.
    void setContext(std::string_view name);
    const std::string& context() const { return contexts_[context_]; }

    /// How far a stick moves before it counts (round, 0..0.9, at first 0.2), and a trigger (0..0.9,
    /// at first 0.1); from there on the value grows from 0. Values outside are clamped.
    void setDeadZones(float stick, float trigger);
    float stickDeadZone() const { return stickDeadZone_; }
    float triggerDeadZone() const { return triggerDeadZone_; }
    /// The only pad that acts, or -1 for all, as at first.
    void setPad(int pad) { pad_ = pad; }

    /// The actions of a tick. A stick or trigger counts as down from half of its way, and as up
    /// again from 0.4, so that it does not flutter. The reference holds until the next call.
    const ActionState& sample(const InputState& input);
    const ActionState& current() const { return current_; }

    /// Writes bindings that differ from the first ones as "input.<action>", and the dead zones.
    void save(Settings& settings) const;
    /// Reads them. Whatever cannot be understood keeps what it had, and is named in what is
    /// returned, one sentence each.
    std::vector<std::string> load(const Settings& settings);

private:
    struct Entry {
        std::string name;
        std::bitset<16> contexts;
        std::vector<Binding> defaults;
        std::vector<Binding> bindings;
        bool blocked = false;  ///< until everything that it is bound to is let go
        float wheelRest = 0;   ///< of a notch, from wheels that turn smoothly
    };
    struct Reading;

    const Entry& entry(Action action) const;
    Reading read(Entry& entry, const InputState& input) const;
    void readPad(const Binding& binding, const PadState& pad, Reading& reading) const;
    void apply(std::size_t index, const Reading& reading);

    std::vector<std::string> contexts_;
    std::size_t context_ = 0;
    std::vector<Entry> actions_;
    float stickDeadZone_ = 0.2f;
    float triggerDeadZone_ = 0.1f;
    int pad_ = -1;
    ActionState current_;
};

}  // namespace atlax
