// Contact rows in blocks of eight lanes: what the solver sweeps and what refreshes their geometry.
//
// A block holds eight rows of one colour: no two of them share a body that can be pushed. The same
// source, rows.ipp, is compiled for every x86-64, for AVX2 and for AVX-512 and gives the same bits:
// lanes do not meet, roots and divisions are exact, no product is fused with a sum. As in
// joint_sweep.hpp nothing here may include a header with functions.
//
// Velocities are displacements of a step (m, rad), impulses are momenta times the step (kg m).
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/settings.hpp"
#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

inline constexpr std::size_t rowLanes = 8;

inline constexpr SweepReal unnoticed = SweepReal(tuned::unnoticed), slop = SweepReal(tuned::slop);

/// What rows push: a rigid component, or a particle that moves by itself (then it never turns).
/// Its pose is counted from a reference that is renewed when it has gone far or turned by much.
/// Its velocity is what rows have given it; that which it has without them is kept apart, so that
/// small impulses on fast bodies are not lost to rounding. Kernels take it by halves.
struct alignas(8 * sizeof(SweepReal)) SolverBody {
    SweepReal vx = 0, vy = 0, spin = 0;  // m and rad, in this step, by rows
    SweepReal inverseMass = 0;           // 1/kg
    SweepReal x = 0, y = 0, turn = 0;    // m and rad, since the reference
    SweepReal inverseInertia = 0;        // 1/(kg m^2)
};

/// The velocity that a body has without rows, and how it goes if they give what they did in the
/// last step.
struct alignas(8 * sizeof(SweepReal)) Prediction {
    SweepReal vx = 0, vy = 0, spin = 0, unused = 0;       // m and rad, in this step
    SweepReal goesX = 0, goesY = 0, turn = 0, spare = 0;  // m and rad
};

/// How a body goes in a step, when its rows have been swept.
struct alignas(4 * sizeof(SweepReal)) BodyWay {
    SweepReal x = 0, y = 0, turn = 0;  // m and rad
    SweepReal around = 0;              // m, that its turn moves any of its surface at most
};

/// Heading of a body at its reference.
struct Heading {
    SweepReal cosine = 1, sine = 0;
};

/// Where a body's pose is counted from.
struct alignas(4 * sizeof(double)) Reference {
    double x = 0, y = 0;          // m
    double cosine = 1, sine = 0;  // of its heading
};

using Lane = SweepReal[rowLanes];
using Places = std::uint32_t[rowLanes];

/// One point of a contact between two bodies, along its normal from a to b.
struct ManifoldPoint {
    Lane normalX, normalY;
    Lane normalArmA, normalArmB;  // m, lever of the normal about each body's centre
    Lane gap;                     // m, where both bodies are at their references
    Lane normalMass;              // kg, effective; 0: there is no such point
    Lane mobility;                // 1/kg, its inverse, or 0
    Lane closing;                 // m, by which the gap grows in this step without rows
    Lane room;                    // m, what is left of it then; an overlap counts as no gap
    Lane pressing;                // kg m, accumulated impulse
};

/// Two bodies that touch in up to two points. They rub as one, in the middle between the points: a
/// face that lies on another has the same tangent in both, and what the two can hold together is
/// Coulomb's limit of their sum. The tangent is the normal turned counter-clockwise by a right
/// angle.
struct alignas(sizeof(Lane)) ManifoldBlock {
    Places a, b;              // bodies
    Lane inertiaA, inertiaB;  // 1/(kg m^2), inverse, of the bodies
    Lane staticFriction, kineticFriction;
    Lane tangentX, tangentY;
    Lane tangentArmA, tangentArmB;  // m, lever of the tangent
    Lane tangentMass;               // kg, effective
    /// Where both points press, friction turns nobody: the normals answer it with these shares of
    /// it, and it meets this mass (the Schur complement of the normals).
    Lane answer1, answer2, heldMass;
    /// Elsewhere it changes by these how the points close (1/kg).
    Lane turns1, turns2;
    /// The mobility matrix of the two normals: off its diagonal (1/kg), and one over its
    /// determinant (kg^2), which is zero where the points are one.
    Lane coupling, inverse;
    Lane used;     // m, by which surfaces have moved against each other since the pair's last look
    Lane slop;     // m, an overlap that stays
    Lane slip;     // m, by which the surfaces run along the tangent in this step
    Lane sliding;  // m, by which b slides along the tangent without rows
    Lane early;    // m, of that what is over before they touch
    Lane grip;     // m, the slip up to which static friction holds; any, once it has in this step
    Lane rubbing;  // kg m, accumulated impulse
    ManifoldPoint points[2];
};

/// What a point is made from: a corner of one body and a side of the other, in their own frames.
struct ManifoldFeature {
    Lane cornerX, cornerY;  // m
    Lane outX, outY;        // unit, outward from the side
    Lane offset;            // m, of the side from its body's centre along that
    Lane middle, half;      // m, of the side along its tangent; half < 0: it has no inside
    Lane owner;             // +1: the corner is b's, -1: it is a's, 0: no point
    Lane share;             // of the thickness that the corner has
};

/// The part of a block that only refreshes read.
struct alignas(sizeof(Lane)) ManifoldShape {
    Places pair;                // whose row it is, or none
    float rolling[rowLanes];    // coefficient of the couple against rolling, as long as Places
    Lane thickness;             // m, radii of both sides together
    Lane fineness;              // m, the least radii of both outlines together
    Lane lookX, lookY;          // m, where b was in the frame of a when the pair was looked at
    Lane lookCosine, lookSine;  // and how it was turned
    Lane reach;                 // m, of b from its centre
    Lane margin;                // m, of relative motion, before the pair is looked at again
    ManifoldFeature features[2];
};

