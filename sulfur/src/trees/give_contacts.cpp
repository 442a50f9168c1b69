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

/// The node whose link a touch becomes a row of: that of the corner, or of the side's lower end;
/// none when both sides are of one tree, or neither is.
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

/// The network that a touch is of, with its nodes: that of its corner, else of its side.
NetworkTouch networkTouchOf(const State& state, std::uint32_t touch) {
    const Trees& trees = state.trees;
    const auto particles = particlesOfTouch(state, touch);
    const auto networkOf = [&](std::uint32_t i) {
        if (state.particles.cluster[i] != none || trees.nodeOfParticle[i] == none) return none;
        return trees.list[trees.ofParticle[i]].network;
    };
    NetworkTouch held{none, touch, {none, none, none}, pressingOf(state, touch)};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto network = networkOf(particles[k]);
        if (held.network == none) held.network = network;
        if (network == none || network != held.network) continue;
        const Tree& tree = trees.list[trees.ofParticle[particles[k]]];
        held.nodes[k] = trees.nodeOfParticle[particles[k]] - tree.first;
    }
    return held;
}

/// Of each network those that press most, as many as it solves as a whole.
void choosePressing(std::vector<NetworkTouch>& touches) {
    std::sort(touches.begin(), touches.end(), [](const NetworkTouch& a, const NetworkTouch& b) {
        return std::tuple(a.network, -a.pressing, a.touch) <
               std::tuple(b.network, -b.pressing, b.touch);
    });
    std::uint32_t network = none;
    std::size_t kept = 0, ofNetwork = 0;
    for (const NetworkTouch& t : touches) {
        ofNetwork = t.network == network ? ofNetwork + 1 : 0;
        network = t.network;
        if (ofNetwork < tuned::networkContacts) touches[kept++] = t;
    }
    touches.resize(kept);
}

void giveTouches(State& state) {
    const auto& touches = state.core.touches;
    std::pmr::vector<Real> gaps(state.trees.nodes.size(), 0, &state.arena);
    for (std::uint32_t i = 0; i < touches.size(); ++i) {
        if (touches[i].pair == none || !touches[i].row) continue;
        if (!state.trees.factors.empty())
            if (const auto held = networkTouchOf(state, i); held.network != none) {
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
    trees.contact.assign(trees.nodes.size(), none);
    trees.networkTouches.clear();
    trees.nodeOfParticle.assign(state.particles.size(), none);
    for (std::uint32_t k = 0; k < trees.nodes.size(); ++k)
        if (trees.nodes[k].particle != none && trees.ofParticle[trees.nodes[k].particle] != none)
            trees.nodeOfParticle[trees.nodes[k].particle] = k;
    giveTouches(state);
    choosePressing(trees.networkTouches);
}

}  // namespace sulfur::detail
