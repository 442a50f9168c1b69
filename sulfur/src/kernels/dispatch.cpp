// Which kernels this processor can run, found out once.
#include "kernels/joint_sweep.hpp"

#include "kernels/contact_sweep.hpp"
#include "kernels/particle_motion.hpp"

#include <atomic>
#include <sulfur/math.hpp>
#include <type_traits>

namespace sulfur::detail {

static_assert(std::is_same_v<SweepReal, Real>);

namespace {

std::atomic<bool> baselineOnly = false;

bool hasAvx2() {
#ifdef SULFUR_AVX2_KERNELS
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

const SweepKernels& widestSweep() {
#ifdef SULFUR_AVX2_KERNELS
    if (hasAvx2()) return avx2Sweep;
#endif
    return baselineSweep;
}

const MotionKernels& widestMotion() {
#ifdef SULFUR_AVX2_KERNELS
    if (hasAvx2()) return avx2Motion;
#endif
    return baselineMotion;
}

const ContactKernels& widestContacts() {
#ifdef SULFUR_AVX2_KERNELS
    if (hasAvx2()) return avx2Contacts;
#endif
    return baselineContacts;
}

}  // namespace

const SweepKernels& sweepKernels() {
    static const SweepKernels& best = widestSweep();
    return baselineOnly ? baselineSweep : best;
}

const MotionKernels& motionKernels() {
    static const MotionKernels& best = widestMotion();
    return baselineOnly ? baselineMotion : best;
}

const ContactKernels& contactKernels() {
    static const ContactKernels& best = widestContacts();
    return baselineOnly ? baselineContacts : best;
}

void useBaselineKernels(bool only) {
    baselineOnly = only;
}

}  // namespace sulfur::detail
