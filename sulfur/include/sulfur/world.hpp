/// \file
/// The world: owns everything, one step() is one tick.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <sulfur/blueprint.hpp>
#include <sulfur/body.hpp>
#include <sulfur/callbacks.hpp>
#include <sulfur/error.hpp>
#include <sulfur/events.hpp>
#include <sulfur/fields.hpp>
#include <sulfur/grab.hpp>
#include <sulfur/ids.hpp>
#include <sulfur/info.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>
#include <sulfur/mechanisms.hpp>
#include <sulfur/queries.hpp>
#include <sulfur/statistics.hpp>
#include <sulfur/tasks.hpp>
#include <sulfur/world_settings.hpp>
#include <utility>
#include <vector>

namespace sulfur {

/// Options of a joint between two particles that exist already.
struct ConnectOptions {
    Real stiffness = infinite;                        ///< N/m; `infinite` is rigid
    Real damping = 0;                                 ///< N s/m
    std::optional<Real> restLength = std::nullopt;    ///< m; their distance now when not given
    Real radius = 0;                                  ///< m; > 0 collides
    Real strength = infinite;                         ///< N
    std::optional<Material> material = std::nullopt;  ///< of its surface; its body's when not given
};

/// The state of a world as bytes. Opaque; the same build of the library reads it back.
using Snapshot = std::vector<std::byte>;

class DebugDraw;
struct DrawOptions;

/// Owns particles, joints and bodies and moves them.
///
/// Not thread-safe: one thread at a time may use a world; different worlds are independent.
/// Determinism: the same calls in the same order give the same bits, whatever the compiler,
/// optimisation level or machine.
///
/// Every function that takes a handle throws Error{staleHandle} when it is null or its thing is
/// gone; every function that takes numbers throws Error when they are not finite or not in the
/// documented range. The world is then unchanged.
///
/// Where there is no memory, a call throws std::bad_alloc and the world is unchanged too. Only
/// step() cannot promise that; see there.
class World {
public:
    /// An empty world. Throws Error when a setting is out of its range.
    explicit World(const WorldSettings& settings = {});
    ~World();
    /// Takes over all that the other one is; every Body and every handle of that is now of this
    /// one, and what this one was before is gone. The other one may then only be destroyed or
    /// assigned to.
    World(World&& other) noexcept;
    World& operator=(World&& other) noexcept;  ///< The same.
    /// Another world in the same state, which goes on to the same bits: handles are valid in both,
    /// settings, names, skins, user data, the last tick's events and setProfiling() are the same.
    /// A Body stays with the world that it is of; body() gives that of the other. Threads are lent
    /// to one world, and callbacks are made for one: the new one has none until setTasks(),
    /// setShouldCollide() and setPreSolve(). It costs as much as snapshot() and restore().
    World clone() const;

    // --- making and removing ---------------------------------------------------------------

    /// Makes a body. Its particles start at rest. What sleeps where a fixed body comes to be wakes.
    /// Complexity: linear in the blueprint, for a fixed body also in what sleeps.
    Body add(const Blueprint& blueprint, const Pose& pose = {});
    /// Removes a body with its particles, its joints and all joints and attachments that held on to
    /// them. Wakes what touched it.
    void remove(BodyId body);
    /// Joins two particles, usually of different bodies. At least one must be free to move, and if
    /// both are of dynamic bodies, the ratio of their masses is at most 1e9, as for attach().
    JointId connect(ParticleId a, ParticleId b, const ConnectOptions& options = {});
    /// Removes one joint, and wakes what lay on it. It leaves its body in one piece, even where
    /// nothing holds the parts together any more; only breaking makes bodies of them.
    void remove(JointId joint);
    /// Holds `particle` at a point of `body`, given in the frame of its blueprint. The point
    /// follows the body's nearest particles, also when the body deforms; it may lie outside, by up
    /// to some fifty times the distance of those particles. A gap closes at 0.5 m/s,
    /// so that nobody is thrown.
    AttachmentId attach(ParticleId particle, BodyId body, Vec2 localPoint);
    /// Holds `particle` at the place along the axis of `joint` (0: its particle a, 1: its b).
    AttachmentId attach(ParticleId particle, JointId joint, Real along);
    /// Lets go.
    void remove(AttachmentId attachment);
    /// Holds a particle where it is, or lets it go.
    void setPinned(ParticleId particle, bool pinned);

    /// Adds a force field. Throws Error when a number is out of the range that fields.hpp gives.
    FieldId add(const Field& field);
    /// Changes a field.
    void set(FieldId id, const Field& field);
    /// Removes a field.
    void remove(FieldId field);

