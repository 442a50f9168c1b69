#include "bench/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "battery/contacts/stage.hpp"
#include "battery/scenes.hpp"
#include "bench/clock.hpp"
#include "bench/threads.hpp"

namespace sulfur::lab::bench {

namespace {

WorldSettings awake(double gravity = standardGravity) {
    return {.gravity = vec2(0, -gravity), .sleeping = false};
}

/// Crates side by side, `pitch` apart, `rows` above each other, in free space.
void scatter(World& world, int count, double pitch) {
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    const Blueprint plan = crate();
    for (int i = 0; i < count; ++i)
        world.add(plan, {.position = Point(i % side * pitch, i / side * pitch)});
}

/// Crates that lie on a floor, apart.
std::vector<Body> lay(World& world, int count, const Material& material = {}) {
    const double reach = 0.75 * count + 5;
    addFloor(world, reach, material);
    const Blueprint plan = crate({.material = material});
    std::vector<Body> bodies;
    for (int i = 0; i < count; ++i)
        bodies.push_back(world.add(plan, {.position = Point(1.5 * i - 0.75 * count, 0.5)}));
    return bodies;
}

std::unique_ptr<World> bodiesWorld(double size) {
    auto world = std::make_unique<World>(awake(0));
    scatter(*world, static_cast<int>(size), 2);
    return world;
}

/// A net of springs with about `size` of them, hung up at its upper row.
std::unique_ptr<World> jointsWorld(double size) {
    auto world = std::make_unique<World>(awake());
    const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(size / 4))));
    Blueprint net = lattice({.columns = side, .rows = side, .damping = 0.1});
    for (int i = 0; i < side; ++i)
        net.particles[static_cast<std::size_t>(side * (side - 1) + i)].pinned = true;
    world->add(net);
    return world;
}

/// Each crate on a floor touches it twice.
std::unique_ptr<World> contactsWorld(double size) {
    auto world = std::make_unique<World>(awake());
    lay(*world, static_cast<int>(size / 2));
    return world;
}

std::unique_ptr<World> threadedWorld(double threads) {
    auto world = contactsWorld(6000);
    world->setTasks(tasksFor(static_cast<std::size_t>(threads)));
    return world;
}

/// A pyramid of 40 rows.
std::unique_ptr<World> threadedPyramid(double threads) {
    constexpr int base = 40;
    auto world = std::make_unique<World>(awake());
    addFloor(*world, base, {});
    const Blueprint plan = crate();
    for (int row = 0; row < base; ++row)
        for (int column = 0; column < base - row; ++column)
            world->add(plan, {.position = Point(0.5 * row + column - base / 2.0, 0.5 + row)});
    world->setTasks(tasksFor(static_cast<std::size_t>(threads)));
    return world;
}

/// 100 soft bodies that lie in a heap.
std::unique_ptr<World> threadedBlobs(double threads) {
    auto world = std::make_unique<World>(awake());
    addFloor(*world, 40, {});
    const Blueprint plan = shapes::jelly();
    for (int i = 0; i < 100; ++i)
        world->add(plan, {.position = Point(1.05 * (i % 20) - 10, 0.5 + 1.05 * (i / 20))});
    world->setTasks(tasksFor(static_cast<std::size_t>(threads)));
    return world;
}

/// 1, 2, 4 and so on, up to what the machine has, but at least two.
std::vector<double> threadCounts() {
    std::vector<double> counts;
    for (unsigned n = 1; n <= std::max(2u, std::thread::hardware_concurrency()); n *= 2)
        counts.push_back(n);
    return counts;
}

/// 1000 crates that sleep, but for a share that is grabbed anew, which never sleeps.
std::unique_ptr<World> awakeWorld(double share) {
    constexpr int count = 1000;
    WorldSettings settings = awake();
    settings.sleeping = true;
    auto world = std::make_unique<World>(settings);
    const auto bodies = lay(*world, count);
    run(*world, 1.5);
    // Slow enough to stay on the floor, and without end.
    for (int i = 0; i < std::lround(share * count); ++i) {
        const Body& body = bodies[static_cast<std::size_t>(i)];
        world->grab(body[0], world->position(body[0]) + Point(0, 0.3));
    }
    return world;
}

