// Trees, networks and lines in the sweeps: which take part, and when.
#include <algorithm>
#include <array>
#include <memory_resource>
#include <vector>

#include "contacts/touch_rows.hpp"
#include "core/limits.hpp"
#include "particles/motion.hpp"
#include "trees/networks.hpp"
#include "trees/tree_solver.hpp"
#include "trees/tree_sweeper.hpp"

namespace sulfur::detail {

namespace {

template <class Function>
void withTreeSweeper(State& state, std::uint32_t tree, Function&& f) {
    if (state.trees.list[tree].points)
        f(TreeSweeper<2>(state, tree));
    else
        f(TreeSweeper<3>(state, tree));
}
template <class Function>
void withSweeper(State& state, std::uint32_t tree, Function&& f) {
    if (state.trees.list[tree].network != none)
        f(NetworkSweeper(state, tree));
    else
        withTreeSweeper(state, tree, f);
}

/// Of trees that are awake.
void clearMultipliers(Trees& trees, const std::vector<std::uint32_t>& list) {
    for (auto* ofNodes : {&trees.met, &trees.lambda}) ofNodes->resize(trees.nodes.size());
    for (auto* ofLinks : {&trees.linkMet, &trees.linkLambda}) ofLinks->resize(trees.links.size());
    trees.contact.resize(trees.nodes.size(), none);
    const auto clear = [](auto& all, std::uint32_t first, std::uint32_t last, const auto& zero) {
        std::fill(all.begin() + first, all.begin() + last, zero);
    };
    constexpr std::array<double, 2> nothing{0, 0};
    for (const auto i : list) {
        const Tree& t = trees.list[i];
        for (auto* ofNodes : {&trees.met, &trees.lambda}) clear(*ofNodes, t.first, t.last, nothing);
        for (auto* ofLinks : {&trees.linkMet, &trees.linkLambda})
            clear(*ofLinks, t.firstLink, t.lastLink, nothing);
        clear(trees.contact, t.first, t.last, none);
    }
}

void pull(State& state, const Grip& grip) {
    Trees& trees = state.trees;
    const auto tree = trees.of(grip.cluster, grip.particle);
    if (tree != none) trees.touched[tree] = Trees::pulled;
}

/// Whether the `number`-th sweep over rows has stirred a node, or what touches its link.
bool isStirred(const State& state, const Tree& tree, int number) {
    const auto& stirred = state.core.stirred;
    const auto isNow = [&](std::uint32_t m) { return m != none && stirred[m] >= number; };
    for (auto k = tree.first; k < tree.last; ++k) {
        const TreeNode& n = state.trees.nodes[k];
        if (n.cluster != none && isNow(moverOfCluster(state, n.cluster))) return true;
        if (n.particle != none && isNow(moverOfParticle(state, n.particle))) return true;
        const auto touch = state.trees.contact[k];
        if (touch == none) continue;
        const auto movers = moversOfTouch(state, touch);
        if (std::any_of(movers.begin(), movers.end(), isNow)) return true;
    }
    return false;
}

}  // namespace

void touchTrees(State& state) {
    Trees& trees = state.trees;
    trees.touchedAlone.clear();
    trees.networkTouches.clear();
    trees.groupCount = 0;
    trees.touchedAlone.reserve(state.work.lonelyTrees.size());
    if (trees.list.empty()) return;
    trees.touched.assign(trees.list.size(), 0);
    if (state.work.lonelyTrees.empty() && state.work.lines.empty()) return;
    for (const auto* list : {&state.work.lonelyTrees, &state.work.lines})
        clearMultipliers(trees, *list);
    const auto& tied = state.work.tiedTrees;
    giveContacts(state);
    for (std::size_t k = 0; k < state.core.awakeMovers.size(); ++k) {
        if (state.core.movers.colours[state.core.awakeMovers[k]] == 0) continue;
        const auto i = state.core.awakeDense[k];
        const auto tree = state.core.awakeIsCluster[k] ? trees.ofCluster[i] : trees.ofParticle[i];
        if (tree != none) trees.touched[tree] = 1;
    }
    for (const Lead& lead : state.core.leads) {
        const BodyRecord& body = state.bodies[lead.body];
        for (auto p = body.firstParticle; p < body.firstParticle + body.particles.size(); ++p)
            pull(state, gripOf(state, p));
    }
    for (const Grab& grab : state.influences.grabs)
        for (std::uint32_t k = 0; k < grab.count; ++k)
            pull(state, gripOf(state, state.particleSlots.dense(grab.support[k])));
    for (const MechanismRow& row : state.mechanisms.rows)
        for (const TurnedMover& m : state.mechanisms.moversOf(row))
            pull(state, {m.particle, m.cluster});
    for (const auto i : tied) trees.touched[i] = Trees::pulled;
    for (const auto i : state.work.lonelyTrees) {
        const Tree& tree = trees.list[i];
        if (!trees.touched[i]) {
            for (auto l = tree.firstLink; l < tree.lastLink; ++l) trees.links[l].swept = {0, 0};
            continue;
        }
        trees.touchedAlone.push_back(i);
        withSweeper(state, i, [](auto&& s) { s.remember(); });
    }
    groupNetworks(state);
}

void shareBlows(State& state) {
    const ContactCore& core = state.core;
    if (core.blows.empty() || state.trees.touchedAlone.empty()) return;
    const Freedoms still = Freedoms::Zero();
    std::pmr::vector<Freedoms> ofParticle(state.particles.size(), still, &state.arena),
        ofCluster(state.clusters.list.size(), still, &state.arena);
    for (const Blow& blow : core.blows) {
        const auto i = core.denseOfMover[blow.mover];
        Freedoms& sum = core.moverIsCluster[blow.mover] != 0 ? ofCluster[i] : ofParticle[i];
        sum.head<2>() += blow.velocity.cast<double>();
        sum[2] += static_cast<double>(blow.spin);
    }
    std::pmr::vector<Freedoms> given(state.trees.nodes.size(), still, &state.arena);
    for (const auto tree : state.trees.touchedAlone) {
        bool any = false;
        for (auto k = state.trees.list[tree].first; k < state.trees.list[tree].last; ++k) {
            const TreeNode& n = state.trees.nodes[k];
            if (n.cluster != none)
                given[k] = ofCluster[n.cluster];
            else if (n.particle != none)
                given[k] = ofParticle[n.particle];
            any = any || !given[k].isZero(0);
        }
        const Tree& t = state.trees.list[tree];
        if (any)
            withSweeper(state, tree, [&](auto&& s) {
                s.share(std::span(given).subspan(t.first, t.last - t.first));
            });
    }
}

void answerOfTree(State& state, std::uint32_t tree, std::span<Freedoms> given) {
    withTreeSweeper(state, tree, [&](auto&& s) { s.answer(given); });
}

void answerLoadsOfTrees(State& state) {
    for (const auto i : state.trees.touchedAlone)
        if (state.trees.list[i].network == none)
            withTreeSweeper(state, i, [](auto&& s) { s.answerLoads(); });
}

void answerLoadsOfNetworks(State& state) {
    if (state.trees.networkTouches.empty()) return;
    state.core.stirred.assign(state.core.movers.size(), 0);
    state.core.sweep = 0;
    for (std::uint32_t group = 0; group < state.trees.groupCount; ++group)
        answerLoads(state, group);
}

void sweepTrees(State& state, int number) {
    const auto sweep = [&](std::uint32_t i) {
        withTreeSweeper(state, i, [](auto&& s) { s.sweep(); });
    };
    for (const auto i : state.work.lines) sweep(i);
    const Trees& trees = state.trees;
    const auto isWanted = [&](std::uint32_t i) {
        return number == 1 || trees.touched[i] == Trees::pulled ||
               isStirred(state, trees.list[i], number);
    };
    for (const auto i : trees.touchedAlone)
        if (trees.list[i].network == none && isWanted(i)) sweep(i);
    for (std::uint32_t group = 0; group < trees.groupCount; ++group) {
        const auto& members = trees.networkGroups[group].trees;
        if (std::any_of(members.begin(), members.end(), isWanted))
            sweepNetworks(state, group, number == 1);
    }
}

void holdNetworkRows(State& state) {
    auto& masses = state.trees.heldRows;
    masses.clear();
    for (const NetworkTouch& held : state.trees.networkTouches)
        masses.push_back(changeMasses(state, held.touch, {}));
}

void releaseNetworkRows(State& state) {
    for (std::size_t k = 0; k < state.trees.heldRows.size(); ++k)
        changeMasses(state, state.trees.networkTouches[k].touch, state.trees.heldRows[k]);
    state.trees.heldRows.clear();
}

namespace {

/// Touches of which a particle is moved by the tree.
std::pmr::vector<std::uint32_t> touchesOf(State& state, std::uint32_t tree) {
    std::pmr::vector<std::uint32_t> found(&state.arena);
    const auto& touches = state.core.touches;
    const auto isOfTree = [&](std::uint32_t p) {
        return state.trees.of(state.particles.cluster[p], p) == tree;
    };
    for (std::uint32_t i = 0; i < touches.size(); ++i) {
        if (touches[i].pair == none || !touches[i].row) continue;
        const auto particles = particlesOfTouch(state, i);
        if (std::any_of(particles.begin(), particles.end(), isOfTree)) found.push_back(i);
    }
    return found;
}

}  // namespace

void finishTrees(State& state, double strain) {
    Trees& trees = state.trees;
    for (std::uint32_t group = 0; group < trees.groupCount; ++group) finishNetworks(state, group);
    for (const auto i : trees.touchedAlone) {
        const Tree& tree = trees.list[i];
        if (tree.network != none) continue;
        if (strain <= tuned::brakingTolerable) continue;
        double own = 0;
        withTreeSweeper(state, i, [&](auto&& s) { own = s.strain(); });
        if (own <= tuned::brakingTolerable) continue;
        if (!brake(state, std::span(&i, 1), touchesOf(state, i), Brake::ifItGains)) continue;
        ++state.statistics.chainFallbacks;
        std::fill(trees.lambda.begin() + tree.first, trees.lambda.begin() + tree.last,
                  std::array<double, 2>{0, 0});
    }
}

double strainOfTrees(State& state) {
    double most = 0;
    const auto look = [&](std::uint32_t tree) {
        withSweeper(state, tree, [&](auto&& s) { most = std::max(most, s.strain()); });
    };
    for (const auto i : state.trees.touchedAlone) look(i);
    for (const auto i : state.work.lines)
        if (state.trees.touched[i]) look(i);
    return most;
}

void recordTreeForces(State& state) {
    const Trees& trees = state.trees;
    Joints& joints = state.joints;
    const auto record = [&](const Tree& tree) {
        if (tree.network != none) return recordNetworkForces(state, tree);
        for (auto k = tree.first + 1; k < tree.last; ++k) {
            const TreeNode& n = trees.nodes[k];
            if (n.kind != LinkKind::joint) {
                const Vec2 pushed(static_cast<Real>(trees.lambda[k][0]),
                                  static_cast<Real>(trees.lambda[k][1]));
                Vec2& force = forceOf(state, n);
                if (!tree.alone) force = Vec2(0, 0);
                force += Real(n.turned ? -1 : 1) * newtonsPerMultiplier(state) * pushed;
                continue;
            }
            const Real swept = static_cast<Real>(trees.lambda[k][0]);
            joints.lambda[n.link] = tree.alone ? joints.lambda[n.link] + swept : swept;
        }
    };
    for (const auto i : state.work.lines) record(trees.list[i]);
    for (const auto i : trees.touchedAlone) record(trees.list[i]);
}

void updateTreeVelocities(State& state) {
    const double h = static_cast<double>(state.h);
    for (const auto i : state.trees.touchedAlone) {
        const Tree& tree = state.trees.list[i];
        for (auto k = tree.first; k < tree.last; ++k) {
            const auto p = state.trees.nodes[k].particle;
            if (p == none || state.particles.inverseMass[p] == 0) continue;
            const Vec2 change = state.particles.displacement[p] - state.trees.predicted[k];
            state.particles.velocity[p] =
                limited(state.particles.velocity[p] + change.cast<double>() / h);
        }
    }
}

}  // namespace sulfur::detail