    /// Pulls a particle of a dynamic body towards `target`, as a mouse does.
    GrabId grab(ParticleId particle, Point target, const GrabOptions& options = {});
    /// Pulls a point of a dynamic body, given in the frame of its blueprint as for attach().
    GrabId grab(BodyId body, Vec2 localPoint, Point target, const GrabOptions& options = {});
    /// Moves the target.
    void setTarget(GrabId grab, Point target);
    /// Lets go. A grab also ends when what it holds is removed.
    void release(GrabId grab);

    // Mechanisms join two bodies, of which at least one is dynamic. Points are of the world. A
    // rigid body holds any point within some fifty of its sizes, one whose particles are in a line
    // those on that line; a soft body holds a point by the particles around it. Drives are in
    // mechanisms.hpp. A mechanism is gone when a body of it is, or what it holds of it.

    /// Lets two bodies turn about a common point. Where that is no particle of either, a pin joins
    /// them: a body of one particle, with a thousandth of the mass of the lighter one.
    MechanismId hinge(BodyId a, BodyId b, Point at, const HingeOptions& options = {});
    /// The same with a drive that holds the angle.
    MechanismId weld(BodyId a, BodyId b, Point at, const WeldOptions& options = {});
    /// Leads the point `at` of b along the line through it, in the direction `axis`, that moves
    /// with a.
    MechanismId slider(BodyId a, BodyId b, Point at, Vec2 axis, const SliderOptions& options = {});
    /// Leads the point `at` of b along joints of a, straight ones and arcs: `rail` has them in the
    /// order of a line, each beginning where the one before ends. The value is the length along
    /// them, at rest, from where the first one begins, which counts as `options.value`; it goes on
    /// from round to round where the last one ends there. At free ends the point stops, as at
    /// limits. Where links meet at an angle it is deflected without losing speed. It may be beside
    /// the rail, by up to half of its length, and then comes nearer at up to 5 m/s. Where another
    /// joint of the rail breaks or is removed, the rail ends there; with the one that it is on the
    /// slider goes. Complexity: linear in the joints, of a step in those that it passes.
    MechanismId slider(BodyId a, BodyId b, Point at, std::span<const JointId> rail,
                       const SliderOptions& options = {});
    /// Hangs a wheel on a body: a slider with a spring, and a motor that turns it.
    WheelIds wheel(BodyId body, BodyId wheel, Point at, Vec2 axis,
                   const WheelOptions& options = {});
    /// Keeps the distance of two points in limits, or drives it: with an upper limit alone a rope,
    /// with a motor a winch.
    MechanismId distance(BodyId a, Point atA, BodyId b, Point atB,
                         const DistanceOptions& options = {});
    /// Hangs two bodies on the ends of one rope without mass, which runs over two points of a third
    /// body without friction.
    MechanismId pulley(BodyId a, Point atA, Point overA, BodyId b, Point atB, Point overB,
                       BodyId frame, const PulleyOptions& options = {});
    /// Couples two mechanisms: the value of the first plus `ratio` times that of the second stays
    /// what it is. Hinges make gears, a hinge and a slider a rack.
    MechanismId gear(MechanismId first, MechanismId second, Real ratio);
    /// Changes what acts along the coordinate of a mechanism, and wakes both bodies. A gear's drive
    /// holds with the stiffness `infinite` and the rest 0.
    void setDrive(MechanismId mechanism, const Drive& drive);
    /// The same for an angular joint of a body, whose coordinate is its angle; its rest is -pi to
    /// pi.
    void setDrive(AngleId angle, const Drive& drive);
    /// Lets both bodies go.
    void remove(MechanismId mechanism);
    /// Takes an angular joint away; what it bent stays.
    void remove(AngleId angle);

    /// Whether a handle is valid: neither null nor of something that was removed.
    bool contains(BodyId body) const;
    /// Whether a handle is valid.
    bool contains(ParticleId particle) const;
    /// Whether a handle is valid.
    bool contains(JointId joint) const;
    /// Whether a handle is valid.
    bool contains(AttachmentId attachment) const;
    /// Whether a handle is valid.
    bool contains(FieldId field) const;
    /// Whether a handle is valid.
    bool contains(GrabId grab) const;
    /// Whether a handle is valid.
    bool contains(MechanismId mechanism) const;
    /// Whether a handle is valid.
    bool contains(AngleId angle) const;

    // --- looking ---------------------------------------------------------------------------

