
#include <algorithm>

#include "core/counting_sort.hpp"
#include "joints/batches.hpp"
#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

namespace {

/// Fewer joints of one level are added one by one.
constexpr std::uint32_t fewest = 4;

/// One more than that of any joint before it that shares a particle with it. Returns the highest.
std::uint32_t findLevels(const State& state, const std::vector<std::uint32_t>& list,
                         ExplicitJoints& all) {
    if (list.empty()) return 0;
    all.levelOfParticle.assign(state.particles.size(), 0);
    all.levelOfJoint.resize(state.joints.size());
    std::uint32_t highest = 0;
    for (const auto j : list) {
        auto& a = all.levelOfParticle[state.joints.a[j]];
        auto& b = all.levelOfParticle[state.joints.b[j]];
        all.levelOfJoint[j] = a = b = std::max(a, b) + 1;
        highest = std::max(highest, a);
    }
    return highest;
}

/// (Joints that were made later come after all others.)
bool isByBodies(const State& state, const std::vector<std::uint32_t>& list,
                const ForceBatch& batch) {
    std::uint32_t last = 0;
    for (auto k = batch.first; k < batch.last; ++k) {
        const auto body = state.joints.body[list[k]];
        if (body == none || body < last) return false;
        last = body;
    }
    return true;
}

void fill(const State& state, const std::vector<std::uint32_t>& list, ExplicitJoints& all,
          ForceBatch& batch) {
    const Joints& joints = state.joints;
    batch.damped = false;
    for (auto k = batch.first; k < batch.last; ++k) {
        const auto j = list[k];
        const std::size_t at = batch.place + (k - batch.first);
        all.joint[at] = j;
        all.a[at] = 2 * joints.a[j];
        all.b[at] = 2 * joints.b[j];
        all.rest[at] = joints.restLength[j];
        all.stiffness[at] = joints.explicitStiffness[j];
        all.damping[at] = joints.explicitDamping[j];
        batch.damped |= joints.explicitDamping[j] > 0;
    }
}

}  // namespace

void batchExplicitJoints(State& state) {
    auto& list = state.work.explicitJoints;
    ExplicitJoints& all = state.work.explicitBatches;
    const std::uint32_t highest = findLevels(state, list, all);
    const auto& level = all.levelOfJoint;
    countingSort(list, all.sorted, all.levelStart, highest + 1,
                 [&](std::uint32_t j) { return level[j]; });
    all.batches.clear();
    all.byBodies = true;
    std::size_t places = 0;
    const auto size = static_cast<std::uint32_t>(list.size());
    for (std::uint32_t first = 0, last = 0; first < size; first = last) {
        while (last < size && level[list[last]] == level[list[first]]) ++last;
        ForceBatch batch{first, last, static_cast<std::uint32_t>(places)};
        batch.wide = last - first >= fewest;
        if (batch.wide) places += (last - first + sweepLanes - 1) / sweepLanes * sweepLanes;
        all.byBodies = all.byBodies && isByBodies(state, list, batch);
        all.batches.push_back(batch);
    }
    // What lies behind the last joint of a batch takes hold of a particle that there is; also where
    // a thread begins in the midst of one.
    places += sweepLanes;
    for (auto* numbers : {&all.joint, &all.a, &all.b}) numbers->assign(places, 0);
    for (auto* numbers : {&all.rest, &all.stiffness, &all.damping}) numbers->assign(places, 0);
    fillExplicitBatches(state);
}

void fillExplicitBatches(State& state) {
    ExplicitJoints& all = state.work.explicitBatches;
    for (ForceBatch& batch : all.batches)
        if (batch.wide) fill(state, state.work.explicitJoints, all, batch);
}

}  // namespace sulfur::detail
