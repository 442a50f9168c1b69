// Runge-Kutta methods, each in two readings.
//
// The method proper moves the whole system through its stages. A program that integrates one
// particle after the other instead may look at the neighbours only where they were when the tick
// began: the stages then see the particle's own spring and damper move, and nothing else. Of such a
// method's order nothing is left but the first, and its stability is that of a single particle
// between two walls.
#include "integrators/integrator.hpp"

namespace sulfur::lab {

namespace {

/// The classical tableaus have one number per stage: how far along the last slope it looks.
struct Tableau {
    std::vector<double> reach;   ///< of stage 2, 3, ...
    std::vector<double> weight;  ///< of each stage's slopes
};

/// Coupled: x and v of all particles go through the stages together.
class Coupled final : public Integrator {
public:
    explicit Coupled(Tableau tableau) : tableau_(std::move(tableau)) {}

    void step(const System& system, State& state, double h) override {
        const auto count = system.size();
        stage_ = state;
        sum_.x.assign(count, Vec::Zero());
        sum_.v.assign(count, Vec::Zero());
        for (std::size_t s = 0; s < tableau_.weight.size(); ++s) {
            system.accelerations(stage_, a_);
            for (std::size_t i = 0; i < count; ++i) {
                sum_.x[i] += tableau_.weight[s] * stage_.v[i];
                sum_.v[i] += tableau_.weight[s] * a_[i];
            }
            if (s == tableau_.reach.size()) break;
            const double reach = h * tableau_.reach[s];
            for (std::size_t i = 0; i < count; ++i) {
                stage_.x[i] = state.x[i] + reach * stage_.v[i];
                stage_.v[i] = state.v[i] + reach * a_[i];
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            state.x[i] += h * sum_.x[i];
            state.v[i] += h * sum_.v[i];
        }
    }

private:
    Tableau tableau_;
    State stage_, sum_;
    Vecs a_;
};

/// Held: each particle goes through the stages alone.
class Held final : public Integrator {
public:
    explicit Held(Tableau tableau) : tableau_(std::move(tableau)) {}

    void step(const System& system, State& state, double h) override {
        next_ = state;
        for (std::size_t i = 0; i < system.size(); ++i) {
            Vec x = state.x[i], v = state.v[i];
            Vec dx = Vec::Zero(), dv = Vec::Zero();
            for (std::size_t s = 0; s < tableau_.weight.size(); ++s) {
                const Vec a = system.acceleration(i, x, v, state);
                dx += tableau_.weight[s] * v;
                dv += tableau_.weight[s] * a;
                if (s == tableau_.reach.size()) break;
                const double reach = h * tableau_.reach[s];
                x = state.x[i] + reach * v;
                v = state.v[i] + reach * a;
            }
            next_.x[i] += h * dx;
            next_.v[i] += h * dv;
        }
        std::swap(state, next_);
    }

private:
    Tableau tableau_;
    State next_;
};

std::unique_ptr<Integrator> make(Tableau tableau, Stages stages) {
    if (stages == Stages::coupled) return std::make_unique<Coupled>(std::move(tableau));
    return std::make_unique<Held>(std::move(tableau));
}

}  // namespace

std::unique_ptr<Integrator> makeMidpoint(Stages stages) {
    return make({{0.5}, {0, 1}}, stages);
}

std::unique_ptr<Integrator> makeRungeKutta4(Stages stages) {
    return make({{0.5, 0.5, 1}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}}, stages);
}

}  // namespace sulfur::lab
