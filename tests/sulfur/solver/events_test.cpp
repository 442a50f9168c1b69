#include <algorithm>
#include <tuple>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

double lengthOf(const Vec2& v) {
    return static_cast<double>(v.norm());
}

bool isOf(const auto& event, BodyId p, BodyId q) {
    return (event.a == p && event.b == q) || (event.a == q && event.b == p);
}

WorldSettings telling() {
    WorldSettings settings;
    settings.tellPersisting = true;
    return settings;
}

/// N s that two bodies gave each other in the last tick, as the events tell it.
double impulseOf(const World& world, BodyId p, BodyId q) {
    double sum = 0;
    for (const auto& e : world.events().contactsBegun)
        if (isOf(e, p, q)) sum += static_cast<double>(e.impulse);
    for (const auto& e : world.events().contactsPersisted)
        if (isOf(e, p, q)) sum += static_cast<double>(e.impulse);
    return sum;
}

/// A ball that falls on a floor.
struct Landing {
    World world{telling()};
    Body floor = world.add(shapes::floor({-5, 0}, {5, 0}, Real(0.1)));
    Body ball;

    explicit Landing(Real restitution = 0, Real mass = 3) {
        ball = world.add(
            shapes::ball(
                {.radius = Real(0.2), .mass = mass, .material = {.restitution = restitution}}),
            {.position = {1, 1.301}});
    }
    /// Runs until they touch.
    ContactBegun fall() {
        for (int i = 0; i < 1000; ++i) {
            world.step();
            if (!world.events().contactsBegun.empty()) return world.events().contactsBegun[0];
        }
        ADD_FAILURE() << "never landed";
        return {};
    }
};

TEST(ContactEvents, BeginTellsWhereAndHowFast) {
    Landing landing;
    const ContactBegun begun = landing.fall();
    EXPECT_EQ(landing.world.events().contactsBegun.size(), 1u);
    EXPECT_EQ(begun.a, landing.ball.id()) << "the particle is the ball's";
    EXPECT_EQ(begun.b, landing.floor.id());
    EXPECT_NEAR((begun.point - Point(1, 0.1)).norm(), 0, 0.005);
    EXPECT_NEAR(lengthOf(begun.normal - Vec2(0, 1)), 0, 1e-6);
    EXPECT_NEAR(begun.speed, std::sqrt(2 * 9.81 * 1.001), 0.03);
    EXPECT_GT(begun.impulse, 0);
}

/// However the blow is spread over the ticks, and whatever comes back of it.
TEST(ContactEvents, ImpulseOfALandingIsTheMomentumThatItTakes) {
    for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
        Landing landing(restitution);
        const double m = 3, h = 0.002;
        landing.fall();
        double given = impulseOf(landing.world, landing.ball, landing.floor);
        int ticks = 1;
        for (; ticks < 10; ++ticks) {
            landing.world.step();
            given += impulseOf(landing.world, landing.ball, landing.floor);
        }
        // All momentum from the release on is gravity's and the floor's.
        const double t = static_cast<double>(landing.world.ticks()) * h - h / 2;
        const double v = landing.world.velocity(landing.ball.front())[1];
        EXPECT_NEAR(given, m * (v + 9.81 * t), 0.002 * given) << restitution;
        const double impact = std::sqrt(2 * 9.81 * 1.001);
        const double e = static_cast<double>(restitution);
        EXPECT_NEAR(given, m * (1 + e) * impact + (e > 0 ? 0 : m * 9.81 * h * ticks), 0.02 * given)
            << restitution;
    }
}

TEST(ContactEvents, ABounceEndsAndBeginsAgain) {
    Landing landing(Real(0.8));
    std::vector<double> speeds;
    int ended = 0;
    for (int i = 0; i < 1500; ++i) {
        landing.world.step();
        for (const auto& e : landing.world.events().contactsBegun)
            speeds.push_back(static_cast<double>(e.speed));
        ended += static_cast<int>(landing.world.events().contactsEnded.size());
    }
    ASSERT_GE(speeds.size(), 3u);
    EXPECT_NEAR(speeds[1] / speeds[0], 0.8, 0.02);
    EXPECT_NEAR(speeds[2] / speeds[1], 0.8, 0.02);
    EXPECT_GE(ended, static_cast<int>(speeds.size()) - 1);
    EXPECT_LE(ended, static_cast<int>(speeds.size()));
}

