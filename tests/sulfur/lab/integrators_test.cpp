// The order of each integrator, measured on problems whose solution is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "entry_of.hpp"
#include "integrators/integrator.hpp"
#include "rope.hpp"
#include "spring_system.hpp"

namespace {

using namespace sulfur::lab;

/// x'' = -x, started at (1, 0) with velocity (0, 1): a circle.
class Oscillator final : public System {
public:
    std::size_t size() const override { return 1; }
    Vec acceleration(std::size_t, const Vec& x, const Vec&, const State&) const override {
        return -x;
    }
    void jacobian(const State&, Jacobian& out) const override {
        out.blocks = {{0, 0, -Mat::Identity(), Mat::Zero()}};
    }
};

/// Two masses between walls: in their mode x2 = -x1 each feels 3 times its own displacement.
class TwoMasses final : public System {
public:
    std::size_t size() const override { return 2; }
    Vec acceleration(std::size_t i, const Vec& x, const Vec&, const State& others) const override {
        return -2 * x + others.x[1 - i];
    }
    void jacobian(const State&, Jacobian& out) const override {
        out.blocks.clear();
        for (const std::size_t i : {0u, 1u}) {
            out.add(i, i, -2 * Mat::Identity(), Mat::Zero());
            out.add(i, 1 - i, Mat::Identity(), Mat::Zero());
        }
    }
};

double errorAfterOneSecond(const IntegratorEntry& entry, int ticks) {
    const Oscillator system;
    State state{{Vec(1, 0)}, {Vec(0, 1)}};
    const auto integrator = entry.make();
    const double h = 1.0 / ticks;
    integrator->begin(system, state, h);
    for (int i = 0; i < ticks; ++i) integrator->step(system, state, h);
    return (state.x[0] - Vec(std::cos(1.0), std::sin(1.0))).norm();
}

double coupledErrorAfterOneSecond(const IntegratorEntry& entry, int ticks) {
    const TwoMasses system;
    State state{{Vec(1, 0), Vec(-1, 0)}, {Vec(0, 0), Vec(0, 0)}};
    const auto integrator = entry.make();
    const double h = 1.0 / ticks;
    integrator->begin(system, state, h);
    for (int i = 0; i < ticks; ++i) integrator->step(system, state, h);
    return std::abs(state.x[0].x() - std::cos(std::sqrt(3.0)));
}

class EveryIntegrator : public testing::TestWithParam<std::string> {};

TEST_P(EveryIntegrator, ConvergesWithItsOrder) {
    const auto& entry = entryOf(GetParam());
    const double coarse = errorAfterOneSecond(entry, 100);
    const double fine = errorAfterOneSecond(entry, 200);
    EXPECT_NEAR(std::log2(coarse / fine), entry.order, 0.1);
}

TEST_P(EveryIntegrator, FollowsAFreeFall) {
    // A rope of one loose particle without spring force is a stone in thin air.
    Rope stone({.particles = 2, .airFriction = 0, .damping = 0, .stiffness = 0});
    const auto integrator = entryOf(GetParam()).make();
    State state = stone.start();
    constexpr double h = 0.001;
    integrator->begin(stone, state, h);
    for (int i = 0; i < 1000; ++i) integrator->step(stone, state, h);
    EXPECT_NEAR(state.x[0].y(), -9.81 / 2, 9.81 * h);
    EXPECT_NEAR(state.v[0].y(), -9.81, 9.81 * h);
}

INSTANTIATE_TEST_SUITE_P(Lab, EveryIntegrator,
                         testing::Values("euler", "suvat", "rk2", "rk2-held", "rk4", "rk4-held",
                                         "nsv", "verlet", "implicit"),
                         [](const auto& chosen) {
                             std::string name = chosen.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(RungeKutta, HoldingNeighboursCostsTheOrder) {
    for (const auto& [coupled, held] : {std::pair("rk2", "rk2-held"), {"rk4", "rk4-held"}}) {
        const auto order = [](const std::string& key) {
            return std::log2(coupledErrorAfterOneSecond(entryOf(key), 100) /
                             coupledErrorAfterOneSecond(entryOf(key), 200));
        };
        EXPECT_NEAR(order(coupled), entryOf(coupled).order, 0.15);
        EXPECT_NEAR(order(held), 1, 0.15);
    }
}

/// All blocks of a Jacobian as one dense matrix, by position or by velocity.
Eigen::MatrixXd dense(const Jacobian& jacobian, std::size_t particles, Mat Jacobian::Block::*part) {
    const auto n = static_cast<Eigen::Index>(2 * particles);
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n);
    for (const auto& block : jacobian.blocks)
        all.block<2, 2>(static_cast<Eigen::Index>(2 * block.row),
                        static_cast<Eigen::Index>(2 * block.column)) += block.*part;
    return all;
}

/// The same by differences.
Eigen::MatrixXd differences(const System& system, const State& state, Vecs State::*part) {
    const auto n = static_cast<Eigen::Index>(2 * system.size());
    Eigen::MatrixXd all(n, n);
    constexpr double d = 1e-6;
    for (Eigen::Index column = 0; column < n; ++column) {
        State low = state, high = state;
        (low.*part)[static_cast<std::size_t>(column / 2)][column % 2] -= d;
        (high.*part)[static_cast<std::size_t>(column / 2)][column % 2] += d;
        Vecs before, after;
        system.accelerations(low, before);
        system.accelerations(high, after);
        for (Eigen::Index i = 0; i < n / 2; ++i)
            all.block<2, 1>(2 * i, column) =
                (after[static_cast<std::size_t>(i)] - before[static_cast<std::size_t>(i)]) /
                (2 * d);
    }
    return all;
}

void expectJacobianIsDerivative(const System& system, const State& state, double tolerance) {
    Jacobian jacobian;
    system.jacobian(state, jacobian);
    const auto count = system.size();
    const Eigen::MatrixXd byPosition = dense(jacobian, count, &Jacobian::Block::position);
    EXPECT_LE((byPosition - differences(system, state, &State::x)).cwiseAbs().maxCoeff(),
              tolerance * byPosition.cwiseAbs().maxCoeff());
    const Eigen::MatrixXd byVelocity = dense(jacobian, count, &Jacobian::Block::velocity);
    EXPECT_LE((byVelocity - differences(system, state, &State::v)).cwiseAbs().maxCoeff(),
              tolerance * byVelocity.cwiseAbs().maxCoeff());
}

TEST(Rope, JacobianIsTheDerivativeOfTheAccelerations) {
    const Rope rope({.particles = 5, .stiffness = 300});
    State state = rope.start();
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        state.x[i] += Vec(0.01 * static_cast<double>(i), -0.02 * static_cast<double>(i * i));
        state.v[i] = Vec(0.3, -0.1 * static_cast<double>(i));
    }
    expectJacobianIsDerivative(rope, state, 1e-6);
}

/// A triangle of springs with one particle held, which is no chain.
SpringSystem triangle(double damping) {
    return SpringSystem({.inverseMass = {0, 2, 5, 1},
                         .springs = {{0, 1, 300, damping, 1},
                                     {1, 2, 200, damping, 1},
                                     {2, 0, 100, damping, 1},
                                     {0, 3, 50, damping, 0.5},
                                     {3, 1, 70, damping, 0.7}},
                         .gravity = 9.81});
}

State bentTriangle() {
    return {{Vec(0, 0), Vec(1.1, 0.1), Vec(0.4, 0.9), Vec(0.3, -0.5)},
            {Vec(0, 0), Vec(0.1, -0.2), Vec(0.5, 0.3), Vec(0, 0)}};
}

TEST(SpringSystem, JacobianIsTheDerivativeOfTheAccelerations) {
    expectJacobianIsDerivative(triangle(0), bentTriangle(), 1e-6);
    // With dampers the change of their direction is left out; at rest they have no force to turn.
    State resting = bentTriangle();
    resting.v.assign(resting.v.size(), Vec::Zero());
    expectJacobianIsDerivative(triangle(3), resting, 1e-6);
}

TEST(SpringSystem, AccelerationsAgreeOneByOneAndTogether) {
    const SpringSystem system = triangle(3);
    const State state = bentTriangle();
    Vecs together;
    system.accelerations(state, together);
    for (std::size_t i = 0; i < state.x.size(); ++i)
        EXPECT_LT((together[i] - system.acceleration(i, state.x[i], state.v[i], state)).norm(),
                  1e-9);
    EXPECT_EQ(together[0], Vec(0, 0));
}

TEST(ImplicitEuler, SolvesItsEquationForAnyTopology) {
    const SpringSystem system = triangle(3);
    const State before = bentTriangle();
    State after = before;
    constexpr double h = 0.05;
    makeImplicitEuler()->step(system, after, h);
    Vecs a;
    system.accelerations(after, a);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((after.v[i] - before.v[i] - h * a[i]).norm(), 1e-8);
        EXPECT_LT((after.x[i] - before.x[i] - h * after.v[i]).norm(), 1e-12);
    }
}

TEST(Rope, AccelerationsAgreeOneByOneAndTogether) {
    for (const auto damper : {sulfur::lab::Damper::full, sulfur::lab::Damper::axial}) {
        const Rope rope({.particles = 6, .stiffness = 500, .damper = damper});
        State state = rope.start();
        for (std::size_t i = 0; i < state.x.size(); ++i) {
            state.x[i] += Vec(0.004, -0.03) * static_cast<double>(i);
            state.v[i] = Vec(-0.2, 0.5) * static_cast<double>(i + 1);
        }
        Vecs together;
        rope.accelerations(state, together);
        for (std::size_t i = 0; i < state.x.size(); ++i)
            EXPECT_LT((together[i] - rope.acceleration(i, state.x[i], state.v[i], state)).norm(),
                      1e-9);
    }
}

}  // namespace
