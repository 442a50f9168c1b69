// Joints that are too stiff to be forces: compliant and rigid distance constraints.
#include <algorithm>
#include <cmath>

#include "core/limits.hpp"
#include "core/pieces.hpp"
#include "core/settings.hpp"
#include "particles/motion.hpp"
#include "rigid/grip.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

/// The two ends of a joint, as it takes hold of them.
struct Ends {
    Ends(const State& state, std::uint32_t j)
        : a(gripOf(state, state.joints.a[j])), b(gripOf(state, state.joints.b[j])) {}

    Vec2 moved(const State& state) const {
        return displacementOf(state, b) - displacementOf(state, a);
    }
    Real inverseMass(const State& state, const Vec2& direction) const {
        return inverseMassAlong(state, a, direction) + inverseMassAlong(state, b, direction);
    }
    /// Apart for a positive impulse.
    void push(State& state, const Vec2& impulse) const {
        detail::push(state, a, -impulse);
        detail::push(state, b, impulse);
    }

    Grip a, b;
};

Vec2 apartAtStart(const State& state, std::uint32_t j) {
    const auto& x = state.particles.position;
    return (x[state.joints.b[j]] - x[state.joints.a[j]]).cast<Real>();
}

/// How strongly the tension of the last tick bends a joint's ends aside within a tick, when the
/// joint pulls along its direction at the tick's start: above about 1 that explodes.
Real whip(const State& state, std::uint32_t j, Real w, Real start) {
    const Joints& joints = state.joints;
    const Real length = joints.restLength[j] > 0 ? joints.restLength[j] : start;
    return 2 * w * std::abs(joints.force[j]) * state.h * state.h / length;
}

constexpr Real mostWhip = Real(tuned::sweptWhip);

/// The unit vector along which a joint pulls that pointed along `before` at the start of the tick
/// and does along `now` at its end, so far: the former (SHAKE, Ryckaert et al. 1977). Only so does
/// a pendulum keep its energy and a wheel its spin: pulls along the latter took a share of
/// (h omega)^2 of it in a tick. Light ends under great tension would explode by that; there it is
/// the mean of the two, which brakes rotation but is stable.
Vec2 pullDirection(const State& state, std::uint32_t j, Real w, Real start, const Vec2& before,
                   const Vec2& now) {
    Vec2 direction = before;
    if (whip(state, j, w, start) > mostWhip) direction = (before + now).normalized();
    return direction.dot(now) < Real(0.5) ? now : direction;
}

/// Implicit Euler for the part of a spring with a damper that is no force, as a constraint with
/// compliance 1 / (k h^2) and an accumulated multiplier (extended position based dynamics, Macklin
/// et al. 2016, equations 18 and 26): the same result for any number of sweeps once they have
/// converged, stable for any k.
void solveImplicit(State& state, std::uint32_t j) {
    Joints& joints = state.joints;
    const Ends ends(state, j);
    const Vec2 moved = ends.moved(state), before = apartAtStart(state, j);
    const Vec2 apart = before + moved;
    const Real start = before.norm(), length = apart.norm();
    if (start == 0 || length == 0) return;
    const Real w = ends.inverseMass(state, before / start);
    const Vec2 direction = pullDirection(state, j, w, start, before / start, apart / length);
    // Numerator and denominator times k h^2, so that no stiffness divides by zero.
    const Real newtons = newtonsPerMultiplier(state);
    const Real hk = (joints.stiffness[j] - joints.explicitStiffness[j]) / newtons;
    const Real hb = (joints.damping[j] - joints.explicitDamping[j]) / (newtons * state.h);
    const Real error = length - joints.restLength[j];
    const Real change =
        -(hk * error + hb * direction.dot(moved) + joints.lambda[j]) / ((hk + hb) * w + 1);
    joints.lambda[j] += change;
    ends.push(state, change * direction);
}

