// The factorisation by blocks against a dense one.
#include "core/block_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "random_numbers.hpp"

namespace sulfur::detail {
namespace {

using Edges = std::vector<BlockPattern::Edge>;

/// A net of `side` x `side` nodes.
Edges net(std::uint32_t side) {
    Edges edges;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        if (i % side + 1 < side) edges.emplace_back(i, i + 1);
        if (i + side < side * side) edges.emplace_back(i, i + side);
    }
    return edges;
}

template <int N>
Eigen::Matrix<double, N, N> randomBlock(test::Random& random) {
    Eigen::Matrix<double, N, N> block;
    for (int k = 0; k < N * N; ++k)
        block(k / N, k % N) = static_cast<double>(random.bits() % 2000) / 1000 - 1;
    return block;
}

/// The largest error of a solution, relative to that of Eigen's dense Cholesky factorisation.
template <int N>
double errorOf(std::uint32_t nodes, const Edges& edges) {
    test::Random random(3);
    BlockPattern pattern;
    pattern.analyse(nodes, edges);
    BlockFactor<N> factor;
    factor.begin(pattern);
    const auto size = static_cast<Eigen::Index>(N * nodes);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    for (std::uint32_t i = 0; i < nodes; ++i) {
        const Eigen::Matrix<double, N, N> half = randomBlock<N>(random);
        const Eigen::Matrix<double, N, N> block =
            half * half.transpose() + 8 * N * Eigen::Matrix<double, N, N>::Identity();
        factor.add(pattern, i, block);
        dense.block<N, N>(N * i, N * i) += block;
    }
    for (const auto& [a, b] : edges) {
        const Eigen::Matrix<double, N, N> block = randomBlock<N>(random);
        factor.add(pattern, a, b, block);
        dense.block<N, N>(N * a, N * b) += block;
        dense.block<N, N>(N * b, N * a) += block.transpose();
    }
    factor.factorise(pattern);
    Eigen::VectorXd right(size);
    std::vector<typename BlockFactor<N>::Vector> x(nodes);
    for (std::uint32_t i = 0; i < nodes; ++i) {
        for (int k = 0; k < N; ++k) right[N * i + k] = std::sin(7.0 * i + k);
        x[pattern.columnOf(i)] = right.segment<N>(N * i);
    }
    factor.solve(pattern, std::span(x));
    std::vector<typename BlockFactor<N>::Lanes> lanes(nodes);
    for (std::uint32_t i = 0; i < nodes; ++i)
        for (int lane = 0; lane < BlockFactor<N>::lanes; ++lane)
            lanes[pattern.columnOf(i)].col(lane) = (lane + 1) * right.segment<N>(N * i);
    factor.solve(pattern, std::span(lanes));
    const Eigen::VectorXd exact = dense.llt().solve(right);
    double worst = 0;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        const auto j = pattern.columnOf(i);
        worst = std::max(worst, (x[j] - exact.segment<N>(N * i)).norm());
        for (int lane = 0; lane < BlockFactor<N>::lanes; ++lane)
            worst =
                std::max(worst, (lanes[j].col(lane) / (lane + 1) - exact.segment<N>(N * i)).norm());
    }
    return worst / exact.norm();
}

TEST(BlockFactor, SolvesWhatADenseFactorisationDoes) {
    EXPECT_LT(errorOf<2>(144, net(12)), 1e-13);
    EXPECT_LT(errorOf<3>(81, net(9)), 1e-13);
    EXPECT_LT(errorOf<2>(1, {}), 1e-13);
}

/// The order is that of approximate degrees, so that it may fill in a little.
TEST(BlockFactor, ATreeHardlyFillsIn) {
    Edges edges;
    for (std::uint32_t i = 1; i < 200; ++i) edges.emplace_back(i, (i - 1) / 2);
    BlockPattern pattern;
    pattern.analyse(200, edges);
    EXPECT_LE(pattern.entries(), edges.size() * 3 / 2);
    EXPECT_LT(errorOf<2>(200, edges), 1e-13);
}

/// Two links between the same nodes are one entry.
TEST(BlockFactor, DoubleEdgesAddUp) {
    const Edges edges{{0, 1}, {1, 0}, {1, 2}};
    BlockPattern pattern;
    pattern.analyse(3, edges);
    EXPECT_EQ(pattern.entries(), 2u);
    EXPECT_LT(errorOf<3>(3, edges), 1e-13);
}

/// A small crate that is tied to a particle by something a million times as stiff as both are
/// heavy: what one of them gets the other gives, although all but one of the freedoms are soft.
TEST(BlockFactor, SoftFreedomsBesideAStiffOneAreExact) {
    const Edges edges{{0, 1}};
    BlockPattern pattern;
    pattern.analyse(2, edges);
    BlockFactor<3> factor;
    using Vector = BlockFactor<3>::Vector;
    const std::array<Vector, 2> mass{Vector(1, 1, 7.3e-6), Vector(0.057, 0.057, 1)};
    const std::array<Vector, 2> row{Vector(-0.741, 0.671, -4.2e-3), Vector(0.741, -0.671, 0)};
    constexpr double stiffness = 1e6;
    factor.begin(pattern);
    for (std::uint32_t i = 0; i < 2; ++i)
        factor.add(
            pattern, i,
            BlockFactor<3>::Block(mass[i].asDiagonal()) + stiffness * row[i] * row[i].transpose());
    factor.add(pattern, 0, 1, stiffness * row[0] * row[1].transpose());
    factor.factorise(pattern);
    std::vector<Vector> x(2);
    for (std::uint32_t i = 0; i < 2; ++i) x[pattern.columnOf(i)] = stiffness * row[i];
    factor.solve(pattern, std::span(x));
    const Vector &a = x[pattern.columnOf(0)], &b = x[pattern.columnOf(1)];
    const Eigen::Vector2d momentum = mass[0][0] * a.head<2>() + mass[1][0] * b.head<2>();
    EXPECT_LT(momentum.norm(), 1e-7 * mass[0][0] * a.head<2>().norm());
}

}  // namespace
}  // namespace sulfur::detail
