// Whoever calls World in any order, with good and bad arguments, finds a sound world afterwards.
#include <algorithm>
#include <functional>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int manyCalls = 12000;  // every one of them costs some ten times as much
#else
constexpr int manyCalls = 100000;
#endif

constexpr std::size_t mostBodies = 12;

/// What may be called: all of it, or only what gives nothing energy.
enum class Calls { all, harmless };

/// Calls a world at random. Everything that it draws comes from its own numbers and from the state
/// of the world, so that the same seed makes the same calls.
class Caller {
public:
    Caller(std::uint64_t seed, bool asks, Calls calls = Calls::all)
        : random_(seed), questions_(seed + 1), asks_(asks) {
        alive_.push_back(
            world_.add(shapes::ground({.points = {{-6, 8}, {-6, 0}, {6, 0}, {6, 8}}})));
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
                      &Caller::tick,
                      &Caller::tick,
                      &Caller::tick};
        else
            calls_ = {&Caller::make,   &Caller::removeSomething,
                      &Caller::weaken, &Caller::tick,
                      &Caller::tick,   &Caller::tick,
                      &Caller::tick,   &Caller::tick};
    }

    World& world() { return world_; }
    int refused() const { return refused_; }
    int accepted() const { return accepted_; }
    int broken() const { return broken_; }

    /// One call. Whatever it is, Error changes nothing.
    void call() {
        const auto which = calls_[random_.below(calls_.size())];
        const auto before = world_.hash();
        try {
            (this->*which)();
            ++accepted_;
        } catch (const Error& error) {
            ++refused_;
            EXPECT_EQ(world_.hash(), before) << error.what();
            EXPECT_GT(std::string(error.what()).size(), 20u);
        }
        if (asks_ && questions_.below(3) == 0) ask();
    }

    /// Expects that everything is finite and that what was there still is.
    void check() {
        ASSERT_EQ(world_.validate(), "");
        for (const BodyId body : world_.bodies())
            for (const ParticleId p : world_.particles(body)) {
                const ParticleInfo info = world_.info(p);
                ASSERT_TRUE(info.body == body && info.position.allFinite());
                ASSERT_TRUE(info.velocity.allFinite());
            }
        for (const ContactInfo& c : world_.contacts()) {
            ASSERT_TRUE(world_.contains(c.a) && world_.contains(c.b));
            ASSERT_TRUE(c.point.allFinite() && std::isfinite(c.friction));
            ASSERT_NEAR(static_cast<double>(c.normal.norm()), 1, 1e-3);
            ASSERT_TRUE(c.impulse > 0 && std::isfinite(c.impulse));
        }
        ASSERT_TRUE(std::isfinite(world_.energy()));
        ASSERT_EQ(std::vector<BodyId>(world_.bodies().begin(), world_.bodies().end()), alive_);
    }

