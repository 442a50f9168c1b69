// Which solver bodies constraints other than contacts hold: only these tell the state in each sweep
// what contacts have given them, and ask what the others have.
#include "contacts/touch_rows.hpp"
#include "model/state.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

class Ties {
public:
    explicit Ties(State& state) : state_(state), core_(state.core) {
        core_.tied.clear();
        core_.isTied.assign(core_.movers.size(), 0);
    }

    void addMover(std::uint32_t m) {
        if (m == none || core_.isTied[m] != 0 || core_.denseOfMover[m] == none) return;
        core_.isTied[m] = 1;
        core_.tied.push_back(m);
    }
    void addCluster(std::uint32_t cluster) {
        const Clusters& clusters = state_.clusters;
        addAlone(clusters.members[clusters.list[cluster].first]);
    }
    void addParticle(std::uint32_t i) {
        const auto cluster = state_.particles.cluster[i];
        cluster == none ? addAlone(i) : addCluster(cluster);
    }

    /// With what touches their links: such contacts are rows of the trees.
    void addTrees(const std::vector<std::uint32_t>& trees) {
        for (const auto t : trees) {
            const Tree& tree = state_.trees.list[t];
            for (auto k = tree.first; k < tree.last; ++k) {
                const TreeNode& node = state_.trees.nodes[k];
                if (node.cluster != none) addCluster(node.cluster);
                if (node.particle != none) addParticle(node.particle);
                const auto touch = state_.trees.contact[k];
                if (touch == none) continue;
                for (const auto m : moversOfTouch(state_, touch)) addMover(m);
            }
        }
    }
    void addPoints() {
        for (const auto i : state_.work.attachments) {
            const Attachment& held = state_.attachments[i];
            addParticle(held.particle);
            for (std::uint32_t k = 0; k < held.count; ++k) addParticle(held.support[k]);
        }
        for (const auto i : state_.work.hinges) {
            addCluster(state_.clusters.hinges[i].cluster);
            addParticle(state_.clusters.hinges[i].particle);
        }
        for (const Grab& grab : state_.influences.grabs)
            for (std::uint32_t k = 0; k < grab.count; ++k)
                addParticle(state_.particleSlots.dense(grab.support[k]));
    }
    void addTriangles() {
        for (const PressedTriangle& t : state_.triangles.pressed)
            for (const Grip& corner : t.corners)
                corner.cluster == none ? addAlone(corner.particle) : addCluster(corner.cluster);
    }

private:
    /// A particle that moves by itself, or the first one of a rigid component.
    void addAlone(std::uint32_t i) {
        const auto slot = state_.particles.id[i].index - 1;
        const auto& movers = core_.shapes.moverOfParticle;
        if (slot < movers.size()) addMover(movers[slot]);
    }

    State& state_;
    ContactCore& core_;
};

}  // namespace

void listTied(State& state) {
    Ties ties(state);
    for (const auto i : state.work.sweptParticles) ties.addParticle(i);
    if (!state.trees.list.empty()) {
        ties.addTrees(state.work.lines);
        ties.addTrees(state.trees.touchedAlone);
    }
    ties.addPoints();
    ties.addTriangles();
}

}  // namespace sulfur::detail
