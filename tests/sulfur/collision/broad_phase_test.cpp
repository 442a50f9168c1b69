#include "collision/broad_phase.hpp"

#include <algorithm>

#include "collision/cell_size.hpp"
#include "collision/geometry.hpp"
#include "collision/rasterise.hpp"
#include "helpers.hpp"
#include "solver/stages.hpp"

namespace sulfur {
namespace {

using detail::none;
using detail::State;

/// A state that holds capsules and discs only, each a body of its own, without velocity.
class Capsules {
public:
    void add(const Point& a, const Point& b, Real radius, BodyKind kind) {
        const auto body = static_cast<std::uint32_t>(state.bodies.size());
        auto& record = state.bodies.emplace_back();
        record.id = state.bodySlots.insert(body);
        record.kind = kind;
        record.firstParticle = static_cast<std::uint32_t>(state.particles.size());
        const bool disc = a == b;
        addParticle(a, Point(0, 0), disc ? radius : 0, body);
        if (disc) return;
        addParticle(b, b - a, 0, body);
        addJoint(static_cast<Real>((b - a).norm()), radius, body);
    }

    /// Three capsules that end in one point, each of its own thickness; they are one body.
    void addStar(const Point& middle, double size, double angle, BodyKind kind) {
        const auto body = static_cast<std::uint32_t>(state.bodies.size());
        auto& record = state.bodies.emplace_back();
        record.id = state.bodySlots.insert(body);
        record.kind = kind;
        const auto first = static_cast<std::uint32_t>(state.particles.size());
        record.firstParticle = first;
        addParticle(middle, Point(0, 0), 0, body);
        for (int arm = 0; arm < 3; ++arm) {
            const double turn = angle + 2 * arm;
            const Point way = size * Point(std::cos(turn), std::sin(turn));
            addParticle(middle + way, way, 0, body);
            addJoint(static_cast<Real>(size), static_cast<Real>(size * (0.05 + 0.1 * arm)), body);
            state.joints.a.back() = first;
        }
    }

    /// The pairs that the broad phase finds, by the places of the capsules in the order of add():
    /// those that may cross, and those of which an end may touch the other.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs() {
        detail::refreshGrid(state, 0);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
        const auto add = [&](std::uint32_t a, std::uint32_t b) {
            found.emplace_back(std::min(a, b), std::max(a, b));
        };
        for (const auto& pair : state.broad.pairs) add(pair.one, pair.other);
        for (const auto& watch : state.broad.watches)
            add(state.particles.body[watch.candidate.particle], watch.body);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    std::size_t size() const { return state.bodies.size(); }
    State state;

private:
    void addParticle(const Point& at, const Point& rest, Real radius, std::uint32_t body) {
        auto& p = state.particles;
        p.forEachArray([](auto& list) { list.emplace_back(); });
        p.position.back() = at;
        p.velocity.back() = p.force.back() = Point(0, 0);
        p.displacement.back() = p.arm.back() = p.shift.back() = Vec2(0, 0);
        p.rest.back() = rest.cast<Real>();
        p.radius.back() = radius;
        p.cluster.back() = none;
        p.body.back() = body;
    }

