#include "joints/retune.hpp"

#include <algorithm>

namespace sulfur::detail {

namespace {

using Indices = std::vector<std::uint32_t>;

void sortOut(Indices& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Where it stands, or the size where it does not.
std::size_t placeOf(const Indices& sorted, std::uint32_t i) {
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), i);
    const bool isThere = at != sorted.end() && *at == i;
    return isThere ? static_cast<std::size_t>(at - sorted.begin()) : sorted.size();
}
bool has(const Indices& sorted, std::uint32_t i) {
    return placeOf(sorted, i) < sorted.size();
}

/// The joints that hold any of these particles, in their order.
Indices jointsAt(const State& state, const Indices& particles) {
    const Joints& joints = state.joints;
    Indices bodies, found;
    for (const auto p : particles) bodies.push_back(state.particles.body[p]);
    sortOut(bodies);
    const auto add = [&](std::uint32_t j) {
        if (has(particles, joints.a[j]) || has(particles, joints.b[j])) found.push_back(j);
    };
    for (const auto b : bodies)
        for (const JointId id : state.bodies[b].joints) add(state.jointSlots.dense(id));
    for (std::uint32_t j = 0; j < joints.size(); ++j)
        if (joints.body[j] == none) add(j);
    std::sort(found.begin(), found.end());
    return found;
}

Indices endsOf(const Joints& joints, const Indices& list) {
    Indices ends;
    for (const auto j : list) ends.insert(ends.end(), {joints.a[j], joints.b[j]});
    sortOut(ends);
    return ends;
}

/// Angular joints share what may be a force with the springs at their particles.
bool hasAngles(const State& state, std::uint32_t particle) {
    const Range angles = anglesOf(state, state.particles.body[particle]);
    return angles.first != angles.last;
}

/// Whether it is a force at all, for which the joint stands in the list of those.
bool isForce(Real stiffness, Real damping) {
    return stiffness > 0 || damping > 0;
}

}  // namespace

Retuning::Retuning(const State& state, std::uint32_t joint, const Spring& spring) {
    const Joints& joints = state.joints;
    const auto a = joints.a[joint], b = joints.b[joint];
    isLocal_ = !isRigid(joints, joint) && spring.stiffness <= maxStiffness &&
               !hasAngles(state, a) && !hasAngles(state, b);
    if (isLocal_) collect(state, joint, spring);
}

void Retuning::collect(const State& state, std::uint32_t joint, const Spring& spring) {
    const Joints& joints = state.joints;
    const Indices around = jointsAt(state, endsOf(joints, {joint}));
    const Indices particles = endsOf(joints, around), all = jointsAt(state, particles);
    const auto springNow = [&](std::uint32_t j) {
        return j == joint ? spring : springOf(joints, j);
    };
    const auto forEachEnd = [&](std::uint32_t j, auto&& f) {
        for (const auto p : {joints.a[j], joints.b[j]})
            if (const auto at = placeOf(particles, p); at < particles.size()) f(at);
    };
    std::vector<Real> weights(particles.size(), 1);
    for (const auto j : all)
        if (isRigid(joints, j))
            forEachEnd(j,
                       [&](auto at) { weights[at] = weightOfSprings(state, particles[at], true); });
    std::vector<JointLoad> loads(particles.size());
    for (const auto j : all) {
        if (isRigid(joints, j)) continue;
        const Real mobilities = mobility(state, joints.a[j]) + mobility(state, joints.b[j]);
        forEachEnd(j, [&](auto at) {
            addLoad(loads[at], springNow(j), weights[at], mobilities, state.h);
        });
    }
    for (const auto j : around) {
        const JointLoad &a = loads[placeOf(particles, joints.a[j])],
                        &b = loads[placeOf(particles, joints.b[j])];
        const HowSolved how = howSolved(state, j, springNow(j), a, b);
        isLocal_ = isLocal_ && how.kind == joints.kind[j] &&
                   isForce(how.stiffness, how.damping) ==
                       isForce(joints.explicitStiffness[j], joints.explicitDamping[j]);
        changed_.push_back({j, how});
    }
}

void Retuning::apply(State& state) const {
    for (const auto& [j, how] : changed_) {
        state.joints.explicitStiffness[j] = how.stiffness;
        state.joints.explicitDamping[j] = how.damping;
        for (const auto p : {state.joints.a[j], state.joints.b[j]}) {
            const auto tree = state.trees.of(state.particles.cluster[p], p);
            if (tree == none || state.trees.list[tree].network == none) continue;
            // (0: it has none yet.)
            double& step = state.trees.list[tree].factorStep;
            if (step != 0) step = Tree::stale;
        }
    }
    state.work.retuned = true;
}

}  // namespace sulfur::detail
