#include "solver/work_lists.hpp"

#include <algorithm>
#include <utility>

#include "contacts/stages.hpp"
#include "model/contact_core.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

namespace {

bool hasHinges(const State& state, Range clusters) {
    const auto& hinges = state.clusters.hinges;
    const auto at = std::partition_point(hinges.begin(), hinges.end(), [&](const Hinge& hinge) {
        return hinge.cluster < clusters.first;
    });
    return at != hinges.end() && at->cluster < clusters.last;
}

/// Of an ascending list, what is in [first, last).
void erase(std::vector<std::uint32_t>& list, Range which) {
    const auto from = std::lower_bound(list.begin(), list.end(), which.first);
    list.erase(from, std::lower_bound(from, list.end(), which.last));
}
void insert(std::vector<std::uint32_t>& list, std::uint32_t value) {
    list.insert(std::lower_bound(list.begin(), list.end(), value), value);
}

/// The first of ascending ranges that ends behind a particle.
auto rangeAt(std::vector<Range>& ranges, std::uint32_t particle) {
    return std::partition_point(ranges.begin(), ranges.end(),
                                [&](const Range& range) { return range.last <= particle; });
}
void cut(std::vector<Range>& ranges, Range which) {
    for (auto at = rangeAt(ranges, which.first); at != ranges.end() && at->first < which.last;) {
        const Range before{at->first, which.first}, after{which.last, at->last};
        if (before.first < before.last && after.first < after.last) {
            *at = before;
            ranges.insert(at + 1, after);
            return;
        }
        if (before.first < before.last)
            *at++ = before;
        else if (after.first < after.last)
            *at++ = after;
        else
            at = ranges.erase(at);
    }
}
/// A particle that is in none of them. Neighbours become one range.
void enter(std::vector<Range>& ranges, std::uint32_t particle) {
    auto at = rangeAt(ranges, particle);
    const bool joinsNext = at != ranges.end() && at->first == particle + 1;
    const bool joinsPrevious = at != ranges.begin() && (at - 1)->last == particle;
    if (joinsNext && joinsPrevious) {
        (at - 1)->last = at->last;
        ranges.erase(at);
    } else if (joinsNext) {
        --at->first;
    } else if (joinsPrevious) {
        ++(at - 1)->last;
    } else {
        ranges.insert(at, {particle, particle + 1});
    }
}

}  // namespace

Range clustersOf(const State& state, std::uint32_t body) {
    const auto& list = state.clusters.list;
    const auto from = std::partition_point(list.begin(), list.end(),
                                           [&](const Cluster& c) { return c.body < body; });
    const auto to =
        std::find_if(from, list.end(), [&](const Cluster& c) { return c.body != body; });
    return {static_cast<std::uint32_t>(from - list.begin()),
            static_cast<std::uint32_t>(to - list.begin())};
}

bool isInTree(const State& state, std::uint32_t index) {
    const Range clusters = clustersOf(state, index);
    for (auto c = clusters.first; c < clusters.last; ++c)
        if (state.trees.ofCluster[c] != none) return true;
    const auto first = state.bodies[index].firstParticle;
    for (auto i = first; i < first + state.bodies[index].particles.size(); ++i)
        if (state.trees.ofParticle[i] != none) return true;
    return false;
}

bool isPlain(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    if (body.strained || hasLinks(state.core, body.id.index - 1) || isInTree(state, index) ||
        hasHinges(state, clustersOf(state, index)))
        return false;
    const Range angles = anglesOf(state, index);
    return body.kind != BodyKind::dynamic ||
           (std::all_of(state.angles.kind.begin() + angles.first,
                        state.angles.kind.begin() + angles.last,
                        [](AngleKind kind) { return kind == AngleKind::held; }) &&
            std::all_of(body.joints.begin(), body.joints.end(), [&](JointId id) {
                return state.joints.inCluster[state.jointSlots.dense(id)] != 0;
            }));
}

