// The stability limits, against the laws that they must follow.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "entry_of.hpp"
#include "integrators/linear_theory.hpp"
#include "limit_search.hpp"
#include "paper_tables.hpp"

namespace {

using namespace sulfur::lab;

TEST(Theory, MatchesTheClosedForms) {
    for (const double rate : {60.0, 500.0, 1000.0}) {
        const double h = 1 / rate, b = 0.2, m = 0.05;
        const ChainConstants chain{m, b, h};
        EXPECT_NEAR(*linearLimit(entryOf("euler"), chain, 1e9) * h / b, 1, 1e-3);
        EXPECT_NEAR(*linearLimit(entryOf("suvat"), chain, 1e9) * h / (2 * b), 1, 1e-3);
        const double nsv = m / (h * h) - 2 * b / h;
        EXPECT_NEAR(*linearLimit(entryOf("nsv"), chain, 1e9) / nsv, 1, 1e-3);
        EXPECT_NEAR(*linearLimit(entryOf("verlet"), chain, 1e9) / nsv, 1, 1e-3);
        EXPECT_FALSE(linearLimit(entryOf("implicit"), chain, 1e9));
    }
}

TEST(Limit, OfEulerAndSuvatFollowTheirLaws) {
    for (const double rate : {250.0, 500.0}) {
        const auto euler = findLimit({}, entryOf("euler"), rate, {});
        EXPECT_NEAR(euler.stable / (0.2 * rate), 1, 0.06);
        const auto suvat = findLimit({}, entryOf("suvat"), rate, {});
        EXPECT_NEAR(suvat.stable / (0.4 * rate), 1, 0.06);
    }
}

TEST(Limit, OfNsvFollowsItsLawForLightDamping) {
    for (const double b : {0.0, 0.1, 0.2}) {
        const auto found = findLimit({.damping = b}, entryOf("nsv"), 500, {});
        EXPECT_NEAR(found.stable / (0.05 * 250000 - 1000 * b), 1, 0.02);
    }
}

TEST(Limit, HeldNeighboursLowerRungeKuttaToTheHundreds) {
    const auto held = findLimit({}, entryOf("rk4-held"), 500, {.resolution = 0.1});
    const auto coupled = findLimit({}, entryOf("rk4"), 500, {.resolution = 0.1});
    EXPECT_LT(held.stable, 600);
    EXPECT_GT(coupled.stable, 20000);
}

TEST(Limit, ImplicitEulerHasNone) {
    const auto found = findLimit({}, entryOf("implicit"), 60, {.seconds = 10, .restShare = 0.05});
    EXPECT_FALSE(found.exploded);
    EXPECT_EQ(found.stable, 1e9);
}

TEST(Limit, BracketIsAsNarrowAsPromised) {
    const auto found = findLimit({}, entryOf("euler"), 500, {.resolution = 0.001});
    ASSERT_TRUE(found.exploded);
    EXPECT_LE(*found.exploded - found.stable, 0.001 * found.stable);
}

/// Becomes NaN after a while, without ever being large.
class Poison final : public Integrator {
public:
    void step(const System&, State& state, double) override {
        if (++ticks_ == 100) state.v[3].y() = std::numeric_limits<double>::quiet_NaN();
    }

private:
    int ticks_ = 0;
};

/// Shakes for ever with a little energy.
class Shaker final : public Integrator {
public:
    void step(const System&, State& state, double) override {
        for (auto& v : state.v) v = Vec(2, 0);
    }
};

TEST(Criterion, SeesNaN) {
    Poison poison;
    EXPECT_FALSE(survives(Rope({}), poison, 500, {}));
}

TEST(Criterion, SeesARopeThatNeverRests) {
    Shaker shaker;
    const Rope rope({.stiffness = 1000});
    EXPECT_FALSE(survives(rope, shaker, 500, {}));
    Shaker other;
    EXPECT_TRUE(survives(rope, other, 500, {.mustRest = false}));
}

TEST(Rope, NeverHasMoreKineticEnergyThanItsBudget) {
    const Rope rope({.damping = 0, .stiffness = 500});
    const auto nsv = makeNsv();
    State state = rope.start();
    double most = 0;
    for (int i = 0; i < 20000; ++i) {
        nsv->step(rope, state, 1e-4);
        most = std::max(most, rope.kineticEnergy(state));
    }
    EXPECT_LT(most, rope.budget());
    EXPECT_GT(most, 0.3 * rope.budget());
}

TEST(PaperTables, HoldTheFiguresOfThePaper) {
    EXPECT_EQ(paperTable3().limit("Euler", 4), 1000);
    EXPECT_EQ(paperTable3().limit("NSV/IE", 3), 8000);
    EXPECT_EQ(paperTable2().limit("NSV/IE", 2), 9000);
    EXPECT_EQ(paperTable2().limit("Euler", 0), std::nullopt);
    EXPECT_EQ(paperTable3().limit("no such row", 0), std::nullopt);
}

}  // namespace
