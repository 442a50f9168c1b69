// Movers at work: kinematic bodies on their ways.
#pragma once

#include <cstdint>
#include <memory>
#include <quaoar/attempt.hpp>
#include <quaoar/signals.hpp>
#include <vector>

namespace quaoar {

class Movers {
public:
    Movers() = default;
    /// Puts movers with a phase where they are at the start.
    explicit Movers(const Attempt& attempt);

    /// One tick.
    void move(const Attempt& attempt, const Signals& signals);

    /// 0 at the start of its way, 1 at the end, by its place in Level::movers.
    double along(std::size_t place) const { return states_[place].along; }
    std::uint64_t hash() const;

private:
    struct Plan {
        sulfur::BodyId body;
        Signals::Place need = Signals::none;
        double angle = 0;                   // rad at the start
        std::vector<sulfur::Point> places;  // with the start; of a loop also back to it
        std::vector<double> lengths;        // m from the start to each place
    };
    struct State {
        std::uint64_t clock = 0;  ///< ticks for which it has moved
        bool begun = false;       ///< its signal has come on once
        double along = 0;
    };
    static Plan planOf(const Attempt& attempt, const Mover& mover);
    static sulfur::Pose poseOf(const Mover& mover, const Plan& plan, const State& state);
    static void advance(const Mover& mover, bool on, State& state);

    std::shared_ptr<const std::vector<Plan>> plans_;
    std::vector<State> states_;
};

}  // namespace quaoar
