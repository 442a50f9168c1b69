/// \file
/// A body as a whole: where it is, how it moves, and pushing it.
#pragma once

#include <cstddef>
#include <span>
#include <sulfur/ids.hpp>
#include <sulfur/math.hpp>

namespace sulfur {

class World;

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

private:
    World& world() const { return **home_; }

    World* const* home_ = nullptr;  // where its world is, which that keeps up to date
    BodyId id_ = {};
};

}  // namespace sulfur
