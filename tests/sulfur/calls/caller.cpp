// What is called next, and what must be true then.
#include "calls/caller.hpp"

#include <algorithm>

namespace sulfur::test {

namespace {

constexpr std::size_t mostBodies = 12;

}  // namespace

Caller::Caller(std::unique_ptr<Numbers> numbers, bool asks, Calls calls)
    : numbers_(std::move(numbers)), asks_(asks), allowed_(calls) {
    if (calls == Calls::all)
        calls_ = {&Caller::make,
                  &Caller::make,
                  &Caller::removeSomething,
                  &Caller::tie,
                  &Caller::changeBody,
                  &Caller::changeJoint,
                  &Caller::changeParticle,
                  &Caller::push,
                  &Caller::influence,
                  &Caller::changeWorld,
                  &Caller::drive,
                  &Caller::saveOrRestore,
                  &Caller::setCallbacks,
                  &Caller::clone,
                  &Caller::tick,
                  &Caller::tick,
                  &Caller::tick,
                  &Caller::tick};
    else
        calls_ = {&Caller::make,   &Caller::removeSomething,
                  &Caller::weaken, &Caller::tick,
                  &Caller::tick,   &Caller::tick,
                  &Caller::tick,   &Caller::tick};
    try {
        world_ = std::make_unique<World>(calls == Calls::all ? settings() : WorldSettings{});
    } catch (const Error&) {
        ++refused_;
        world_ = std::make_unique<World>();
    }
    alive_.push_back(world_->add(shapes::ground({.points = {{-6, 8}, {-6, 0}, {6, 0}, {6, 8}}})));
}

Caller::Caller(std::uint64_t seed, bool asks, Calls calls)
    : Caller(std::make_unique<SeededNumbers>(seed), asks, calls) {}

std::unique_ptr<Caller> Caller::twin(bool asks) const {
    auto other = std::make_unique<Caller>(numbers_->clone(), asks, allowed_);
    other->numbers_ = numbers_->clone();  // those that making it has used up
    other->world_ = std::make_unique<World>();
    other->world_->restore(world_->snapshot());
    other->asksShouldCollide_ = asksShouldCollide_;
    other->asksPreSolve_ = asksPreSolve_;
    other->answers_ = answers_;
    other->misbehaves_ = misbehaves_;
    other->lendCallbacks();
    other->alive_ = alive_;
    other->gone_ = gone_;
    other->saved_ = saved_;
    other->savedAlive_ = savedAlive_;
    return other;
}

void Caller::call() {
    const auto which = calls_[numbers_->below(calls_.size())];
    const auto before = world_->hash();
    try {
        (this->*which)();
        ++accepted_;
    } catch (const Error& error) {
        ++refused_;
        require(world_->hash() == before,
                std::string("a refused call changes nothing: ") + error.what());
        require(std::string(error.what()).size() > 20, "an error says what is wrong");
    }
    if (allowed_ == Calls::all && oneIn(3)) ask();
}

void Caller::check() {
    const std::string broken = world_->validate();
    require(broken.empty(), "the world is sound: " + broken);
    for (const BodyId body : world_->bodies())
        for (const ParticleId p : world_->particles(body)) {
            const ParticleInfo info = world_->info(p);
            require(info.body == body, "a particle knows its body");
            require(info.position.allFinite() && info.velocity.allFinite(), "motion is finite");
        }
    for (const ContactInfo& c : world_->contacts()) {
        require(world_->contains(c.a) && world_->contains(c.b), "a contact is of bodies");
        require(c.point.allFinite() && std::isfinite(c.friction), "contacts are finite");
        require(std::abs(static_cast<double>(c.normal.norm()) - 1) < 1e-3,
                "normals are of length 1");
        require(c.impulse > 0 && std::isfinite(c.impulse), "contacts push");
    }
    require(std::isfinite(world_->energy()), "energy is finite");
    require(
        std::equal(alive_.begin(), alive_.end(), world_->bodies().begin(), world_->bodies().end()),
        "the bodies are those that were added");
}

// --- what is drawn -------------------------------------------------------------------------

double Caller::real() {
    if (oneIn(40)) {
        constexpr double odd[] = {0,     -1,     NAN,  INFINITY, -INFINITY, 1e-30, 3e38,
                                  1e-41, 4e-320, -0.0, 1e9,      -1e7,      1e12,  2000};
        return odd[numbers_->below(allowed_ == Calls::all ? std::size(odd) : 7)];
    }
    if (oneIn(40)) return std::pow(10, numbers_->uniform(-12, 12));
    return numbers_->uniform(-5, 5);
}

Vec2 Caller::vector() {
    const Real x = number();
    return {x, number()};
}

std::vector<Vec2> Caller::vectors(std::size_t fewerThan) {
    std::vector<Vec2> list(numbers_->below(fewerThan));
    for (Vec2& one : list) one = vector();
    return list;
}

Point Caller::place() {
    if (oneIn(50)) {
        const double x = real();
        return {x, real()};
    }
    const double x = numbers_->uniform(-5.5, 5.5);
    return {x, numbers_->uniform(0.2, 7)};
}

BodyId Caller::body() {
    return oneOf(oneIn(30) ? gone_ : alive_);
}

ParticleId Caller::particle() {
    const BodyId id = body();
    return world_->contains(id) ? oneOf(world_->particles(id)) : ParticleId{3, 7};
}

JointId Caller::joint() {
    const BodyId id = body();
    const auto between = world_->connections();
    if (oneIn(4)) return oneOf(between);
    return world_->contains(id) ? oneOf(world_->joints(id)) : JointId{2, 9};
}

Material Caller::material() {
    const Real kinetic = std::abs(fraction());
    const Real more = std::abs(fraction()), restitution = fraction();
    const Real speed = either() ? 0 : number();
    return {kinetic + more, kinetic, restitution, speed, oneIn(3) ? number() : 0};
}

Filter Caller::filter() {
    const auto category = static_cast<std::uint32_t>(1u << numbers_->below(3));
    const auto mask = static_cast<std::uint32_t>(numbers_->bits());
    return {category, mask, static_cast<std::int32_t>(numbers_->below(4)) - 1};
}

WorldSettings Caller::settings() {
    WorldSettings chosen;
    if (oneIn(4)) chosen.gravity = vector();
    if (oneIn(4)) chosen.airFriction = number();
    constexpr int rates[] = {60, 120, 479, 480, 1000, 10000, 0, -1, 10001};
    if (oneIn(4)) chosen.tickRate = rates[numbers_->below(std::size(rates))];
    chosen.sleeping = !oneIn(8);
    if (oneIn(4)) chosen.damper = Damper::full;
    if (oneIn(4)) chosen.friction = Friction::sliding;
    chosen.tellPersisting = either();
    if (oneIn(4)) chosen.sleepSpeed = number();
    if (oneIn(4)) chosen.reboundSpeed = number();
    if (oneIn(4)) chosen.sweeps = static_cast<int>(numbers_->below(12));
    return chosen;
}

// --- bodies --------------------------------------------------------------------------------

void Caller::make() {
    if (alive_.size() >= mostBodies) return removeBody();
    Blueprint plan = this->plan();
    if (allowed_ == Calls::all) disturb(plan);
    const Point at = place();
    alive_.push_back(world_->add(plan, {at, numbers_->uniform(-4, 4)}));
}

void Caller::removeBody() {
    const BodyId id = body();
    world_->remove(id);
    require(!world_->contains(id), "what was removed is gone");
    bury(id);
}

void Caller::bury(BodyId id) {
    std::erase(alive_, id);
    gone_.push_back(id);
    if (gone_.size() > 50) gone_.erase(gone_.begin());
}

void Caller::removeSomething() {
    switch (numbers_->below(allowed_ == Calls::all ? 5 : 2)) {
        case 0:
            return removeBody();
        case 1:
            return world_->remove(joint());
        case 2:
            return world_->remove(oneOf(world_->attachments()));
        case 3:
            return world_->remove(oneOf(world_->fields()));
        default:
            return world_->release(oneOf(world_->grabs()));
    }
}

void Caller::weaken() {
    const auto limit = static_cast<Real>(numbers_->uniform(1, 100));
    world_->setStrength(joint(), limit);
}

int callBesideATwin(std::unique_ptr<Numbers> numbers, int mostCalls) {
    auto twin = std::make_unique<Caller>(numbers->clone(), false);
    Caller caller(std::move(numbers), true);
    int calls = 0;
    for (; calls < mostCalls && !caller.done(); ++calls) {
        caller.call();
        twin->call();
        require(caller.world().hash() == twin->world().hash(), "the same calls give the same bits");
        if (calls % 16 == 15) caller.check();
        if (calls % 40 == 39) twin = caller.twin(false);
    }
    caller.check();
    return calls;
}

}  // namespace sulfur::test