private:
    using Call = void (Caller::*)();

    double real() {
        if (random_.below(40) == 0)
            return std::vector<double>{
                0, -1, NAN, INFINITY, -INFINITY, 1e-30, 3e38}[random_.below(7)];
        if (random_.below(40) == 0) return std::pow(10, random_.uniform(-12, 12));
        return random_.uniform(-5, 5);
    }
    Real number() { return static_cast<Real>(real()); }
    Real positive() { return std::abs(number()); }
    Real fraction() { return random_.below(20) == 0 ? number() : static_cast<Real>(unit()); }
    double unit() { return random_.uniform(0, 1); }
    bool either() { return random_.below(2) == 0; }
    Vec2 vector() { return {number(), number()}; }
    Point place() {
        if (random_.below(50) == 0) return {real(), real()};
        return {random_.uniform(-5.5, 5.5), random_.uniform(0.2, 7)};
    }
    template <class T>
    T oneOf(std::span<const T> list) {
        return list.empty() || random_.below(60) == 0 ? T{} : list[random_.below(list.size())];
    }
    /// Now and then one that is gone.
    BodyId body() { return oneOf<BodyId>(random_.below(30) == 0 ? gone_ : alive_); }
    ParticleId particle() {
        const BodyId id = body();
        return world_.contains(id) ? oneOf(world_.particles(id)) : ParticleId{3, 7};
    }
    JointId joint() {
        const BodyId id = body();
        const auto between = world_.connections();
        if (random_.below(4) == 0) return oneOf<JointId>(between);
        return world_.contains(id) ? oneOf(world_.joints(id)) : JointId{2, 9};
    }
    Material material() {
        const Real kinetic = std::abs(fraction());
        return {kinetic + std::abs(fraction()), kinetic, fraction(), either() ? 0 : number()};
    }
    Filter filter() {
        return {static_cast<std::uint32_t>(1u << random_.below(3)),
                static_cast<std::uint32_t>(random_.bits()),
                static_cast<std::int32_t>(random_.below(4)) - 1};
    }
    Real strength() { return either() ? infinite : static_cast<Real>(random_.uniform(1, 400)); }

    Blueprint plan() {
        const auto size = [&] { return static_cast<Real>(random_.uniform(0.15, 1.2)); };
        const Real s = strength();
        switch (random_.below(11)) {
            case 0:
                return shapes::box({.size = {size(), size()}, .strength = s});
            case 1:
                return shapes::ball({.radius = size() / 3, .mass = positive()});
            case 2:
                return shapes::rope({.to = {0, -size()}, .links = 6, .strength = s});
            case 3:
                return shapes::chain({.to = {size(), 0}, .links = 4, .strength = s});
            case 4:
                return shapes::wheel({.radius = size() / 2, .segments = 8, .strength = s});
            case 5:
                return shapes::jelly(
                    {.size = {size(), size()}, .columns = 3, .rows = 3, .strength = s});
            case 6:
                return shapes::polygon({.points = {{0, 0}, {1, 0}, {1, 1}, {Real(0.5), Real(0.3)}},
                                        .stiffness = either() ? infinite : 2000,
                                        .strength = s});
            case 7:
                return shapes::bridge({.from = {-1, 0}, .to = {1, 0}, .planks = 4, .strength = s});
            case 8:
                return shapes::floor({-size(), 0}, {size(), 0});
            case 9:
                return shapes::box({.size = vector(), .mass = number()});
            default:
                return shapes::ground(
                    {.points = {{0, 0}, {size(), 0}, {0, size()}}, .closed = true});
        }
    }

    void make() {
        if (alive_.size() >= mostBodies) return removeBody();
        Blueprint plan = this->plan();
        if (calls_.size() > 8) {
            if (random_.below(6) == 0) plan.kind = static_cast<BodyKind>(random_.below(3));
            plan.sensor = random_.below(10) == 0;
            plan.selfCollision = random_.below(4) == 0;
            if (random_.below(4) == 0) plan.material = material();
            if (random_.below(6) == 0) plan.filter = filter();
            if (random_.below(6) == 0 && !plan.joints.empty())
                plan.joints[random_.below(plan.joints.size())].material = material();
        }
        const BodyId id = world_.add(plan, {place(), random_.uniform(-4, 4)});
        alive_.push_back(id);
    }
    void removeBody() {
        const BodyId id = body();
        world_.remove(id);
        ASSERT_FALSE(world_.contains(id));
        bury(id);
    }
    void bury(BodyId id) {
        std::erase(alive_, id);
        gone_.push_back(id);
        if (gone_.size() > 50) gone_.erase(gone_.begin());
    }
    void removeSomething() {
        switch (random_.below(calls_.size() > 8 ? 5 : 2)) {
            case 0:
                return removeBody();
            case 1:
                return world_.remove(joint());
            case 2:
                return world_.remove(oneOf<AttachmentId>(world_.attachments()));
            case 3:
                return world_.remove(oneOf<FieldId>(world_.fields()));
            default:
                return world_.release(oneOf<GrabId>(world_.grabs()));
        }
    }
    void weaken() { world_.setStrength(joint(), static_cast<Real>(random_.uniform(1, 100))); }

    void tie() {
        // What is torn together across the room is thrown about, as the caller wanted.
        switch (random_.below(3)) {
            case 0: {
                ConnectOptions options{.stiffness = either() ? infinite : 100 * positive(),
                                       .damping = positive(),
                                       .radius = either() ? 0 : fraction() / 10,
                                       .strength = strength()};
                if (either()) options.restLength = positive();
                if (either()) options.material = material();
                world_.connect(particle(), particle(), options);
                return;
            }
            case 1:
                world_.attach(particle(), body(), vector() / 5);
                return;
            default:
                world_.attach(particle(), joint(), fraction());
        }
    }
    void changeBody() {
        const BodyId id = body();
        switch (random_.below(8)) {
            case 0:
                return world_.setMaterial(id, material());
            case 1:
                return world_.setFilter(id, random_.below(3) == 0 ? filter() : Filter{});
            case 2:
                return world_.setSelfCollision(id, either());
            case 3:
                return world_.setCollision(id, body(), either());
            case 4:
                return world_.setSensor(id, random_.below(4) == 0);
            case 5:
                return world_.setUserData(id, random_.bits());
            case 6:
                return world_.wake(id);
            default:
                return world_.setVelocity(id, vector());
        }
    }
    void changeJoint() {
        const JointId id = joint();
        switch (random_.below(5)) {
            case 0:
                return world_.setStiffness(id, either() ? infinite : 1000 * number());
            case 1:
                return world_.setDamping(id, number());
            case 2:
                return world_.setRestLength(id, number() / 3);
            case 3:
                return world_.setStrength(id, strength());
            default:
                return world_.setMaterial(id, either() ? std::optional(material()) : std::nullopt);
        }
    }
    void changeParticle() {
        const ParticleId id = particle();
        switch (random_.below(4)) {
            case 0:
                return world_.setPinned(id, random_.below(4) == 0);
            case 1:
                return world_.setMass(id, number());
            case 2:
                return world_.setPosition(id, place());
            default:
                return world_.setVelocity(id, 10 * vector());
        }
    }
    void push() {
        if (either()) return world_.applyForce(particle(), 100 * vector());
        world_.applyImpulse(particle(), vector());
    }
    void influence() {
        const auto zone = [&]() -> Zone {
            switch (random_.below(3)) {
                case 0:
                    return Everywhere{};
                case 1:
                    return BoxZone{{-real(), -real()}, {real(), real()}};
                default:
                    return CircleZone{place(), number()};
            }
        };
        const auto field = [&]() -> Field {
            switch (random_.below(3)) {
                case 0:
                    return UniformField{zone(), vector()};
                case 1:
                    return RadialField{place(), number(), static_cast<int>(random_.below(6))};
                default:
                    return WindField{zone(), vector(), positive()};
            }
        };
        const auto fields = world_.fields();
        const auto grabs = world_.grabs();
        switch (random_.below(5)) {
            case 0:
                if (fields.size() > 3) return world_.remove(fields.front());
                world_.add(field());
                return;
            case 1:
                return world_.set(oneOf<FieldId>(fields), field());
            case 2:
                if (grabs.size() > 3) return world_.release(grabs.front());
                world_.grab(particle(), place(), {.frequency = positive()});
                return;
            case 3:
                world_.grab(body(), vector() / 5, place(), {.dampingRatio = number()});
                return;
            default:
                return world_.setTarget(oneOf<GrabId>(grabs), place());
        }
    }
    void changeWorld() {
        switch (random_.below(12)) {
            case 0:
                return world_.setGravity(either() ? Vec2(0, Real(-9.81)) : vector());
            case 1:
                return world_.setAirFriction(number());
            case 2:
                return world_.setTickRate(either() ? 500 : static_cast<int>(100 * real()));
            case 3:
                return world_.setDamper(either() ? Damper::axial : Damper::full);
            default:
                return tick();
        }
    }
    void drive() {
        const BodyId id = body();
        const Point to = place();
        world_.moveTo(id, {to, real()});
    }
    void saveOrRestore() {
        if (random_.below(3) != 0) {
            saved_ = world_.snapshot();
            savedAlive_ = alive_;
            return;
        }
        if (saved_.empty()) return;
        Snapshot bytes = saved_;
        if (either()) bytes.resize(random_.below(bytes.size()));
        world_.restore(bytes);
        if (alive_ != savedAlive_) gone_.clear();  // some of them are back
        alive_ = savedAlive_;
    }
    void tick() {
        world_.step();
        const Events& events = world_.events();
        broken_ += static_cast<int>(events.jointsBroken.size());
        for (const BodySplit& split : events.bodiesSplit) alive_.push_back(split.piece);
        for (const ParticleLost& lost : events.particlesLost) {
            EXPECT_FALSE(world_.contains(lost.particle));
            if (!world_.contains(lost.body)) bury(lost.body);
        }
        for (const ContactBegun& e : events.contactsBegun)
            EXPECT_TRUE(world_.contains(e.a) && world_.contains(e.b));
    }

    /// Questions of every kind: they change nothing.
    void ask() {
        test::Random& q = questions_;
        const auto at = [&] { return Point(q.uniform(-7, 7), q.uniform(-1, 9)); };
        const QueryFilter filter{.sensors = q.below(2) == 0};
        switch (q.below(9)) {
            case 0:
                world_.castSegment(at(), at(), filter);
                break;
            case 1:
                world_.castRay(at(), {1, Real(0.2)}, 20, filter);
                break;
            case 2:
                world_.castAll(at(), at(), filter);
                break;
            case 3:
                world_.castShape(QueryShape::circle(at(), 0.3), {1, -1}, filter);
                break;
            case 4:
                world_.closestPoint(at(), 3, filter);
                break;
            case 5:
                world_.overlap(QueryShape::box(at(), {1, 2}, 0.3), filter);
                break;
            case 6:
                world_.overlapCircle(at(), 1, filter);
                break;
            case 7:
                world_.bodiesAt(at(), filter);
                break;
            default:
                world_.nearestParticle(at(), 2);
        }
    }

    World world_;
    test::Random random_, questions_;
    bool asks_;
    std::vector<Call> calls_;
    std::vector<BodyId> alive_, gone_;
    Snapshot saved_;
    std::vector<BodyId> savedAlive_;
    int refused_ = 0, accepted_ = 0, broken_ = 0;
};

