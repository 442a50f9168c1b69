// Sweeping many contacts that share nothing that moves, several at once.
//
// Compiled twice and chosen at run time like joint_sweep.hpp, with the same promise and the same
// ban on headers with functions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

/// What contacts push: a rigid component, or a particle that moves by itself (then without a turn).
/// A whole number of them fills a cache line.
struct alignas(8 * sizeof(SweepReal)) Mover {
    SweepReal x = 0, y = 0;           // m, its displacement in this tick
    SweepReal sine = 0, versine = 0;  // of its turn in this tick; 1 - cos
    SweepReal turn = 0;               // rad, what the sweeps have added to it
    SweepReal mass = 0, inertia = 0;  // 1/kg and 1/(kg m^2), the inverses
    SweepReal unused = 0;
};

/// Contacts that are solved at once. Where there are fewer, the others hold nothing.
inline constexpr std::size_t contactLanes = 8;

/// Contacts of which no two share a mover that can be pushed.
struct alignas(8 * sizeof(SweepReal)) ContactBlock {
    using Lane = SweepReal[contactLanes];
    using Places = std::uint32_t[contactLanes];

    Places particle, a, b;  // movers: of the particle and of the capsule's ends
    Lane shareA, shareB;    // of the ends; all in shareA when one mover has both
    Lane normalX, normalY;  // unit, from the capsule towards the particle
    Lane armX, armY;        // m, from the particle's mover to the particle
    Lane armAX, armAY, armBX, armBY;
    Lane start;                    // m, the gap at the start of the tick that may be used up
    Lane deepest;                  // m, below which sweeps must not leave the gap
    Lane conveyed;                 // m, by which its surfaces run along the tangent in this tick
    Lane normalMass, tangentMass;  // kg, effective; 0: nothing can be pushed that way
    Lane coupling;                 // 1/kg, motion along the tangent by a push along the normal
    Lane friction;                 // the coefficient that counts in this tick
    Lane normalLambda, tangentLambda;  // kg m, accumulated in this tick
    // Of the correction that becomes no velocity.
    Lane wanted;                     // m, by which the gap is to grow, or shrink; 0: neither
    Lane recoveryLambda;             // kg m, accumulated along the normal
    Lane driftLambda;                // kg m, along the tangent
    std::uint32_t recovers, drifts;  // whether any of the contacts does
};

/// Blocks of contacts whose capsule has one mover (`two` in all) or two (`three` in all).
struct ContactKernels {
    using Sweep = void (*)(Mover* movers, ContactBlock* blocks, std::size_t count);
    /// Finds the multipliers, one block after the other.
    Sweep solveTwo, solveThree;
    /// Pushes with the multipliers that there are.
    Sweep warmTwo, warmThree;
    /// Where movers stand for the correction: sine and versine mean nothing, turns are small.
    Sweep recoverTwo, recoverThree, driftTwo, driftThree;
    /// Whether one more sweep would push any of them by more than so many m.
    bool (*anyErrorTwo)(const Mover* movers, const ContactBlock* blocks, std::size_t count,
                        SweepReal most);
    bool (*anyErrorThree)(const Mover* movers, const ContactBlock* blocks, std::size_t count,
                          SweepReal most);
    /// Whether any of them is left deeper than it may be.
    bool (*anyDeepTwo)(const Mover* movers, const ContactBlock* blocks, std::size_t count);
    bool (*anyDeepThree)(const Mover* movers, const ContactBlock* blocks, std::size_t count);
};

extern const ContactKernels baselineContacts;
#ifdef SULFUR_AVX2_KERNELS
extern const ContactKernels avx2Contacts;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const ContactKernels& contactKernels();

}  // namespace sulfur::detail
