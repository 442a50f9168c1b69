// Body: the calls of its world.
#include <sulfur/body.hpp>
#include <sulfur/world.hpp>

namespace sulfur {

Body::Body(World& world, BodyId id) : home_(world.home_.get()), id_(id) {}

std::span<const ParticleId> Body::particles() const {
    return world().particles(id_);
}

std::span<const JointId> Body::joints() const {
    return world().joints(id_);
}

Pose Body::pose() const {
    return world().pose(id_);
}

Pose Body::interpolatedPose(double alpha) const {
    return world().interpolatedPose(id_, alpha);
}

double Body::angle() const {
    return world().angle(id_);
}

Point Body::centreOfMass() const {
    return world().centreOfMass(id_);
}

Vec2 Body::meanVelocity() const {
    return world().meanVelocity(id_);
}

double Body::angularVelocity() const {
    return world().angularVelocity(id_);
}

Real Body::mass() const {
    return world().mass(id_);
}

Real Body::inertia() const {
    return world().inertia(id_);
}

Bounds Body::bounds() const {
    return world().bounds(id_);
}

void Body::setPose(const Pose& pose) const {
    world().setPose(id_, pose);
}

void Body::setVelocity(Vec2 velocity) const {
    world().setVelocity(id_, velocity);
}

void Body::setVelocity(Vec2 linear, double angular) const {
    world().setVelocity(id_, linear, angular);
}

void Body::applyForce(Vec2 force, Point at) const {
    world().applyForce(id_, force, at);
}

void Body::applyImpulse(Vec2 impulse, Point at) const {
    world().applyImpulse(id_, impulse, at);
}

void Body::applyTorque(Real torque) const {
    world().applyTorque(id_, torque);
}

void Body::applyAngularImpulse(Real impulse) const {
    world().applyAngularImpulse(id_, impulse);
}

Real Body::gravityScale() const {
    return world().gravityScale(id_);
}

void Body::setGravityScale(Real scale) const {
    world().setGravityScale(id_, scale);
}

bool Body::fixedRotation() const {
    return world().fixedRotation(id_);
}

void Body::setFixedRotation(bool on) const {
    world().setFixedRotation(id_, on);
}

Real Body::linearDamping() const {
    return world().linearDamping(id_);
}

Real Body::angularDamping() const {
    return world().angularDamping(id_);
}

void Body::setDamping(Real linear, Real angular) const {
    world().setDamping(id_, linear, angular);
}

}  // namespace sulfur
