// Implicit Euler: v' = v + h a(x + h v', v'), x' = x + h v'.
//
// Solved for v' by Newton's method with step halving, with the matrix I - h da/dv - h^2 da/dx.
#include <cmath>
#include <limits>

#include "integrators/implicit_matrix.hpp"
#include "integrators/integrator.hpp"

namespace sulfur::lab {

namespace {

class ImplicitEuler final : public Integrator {
public:
    void step(const System& system, State& state, double h) override {
        guess_ = state;
        place(state, h, guess_);
        double error = residual(system, state, h, guess_, rest_);
        for (int pass = 0; pass < maxPasses && error > tolerance; ++pass) {
            system.jacobian(guess_, jacobian_);
            matrix_.solve(jacobian_, h, rest_, step_);
            // An error that is not finite gives no direction: the criterion will see the state.
            if (!std::isfinite(error) || !improve(system, state, h, error)) break;
        }
        state = guess_;
    }

private:
    static constexpr int maxPasses = 40;
    static constexpr double tolerance = 1e-9;  // m/s, of any particle

    static void place(const State& state, double h, State& guess) {
        for (std::size_t i = 0; i < state.x.size(); ++i) guess.x[i] = state.x[i] + h * guess.v[i];
    }

    /// Fills `out` with v' - v - h a and returns its largest norm; NaN counts as infinite.
    double residual(const System& system, const State& state, double h, const State& guess,
                    Vecs& out) {
        system.accelerations(guess, a_);
        out.resize(a_.size());
        double worst = 0;
        for (std::size_t i = 0; i < a_.size(); ++i) {
            out[i] = guess.v[i] - state.v[i] - h * a_[i];
            const double norm = out[i].norm();
            worst = norm > worst || std::isnan(norm) ? norm : worst;
        }
        return std::isnan(worst) ? std::numeric_limits<double>::infinity() : worst;
    }

    /// Goes along the Newton direction as far as the residual shrinks.
    bool improve(const System& system, const State& state, double h, double& error) {
        double way = 1;
        for (int halving = 0; halving < 12; ++halving, way /= 2) {
            trial_ = guess_;
            for (std::size_t i = 0; i < trial_.v.size(); ++i) trial_.v[i] -= way * step_[i];
            place(state, h, trial_);
            const double after = residual(system, state, h, trial_, trialRest_);
            if (!(after < error)) continue;
            std::swap(guess_, trial_);
            std::swap(rest_, trialRest_);
            error = after;
            return true;
        }
        return false;
    }

    State guess_, trial_;
    Vecs a_, rest_, trialRest_, step_;
    Jacobian jacobian_;
    ImplicitMatrix matrix_;
};

}  // namespace

std::unique_ptr<Integrator> makeImplicitEuler() {
    return std::make_unique<ImplicitEuler>();
}

}  // namespace sulfur::lab