    /// All bodies, oldest first. Valid until the next body is added or removed.
    std::span<const BodyId> bodies() const;
    /// Joints between bodies, oldest first.
    std::vector<JointId> connections() const;
    /// Attachments, oldest first.
    std::vector<AttachmentId> attachments() const;
    /// Fields, oldest first.
    std::vector<FieldId> fields() const;
    /// What a field is. Valid until it is changed or any field is added or removed.
    const Field& field(FieldId id) const;
    /// Grabs, oldest first.
    std::vector<GrabId> grabs() const;
    /// Mechanisms, oldest first.
    std::vector<MechanismId> mechanisms() const;
    /// The body of a handle.
    Body body(BodyId body);
    /// Particles of a body in the order of its blueprint. Valid until it changes.
    std::span<const ParticleId> particles(BodyId body) const;
    /// Joints of a body in the order of its blueprint, without those that are gone.
    std::span<const JointId> joints(BodyId body) const;
    /// Angular joints of a body in the order of its blueprint, without those that are gone.
    std::vector<AngleInfo> angles(BodyId body) const;
    /// The name of its blueprint. References of this and the next are valid until bodies are
    /// added or removed.
    const std::string& name(BodyId body) const;
    /// Who moves a body.
    BodyKind kind(BodyId body) const;
    /// Whether a body takes part; see setEnabled().
    bool isEnabled(BodyId body) const;
    /// The surface of a body.
    const Material& material(BodyId body) const;
    /// The surface of a joint: its own, or that of its body.
    const Material& material(JointId joint) const;
    /// What a body collides with.
    const Filter& filter(BodyId body) const;
    /// Whether the parts of a body touch each other.
    bool selfCollision(BodyId body) const;
    /// False after setCollision(a, b, false).
    bool collision(BodyId a, BodyId b) const;
    /// Whether a body is a sensor; see setSensor().
    bool sensor(BodyId body) const;
    /// Who was in a sensor at the end of the last tick and is still there, by their ids; nobody
    /// for other bodies.
    std::vector<BodyId> visitors(BodyId sensor) const;
    /// The pairs of bodies for which collision() is false, in the order of their handles.
    std::vector<std::pair<BodyId, BodyId>> vetoes() const;
    /// What a body wears.
    const std::optional<Skin>& skin(BodyId body) const;
    /// What setUserData() left there; 0 at first.
    std::uint64_t userData(BodyId body) const;

    // A body as a whole. Rotation is what its particles do together; each of them counts by its
    // mass, pinned ones by the mass that they have when they are let go. A disc that turns by
    // itself (see ParticleInfo::spin) counts with its own spin and its moment of inertia,
    // m r^2 / 2. Complexity: linear in the body; before the first tick after a change of its rigid
    // joints or pins, that of finding what of it is rigid, where it has particles with a radius.

    /// Where the frame of its blueprint is: after add(blueprint, pose) that pose, with an angle of
    /// -pi to pi. For a rigid body it is exact within rounding. For any other one it is the rigid
    /// motion of the blueprint that comes nearest to its particles, by the sum of mass times
    /// distance squared: both centres of mass meet, and the angle is that of the sums of
    /// m (q . x) and m (q x x), with the places q in the blueprint and x now, from there (polar
    /// decomposition: Mueller et al. 2005, shape matching). So it is also for what has changed for
    /// good, by rest lengths or by places: places in the blueprint stay what they were. Pieces
    /// that break off keep the frame of their body, as their particles show it. Where both sums
    /// vanish (a single particle, a body pressed into one point or turned inside out), the angle
    /// is the one that it was placed with last, by add() or setPose(), or had when it broke;
    /// that of a disc has rolled on from there.
    Pose pose(BodyId body) const;
    /// Where to draw its frame when `alpha` (0..1) of the next tick has already passed on the
    /// clock: between the poses of the last two ticks. Its centre of mass goes straight, its angle
    /// evenly and the shorter way. Throws Error when `alpha` is not in 0..1.
    Pose interpolatedPose(BodyId body, double alpha) const;
    /// The angle of pose(), -pi to pi.
    double angle(BodyId body) const;
    /// Where a point of a body's frame is in the world, metres, by pose(). Points here and below
    /// are -1e9 to 1e9 m on each axis. For what is bent it is where the point would be if it were
    /// not; attach() tells of points that follow the particles around them.
    Point toWorld(BodyId body, Point local) const;
    /// Where a point of the world is in a body's frame, metres.
    Point toBody(BodyId body, Point point) const;
    /// A direction, velocity or force in a body's frame (each component -1e12 to 1e12) as it is in
    /// the world: turned by angle().
    Vec2 vectorToWorld(BodyId body, Vec2 local) const;
    /// And the other way.
    Vec2 vectorToBody(BodyId body, Vec2 vector) const;
    /// The mass-weighted mean place of its particles, metres.
    Point centreOfMass(BodyId body) const;
    /// The mass-weighted mean velocity of its particles, m/s.
    Vec2 meanVelocity(BodyId body) const;
    /// Angular momentum about the centre of mass over inertia(), rad/s; for a rigid body its spin.
    /// 0 for a single particle that is no disc.
    double angularVelocity(BodyId body) const;
    /// The mass of all its particles, kg.
    Real mass(BodyId body) const;
    /// The moment of inertia of its particles as they are now, about its centre of mass, kg m^2.
    Real inertia(BodyId body) const;
    /// The upright rectangle around its particles, discs and capsules; those of joints between
    /// bodies are left out. Where the last tick left them, or the last call.
    Bounds bounds(BodyId body) const;
    /// How much of gravity() acts on a body; see setGravityScale().
    Real gravityScale(BodyId body) const;
    /// Whether a body does not turn; see setFixedRotation().
    bool fixedRotation(BodyId body) const;
    /// 1/s, of a body's centre of mass; see setDamping().
    Real linearDamping(BodyId body) const;
    /// 1/s, of how it turns about that.
    Real angularDamping(BodyId body) const;
    /// False after setSleepingAllowed(body, false).
    bool sleepingAllowed(BodyId body) const;
    /// Whether a body sleeps: it rests and costs nothing until something wakes it.
    bool asleep(BodyId body) const;

