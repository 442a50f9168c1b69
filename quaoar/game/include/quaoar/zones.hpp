// Zones at work: gravity, wind, liquid and death, coming and going.
#pragma once

#include <cstdint>
#include <memory>
#include <quaoar/attempt.hpp>
#include <quaoar/signals.hpp>
#include <vector>

namespace quaoar {

class Zones {
public:
    /// Ticks in which a zone comes to its full strength, or goes: 0.2 s.
    static constexpr int rampTicks = 100;

    Zones() = default;
    /// Adds what gravity and wind need to the world.
    explicit Zones(const Attempt& attempt);

    /// One tick: strengths follow signals and pulses, liquids push.
    void act(const Attempt& attempt, const Signals& signals);

    /// 0 to 1: how far a zone acts now, by its place in Level::zones.
    sulfur::Real strength(std::size_t place) const {
        return static_cast<sulfur::Real>(ramps_[place]) / rampTicks;
    }
    /// Whether a place is in a zone that kills.
    bool deadly(const Level& level, sulfur::Point place) const;
    std::uint64_t hash() const;

private:
    /// How a body of the scene floats.
    struct Float {
        sulfur::Real volume = 0;  ///< m^2 for each kg
        sulfur::Real depth = 0;   ///< m: half the height over which a particle submerges
    };
    struct Plan {
        std::vector<Signals::Place> needs;     // by zone
        std::vector<sulfur::FieldId> gravity;  // by zone, or null
        std::vector<sulfur::FieldId> wind;     // the same
        std::vector<Float> floats;             // by body of the scene; empty without liquids
        Float hero;
        Float rope;
    };
    void addFields(const Attempt& attempt, Plan& plan) const;
    static void findFloats(const Attempt& attempt, Plan& plan);
    void setFields(const Attempt& attempt, std::size_t place) const;
    static void wakeIn(const Attempt& attempt, const Zone& zone);
    void pushUp(const Attempt& attempt, std::size_t place) const;
    Float floatOf(const Attempt& attempt, sulfur::BodyId body) const;

    std::shared_ptr<const Plan> plan_;
    std::vector<int> ramps_;  ///< 0 to rampTicks
    std::uint64_t clock_ = 0;
};

}  // namespace quaoar