TEST(ContactEvents, ARestingCratePersistsWithItsWeight) {
    World world([] {
        WorldSettings settings = telling();
        settings.sleeping = false;
        return settings;
    }());
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body box = world.add(shapes::box({.mass = 7}), {.position = {0, 0.56}});
    test::run(world, 2);
    for (int i = 0; i < 500; ++i) {
        world.step();
        const Events& events = world.events();
        EXPECT_TRUE(events.contactsBegun.empty() && events.contactsEnded.empty());
        ASSERT_EQ(events.contactsPersisted.size(), 1u);
        EXPECT_TRUE(isOf(events.contactsPersisted[0], box, floor));
        EXPECT_NEAR(impulseOf(world, box, floor), 7 * 9.81 * 0.002, 0.01 * 7 * 9.81 * 0.002);
        EXPECT_NEAR(lengthOf(events.contactsPersisted[0].normal), 1, 1e-5);
        double told = 0;
        for (const ContactInfo& c : world.contacts()) told += static_cast<double>(c.impulse);
        EXPECT_NEAR(told, impulseOf(world, box, floor), 1e-4);
    }
}

TEST(ContactEvents, PersistingIsToldOnlyOnDemand) {
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    world.add(shapes::box(), {.position = {0, 0.56}});
    for (int i = 0; i < 200; ++i) {
        world.step();
        EXPECT_TRUE(world.events().contactsPersisted.empty());
    }
    EXPECT_FALSE(world.contacts().empty());
}

TEST(ContactEvents, SleepersAreNotTold) {
    World world(telling());
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body box = world.add(shapes::box(), {.position = {0, 0.56}});
    test::run(world, 3);
    ASSERT_TRUE(world.asleep(box));
    world.step();
    EXPECT_TRUE(world.events().contactsPersisted.empty());
    EXPECT_TRUE(world.events().contactsEnded.empty());
    EXPECT_FALSE(world.contacts().empty());
}

/// Two crates on a floor, one on the other; `sleeping` or not.
struct Pair {
    World world;
    Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    Body low = world.add(shapes::box(), {.position = {0, 0.55}});
    Body high = world.add(shapes::box(), {.position = {0, 1.55}});

    explicit Pair(bool sleeping) : world(WorldSettings{.sleeping = sleeping}) {
        test::run(world, 3);
        EXPECT_EQ(world.asleep(low), sleeping);
        EXPECT_EQ(world.asleep(high), sleeping);
    }
    /// Expects that exactly the contacts of these pairs end in the next tick.
    void expectEnds(const char* what, std::vector<std::pair<BodyId, BodyId>> pairs) {
        world.step();
        const auto& ended = world.events().contactsEnded;
        EXPECT_EQ(ended.size(), pairs.size()) << what;
        for (const auto& pair : pairs) {
            const auto told = std::count_if(ended.begin(), ended.end(), [&](const auto& e) {
                return isOf(e, pair.first, pair.second);
            });
            EXPECT_EQ(told, 1) << what;
        }
        EXPECT_TRUE(world.events().contactsBegun.empty()) << what;
        world.step();
        EXPECT_TRUE(world.events().contactsEnded.empty()) << what << ": told once";
    }
};

TEST(ContactEvents, EndWhenTheyPart) {
    for (const bool sleeping : {false, true}) {
        {
            Pair pair(sleeping);
            pair.world.setVelocity(pair.high, {0, 3});
            pair.expectEnds("thrown up", {{pair.low, pair.high}});
        }
        {
            Pair pair(sleeping);
            pair.world.remove(pair.high);
            pair.expectEnds("removed", {{pair.low, pair.high}});
        }
        {
            Pair pair(sleeping);
            pair.world.remove(pair.low);
            pair.expectEnds("lowest removed", {{pair.low, pair.high}, {pair.low, pair.floor}});
        }
        {
            Pair pair(sleeping);
            pair.world.setFilter(pair.high, {1, 0, 0});
            pair.expectEnds("filtered", {{pair.low, pair.high}});
        }
        {
            Pair pair(sleeping);
            pair.world.setCollision(pair.high, pair.low, false);
            pair.expectEnds("vetoed", {{pair.low, pair.high}});
        }
        {
            Pair pair(sleeping);
            pair.world.setSensor(pair.high, true);
            pair.expectEnds("made a sensor", {{pair.low, pair.high}});
        }
        {
            Pair pair(sleeping);
            for (const ParticleId p : pair.high.particles())
                pair.world.setPosition(p, pair.world.position(p) + Point(9, 9));
            pair.expectEnds("carried away", {{pair.low, pair.high}});
        }
    }
}

