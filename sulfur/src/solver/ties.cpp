// Which solver bodies constraints other than contacts hold: only these tell the state in each sweep
// what contacts have given them, and ask what the others have.
#include "contacts/touch_rows.hpp"
#include "model/state.hpp"
#include "solver/constraint_kinds.hpp"

namespace sulfur::detail {

namespace {

class Ties {
public:
    explicit Ties(State& state)
        : state_(state), core_(state.core), listed_(core_.movers.size(), false, &state.arena) {
        core_.tied.clear();
        core_.tied.reserve(core_.movers.size());
    }

    void addJoints() {
        for (const auto i : state_.work.sweptParticles) addParticle(i);
    }
    /// With what touches their links: such contacts are rows of the trees.
    void addTrees(const std::vector<std::uint32_t>& trees) {
        for (const auto t : trees) {
            const Tree& tree = state_.trees.list[t];
            for (auto k = tree.first; k < tree.last; ++k) {
                const TreeNode& node = state_.trees.nodes[k];
                if (node.cluster != none) add(moverOfCluster(state_, node.cluster));
                if (node.particle != none) addParticle(node.particle);
                const auto touch = state_.trees.contact[k];
                if (touch == none) continue;
                for (const auto m : moversOfTouch(state_, touch)) add(m);
            }
        }
    }
    void addNetworkTouches() {
        for (const NetworkTouch& held : state_.trees.networkTouches)
            for (const auto m : moversOfTouch(state_, held.touch)) add(m);
    }
    void addPoints() {
        for (const auto i : state_.work.attachments) {
            const Attachment& held = state_.attachments[i];
            addParticle(held.particle);
            for (std::uint32_t k = 0; k < held.count; ++k) addParticle(held.support[k]);
        }
        for (const auto i : state_.work.hinges) {
            add(moverOfCluster(state_, state_.clusters.hinges[i].cluster));
            addParticle(state_.clusters.hinges[i].particle);
        }
        for (const Grab& grab : state_.influences.grabs)
            for (std::uint32_t k = 0; k < grab.count; ++k)
                addParticle(state_.particleSlots.dense(grab.support[k]));
    }
    void addMechanisms() {
        for (const MechanismRow& row : state_.mechanisms.rows)
            for (const TurnedMover& m : state_.mechanisms.moversOf(row)) {
                if (m.cluster != none) add(moverOfCluster(state_, m.cluster));
                if (m.particle != none) addParticle(m.particle);
            }
    }
    void addTriangles() {
        for (const PressedTriangle& t : state_.triangles.pressed)
            for (const Grip& corner : t.corners) addParticle(corner.particle);
    }

private:
    void addParticle(std::uint32_t i) { add(moverOfParticle(state_, i)); }
    void add(std::uint32_t mover) {
        if (mover == none || listed_[mover] || core_.denseOfMover[mover] == none) return;
        listed_[mover] = true;
        core_.tied.push_back(mover);
    }

    State& state_;
    ContactCore& core_;
    std::pmr::vector<bool> listed_;  // by mover
};

}  // namespace

void listTiedToTrees(State& state) {
    Ties ties(state);
    ties.addTrees(state.trees.touchedAlone);
    ties.addNetworkTouches();
}

void listTied(State& state) {
    Ties ties(state);
    ties.addJoints();
    ties.addTrees(state.work.lines);
    ties.addTrees(state.trees.touchedAlone);
    ties.addNetworkTouches();
    ties.addPoints();
    ties.addMechanisms();
    ties.addTriangles();
}

}  // namespace sulfur::detail
