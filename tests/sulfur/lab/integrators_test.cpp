// The order of each integrator, measured on problems whose solution is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integrators/integrator.hpp"
#include "rope.hpp"

namespace {

using namespace sulfur::lab;

/// x'' = -x, started at (1, 0) with velocity (0, 1): a circle.
class Oscillator final : public System {
public:
    std::size_t size() const override { return 1; }
    Vec acceleration(std::size_t, const Vec& x, const Vec&, const State&) const override {
        return -x;
    }
    void jacobian(const State&, ChainJacobian& out) const override {
        out.resize(1);
        out.position.self[0] = -Mat::Identity();
    }
};

/// Two masses between walls: in their mode x2 = -x1 each feels 3 times its own displacement.
class TwoMasses final : public System {
public:
    std::size_t size() const override { return 2; }
    Vec acceleration(std::size_t i, const Vec& x, const Vec&, const State& others) const override {
        return -2 * x + others.x[1 - i];
    }
    void jacobian(const State&, ChainJacobian& out) const override {
        out.resize(2);
        for (auto& self : out.position.self) self = -2 * Mat::Identity();
        out.position.behind[0] = out.position.before[1] = Mat::Identity();
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

const IntegratorEntry& entryOf(const std::string& key) {
    for (const auto& entry : integrators())
        if (entry.key == key) return entry;
    throw std::out_of_range(key);
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

TEST(Rope, JacobianIsTheDerivativeOfTheAccelerations) {
    const Rope rope({.particles = 5, .stiffness = 300});
    State state = rope.start();
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        state.x[i] += Vec(0.01 * static_cast<double>(i), -0.02 * static_cast<double>(i * i));
        state.v[i] = Vec(0.3, -0.1 * static_cast<double>(i));
    }
    ChainJacobian jacobian;
    rope.jacobian(state, jacobian);
    Vecs before, after;
    rope.accelerations(state, before);
    constexpr double d = 1e-7;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        for (int axis = 0; axis < 2; ++axis) {
            State moved = state;
            moved.x[i][axis] += d;
            rope.accelerations(moved, after);
            EXPECT_NEAR((after[i] - before[i])[axis] / d, jacobian.position.self[i](axis, axis),
                        1e-2);
            if (i > 0) {
                EXPECT_NEAR((after[i - 1] - before[i - 1])[axis] / d,
                            jacobian.position.behind[i - 1](axis, axis), 1e-2);
            }
            moved = state;
            moved.v[i][axis] += d;
            rope.accelerations(moved, after);
            EXPECT_NEAR((after[i] - before[i])[axis] / d, jacobian.velocity.self[i](axis, axis),
                        1e-4);
        }
    }
}

TEST(Rope, AccelerationsAgreeOneByOneAndTogether) {
    for (const Damper damper : {Damper::full, Damper::axial}) {
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
