#include "trees/chain_batches.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "core/limits.hpp"
#include "model/state.hpp"
#include "trees/step_judgement.hpp"

namespace sulfur::detail {

namespace {

std::uint32_t nodesOf(const State& state, std::uint32_t tree) {
    return state.trees.list[tree].last - state.trees.list[tree].first;
}

bool isChainOfRigidLinks(const State& state, std::uint32_t index) {
    const Tree& tree = state.trees.list[index];
    if (!tree.chain || tree.last - tree.first < 2) return false;
    const auto first = state.trees.nodes.begin() + tree.first + 1;
    const auto last = state.trees.nodes.begin() + tree.last;
    return std::all_of(first, last, [&](const TreeNode& n) {
        return state.joints.kind[n.link] == JointKind::rigid;
    });
}

/// Whether a particle never leaves its place: its displacement is zero in every tick.
bool isHeld(const State& state, std::uint32_t particle) {
    return state.particles.inverseMass[particle] == 0 &&
           state.bodies[state.particles.body[particle]].kind != BodyKind::kinematic;
}

/// A batch of the chains [first, first + count).
void addBatch(State& state, const std::uint32_t* first, std::size_t count) {
    ChainBatches& batches = state.work.chains;
    LanesOfChains batch;
    batch.nodes = nodesOf(state, *first);
    batch.lanes = static_cast<std::uint32_t>(count);
    batch.indices = static_cast<std::uint32_t>(batches.particles.size());
    for (std::size_t k = 0; k < chainLanes; ++k) {
        batch.trees[k] = first[k < count ? k : 0];
        batch.firsts[k] = state.trees.list[batch.trees[k]].first;
        batch.heldRoot &= isHeld(state, state.trees.nodes[batch.firsts[k]].particle);
    }
    for (std::uint32_t i = 0; i < batch.nodes; ++i)
        for (const auto tree : batch.trees) {
            const TreeNode& node = state.trees.nodes[state.trees.list[tree].first + i];
            const auto rest = i == 0 ? 1 : static_cast<double>(state.joints.restLength[node.link]);
            const auto w = static_cast<double>(state.particles.inverseMass[node.particle]);
            batches.particles.push_back(node.particle);
            batches.joints.push_back(node.link);
            batches.inverseMass.push_back(w);
            batches.rest.push_back(rest);
            batches.share.push_back(shareOf(rest));
        }
    batches.list.push_back(batch);
}

ChainView viewOf(State& state) {
    Particles& p = state.particles;
    Joints& j = state.joints;
    return {p.position.data()->data(),
            p.velocity.data()->data(),
            p.force.data()->data(),
            p.displacement.data()->data(),
            j.force.data(),
            j.lambda.data(),
            state.trees.predicted.data()->data()};
}

ChainRules rulesOf(const State& state) {
    const Point gravity = state.settings.gravity.cast<double>();
    return {.gravityX = gravity[0],
            .gravityY = gravity[1],
            .airFriction = static_cast<double>(state.settings.airFriction),
            .tick = static_cast<double>(state.h),
            .late = (state.lastStep - static_cast<double>(state.h)) / 2,
            .maxSpeed = maxSpeed,
            .maxForce = maxForce,
            .closingSpeed = closingSpeed,
            .smallStretch = smallStretch,
            .tolerance = treeTolerance,
            .worthwhile = worthwhile,
            .redundant = redundantPivot,
            .mostPasses = mostChainPasses,
            .mostFactored = mostChainFactors,
            .mostWhip = mostWhip,
            .mostTurn = mostTurn,
            .calmWhip = calmWhip,
            .calmTurn = calmTurn};
}

class BatchStepper {
public:
    BatchStepper(State& state, std::pmr::vector<std::uint32_t>& left)
        : state_(state), left_(left), view_(viewOf(state)), rules_(rulesOf(state)) {}

    void run() {
        for (const LanesOfChains& batch : state_.work.chains.list) step(batch);
    }

private:
    Tree& tree(const LanesOfChains& batch, std::size_t lane) const {
        return state_.trees.list[batch.trees[lane]];
    }

