// How trees of stiff joints move: by themselves in steps of their own, and against contacts.
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/limits.hpp"
#include "core/settings.hpp"
#include "model/state.hpp"

namespace sulfur::detail {

/// Finds the trees among the stiff joints, attachments and hinges, and lists what remains for the
/// sweeps. Called when the structure of the world has changed.
void buildTrees(State& state);

/// Leads every tree that moves alone through the tick, in as many steps as it needs (SHAKE
/// directions, Newton passes to treeTolerance). Sets velocity and
/// displacement of its particles and clusters.
void stepTrees(State& state);

/// Gives each node of a tree the contact that pushes most on it or its link (Trees::contact).
void giveContacts(State& state);
/// Groups of the networks that touch each other. Of their contacts, those that press most are
/// theirs.
void groupNetworks(State& state);
/// Before the sweeps: finds the trees that contacts or swept constraints pull on.
void touchTrees(State& state);
/// What impacts have given to single nodes of the touched trees is shared along their links at
/// once: how fast these grow does not change.
void shareBlows(State& state);
/// `given`: displacement and angle of each node of a tree that has no cycles and is touched. Of
/// that becomes what its rigid links leave.
void answerOfTree(State& state, std::uint32_t tree, std::span<Eigen::Vector3d> given);
/// Before the first sweep over rows: trees answer what these begin with, networks afterwards what
/// they have given. Else rows, which see nodes as free, would take nearly all of it back, and find
/// it anew in every step: a light rope would creep over what holds it by friction.
void answerLoadsOfTrees(State& state);
void answerLoadsOfNetworks(State& state);
/// One sweep: every line through a mesh is solved as a whole, and every touched tree that the
/// `number`-th sweep over rows has stirred; the first one solves all.
void sweepTrees(State& state, int number);
/// In between, rows that networks solve as their own are left alone by the sweeps over rows.
void holdNetworkRows(State& state);
void releaseNetworkRows(State& state);
/// Networks for whose sweeps there was no work left get the last one. What the sweeps have not
/// solved, a network that is crumpled or pressed beyond what it can bear, and a tree that is
/// strained and has gained energy by it, is braked. `strain`: the largest of trees.
void finishTrees(State& state, double strain);
/// When trees or networks are braked: always, or if they and what presses on them move with more
/// energy than before the sweeps.
enum class Brake : std::uint8_t { always, ifItGains };
/// Their nodes and what presses on them go on as one, with their momentum: no link is strained and
/// nothing comes nearer. What pressed is forgotten. `touches`: all of it. Returns whether they do.
bool brake(State& state, std::span<const std::uint32_t> trees,
           std::span<const std::uint32_t> touches, Brake when);
/// By what share of its length a link is wrong, at most, in trees that contacts pull on.
double strainOfTrees(State& state);
/// Multipliers of the sweeps to the joints.
void recordTreeForces(State& state);
/// Velocities of the nodes take up what the sweeps have changed.
void updateTreeVelocities(State& state);

/// Velocities of trees that are about to be found anew: back to the middle of a whole tick.
void dissolveTrees(State& state);

/// The force of an attachment or hinge, N on its first end.
inline Vec2& forceOf(State& state, const TreeNode& node) {
    return node.kind == LinkKind::hinge ? state.clusters.hinges[node.link].force
                                        : state.attachments[node.link].force;
}

/// kg m, that a contact of a tree or network may press with: what takes part brings no more
/// momentum. `mass`: kg, of all of it; `closing`: m, the most that is to be closed.
inline double mostPressing(const State& state, double mass, double closing) {
    const double h = static_cast<double>(state.h);
    const double falls = h * h * static_cast<double>(state.settings.gravity.norm());
    return tuned::contactLeverage * mass * (closing + falls);
}

/// m/s, at which comes together what the caller has torn apart there.
inline double closingSpeedOf(LinkKind kind) {
    return kind == LinkKind::attachment ? attachingSpeed : closingSpeed;
}

/// Duration of the last step (s) that moved this particle.
double lastStepOf(const State& state, std::uint32_t particle);

}  // namespace sulfur::detail