TEST(RandomCalls, KeepTheInvariants) {
    int refused = 0, accepted = 0, broken = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Caller caller(seed, true);
        for (int i = 0; i < manyCalls / 5; ++i) {
            caller.call();
            if (i % 20 == 0) caller.check();
            ASSERT_FALSE(HasFailure()) << "seed " << seed << ", call " << i;
        }
        refused += caller.refused();
        accepted += caller.accepted();
        broken += caller.broken();
    }
    EXPECT_GT(refused, manyCalls / 20);
    EXPECT_GT(accepted, manyCalls / 2);
    EXPECT_GT(broken, manyCalls / 500);
}

/// What falls, breaks and vanishes is never faster than a fall through the room makes it, and what
/// starts inside of other things is only pushed out.
TEST(RandomCalls, BreakingAndRemovingGivesNoEnergy) {
    const double deepest =
        std::sqrt(2 * 9.81 * 12);  // m/s: from the highest place made to the floor
    int broken = 0;
    for (std::uint64_t seed = 31; seed <= 33; ++seed) {
        Caller caller(seed, false, Calls::harmless);
        for (int i = 0; i < 1500; ++i) {
            caller.call();
            const World& world = caller.world();
            for (const BodyId body : world.bodies()) {
                if (world.centreOfMass(body)[1] < -1) continue;  // fell off the room
                ASSERT_LT(static_cast<double>(world.meanVelocity(body).norm()), deepest)
                    << "seed " << seed << ", call " << i << ", " << world.particles(body).size()
                    << " particles";
            }
        }
        caller.check();
        broken += caller.broken();
    }
    EXPECT_GT(broken, 10);
}