    void step(const LanesOfChains& lanes) {
        const ChainBatches& all = state_.work.chains;
        ChainBatch batch;
        batch.nodes = lanes.nodes;
        batch.particles = all.particles.data() + lanes.indices;
        batch.joints = all.joints.data() + lanes.indices;
        batch.inverseMass = all.inverseMass.data() + lanes.indices;
        batch.rest = all.rest.data() + lanes.indices;
        batch.share = all.share.data() + lanes.indices;
        batch.firsts = lanes.firsts.data();
        batch.heldRoot = lanes.heldRoot;
        // Those that need as many steps go together.
        for (std::uint32_t waiting = inLanes(lanes); waiting != 0;) {
            batch.steps = tree(lanes, static_cast<std::size_t>(std::countr_zero(waiting))).steps;
            batch.lanes = 0;
            for (std::size_t k = 0; k < chainLanes; ++k) {
                const Tree& chain = tree(lanes, k);
                batch.lastStep[k] = chain.lastStep;
                if (chain.steps == batch.steps) batch.lanes |= waiting & 1u << k;
            }
            waiting &= ~batch.lanes;
            stepTogether(lanes, batch);
        }
    }

    /// Lanes of chains on which the world's gravity acts; the others go alone.
    std::uint32_t inLanes(const LanesOfChains& lanes) {
        std::uint32_t all = (1u << lanes.lanes) - 1;
        if (!state_.gravityScaled) return all;
        for (std::uint32_t k = 0; k < lanes.lanes; ++k) {
            const Tree& chain = tree(lanes, k);
            const auto isScaled = [&](std::uint32_t node) {
                const auto p = state_.trees.nodes[node].particle;
                return state_.bodies[state_.particles.body[p]].gravityScale != 1;
            };
            bool any = false;
            for (auto node = chain.first; node < chain.last; ++node) any |= isScaled(node);
            if (!any) continue;
            left_.push_back(lanes.trees[k]);
            all &= ~(1u << k);
        }
        return all;
    }

    /// One chain is as fast by itself; and the shortest steps are judged more mildly.
    void stepTogether(const LanesOfChains& lanes, const ChainBatch& batch) {
        ChainOutcome outcome{0, 0};
        const double step = rules_.tick / batch.steps;
        if ((batch.lanes & (batch.lanes - 1)) != 0 && batch.steps < mostSteps)
            outcome = kernels_.step(view_, rules_, batch, state_.work.chains.scratch.data());
        for (std::uint32_t k = 0; k < lanes.lanes; ++k) {
            if ((batch.lanes >> k & 1u) == 0) continue;
            if ((outcome.done >> k & 1u) == 0) {
                left_.push_back(lanes.trees[k]);
                continue;
            }
            state_.statistics.chainSteps += batch.steps;
            ++state_.statistics.chainsInLanes;
            Tree& chain = tree(lanes, k);
            chain.lastStep = step;
            if ((outcome.calm >> k & 1u) != 0 && batch.steps > 1) chain.steps /= 2;
        }
    }

    State& state_;
    std::pmr::vector<std::uint32_t>& left_;
    const ChainKernels& kernels_ = chainKernels();
    const ChainView view_;
    const ChainRules rules_;
};

}  // namespace

void listChainBatches(State& state) {
    ChainBatches& batches = state.work.chains;
    batches.list.clear();
    batches.particles.clear();
    batches.joints.clear();
    batches.inverseMass.clear();
    batches.rest.clear();
    batches.share.clear();
    batches.others.clear();
    batches.others.reserve(state.work.lonelyTrees.size());
    std::pmr::vector<std::uint32_t> chains(&state.arena);
    chains.reserve(state.work.lonelyTrees.size());
    for (const auto tree : state.work.lonelyTrees)
        if (isChainOfRigidLinks(state, tree))
            chains.push_back(tree);
        else
            batches.others.push_back(tree);
    std::sort(chains.begin(), chains.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(nodesOf(state, a), a) < std::pair(nodesOf(state, b), b);
    });
    for (std::size_t first = 0; first < chains.size();) {
        const auto nodes = nodesOf(state, chains[first]);
        std::size_t count = 1;
        while (count < chainLanes && first + count < chains.size() &&
               nodesOf(state, chains[first + count]) == nodes)
            ++count;
        if (count > 1)
            addBatch(state, &chains[first], count);
        else
            batches.others.push_back(chains[first]);
        first += count;
    }
    // The last ones are the longest. What falls out of its lane goes by itself.
    if (!batches.list.empty() && batches.scratch.size() < batches.list.back().nodes)
        batches.scratch.resize(batches.list.back().nodes);
    if (!chains.empty()) state.trees.scratch.chain.reserve(nodesOf(state, chains.back()));
    std::sort(batches.others.begin(), batches.others.end());
}

void stepChainBatches(State& state, std::pmr::vector<std::uint32_t>& left) {
    if (state.work.chains.list.empty()) return;
    BatchStepper(state, left).run();
}

}  // namespace sulfur::detail
