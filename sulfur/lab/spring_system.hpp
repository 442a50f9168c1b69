// Particles and springs in any topology.
#pragma once

#include "integrators/system.hpp"

namespace sulfur::lab {

/// A spring with a damper along it.
struct Spring {
    std::size_t a, b;   ///< particles
    double stiffness;   ///< N/m
    double damping;     ///< N s/m
    double restLength;  ///< m
};

struct SpringPlan {
    std::vector<double> inverseMass;  ///< 1/kg; 0: held where it is
    std::vector<Spring> springs;
    double gravity = 0;  ///< m/s^2, downwards
};

class SpringSystem final : public System {
public:
    explicit SpringSystem(SpringPlan plan);

    std::size_t size() const override { return plan_.inverseMass.size(); }
    Vec acceleration(std::size_t i, const Vec& x, const Vec& v, const State& others) const override;
    void accelerations(const State& state, Vecs& out) const override;
    void jacobian(const State& state, Jacobian& out) const override;

private:
    SpringPlan plan_;
    std::vector<std::vector<std::size_t>> springsOf_;  ///< by particle
};

}  // namespace sulfur::lab
