// Body: the calls of its world.
#include <sulfur/body.hpp>
#include <sulfur/world.hpp>

namespace sulfur {

std::span<const ParticleId> Body::particles() const {
    return world_->particles(id_);
}

std::span<const JointId> Body::joints() const {
    return world_->joints(id_);
}

Pose Body::pose() const {
    return world_->pose(id_);
}

Pose Body::interpolatedPose(double alpha) const {
    return world_->interpolatedPose(id_, alpha);
}

double Body::angle() const {
    return world_->angle(id_);
}

Point Body::centreOfMass() const {
    return world_->centreOfMass(id_);
}

Vec2 Body::meanVelocity() const {
    return world_->meanVelocity(id_);
}

double Body::angularVelocity() const {
    return world_->angularVelocity(id_);
}

Real Body::mass() const {
    return world_->mass(id_);
}

Real Body::inertia() const {
    return world_->inertia(id_);
}

Bounds Body::bounds() const {
    return world_->bounds(id_);
}

void Body::setPose(const Pose& pose) const {
    world_->setPose(id_, pose);
}

void Body::setVelocity(Vec2 velocity) const {
    world_->setVelocity(id_, velocity);
}

void Body::setVelocity(Vec2 linear, double angular) const {
    world_->setVelocity(id_, linear, angular);
}

void Body::applyForce(Vec2 force, Point at) const {
    world_->applyForce(id_, force, at);
}

void Body::applyImpulse(Vec2 impulse, Point at) const {
    world_->applyImpulse(id_, impulse, at);
}

void Body::applyTorque(Real torque) const {
    world_->applyTorque(id_, torque);
}

void Body::applyAngularImpulse(Real impulse) const {
    world_->applyAngularImpulse(id_, impulse);
}

Real Body::gravityScale() const {
    return world_->gravityScale(id_);
}

void Body::setGravityScale(Real scale) const {
    world_->setGravityScale(id_, scale);
}

bool Body::fixedRotation() const {
    return world_->fixedRotation(id_);
}

void Body::setFixedRotation(bool on) const {
    world_->setFixedRotation(id_, on);
}

Real Body::linearDamping() const {
    return world_->linearDamping(id_);
}

Real Body::angularDamping() const {
    return world_->angularDamping(id_);
}

void Body::setDamping(Real linear, Real angular) const {
    world_->setDamping(id_, linear, angular);
}

}  // namespace sulfur
