// Chains of as many rigid links each, led through a tick side by side: one in each lane.
//
// Compiled three times and chosen at run time like joint_sweep.hpp, with the same promise and the
// same ban on headers with functions. A lane computes what ChainStepper (trees/point_chain.cpp)
// does, in the same order, so that it does not matter to a chain whether it has a lane or goes by
// itself.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

inline constexpr std::size_t chainLanes = 8;

/// The arrays of a world that chains read and write; x and y in turn where there are both.
struct ChainView {
    const double* position;    // m
    double* velocity;          // m/s
    double* force;             // N
    SweepReal* displacement;   // m
    const SweepReal* tension;  // N, of joints, in the last tick
    SweepReal* lambda;         // kg m, of joints
    SweepReal* predicted;      // m, of the nodes of all trees
};

/// What is the same for all chains.
struct ChainRules {
    double gravityX, gravityY;  // m/s^2
    double airFriction;         // 1/s
    double tick;                // s
    double late;                // s, for which forces act longer in the first step of a tick
    double maxSpeed;            // m/s, of each component
    double maxForce;            // N; what carries more begins from nothing
    double closingSpeed;        // m/s
    double smallStretch;        // m
    double tolerance;           // of a link's length
    double worthwhile;          // a pass that leaves more of the error needs new factors
    double redundant;           // relative to what moves: a smaller pivot is none
    int mostPasses, mostFactored;
    double mostWhip, mostTurn, calmWhip, calmTurn;
};

/// chainLanes chains. What they have of each node and link lies node by node, a lane beside the
/// other.
struct ChainBatch {
    std::size_t nodes;               // of each chain, at least 2
    const std::uint32_t* particles;  // of node i of lane k: [i * chainLanes + k]
    const std::uint32_t* joints;     // the same, of the joint from node i - 1 to node i
    const double* inverseMass;       // 1/kg, of each node
    const double *rest, *share;      // m and 1/m, of each link: its length, see shareOf()
    const std::uint32_t* firsts;     // of each lane: its first node among those of all trees
    double lastStep[chainLanes];     // s
    bool heldRoot;                   // node 0 of every lane stays where it is
    std::uint32_t steps;             // of every lane
    std::uint32_t lanes;             // bit k: lane k takes part
};

/// Bit k speaks of lane k. What is not done has changed nothing.
struct ChainOutcome {
    std::uint32_t done, calm;
};

/// Bytes of scratch memory that a chain's node needs, aligned to as many as chainAlignment.
inline constexpr std::size_t chainScratch = 2048, chainAlignment = 64;

struct ChainKernels {
    /// Leads the chains through the tick.
    ChainOutcome (*step)(const ChainView&, const ChainRules&, const ChainBatch&, void* scratch);
};

extern const ChainKernels baselineChains;
#ifdef SULFUR_AVX2_KERNELS
extern const ChainKernels avx2Chains;
#endif
#ifdef SULFUR_AVX512_KERNELS
extern const ChainKernels avx512Chains;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const ChainKernels& chainKernels();

}  // namespace sulfur::detail
