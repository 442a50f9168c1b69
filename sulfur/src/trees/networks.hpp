// Networks: nets, rings, frames and grids, whatever is tied together in loops.
//
// Unknown are the changes of the nodes' places and the multipliers lambda of the links:
//     M d - J^T lambda = -r,   J d + alpha lambda = -c,
// with the residual r of the nodes and the values c of the constraints. Eliminating lambda leaves
//     (M + G + J^T J / alpha) d = -r - J^T c / alpha,
// a sparse symmetric matrix with a block for each node, in which G is how pulls resist turning. It
// is positive definite whatever the constraints: what cannot hold is solved by least squares. What
// is rigid has a compliance alpha of a ten-millionth of what its ends answer a push with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Place (x, y) and angle of a node.
using Freedoms = Eigen::Vector3d;

/// A row without the freedoms that a node of these inverse masses has not.
inline Freedoms ofMovable(Freedoms row, const Freedoms& inverseMass) {
    for (int k = 0; k < 3; ++k)
        if (inverseMass[k] == 0) row[k] = 0;
    return row;
}
/// 1/kg and 1/(kg m^2); zero where the node cannot move.
Freedoms inverseMassOf(const State& state, const TreeNode& node);
/// Finds the pattern of a network. Returns whether a factorisation has a bounded price: else it is
/// better swept.
bool analyseNetwork(State& state, const Tree& tree);
/// Patterns of all networks of a world that was restored.
void prepareNetworks(State& state);

void factoriseNetwork(State& state, const Tree& tree, std::span<const NetworkRow> rows,
                      NetworkSystem& system);
/// One correction with what has been factorised of these rows: `nodes` holds r and becomes d,
/// `values` holds c of the links and becomes the change of lambda.
void correctNetwork(State& state, const Tree& tree, std::span<const NetworkRow> rows,
                    NetworkSystem& system, std::vector<Freedoms>& nodes,
                    std::vector<std::array<double, 2>>& values);
/// Adds how what has been factorised moves along each row by a push of one along another, 1/kg:
/// those of one push after those of another.
void addAnswersOfNetwork(State& state, const Tree& tree, NetworkSystem& system,
                         std::span<const PressedRow> pressed, std::span<double> answers);
/// The rows and the factors of the step, which a restored world has to make again.
std::span<const NetworkRow> stepRows(State& state, const Tree& tree);
NetworkSystem& stepSystem(State& state, const Tree& tree);

/// Whether factors are better renewed, which costs as much as some passes do, than kept: whether
/// the error `worst` is still above the tolerance after these, if they go on as the `last` has.
bool isSlow(double worst, double last, double tolerance);

/// Leads a network through the tick.
void stepNetwork(State& state, Tree& tree);

/// A network in the sweeps, as TreeSweeper is a tree.
class NetworkSweeper {
public:
    NetworkSweeper(State& state, std::uint32_t tree)
        : state_(state), tree_(state.trees.list[tree]) {}
    void remember();
    void share(std::span<const Freedoms> given);
    double strain();

private:
    State& state_;
    const Tree& tree_;
};

/// A group of networks answers what contacts begin with.
void answerLoads(State& state, std::uint32_t group);
void sweepNetworks(State& state, std::uint32_t group, bool first);
/// Sweeps once more what has waited.
void finishNetworks(State& state, std::uint32_t group);

/// Products of blocks that a factorisation of a network takes, with its passes.
std::uint64_t priceOf(const State& state, const Tree& tree);
/// How many a step may take.
std::uint64_t productsOfStep(const Tree& tree);

/// The force of an attachment or hinge, N on its first end.
inline Vec2& forceOf(State& state, const NetworkLink& link) {
    return link.kind == LinkKind::hinge ? state.clusters.hinges[link.link].force
                                        : state.attachments[link.link].force;
}
/// Multipliers of the sweeps to the links.
void recordNetworkForces(State& state, const Tree& tree);

}  // namespace sulfur::detail
