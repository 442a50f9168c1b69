// The signals of a level: which are on.
#pragma once

#include <cstdint>
#include <quaoar/level.hpp>
#include <string_view>
#include <vector>

namespace quaoar {

class Signals {
public:
    /// A place in Level::signals, or -1.
    using Place = int;
    static constexpr Place none = -1;

    Signals() = default;
    explicit Signals(const Level& level) : on_(level.signals.size(), 0) {}

    static Place place(const Level& level, std::string_view name) {
        const auto found = level.signal(name);
        return found ? static_cast<Place>(*found) : none;
    }
    bool on(std::size_t signal) const { return on_[signal] != 0; }
    /// Whether what needs this signal may act; what needs none always may.
    bool met(Place need) const { return need == none || on_[static_cast<std::size_t>(need)] != 0; }

    void clear() { on_.assign(on_.size(), 0); }
    void turnOn(Place signal) {
        if (signal != none) on_[static_cast<std::size_t>(signal)] = 1;
    }

private:
    std::vector<std::uint8_t> on_;  // follows from switches and monsters, so it is not hashed
};

}  // namespace quaoar
