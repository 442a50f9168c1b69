// Callbacks, what they answer and throw, and worlds that are cloned.
#include "calls/caller.hpp"

namespace sulfur::test {

namespace {

/// The same for the same two, whoever asks.
std::uint64_t mixed(std::uint64_t answers, BodyId a, BodyId b) {
    std::uint64_t x = answers ^ (std::uint64_t{a.index} << 32 | b.index);
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

void lookAt(const World& world, BodyId id) {
    require(world.contains(id), "callbacks are asked about bodies");
    require(world.centreOfMass(id).allFinite() && world.meanVelocity(id).allFinite(),
            "bodies move finitely in the middle of a tick");
    const Bounds bounds = world.bounds(id);
    require((bounds.low.array() <= bounds.high.array()).all(), "bodies have bounds in a tick");
}

}  // namespace

void Caller::setCallbacks() {
    asksShouldCollide_ = oneIn(3);
    asksPreSolve_ = either();
    misbehaves_ = oneIn(3);
    answers_ = numbers_->bits();
    lendCallbacks();
}

/// Callbacks are no part of the state: a world that takes the place of another one gets them anew.
void Caller::lendCallbacks() {
    world_->setShouldCollide({});
    world_->setPreSolve({});
    if (asksShouldCollide_)
        world_->setShouldCollide([this](BodyId a, BodyId b) { return answerShouldCollide(a, b); });
    if (asksPreSolve_)
        world_->setPreSolve([this](const PreSolveContact& contact, Material& surface) {
            return answerPreSolve(contact, surface);
        });
}

bool Caller::answerShouldCollide(BodyId a, BodyId b) {
    require(a < b, "the smaller handle comes first");
    require(world_->collision(a, b), "nobody is asked about who must not collide");
    lookAt(*world_, a);
    lookAt(*world_, b);
    const auto bits = mixed(answers_, a, b);
    misbehave(bits >> 8);
    return bits % 4 != 0;
}

bool Caller::answerPreSolve(const PreSolveContact& contact, Material& surface) {
    require(contact.a < contact.b, "the smaller handle comes first");
    require(contact.point.allFinite() && std::isfinite(contact.speed) && std::isfinite(contact.gap),
            "contacts are finite before they are solved");
    require(std::abs(static_cast<double>(contact.normal.norm()) - 1) < 1e-3,
            "normals are of length 1 before they are solved");
    lookAt(*world_, contact.a);
    lookAt(*world_, contact.b);
    const auto bits = mixed(answers_ + world_->ticks(), contact.a, contact.b);
    misbehave(bits >> 16);
    if (bits % 4 == 1) surface.kineticFriction = surface.staticFriction = Real(0.1);
    if (bits % 4 == 2) surface.restitution = Real(0.8);
    if (bits % 4 == 3) surface.surfaceSpeed = static_cast<Real>(bits >> 8 & 7u) - 3;
    if (misbehaves_ && (bits >> 32) % 64 == 0) {
        surface.restitution = -1;
        hasMisbehaved_ = true;
    }
    return (bits >> 12) % 4 != 0;
}

/// Tries to change the world; now and then throws.
void Caller::misbehave(std::uint64_t bits) {
    if (!misbehaves_ || bits % 16 != 0) return;
    try {
        world_->setGravity({0, 0});
        require(false, "a callback cannot change the world");
    } catch (const Error& error) {
        require(error.code() == ErrorCode::inCallback, "who changes the world is told why not");
    }
    if (bits / 16 % 4 != 0) return;
    hasMisbehaved_ = true;
    throw Refusal("a callback throws");
}

/// What callbacks throw comes out of a whole tick.
void Caller::step() {
    hasMisbehaved_ = false;
    const auto before = world_->ticks();
    try {
        world_->step();
    } catch (const BrokenPromise&) {
        throw;
    } catch (const std::exception&) {
        if (!hasMisbehaved_) throw;
        hasMisbehaved_ = false;
        require(world_->ticks() == before + 1, "a tick whose callback threw is a whole one");
    }
    require(!hasMisbehaved_, "what a callback throws comes out of the tick");
}

/// A clone is in the same state, and goes on in its place or beside it.
void Caller::clone() {
    auto copy = std::make_unique<World>(world_->clone());
    require(copy->hash() == world_->hash(), "a clone is in the same state");
    require(copy->validate().empty(), "a clone is sound");
    const bool goesOn = either();
    if (goesOn) {
        world_ = std::move(copy);
        lendCallbacks();
        return;
    }
    if (asks_) copy->step();
    if (asks_ && !asksShouldCollide_ && !asksPreSolve_) {
        World same = world_->clone();
        same.step();
        require(copy->hash() == same.hash(), "clones go on to the same bits");
    }
}

}  // namespace sulfur::test
