// The elastic rope: shot, laid, reeled, released.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <sulfur/world.hpp>
#include <vector>

namespace quaoar {

/// Numbers of the rope.
struct RopeRules {
    /// m. Shorter links of the same rope are stiffer for their mass, beyond what the library takes
    /// as forces: with 0.05 m a tick costs six times as much.
    sulfur::Real linkLength = sulfur::Real(0.1);
    sulfur::Real linkMass = sulfur::Real(0.04);  ///< kg of a particle
    sulfur::Real stiffness = 2500;               ///< N/m of a link of linkLength
    sulfur::Real damping = sulfur::Real(0.5);    ///< N s/m of a link of linkLength
    sulfur::Real axialDamping = 3;               ///< N s/m between hand and anchor
    sulfur::Real radius = sulfur::Real(0.012);   ///< m: what a particle collides with
    sulfur::Real reelDamping = 12;               ///< N s/m of the same while the reel turns
    sulfur::Real reach = 3;                      ///< m: flight of the head, longest rope
    sulfur::Real shortest = sulfur::Real(0.3);   ///< m: no reeling beyond
    sulfur::Real headSpeed = 30;                 ///< m/s
    sulfur::Real reelSpeed = sulfur::Real(1.5);  ///< m/s
    sulfur::Real boostSpeed = 3;                 ///< m/s
    sulfur::Real reelForce = 160;                ///< N: above this tension the reel stalls
    /// m/s^2 by which the reel begins to draw, or brakes while it gives out.
    sulfur::Real reelStart = 30;
    /// m/s^2 by which it begins to give out, or ends to draw: less than gravity, so that whoever
    /// hangs on the rope follows it and it stays taut.
    sulfur::Real reelYield = 5;
};

/// The rope of one hero in one world. It is made of particles that are bodies of their own and of
/// joints between them, so that links can be taken away and added near the hand.
class Rope {
public:
    enum class State : std::uint8_t { idle, flying, attached };

    /// What a flying head ran into.
    enum class Landing : std::uint8_t { none, stuck, slipped, missed };

    /// Whether the rope holds on a body; asked when the head hits it.
    class Grip {
    public:
        virtual ~Grip() = default;
        virtual bool holds(sulfur::BodyId body) const = 0;
    };

    explicit Rope(const RopeRules& rules = {}) : rules_(rules) {}

    State state() const { return state_; }
    const RopeRules& rules() const { return rules_; }

    /// Sends the head off from the hand. Only when idle.
    void shoot(sulfur::Point from, sulfur::Vec2 direction);
    /// Moves a flying head by one tick; lays the rope when it sticks.
    Landing fly(sulfur::World& world, sulfur::ParticleId hand, const Grip& grip);
    /// Brings the reel nearer to `speed` m/s (negative shortens) and turns it for this tick, within
    /// the rope's bounds. Then applies the axial damping. Only when attached.
    void hold(sulfur::World& world, sulfur::ParticleId hand, sulfur::Real speed);
    /// Whether what it is tied to is still there. Only when attached.
    bool tied(const sulfur::World& world) const;
    /// The body that it is tied to, also when that broke off from another one; null unless
    /// attached.
    sulfur::BodyId hooked(const sulfur::World& world) const;
    /// Lets go and takes the rope out of the world; a flying head is called back.
    void release(sulfur::World& world);

    /// Length at rest, metres; 0 unless attached.
    double restLength() const;
    /// Tension of the link at the hand in the last tick, N; 0 unless attached.
    double tension(const sulfur::World& world) const;
    /// Where it is tied, or where the flying head is.
    sulfur::Point head(const sulfur::World& world) const;
    /// Particles from the anchor towards the hand, the hand not among them. Empty unless attached.
    const std::vector<sulfur::ParticleId>& particles() const { return beads_; }

    /// A 64-bit hash of what is not in the world's own state.
    std::uint64_t hash() const;

private:
    void lay(sulfur::World& world, sulfur::ParticleId hand, const sulfur::CastHit& hit);
    sulfur::ParticleId addBead(sulfur::World& world, sulfur::Point at, sulfur::Vec2 velocity,
                               sulfur::Real radius);
    void tieHand(sulfur::World& world, sulfur::ParticleId hand);
    void reel(sulfur::World& world, sulfur::ParticleId hand, sulfur::Real change);
    void dropBead(sulfur::World& world, sulfur::ParticleId hand);
    void insertBead(sulfur::World& world, sulfur::ParticleId hand);
    void damp(sulfur::World& world, sulfur::ParticleId hand, sulfur::Real wantedRate) const;
    sulfur::Real handStiffness() const { return rules_.stiffness * rules_.linkLength / handLink_; }
    sulfur::Real handDamping() const { return rules_.damping * rules_.linkLength / handLink_; }

    RopeRules rules_;
    State state_ = State::idle;
    sulfur::Point flyFrom_{0, 0};
    sulfur::Vec2 flyDirection_{1, 0};
    sulfur::Real flown_ = 0;
    std::vector<sulfur::ParticleId> beads_;
    sulfur::JointId handJoint_;
    sulfur::AttachmentId anchor_;
    sulfur::Real handLink_ = 0;   ///< m: rest length of the link at the hand
    sulfur::Real reelSpeed_ = 0;  ///< m/s, negative: the rope becomes shorter
};

}  // namespace quaoar