    /// What a particle is.
    ParticleInfo info(ParticleId particle) const;
    /// What a joint is.
    JointInfo info(JointId joint) const;
    /// What an attachment is.
    AttachmentInfo info(AttachmentId attachment) const;
    /// What a grab is.
    GrabInfo info(GrabId grab) const;
    /// What a mechanism is.
    MechanismInfo info(MechanismId mechanism) const;
    /// What an angular joint is.
    AngleInfo info(AngleId angle) const;
    /// Where a particle is, metres.
    Point position(ParticleId particle) const;
    /// Where to draw a particle when `alpha` (0..1) of the next tick has already passed on the
    /// clock: between the last two ticks' positions, so drawing lags by at most one tick. Throws
    /// Error when `alpha` is not in 0..1.
    Point interpolated(ParticleId particle, double alpha) const;
    /// Mean velocity over the last step (displacement divided by duration), which is the velocity
    /// at the middle of that step; after setVelocity, what was set. A step is a tick, below 480 Hz
    /// an equal part of one; ropes and what hangs on them take more steps when they need to. Each
    /// axis is at most 2000 m/s either way: forces, impulses and constraints give no more.
    Vec2 velocity(ParticleId particle) const;
    /// Contacts that push, in a fixed order: those of the last tick, and those of sleepers. Sensors
    /// have none.
    std::vector<ContactInfo> contacts() const;
    /// Those of one body, with others and between its own parts, in a fixed order: as many as there
    /// is room for come to `out`. Returns how many there are. It takes no memory once it has been
    /// asked about as many. Complexity: linear in what is near the body, and in the impacts of the
    /// last step; in all contacts for a body to which a capsule of connect() leads.
    std::size_t contacts(BodyId body, std::span<ContactInfo> out) const;
    /// Whether two bodies touched at the end of the last tick, as events() tell it; also sleepers,
    /// and parts of one body. Sensors touch nobody. Complexity: constant.
    bool touches(BodyId a, BodyId b) const;
    /// Kinetic plus gravitational plus elastic energy of all dynamic bodies, joules, at the time of
    /// the velocities: half a tick before the positions (see velocity()).
    double energy() const;

    // --- changing --------------------------------------------------------------------------

