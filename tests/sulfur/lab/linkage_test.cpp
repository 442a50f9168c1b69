// The reference of nets, where the motion is known otherwise.
#include <gtest/gtest.h>

#include <cmath>

#include "references/chain.hpp"
#include "references/linkage.hpp"

namespace {

using namespace sulfur::lab;

/// Links of 0.4 m in a row, whose last node is held.
LinkagePlan row(Eigen::Index links) {
    LinkagePlan plan;
    plan.reach = Eigen::MatrixXd::Zero(links + 1, links);
    for (Eigen::Index i = 0; i <= links; ++i) plan.reach.row(i).head(i).setConstant(0.4);
    plan.masses = Eigen::VectorXd::Ones(links + 1);
    plan.held = links;
    return plan;
}

double energyOf(const LinkagePlan& plan, const State& nodes) {
    double energy = 0;
    for (std::size_t i = 0; i < nodes.x.size(); ++i)
        energy += plan.masses[static_cast<Eigen::Index>(i)] *
                  (nodes.v[i].squaredNorm() / 2 + plan.gravity * nodes.x[i].y());
    return energy;
}

/// Three links between two fixed ends, in another shape than at rest.
LinkageState slack() {
    return {Eigen::Vector3d(-1.2, 0.1, 0.7), Eigen::Vector3d::Zero()};
}

TEST(Linkage, KeepsItsLengthsItsEndsAndItsEnergy) {
    const LinkagePlan plan = row(3);
    const LinkageReference linkage(plan);
    LinkageState state = slack();
    const State before = linkage.nodes(state);
    for (int i = 0; i < 2900; ++i) linkage.step(state, 5e-4);
    const State after = linkage.nodes(state);
    EXPECT_GT((after.x[1] - before.x[1]).norm() + (after.x[2] - before.x[2]).norm(), 0.01);
    EXPECT_LT((after.x[3] - before.x[3]).norm(), 1e-9);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((after.x[i + 1] - after.x[i]).norm(), 0.4, 1e-14);
    EXPECT_NEAR(energyOf(plan, after), energyOf(plan, before), 1e-8);
}

/// The same links, which hang free.
TEST(Linkage, AgreesWithTheChain) {
    LinkagePlan plan = row(3);
    // A second arm without mass, held, so that the row itself is free.
    plan.reach.conservativeResizeLike(Eigen::MatrixXd::Zero(5, 5));
    plan.reach.row(4).tail(2).setConstant(0.5);
    plan.masses.conservativeResize(5);
    plan.masses[4] = 1e-9;
    plan.held = 4;
    const LinkageReference linkage(plan);
    LinkageState state{Eigen::VectorXd(5), Eigen::VectorXd::Zero(5)};
    state.angles << -1.2, 0.1, 0.7, 0.3, -0.4;
    const State nodes = linkage.nodes(state);
    const LinkagePath found = convergedPath(linkage, state, 0.1, 5, 3, 1e-9, 4096);
    const ChainPath chain = convergedPath(
        {{0.4, 0.4, 0.4}, {1, 1, 1}},
        {{nodes.x.begin() + 1, nodes.x.begin() + 4}, Vecs(3, Vec::Zero())}, 0.1, 5, 1e-10);
    EXPECT_LT(found.error, 1e-9);
    for (std::size_t n = 0; n < 5; ++n)
        EXPECT_LT((found.places[n][3] - chain.states[n + 1].x[2]).norm(), 1e-7) << n;
}

/// Of all motions that links allow, a blow leaves the one that is nearest.
TEST(Linkage, ABlowLeavesWhatLinksAllow) {
    const LinkagePlan plan = row(3);
    const LinkageReference linkage(plan);
    LinkageState state = slack();
    const Vecs thrown{Vec(0, 0), Vec(1, 2), Vec(0, 0), Vec(0, 0)};
    state.rates = linkage.struck(state.angles, thrown);
    const State nodes = linkage.nodes(state);
    EXPECT_LT(nodes.v[3].norm(), 1e-12);
    // What it has lost is orthogonal to how it moves.
    double product = 0, left = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        product += (thrown[i] - nodes.v[i]).dot(nodes.v[i]);
        left += nodes.v[i].squaredNorm();
    }
    EXPECT_NEAR(product, 0, 1e-12);
    EXPECT_GT(left, 0.1);
    const Eigen::VectorXd again = linkage.struck(state.angles, nodes.v);
    EXPECT_LT((again - state.rates).norm(), 1e-10);
}

}  // namespace
