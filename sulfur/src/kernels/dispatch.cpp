// Which kernels this processor can run, found out once.
#include <algorithm>
#include <atomic>
#include <sulfur/math.hpp>
#include <type_traits>

#include "kernels/area_look.hpp"
#include "kernels/chain_lanes.hpp"
#include "kernels/cluster_motion.hpp"
#include "kernels/joint_force.hpp"
#include "kernels/joint_sweep.hpp"
#include "kernels/loose_look.hpp"
#include "kernels/particle_motion.hpp"
#include "kernels/rows.hpp"

namespace sulfur::detail {

static_assert(std::is_same_v<SweepReal, Real>);

namespace {

std::atomic<Instructions> allowed = Instructions::avx512;

Instructions findWidest() {
#ifdef SULFUR_AVX512_KERNELS
    if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
        __builtin_cpu_supports("avx512vl") != 0)
        return Instructions::avx512;
#endif
#ifdef SULFUR_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") != 0) return Instructions::avx2;
#endif
    return Instructions::baseline;
}

[[maybe_unused]] bool mayUse(Instructions instructions) {
    return instructions <= std::min(widestInstructions(), allowed.load(std::memory_order_relaxed));
}

}  // namespace

Instructions widestInstructions() {
    static const Instructions widest = findWidest();
    return widest;
}

void useKernelsUpTo(Instructions most) {
    allowed = most;
}

const SweepKernels& sweepKernels() {
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Sweep;
#endif
    return baselineSweep;
}

const ForceKernels& forceKernels() {
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Forces;
#endif
    return baselineForces;
}

const AreaKernels& areaKernels() {
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Areas;
#endif
    return baselineAreas;
}

const LookKernels& lookKernels() {
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Looks;
#endif
    return baselineLooks;
}

const MotionKernels& motionKernels() {
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Motion;
#endif
    return baselineMotion;
}

const ClusterKernels& clusterKernels() {
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Clusters;
#endif
    return baselineClusters;
}

const ChainKernels& chainKernels() {
#ifdef SULFUR_AVX512_KERNELS
    if (mayUse(Instructions::avx512)) return avx512Chains;
#endif
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Chains;
#endif
    return baselineChains;
}

const RowKernels& rowKernels() {
#ifdef SULFUR_AVX512_KERNELS
    if (mayUse(Instructions::avx512)) return avx512Rows;
#endif
#ifdef SULFUR_AVX2_KERNELS
    if (mayUse(Instructions::avx2)) return avx2Rows;
#endif
    return baselineRows;
}

}  // namespace sulfur::detail
