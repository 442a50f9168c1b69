// Ready-made blueprints. Sizes are outer sizes: the thickness of the collision capsules is
// included. Every function throws Error when a number is not finite or not in its range.
#pragma once

#include <string>
#include <sulfur/blueprint.hpp>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur::shapes {

/// A fixed line of capsules through `points` (at least two), such as ground, a wall or a ceiling.
struct GroundOptions {
    std::vector<Vec2> points = {};
    bool closed = false;       ///< also joins the last point to the first
    Real radius = Real(0.05);  ///< metres, > 0: half the thickness
    Material material = {};
};
Blueprint ground(const GroundOptions& options);

/// A fixed straight floor from `from` to `to`.
Blueprint floor(Vec2 from, Vec2 to, Real radius = Real(0.05));

/// A rectangle of four corner particles, four outer capsules and two diagonals.
///
/// With `solidInertia` a fifth particle in the middle carries what the corners may not: a third
/// of the mass in the corners and two thirds in the middle have the moment of inertia of a solid
/// rectangle about its centre, m (w^2 + h^2) / 12, where w and h are the outer size.
/// Without it the corners carry all (the paper's box of Table 4, three times the inertia).
struct BoxOptions {
    Vec2 size{1, 1};            ///< metres, both more than 2 radius
    Real mass = 1;              ///< kilograms, > 0
    Real radius = Real(0.02);   ///< metres, > 0
    Real stiffness = infinite;  ///< N/m of every joint
    Real damping = 0;           ///< N s/m of every joint
    Real strength = infinite;   ///< N of every joint
    bool solidInertia = true;
    Material material = {};
};
Blueprint box(const BoxOptions& options = {});

/// One particle with a radius.
struct BallOptions {
    Real radius = Real(0.25);  ///< metres, > 0
    Real mass = 1;             ///< kilograms, > 0
    Material material = {};
};
Blueprint ball(const BallOptions& options = {});

/// A line of equal links. The first particle is at `from`, the last at `to`.
struct RopeOptions {
    Vec2 from{0, 0};
    Vec2 to{0, -2};
    int links = 0;              ///< 1 to 100000; 0: as many as make links of about 5 cm
    Real mass = Real(0.5);      ///< kilograms in all, > 0
    Real radius = Real(0.015);  ///< metres; 0: the rope touches nothing
    Real stiffness = infinite;  ///< N/m of a link
    Real damping = 0;           ///< N s/m of a link
    Real strength = infinite;   ///< N of a link
    bool pinFirst = false;
    bool pinLast = false;
    Material material = {};
};
Blueprint rope(const RopeOptions& options = {});

/// A rectangular lattice of particles with structural and diagonal springs and a collision
/// outline.
struct JellyOptions {
    Vec2 size{1, 1};           ///< metres, both more than 2 radius
    int columns = 4;           ///< particles across, 2 to 1000
    int rows = 4;              ///< particles up, 2 to 1000
    Real mass = 1;             ///< kilograms in all, > 0
    Real radius = Real(0.03);  ///< metres, > 0: half the thickness of the outline
    Real stiffness = 400;      ///< N/m of a spring
    Real damping = 1;          ///< N s/m of a spring
    Real strength = infinite;  ///< N of a spring
    Material material = {};
};
Blueprint jelly(const JellyOptions& options = {});

/// A round soft body: a ring of particles around a hub, with spokes and skipping braces.
struct BlobOptions {
    Real radius = Real(0.5);       ///< metres, outer, more than 2 skinRadius
    int segments = 12;             ///< particles on the ring, 3 to 1000
    Real mass = 1;                 ///< kilograms in all, > 0
    Real skinRadius = Real(0.03);  ///< metres, > 0: half the thickness of the outline
    Real stiffness = 800;          ///< N/m of a spring
    Real damping = 2;              ///< N s/m of a spring
    Material material = {};
};
Blueprint blob(const BlobOptions& options = {});

}  // namespace sulfur::shapes