/// A corner of one body held off a side whose ends may be two bodies more. The side moves with the
/// weights of its ends and turns like a rod, so that both sides act at one point and no angular
/// momentum is made.
struct alignas(sizeof(Lane)) TouchBlock {
    Places p, a, b;  // bodies; b is the world where a has both ends
    Places unused;   // no block has padding, because its bytes are hashed
    Lane staticFriction, kineticFriction;
    Lane normalX, normalY;  // from the side towards the corner
    Lane weightA, weightB;  // of the side's ends, adding up to 1
    Lane rod, lean;         // how the side's turn moves the point along the tangent, the normal
    Lane sideX, sideY;      // unit normal of the side: its turn is that of this
    Lane normalArmP, normalArmA, normalArmB;
    Lane tangentArmP, tangentArmA, tangentArmB;
    Lane gap, slop;
    Lane normalMass, mobility, tangentMass;
    Lane slip;
    Lane closing, room, sliding, early, grip;
    Lane pressing, rubbing;
};

struct alignas(sizeof(Lane)) TouchShape {
    Places touch;             // whose row it is, or none
    float rolling[rowLanes];  // as of manifolds
    Lane thickness;           // m
    Lane cornerX, cornerY;    // m, in the frame of p
    /// m, the side's ends in the frames of their bodies; of an arc its middle, and what is a metre
    /// outwards from there
    Lane aX, aY, bX, bY;
    Lane sameBody;  // 1: a moves both ends
    Lane free;      // 1: the corner is a particle, which cannot turn
    Lane share;     // of the thickness that the corner has
    Lane outward;   // +1, -1: which way the side pushes, from a to b; 0: the
                    // corner is before one of its ends
    /// Of a corner before a corner: 0: that is the side's a, 1: its b. Before a side: m, the radius
    /// of the circle on which its axis is; 0: it is straight.
    Lane endShare;
    /// Where along the side (0 to 1) it stays this touch; on an arc: sines, seen from its middle
    Lane low, high;
};

/// What a refresh reads beside the bodies.
struct PoseView {
    const Reference* references;
    const Prediction* predictions;
};

/// What a sweep does.
struct SweepKind {
    bool begins = false;       // it is the first of the step, and moves places, too
    bool anew = false;         // it is the first since motion was predicted
    bool onlyStirred = false;  // rows whose bodies the sweep before has left alone are passed over
};

/// What rows are swept with.
struct SweepSettings {
    SweepReal creep;        // m, slower slips are held by static friction
    SweepReal share;        // of an overlap that goes in this step
    SweepReal settled;      // m, a row that changes how its surfaces part by more stirs its bodies
    std::uint8_t* stirred;  // by body, the last sweep that has stirred it
    std::uint8_t number;    // of the sweep in its step, from 1
    SweepKind kind;
};

struct RowKernels {
    /// Friction, then normals, of one block after the other. The first sweep after predictions have
    /// changed looks at these. Returns whether any body was stirred.
    bool (*sweepManifolds)(SolverBody* bodies, const Prediction* predictions, ManifoldBlock* blocks,
                           std::size_t count, const SweepSettings& settings);
    bool (*sweepTouches)(SolverBody* bodies, const Prediction* predictions, TouchBlock* blocks,
                         std::size_t count, const SweepSettings& settings);
    /// Geometry of one block from the poses of its bodies. Impulses turn along; what that changes
    /// goes to the bodies, or, with the second of each two, all that the rows give. Returns a bit
    /// for each lane that must be looked at again.
    std::uint32_t (*refreshManifolds[2])(SolverBody* bodies, const PoseView& poses,
                                         ManifoldBlock& block, const ManifoldShape& shape);
    std::uint32_t (*refreshTouches[2])(SolverBody* bodies, const PoseView& poses, TouchBlock& block,
                                       const TouchShape& shape);
    /// The bodies of one block get what its rows give.
    void (*giveManifolds)(SolverBody* bodies, const ManifoldBlock& block);
    void (*giveTouches)(SolverBody* bodies, const TouchBlock& block);
    /// A bit for each lane that presses nothing yet and comes to touch in this step, with more than
    /// `slow` (m in a step).
    std::uint32_t (*meetingManifolds)(const SolverBody* bodies, const Prediction* predictions,
                                      const ManifoldBlock& block, SweepReal slow);
    std::uint32_t (*meetingTouches)(const SolverBody* bodies, const Prediction* predictions,
                                    const TouchBlock& block, SweepReal slow);
    /// A bit for each lane whose bodies come nearer by more than `fast`, a share of the fineness,
    /// and are not known to be stopped by the row.
    std::uint32_t (*passingManifolds)(const SolverBody* bodies, const BodyWay* ways,
                                      const ManifoldBlock& block, const ManifoldShape& shape,
                                      SweepReal fast);
    /// A bit for each lane that presses.
    std::uint32_t (*pressingManifolds)(const ManifoldBlock& block);
    std::uint32_t (*pressingTouches)(const TouchBlock& block);
    /// A bit for each lane that has pressed or rubbed its bodies in this step, or moved them apart.
    std::uint32_t (*actingManifolds)(const ManifoldBlock& block);
    std::uint32_t (*actingTouches)(const TouchBlock& block);
};

extern const RowKernels baselineRows;
#ifdef SULFUR_AVX2_KERNELS
extern const RowKernels avx2Rows;
#endif
#ifdef SULFUR_AVX512_KERNELS
extern const RowKernels avx512Rows;
#endif

/// The widest that this processor can run, or that useKernelsUpTo() allows.
const RowKernels& rowKernels();

}  // namespace sulfur::detail
