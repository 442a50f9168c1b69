// Which contact is a row of which link.
#include <algorithm>
#include <array>
#include <utility>

#include "contacts/touch_rows.hpp"
#include "model/state.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

/// The node whose link a touch becomes a row of: that of the corner, or of the side's lower end;
/// none when both sides are of one tree, or neither is.
std::uint32_t nodeFor(const State& state, const std::array<std::uint32_t, 3>& particles) {
    const Trees& trees = state.trees;
    const auto treeOf = [&](std::uint32_t i) {
        const auto c = state.particles.cluster[i];
        return c == none ? trees.ofParticle[i] : trees.ofCluster[c];
    };
    const auto p = treeOf(particles[0]), a = treeOf(particles[1]), b = treeOf(particles[2]);
    if (p == none ? a == none : (p == a || p == b)) return none;
    const auto nodeOf = [&](std::uint32_t i) {
        return state.particles.cluster[i] == none ? trees.nodeOfParticle[i] : none;
    };
    const auto heldByJoint = [&](std::uint32_t k) {
        return k != none && trees.nodes[k].parent != none && trees.nodes[k].kind == LinkKind::joint;
    };
    if (p != none) return heldByJoint(nodeOf(particles[0])) ? nodeOf(particles[0]) : none;
    if (a != b) return none;
    const auto first = nodeOf(particles[1]), second = nodeOf(particles[2]);
    if (first == none || second == none) return none;
    const auto root = trees.list[a].first;
    for (const auto& [child, parent] : {std::pair(first, second), std::pair(second, first)})
        if (heldByJoint(child) && (first == second || trees.nodes[child].parent + root == parent))
            return child;
    return none;
}

/// The network that only one side of a touch is of, with the nodes of that side: of a capsule both
/// ends, whose motion the factorisation couples.
NetworkTouch networkTouchOf(const State& state, std::uint32_t touch) {
    const Trees& trees = state.trees;
    const auto particles = particlesOfTouch(state, touch);
    const auto nodeOf = [&](std::uint32_t i) {
        return state.particles.cluster[i] == none ? trees.nodeOfParticle[i] : none;
    };
    const auto networkOf = [&](std::uint32_t i) {
        const auto tree = nodeOf(i) == none ? none : trees.ofParticle[i];
        return tree == none ? none : trees.list[tree].network;
    };
    const auto p = networkOf(particles[0]), a = networkOf(particles[1]),
               b = networkOf(particles[2]);
    const auto from = [&](std::uint32_t particle) {
        return nodeOf(particle) - trees.list[trees.ofParticle[particle]].first;
    };
    if (p != none && p != a && p != b) return {p, touch, from(particles[0]), none};
    if (p != none || a == none || a != b) return {};
    const NetworkTouch held{a, touch, from(particles[1]), from(particles[2])};
    if (held.here == held.there) return {a, touch, held.here, none};
    const bool coupled = trees.factors[a].pattern.hasEntry(held.here, held.there);
    return coupled ? held : NetworkTouch{};
}

void giveTouches(State& state) {
    const auto& touches = state.core.touches;
    std::pmr::vector<Real> gaps(state.trees.nodes.size(), 0, &state.arena);
    for (std::uint32_t i = 0; i < touches.size(); ++i) {
        if (touches[i].pair == none || !touches[i].row) continue;
        if (!state.trees.factors.empty())
            if (const auto held = networkTouchOf(state, i); held.network != none)
                state.trees.networkTouches.push_back(held);
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
    trees.contact.assign(trees.nodes.size(), none);
    trees.networkTouches.clear();
    trees.nodeOfParticle.assign(state.particles.size(), none);
    for (std::uint32_t k = 0; k < trees.nodes.size(); ++k)
        if (trees.nodes[k].particle != none && trees.ofParticle[trees.nodes[k].particle] != none)
            trees.nodeOfParticle[trees.nodes[k].particle] = k;
    giveTouches(state);
    std::sort(trees.networkTouches.begin(), trees.networkTouches.end(),
              [](const NetworkTouch& a, const NetworkTouch& b) {
                  return std::pair(a.network, a.touch) < std::pair(b.network, b.touch);
              });
}

}  // namespace sulfur::detail
