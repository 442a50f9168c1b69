/// \file
/// A body as a whole: where it is, how it moves, and pushing it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <sulfur/blueprint.hpp>
#include <sulfur/grab.hpp>
#include <sulfur/ids.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>
#include <vector>

namespace sulfur {

class World;
struct AngleInfo;
struct ContactInfo;

/// A body in a world: a handle with the world beside it. Copy it freely; it stays valid until the
/// body is removed or the world is gone, and follows a world that is moved.
class Body {
public:
    Body() = default;
    /// A body of `world`, which must outlive it.
    Body(World& world, BodyId id);

    /// Its handle.
    BodyId id() const { return id_; }
    /// Its handle: a body is its id wherever an id is wanted.
    operator BodyId() const { return id_; }  // NOLINT: meant to be implicit
    /// Its particles; see World::particles.
    std::span<const ParticleId> particles() const;
    /// Its joints; see World::joints.
    std::span<const JointId> joints() const;
    /// The number of its particles.
    std::size_t size() const { return particles().size(); }
    /// The particle at place `i` of its blueprint, less than size().
    ParticleId operator[](std::size_t i) const { return particles()[i]; }
    /// The first particle.
    ParticleId front() const { return particles().front(); }
    /// The last particle.
    ParticleId back() const { return particles().back(); }

    /// Where its own frame is; see World::pose.
    Pose pose() const;
    /// The same for drawing; see World::interpolatedPose.
    Pose interpolatedPose(double alpha) const;
    /// Radians; see World::angle.
    double angle() const;
    /// Metres; see World::centreOfMass.
    Point centreOfMass() const;
    /// m/s; see World::meanVelocity.
    Vec2 meanVelocity() const;
    /// rad/s; see World::angularVelocity.
    double angularVelocity() const;
    /// kg; see World::mass.
    Real mass() const;
    /// kg m^2; see World::inertia.
    Real inertia() const;
    /// What it covers; see World::bounds.
    Bounds bounds() const;

    // A handle stays the same when what it refers to changes.

    /// Puts it elsewhere; see World::setPose.
    void setPose(const Pose& pose) const;
    /// m/s of all of its particles; see World::setVelocity.
    void setVelocity(Vec2 velocity) const;
    /// m/s and rad/s about its centre of mass; see World::setVelocity.
    void setVelocity(Vec2 linear, double angular) const;
    /// Newtons at a point of the world during the next tick; see World::applyForce.
    void applyForce(Vec2 force, Point at) const;
    /// N s at a point of the world, at once; see World::applyImpulse.
    void applyImpulse(Vec2 impulse, Point at) const;
    /// N m during the next tick; see World::applyTorque.
    void applyTorque(Real torque) const;
    /// N m s, at once; see World::applyAngularImpulse.
    void applyAngularImpulse(Real impulse) const;
    /// How much of gravity acts on it; see World::setGravityScale.
    Real gravityScale() const;
    /// Changes that.
    void setGravityScale(Real scale) const;
    /// Whether it does not turn; see World::setFixedRotation.
    bool fixedRotation() const;
    /// Changes that.
    void setFixedRotation(bool on) const;
    /// 1/s, of its centre of mass; see World::setDamping.
    Real linearDamping() const;
    /// 1/s, of how it turns about that.
    Real angularDamping() const;
    /// Changes both.
    void setDamping(Real linear, Real angular) const;

    // What it is, and whether it takes part.

    /// Whether it is still in its world; see World::contains.
    bool exists() const;
    /// Removes it; see World::remove.
    void remove() const;
    /// The name of its blueprint; see World::name.
    const std::string& name() const;
    /// Who moves it.
    BodyKind kind() const;
    /// Changes who does; see World::setKind.
    void setKind(BodyKind kind) const;
    /// Whether it takes part.
    bool isEnabled() const;
    /// Takes it out of the world for a while, or back in; see World::setEnabled.
    void setEnabled(bool enabled) const;
    /// Its angular joints; see World::angles.
    std::vector<AngleInfo> angles() const;
    /// What it wears; see World::skin.
    const std::optional<Skin>& skin() const;
    /// The caller's number; see World::setUserData.
    std::uint64_t userData() const;
    /// Changes that.
    void setUserData(std::uint64_t data) const;

    /// Its surface.
    const Material& material() const;
    /// Changes that; see World::setMaterial.
    void setMaterial(const Material& material) const;
    /// What it collides with.
    const Filter& filter() const;
    /// Changes that; see World::setFilter.
    void setFilter(const Filter& filter) const;
    /// Whether its own parts touch each other.
    bool selfCollision() const;
    /// Changes that; see World::setSelfCollision.
    void setSelfCollision(bool on) const;
    /// False after setCollision(other, false).
    bool collision(BodyId other) const;
    /// Lets it and another one pass through each other, or not; see World::setCollision.
    void setCollision(BodyId other, bool on) const;
    /// Whether it is a sensor.
    bool sensor() const;
    /// Makes it a sensor or an ordinary body; see World::setSensor.
    void setSensor(bool sensor) const;
    /// Who is in it, if it is a sensor; see World::visitors.
    std::vector<BodyId> visitors() const;
    /// Its contacts, as many as there is room for; returns how many there are. See World::contacts.
    std::size_t contacts(std::span<ContactInfo> out) const;
    /// Whether it touches another one; see World::touches.
    bool touches(BodyId other) const;

    /// Whether it sleeps; see World::asleep.
    bool asleep() const;
    /// Wakes it and its island.
    void wake() const;
    /// Puts it to sleep with its island and returns whether it sleeps now; see World::putToSleep.
    bool putToSleep() const;
    /// Whether it may fall asleep.
    bool sleepingAllowed() const;
    /// Changes that; see World::setSleepingAllowed.
    void setSleepingAllowed(bool allowed) const;

    /// Where a point of its frame is in the world, metres; see World::toWorld.
    Point toWorld(Point local) const;
    /// Where a point of the world is in its frame, metres.
    Point toBody(Point point) const;
    /// A vector of its frame as it is in the world: turned.
    Vec2 vectorToWorld(Vec2 local) const;
    /// And the other way.
    Vec2 vectorToBody(Vec2 vector) const;

    /// Moves it, if it is kinematic, to be at `pose` after the next tick; see World::moveTo.
    void moveTo(const Pose& pose) const;
    /// Holds a particle of another body at a point of its frame; see World::attach.
    AttachmentId attach(ParticleId particle, Vec2 localPoint) const;
    /// Pulls a point of its frame, if it is dynamic, towards `target`; see World::grab.
    GrabId grab(Vec2 localPoint, Point target, const GrabOptions& options = {}) const;

private:
    World& world() const { return **home_; }

    World* const* home_ = nullptr;  // where its world is, which that keeps up to date
    BodyId id_ = {};
};

}  // namespace sulfur