/// The length (m) to reach in this tick by a rigid joint of the given length.
Real restOf(const State& state, std::uint32_t j, Real length) {
    const Real rest = state.joints.restLength[j];
    const double torn = static_cast<double>(length - rest);
    return rest + static_cast<Real>(errorLeft(torn, static_cast<double>(state.h)));
}

void solveRigid(State& state, std::uint32_t j) {
    Joints& joints = state.joints;
    const Ends ends(state, j);
    const Vec2 before = apartAtStart(state, j);
    const Vec2 apart = before + ends.moved(state);
    const Real start = before.norm(), length = apart.norm();
    if (start == 0 || length == 0) return;
    const Real w = ends.inverseMass(state, before / start);
    if (w == 0) return;
    const Real rest = restOf(state, j, start);
    const Vec2 direction = pullDirection(state, j, w, start, before / start, apart / length);
    const Real change = (rest - length) * length / (w * direction.dot(apart));
    joints.lambda[j] += change;
    ends.push(state, change * direction);
}

// --- many at once ---------------------------------------------------------------------------

SweepView viewOf(State& state, SweptJoints& s) {
    static_assert(sizeof(Vec2) == 2 * sizeof(Real));
    SweepView view{};
    view.displacement = state.particles.displacement.data()->data();
    view.a = s.a.data();
    view.b = s.b.data();
    view.startX = s.startX.data();
    view.startY = s.startY.data();
    view.massA = s.massA.data();
    view.massB = s.massB.data();
    view.rest = s.rest.empty() ? s.length.data() : s.rest.data();
    view.lambda = s.lambda.data();
    view.hk = s.hk.data();
    view.hb = s.hb.data();
    view.gain = s.gain.data();
    view.directionX = s.directionX.data();
    view.directionY = s.directionY.data();
    view.whips = s.whips.data();
    return view;
}

StartView startOf(const State& state, SweptJoints& s) {
    StartView view{};
    view.position = state.particles.position.data()->data();
    view.pulled = state.joints.force.data();
    view.joint = s.joint.data();
    view.a = s.a.data();
    view.b = s.b.data();
    view.massA = s.massA.data();
    view.massB = s.massB.data();
    view.length = s.length.data();
    view.hk = s.hk.data();
    view.hb = s.hb.data();
    view.startX = s.startX.data();
    view.startY = s.startY.data();
    view.directionX = s.directionX.data();
    view.directionY = s.directionY.data();
    view.whips = s.whips.data();
    view.lambda = s.lambda.data();
    view.gain = s.gain.data();
    view.rest = s.rest.data();
    view.h = state.h;
    view.mostWhip = mostWhip;
    view.closing = closingSpeed * static_cast<double>(state.h);
    return view;
}

/// Joints that are swept or prepared in a microsecond, most of them in lanes.
constexpr std::size_t inMicrosecond = 600;

/// Calls f(batch, first, last) for the joints [first, last) of each batch, those of one part in the
/// order of their batches: parts at once or, where there is only one, what a wide batch has.
template <class Function>
void forEachBatch(const State& state, const SweptJoints& swept, std::size_t count, Function&& f) {
    const std::size_t pieces =
        std::min<std::size_t>(swept.parts, piecesOf(state.tasks, count, inMicrosecond));
    if (pieces > 1)
        return runPieces(state.tasks, pieces, [&](std::size_t i) {
            const auto first = pieceStart(i, pieces, swept.parts);
            const auto last = pieceStart(i + 1, pieces, swept.parts);
            for (const SweepBatch& batch : swept.batches)
                if (batch.part >= first && batch.part < last)
                    f(batch, std::size_t{0}, batch.size());
        });
    for (const SweepBatch& batch : swept.batches) {
        if (!batch.wide) {
            f(batch, std::size_t{0}, batch.size());
            continue;
        }
        const std::size_t blocks = (batch.size() + sweepLanes - 1) / sweepLanes;
        inPieces(state.tasks, blocks, inMicrosecond / sweepLanes,
                 [&](std::size_t first, std::size_t last) {
                     f(batch, first * sweepLanes, std::min(last * sweepLanes, batch.size()));
                 });
    }
}

