// What is near: the boxes of the broad phase, and what these do not hold as it is.
//
// Queries never change how the world goes on: they read the boxes that the last step left. Bodies
// that were made or changed by hand since, and the few that went farther than their boxes, are
// looked through one by one.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "model/state.hpp"
#include "shape/bends.hpp"

namespace sulfur::detail {

/// A thick segment between two particles; a disc when both are the same particle. Of an arc, a
/// chord of it.
struct Collider {
    std::uint32_t a = none, b = none;  // particles, dense indices
    std::uint32_t body = none;         // dense index; of a joint between bodies, one of them
    std::uint32_t joint = none;        // dense index, or none for a disc
    Real radius = 0;                   // m
    Point from{0, 0}, to{0, 0};        // m
    double begin = 0, end = 1;         // which part of the way from a to b that is

    friend bool operator==(const Collider&, const Collider&) = default;
};

/// Calls f(collider) for what a joint or a disc is.
template <class Function>
void forEachPiece(const State& state, Collider c, Function&& f) {
    c.from = state.particles.position[c.a];
    c.to = state.particles.position[c.b];
    if (c.joint == none) return f(c);
    forEachPieceOf(state, c.joint, c.from, c.to,
                   [&](const Point& from, const Point& to, double begin, double end) {
                       c.from = from;
                       c.to = to;
                       c.begin = begin;
                       c.end = end;
                       f(c);
                   });
}

/// Makes what is derived of the boxes fit the present world. Complexity: nothing where no tick and
/// no change has come since the last call; otherwise linear in bodies and awake chunks. Throws
/// while the caller is being asked: boxes are then on their way.
void prepareNearby(State& state);

/// The bodies, ascending by dense index, whose outlines enclose a point, until the next call. Needs
/// prepareNearby().
/// Complexity: linear in bodies whose outline is not convex and rigid, besides those near.
const std::vector<std::uint32_t>& bodiesAround(State& state, const Point& point);
/// Whether the outlines of a body wind round `point`, with its particles where they are now
/// (nonzero rule; Sunday 2001, without divisions). What is exactly on an outline belongs to one of
/// its sides. Complexity: linear in its colliders.
bool encloses(const State& state, std::uint32_t body, const Point& point);

/// Calls f(collider) for all of a body.
template <class Function>
void forEachColliderOf(const State& state, std::uint32_t index, Function&& f) {
    const BodyRecord& body = state.bodies[index];
    const Joints& joints = state.joints;
    for (const JointId id : body.joints) {
        const auto j = state.jointSlots.dense(id);
        if (joints.radius[j] > 0)
            forEachPiece(state, {joints.a[j], joints.b[j], index, j, joints.radius[j]}, f);
    }
    for (std::uint32_t k = 0; k < body.particles.size(); ++k) {
        const auto i = body.firstParticle + k;
        if (state.particles.radius[i] > 0)
            forEachPiece(state, {i, i, index, none, state.particles.radius[i]}, f);
    }
}

/// Calls f(collider) for all of bodies that are apart.
template <class Function>
void forEachColliderApart(const State& state, Function&& f) {
    const Joints& joints = state.joints;
    for (const auto body : state.nearby.apart) forEachColliderOf(state, body, f);
    for (const auto j : state.nearby.tied) {
        const auto body = state.particles.body[joints.a[j]];
        forEachPiece(state, {joints.a[j], joints.b[j], body, j, joints.radius[j]}, f);
    }
}

/// Calls f(collider) for those that a chunk of a body stands for. The sides of convex ones are
/// fewer than their colliders, which are all of the body's then.
template <class Function>
void forEachColliderOf(const State& state, const Chunk& chunk, Function&& f) {
    const auto index = state.bodySlots.denseOf(chunk.body);
    if (chunk.kind == ChunkKind::convex) return forEachColliderOf(state, index, f);
    const Shapes& shapes = state.core.shapes;
    const auto particle = [&](std::uint32_t corner) {
        return state.particleSlots.denseOf(shapes.corners[corner].particle);
    };
    for (auto s = chunk.firstSide; s < chunk.firstSide + chunk.sides; ++s) {
        const Side& side = shapes.sides[s];
        forEachPiece(
            state,
            {particle(side.a), particle(side.b), index,
             side.joint == none ? none : state.jointSlots.denseOf(side.joint), side.radius},
            f);
    }
}

/// Calls f(collider) for all that may meet a box, some of them repeatedly. Needs prepareNearby().
template <class Function>
void forEachColliderIn(const State& state, const Point& low, const Point& high, Function&& f) {
    const ContactCore& core = state.core;
    core.grid.forEachIn(core.shapes.chunks, {low[0], low[1]}, {high[0], high[1]},
                        [&](std::uint32_t c) {
                            const Chunk& chunk = core.shapes.chunks[c];
                            if (!state.nearby.isApart[chunk.body])
                                forEachColliderOf(state, chunk, f);
                        });
    forEachColliderApart(state, f);
}

/// The same for all that may meet a disc on a straight way. f returns the fraction of the way
/// beyond which nothing interests any more.
template <class Function>
void forEachColliderAlong(const State& state, const Point& from, const Point& way, double radius,
                          Function&& f) {
    const ContactCore& core = state.core;
    double enough = 1;
    const auto ask = [&](const Collider& collider) { enough = std::min(enough, f(collider)); };
    forEachColliderApart(state, ask);
    core.grid.forEachAlong(core.shapes.chunks, from, way, radius, enough, [&](std::uint32_t c) {
        const Chunk& chunk = core.shapes.chunks[c];
        if (!state.nearby.isApart[chunk.body]) forEachColliderOf(state, chunk, ask);
    });
}

}  // namespace sulfur::detail
