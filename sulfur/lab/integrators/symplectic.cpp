// Newton-Stoermer-Verlet (symplectic Euler) and Verlet in positions.
#include "integrators/integrator.hpp"

namespace sulfur::lab {

namespace {

/// v' = v + h a(x, v), x' = x + h v'.
class Nsv final : public Integrator {
public:
    void step(const System& system, State& state, double h) override {
        system.accelerations(state, a_);
        for (std::size_t i = 0; i < a_.size(); ++i) {
            state.v[i] += h * a_[i];
            state.x[i] += h * state.v[i];
        }
    }

private:
    Vecs a_;
};

/// x(t + h) = 2 x(t) - x(t - h) + h^2 a (the paper's equation 3). The velocity that dampers see is
/// the mean one of the last tick, (x(t) - x(t - h)) / h.
class Verlet final : public Integrator {
public:
    void begin(const System& system, const State& state, double h) override {
        system.accelerations(state, a_);
        before_ = state.x;
        for (std::size_t i = 0; i < a_.size(); ++i)
            before_[i] += -h * state.v[i] + h * h / 2 * a_[i];
    }
    void step(const System& system, State& state, double h) override {
        for (std::size_t i = 0; i < before_.size(); ++i) state.v[i] = (state.x[i] - before_[i]) / h;
        system.accelerations(state, a_);
        for (std::size_t i = 0; i < a_.size(); ++i) {
            const Vec next = 2 * state.x[i] - before_[i] + h * h * a_[i];
            before_[i] = state.x[i];
            state.x[i] = next;
            state.v[i] = (next - before_[i]) / h;
        }
    }

private:
    Vecs a_, before_;
};

}  // namespace

std::unique_ptr<Integrator> makeNsv() {
    return std::make_unique<Nsv>();
}

std::unique_ptr<Integrator> makeVerlet() {
    return std::make_unique<Verlet>();
}

}  // namespace sulfur::lab
