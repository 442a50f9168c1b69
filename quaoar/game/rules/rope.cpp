#include <quaoar/rope.hpp>

#include <algorithm>
#include <cmath>
#include <quaoar/hero.hpp>

#include "hash.hpp"

namespace quaoar {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;

namespace {

/// What the rope and its head meet: everything but the hero and the rope itself.
constexpr std::uint32_t touches = ~(Category::hero | Category::rope);

Point moved(const Point& from, const Vec2& direction, Real distance) {
    return from + (direction * distance).cast<double>();
}

}  // namespace

void Rope::shoot(Point from, Vec2 direction) {
    if (state_ != State::idle) return;
    state_ = State::flying;
    flyFrom_ = from;
    flyDirection_ = direction;
    flown_ = 0;
}

Rope::Landing Rope::fly(sulfur::World& world, sulfur::ParticleId hand, const Grip& grip) {
    if (state_ != State::flying) return Landing::none;
    const Real next = std::min(flown_ + rules_.headSpeed * world.tickDuration(), rules_.reach);
    const Point from = moved(flyFrom_, flyDirection_, flown_);
    const Point to = moved(flyFrom_, flyDirection_, next);
    const auto hit = world.castSegment(from, to, {.mask = touches});
    if (hit && !grip.holds(hit->body)) {
        state_ = State::idle;
        return Landing::slipped;
    }
    if (hit) {
        lay(world, hand, *hit);
        return Landing::stuck;
    }
    flown_ = next;
    if (flown_ < rules_.reach) return Landing::none;
    state_ = State::idle;
    return Landing::missed;
}

void Rope::lay(sulfur::World& world, sulfur::ParticleId hand, const sulfur::CastHit& hit) {
    const Point end = world.position(hand);
    const Vec2 handVelocity = world.velocity(hand);
    const Vec2 span = (end - hit.point).cast<Real>();
    const Real distance = span.norm();
    const Real length = std::clamp(distance, rules_.shortest, rules_.reach);
    const int count = std::max(1, static_cast<int>(length / rules_.linkLength));
    handLink_ = length - rules_.linkLength * static_cast<Real>(count - 1);
    const Vec2 anchorVelocity = world.meanVelocity(hit.body);
    for (int i = 0; i < count; ++i) {
        const Real part = rules_.linkLength * static_cast<Real>(i) / length;
        const Point at = hit.point + (span * part).cast<double>();
        // The tied end lies on the surface: with a radius it would push itself out of it.
        const Real radius = i == 0 ? Real(0) : rules_.radius;
        beads_.push_back(
            addBead(world, at, anchorVelocity + (handVelocity - anchorVelocity) * part, radius));
        if (i == 0) continue;
        const auto before = beads_[beads_.size() - 2];
        world.connect(before, beads_.back(),
                      {.stiffness = rules_.stiffness,
                       .damping = rules_.damping,
                       .restLength = rules_.linkLength});
    }
    tieHand(world, hand);
    anchor_ = hit.joint ? world.attach(beads_.front(), hit.joint, hit.along)
                        : world.attach(beads_.front(), hit.body, Vec2(0, 0));
    state_ = State::attached;
}

sulfur::ParticleId Rope::addBead(sulfur::World& world, Point at, Vec2 velocity, Real radius) {
    sulfur::Blueprint bead;
    bead.name = "rope";
    bead.particles.push_back({.position = {0, 0}, .mass = rules_.linkMass, .radius = radius});
    bead.material = {.staticFriction = Real(0.3), .kineticFriction = Real(0.25), .restitution = 0};
    bead.filter = {.category = Category::rope, .mask = touches};
    const sulfur::Body body = world.add(bead, {.position = at});
    world.setVelocity(body.front(), velocity);
    return body.front();
}

void Rope::tieHand(sulfur::World& world, sulfur::ParticleId hand) {
    handJoint_ = world.connect(
        beads_.back(), hand,
        {.stiffness = handStiffness(), .damping = handDamping(), .restLength = handLink_});
}

void Rope::hold(sulfur::World& world, sulfur::ParticleId hand, Real speed) {
    if (state_ != State::attached) return;
    const Real tick = world.tickDuration();
    reelSpeed_ = std::clamp(speed, reelSpeed_ - rules_.reelStart * tick,
                            reelSpeed_ + rules_.reelYield * tick);
    const bool stalls = tension(world) > static_cast<double>(rules_.reelForce);
    if (stalls) reelSpeed_ = std::max(reelSpeed_, Real(0));
    const Real before = static_cast<Real>(restLength());
    if (reelSpeed_ != 0) reel(world, hand, reelSpeed_ * tick);
    const Real changed = static_cast<Real>(restLength()) - before;
    if (changed == 0) reelSpeed_ = 0;
    damp(world, hand, changed / tick);
}

/// Keeps the link at the hand between a half and one and a half links long. Its stiffness goes
/// with its length as that of any piece of the same rope, so that taking a link away or adding one
/// changes neither the tension nor the rope's spring constant.
void Rope::reel(sulfur::World& world, sulfur::ParticleId hand, Real change) {
    const Real length = static_cast<Real>(restLength());
    change = std::clamp(change, std::min(Real(0), rules_.shortest - length),
                        std::max(Real(0), rules_.reach - length));
    if (change == 0) return;
    handLink_ += change;
    if (handLink_ < rules_.linkLength / 2 && beads_.size() > 1) {
        dropBead(world, hand);
    } else if (handLink_ > rules_.linkLength * Real(1.5)) {
        insertBead(world, hand);
    } else {
        world.setRestLength(handJoint_, handLink_);
        world.setStiffness(handJoint_, handStiffness());
        world.setDamping(handJoint_, handDamping());
    }
}

void Rope::dropBead(sulfur::World& world, sulfur::ParticleId hand) {
    world.remove(world.info(beads_.back()).body);  // and its joints with it
    beads_.pop_back();
    handLink_ += rules_.linkLength;
    tieHand(world, hand);
}

void Rope::insertBead(sulfur::World& world, sulfur::ParticleId hand) {
    const Point last = world.position(beads_.back());
    const Point end = world.position(hand);
    const Vec2 lastVelocity = world.velocity(beads_.back());
    const Vec2 endVelocity = world.velocity(hand);
    const Real part = rules_.linkLength / handLink_;
    world.remove(handJoint_);
    const Point at = last + (end - last) * static_cast<double>(part);
    beads_.push_back(
        addBead(world, at, lastVelocity + (endVelocity - lastVelocity) * part, rules_.radius));
    world.connect(beads_[beads_.size() - 2], beads_.back(),
                  {.stiffness = rules_.stiffness,
                   .damping = rules_.damping,
                   .restLength = rules_.linkLength});
    handLink_ -= rules_.linkLength;
    tieHand(world, hand);
}

/// Without it a hanging hero bobs for half a minute. It brakes the change of the distance between
/// hand and anchor, as far as that differs from the reel's own; a slack rope brakes nothing.
void Rope::damp(sulfur::World& world, sulfur::ParticleId hand, Real wantedRate) const {
    const Vec2 span = (world.position(hand) - world.position(beads_.front())).cast<Real>();
    const Real distance = span.norm();
    if (static_cast<double>(distance) < restLength() || distance <= 0) return;
    const Vec2 along = span / distance;
    const Vec2 relative = world.velocity(hand) - world.velocity(beads_.front());
    const Real damping = reelSpeed_ == 0 ? rules_.axialDamping : rules_.reelDamping;
    const Vec2 force = along * (-damping * (relative.dot(along) - wantedRate));
    world.applyForce(hand, force);
    world.applyForce(beads_.front(), -force);
}

bool Rope::tied(const sulfur::World& world) const {
    return state_ == State::attached && world.contains(anchor_);
}

sulfur::BodyId Rope::hooked(const sulfur::World& world) const {
    if (!tied(world)) return {};
    return world.info(world.info(anchor_).supports.front()).body;
}

void Rope::release(sulfur::World& world) {
    for (const sulfur::ParticleId bead : beads_) {
        if (world.contains(bead)) world.remove(world.info(bead).body);
    }
    *this = Rope(rules_);
}

double Rope::restLength() const {
    if (state_ != State::attached) return 0;
    return static_cast<double>(handLink_) +
           static_cast<double>(rules_.linkLength) * static_cast<double>(beads_.size() - 1);
}

double Rope::tension(const sulfur::World& world) const {
    if (state_ != State::attached) return 0;
    return static_cast<double>(world.info(handJoint_).force);
}

Point Rope::head(const sulfur::World& world) const {
    if (state_ == State::attached) return world.position(beads_.front());
    return moved(flyFrom_, flyDirection_, flown_);
}

std::uint64_t Rope::hash() const {
    Hash hash;
    hash.add(static_cast<std::uint64_t>(state_)).add(flyFrom_).add(flyDirection_).add(flown_);
    for (const sulfur::ParticleId bead : beads_) {
        hash.add(static_cast<std::uint64_t>(bead.index));
    }
    return hash.add(handLink_).add(reelSpeed_).value();
}

}  // namespace quaoar