    /// m/s^2, each axis up to 1e6 either way. A change wakes everything.
    void setGravity(Vec2 gravity);
    /// m/s^2.
    Vec2 gravity() const;
    /// 1/s, 0 to the tick rate; see WorldSettings::airFriction.
    void setAirFriction(Real airFriction);
    /// 1/s.
    Real airFriction() const;
    /// Changes the duration of the ticks to come; 60 to 10000 Hz, and not less than airFriction()
    /// and the damping of any body. How each joint is solved is derived again.
    void setTickRate(int tickRate);
    /// What the dampers of all elastic joints brake from now on.
    void setDamper(Damper damper);
    /// Changes the surface of a body. Throws Error when a number is out of the range that
    /// material.hpp gives. Wakes it and what touches it.
    void setMaterial(BodyId body, const Material& material);
    /// Gives a joint a surface of its own, or its body's again (std::nullopt). Errors and waking as
    /// above.
    void setMaterial(JointId joint, const std::optional<Material>& material);
    /// Whether the parts of a body touch each other. What is nearer to each other in the blueprint
    /// than 1.2 times its thickness never does, nor do the parts of a rigid component.
    void setSelfCollision(BodyId body, bool on);
    /// Lets two bodies pass through each other (false), whatever their filters say, or not (true).
    /// Pieces that break off inherit it; it is forgotten with either body. Throws
    /// Error{degenerate} when they are one body. Wakes both and what is near.
    void setCollision(BodyId a, BodyId b, bool on);
    /// Changes what a body collides with. Wakes it and what is near.
    void setFilter(BodyId body, const Filter& filter);
    /// Makes a body a sensor or an ordinary body. The capsules and discs of a sensor push nothing
    /// and are pushed by nothing. It feels the dynamic and kinematic bodies that touch them or
    /// are inside of its outline, which may be drawn either way round, also sleeping ones, unless
    /// the filters of both forbid them to collide; it does not feel fixed bodies and other
    /// sensors. Who comes and goes is told at the end of each tick in events(); where a sensor is
    /// removed, or made an ordinary body, nothing is told. Wakes what is near.
    void setSensor(BodyId body, bool sensor);
    /// Takes a body out of the world for a while (false), or back in (true). While it is out it
    /// stays where it is, with its velocities, touches nothing, and no query or sensor finds it; as
    /// a sensor it feels nobody. Joints to other bodies, attachments and mechanisms do nothing
    /// meanwhile, on either side, nor do grabs, forces and impulses; it neither sleeps nor wakes.
    /// Its handles are valid, it can be looked at, drawn, moved by setPose() and changed, and what
    /// velocity it is given it has when it comes back. Contacts end with the next tick, with their
    /// events; those who were in it as a sensor are not told. When it comes back it goes on as it
    /// was, joints and attachments close as if the caller had torn them apart, and what it overlaps
    /// then is led apart slowly. Pieces that break off inherit it; scene files do not hold it.
    /// Wakes what touched or is tied to it, and what sleeps where it comes back. Complexity: that
    /// of deriving how all is solved, in the next tick.
    void setEnabled(BodyId body, bool enabled);
    /// Changes who moves a body. What becomes dynamic goes on with the velocities of its particles,
    /// and discs with its angular velocity: from rest if it was fixed, as it was driven if it was
    /// kinematic. What becomes kinematic goes on with the velocity of its centre of mass, a rigid
    /// body also with its angular velocity, as if setVelocity() had said so; a pose that it was
    /// being moved to is forgotten. What becomes fixed stops: its momentum is gone. Throws
    /// Error{outOfRange} where a body that becomes dynamic is joined or attached to a dynamic one
    /// of more than 1e9 times its mass, or less than a 1e9th, as connect() does. A joint between
    /// two bodies that are not dynamic does nothing. Wakes it, what touched or is tied to it, and
    /// what sleeps where it is. Complexity: as that of setEnabled().
    void setKind(BodyId body, BodyKind kind);
    /// How much of gravity() acts on a dynamic body, -1000 to 1000, 1 at first: 0 floats, below 0
    /// rises. Pieces that break off inherit it; scene files do not hold it. Wakes it and what
    /// touches it.
    void setGravityScale(BodyId body, Real scale);
    /// Whether a dynamic body keeps its angle, whatever pushes it, as a figure of a platform game
    /// does: the moment of inertia of its rigid components and discs is infinite, and they lose
    /// the spin that they have with the next tick. setPose() turns it still. A body of several such
    /// components still bends at its hinges, and nothing keeps from turning what is soft. With a
    /// pinned particle it stays where it is. inertia() tells what it would be otherwise. Angular
    /// momentum is not kept by whatever such a body pushes. Pieces that break off inherit it; scene
    /// files do not hold it. Wakes it and what touches it.
    void setFixedRotation(BodyId body, bool on);
    /// Slows a dynamic body down, as the world's air friction does and beside it: its centre of
    /// mass gets the acceleration -linear * meanVelocity(), and it turns about that with the
    /// angular acceleration -angular * angularVelocity(). 1/s, 0 to the tick rate, 0 at first. The
    /// force acts as that of a push on the whole body does (see below): it brakes no deformation,
    /// and where only turning is damped, momentum stays within rounding. Integrated by the
    /// trapezoidal rule, with the forces that are known before contacts and links: what rests on
    /// something presses on it by the share linear * h / 2 less, in steps of h seconds. Pieces that
    /// break off inherit it; scene files do not hold it. Wakes nobody.
    void setDamping(BodyId body, Real linear, Real angular);
    /// Leaves a number with a body, for the caller's use; it is no part of hash().
    void setUserData(BodyId body, std::uint64_t data);
    /// N/m, 0 to `infinite`. May be called in each tick, as the next two: while a spring stays one,
    /// only the joints around it follow.
    void setStiffness(JointId joint, Real stiffness);
    /// N s/m, 0 to 1e12.
    void setDamping(JointId joint, Real damping);
    /// Metres, 0 to 1e9; above 0 for a joint that is rigid or collides.
    void setRestLength(JointId joint, Real restLength);
    /// N, 0 to `infinite`.
    void setStrength(JointId joint, Real strength);
    /// kg, 1e-9 to 1e12, and at most 1e9 times that of any other particle of its body, or a 1e9th.
    void setMass(ParticleId particle, Real mass);
    /// Moves a particle, also one of a fixed body, without giving it velocity; metres, -1e9 to 1e9
    /// on each axis. Wakes its body, what touches it, and what a fixed body now overlaps.
    void setPosition(ParticleId particle, Point position);
    /// m/s, each axis up to 2000 either way. Not for fixed bodies; nothing for pinned particles.
    void setVelocity(ParticleId particle, Vec2 velocity);
    /// The same for all particles of a body, which ceases to turn with that, but that discs keep
    /// their spin: a ball goes on turning. Give the angular velocity too (below) to set it.
    void setVelocity(BodyId body, Vec2 velocity);
    /// Gives a body the motion of a rigid one: `linear` m/s of its centre of mass, and `angular`
    /// rad/s about it, -1e6 to 1e6, of all its particles and discs. None of them, nor the rim of a
    /// disc, may come to more than 2000 m/s on an axis. Pinned particles stay, and a rigid body
    /// that is pinned keeps of it what its pin allows. A kinematic body goes on like that, turning
    /// about its centre of mass, until a velocity is set or it is moved to a pose; its particles
    /// keep to their places in the blueprint meanwhile. Not for fixed bodies.
    void setVelocity(BodyId body, Vec2 linear, double angular);
    /// Puts a body elsewhere: its frame (see pose()) is at `pose` then. It keeps its shape, also
    /// what it is bent by, the velocity of its centre of mass and its angular velocity, so both
    /// momenta; its velocities relative to the centre of mass turn with it. (Where a particle is
    /// pinned, all velocities turn with it.) It does not go the way between: nothing on it is
    /// pushed or sensed, and interpolated() does not show it. What it is put into is led apart
    /// slowly. Pinned particles come along and are held at their new places. Attachments, joints
    /// to other bodies and grabs go on to hold: what they hold on to stays where it is, and both
    /// come together again, at up to 5 m/s, attachments as attach() says. A kinematic body forgets
    /// where moveTo() would have it go. Any kind of body; none of its particles may come to be
    /// beyond 1e9 m on an axis. Wakes it, what touched or is tied to it, and what a fixed or
    /// kinematic body now overlaps.
    void setPose(BodyId body, const Pose& pose);
    /// Adds a force, in newtons, that acts during the next tick only. In the tick
    /// after a velocity was set it changes that by half as much, because velocities stand in the
    /// middle of a step.
    void applyForce(ParticleId particle, Vec2 force);
    /// Changes the velocity at once by impulse / mass; N s. Does nothing to what cannot move.
    void applyImpulse(ParticleId particle, Vec2 impulse);