TEST(ContactEvents, SensorsTouchNothing) {
    World world(telling());
    Blueprint feeler = shapes::box({.size = {2, 2}});
    feeler.kind = BodyKind::fixed;
    feeler.sensor = true;
    const Body sensor = world.add(feeler, {.position = {0, 1}});
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body ball = world.add(shapes::ball(), {.position = {0, 4}});
    std::size_t entered = 0;
    for (int i = 0; i < 1000; ++i) {
        world.step();
        const Events& events = world.events();
        entered += events.sensorsEntered.size();
        for (const auto& e : events.contactsBegun) EXPECT_TRUE(isOf(e, ball, floor));
        for (const auto& e : events.contactsPersisted) EXPECT_TRUE(isOf(e, ball, floor));
        for (const auto& c : world.contacts()) EXPECT_TRUE(isOf(c, ball, floor));
    }
    EXPECT_EQ(entered, 1u);
    EXPECT_EQ(world.visitors(sensor).size(), 1u);
}

/// A heap in a pit: each pair at most once in a tick, in the order of the handles, and begin and
/// end alternate.
TEST(ContactEvents, ComeOncePerPairInAFixedOrder) {
    World world(telling());
    world.add(shapes::ground({.points = {{-2, 4}, {-2, 0}, {2, 0}, {2, 4}}}));
    test::Random random(3);
    for (int i = 0; i < 12; ++i) {
        const Pose pose{{random.uniform(-1.5, 1.5), 1 + 0.5 * i}, random.uniform(0, 6)};
        const Material bouncy{.restitution = Real(0.6)};
        if (i % 3 == 0)
            world.add(shapes::ball({.material = bouncy}), pose);
        else if (i % 3 == 1)
            world.add(shapes::box({.size = {Real(0.6), Real(0.3)}, .material = bouncy}), pose);
        else
            world.add(shapes::jelly({.size = {Real(0.5), Real(0.5)}, .material = bouncy}), pose);
    }
    using Touching = std::pair<BodyId, BodyId>;
    const auto pairOf = [](const auto& e) {
        return Touching(std::min(e.a, e.b), std::max(e.a, e.b));
    };
    std::vector<Touching> touching;
    std::size_t begun = 0, ended = 0;
    const auto inOrder = [&](const auto& list) {
        for (std::size_t i = 1; i < list.size(); ++i)
            EXPECT_LT(pairOf(list[i - 1]), pairOf(list[i]));
    };
    for (int i = 0; i < 1500; ++i) {
        world.step();
        const Events& events = world.events();
        inOrder(events.contactsBegun);
        inOrder(events.contactsPersisted);
        inOrder(events.contactsEnded);
        for (const auto& e : events.contactsPersisted)
            EXPECT_TRUE(std::count(touching.begin(), touching.end(), pairOf(e)) == 1);
        for (const auto& e : events.contactsEnded)
            EXPECT_EQ(std::erase(touching, pairOf(e)), 1u) << "it had begun";
        for (const auto& e : events.contactsBegun) {
            EXPECT_EQ(std::count(touching.begin(), touching.end(), pairOf(e)), 0);
            touching.push_back(pairOf(e));
            EXPECT_NEAR(lengthOf(e.normal), 1, 1e-4);
            EXPECT_GE(e.impulse, 0);
            EXPECT_GE(e.speed, 0);
        }
        begun += events.contactsBegun.size();
        ended += events.contactsEnded.size();
    }
    EXPECT_GT(begun, 30u);
    EXPECT_EQ(begun - ended, touching.size());
}

/// A heap of as many crates, with as many handles free below theirs.
struct Heap {
    World world{telling()};

    Heap(int crates, int freed) {
        std::vector<Body> removed;
        for (int i = 0; i < freed; ++i)
            removed.push_back(world.add(shapes::ball(), {.position = {20.0 + i, 5}}));
        world.add(shapes::floor({-5, 0}, {5, 0}));
        for (int i = 0; i < crates; ++i)
            world.add(shapes::box({.size = {Real(0.5), Real(0.3)}}),
                      {.position = {0.3 * (i % 3) - 0.3, 0.4 + 0.5 * i}});
        for (const Body& body : removed) world.remove(body);
    }
};

