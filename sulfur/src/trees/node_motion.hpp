// How the nodes of trees and networks enter and leave steps of their own.
#pragma once

#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// Masses, loads and motion of a node when the tick begins.
void loadNode(const State& state, const TreeNode& node, StepScratch::Node& data);
/// For how long, s, loads act on velocities when a step begins. These stand in the middle of steps,
/// so that gravity acts from the middle of the step before. Forces act for as long as on what is in
/// no tree, whatever the steps: springs give them to both sides.
struct NodeKick {
    double forces = 0, gravity = 0;
};
/// Of the first step of a tree in a tick.
NodeKick firstKick(const State& state, const Tree& tree, double step);
/// Velocities and displacements of a step before its constraints.
void predictNodes(const State& state, const std::vector<StepScratch::Node>& nodes, NodeKick kick,
                  double step, std::vector<StepScratch::Motion>& motion);
/// Places and velocities at the end of a step.
void moveNode(const StepScratch::Node& data, double step, StepScratch::Motion& motion);
bool allFinite(const std::vector<StepScratch::Motion>& motion);
/// To the state, for a tick; returns how far the node has moved.
Vec2 storeNode(State& state, const TreeNode& node, const StepScratch::Node& data,
               const StepScratch::Motion& motion);

}  // namespace sulfur::detail
