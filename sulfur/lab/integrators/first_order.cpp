// The explicit methods of first order.
#include "integrators/integrator.hpp"

namespace sulfur::lab {

namespace {

/// x' = x + h v, v' = v + h a(x, v).
class Euler final : public Integrator {
public:
    void step(const System& system, State& state, double h) override {
        system.accelerations(state, a_);
        for (std::size_t i = 0; i < a_.size(); ++i) {
            state.x[i] += h * state.v[i];
            state.v[i] += h * a_[i];
        }
    }

private:
    Vecs a_;
};

/// x' = x + h v + h^2 a(x, v) / 2, v' = v + h a(x, v): exact while a is constant.
class Suvat final : public Integrator {
public:
    void step(const System& system, State& state, double h) override {
        system.accelerations(state, a_);
        for (std::size_t i = 0; i < a_.size(); ++i) {
            state.x[i] += h * state.v[i] + h * h / 2 * a_[i];
            state.v[i] += h * a_[i];
        }
    }

private:
    Vecs a_;
};

}  // namespace

std::unique_ptr<Integrator> makeEuler() {
    return std::make_unique<Euler>();
}

std::unique_ptr<Integrator> makeSuvat() {
    return std::make_unique<Suvat>();
}

}  // namespace sulfur::lab
