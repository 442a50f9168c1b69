// One attempt at a level: the rules of the game on one world, without a window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <quaoar/hero.hpp>
#include <quaoar/level.hpp>
#include <quaoar/rope.hpp>
#include <quaoar/tick_input.hpp>
#include <quaoar/workings.hpp>
#include <sulfur/world.hpp>

namespace quaoar {

/// Where the rope would land if it were fired now.
struct AimPreview {
    sulfur::Point from{0, 0};
    sulfur::Point to{0, 0};  ///< on the first surface, or as far as the rope reaches
    bool hits = false;       ///< something is in reach
    bool sticks = false;     ///< and the rope would hold on it
};

/// What killed the hero.
enum class Death : std::uint8_t {
    none,
    fell,     ///< below the level, or far out of it
    touched,  ///< something deadly
    struck,   ///< by something fast and heavy
    crushed,  ///< squeezed flat
    zone,     ///< in a deadly zone
    late,     ///< the countdown has ended
    given,    ///< the player gave up this try: TickInput::retry
};

/// What happened in the last tick, for sounds and sparks.
struct TickEvents {
    bool fired = false;
    bool stuck = false;
    bool slipped = false;  ///< hit a surface on which the rope does not hold
    bool missed = false;   ///< flew to its end
    bool released = false;
    bool finished = false;
    bool restarted = false;  ///< back at the spawn
    bool died = false;       ///< back at the last checkpoint, or at the spawn
    Death death = Death::none;
    sulfur::Point diedAt{0, 0};  ///< m: where he was
    bool checkpoint = false;     ///< one was reached for the first time
    bool pickedUp = false;
    bool cut = false;           ///< the rope, by something sharp
    sulfur::Point cutAt{0, 0};  ///< m: there
    bool switched = false;      ///< a switch went on or off
    bool crumbled = false;      ///< something came loose
    bool noticed = false;       ///< a monster has seen what it looks for
    bool defeated = false;      ///< a monster was
    bool respawned = false;     ///< something came back to its place
    float impact = 0;           ///< m/s at which the hero began to touch something, 0: it did not
};

/// The game, 500 ticks a second. The same level and the same inputs give the same hash() on every
/// machine. Not thread-safe; sessions are independent of each other.
class Session : private Rope::Grip {
public:
    static constexpr int tickRate = 500;
    /// A shot that is asked for this many ticks too early (the last one is still on its way back)
    /// is fired as soon as it can be: 120 ms.
    static constexpr int inputBuffer = 60;
    /// Ticks after a miss or a slip before the arm can shoot again: 80 ms.
    static constexpr int cooldown = 40;

    enum class Phase : std::uint8_t { playing, finished };

    /// Keeps the level. Throws what sulfur::scene::instantiate throws.
    explicit Session(std::shared_ptr<const Level> level);
    ~Session() override;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// One tick. After the finish the world goes on without the player, and the gate keeps the
    /// hero.
    void tick(const TickInput& input);
    /// Back to the spawn: everything is as in a new session.
    void restart();
    /// Gives up this try: what death does. Back to the last checkpoint with the world as it was
    /// when that was reached, while the timer goes on; to the spawn where none was.
    void retry() { die(Death::given); }

    const Level& level() const { return *level_; }
    Phase phase() const { return state_.phase; }
    /// Ticks since the start of the attempt.
    std::uint64_t ticks() const { return state_.ticks; }
    /// Ticks since the player first did something, up to the finish.
    std::uint64_t timerTicks() const;
    /// The same in seconds: what medals are given for.
    double seconds() const { return static_cast<double>(timerTicks()) / tickRate; }
    Medal medal() const;
    /// Times that this session went back to the spawn. Not part of the hash.
    int restarts() const { return restarts_; }
    /// Times that the hero came back to a checkpoint in this attempt.
    int deaths() const { return state_.deaths; }
    /// The place in the level's list of the last checkpoint that was reached, or nothing.
    std::optional<std::size_t> checkpoint() const;
    bool reached(std::size_t checkpoint) const { return (state_.reached >> checkpoint & 1) != 0; }
    bool pickedUp(std::size_t pickup) const { return (state_.pickedUp >> pickup & 1) != 0; }
    /// How many of the level's pick-ups are collected.
    int pickups() const;
    /// Seconds until the level's countdown ends the attempt; nothing where there is none.
    std::optional<double> secondsLeft() const;

