// A random world as plain data: what a seed makes, what is made smaller, printed, and kept as a
// test.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <sulfur/sulfur.hpp>
#include <vector>

namespace sulfur::lab {

/// What a thing is made as.
enum class Kind : std::uint8_t {
    ball,
    crate,
    plank,
    polygon,
    hook,
    wheel,
    springWheel,
    rod,
    rope,
    elasticRope,
    chain,
    jelly,
    blob,
    wall,
    cloth,
};
inline constexpr std::size_t kindCount = 15;

/// Who moves it.
enum class Role : std::uint8_t {
    free,    ///< physics
    driven,  ///< nobody can stop it: it goes at its velocity and turns with its spin
    sensor,  ///< physics, but it only feels
};

/// A body.
struct Thing {
    Kind kind = Kind::ball;
    Role role = Role::free;
    double size = 1;         ///< m, its largest extent
    double mass = 1;         ///< kg
    double variant = 0;      ///< 0 to 1: proportions, number of corners, links or segments
    double frequency = 100;  ///< rad/s, of a particle of something soft on one of its springs
    double friction = 0;     ///< kinetic coefficient; the static one is 1.25 times that
    double restitution = 0;
    double strength = 0;  ///< m/s^2 times its mass is the strength of its joints; 0: unbreakable
    Eigen::Vector2d place{0, 0};
    double angle = 0;
    Eigen::Vector2d velocity{0, 0};
    double spin = 0;  ///< rad/s
};

/// What holds two things together, or one of them to the hand.
struct Tie {
    enum class Kind : std::uint8_t { rod, spring, attachment, grab };
    Kind kind = Kind::rod;
    std::size_t a = 0, b = 0;       ///< things; a grab has no b
    double alongA = 0, alongB = 0;  ///< 0 to 1: which of their particles
    double frequency = 100;         ///< rad/s, of the lighter particle on a spring
};

/// A force field over the whole scene.
struct Influence {
    enum class Kind : std::uint8_t { uniform, radial, wind };
    Kind kind = Kind::uniform;
    double strength = 1;  ///< m/s^2, of a wind m/s
    double angle = 0;     ///< where it goes
};

/// A world and how long it is looked at.
struct Scene {
    int rate = 500;
    int ticks = 200;
    bool sleeping = false;
    double calm = 0;     ///< s: all that is free may fall asleep for so long before it is let go
    double gravity = 0;  ///< m/s^2, downwards
    double airFriction = 0;  ///< 1/s
    double room = 0;         ///< m, half of the width of the room round everything; 0: none
    double restsAfter = 0;   ///< s, after which nothing may move any more; 0: it may for ever
    bool contacts = true;    ///< false: everything passes through everything
    std::vector<Thing> things = {};
    std::vector<Tie> ties = {};
    std::vector<Influence> influences = {};

    /// Nothing from outside acts: momentum is kept.
    bool closed() const;
    /// Nothing from outside gives energy.
    bool undriven() const;
};

/// The scene of a seed.
Scene sceneOf(std::uint64_t seed);

/// The plan of a thing.
Blueprint planOf(const Thing& thing);

/// The radius of a plan about its origin, m.
double reachOf(const Blueprint& plan);

/// C++ that makes the scene.
std::string asCode(const Scene& scene);

}  // namespace sulfur::lab
