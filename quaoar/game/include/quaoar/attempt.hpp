// What the mechanics of a level look at and act upon.
#pragma once

#include <quaoar/level.hpp>
#include <quaoar/rope.hpp>
#include <sulfur/world.hpp>

namespace quaoar {

/// The parts of one session. It owns nothing.
struct Attempt {
    const Level& level;
    const sulfur::scene::Instance& instance;
    sulfur::World& world;
    Rope& rope;
    sulfur::BodyId hero;
    sulfur::ParticleId hand;  ///< the particle in the middle of the hero
    sulfur::Real heroRadius;  ///< m

    sulfur::Point heroPosition() const { return world.position(hand); }
    /// The body of the scene that a body is, or that it broke off from, as a place in the scene's
    /// list; nothing for the hero and the rope.
    std::optional<std::size_t> origin(sulfur::BodyId body) const {
        const std::uint64_t place = world.userData(body);
        if (place == 0) return std::nullopt;
        return static_cast<std::size_t>(place - 1);
    }
};

}  // namespace quaoar
