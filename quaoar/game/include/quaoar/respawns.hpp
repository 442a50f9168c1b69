// Bodies that come back to their places again and again.
#pragma once

#include <cstdint>
#include <memory>
#include <quaoar/attempt.hpp>
#include <quaoar/signals.hpp>
#include <vector>

namespace quaoar {

class Respawns {
public:
    Respawns() = default;
    /// Takes bodies that appear later out of the world.
    explicit Respawns(const Attempt& attempt);

    /// One tick. Whether something came back.
    bool act(const Attempt& attempt, const Signals& signals);
    std::uint64_t hash() const;

private:
    struct Plan {
        sulfur::BodyId body;
        Signals::Place need = Signals::none;
        int every = 0;  ///< ticks
        int phase = 0;  ///< ticks before the first time
    };
    static void bringBack(const Attempt& attempt, const Plan& plan, const Respawn& respawn);

    std::shared_ptr<const std::vector<Plan>> plans_;
    std::vector<std::uint64_t> clocks_;  ///< ticks for which each had its signal
};

}  // namespace quaoar