/// What the sweeps of implicit joints need of each, which only changes with the step.
void noteStep(const State& state, SweptJoints& s) {
    const Joints& joints = state.joints;
    const Real newtons = newtonsPerMultiplier(state);
    if (s.h == state.h && s.newtons == newtons) return;
    s.h = state.h;
    s.newtons = newtons;
    for (std::size_t k = 0; k < s.hk.size(); ++k) {
        const auto j = s.joint[k];
        s.hk[k] = (joints.stiffness[j] - joints.explicitStiffness[j]) / newtons;
        s.hb[k] = (joints.damping[j] - joints.explicitDamping[j]) / (newtons * state.h);
    }
}

using SolveOne = void (*)(State&, std::uint32_t);
template <class View>
using SolveMany = void (*)(const View&, std::size_t, std::size_t);

void sweep(State& state, const std::vector<std::uint32_t>& list, SweptJoints& swept, SolveOne one,
           SolveMany<SweepView> many) {
    if (list.empty()) return;
    const SweepView view = viewOf(state, swept);
    forEachBatch(state, swept, list.size(),
                 [&](const SweepBatch& batch, std::size_t first, std::size_t last) {
                     if (batch.wide) return many(view, batch.place + first, last - first);
                     for (auto k = first; k < last; ++k) one(state, list[batch.first + k]);
                 });
}

}  // namespace

void solveImplicitJoints(State& state) {
    WorkLists& work = state.work;
    sweep(state, work.implicitJoints, work.implicitSweep, solveImplicit, sweepKernels().implicit);
}

void solveRigidJoints(State& state) {
    WorkLists& work = state.work;
    sweep(state, work.rigidJoints, work.rigidSweep, solveRigid, sweepKernels().rigid);
}

void clearMultipliers(State& state) {
    WorkLists& work = state.work;
    const auto start = [&](const std::vector<std::uint32_t>& list, SweptJoints& swept,
                           SolveMany<StartView> many) {
        if (list.empty()) return;
        noteStep(state, swept);
        const StartView view = startOf(state, swept);
        forEachBatch(state, swept, list.size(),
                     [&](const SweepBatch& batch, std::size_t first, std::size_t last) {
                         if (batch.wide) return many(view, batch.place + first, last - first);
                         for (auto k = first; k < last; ++k)
                             state.joints.lambda[list[batch.first + k]] = 0;
                     });
    };
    start(work.implicitJoints, work.implicitSweep, sweepKernels().startImplicit);
    start(work.rigidJoints, work.rigidSweep, sweepKernels().startRigid);
    for (const auto i : work.attachments) state.attachments[i].force = Vec2(0, 0);
    for (const auto i : work.hinges) state.clusters.hinges[i].force = Vec2(0, 0);
}

void recordForces(State& state) {
    Joints& joints = state.joints;
    const WorkLists& work = state.work;
    for (const auto* swept : {&work.implicitSweep, &work.rigidSweep})
        for (const SweepBatch& batch : swept->batches)
            for (std::size_t k = 0; batch.wide && k < batch.size(); ++k)
                joints.lambda[swept->joint[batch.place + k]] = swept->lambda[batch.place + k];
    const Real scale = -newtonsPerMultiplier(state);
    Real* const force = joints.force.data();
    const Real* const lambda = joints.lambda.data();
    for (const StiffRun& run : work.stiffRuns) {
        // What is a force as well has been recorded as one already.
        if (run.forces)
            for (auto j = run.first; j < run.last; ++j) force[j] += scale * lambda[j];
        else
            for (auto j = run.first; j < run.last; ++j) force[j] = Real(0) + scale * lambda[j];
    }
}

}  // namespace sulfur::detail