/// Neither a second run nor questions in between change anything.
TEST(RandomCalls, GiveTheSameHashAgain) {
    for (std::uint64_t seed = 11; seed <= 12; ++seed) {
        Caller first(seed, false), again(seed, false), asked(seed, true);
        for (int i = 0; i < manyCalls / 50; ++i) {
            for (Caller* caller : {&first, &again, &asked}) caller->call();
            ASSERT_EQ(first.world().hash(), again.world().hash()) << seed << ", call " << i;
            ASSERT_EQ(first.world().hash(), asked.world().hash()) << seed << ", call " << i;
        }
    }
}

/// What was restored goes on as if nothing had been saved, whatever was going on.
TEST(RandomCalls, ASnapshotGoesOnTheSameWay) {
    Caller caller(21, false);
    for (int i = 0; i < manyCalls / 25; ++i) {
        caller.call();
        if (i % 200 != 0) continue;
        World other;
        other.restore(caller.world().snapshot());
        ASSERT_EQ(other.hash(), caller.world().hash()) << "call " << i;
        for (int k = 0; k < 5; ++k) {
            caller.world().step();
            other.step();
            ASSERT_EQ(other.hash(), caller.world().hash()) << "call " << i << ", tick " << k;
        }
    }
}

}  // namespace
}  // namespace sulfur
