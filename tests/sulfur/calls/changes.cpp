// Changes of what there is, and ticks.
#include "calls/caller.hpp"

namespace sulfur::test {

void Caller::tie() {
    // What is torn together across the room is thrown about, as the caller wanted.
    const ParticleId first = particle();
    switch (numbers_->below(3)) {
        case 0: {
            ConnectOptions options;
            options.stiffness = either() ? infinite : 100 * positive();
            options.damping = positive();
            options.radius = either() ? 0 : fraction() / 10;
            options.strength = strength();
            if (either()) options.restLength = positive();
            if (either()) options.material = material();
            world_->connect(first, particle(), options);
            return;
        }
        case 1: {
            const BodyId to = body();
            world_->attach(first, to, vector() / 5);
            return;
        }
        default: {
            const JointId to = joint();
            world_->attach(first, to, fraction());
        }
    }
}

void Caller::changeBody() {
    const BodyId id = body();
    switch (numbers_->below(17)) {
        case 0:
            return world_->setMaterial(id, material());
        case 1:
            return world_->setFilter(id, oneIn(3) ? filter() : Filter{});
        case 2:
            return world_->setSelfCollision(id, either());
        case 3: {
            const BodyId other = body();
            return world_->setCollision(id, other, either());
        }
        case 4:
            return world_->setSensor(id, oneIn(4));
        case 5:
            return world_->setUserData(id, numbers_->bits());
        case 6:
            return world_->wake(id);
        case 7: {
            const Point to = place();
            return world_->setPose(id, {to, real()});
        }
        case 8: {
            const Vec2 linear = vector();
            return world_->setVelocity(id, linear, real());
        }
        case 9:
            return world_->setGravityScale(id, number());
        case 10:
            return world_->setFixedRotation(id, oneIn(3));
        case 11:
            world_->putToSleep(id);
            return;
        case 12:
            return world_->setSleepingAllowed(id, !oneIn(4));
        case 13: {
            const Real linear = number();
            return world_->setDamping(id, linear, number());
        }
        case 14:
            return world_->setEnabled(id, !oneIn(4));
        case 15:
            return world_->setKind(
                id, either() ? BodyKind::dynamic : static_cast<BodyKind>(numbers_->below(3)));
        default:
            return world_->setVelocity(id, vector());
    }
}

void Caller::changeJoint() {
    const JointId id = joint();
    switch (numbers_->below(5)) {
        case 0:
            return world_->setStiffness(id, either() ? infinite : 1000 * number());
        case 1:
            return world_->setDamping(id, number());
        case 2:
            return world_->setRestLength(id, number() / 3);
        case 3:
            return world_->setStrength(id, strength());
        default:
            return world_->setMaterial(id, either() ? std::optional(material()) : std::nullopt);
    }
}

void Caller::changeParticle() {
    const ParticleId id = particle();
    switch (numbers_->below(4)) {
        case 0:
            return world_->setPinned(id, oneIn(4));
        case 1:
            return world_->setMass(id, number());
        case 2:
            return world_->setPosition(id, place());
        default:
            return world_->setVelocity(id, 10 * vector());
    }
}

void Caller::push() {
    if (either()) return pushBody();
    const ParticleId id = particle();
    if (either()) return world_->applyForce(id, 100 * vector());
    world_->applyImpulse(id, vector());
}

void Caller::pushBody() {
    const BodyId id = body();
    const Vec2 push = vector();
    const Point at = place();
    switch (numbers_->below(4)) {
        case 0:
            return world_->applyForce(id, 100 * push, at);
        case 1:
            return world_->applyImpulse(id, push, at);
        case 2:
            return world_->applyTorque(id, 100 * number());
        default:
            return world_->applyAngularImpulse(id, number());
    }
}

Zone Caller::zone() {
    switch (numbers_->below(3)) {
        case 0:
            return Everywhere{};
        case 1: {
            const double left = real(), low = real(), right = real();
            return BoxZone{{-left, -low}, {right, real()}};
        }
        default: {
            const Point centre = place();
            return CircleZone{centre, number()};
        }
    }
}

Field Caller::field() {
    switch (numbers_->below(3)) {
        case 0:
            return UniformField{.zone = zone(), .acceleration = vector()};
        case 1: {
            RadialField field{.centre = place(), .strength = number()};
            field.falloff = static_cast<int>(numbers_->below(6));
            if (oneIn(4)) field.core = positive();
            if (oneIn(4)) field.reach = number();
            return field;
        }
        default:
            return WindField{.zone = zone(), .velocity = vector(), .drag = positive()};
    }
}

void Caller::influence() {
    const auto fields = world_->fields();
    const auto grabs = world_->grabs();
    switch (numbers_->below(5)) {
        case 0:
            if (fields.size() > 3) return world_->remove(fields.front());
            world_->add(field());
            return;
        case 1: {
            const FieldId id = oneOf(fields);
            return world_->set(id, field());
        }
        case 2: {
            if (grabs.size() > 3) return world_->release(grabs.front());
            const ParticleId id = particle();
            const Point to = place();
            world_->grab(id, to, {.frequency = positive()});
            return;
        }
        case 3: {
            const BodyId id = body();
            const Vec2 at = vector() / 5;
            const Point to = place();
            GrabOptions options{.dampingRatio = number()};
            if (oneIn(3)) options.maxForce = number();
            world_->grab(id, at, to, options);
            return;
        }
        default: {
            const GrabId id = oneOf(grabs);
            return world_->setTarget(id, place());
        }
    }
}

void Caller::changeWorld() {
    switch (numbers_->below(12)) {
        case 0:
            return world_->setGravity(either() ? Vec2(0, Real(-9.81)) : vector());
        case 1:
            return world_->setAirFriction(number());
        case 2:
            // What is no int must not become one.
            return world_->setTickRate(
                either() ? 500 : static_cast<int>(std::fmin(std::fmax(100 * real(), -1e6), 1e6)));
        case 3:
            return world_->setDamper(either() ? Damper::axial : Damper::full);
        case 4:
            // Neither is part of the state: who does not ask lends no threads.
            if (const bool lent = either(); asks_) world_->setTasks(lent ? &tasks_ : nullptr);
            return;
        case 5:
            if (const bool on = either(); asks_) world_->setProfiling(on);
            return;
        default:
            return tick();
    }
}

void Caller::drive() {
    const BodyId id = body();
    const Point to = place();
    world_->moveTo(id, {to, real()});
}

void Caller::saveOrRestore() {
    if (!oneIn(3)) {
        saved_ = world_->snapshot();
        savedAlive_ = alive_;
        return;
    }
    if (!saved_.empty()) restore();
}

void Caller::restore() {
    Snapshot bytes = saved_;
    bool damaged = false;
    switch (numbers_->below(4)) {
        case 0:
            bytes.resize(numbers_->below(bytes.size()));
            damaged = true;
            break;
        case 1: {
            std::byte& chosen = bytes[numbers_->below(bytes.size())];
            chosen ^= static_cast<std::byte>(1 + numbers_->below(255));
            damaged = true;
            break;
        }
        default:
            break;
    }
    world_->restore(bytes);
    require(!damaged, "a damaged snapshot is refused");
    if (alive_ != savedAlive_) gone_.clear();  // some of them are back
    alive_ = savedAlive_;
}

void Caller::tick() {
    step();
    const Events& events = world_->events();
    broken_ += static_cast<int>(events.jointsBroken.size());
    for (const BodySplit& split : events.bodiesSplit) alive_.push_back(split.piece);
    for (const ParticleLost& lost : events.particlesLost) {
        require(!world_->contains(lost.particle), "a lost particle is gone");
        if (!world_->contains(lost.body)) bury(lost.body);
    }
    checkEvents();
}

void Caller::checkEvents() {
    const auto require2 = [&](BodyId a, BodyId b) {
        require(world_->contains(a) && world_->contains(b), "an event is of bodies that there are");
    };
    for (const ContactBegun& e : world_->events().contactsBegun) require2(e.a, e.b);
}

}  // namespace sulfur::test