/// Crates that all sleep.
std::unique_ptr<World> sleepingWorld(double size) {
    WorldSettings settings = awake();
    settings.sleeping = true;
    auto world = std::make_unique<World>(settings);
    lay(*world, static_cast<int>(size));
    run(*world, 1.5);
    return world;
}

std::unique_ptr<World> extentWorld(double metres) {
    auto world = std::make_unique<World>(awake(0));
    scatter(*world, 1000, metres / 32);
    return world;
}

using Change = std::function<void(World&, const std::vector<Body>&)>;

/// A floor with crates that lie on it; `change` is made when the option is on.
Option onCrates(std::string name, int bodies, Change change) {
    return {std::move(name), "crates that lie on a floor", [=](bool on) {
                auto world = std::make_unique<World>(awake());
                const auto crates = lay(*world, bodies);
                if (on) change(*world, crates);
                return world;
            }};
}

Option material(std::string name, int bodies, const Material& off, const Material& on) {
    return {std::move(name), "crates that lie on a floor", [=](bool is) {
                auto world = std::make_unique<World>(awake());
                lay(*world, bodies, is ? on : off);
                return world;
            }};
}

Option setting(std::string name, int bodies, std::function<void(WorldSettings&)> set) {
    return {std::move(name), "crates that lie on a floor", [=](bool on) {
                WorldSettings settings = awake();
                if (on) set(settings);
                auto world = std::make_unique<World>(settings);
                lay(*world, bodies);
                return world;
            }};
}

/// Jellies that lie on a floor.
Option onJellies(std::string name, int bodies, std::function<void(Blueprint&)> change) {
    return {std::move(name), "jellies that lie on a floor", [=](bool on) {
                auto world = std::make_unique<World>(awake());
                Blueprint plan = shapes::jelly();
                for (JointSpec& joint : plan.joints) joint.damping = 0;
                if (on) change(plan);
                addFloor(*world, bodies + 5);
                for (int i = 0; i < bodies; ++i)
                    world->add(plan, {.position = Point(1.5 * i - 0.75 * bodies, 0.5)});
                return world;
            }};
}

Option flight(int bodies) {
    return {"fast movers", "balls in free flight, at 1 m/s or at 300", [=](bool on) {
                auto world = std::make_unique<World>(awake(0));
                const Blueprint plan = shapes::ball({.radius = Real(0.1)});
                for (int i = 0; i < bodies; ++i) {
                    const Body ball = world->add(plan, {.position = Point(0, i)});
                    world->setVelocity(ball, Vec2(on ? 300 : 1, 0));
                }
                return world;
            }};
}

Option selfCollision(int bodies) {
    return {"self-collision", "hanging ropes of 40 links", [=](bool on) {
                auto world = std::make_unique<World>(awake());
                Blueprint plan = shapes::rope({.links = 40, .pinFirst = true});
                plan.selfCollision = on;
                for (int i = 0; i < bodies / 10; ++i) world->add(plan, {.position = Point(i, 0)});
                return world;
            }};
}

void addFieldOptions(std::vector<Option>& all, int bodies) {
    all.push_back(onCrates("uniform field", bodies, [](World& world, const auto&) {
        world.add(UniformField{.acceleration = Vec2(0, -1)});
    }));
    all.push_back(onCrates("radial field", bodies, [](World& world, const auto&) {
        world.add(RadialField{.centre = Point(0, -1000), .strength = 1, .falloff = 0});
    }));
    all.push_back(onCrates("wind", bodies, [](World& world, const auto&) {
        world.add(WindField{.drag = Real(0.1)});
    }));
}

}  // namespace

