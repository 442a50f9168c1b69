// Switches: rectangles that turn signals on.
#pragma once

#include <cstdint>
#include <memory>
#include <quaoar/attempt.hpp>
#include <quaoar/signals.hpp>
#include <vector>

namespace quaoar {

class Switches {
public:
    Switches() = default;
    explicit Switches(const Attempt& attempt);

    /// Looks who presses what. Whether a switch went on or off.
    bool look(const Attempt& attempt);
    void report(Signals& signals) const;

    /// By place in Level::switches.
    bool pressed(std::size_t place) const { return states_[place].pressed; }
    bool on(std::size_t place) const { return states_[place].on; }
    std::uint64_t hash() const;

private:
    struct State {
        bool pressed = false;
        bool on = false;
        int lasts = 0;  ///< ticks for which it stays on
    };
    static bool isPressed(const Attempt& attempt, const Switch& one);

    std::vector<Signals::Place> signals_;
    std::vector<State> states_;
};

}  // namespace quaoar