    void addJoint(Real length, Real radius, std::uint32_t body) {
        auto& j = state.joints;
        j.forEachArray([](auto& list) { list.emplace_back(); });
        j.b.back() = static_cast<std::uint32_t>(state.particles.size()) - 1;
        j.a.back() = j.b.back() - 1;
        j.restLength.back() = length;
        j.radius.back() = radius;
        j.body.back() = body;
    }
};

struct Segment {
    Point a, b;
    double radius;
};

double distance(const Segment& s, const Segment& t) {
    const Point a(0, 0), b = s.b - s.a, c = t.a - s.a, d = t.b - s.a;
    if (detail::segmentsCross(a, b, c, d)) return -s.radius - t.radius;
    const auto to = [](const Point& p, const Point& u, const Point& v) {
        return (p - (u + detail::nearestAlong<Point>(p, u, v) * (v - u))).norm();
    };
    return std::min({to(a, c, d), to(b, c, d), to(c, a, b), to(d, a, b)}) - s.radius - t.radius;
}

std::vector<Segment> segmentsOf(const Capsules& capsules) {
    std::vector<Segment> segments;
    const auto& x = capsules.state.particles.position;
    for (std::uint32_t i = 0; i < capsules.state.bodies.size(); ++i) {
        const auto first = capsules.state.bodies[i].firstParticle;
        const bool disc = capsules.state.particles.radius[first] > 0;
        segments.push_back({x[first], x[disc ? first : first + 1], 0});
        if (disc)
            segments.back().radius = static_cast<double>(capsules.state.particles.radius[first]);
    }
    for (std::size_t j = 0; j < capsules.state.joints.size(); ++j)
        segments[capsules.state.joints.body[j]].radius =
            static_cast<double>(capsules.state.joints.radius[j]);
    return segments;
}

/// Discs, rods and thick capsules of sizes from 1 mm to 10 m round a point, most of them small and
/// dense enough that many touch, a third of them fixed.
Capsules scatter(std::uint64_t seed, int count, const Point& middle) {
    test::Random random(seed);
    Capsules capsules;
    const auto kind = [&] { return random.below(3) == 0 ? BodyKind::fixed : BodyKind::dynamic; };
    for (int i = 0; i < count; ++i) {
        const double size = std::pow(10.0, random.uniform(-3, 1));
        // The smaller, the nearer to the middle, so that all sizes are equally crowded.
        const double spread = 5 * size;
        const Point at =
            middle + Point(random.uniform(-spread, spread), random.uniform(-spread, spread));
        const double angle = random.uniform(0, 7);
        const Point way = size * Point(std::cos(angle), std::sin(angle));
        const double thickness = size * std::pow(10.0, random.uniform(-2, -0.3));
        capsules.add(at, random.below(4) == 0 ? at : Point(at + way),
                     static_cast<Real>(thickness / 2), kind());
    }
    return capsules;
}

struct Misses {
    std::size_t pairs = 0, touching = 0, missed = 0;
};

Misses compareWithAll(Capsules& capsules) {
    const auto segments = segmentsOf(capsules);
    const auto found = capsules.pairs();
    Misses misses;
    const auto& bodies = capsules.state.bodies;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        for (std::uint32_t k = i + 1; k < segments.size(); ++k) {
            if (bodies[i].kind == BodyKind::fixed && bodies[k].kind == BodyKind::fixed) continue;
            ++misses.pairs;
            if (distance(segments[i], segments[k]) > 0) continue;
            ++misses.touching;
            misses.missed += !std::binary_search(found.begin(), found.end(), std::pair(i, k));
        }
    }
    return misses;
}

TEST(BroadPhase, MissesNoTouchingPairOfMillions) {
#ifdef __SANITIZE_ADDRESS__
    constexpr int count = 700;
#else
    constexpr int count = 2000;
#endif
    Misses all;
    std::uint64_t seed = 1;
    for (const Point& middle : {Point(0, 0), Point(1e6, 1e6), Point(-1e6, 3.7), Point(-3e8, 4e8)}) {
        Capsules capsules = scatter(seed++, count, middle);
        const Misses misses = compareWithAll(capsules);
        EXPECT_EQ(misses.missed, 0u) << "near " << middle.transpose();
        // In an area of one size, twice as many things touch four times as often.
        EXPECT_GT(misses.touching, static_cast<std::size_t>(count) * count / 1500);
        all.pairs += misses.pairs;
    }
    EXPECT_GT(all.pairs, static_cast<std::size_t>(count) * count);
}

/// Where several capsules end in a particle, one of them speaks for it.
TEST(BroadPhase, FindsWhatTouchesEachParticleOnce) {
    test::Random random(7);
    Capsules capsules;
    for (int i = 0; i < 300; ++i)
        capsules.addStar({random.uniform(-6, 6), random.uniform(-6, 6)}, random.uniform(0.1, 1),
                         random.uniform(0, 7),
                         random.below(4) == 0 ? BodyKind::fixed : BodyKind::dynamic);
    capsules.pairs();
    const State& state = capsules.state;
    const auto& watches = state.broad.watches;
    const auto isAfter = [](const auto& p, const auto& q) { return !(p < q); };
    EXPECT_EQ(std::adjacent_find(watches.begin(), watches.end(), isAfter), watches.end());
    const auto& x = state.particles.position;
    const auto colliders = state.broad.moving.size() + state.broad.fixed.size();
    std::size_t touching = 0;
    for (std::uint32_t p = 0; p < x.size(); ++p)
        for (std::uint32_t j = 0; j < colliders; ++j) {
            const auto& c = state.broad.collider(j);
            const auto own = state.particles.body[p];
            const auto isFixed = [&](std::uint32_t b) {
                return state.bodies[b].kind == BodyKind::fixed;
            };
            if (own == c.body || (isFixed(own) && isFixed(c.body))) continue;
            const double radii = static_cast<double>(state.particles.reach[p] + c.radius);
            if (distance({x[p], x[p], radii}, {x[c.a], x[c.b], 0}) > 0) continue;
            ++touching;
            detail::Watch watch;
            watch.candidate = {p, j};
            EXPECT_TRUE(std::binary_search(watches.begin(), watches.end(), watch)) << p << ' ' << j;
        }
    EXPECT_GT(touching, 2000u);
}

/// So that the test above can fail; and what the setting's documentation says.
TEST(BroadPhase, LiteralBresenhamMissesPairsThatTouch) {
    Capsules capsules = scatter(5, 700, {0, 0});
    capsules.state.settings.rasterisation = Rasterisation::bresenham;
    const Misses misses = compareWithAll(capsules);
    EXPECT_GT(misses.missed, misses.touching / 100);
    EXPECT_LT(misses.missed, misses.touching);
}

/// One body covers so many cells that it stands in a coarser grid, fixed or not.
TEST(BroadPhase, FindsWhatTouchesVeryLargeThings) {
    for (const BodyKind kind : {BodyKind::dynamic, BodyKind::fixed}) {
        for (const double length : {1e3, 1e5, 1e8}) {
            Capsules capsules = scatter(6, 500, {0, 0});
            const auto few = capsules.size();
            capsules.add({-length, -0.7 * length}, {length, 0.7 * length}, Real(0.05), kind);
            capsules.add({-2, -length}, {-2.5, length}, Real(0.5), BodyKind::dynamic);
            const Misses misses = compareWithAll(capsules);
            EXPECT_EQ(misses.missed, 0u) << length;
            EXPECT_GT(misses.touching, few / 2);
            EXPECT_FALSE(capsules.state.broad.largeMoving.empty());
        }
    }
}

/// Ends and sides exactly on the borders of cells, near the origin and where doubles are coarse:
/// the cover itself, without skins.
TEST(BroadPhase, CoversWhatTouchesExactlyAtBorders) {
    test::Random random(7);
    int touching = 0;
    for (int trial = 0; trial < 100000; ++trial) {
        const double origin = trial % 3 == 0 ? 0 : trial % 3 == 1 ? 4e7 : -4e7;
        const auto whole = [&](std::size_t count) {
            return static_cast<double>(random.below(count)) / 2;
        };
        const auto place = [&] { return Point(origin + whole(12), origin - whole(12)); };
        const Segment s{place(), place(), whole(3)}, t{place(), place(), whole(3)};
        if (distance(s, t) > 0) continue;
        ++touching;
        std::vector<detail::Cell> cells;
        detail::rasteriseCapsule(s.a, s.b, s.radius, [&](auto cell) { cells.push_back(cell); });
        bool shared = false;
        detail::rasteriseCapsule(t.a, t.b, t.radius, [&](auto cell) {
            shared |= std::find(cells.begin(), cells.end(), cell) != cells.end();
        });
        ASSERT_TRUE(shared) << "trial " << trial;
    }
    EXPECT_GT(touching, 10000);
}

TEST(BroadPhase, BresenhamsLineIsOneCellAStep) {
    std::vector<detail::Cell> cells;
    const auto note = [&](detail::Cell cell) { cells.push_back(cell); };
    detail::rasteriseLine({0.9, 0.9}, {6.1, 3.5}, note);
    const std::vector<detail::Cell> expected{{0, 0}, {1, 0}, {2, 1}, {3, 1},
                                             {4, 2}, {5, 2}, {6, 3}};
    EXPECT_EQ(cells.size(), expected.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        EXPECT_EQ(cells[i].x, static_cast<int>(i));
        EXPECT_LE(std::abs(cells[i].y - cells[i].x * 0.5), 0.5);
    }
    cells.clear();
    detail::rasteriseLine({-0.5, 2.5}, {-0.5, -2.5}, note);
    EXPECT_EQ(cells,
              (std::vector<detail::Cell>{{-1, 2}, {-1, 1}, {-1, 0}, {-1, -1}, {-1, -2}, {-1, -3}}));
}

/// Grains of `size` metres in a block, a little apart.
void addGrains(World& world, int count, double size, const Point& corner) {
    const int columns = 50;
    for (int i = 0; i < count; ++i)
        world.add(shapes::ball({.radius = static_cast<Real>(size / 2), .mass = Real(0.01)}),
                  {.position = corner + 1.25 * size * Point(i % columns, i / columns)});
}

TEST(BroadPhase, CostsTheSameWhereverAndHoweverFarApartThingsAre) {
    const auto measure = [](const Point& first, const Point& second) {
        World world({.sleeping = false});
        addGrains(world, 500, 0.5, first);
        addGrains(world, 500, 0.5, second);
        for (int i = 0; i < 50; ++i) world.step();
        return world.statistics();
    };
    const auto near = measure({0, 0}, {64, 0});
    EXPECT_GT(near.candidates, 500u);
    for (const double far : {1024.0 * 1024, 400.0 * 1024 * 1024}) {
        const auto apart = measure({-far, -far}, {far, far});
        EXPECT_EQ(apart.gridCells, near.gridCells) << far;
        EXPECT_EQ(apart.candidates, near.candidates) << far;
        EXPECT_EQ(apart.broadPhases, near.broadPhases) << far;
    }
}

/// Linear in the grains, although crates, a hall and the ground are up to 10^5 times larger.
TEST(BroadPhase, LargeThingsDoNotMakeItQuadraticInTheSmallOnes) {
    const auto measure = [](int grains) {
        World world({.sleeping = false});
        world.add(shapes::floor({-500, 0}, {500, 0}));
        addGrains(world, grains, 0.01, {0, 0.06});
        for (int i = 0; i < 4; ++i)
            world.add(shapes::box({.size = {10, 10}, .mass = 100}), {.position = {-50.0 * i, 30}});
        world.add(shapes::box({.size = {1000, 500}, .mass = 1e5}), {.position = {0, 260}});
        world.step();
        return world.statistics();
    };
    const auto few = measure(1000), many = measure(4000);
    EXPECT_LT(few.gridCells, 60000u);
    EXPECT_LT(many.gridCells, few.gridCells + 3000 * 8);
    EXPECT_LT(few.candidates, 10000u);
    EXPECT_LT(many.candidates, few.candidates + 3000 * 10);
}

TEST(BroadPhase, RasterisesFixedGeometryOnce) {
    World world({.sleeping = false});
    world.add(shapes::floor({-20, 0}, {20, 0}));
    for (int i = 0; i < 10; ++i) world.add(shapes::box(), {.position = {2.0 * i - 10, 2.0}});
    test::run(world, 1);
    EXPECT_GT(world.statistics().broadPhases, 2u);
    EXPECT_EQ(world.statistics().fixedRebuilds, 1u);
    world.add(shapes::box(), {.position = {0, 5}});
    world.step();
    EXPECT_EQ(world.statistics().fixedRebuilds, 1u);
    world.add(shapes::floor({-20, -5}, {20, -5}));
    world.step();
    EXPECT_EQ(world.statistics().fixedRebuilds, 2u);
    world.remove(world.bodies().front());
    world.step();
    EXPECT_EQ(world.statistics().fixedRebuilds, 3u);
}

TEST(BroadPhase, KeepsCandidatesUntilSomethingLeavesItsSkin) {
    World world({.gravity = {0, 0}, .sleeping = false});
    const Body still = world.add(shapes::box(), {.position = {0, 0}});
    const Body other = world.add(shapes::box(), {.position = {1.05, 0}});
    world.step();
    const auto runs = world.statistics().broadPhases;
    test::run(world, 1);
    EXPECT_EQ(world.statistics().broadPhases, runs);
    // See collision/skins.hpp: 0.77 of a tenth of a cell of 1 m.
    world.setVelocity(still, {Real(-0.5), 0});
    const double before = world.centreOfMass(still)[0];
    while (world.statistics().broadPhases == runs) world.step();
    EXPECT_NEAR(before - world.centreOfMass(still)[0], 0.077, 0.003);
    EXPECT_EQ(world.centreOfMass(other)[0], 1.05);
}

/// A thick joint to fixed ground makes its corner part of what swings: when that is drawn again,
/// what others have with the ground stays.
TEST(BroadPhase, KeepsWhatLiesOnGroundThatSomethingThickIsTiedTo) {
    World world;
    const Body ground = world.add(shapes::ground({.points = {{0, 6}, {0, 0}, {8, 0}}}));
    const Body ball =
        world.add(shapes::ball({.radius = Real(0.2), .mass = 5}), {.position = {1.5, 0}});
    world.connect(world.particles(ground)[1], ball.front(),
                  {.stiffness = infinite, .radius = Real(0.02)});
    std::vector<Body> boxes;
    for (int i = 0; i < 30; ++i)
        boxes.push_back(
            world.add(shapes::box({.size = {Real(0.3), Real(0.3)}}),
                      {.position = {0.5 + 0.24 * i, 0.2 + 0.5 * (i % 2)}, .angle = 0.1}));
    for (int tick = 0; tick < 700; ++tick) {
        World restored;
        if (tick % 10 == 0) restored.restore(world.snapshot());
        world.step();
        if (tick % 10 != 0) continue;
        restored.step();
        ASSERT_EQ(restored.hash(), world.hash()) << tick;
    }
    for (const Body& box : boxes) EXPECT_GT(world.centreOfMass(box)[1], 0);
}

/// The end of a thin rod is as thick as a joint to another body, also for what that body lets pass.
TEST(BroadPhase, HoldsOffWhatTouchesAnEndThatAnotherBodysJointMakesThick) {
    for (const double speed : {0.5, 2.0}) {
        World world({.gravity = {0, 0}});
        const Body rod = world.add(shapes::chain({.to = {2, 0}, .links = 1, .pinFirst = true}),
                                   {.position = {0, 3}});
        Blueprint plan = shapes::ball({.radius = Real(0.05), .mass = 1});
        plan.filter.mask = 0;
        const Body other = world.add(plan, {.position = {2, 5}});
        plan.filter = {};
        // So that cells are small.
        for (int i = 0; i < 20; ++i) world.add(plan, {.position = {-10.0 - i, -5}});
        world.connect(other.front(), rod.back(), {.stiffness = infinite, .radius = Real(0.5)});
        const Body visitor = world.add(plan, {.position = {4, 1}});
        world.setVelocity(visitor, Point(-speed, speed).cast<Real>());
        double nearest = 9;
        for (int tick = 0; tick < 2500 / speed; ++tick) {
            world.step();
            nearest = std::min(nearest,
                               (world.position(rod.back()) - world.centreOfMass(visitor)).norm());
        }
        EXPECT_NEAR(nearest, 0.55, 0.005) << speed;
    }
}

TEST(CellSize, IsThatOfThingsOfOneSize) {
    for (const double size : {0.02, 0.1, 1.0, 30.0}) {
        detail::SizeCensus discs, rods;
        for (int i = 0; i < 1000; ++i) discs.add(0, size / 2);
        for (int i = 0; i < 1000; ++i) rods.add(size, size / 50);
        for (const auto* census : {&discs, &rods}) {
            EXPECT_GE(census->choose(1), size / 2) << size;
            EXPECT_LE(census->choose(1), size * 2) << size;
        }
    }
}

TEST(CellSize, SuitsGrainsWhateverLiesAmongThem) {
    detail::SizeCensus census;
    for (int i = 0; i < 5000; ++i) census.add(0, 0.01);
    for (int i = 0; i < 400; ++i) census.add(10, 0.02);
    EXPECT_LE(census.choose(1), 0.07);
    // And one grain does not make the cells of crates small.
    detail::SizeCensus crates;
    for (int i = 0; i < 5000; ++i) crates.add(1, 0.02);
    crates.add(0, 0.001);
    EXPECT_GE(crates.choose(1), 0.5);
}

TEST(CellSize, IsKeptWhileItIsNearlyAsGood) {
    detail::SizeCensus census;
    for (int i = 0; i < 1000; ++i) census.add(0, 0.25);
    const double best = census.choose(1e3);
    double other = best;
    for (const double near : {best / 2, best * 2})
        if (census.cost(near) <= 1.25 * census.cost(best)) other = near;
    EXPECT_EQ(census.choose(other), other);
    EXPECT_EQ(census.choose(best * 16), best);
    EXPECT_EQ(detail::SizeCensus().choose(3), 1);
}

/// The choice is part of the state: it is made when bodies change, not when a copy goes on.
TEST(CellSize, IsRestoredWithTheWorld) {
    World world;
    world.add(shapes::floor({-20, 0}, {20, 0}));
    const Body rope = world.add(shapes::rope({.radius = Real(0.02)}), {.position = {0, 3}});
    test::run(world, 0.2);
    for (const JointId joint : rope.joints()) world.setRestLength(joint, Real(0.4));
    const Snapshot snapshot = world.snapshot();
    World copy;
    copy.restore(snapshot);
    for (World* each : {&world, &copy}) test::run(*each, 1);
    EXPECT_EQ(copy.hash(), world.hash());
}

TEST(Rasterisation, IsASettingThatStaysWithTheWorld) {
    World world({.rasterisation = Rasterisation::bresenham}), other;
    EXPECT_NE(world.hash(), other.hash());
    other.restore(world.snapshot());
    EXPECT_EQ(other.settings().rasterisation, Rasterisation::bresenham);
    EXPECT_EQ(world.hash(), other.hash());
}

}  // namespace
}  // namespace sulfur
