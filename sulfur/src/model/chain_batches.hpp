// Chains of rigid links that go through the tick side by side, in SIMD lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels/chain_lanes.hpp"

namespace sulfur::detail {

/// Chains of as many nodes each, one a lane. Lanes that are left over repeat the first one and take
/// no part.
struct LanesOfChains {
    std::uint32_t nodes = 0;                         // of each
    std::uint32_t lanes = 0;                         // that take part, the first ones
    std::uint32_t indices = 0;                       // where those of its nodes begin
    bool heldRoot = true;                            // nothing moves the first node of any lane
    std::array<std::uint32_t, chainLanes> trees{};   // of each lane
    std::array<std::uint32_t, chainLanes> firsts{};  // of each lane, its node among all
};

/// Memory that a node of a batch needs while the batch is led through the tick.
struct alignas(chainAlignment) LanesScratch {
    std::byte bytes[chainScratch];
};

/// Derived from the trees that move alone and are awake.
struct ChainBatches {
    std::vector<LanesOfChains> list;
    // Node by node, a lane beside the other.
    std::vector<std::uint32_t> particles, joints;
    std::vector<double> inverseMass;    // 1/kg
    std::vector<double> rest, share;    // m and 1/m
    std::vector<std::uint32_t> others;  // trees that are in no batch
    std::vector<LanesScratch> scratch;  // for each node of the longest batch
};

}  // namespace sulfur::detail
