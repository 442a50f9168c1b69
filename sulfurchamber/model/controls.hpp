// Keys that are held while time runs, and what they drive.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "document.hpp"

namespace sulfurchamber {

/// Drives the motors, winches and thrusters of a plan. What it does to the world goes through the
/// document, which records it: rewinding comes back to the bit.
class Controls {
public:
    /// Ignores what is not one of controlKeys().
    void hold(const std::string& key, bool down);
    void release() { held_.clear(); }
    bool holds(const std::string& key) const { return held_.contains(key); }
    const std::set<std::string>& held() const { return held_; }

    /// Before a tick.
    void tick(Document& document);

private:
    struct Driven {
        std::size_t mechanism = 0;
        DriveKeys keys;
    };

    int direction(const DriveKeys& keys) const;
    void readPlan(const Document& document);

    std::set<std::string> held_;
    std::optional<std::uint64_t> revision_;
    std::vector<Driven> driven_;  // mechanisms of the plan that have keys
};

/// Whether something of the plan answers to a key.
bool answersTo(const Document& document, const std::string& key);

/// What drives a mechanism: `direction` 1 forward, -1 back, 0 when no key is held. `plan` is its
/// drive in the plan, `now` what it is in the world. A motor stops, with its brake, and goes to its
/// target or back to 0 if it has one. A winch pulls while it winds, and else keeps its length as a
/// cable does. `tick` in seconds.
sulfur::Drive drivenBy(const sulfur::Drive& plan, const DriveKeys& keys, int direction,
                       const sulfur::MechanismInfo& now, double tick);

}  // namespace sulfurchamber
