/// \file
/// Ready-made blueprints.
///
/// Sizes are outer sizes: the thickness of the collision capsules is included. A body that stands
/// for a solid (box, polygon, blob, wheel, jelly, cloth, wall) has the mass, the centre of mass
/// and the moment of inertia of the uniform solid of that outer size, with sharp corners, within
/// the rounding of Real; the capsules round its corners by their radius. Only a box without
/// `solidInertia` differs, and what is `rounded`: its solid has round corners too. Where capsules
/// are so thick that no distribution of the mass among the particles has that inertia, the shape is
/// refused.
///
/// Every function throws Error when a number is not finite or not in its range.
#pragma once

#include <optional>
#include <string>
#include <sulfur/blueprint.hpp>
#include <sulfur/math.hpp>
#include <vector>

/// Ready-made blueprints.
namespace sulfur::shapes {

/// A fixed line of capsules through `points` (at least two), such as ground, a wall or a ceiling.
struct GroundOptions {
    std::vector<Vec2> points = {};  ///< metres; the axes of the capsules
    bool closed = false;            ///< also joins the last point to the first
    Real radius = Real(0.05);       ///< metres, > 0: half the thickness
    Material material = {};         ///< of the surface
    /// Radians: by how much each capsule, from one point to the next, turns on its way, as
    /// JointSpec::bend. None: all are straight; else one for each capsule. Where tangents go on in
    /// one line what rolls meets no bump.
    std::vector<Real> bends = {};
};
/// Makes a fixed line; see GroundOptions.
Blueprint ground(const GroundOptions& options);

/// A fixed straight floor from `from` to `to`, metres; `radius` > 0 is half its thickness.
Blueprint floor(Vec2 from, Vec2 to, Real radius = Real(0.05));

/// A rectangle of four corner particles, four outer capsules and two diagonals. The corners are
/// particles 0 to 3, anticlockwise from the lower left: lower left, lower right, upper right, upper
/// left, each by the radius of the capsules further inside than the outline. Joints 0 to 3 are the
/// sides from these corners to the next ones.
///
/// With `solidInertia` a fifth particle in the middle carries what the corners may not: about a
/// third of the mass in the corners and two thirds in the middle have the moment of inertia of a
/// solid rectangle about its centre, m (w^2 + h^2) / 12, where w and h are the outer size. Where
/// thick capsules keep the corners too near to the middle for that, two particles in the middle of
/// the short sides take the place of the fifth, or, where the corners nearly do by themselves, join
/// it as the fifth and the sixth.
/// Without it the corners carry all (the paper's box of Table 4, three times the inertia).
///
/// Where a rounded box is so thick, four particles at the outermost points of its round corners do,
/// before the core.
struct BoxOptions {
    Vec2 size{1, 1};            ///< metres, both more than 2 radius
    Real mass = 1;              ///< kilograms, > 0
    Real radius = Real(0.02);   ///< metres, > 0
    Real stiffness = infinite;  ///< N/m of every joint
    Real damping = 0;           ///< N s/m of every joint
    Real strength = infinite;   ///< N of every joint
    bool solidInertia = true;   ///< false: four corner particles alone, as in the paper
    bool rounded = false;       ///< whether the solid has its corners rounded by `radius`
    Material material = {};     ///< of the surface
};
/// Makes a rectangle; see BoxOptions.
Blueprint box(const BoxOptions& options = {});

/// A convex or concave polygon: a capsule along each edge, diagonals that triangulate it, and a
/// core particle, the last one, joined to all corners. Particle i is the corner of points[i], by
/// the radius of the capsules further inside, and joint i the edge from there to the next one. With
/// infinite stiffness it is rigid. The core may lie outside of a concave polygon; it touches
/// nothing.
///
/// A rounded polygon stands for a solid whose corners that are bent outwards are arcs of `radius`,
/// and may be as thick as fits: where its corner particles are too near to the middle, as many
/// particles at the outermost points of the arcs follow them, before the core.
struct PolygonOptions {
    /// 3 to 200 corners in either sense of rotation, metres in the body's frame: the outer side of
    /// the capsules. The outline may not meet itself.
    std::vector<Vec2> points = {};
    Real mass = 1;              ///< kilograms, > 0
    Real radius = Real(0.02);   ///< metres, > 0; twice that fits into the narrowest place
    Real stiffness = infinite;  ///< N/m of every joint
    Real damping = 0;           ///< N s/m of every joint
    Real strength = infinite;   ///< N of every joint
    bool rounded = false;       ///< whether the solid has its corners rounded by `radius`
    Material material = {};     ///< of the surface
};
/// Makes a polygon; see PolygonOptions. Complexity: cubic in the number of points.
Blueprint polygon(const PolygonOptions& options);

/// One particle with a radius: a solid disc, which turns and rolls, with the moment of inertia
/// m r^2 / 2. (With Friction::sliding, or pinned, it does not turn.)
struct BallOptions {
    Real radius = Real(0.25);  ///< metres, > 0
    Real mass = 1;             ///< kilograms, > 0
    Material material = {};    ///< of the surface
};
/// Makes a disc of one particle; see BallOptions.
Blueprint ball(const BallOptions& options = {});

/// A rim of rigid capsules around a hub, with the inertia of a solid disc, m R^2 / 2. The hub is
/// the last particle; what is attached to it is an axle.
struct WheelOptions {
    Real radius = Real(0.5);         ///< metres, outer, to the rim's corners; >= 2 rimRadius
    int segments = 16;               ///< particles on the rim, 3 to 1000
    Real mass = 1;                   ///< kilograms in all, > 0
    Real rimRadius = Real(0.03);     ///< metres, > 0: half the thickness of the rim
    Real spokeStiffness = infinite;  ///< N/m of a spoke; infinite makes the wheel rigid
    Real spokeDamping = 0;           ///< N s/m of a spoke
    Real strength = infinite;        ///< N of every joint
    Material material = {};          ///< of the surface
};
/// Makes a wheel; see WheelOptions.
Blueprint wheel(const WheelOptions& options = {});

/// A line of equal links. The first particle is at `from`, the last at `to`. With slack it is
/// longer than the way between them, and begins as an arc on the lower side. A rope of weight W
/// that hangs from one end is stretched by W links / (2 stiffness), a rigid one not at all.
struct RopeOptions {
    Vec2 from{0, 0};  ///< metres
    Vec2 to{0, -2};   ///< metres
    int links = 0;    ///< 1 to 100000; 0: as many as make links of about 5 cm
    /// The share by which it is longer, 0 to 10, from two links on. Without a value 0.02 with both
    /// ends pinned, because what is taut bears a load across it with a hundred times its weight,
    /// and 0 else.
    std::optional<Real> slack = {};
    Real mass = Real(0.5);      ///< kilograms in all, > 0, the same in each particle
    Real radius = Real(0.015);  ///< metres; 0: the rope touches nothing
    Real stiffness = infinite;  ///< N/m of a link
    Real damping = 0;           ///< N s/m of a link
    /// How stiff it is against bending, 0 (limp, as a chain of hinges) to 100. An angular joint at
    /// each inner particle has the stiffness m l^2 w^2 (N m/rad) and the damping 2 z m l^2 w
    /// (N m s/rad), with the mass m of a particle, the length l of a link, z = 0.3 times
    /// `bendingDamping`, and w = 60 rad/s times the root of this, or a quarter of the root of
    /// stiffness over m, if that is less. Between rigid links, and with both up to 1, that are
    /// forces alone, whatever the rate. A rope of links of 5 cm then lies in coils of some 10 cm.
    Real bending = 1;
    /// How strongly bending is damped, 0 to 100; from 3.3 on it springs back without swinging. A
    /// rope across a gap needs tens of it to calm loads that are much heavier than itself.
    Real bendingDamping = 1;
    Real strength = infinite;  ///< N of a link
    bool pinFirst = false;     ///< holds the particle at `from`
    bool pinLast = false;      ///< holds the particle at `to`
    Material material = {};    ///< of the surface
};
/// Makes a rope; see RopeOptions.
Blueprint rope(const RopeOptions& options = {});

/// A line of rigid links, longer, thicker and heavier than a rope's.
struct ChainOptions {
    Vec2 from{0, 0};           ///< metres
    Vec2 to{0, -2};            ///< metres
    int links = 0;             ///< 1 to 100000; 0: as many as make links of about 12 cm
    Real mass = 6;             ///< kilograms in all, > 0, the same in each particle
    Real radius = Real(0.03);  ///< metres; 0: the chain touches nothing
    Real strength = infinite;  ///< N of a link
    bool pinFirst = false;     ///< holds the particle at `from`
    bool pinLast = false;      ///< holds the particle at `to`
    Material material = {};    ///< of the surface
};
/// Makes a chain; see ChainOptions.
Blueprint chain(const ChainOptions& options = {});

/// Planks hung between two pins: each is one capsule, joined to its neighbours end to end. Each
/// end of a plank carries half of its mass.
struct BridgeOptions {
    Vec2 from{-2, 0};           ///< metres; a pin
    Vec2 to{2, 0};              ///< metres; a pin
    int planks = 12;            ///< 1 to 10000
    Real sag = Real(0.2);       ///< metres, >= 0: how far its middle hangs below the pins
    Real mass = 12;             ///< kilograms in all, > 0
    Real radius = Real(0.05);   ///< metres, > 0: half the thickness of a plank
    Real stiffness = infinite;  ///< N/m of a plank
    Real damping = 0;           ///< N s/m of a plank
    Real strength = infinite;   ///< N of a plank
    Material material = {};     ///< of the surface
};
/// Makes a bridge; see BridgeOptions.
Blueprint bridge(const BridgeOptions& options = {});

/// A rectangular lattice of particles with structural and diagonal springs and a collision
/// outline. Particles stand row by row from the lower left; a coarse lattice gets one more in its
/// middle when the solid's inertia asks for it.
struct JellyOptions {
    Vec2 size{1, 1};           ///< metres, both more than 2 radius
    int columns = 4;           ///< particles across, 2 to 1000
    int rows = 4;              ///< particles up, 2 to 1000
    Real mass = 1;             ///< kilograms in all, > 0
    Real radius = Real(0.03);  ///< metres, > 0: half the thickness of the outline
    Real stiffness = 400;      ///< N/m of a spring
    Real damping = 1;          ///< N s/m of a spring
    Real strength = infinite;  ///< N of a spring
    Material material = {};    ///< of the surface
};
/// Makes a jelly; see JellyOptions.
Blueprint jelly(const JellyOptions& options = {});

/// A sheet hung by its upper corners: a rectangular net of springs, each of which collides.
/// Particles stand row by row from the lower left.
struct ClothOptions {
    Vec2 size{2, 2};            ///< metres, both more than 2 radius
    int columns = 12;           ///< particles across, 3 to 1000
    int rows = 12;              ///< particles up, 3 to 1000
    Real mass = Real(0.5);      ///< kilograms in all, > 0
    Real radius = Real(0.01);   ///< metres: half the thickness; 0: the cloth touches nothing
    bool diagonals = false;     ///< braces each mesh, so that it resists shear
    bool pinCorners = true;     ///< holds the two upper corners
    Real stiffness = 2000;      ///< N/m of a spring
    Real damping = Real(0.05);  ///< N s/m of a spring
    Real strength = infinite;   ///< N of a spring
    Material material = {};     ///< of the surface
};
/// Makes a cloth; see ClothOptions.
Blueprint cloth(const ClothOptions& options = {});

/// A wall of braced cells that breaks where it is loaded beyond its strength. The sides of all
/// cells are capsules, so that its fragments have a surface.
struct WallOptions {
    Vec2 size{2, 1};            ///< metres, both more than 2 radius
    int columns = 6;            ///< cells across, 1 to 999
    int rows = 3;               ///< cells up, 1 to 999
    Real mass = 40;             ///< kilograms in all, > 0
    Real radius = Real(0.02);   ///< metres, > 0
    Real stiffness = infinite;  ///< N/m of every joint
    Real damping = 0;           ///< N s/m of every joint
    Real strength = 1500;       ///< N of every joint
    bool pinBottom = false;     ///< holds the lowest row of particles: a foundation
    Material material = {};     ///< of the surface
};
/// Makes a wall; see WallOptions.
Blueprint wall(const WallOptions& options = {});

/// A round soft body: a ring of particles around a hub, with spokes and skipping braces, and the
/// inertia of a solid disc, m R^2 / 2. The hub is the last particle.
struct BlobOptions {
    Real radius = Real(0.5);       ///< metres, outer, at least 2 skinRadius
    int segments = 12;             ///< particles on the ring, 3 to 1000
    Real mass = 1;                 ///< kilograms in all, > 0
    Real skinRadius = Real(0.03);  ///< metres, > 0: half the thickness of the outline
    Real stiffness = 800;          ///< N/m of a spring
    Real damping = 2;              ///< N s/m of a spring
    Material material = {};        ///< of the surface
};
/// Makes a blob; see BlobOptions.
Blueprint blob(const BlobOptions& options = {});

}  // namespace sulfur::shapes