    // Pushing a body as a whole. The push acts as on a rigid body: its particles get
    // m_i (F/M + T/I x r_i), its discs a share of the torque T that goes with their own inertia,
    // where M is mass(), I inertia() and r_i the place from centreOfMass(). So the sums of force
    // and torque are exact, a rigid body does what rigid mechanics says, also about a pin, and a
    // soft one is not deformed by the push itself. What falls to pinned particles their pins bear.
    // Where there is no inertia (a single particle that is no disc) torques do nothing. None of
    // this does anything to fixed and kinematic bodies, nor does a push of 0; any other wakes.
    // Each component is up to 1e12 either way, that of each particle and disc too, points up to
    // 1e9 m.

    /// Adds a force, in newtons, at a point of the world, that acts during the next tick only.
    void applyForce(BodyId body, Vec2 force, Point at);
    /// Adds a torque, in N m, counter-clockwise, that acts during the next tick only.
    void applyTorque(BodyId body, Real torque);
    /// Changes velocity and angular velocity at once, by an impulse (N s) at a point of the world.
    /// No particle, nor the rim of a disc, gets faster than 2000 m/s on an axis.
    void applyImpulse(BodyId body, Vec2 impulse, Point at);
    /// Changes the angular velocity at once, by an angular impulse (N m s); likewise limited.
    void applyAngularImpulse(BodyId body, Real impulse);
    /// Moves a kinematic body so that it is at `pose` after the next tick, pushing what is in its
    /// way. It then stands still unless it is moved again.
    void moveTo(BodyId body, const Pose& pose);
    /// Wakes a sleeping body and its island.
    void wake(BodyId body);
    /// Puts a dynamic body to sleep with its island, which is all that is near or tied to it, also
    /// in the air: it loses its velocities and the forces of the next tick, and stays where it is
    /// until something wakes it. Returns whether it sleeps now. It does not, and nothing changes,
    /// where the world has no sleeping, where a body of the island may not sleep, or lies on a
    /// kinematic body that moves. Who is near is known from the last tick: what was added since is
    /// of an island by joints and attachments alone. Complexity: linear in the world.
    bool putToSleep(BodyId body);
    /// Whether a dynamic body may fall asleep, as all may at first. What may not wakes, and keeps
    /// awake whatever is near or tied to it. Pieces that break off inherit it; scene files do not
    /// hold it.
    void setSleepingAllowed(BodyId body, bool allowed);

