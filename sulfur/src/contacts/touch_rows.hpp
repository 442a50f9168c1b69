// Rows of touches as somebody else sees them who solves them together with rows of his own.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>

namespace sulfur::detail {

struct State;

/// The mover that a particle is, or that carries it; none where neither has a surface.
std::uint32_t moverOfParticle(const State& state, std::uint32_t particle);
std::uint32_t moverOfCluster(const State& state, std::uint32_t cluster);

/// A corner before a side, in the middle of the sweeps.
struct TouchView {
    std::array<std::uint32_t, 3> particles{};  // dense: corner, ends of the side
    std::array<Vec2, 3> directions{};          // along which the motion of each makes the gap grow
    Real gapBefore = 0, gap = 0;               // m, when the step begins and when it ends
    Real pressing = 0;                         // kg m
    Real inverseMass = 0;                      // 1/kg, of all bodies
};
TouchView viewOfTouch(const State& state, std::uint32_t touch);
/// The same particles and pressing alone, and the movers of the three.
std::array<std::uint32_t, 3> particlesOfTouch(const State& state, std::uint32_t touch);
std::array<std::uint32_t, 3> moversOfTouch(const State& state, std::uint32_t touch);
Real pressingOf(const State& state, std::uint32_t touch);

/// Adds to what a touch presses. The corner or the side have the impulse in their displacements
/// already.
void pressFromOutside(State& state, std::uint32_t touch, Real impulse, bool cornerHas,
                      bool sideHas);

}  // namespace sulfur::detail
