// Chains and trees of stiff joints, which are solved directly.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "core/slots.hpp"
#include "model/networks.hpp"
#include "model/tree_links.hpp"
#include "model/tree_scratch.hpp"

namespace sulfur::detail {

/// A node, and its link to its parent. Nodes stand in breadth-first order from the root, so that
/// going backwards every child comes before its parent. What cannot move (a pinned particle, a
/// kinematic body) is a leaf of its own for each of its links.
struct TreeNode {
    std::uint32_t particle = none;  // exactly one of the two
    std::uint32_t cluster = none;
    std::uint32_t parent = none;  // node, counted from the tree's first; the root has none
    LinkKind kind = LinkKind::joint;
    std::uint32_t link = none;  // index of the joint, attachment or hinge
    std::uint8_t turned = 0;    // this node is the second end of an attachment or hinge
    LinkEnd here, there;        // at this node and at the parent

    template <class Archive>
    void archive(Archive& a) {
        a(particle);
        a(cluster);
        a(parent);
        a(kind);
        a(link);
        a(turned);
        a(here);
        a(there);
    }
};

struct Tree {
    std::uint32_t first = 0, last = 0;  // nodes
    /// Nothing else that is stiff connects its nodes, so it moves by itself, in steps of its own.
    /// Otherwise it is a line through a mesh, solved as a whole in every sweep.
    std::uint8_t alone = 1;
    std::uint8_t points = 1;  // no clusters: two freedoms a node are enough
    std::uint8_t chain = 1;   // moves alone, of points and joints only, each held by the one before
    std::uint8_t tied = 0;    // swept constraints pull on it
    std::uint32_t steps = 1;  // in the next tick, a power of two
    double lastStep = 0;      // s, duration of its last step
    /// Of a network, which has cycles: its factorisation and its links. Its nodes have no parents.
    std::uint32_t network = none;
    std::uint32_t firstLink = 0, lastLink = 0;
    /// s, of the step for which it was factorised; 0: not yet.
    double factorStep = 0;
    static constexpr double stale = -1;  // it has been, but is to be renewed

    template <class Archive>
    void archive(Archive& a) {
        a(first);
        a(last);
        a(alone);
        a(points);
        a(chain);
        a(tied);
        a(steps);
        a(lastStep);
        a(network);
        a(firstLink);
        a(lastLink);
        a(factorStep);
    }
};

/// The trees of a world; and, for each node of those that move alone, where the tick would lead it
/// without contacts.
struct Trees {
    std::vector<Tree> list;
    std::vector<TreeNode> nodes;
    std::vector<std::uint32_t> ofParticle, ofCluster;  // the tree that moves it, or none
    std::vector<NetworkLink> links;
    std::vector<NetworkRow> rows;  // of each of these
    std::vector<NetworkFactor> factors;
    std::vector<NetworkFactor> earlier;  // of networks that are about to be found anew

    // Of the present tick only.
    std::vector<Vec2> predicted;                // m, displacement of each node
    std::vector<std::array<double, 2>> met;     // m, between a link's ends after the prediction
    std::vector<std::array<double, 2>> lambda;  // kg m, multipliers of the sweeps
    /// Of the links of networks: m, constraint values after the prediction; kg m, multipliers.
    std::vector<std::array<double, 2>> linkMet, linkLambda;
    /// Tree: 0, 1: contacts push on it, 2: something else that is swept, a grab or a lead does.
    std::vector<std::uint8_t> touched;
    static constexpr std::uint8_t pulled = 2;
    std::vector<std::uint32_t> touchedAlone;  // those that move alone, in order
    /// Of each node that a joint holds: the contact that pushes most on it, or on that joint.
    std::vector<std::uint32_t> contact;
    std::vector<std::uint32_t> nodeOfParticle;  // of trees as they are; empty: not yet listed
    std::vector<NetworkTouch> networkTouches;  // by groups
    std::vector<TouchMasses> heldRows;         // of these, while only networks solve them
    std::vector<NetworkGroup> networkGroups;   // of this step, and what later steps use again
    std::uint32_t groupCount = 0;
    std::vector<std::uint32_t> groupOf;  // of a tree, or none
    NetworkSweep networkSweep;
    TreeScratch scratch;

    /// The tree that moves a rigid component, or else a particle, or none.
    std::uint32_t of(std::uint32_t cluster, std::uint32_t particle) const {
        return cluster != none ? ofCluster[cluster] : ofParticle[particle];
    }

    void clear() {
        list.clear();
        nodes.clear();
        links.clear();
        rows.clear();
        nodeOfParticle.clear();
        if (!factors.empty()) earlier.swap(factors);  // allocates nothing
        factors.clear();
    }

    template <class Archive>
    void archive(Archive& a) {
        a(list);
        a(nodes);
        a(ofParticle);
        a(ofCluster);
        a(links);
        a(rows);
    }
};

}  // namespace sulfur::detail