void unlist(State& state, std::uint32_t index) {
    WorkLists& work = state.work;
    const BodyRecord& body = state.bodies[index];
    const bool isListed = index < work.listed.bodies && (!work.stale || work.onlyAdded);
    if (!isListed || body.kind == BodyKind::fixed || body.disabled) return;
    const auto at = std::lower_bound(work.bodies.begin(), work.bodies.end(), index);
    if (at == work.bodies.end() || *at != index) {
        --work.sleepers;
        return;
    }
    work.bodies.erase(at);
    erase(work.kinematic, {index, index + 1});
    const auto size = static_cast<std::uint32_t>(body.particles.size());
    work.awakeParticles -= size;
    work.awakeSurfaces -= countSurfaces(state, body);
    for (auto* ranges : {&work.awake, &work.points, &work.free})
        cut(*ranges, {body.firstParticle, body.firstParticle + size});
    for (auto* list : {&work.awakeClusters, &work.clusters, &work.watchedClusters})
        erase(*list, clustersOf(state, index));
    for (const JointId id : body.joints) {
        const auto j = state.jointSlots.dense(id);
        if (state.joints.strength[j] != infinite) erase(work.breakableJoints, {j, j + 1});
    }
}

void retireFromLists(State& state, std::uint32_t index) {
    WorkLists& work = state.work;
    const BodyRecord& body = state.bodies[index];
    const bool isListed = index < work.listed.bodies && (!work.stale || work.onlyAdded);
    if (!isListed || body.kind == BodyKind::fixed || body.disabled) return;
    if (!std::binary_search(work.bodies.begin(), work.bodies.end(), index)) {
        --work.sleepers;
        return;
    }
    work.hasGaps = true;
    const auto size = static_cast<std::uint32_t>(body.particles.size());
    work.awakeParticles -= size;
    work.awakeSurfaces -= countSurfaces(state, body);
    for (auto* ranges : {&work.awake, &work.points, &work.free})
        cut(*ranges, {body.firstParticle, body.firstParticle + size});
}

void closeListGaps(State& state) {
    WorkLists& work = state.work;
    if (!std::exchange(work.hasGaps, false) || (work.stale && !work.onlyAdded)) return;
    const auto isGone = [&](std::uint32_t body) { return state.bodies[body].gone > 0; };
    for (auto* list : {&work.bodies, &work.kinematic}) {
        state.statistics.upkeep += list->size();
        std::erase_if(*list, isGone);
    }
    for (auto* list : {&work.awakeClusters, &work.clusters, &work.watchedClusters}) {
        state.statistics.upkeep += list->size();
        std::erase_if(*list, [&](std::uint32_t c) { return isGone(state.clusters.list[c].body); });
    }
    state.statistics.upkeep += work.breakableJoints.size();
    std::erase_if(work.breakableJoints, [&](std::uint32_t j) {
        return state.joints.body[j] != none && isGone(state.joints.body[j]);
    });
}

void enlist(State& state, std::uint32_t index) {
    WorkLists& work = state.work;
    const BodyRecord& body = state.bodies[index];
    if (body.asleep) ++work.sleepers;
    if (!state.awake(index)) return;
    insert(work.bodies, index);
    if (body.kind == BodyKind::kinematic) insert(work.kinematic, index);
    const auto size = static_cast<std::uint32_t>(body.particles.size());
    const auto surfaces = countSurfaces(state, body);
    work.awakeParticles += size;
    work.awakeSurfaces += surfaces;
    for (auto i = body.firstParticle; i < body.firstParticle + size; ++i) {
        if (surfaces > 0) enter(work.awake, i);
        if (state.particles.cluster[i] != none) continue;
        enter(work.points, i);
        enter(work.free, i);
    }
    const Range clusters = clustersOf(state, index);
    for (auto c = clusters.first; c < clusters.last; ++c) {
        insert(work.awakeClusters, c);
        insert(work.clusters, c);
        if (state.clusters.list[c].watched) insert(work.watchedClusters, c);
    }
    for (const JointId id : body.joints) {
        const auto j = state.jointSlots.dense(id);
        if (state.joints.strength[j] != infinite) insert(work.breakableJoints, j);
    }
}

std::uint32_t countSurfaces(const State& state, const BodyRecord& body) {
    const auto first = state.particles.reach.begin() + body.firstParticle;
    return static_cast<std::uint32_t>(
        std::count_if(first, first + static_cast<std::ptrdiff_t>(body.particles.size()),
                      [](Real reach) { return reach > 0; }));
}

}  // namespace sulfur::detail
