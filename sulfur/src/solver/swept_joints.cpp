#include "solver/swept_joints.hpp"

#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// Fewer joints of one colour are solved one by one.
constexpr std::uint32_t fewest = 4;

bool isFree(const State& state, std::uint32_t j) {
    const auto& cluster = state.particles.cluster;
    return cluster[state.joints.a[j]] == none && cluster[state.joints.b[j]] == none &&
           state.structure.colours[j] != noColour;
}

}  // namespace

void batchJoints(const State& state, const std::vector<std::uint32_t>& list, SweptJoints& swept) {
    swept.batches.clear();
    std::size_t places = 0;
    const auto size = static_cast<std::uint32_t>(list.size());
    for (std::uint32_t first = 0, last = 0; first < size; first = last) {
        const auto same = [&](std::uint32_t k) {
            return state.structure.colours[list[k]] == state.structure.colours[list[first]] &&
                   isFree(state, list[k]) == isFree(state, list[first]);
        };
        while (last < size && same(last)) ++last;
        SweepBatch batch{first, last, static_cast<std::uint32_t>(places), false};
        batch.wide = isFree(state, list[first]) && last - first >= fewest;
        if (batch.wide) places += (last - first + sweepLanes - 1) / sweepLanes * sweepLanes;
        swept.batches.push_back(batch);
    }
    // What lies behind the last joint of a batch takes hold of a particle that there is.
    swept.a.assign(places, 0);
    swept.b.assign(places, 0);
    swept.forEachReal([&](std::vector<Real>& numbers) { numbers.assign(places, 0); });
    for (const SweepBatch& batch : swept.batches) {
        if (!batch.wide) continue;
        for (auto k = batch.first; k < batch.last; ++k) {
            swept.a[batch.place + (k - batch.first)] = state.joints.a[list[k]];
            swept.b[batch.place + (k - batch.first)] = state.joints.b[list[k]];
        }
    }
}

}  // namespace sulfur::detail