    // --- time ------------------------------------------------------------------------------

    /// Advances by exactly one tick. Once the world has been in much the same situation before, a
    /// tick takes no memory. If it needs some and there is none, it throws std::bad_alloc in its
    /// middle, and there the world stays: from then on validate() says so, and whatever asks for
    /// the state or changes it throws Error{outOfMemory}, until restore() brings back a snapshot.
    /// What callbacks throw leaves a whole world; see callbacks.hpp.
    void step();
    /// Ticks since the world was made.
    std::uint64_t ticks() const;
    double time() const;        ///< seconds since the world was made
    Real tickDuration() const;  ///< seconds
    /// What the world was made with; gravity and air friction as they are now.
    const WorldSettings& settings() const;
    /// What happened in the last tick. Valid until the next.
    const Events& events() const;
    /// What the last tick did.
    const Statistics& statistics() const;
    /// What the world holds in memory, part by part: a handful of rows whatever its size. Linear in
    /// the bodies.
    std::vector<MemoryUse> memory() const;
    /// Whether statistics() also measures the time of each stage. It does not affect results.
    void setProfiling(bool on);
    /// Lends the world threads for its ticks, and for the first query after a change; null, as at
    /// first: it uses the caller's alone. `tasks` stays the host's and must live until others are
    /// lent or the world is gone. It does not affect results.
    void setTasks(Tasks* tasks);

    // --- callbacks -------------------------------------------------------------------------

    // What callbacks may do, when they are called and what becomes of their exceptions says
    // callbacks.hpp. They are no part of snapshots: restore() keeps those of the world that
    // restores, but with the state come the answers that still hold.

    /// Asks in the ticks to come whether two bodies collide, which their filters and collision()
    /// allow; an empty function, as at first, asks nobody. It is asked once about two bodies when
    /// they come near each other: when the boxes of the first of their parts meet, which have a
    /// margin of a tenth of their size, and more for what is fast. The answer holds until no parts
    /// of theirs are near each other any more, or until the shape of one of them is made anew, as
    /// changes of its particles, joints, material and filter do, and breaking. So setFilter() with
    /// the filter that a body has already makes the world ask again in the next tick. While the
    /// answer is false, the two pass through each other and do not wake each other. Sensors feel
    /// everybody whom filters allow, without a question. Filters cost less where many bodies that
    /// do not collide lie in one place, because each pair that was asked about is watched.
    void setShouldCollide(ShouldCollide shouldCollide);
    /// Asks in each step to come about each contact of two bodies that touch or may come to touch
    /// in it, before it is solved; an empty function, as at first, asks nobody. Two convex parts of
    /// bodies (what is rigid and convex, discs) have one contact of one or two points; elsewhere
    /// each corner that is near a side has one. Nobody is asked about sensors, about a body with
    /// itself, about sleepers (wake them when answers change), nor about bodies that were put into
    /// each other, until they have been led apart.
    ///
    /// All that is answered holds for one step. What does not act presses nothing and holds nothing
    /// back: continuous collision asks once more where something would pass through something else,
    /// and `surface` is of no use then. Events tell when contacts begin or cease to act. Sleepers
    /// wake when somebody comes near, before anybody is asked. Numbers of the surface are in the
    /// ranges of Material; else step() throws Error as if the callback had. Where several contacts
    /// of the same two parts differ, the largest restitution counts, and with Friction::sliding the
    /// largest friction.
    ///
    /// A platform with one way, whatever is thrown at it, asks where the other body is as a whole:
    /// `return world.bounds(other).low[1] > middleOfThePlatform;`
    void setPreSolve(PreSolve preSolve);

