// Rows of touches as somebody else sees them who solves them together with rows of his own.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur::detail {

struct State;
struct TouchMasses;

/// The mover that a particle is, or that carries it; none where neither has a surface.
std::uint32_t moverOfParticle(const State& state, std::uint32_t particle);
std::uint32_t moverOfCluster(const State& state, std::uint32_t cluster);

/// How the motions of the three particles of a touch change what it measures.
struct TouchDirection {
    std::array<Vec2, 3> ways{};  // along which the motion of each makes it grow
    std::array<Real, 3> arms{};  // m, by which the turn of each one's mover does
    Real inverseMass = 0;        // 1/kg, of all bodies
};
/// A corner before a side, in the middle of the sweeps.
struct TouchView {
    std::array<std::uint32_t, 3> particles{};  // dense: corner, ends of the side
    std::array<std::uint32_t, 3> movers{};     // of these
    TouchDirection normal, tangent;
    Real gapBefore = 0, gap = 0;     // m, when the step begins and when it ends
    Real slop = 0;                   // m, of overlap that stays
    Real slide = 0;                  // m, in this step
    Real pressing = 0, rubbing = 0;  // kg m
    Real staticFriction = 0, kineticFriction = 0;
};
TouchView viewOfTouch(const State& state, std::uint32_t touch);
/// The same particles and pressing alone, and the movers of the three.
std::array<std::uint32_t, 3> particlesOfTouch(const State& state, std::uint32_t touch);
std::array<std::uint32_t, 3> moversOfTouch(const State& state, std::uint32_t touch);
Real pressingOf(const State& state, std::uint32_t touch);

/// Sets the effective masses of a row and returns what they were. Without them it neither presses
/// nor rubs nor moves apart in a sweep, and keeps what it gives.
TouchMasses changeMasses(State& state, std::uint32_t touch, TouchMasses masses);

/// Adds to what a touch presses and rubs, kg m. `have`: which of its three particles have that in
/// their displacements already.
void pressFromOutside(State& state, std::uint32_t touch, Real pressing, Real rubbing,
                      const std::array<bool, 3>& have);

}  // namespace sulfur::detail
