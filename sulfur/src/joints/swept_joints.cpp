
#include <algorithm>
#include <array>

#include "joints/batches.hpp"

namespace sulfur::detail {

namespace {

/// Fewer joints of one colour are solved one by one.
constexpr std::uint32_t fewestWide = 4;

bool isFree(const State& state, std::uint32_t j) {
    const auto& cluster = state.particles.cluster;
    return cluster[state.joints.a[j]] == none && cluster[state.joints.b[j]] == none &&
           state.structure.colours[j] != noColour;
}

/// Divides joints by the bodies that they belong to: where parts begin, by particles.
class Parts {
public:
    /// Into one part where joints hold clusters or bodies to each other.
    Parts(State& state, const std::vector<std::uint32_t>& list) : state_(state) {
        constexpr std::size_t leastJoints = 512;  // in a part; less is not worth the lanes
        const auto parts = std::min<std::size_t>(most, list.size() / leastJoints);
        if (parts < 2) return;
        std::pmr::vector<std::uint32_t> joints(state.bodies.size(), 0, &state.arena);  // by bodies
        for (const auto j : list) ++joints[state.particles.body[state.joints.a[j]]];
        std::size_t before = 0;
        for (std::size_t body = 0; body < joints.size() && count_ < parts; ++body) {
            if (count_ < parts && before * parts >= count_ * list.size() && before > 0)
                begins_[count_++] = state.bodies[body].firstParticle;
            before += joints[body];
        }
        if (!std::all_of(list.begin(), list.end(), [&](auto j) { return isWithin(j); })) count_ = 1;
    }

    std::uint32_t count() const { return count_; }
    std::uint32_t of(std::uint32_t joint) const { return ofParticle(state_.joints.a[joint]); }

private:
    static constexpr std::size_t most = 4;

    std::uint32_t ofParticle(std::uint32_t particle) const {
        std::uint32_t part = count_ - 1;
        while (particle < begins_[part]) --part;
        return part;
    }
    bool isWithin(std::uint32_t j) const {
        return isFree(state_, j) &&
               ofParticle(state_.joints.a[j]) == ofParticle(state_.joints.b[j]);
    }

    const State& state_;
    std::uint32_t count_ = 1;
    std::array<std::uint32_t, most> begins_{};
};

/// Behind the last joint of a batch come copies of its first, whose pushes are left out.
void fillLanes(const State& state, const std::vector<std::uint32_t>& list, SweptJoints& swept) {
    const Joints& joints = state.joints;
    swept.h = swept.newtons = 0;  // what follows from these is stale
    for (const SweepBatch& batch : swept.batches) {
        if (!batch.wide) continue;
        const std::size_t end = (batch.size() + sweepLanes - 1) / sweepLanes * sweepLanes;
        for (std::size_t i = 0; i < end; ++i) {
            const auto j = list[batch.first + (i < batch.size() ? i : 0)];
            const std::size_t at = batch.place + i;
            swept.joint[at] = j;
            swept.a[at] = 2 * joints.a[j];
            swept.b[at] = 2 * joints.b[j];
            swept.massA[at] = state.particles.inverseMass[joints.a[j]];
            swept.massB[at] = state.particles.inverseMass[joints.b[j]];
            swept.length[at] = joints.restLength[j];
        }
    }
}

void makeRoom(const State& state, const std::vector<std::uint32_t>& list, std::size_t places,
              SweptJoints& swept) {
    swept.forEachArray([&](auto& numbers) { numbers.resize(places); });
    const bool rigid = !list.empty() && state.joints.kind[list.front()] == JointKind::rigid;
    for (auto* numbers : {&swept.hk, &swept.hb}) numbers->resize(rigid ? 0 : places);
    swept.rest.resize(rigid ? places : 0);
}

void batch(State& state, const std::vector<std::uint32_t>& list, SweptJoints& swept) {
    swept.batches.clear();
    const Parts parts(state, list);
    swept.parts = parts.count();
    std::size_t places = 0;
    const auto size = static_cast<std::uint32_t>(list.size());
    for (std::uint32_t first = 0, last = 0; first < size; first = last) {
        const auto same = [&](std::uint32_t k) {
            return state.structure.colours[list[k]] == state.structure.colours[list[first]] &&
                   isFree(state, list[k]) == isFree(state, list[first]);
        };
        while (last < size && same(last)) ++last;
        const bool wide = isFree(state, list[first]) && last - first >= fewestWide;
        // Neighbours of one part; where bodies do not come in their order, of a few.
        for (std::uint32_t from = first, to = first; from < last; from = to) {
            const auto part = parts.of(list[from]);
            while (to < last && parts.of(list[to]) == part) ++to;
            swept.batches.push_back({from, to, static_cast<std::uint32_t>(places), wide, part});
            if (wide) places += (to - from + sweepLanes - 1) / sweepLanes * sweepLanes;
        }
    }
    makeRoom(state, list, places, swept);
    fillLanes(state, list, swept);
}

}  // namespace

void batchSweptJoints(State& state) {
    WorkLists& work = state.work;
    batch(state, work.implicitJoints, work.implicitSweep);
    batch(state, work.rigidJoints, work.rigidSweep);
}

void fillSweptBatches(State& state) {
    WorkLists& work = state.work;
    fillLanes(state, work.implicitJoints, work.implicitSweep);
    fillLanes(state, work.rigidJoints, work.rigidSweep);
}

}  // namespace sulfur::detail