    sulfur::World& world() { return *world_; }
    const sulfur::World& world() const { return *world_; }
    const sulfur::scene::Instance& instance() const { return instance_; }
    /// Switches, movers, zones and the like as they are now.
    const Workings& workings() const { return workings_; }
    /// Whether the exit lets the hero in.
    bool exitOpen() const { return workings_.signals.met(exitNeed_); }
    /// The body of the scene that this one is, or that it broke off from, as a place in the scene's
    /// list; nothing for the hero and the rope, nor for what is gone: the
    /// events of a tick still tell of a rope that was let go at its end.
    std::optional<std::size_t> origin(sulfur::BodyId body) const;
    /// The surface of any body of the world.
    const Surface& surface(sulfur::BodyId body) const;
    sulfur::BodyId hero() const { return hero_; }
    /// The particle in the middle of the hero, where the rope is tied.
    sulfur::ParticleId hand() const { return hand_; }
    sulfur::Point heroPosition() const { return world_->position(hand_); }
    sulfur::Vec2 heroVelocity() const { return world_->meanVelocity(hero_); }
    const Rope& rope() const { return rope_; }
    /// The last tick's aim, of unit length.
    sulfur::Vec2 aim() const { return state_.aim; }
    AimPreview preview(sulfur::Vec2 direction) const;
    const TickEvents& events() const { return events_; }

    /// A 64-bit hash of everything that decides how the game goes on.
    std::uint64_t hash() const;

    /// Everything that decides how the game goes on, for search programs and rewinding.
    struct Snapshot;
    std::shared_ptr<const Snapshot> snapshot() const;
    /// Goes on from a snapshot of a session of the same level.
    void restore(const Snapshot& snapshot);

private:
    struct State {
        Phase phase = Phase::playing;
        std::uint64_t ticks = 0;
        std::uint64_t firstAction = 0;  ///< tick + 1 of the player's first action; 0: none yet
        std::uint64_t finishTick = 0;
        int buffer = 0;    ///< ticks for which a press is still remembered
        int cooldown = 0;  ///< ticks until the arm can shoot
        bool fireHeld = false;
        sulfur::Vec2 aim{1, 0};
        bool touching = false;  ///< the hero touched something in the last tick
        int squeezed = 0;       ///< ticks for which the hero has been squeezed flat
        int deaths = 0;
        std::uint64_t reached = 0;   ///< bits of checkpoints
        std::uint64_t pickedUp = 0;  ///< bits of pick-ups
        int checkpoint = -1;         ///< the last one that was reached
        /// The attempt when that was first reached, and its hash.
        std::shared_ptr<const Snapshot> saved;
        std::uint64_t savedHash = 0;
    };

    bool holds(sulfur::BodyId body) const override;
    void build();
    Attempt attempt();
    void work();
    void backToCheckpoint();
    void placeHero(sulfur::Point at);
    void act(const TickInput& input);
    void updateRope(const TickInput& input);
    void pushHero(const TickInput& input);
    void drawIntoGate();
    void brakeRolling();
    void limitSpeed();
    void lookAtContacts();
    void noticeContacts(const sulfur::Vec2& velocityBefore);
    bool strikes(const sulfur::ContactBegun& contact, const sulfur::Vec2& velocityBefore) const;
    bool harmless(sulfur::BodyId body) const;
    void cutRope();
    void collect();
    void judge();
    void die(Death death);
    Death deathNow();
    bool outside() const;
    void forgetFallen();
    bool touchedOnBothSides() const;
    bool squeezedFlat();
    void finish();

    std::shared_ptr<const Level> level_;
    HeroRules heroRules_;
    std::unique_ptr<sulfur::World> world_;
    sulfur::scene::Instance instance_;
    std::vector<Surface> surfaces_;           ///< of the scene's bodies, in its order
    std::vector<sulfur::BodyId> blades_;      ///< bodies that cut the rope
    bool deadly_ = false;                     ///< some body is
    std::vector<sulfur::ContactInfo> touch_;  ///< the hero's contacts of the last tick
    bool struck_ = false;                     ///< something deadly met him in the last tick
    sulfur::BodyId hero_;
    sulfur::ParticleId hand_;
    Rope rope_;
    Workings workings_;
    Signals::Place exitNeed_ = Signals::none;
    std::vector<Signals::Place> pickupSignals_;
    State state_;
    TickEvents events_;
    std::shared_ptr<const Snapshot> start_;
    int restarts_ = 0;
};

struct Session::Snapshot {
    sulfur::Snapshot world;
    Rope rope;
    Workings workings;
    State state;
};

}  // namespace quaoar
