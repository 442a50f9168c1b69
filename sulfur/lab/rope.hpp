// The paper's test rope: 40 particles in a row, horizontal and at rest, one end held.
#pragma once

#include "integrators/system.hpp"

namespace sulfur::lab {

enum class Damper {
    full,   ///< -b (v - v'), the paper's equation (1)
    axial,  ///< the part of it along the spring
};

/// Section 3.1 of the paper. What it does not say is marked.
struct RopeConstants {
    int particles = 40;         ///< the first one is held (not said: figure 4 shows it)
    double length = 0.05;       ///< m, of a spring at rest
    double mass = 0.05;         ///< kg, of a particle
    double airFriction = 0.02;  ///< N s/m, force per speed of a particle (unit not said)
    double gravity = 9.81;      ///< m/s^2 (not said)
    double damping = 0.2;       ///< N s/m
    double stiffness = 100;     ///< N/m
    Damper damper = Damper::full;
};

/// The particles that can move; the held one is the origin.
class Rope final : public System {
public:
    explicit Rope(const RopeConstants& constants) : c_(constants) {}

    State start() const;
    std::size_t size() const override { return static_cast<std::size_t>(c_.particles) - 1; }
    Vec acceleration(std::size_t i, const Vec& x, const Vec& v, const State& others) const override;
    void accelerations(const State& state, Vecs& out) const override;
    void jacobian(const State& state, Jacobian& out) const override;

    /// Joules. Dampers and air only take energy away, so no motion of the rope has more than this:
    /// the energy of the start above that of the rope hanging at rest.
    double budget() const;
    double kineticEnergy(const State& state) const;
    const RopeConstants& constants() const { return c_; }

private:
    /// The force on a particle at `x` from a neighbour at `y`.
    Vec pull(const Vec& x, const Vec& v, const Vec& y, const Vec& w) const;

    RopeConstants c_;
};

}  // namespace sulfur::lab