    // --- queries ---------------------------------------------------------------------------

    // Coordinates are -1e7 to 1e7 m; Error otherwise. See queries.hpp for what they see and cost.

    /// The first surface between two points. What starts inside of a capsule or disc meets it at
    /// once; what starts in the hollow of an outline meets the inner side of its capsules.
    std::optional<CastHit> castSegment(Point from, Point to, const QueryFilter& filter = {}) const;
    /// The first surface in a direction of any length above 0, at most `reach` metres away (0 to
    /// 1e6). Throws Error{degenerate} when the direction is zero. However far it reaches, it costs
    /// no more than the part of the way that runs through what there is.
    std::optional<CastHit> castRay(Point from, Vec2 direction, double reach,
                                   const QueryFilter& filter = {}) const;
    /// All capsules and discs between two points, each once where the way enters it, nearest first.
    std::vector<CastHit> castAll(Point from, Point to, const QueryFilter& filter = {}) const;
    /// The first surface that a shape meets when it is moved, without turning, by `translation`
    /// (each axis -1e7 to 1e7 m). A shape that overlaps a body at the start, also in the hollow of
    /// its outline, meets it at the fraction 0, with the normal zero. Exact: what it moves past is
    /// a polygon with round corners (the Minkowski difference), against which it is a ray.
    std::optional<CastHit> castShape(const QueryShape& shape, Point translation,
                                     const QueryFilter& filter = {}) const;
    /// The place of a surface that is nearest to a point and at most `reach` metres away (0 to
    /// 1e6); where bodies contain the point, of that one in which it is deepest.
    std::optional<ClosestPoint> closestPoint(Point point, double reach,
                                             const QueryFilter& filter = {}) const;
    /// All bodies that touch or enclose a shape, by their ids, each once.
    std::vector<Overlap> overlap(const QueryShape& shape, const QueryFilter& filter = {}) const;
    /// The same for the upright rectangle between two corners, `low` at most `high` in each axis.
    std::vector<Overlap> overlapBox(Point low, Point high, const QueryFilter& filter = {}) const;
    /// The same for a disc of 0 to 1e6 m.
    std::vector<Overlap> overlapCircle(Point centre, double radius,
                                       const QueryFilter& filter = {}) const;
    /// All bodies that contain a point, by their ids: what a mouse points at.
    std::vector<BodyId> bodiesAt(Point point, const QueryFilter& filter = {}) const;
    /// All bodies that overlap the upright rectangle between two corners, by their ids, each once:
    /// what a frame drawn with a mouse takes. Beside those of overlapBox() also bodies without a
    /// surface, of which a particle is in it. Complexity: also linear in the world's particles.
    std::vector<BodyId> bodiesIn(Point low, Point high, const QueryFilter& filter = {}) const;
    /// The particle nearest to a point and at most `reach` metres away.
    std::optional<ParticleId> nearestParticle(Point point, Real reach) const;

    /// Shows everything to `to`; see draw.hpp. Throws Error when `options.alpha` is not in 0..1.
    void draw(DebugDraw& to, const DrawOptions& options) const;
    /// Shows everything with the default options.
    void draw(DebugDraw& to) const;

    // --- state -----------------------------------------------------------------------------

    /// A 64-bit hash of everything that decides how the world goes on.
    std::uint64_t hash() const;
    /// The whole state. restore() and going on gives the same hash as never having stopped, and
    /// all handles that were valid then are valid again.
    Snapshot snapshot() const;
    /// Throws Error{badSnapshot}, leaving the world unchanged, unless `snapshot` came from the
    /// same build of the library.
    void restore(const Snapshot& snapshot);
    /// Names the first broken invariant (a number that is not finite, an index out of range, a
    /// list out of order), or returns an empty string.
    std::string validate() const;

    struct Impl;

private:
    friend class Body;

    std::unique_ptr<Impl> impl_;
    std::unique_ptr<World*> home_;  // where this world is: Body looks there
};

}  // namespace sulfur