/// All that a tick tells of contacts.
std::vector<std::tuple<int, BodyId, BodyId, Real>> toldBy(World& world) {
    world.step();
    std::vector<std::tuple<int, BodyId, BodyId, Real>> told;
    for (const auto& e : world.events().contactsBegun) told.emplace_back(0, e.a, e.b, e.impulse);
    for (const auto& e : world.events().contactsPersisted)
        told.emplace_back(1, e.a, e.b, e.impulse);
    for (const auto& e : world.events().contactsEnded) told.emplace_back(2, e.a, e.b, 0);
    return told;
}

/// What is kept from tick to tick to find who touched already only saves work: another world's,
/// with the same particles in other bodies, does no harm.
TEST(ContactEvents, WorldsThatTakeTurnsTellWhatEachTellsAlone) {
    constexpr int ticks = 600;
    Heap alone(6, 0), otherAlone(9, 3);
    std::vector<std::vector<std::tuple<int, BodyId, BodyId, Real>>> told, otherTold;
    for (int i = 0; i < ticks; ++i) told.push_back(toldBy(alone.world));
    for (int i = 0; i < ticks; ++i) otherTold.push_back(toldBy(otherAlone.world));
    Heap one(6, 0), other(9, 3);
    std::size_t events = 0;
    for (std::size_t i = 0; i < ticks; ++i) {
        EXPECT_EQ(toldBy(one.world), told[i]) << "tick " << i;
        EXPECT_EQ(toldBy(other.world), otherTold[i]) << "tick " << i;
        events += told[i].size() + otherTold[i].size();
    }
    EXPECT_GT(events, 4000u);
}

/// The pieces of what breaks take its contacts over or begin their own; none is left dangling.
TEST(ContactEvents, PiecesTouchForThemselves) {
    World world(telling());
    const Body floor = world.add(shapes::floor({-5, 0}, {5, 0}));
    const Body box =
        world.add(shapes::box({.size = {2, Real(0.4)}, .strength = 400}), {.position = {0, 0.3}});
    test::run(world, 0.2);
    world.add(shapes::ball({.mass = 40}), {.position = {0.3, 4}});
    std::vector<BodyId> pieces;
    for (int i = 0; i < 1000; ++i) {
        world.step();
        for (const auto& e : world.events().bodiesSplit) pieces.push_back(e.piece);
        for (const auto& e : world.events().contactsBegun)
            EXPECT_TRUE(world.contains(e.a) && world.contains(e.b));
        ASSERT_EQ(world.validate(), "");
    }
    EXPECT_FALSE(world.contains(box) && pieces.empty()) << "nothing broke";
    EXPECT_TRUE(world.contains(floor));
}

/// What is called a hit elsewhere: a contact that begins fast.
TEST(ContactEvents, ThoseThatBeginTellHowFastAnythingHits) {
    for (const int rate : {60, 500})
        for (const Real speed : {Real(0.5), Real(5), Real(50)}) {
            World world({.gravity = {0, 0}, .tickRate = rate});
            world.add(shapes::floor({-50, 0}, {50, 0}));
            const std::vector<Body> bodies{
                world.add(shapes::box(), {.position = {-6, 1}}),
                world.add(shapes::box(), {.position = {-9, 1}, .angle = 0.3}),
                world.add(shapes::ball(), {.position = {-3, 1}}),
                world.add(shapes::jelly(), {.position = {0, 1}}),
                world.add(shapes::rope({.from = {3, 1}, .to = {4, 1}}))};
            for (const Body& body : bodies) world.setVelocity(body, Vec2(0, -speed));
            std::size_t hits = 0;
            for (int i = 0; i < 3 * rate; ++i) {
                world.step();
                for (const ContactBegun& e : world.events().contactsBegun) {
                    if (!(e.speed > Real(0.9) * speed)) continue;
                    EXPECT_NEAR(e.speed, speed, 1e-3 * static_cast<double>(speed)) << rate;
                    ++hits;
                }
            }
            EXPECT_EQ(hits, bodies.size()) << rate << " Hz, " << speed;
        }
}

}  // namespace
}  // namespace sulfur
