#include "rigid/rigidity.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/disjoint_sets.hpp"
#include "core/slots.hpp"

namespace sulfur::detail {

namespace {

using Motion = Eigen::VectorXd;  // velocity of every particle, x and y in turn

/// Bars that end at each particle.
std::vector<std::vector<std::uint32_t>> barsAround(std::size_t particles,
                                                   const std::vector<Bar>& bars) {
    std::vector<std::vector<std::uint32_t>> around(particles);
    for (std::uint32_t i = 0; i < bars.size(); ++i) {
        around[bars[i].a].push_back(i);
        around[bars[i].b].push_back(i);
    }
    return around;
}

/// Takes away bars that end freely, again and again: what hangs on one particle is not rigid with
/// the rest. Nothing remains of a tree.
std::vector<std::uint32_t> barsInCycles(std::size_t particles, const std::vector<Bar>& bars) {
    const auto around = barsAround(particles, bars);
    std::vector<std::size_t> degree(particles);
    std::vector<bool> gone(bars.size(), false);
    std::vector<std::uint32_t> ends;
    for (std::uint32_t p = 0; p < particles; ++p) {
        degree[p] = around[p].size();
        if (degree[p] == 1) ends.push_back(p);
    }
    while (!ends.empty()) {
        const auto p = ends.back();
        ends.pop_back();
        for (const auto i : around[p]) {
            if (gone[i]) continue;
            gone[i] = true;
            const auto other = bars[i].a == p ? bars[i].b : bars[i].a;
            if (--degree[other] == 1) ends.push_back(other);
        }
        degree[p] = 0;
    }
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < bars.size(); ++i)
        if (!gone[i]) kept.push_back(i);
    return kept;
}

/// A random motion that lengthens no bar: a random vector, led three times through the inverse of
/// K + epsilon, where K is the stiffness matrix of the framework with bars of unit stiffness. That
/// shrinks what strains a bar by epsilon / eigenvalue each time and keeps the rest.
class FreeMotions {
public:
    FreeMotions(const std::vector<Point>& positions, const std::vector<Bar>& bars,
                const std::vector<std::uint32_t>& chosen)
        : size_(static_cast<Eigen::Index>(2 * positions.size())) {
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index i = 0; i < size_; ++i) entries.emplace_back(i, i, epsilon);
        for (const auto i : chosen) addBar(positions, bars[i], entries);
        Eigen::SparseMatrix<double> matrix(size_, size_);
        matrix.setFromTriplets(entries.begin(), entries.end());
        solver_.compute(matrix);
    }

    Motion random(std::uint64_t seed) const {
        Motion motion(size_);
        for (Eigen::Index i = 0; i < size_; ++i) {
            seed ^= seed << 13;  // xorshift64, Marsaglia 2003
            seed ^= seed >> 7;
            seed ^= seed << 17;
            motion[i] = static_cast<double>(seed >> 11) / 4503599627370496.0 - 1;
        }
        for (int pass = 0; pass < 3; ++pass) motion = epsilon * solver_.solve(motion);
        return motion;
    }

private:
    static constexpr double epsilon = 1e-11;

    static void addBar(const std::vector<Point>& positions, const Bar& bar,
                       std::vector<Eigen::Triplet<double>>& entries) {
        const Point n = (positions[bar.b] - positions[bar.a]).normalized();
        const auto a = static_cast<Eigen::Index>(2 * bar.a);
        const auto b = static_cast<Eigen::Index>(2 * bar.b);
        for (Eigen::Index row = 0; row < 2; ++row) {
            for (Eigen::Index column = 0; column < 2; ++column) {
                const double value = n[row] * n[column];
                entries.emplace_back(a + row, a + column, value);
                entries.emplace_back(b + row, b + column, value);
                entries.emplace_back(a + row, b + column, -value);
                entries.emplace_back(b + row, a + column, -value);
            }
        }
    }

    Eigen::Index size_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// How fast a bar turns in a motion.
double turning(const std::vector<Point>& positions, const Bar& bar, const Motion& motion) {
    const Point along = positions[bar.b] - positions[bar.a];
    const Eigen::Vector2d apart = motion.segment<2>(2 * bar.b) - motion.segment<2>(2 * bar.a);
    return (along[0] * apart[1] - along[1] * apart[0]) / along.squaredNorm();
}

/// Unites bars that share a particle and turn alike in both motions.
DisjointSets uniteByTurning(const std::vector<Point>& positions, const std::vector<Bar>& bars,
                            const std::vector<std::uint32_t>& chosen) {
    const FreeMotions motions(positions, bars, chosen);
    const Motion first = motions.random(0x9e3779b97f4a7c15u), second = motions.random(0x2545f491u);
    const double scale = (first.norm() + second.norm()) / std::sqrt(2.0 * positions.size());
    const auto alike = [&](const Bar& p, const Bar& q) {
        const double length = std::min((positions[p.b] - positions[p.a]).norm(),
                                       (positions[q.b] - positions[q.a]).norm());
        const auto differs = [&](const Motion& motion) {
            return std::abs(turning(positions, p, motion) - turning(positions, q, motion)) *
                       length >
                   1e-5 * scale;
        };
        return !differs(first) && !differs(second);
    };
    DisjointSets sets(bars.size());
    std::vector<std::vector<std::uint32_t>> groupsAt(positions.size());  // one bar of each group
    for (const auto i : chosen) {
        for (const auto p : {bars[i].a, bars[i].b}) {
            auto& groups = groupsAt[p];
            const auto match = std::find_if(groups.begin(), groups.end(), [&](std::uint32_t g) {
                return alike(bars[g], bars[i]);
            });
            if (match == groups.end())
                groups.push_back(i);
            else
                sets.unite(*match, i);
        }
    }
    return sets;
}

}  // namespace

std::vector<std::uint32_t> findRigidSets(const std::vector<Point>& positions,
                                         const std::vector<Bar>& bars) {
    std::vector<std::uint32_t> label(bars.size(), none);
    const auto chosen = barsInCycles(positions.size(), bars);
    if (chosen.size() < 3) return label;
    DisjointSets sets = uniteByTurning(positions, bars, chosen);
    std::vector<std::uint32_t> size(bars.size(), 0), number(bars.size(), none);
    for (const auto i : chosen) ++size[sets.find(i)];
    std::uint32_t next = 0;
    for (const auto i : chosen) {
        const auto leader = sets.find(i);
        if (size[leader] < 3) continue;
        if (number[leader] == none) number[leader] = next++;
        label[i] = number[leader];
    }
    return label;
}

}  // namespace sulfur::detail
