// Stage: joints break that were loaded beyond their strength.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/settings.hpp"
#include "solver/compact.hpp"
#include "solver/split.hpp"
#include "solver/stages.hpp"

namespace sulfur::detail {

namespace {

JointBroken describe(const State& state, std::uint32_t j) {
    const Joints& joints = state.joints;
    JointBroken event;
    event.joint = joints.id[j];
    if (joints.body[j] != none) event.body = state.bodies[joints.body[j]].id;
    event.point =
        (state.particles.position[joints.a[j]] + state.particles.position[joints.b[j]]) / 2;
    event.force = std::abs(joints.force[j]);
    return event;
}

/// A crack opens where a body is loaded most, and relieves the rest of it: of the joints that are
/// loaded beyond their strength only those break whose load is this share of the worst.
constexpr Real opens = Real(tuned::loadShare);

/// The load of a joint in its strength.
Real loadOf(const Joints& joints, std::uint32_t j) {
    return std::abs(joints.force[j]) / joints.strength[j];
}

/// The tree or network that a joint is a link of, or none.
std::uint32_t treeOf(const State& state, std::uint32_t j) {
    const Joints& joints = state.joints;
    if (joints.inCluster[j] != 0 || joints.kind[j] == JointKind::explicitElastic) return none;
    const auto at = [&](std::uint32_t end) {
        return state.trees.of(state.particles.cluster[end], end);
    };
    const auto a = at(joints.a[j]), b = at(joints.b[j]);
    if (a == none || b == none) return a == none ? b : a;
    return a == b ? a : none;
}

/// Joints that break in this step. What is tied in a row bears the same load everywhere, and is
/// relieved by the first that breaks: of a tree or network it is the worst one alone.
std::pmr::vector<std::uint32_t> breaking(State& state) {
    const Joints& joints = state.joints;
    std::pmr::vector<std::uint32_t> overloaded(&state.arena);
    for (const auto j : state.work.breakableJoints)
        if (loadOf(joints, j) > 1) overloaded.push_back(j);
    if (overloaded.empty()) return overloaded;
    std::pmr::vector<Real> worst(state.bodies.size(), 0, &state.arena);
    std::pmr::vector<std::uint32_t> weakest(state.trees.list.size(), none, &state.arena);
    for (const auto j : overloaded) {
        const auto tree = treeOf(state, j);
        if (const auto b = joints.body[j]; b != none && tree == none)
            worst[b] = std::max(worst[b], loadOf(joints, j));
        if (tree == none) continue;
        if (weakest[tree] == none || loadOf(joints, j) > loadOf(joints, weakest[tree]))
            weakest[tree] = j;
    }
    std::erase_if(overloaded, [&](std::uint32_t j) {
        if (const auto tree = treeOf(state, j); tree != none) return weakest[tree] != j;
        return joints.body[j] != none && loadOf(joints, j) < opens * worst[joints.body[j]];
    });
    return overloaded;
}

/// What has lost the last of its surface would hang on its braces and pass through everything: the
/// braces break with the surface. `broken` are marked already, and so are these.
void breakBraces(State& state, std::uint32_t particle, std::vector<bool>& broken) {
    if (state.particles.radius[particle] > 0 || isAttached(state, particle)) return;
    const Joints& joints = state.joints;
    for (std::uint32_t j = 0; j < joints.size(); ++j)  // it hangs on another body
        if (joints.body[j] == none && (joints.a[j] == particle || joints.b[j] == particle)) return;
    std::vector<std::uint32_t> braces;
    for (const JointId id : state.bodies[state.particles.body[particle]].joints) {
        const auto j = state.jointSlots.dense(id);
        if (broken[j] || (joints.a[j] != particle && joints.b[j] != particle)) continue;
        if (joints.radius[j] > 0) return;
        braces.push_back(j);
    }
    for (const auto j : braces) {
        broken[j] = true;
        state.events.jointsBroken.push_back(describe(state, j));
    }
}

}  // namespace

void breakJoints(State& state) {
    auto& told = state.events.jointsBroken;
    const std::size_t first = told.size();  // those before broke in earlier steps of the tick
    const Joints& joints = state.joints;
    state.looked(Stage::breakage, state.work.breakableJoints.size());
    for (const auto j : breaking(state)) told.push_back(describe(state, j));
    if (told.size() == first) return;
    Removal removal(state);
    std::vector<ParticleId> ends;
    const std::size_t overloaded = told.size();
    for (std::size_t i = first; i < overloaded; ++i)
        removal.joints[state.jointSlots.dense(told[i].joint)] = true;
    for (std::size_t i = first; i < overloaded; ++i) {
        const auto j = state.jointSlots.dense(told[i].joint);
        if (joints.body[j] == none || !(joints.radius[j] > 0)) continue;
        for (const auto end : {joints.a[j], joints.b[j]}) breakBraces(state, end, removal.joints);
    }
    for (std::size_t i = first; i < told.size(); ++i) {
        const auto j = state.jointSlots.dense(told[i].joint);
        if (joints.body[j] == none) continue;
        ends.push_back(state.particles.id[joints.a[j]]);
        ends.push_back(state.particles.id[joints.b[j]]);
    }
    compact(state, removal);
    splitBodies(state, ends);
}

}  // namespace sulfur::detail