Spread tickTime(World& world, const TickOptions& options, bool onWall) {
    const auto now = onWall ? wallTime : threadTime;
    for (int i = 0; i < options.warmUp; ++i) world.step();
    std::vector<double> times;
    for (int r = 0; r < options.repeats; ++r) {
        const double begin = now();
        for (int i = 0; i < options.ticks; ++i) world.step();
        times.push_back((now() - begin) / options.ticks);
    }
    return spreadOf(std::move(times));
}

std::vector<Growth> growths(bool quick) {
    const auto upTo = [&](std::vector<double> sizes) {
        if (quick) sizes.resize(3);
        return sizes;
    };
    std::vector<Growth> all{
        {"bodies", "bodies in free space", upTo({100, 300, 1000, 3000, 10000}), bodiesWorld},
        {"joints", "springs in a net", upTo({400, 1600, 6400, 25600, 102400}), jointsWorld},
        {"contacts", "contacts of crates on a floor", upTo({200, 600, 2000, 6000, 20000}),
         contactsWorld},
        {"awake", "share of 1000 crates that is awake", upTo({0.01, 0.03, 0.1, 0.3, 1}),
         awakeWorld},
        {"sleepers", "sleeping crates, none awake", upTo({100, 300, 1000, 3000, 25000}),
         sleepingWorld},
        {"extent", "extent of a world with 1000 bodies (m)", upTo({64, 640, 6400, 64000, 640000}),
         extentWorld},
        {"threads", "threads, for 6000 contacts of crates on a floor", threadCounts(),
         threadedWorld, true},
        {"threads-pyramid", "threads, for a pyramid of 40 rows", threadCounts(), threadedPyramid,
         true},
        {"threads-blobs", "threads, for a heap of 100 soft bodies", threadCounts(), threadedBlobs,
         true}};
    return all;
}

std::vector<Option> options(int bodies) {
    const Material smooth{.staticFriction = 0, .kineticFriction = 0};
    Material bouncing;
    bouncing.restitution = Real(0.5);
    std::vector<Option> all{
        material("friction", bodies, smooth, {}),
        material("restitution", bodies, {}, bouncing),
        setting("friction of the paper", bodies,
                [](WorldSettings& s) { s.friction = Friction::sliding; }),
        setting("air friction", bodies, [](WorldSettings& s) { s.airFriction = Real(0.1); }),
        setting("events of persisting contacts", bodies,
                [](WorldSettings& s) { s.tellPersisting = true; }),
        setting("8 sweeps instead of 4", bodies, [](WorldSettings& s) { s.sweeps = 8; }),
        onJellies("damping of joints", bodies,
                  [](Blueprint& plan) {
                      for (JointSpec& joint : plan.joints) joint.damping = 1;
                  }),
        onJellies("breakage of springs", bodies,
                  [](Blueprint& plan) {
                      for (JointSpec& joint : plan.joints) joint.strength = Real(1e9);
                  }),
        onCrates("breakage of rigid joints", bodies,
                 [](World& world, const std::vector<Body>& crates) {
                     for (const Body& body : crates)
                         for (const JointId joint : body.joints())
                             world.setStrength(joint, Real(1e9));
                 }),
        flight(bodies),
        onCrates("a sensor round all", bodies,
                 [bodies](World& world, const auto&) {
                     Blueprint zone = shapes::box({.size = vec2(2.0 * bodies, 4)});
                     zone.kind = BodyKind::fixed;
                     zone.sensor = true;
                     world.add(zone, {.position = Point(0, 1)});
                 }),
        selfCollision(bodies),
        onCrates("grabs of a tenth", bodies,
                 [](World& world, const std::vector<Body>& crates) {
                     for (std::size_t i = 0; i < crates.size(); i += 10)
                         world.grab(crates[i][0], world.position(crates[i][0]));
                 }),
        onCrates("profiling", bodies, [](World& world, const auto&) { world.setProfiling(true); }),
    };
    addFieldOptions(all, bodies);
    return all;
}

}  // namespace sulfur::lab::bench
