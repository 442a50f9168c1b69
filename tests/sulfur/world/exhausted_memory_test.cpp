// Whatever call of World cannot get memory throws, and leaves the world as it was; after a tick the
// world says that it is torn.
//
// This program replaces operator new, and malloc where the C library is glibc and no sanitizer
// stands in its place: there Eigen takes its memory. The n-th allocation of a call fails, for
// every n until the call succeeds; alone, or with all that follow it.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <sulfur/sulfur.hpp>

#include "builds/every_feature.hpp"

namespace {

/// Which allocations fail.
struct Shortage {
    bool on = false, lasts = false;
    std::size_t taken = 0, first = 0;

    bool hits() {
        if (!on) return false;
        ++taken;
        return lasts ? taken >= first : taken == first;
    }
};
Shortage shortage;

}  // namespace

#if defined(__GLIBC__) && !defined(SULFUR_SANITIZED)
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT: glibc's own name
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT: glibc's own name

void* malloc(std::size_t size) {
    if (!shortage.hits()) return __libc_malloc(size);
    errno = ENOMEM;
    return nullptr;
}
}

namespace {
void* takeMemory(std::size_t size) {
    return std::malloc(size);
}
void* takeMemory(std::size_t size, std::align_val_t alignment) {
    return shortage.hits() ? nullptr : __libc_memalign(static_cast<std::size_t>(alignment), size);
}
}  // namespace
#else
namespace {
void* takeMemory(std::size_t size) {
    return shortage.hits() ? nullptr : std::malloc(size == 0 ? 1 : size);
}
void* takeMemory(std::size_t size, std::align_val_t alignment) {
    const auto to = static_cast<std::size_t>(alignment);
    return shortage.hits() ? nullptr : std::aligned_alloc(to, (size + to - 1) / to * to);
}
}  // namespace
#endif

