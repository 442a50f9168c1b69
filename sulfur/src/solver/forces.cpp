// Stage: forces of explicit elastic joints.
#include <algorithm>
#include <cmath>

#include "core/pieces.hpp"
#include "kernels/joint_force.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

/// Hooke's law with a damper: the paper's equation (1), as a rule with the damper projected on the
/// joint, so that it brakes stretching but not rotation.
void addElasticForce(State& state, std::uint32_t j) {
    Joints& joints = state.joints;
    Particles& particles = state.particles;
    const auto a = joints.a[j], b = joints.b[j];
    const Vec2 apart = (particles.position[b] - particles.position[a]).cast<Real>();
    const Real length = apart.norm();
    if (length == 0) {
        joints.force[j] = 0;
        return;
    }
    const Vec2 direction = apart / length;
    Real pull = joints.explicitStiffness[j] * (length - joints.restLength[j]);
    Vec2 sideways(0, 0);
    if (joints.explicitDamping[j] > 0) {
        const Vec2 relative = (particles.velocity[b] - particles.velocity[a]).cast<Real>();
        const Real lengthening = direction.dot(relative);
        pull += joints.explicitDamping[j] * lengthening;
        if (state.settings.damper == Damper::full)
            sideways = joints.explicitDamping[j] * (relative - lengthening * direction);
    }
    joints.force[j] = pull;
    const Vec2 total = pull * direction + sideways;
    const Point force = total.cast<double>();
    particles.force[a] += force;
    particles.force[b] -= force;
}

ForceView forceViewOf(State& state) {
    Particles& p = state.particles;
    const ExplicitJoints& j = state.work.explicitBatches;
    return {p.position.data()->data(),
            p.velocity.data()->data(),
            p.force.data()->data(),
            state.joints.force.data(),
            j.joint.data(),
            j.a.data(),
            j.b.data(),
            j.rest.data(),
            j.stiffness.data(),
            j.damping.data()};
}

/// Adds the forces of joints that are neighbours in the list, all of one batch.
void addForces(State& state, const ForceView& view, const ForceBatch& batch, std::uint32_t first,
               std::uint32_t last) {
    if (!batch.wide || (state.settings.damper == Damper::full && batch.damped)) {
        for (auto k = first; k < last; ++k) addElasticForce(state, state.work.explicitJoints[k]);
        return;
    }
    const auto add = batch.damped ? forceKernels().damped : forceKernels().elastic;
    add(view, batch.place + (first - batch.first), last - first);
}

/// The first particle of the body with the particle of that number, or how many there are.
std::uint32_t bodyStart(const State& state, std::size_t particle) {
    const Particles& p = state.particles;
    if (particle >= p.size()) return static_cast<std::uint32_t>(p.size());
    return state.bodies[p.body[particle]].firstParticle;
}

/// Those of the bodies whose first particles are in [begin, end): within a batch they come in the
/// order of their bodies.
void addForcesOf(State& state, const ForceView& view, std::uint32_t begin, std::uint32_t end) {
    const auto& list = state.work.explicitJoints;
    const auto& a = state.joints.a;
    for (const ForceBatch& batch : state.work.explicitBatches.batches) {
        const auto firstFrom = [&](std::uint32_t particle) {
            const auto found =
                std::partition_point(list.begin() + batch.first, list.begin() + batch.last,
                                     [&](std::uint32_t j) { return a[j] < particle; });
            return static_cast<std::uint32_t>(found - list.begin());
        };
        const auto first = firstFrom(begin), last = firstFrom(end);
        if (first < last) addForces(state, view, batch, first, last);
    }
}

void gatherJoints(State& state) {
    const auto& list = state.work.explicitJoints;
    if (list.empty()) return;
    const ForceView view = forceViewOf(state);
    constexpr std::size_t inMicrosecond = 400;
    const std::size_t size = state.particles.size();
    const std::size_t pieces =
        state.work.explicitBatches.byBodies ? piecesOf(state.tasks, list.size(), inMicrosecond) : 1;
    if (pieces == 1) {
        for (const ForceBatch& batch : state.work.explicitBatches.batches)
            addForces(state, view, batch, batch.first, batch.last);
        return;
    }
    runPieces(state.tasks, pieces, [&](std::size_t i) {
        addForcesOf(state, view, bodyStart(state, pieceStart(i, pieces, size)),
                    bodyStart(state, pieceStart(i + 1, pieces, size)));
    });
}

}  // namespace

void gatherForces(State& state) {
    const WorkLists& work = state.work;
    const std::size_t count = work.explicitJoints.size() + work.explicitAngles.size();
    state.looked(Stage::forces, count);
    if (count == 0) return;
    if (work.holdsClusters) state.anyForced = true;
    gatherJoints(state);
    gatherAngles(state);
}

}  // namespace sulfur::detail
