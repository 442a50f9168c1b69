#include "kernels/joint_sweep.hpp"

#include <atomic>
#include <sulfur/math.hpp>
#include <type_traits>

namespace sulfur::detail {

static_assert(std::is_same_v<SweepReal, Real>);

namespace {

std::atomic<bool> baselineOnly = false;

const SweepKernels& widest() {
#ifdef SULFUR_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2")) return avx2Sweep;
#endif
    return baselineSweep;
}

}  // namespace

const SweepKernels& sweepKernels() {
    static const SweepKernels& best = widest();
    return baselineOnly ? baselineSweep : best;
}

void useBaselineKernels(bool only) {
    baselineOnly = only;
}

}  // namespace sulfur::detail
