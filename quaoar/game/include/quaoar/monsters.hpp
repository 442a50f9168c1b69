// Monsters: bodies of the scene that see, crawl, leap, fly and are defeated.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <quaoar/attempt.hpp>
#include <quaoar/signals.hpp>
#include <quaoar/zones.hpp>
#include <vector>

namespace quaoar {

class Monsters {
public:
    enum class Mood : std::uint8_t {
        idle,
        alert,     ///< sees its target; a lunging one crouches
        angry,     ///< leaps, chases or flees
        defeated,  ///< a body like any other, for good
    };
    /// Ticks for which a lunging monster crouches, leaps and rests: 0.4, 0.8 and 1 s.
    static constexpr int crouch = 200;
    static constexpr int leap = 400;
    static constexpr int rest = 500;

    Monsters() = default;
    explicit Monsters(const Attempt& attempt);

    /// Before a tick of the world: looks around and moves. Whether one has noticed its target.
    bool behave(const Attempt& attempt);
    /// After it: what it stands on, what has struck it. Whether one was defeated.
    bool notice(const Attempt& attempt, const Zones& zones);
    void report(Signals& signals) const;

    /// By place in Level::monsters.
    Mood mood(std::size_t place) const { return states_[place].mood; }
    /// Where it goes or looks: -1 to the left, 1 to the right.
    int facing(std::size_t place) const { return states_[place].way; }
    /// Whether the surface of a body of the scene has lost its malice, by its place in the scene.
    bool harmless(std::size_t origin) const;
    std::uint64_t hash() const;

private:
    struct Plan {
        sulfur::BodyId body;
        std::size_t origin = 0;  ///< its place among the scene's bodies
        sulfur::Material material;
        sulfur::Point home{0, 0};  ///< m: where its middle began
        std::size_t joints = 0;    ///< that it began with
        Signals::Place onDefeat = Signals::none;
    };
    struct State {
        Mood mood = Mood::idle;
        int timer = 0;  ///< ticks left of what it does
        int way = 1;
        int stuck = 0;  ///< ticks without getting on
        bool grounded = false;
        bool sees = false;
    };
    /// One monster at work.
    struct One {
        const Attempt& attempt;
        const Monster& monster;
        const Plan& plan;
        State& state;

        std::optional<sulfur::Point> target() const;
        bool inSight(const sulfur::Point& target) const;
        void look();
        void act();
        void patrol() const;
        void follow(int sign) const;
        void lunge() const;
        void leapAt(const sulfur::Point& target) const;
        void swing() const;
        void crawl(int way) const;
        void steer(const sulfur::Vec2& wanted) const;
        void goHome() const;
        void defeat() const;
        bool isDefeated(const Zones& zones) const;
        double momentumOf(const sulfur::ContactBegun& contact) const;
        bool isStruck() const;
        sulfur::Point middle() const { return attempt.world.centreOfMass(plan.body); }
    };
    One one(const Attempt& attempt, std::size_t place);

    std::shared_ptr<const std::vector<Plan>> plans_;
    std::vector<State> states_;
};

}  // namespace quaoar
