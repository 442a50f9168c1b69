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

bool Body::exists() const {
    return world().contains(id_);
}

void Body::remove() const {
    world().remove(id_);
}

const std::string& Body::name() const {
    return world().name(id_);
}

BodyKind Body::kind() const {
    return world().kind(id_);
}

void Body::setKind(BodyKind kind) const {
    world().setKind(id_, kind);
}

bool Body::isEnabled() const {
    return world().isEnabled(id_);
}

void Body::setEnabled(bool enabled) const {
    world().setEnabled(id_, enabled);
}

std::vector<AngleInfo> Body::angles() const {
    return world().angles(id_);
}

const std::optional<Skin>& Body::skin() const {
    return world().skin(id_);
}

std::uint64_t Body::userData() const {
    return world().userData(id_);
}

void Body::setUserData(std::uint64_t data) const {
    world().setUserData(id_, data);
}

const Material& Body::material() const {
    return world().material(id_);
}

void Body::setMaterial(const Material& material) const {
    world().setMaterial(id_, material);
}

const Filter& Body::filter() const {
    return world().filter(id_);
}

void Body::setFilter(const Filter& filter) const {
    world().setFilter(id_, filter);
}

bool Body::selfCollision() const {
    return world().selfCollision(id_);
}

void Body::setSelfCollision(bool on) const {
    world().setSelfCollision(id_, on);
}

bool Body::collision(BodyId other) const {
    return world().collision(id_, other);
}

void Body::setCollision(BodyId other, bool on) const {
    world().setCollision(id_, other, on);
}

bool Body::sensor() const {
    return world().sensor(id_);
}

void Body::setSensor(bool sensor) const {
    world().setSensor(id_, sensor);
}

std::vector<BodyId> Body::visitors() const {
    return world().visitors(id_);
}

std::size_t Body::contacts(std::span<ContactInfo> out) const {
    return world().contacts(id_, out);
}

bool Body::touches(BodyId other) const {
    return world().touches(id_, other);
}

bool Body::asleep() const {
    return world().asleep(id_);
}

void Body::wake() const {
    world().wake(id_);
}

bool Body::putToSleep() const {
    return world().putToSleep(id_);
}

bool Body::sleepingAllowed() const {
    return world().sleepingAllowed(id_);
}

void Body::setSleepingAllowed(bool allowed) const {
    world().setSleepingAllowed(id_, allowed);
}

Point Body::toWorld(Point local) const {
    return world().toWorld(id_, local);
}

Point Body::toBody(Point point) const {
    return world().toBody(id_, point);
}

Vec2 Body::vectorToWorld(Vec2 local) const {
    return world().vectorToWorld(id_, local);
}

Vec2 Body::vectorToBody(Vec2 vector) const {
    return world().vectorToBody(id_, vector);
}

void Body::moveTo(const Pose& pose) const {
    world().moveTo(id_, pose);
}

AttachmentId Body::attach(ParticleId particle, Vec2 localPoint) const {
    return world().attach(particle, id_, localPoint);
}

GrabId Body::grab(Vec2 localPoint, Point target, const GrabOptions& options) const {
    return world().grab(id_, localPoint, target, options);
}

}  // namespace sulfur
