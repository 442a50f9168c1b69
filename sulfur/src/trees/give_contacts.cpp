// Which contact is a row of which link.
#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "contacts/touch_rows.hpp"
#include "core/settings.hpp"
#include "model/state.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// The node whose link a touch becomes a row of: that of the corner if a joint holds it, else that
/// of the side's lower end; none when both sides are of one tree, or no joint of a tree holds
/// either.
std::uint32_t nodeFor(const State& state, const std::array<std::uint32_t, 3>& particles) {
    const Trees& trees = state.trees;
    const auto treeOf = [&](std::uint32_t i) { return trees.of(state.particles.cluster[i], i); };
    const auto p = treeOf(particles[0]), a = treeOf(particles[1]), b = treeOf(particles[2]);
    if (p == none ? a == none : (p == a || p == b)) return none;
    const auto nodeOf = [&](std::uint32_t i) {
        return state.particles.cluster[i] == none ? trees.nodeOfParticle[i] : none;
    };
    const auto heldByJoint = [&](std::uint32_t k) {
        return k != none && trees.nodes[k].parent != none && trees.nodes[k].kind == LinkKind::joint;
    };
    if (p != none && heldByJoint(nodeOf(particles[0]))) return nodeOf(particles[0]);
    if (a == none || a != b) return none;
    const auto first = nodeOf(particles[1]), second = nodeOf(particles[2]);
    if (first == none || second == none) return none;
    const auto root = trees.list[a].first;
    for (const auto& [child, parent] : {std::pair(first, second), std::pair(second, first)})
        if (heldByJoint(child) && (first == second || trees.nodes[child].parent + root == parent))
            return child;
    return none;
}

/// The networks that a touch is of, with its nodes.
NetworkTouch networkTouchOf(const State& state, std::uint32_t touch) {
    const Trees& trees = state.trees;
    const auto particles = particlesOfTouch(state, touch);
    NetworkTouch held{
        none, touch, {none, none, none}, {none, none, none}, pressingOf(state, touch)};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = particles[k];
        if (state.particles.cluster[i] != none || trees.nodeOfParticle[i] == none) continue;
        const auto tree = trees.ofParticle[i];
        if (trees.list[tree].network == none) continue;
        held.trees[k] = tree;
        held.nodes[k] = trees.nodeOfParticle[i] - trees.list[tree].first;
    }
    return held;
}
bool isOfNetwork(const NetworkTouch& held) {
    return std::any_of(held.trees.begin(), held.trees.end(),
                       [](std::uint32_t tree) { return tree != none; });
}

/// Of each group those that press most, as many as it solves as a whole.
void choosePressing(std::vector<NetworkTouch>& touches) {
    std::sort(touches.begin(), touches.end(), [](const NetworkTouch& a, const NetworkTouch& b) {
        return std::tuple(a.group, -a.pressing, a.touch) <
               std::tuple(b.group, -b.pressing, b.touch);
    });
    std::uint32_t group = none;
    std::size_t kept = 0, ofGroup = 0;
    for (const NetworkTouch& t : touches) {
        ofGroup = t.group == group ? ofGroup + 1 : 0;
        group = t.group;
        if (ofGroup < tuned::networkContacts) touches[kept++] = t;
    }
    touches.resize(kept);
}

/// The node of each particle that trees move, anew after these have been found anew.
void listNodes(State& state) {
    Trees& trees = state.trees;
    const bool isStale = trees.nodeOfParticle.empty();
    trees.nodeOfParticle.resize(state.particles.size(), none);
    for (std::uint32_t k = 0; isStale && k < trees.nodes.size(); ++k)
        if (trees.nodes[k].particle != none && trees.ofParticle[trees.nodes[k].particle] != none)
            trees.nodeOfParticle[trees.nodes[k].particle] = k;
}

void giveTouches(State& state) {
    const auto& touches = state.core.touches;
    std::pmr::vector<Real> gaps(state.trees.nodes.size(), 0, &state.arena);
    for (std::uint32_t i = 0; i < touches.size(); ++i) {
        if (touches[i].pair == none || !touches[i].row) continue;
        if (!state.trees.factors.empty())
            if (const auto held = networkTouchOf(state, i); isOfNetwork(held)) {
                state.trees.networkTouches.push_back(held);
                continue;
            }
        const auto k = nodeFor(state, particlesOfTouch(state, i));
        if (k == none) continue;
        const Real gap = viewOfTouch(state, i).gap;
        auto& held = state.trees.contact[k];
        if (held != none && !(gaps[k] > gap)) continue;
        held = i;
        gaps[k] = gap;
    }
}

}  // namespace

void giveContacts(State& state) {
    Trees& trees = state.trees;
    trees.networkTouches.clear();
    listNodes(state);
    giveTouches(state);
}

void groupNetworks(State& state) {
    Trees& trees = state.trees;
    std::pmr::vector<std::uint32_t> root(trees.list.size(), none, &state.arena);
    for (const auto i : trees.touchedAlone)
        if (trees.list[i].network != none) root[i] = i;
    const auto find = [&](std::uint32_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (NetworkTouch& touch : trees.networkTouches) {
        std::uint32_t first = none;
        for (std::size_t k = 0; k < 3; ++k) {
            if (touch.trees[k] == none) continue;
            if (root[touch.trees[k]] == none) {
                touch.trees[k] = touch.nodes[k] = none;
                continue;
            }
            const auto i = find(touch.trees[k]);
            if (first != none && i != first) root[std::max(i, first)] = std::min(i, first);
            first = first == none ? i : std::min(i, first);
        }
    }
    std::erase_if(trees.networkTouches, [](const NetworkTouch& t) { return !isOfNetwork(t); });
    trees.groupOf.assign(trees.list.size(), none);
    trees.groupCount = 0;
    for (const auto i : trees.touchedAlone) {
        if (root[i] == none) continue;
        auto& group = trees.groupOf[find(i)];
        if (group == none) {
            group = trees.groupCount++;
            if (trees.networkGroups.size() < trees.groupCount) trees.networkGroups.emplace_back();
            NetworkGroup& made = trees.networkGroups[group];
            made.trees.clear();
            made.answers.clear();
            made.work = 0;
            made.waits = false;
            made.error = made.mostPressing = 0;
        }
        trees.groupOf[i] = group;
        trees.networkGroups[group].trees.push_back(i);
    }
    for (NetworkTouch& touch : trees.networkTouches)
        for (const auto tree : touch.trees)
            if (tree != none) touch.group = trees.groupOf[tree];
    choosePressing(trees.networkTouches);
}

}  // namespace sulfur::detail
