// What several scenes of the battery are built from.
#pragma once

#include <cstdint>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "battery/row.hpp"
#include "integrators/system.hpp"

namespace sulfur::lab {

inline constexpr double standardGravity = 9.81;  ///< m/s^2, downwards

inline Real real(double x) {
    return static_cast<Real>(x);
}
inline Vec2 vec2(double x, double y) {
    return {real(x), real(y)};
}

/// Whether the library computes in double.
inline constexpr bool doubleBuild = sizeof(Real) == sizeof(double);

/// A world in which nothing sleeps and no air brakes.
WorldSettings still(const Setup& setup, double gravity);

/// Advances by `seconds`, rounded to ticks.
void run(World& world, double seconds);

/// A body that is in nobody's way.
Blueprint ghost(std::string name);

/// A line of particles held together by joints of one kind.
struct ChainOptions {
    Vecs places;                         ///< m, of all particles; the first one is pinned
    std::vector<double> masses;          ///< kg, of all particles
    std::vector<double> lengths;         ///< m, rest length of each joint
    std::vector<double> stiffness = {};  ///< N/m of each joint; none: all are rigid
    double damping = 0;                  ///< N s/m
    bool pinLast = false;
};
Blueprint chain(const ChainOptions& options);

/// A lattice of columns x rows particles `cell` metres apart, with springs along both axes and
/// both diagonals. Row by row, from the bottom left.
struct LatticeOptions {
    int columns = 4, rows = 4;
    double cell = 0.25;
    double mass = 0.1;  ///< kg, of a particle
    double stiffness = 400;
    double damping = 0;
};
Blueprint lattice(const LatticeOptions& options);

/// A square net of rigid joints of 0.1 m between nodes of 10 g, row by row from the top left,
/// pinned at the upper corners.
struct NetOptions {
    std::uint32_t side = 10;   ///< nodes
    double load = 1;           ///< mass of the node in the middle, in that of the others
    bool secondCorner = true;  ///< whether it hangs by two corners, or by the left one only
};
Blueprint net(const NetOptions& options);

/// Numbers that are the same everywhere (SplitMix64).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double uniform(double low, double high);

private:
    std::uint64_t state_;
};

}  // namespace sulfur::lab