void* operator new(std::size_t size) {
    if (void* memory = takeMemory(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    if (void* memory = takeMemory(size, alignment)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return takeMemory(size);
}
// The sanitizers have these too.
void* operator new[](std::size_t size) {
    return operator new(size);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace sulfur {
namespace {

using Call = std::function<void(World&)>;

/// A world as it was saved.
std::unique_ptr<World> copyOf(const Snapshot& saved) {
    auto world = std::make_unique<World>();
    world->restore(saved);
    return world;
}

/// Whether the call fails for want of memory when its n-th allocation does.
bool fails(World& world, const Call& call, std::size_t n, bool lasts) {
    shortage = {.on = true, .lasts = lasts, .first = n};
    try {
        call(world);
        shortage.on = false;
        return false;
    } catch (const std::bad_alloc&) {
        shortage.on = false;
    } catch (const Error& error) {
        shortage.on = false;
        EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::outOfMemory))
            << error.what();
    }
    return true;
}

/// After the call and some ticks.
std::uint64_t goOn(World& world, const Call& call) {
    call(world);
    for (int i = 0; i < 3; ++i) world.step();
    return world.hash();
}

/// All of the first allocations, then fewer and fewer.
std::size_t after(std::size_t n) {
    return n < 200 ? n + 1 : n + n / 20;
}

/// Calls f(world, n) for worlds of which the call has failed.
template <class Function>
void forEachFailure(const Snapshot& saved, const Call& call, Function&& f) {
    for (const bool lasts : {false, true})
        for (std::size_t n = 1;; n = after(n)) {
            const auto world = copyOf(saved);
            if (fails(*world, call, n, lasts))
                ASSERT_NO_FATAL_FAILURE(f(*world, n));
            else if (shortage.taken < n)
                break;
        }
}

/// Expects that a call that fails changes nothing.
void expectAllOrNothing(const Snapshot& saved, const Call& call) {
    const auto twin = copyOf(saved);
    const auto before = twin->hash(), afterwards = goOn(*twin, call);
    forEachFailure(saved, call, [&](World& world, std::size_t n) {
        ASSERT_EQ(world.hash(), before) << "allocation " << n;
        ASSERT_EQ(world.validate(), "") << "allocation " << n;
        ASSERT_TRUE(world.snapshot() == saved) << "allocation " << n;
        ASSERT_EQ(goOn(world, call), afterwards) << "allocation " << n;
    });
}

/// Expects that a world refuses a call because it is in the middle of a tick.
template <class Function>
void expectTorn(Function&& call) {
    try {
        call();
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::outOfMemory))
            << error.what();
    }
}

/// A world in which everything moves, and one in which everything sleeps.
class ExhaustedMemory : public testing::TestWithParam<bool> {
protected:
    void SetUp() override {
        if (GetParam())
            buildSleepers();
        else
            buildEveryFeature();
    }
    void buildEveryFeature() {
        scene_ = std::make_unique<test::EveryFeature>(Friction::coulomb);
        for (int t = 0; t < 30; ++t) scene_->tick(t);
        saved_ = scene_->world().snapshot();
        world_ = &scene_->world();
    }
    void buildSleepers() {
        sleepers_ = std::make_unique<World>(WorldSettings{.airFriction = 1});
        sleepers_->add(shapes::floor({-20, 0}, {20, 0}));
        for (int i = 0; i < 12; ++i)
            sleepers_->add(shapes::box(),
                           {.position = {1.05 * (i % 4) - 3, 0.56 + 1.01 * (i / 4)}});
        const Body crate = sleepers_->body(sleepers_->bodies()[1]);
        const Body rope = sleepers_->add(
            shapes::rope({.from = {4, 4}, .to = {4, 2}, .links = 6, .pinFirst = true}));
        const Body weight =
            sleepers_->add(shapes::box({.size = {Real(0.4), Real(0.4)}}), {.position = {4, 1.8}});
        sleepers_->attach(rope.back(), weight, {0, Real(0.2)});
        const Body ball = sleepers_->add(shapes::ball(), {.position = {8, 0.3}});
        sleepers_->connect(ball.front(), crate.front(), {.stiffness = 1, .restLength = Real(10)});
        for (int t = 0; t < 6000; ++t) sleepers_->step();
        saved_ = sleepers_->snapshot();
        world_ = sleepers_.get();
    }

    /// By the order in which they were made.
    BodyId body(std::size_t i) const { return world_->bodies()[i]; }
    ParticleId particle(std::size_t i) const { return world_->particles(body(i)).front(); }
    JointId joint(std::size_t i) const { return world_->joints(body(i)).front(); }
    BodyId kinematic() const {
        for (const BodyId id : world_->bodies())
            if (world_->kind(id) == BodyKind::kinematic) return id;
        return {};
    }
    void expectAllOrNothing(const Call& call) { sulfur::expectAllOrNothing(saved_, call); }

    Snapshot saved_;
    const World* world_ = nullptr;

private:
    std::unique_ptr<test::EveryFeature> scene_;
    std::unique_ptr<World> sleepers_;
};

#ifdef SULFUR_SANITIZED
constexpr bool worlds[] = {true};  // the other one takes minutes
#else
constexpr bool worlds[] = {false, true};
#endif

INSTANTIATE_TEST_SUITE_P(Of, ExhaustedMemory, testing::ValuesIn(worlds), [](const auto& sleeps) {
    return std::string(sleeps.param ? "sleepers" : "every_feature");
});

TEST_P(ExhaustedMemory, SleepersSleep) {
    if (!GetParam()) return;
    for (const BodyId id : world_->bodies())
        EXPECT_TRUE(world_->asleep(id) || world_->kind(id) == BodyKind::fixed);
}

TEST_P(ExhaustedMemory, AddingABody) {
    const auto adding = [](const Blueprint& plan, const Point& place) {
        return [=](World& w) { w.add(plan, {.position = place}); };
    };
    expectAllOrNothing(adding(shapes::jelly(), {0, 20}));
    expectAllOrNothing(adding(shapes::box(), {0, 1}));
    expectAllOrNothing(adding(shapes::floor({-9, 1}, {9, 1}), {0, 0}));
    Blueprint plan = shapes::box();
    plan.name = "a name so long that it does not fit where short ones do";
    plan.skin =
        Skin{.texture = plan.name, .uv = std::vector<Vec2>(plan.particles.size(), Vec2{0, 0})};
    expectAllOrNothing(adding(plan, {0, 9}));
}

TEST_P(ExhaustedMemory, RemovingABody) {
    // In the large world one of each kind, and what is tied.
    const auto bodies = world_->bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (GetParam() || i < 10 || i > 25)
            expectAllOrNothing([id = bodies[i]](World& w) { w.remove(id); });
}

TEST_P(ExhaustedMemory, RemovingWhatTies) {
    expectAllOrNothing([id = joint(2)](World& w) { w.remove(id); });
    expectAllOrNothing([id = world_->connections().front()](World& w) { w.remove(id); });
    expectAllOrNothing([id = world_->attachments().front()](World& w) { w.remove(id); });
}

TEST_P(ExhaustedMemory, Tying) {
    const ParticleId p = particle(2), q = particle(3);
    expectAllOrNothing([=](World& w) { w.connect(p, q, {.radius = Real(0.02)}); });
    expectAllOrNothing([=](World& w) { w.connect(w.particles(w.bodies()[2])[1], p); });
    expectAllOrNothing([=, id = body(3)](World& w) { w.attach(p, id, {Real(0.1), 0}); });
    expectAllOrNothing([=, id = joint(5)](World& w) { w.attach(p, id, Real(0.5)); });
}

TEST_P(ExhaustedMemory, ChangingBodies) {
    const BodyId id = body(2), other = body(3);
    expectAllOrNothing([=](World& w) { w.setMaterial(id, {.restitution = 1}); });
    expectAllOrNothing([=](World& w) { w.setFilter(id, {.category = 2, .mask = 1}); });
    expectAllOrNothing([=](World& w) { w.setSelfCollision(id, true); });
    expectAllOrNothing([=](World& w) { w.setCollision(id, other, false); });
    expectAllOrNothing([=](World& w) { w.setSensor(id, true); });
    expectAllOrNothing([=](World& w) { w.setUserData(id, 7); });
    expectAllOrNothing([=](World& w) { w.setVelocity(id, {1, 2}); });
    expectAllOrNothing([=](World& w) { w.wake(id); });
    expectAllOrNothing([=](World& w) { w.setSleepingAllowed(id, false); });
    expectAllOrNothing([=](World& w) { w.putToSleep(id); });
    expectAllOrNothing([=](World& w) { w.setVelocity(id, {1, 2}, 3); });
    expectAllOrNothing([=](World& w) { w.setGravityScale(id, 2); });
    expectAllOrNothing([=](World& w) { w.setDamping(id, 1, 2); });
    expectAllOrNothing([=](World& w) { w.setFixedRotation(id, true); });
    expectAllOrNothing([=](World& w) { w.setPose(id, {.position = {3, 5}, .angle = 1}); });
    expectAllOrNothing([fixed = body(0)](World& w) { w.setPose(fixed, {.angle = 1}); });
}

TEST_P(ExhaustedMemory, PushingBodies) {
    for (const BodyId id : {body(2), body(3), world_->bodies().back()}) {
        expectAllOrNothing([=](World& w) { w.applyForce(id, {1, 2}, {0, 1}); });
        expectAllOrNothing([=](World& w) { w.applyImpulse(id, {1, 2}, {0, 1}); });
        expectAllOrNothing([=](World& w) { w.applyTorque(id, 2); });
        expectAllOrNothing([=](World& w) { w.applyAngularImpulse(id, 2); });
    }
    // A disc that no tick has found yet.
    World other;
    const BodyId ball = other.add(shapes::ball());
    const auto saved = other.snapshot();
    sulfur::expectAllOrNothing(saved, [=](World& w) { w.applyAngularImpulse(ball, 2); });
    sulfur::expectAllOrNothing(saved, [=](World& w) { w.applyTorque(ball, 2); });
    sulfur::expectAllOrNothing(saved, [=](World& w) { w.setVelocity(ball, {1, 0}, 2); });
}

TEST_P(ExhaustedMemory, ChangingJoints) {
    const JointId id = joint(2);
    expectAllOrNothing([=](World& w) { w.setStiffness(id, 1000); });
    expectAllOrNothing([=](World& w) { w.setDamping(id, 3); });
    expectAllOrNothing([=](World& w) { w.setRestLength(id, Real(0.9)); });
    expectAllOrNothing([=](World& w) { w.setStrength(id, 3); });
    expectAllOrNothing([=](World& w) { w.setMaterial(id, Material{.restitution = 1}); });
}

TEST_P(ExhaustedMemory, ChangingParticles) {
    const ParticleId id = particle(2);
    expectAllOrNothing([=](World& w) { w.setPinned(id, true); });
    expectAllOrNothing([=](World& w) { w.setMass(id, 3); });
    expectAllOrNothing([=](World& w) { w.setPosition(id, {0, 3}); });
    expectAllOrNothing([=](World& w) { w.setVelocity(id, {0, 3}); });
    expectAllOrNothing([=](World& w) { w.applyForce(id, {0, 3}); });
    expectAllOrNothing([=](World& w) { w.applyImpulse(id, {0, 3}); });
    expectAllOrNothing([p = particle(0)](World& w) { w.setPosition(p, {0, 3}); });
}

TEST_P(ExhaustedMemory, FieldsAndGrabs) {
    expectAllOrNothing([](World& w) { w.add(UniformField{.acceleration = {1, 1}}); });
    expectAllOrNothing([id = particle(2)](World& w) { w.grab(id, {0, 3}); });
    expectAllOrNothing([id = body(2)](World& w) { w.grab(id, {Real(0.1), 0}, {0, 3}); });
    if (GetParam()) return;
    const FieldId field = world_->fields().front();
    expectAllOrNothing([=](World& w) { w.set(field, UniformField{}); });
    expectAllOrNothing([=](World& w) { w.remove(field); });
    const GrabId grab = world_->grabs().front();
    expectAllOrNothing([=](World& w) { w.setTarget(grab, {0, 3}); });
    expectAllOrNothing([=](World& w) { w.release(grab); });
}

TEST_P(ExhaustedMemory, ChangingTheWorld) {
    expectAllOrNothing([](World& w) { w.setGravity({1, 1}); });
    expectAllOrNothing([](World& w) { w.setAirFriction(Real(0.3)); });
    expectAllOrNothing([](World& w) { w.setTickRate(240); });
    expectAllOrNothing([](World& w) { w.setDamper(Damper::full); });
    if (!GetParam())
        expectAllOrNothing([id = kinematic()](World& w) { w.moveTo(id, {.position = {1, 1}}); });
}

TEST_P(ExhaustedMemory, SavingAndRestoring) {
    expectAllOrNothing([](World& w) { w.snapshot(); });
    World other;
    other.add(shapes::box());
    other.step();
    expectAllOrNothing([saved = other.snapshot()](World& w) { w.restore(saved); });
}

/// A tick that gets no memory says so, and so does the world until it is restored.
TEST_P(ExhaustedMemory, Ticks) {
    const auto step = [](World& w) { w.step(); };
    const auto twin = copyOf(saved_);
    const auto before = twin->hash(), afterwards = goOn(*twin, step);
    const BodyId id = body(2);
    std::size_t failures = 0;
    forEachFailure(saved_, step, [&](World& world, std::size_t n) {
        ++failures;
        ASSERT_NE(world.validate(), "") << "allocation " << n;
        expectTorn([&] { world.step(); });
        expectTorn([&] { world.hash(); });
        expectTorn([&] { world.snapshot(); });
        expectTorn([&] { world.bodies(); });
        expectTorn([&] { world.setVelocity(id, {0, 0}); });
        expectTorn([&] { world.castRay({0, 9}, {0, -1}, 20); });
        world.restore(saved_);
        ASSERT_EQ(world.hash(), before) << "allocation " << n;
        ASSERT_EQ(goOn(world, step), afterwards) << "allocation " << n;
    });
    EXPECT_GT(failures, 10u);
}

TEST_P(ExhaustedMemory, Looking) {
    const BodyId id = body(2);
    expectAllOrNothing([](World& w) { w.castRay({0, 9}, {0, -1}, 20); });
    expectAllOrNothing([](World& w) { w.castAll({-9, 1}, {9, 1}); });
    expectAllOrNothing([](World& w) { w.castShape(QueryShape::circle({0, 9}, 1), {0, -9}); });
    expectAllOrNothing([](World& w) { w.closestPoint({0, 3}, 4); });
    expectAllOrNothing([](World& w) { w.overlapCircle({0, 1}, 3); });
    expectAllOrNothing([](World& w) { w.bodiesAt({0, 1}); });
    expectAllOrNothing([](World& w) { w.nearestParticle({0, 1}, 3); });
    expectAllOrNothing([](World& w) { w.contacts(); });
    expectAllOrNothing([=](World& w) { w.visitors(id); });
    expectAllOrNothing([](World& w) {
        for (const BodyId each : w.bodies()) w.angularVelocity(each);
    });
    expectAllOrNothing([](World& w) {
        DebugDraw nobody;
        w.draw(nobody);
    });
}

}  // namespace
}  // namespace sulfur
