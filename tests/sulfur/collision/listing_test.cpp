#include "collision/listing.hpp"

#include <algorithm>
#include <tuple>

#include "helpers.hpp"
#include "solver/stages.hpp"

namespace sulfur {
namespace {

using detail::none;
using detail::State;

/// A state to which bodies are added as a world adds them, as far as the broad phase looks.
class Bodies {
public:
    /// Capsules from each point to the next, round to the first; of one point, a disc.
    void add(const std::vector<Vec2>& points, const Point& at, BodyKind kind) {
        const auto body = static_cast<std::uint32_t>(state.bodies.size());
        auto& record = state.bodies.emplace_back();
        record.id = state.bodySlots.insert(body);
        record.kind = kind;
        record.firstParticle = static_cast<std::uint32_t>(state.particles.size());
        for (const Vec2& point : points) addParticle(point, at, points.size() == 1, body);
        const auto count = static_cast<std::uint32_t>(points.size());
        for (std::uint32_t k = 0; count > 1 && k < count; ++k)
            addJoint(record.firstParticle + k, record.firstParticle + (k + 1) % count, body);
        state.broad.bodyAdded();
    }

    /// Brings the grid up to date as a tick does once it has derived its lists.
    const detail::BroadPhase& refresh() {
        state.structure.stale = state.work.stale = false;
        detail::refreshGrid(state, 0);
        return state.broad;
    }

    State state;

private:
    void addParticle(const Vec2& point, const Point& at, bool disc, std::uint32_t body) {
        auto& p = state.particles;
        p.forEachArray([](auto& list) { list.emplace_back(); });
        p.position.back() = at + point.cast<double>();
        p.velocity.back() = p.force.back() = Point(0, 0);
        p.displacement.back() = p.arm.back() = p.shift.back() = Vec2(0, 0);
        p.rest.back() = point;
        p.radius.back() = disc ? Real(0.4) : 0;
        p.cluster.back() = none;
        p.body.back() = body;
    }

    void addJoint(std::uint32_t a, std::uint32_t b, std::uint32_t body) {
        auto& j = state.joints;
        j.forEachArray([](auto& list) { list.emplace_back(); });
        j.a.back() = a;
        j.b.back() = b;
        j.restLength.back() = (state.particles.rest[b] - state.particles.rest[a]).norm();
        j.radius.back() = Real(0.05);
        j.body.back() = body;
    }
};

const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, triangle{{0, 0}, {1, 0}, {0, 1}},
    disc{{0, 0}};

/// A crowd of squares, triangles and discs on a floor.
void addSome(Bodies& bodies, int from, int to) {
    for (int i = from; i < to; ++i) {
        const Point at(0.9 * (i % 6), 0.9 * (i / 6));
        bodies.add(i % 3 == 0 ? square : i % 3 == 1 ? disc : triangle, at, BodyKind::dynamic);
    }
}

using Tuples = std::vector<std::tuple<std::uint32_t, std::uint32_t, Real>>;

Tuples candidatesOf(const detail::BroadPhase& broad) {
    Tuples all;
    for (const auto& w : broad.watches)
        all.emplace_back(w.candidate.particle, w.candidate.collider, w.spare);
    return all;
}

Tuples pairsOf(const detail::BroadPhase& broad) {
    Tuples all;
    for (const auto& pair : broad.pairs) all.emplace_back(pair.first, pair.second, pair.spare);
    return all;
}

/// One body after another, the grid refreshed after each, gives what all of them give at once.
TEST(Listing, BodiesOneByOneAreAsAllAtOnce) {
    Bodies oneByOne, atOnce;
    for (auto* bodies : {&oneByOne, &atOnce}) {
        bodies->add({{-5, -1}, {10, -1}}, Point(0, 0), BodyKind::fixed);
        addSome(*bodies, 0, 30);
    }
    oneByOne.refresh();
    for (int i = 30; i < 60; ++i) {
        addSome(oneByOne, i, i + 1);
        oneByOne.refresh();
    }
    addSome(atOnce, 30, 60);
    const auto& grown = oneByOne.refresh();
    const auto& anew = atOnce.refresh();
    EXPECT_GT(grown.movingGrid.added(), 0u) << "everything was drawn again";
    EXPECT_EQ(grown.fixedRuns, 1u);
    EXPECT_EQ(grown.moving, anew.moving);
    EXPECT_EQ(grown.fixed, anew.fixed);
    EXPECT_EQ(grown.reach, anew.reach);
    EXPECT_EQ(grown.surface, anew.surface);
    EXPECT_EQ(grown.pieces.ofParticle, anew.pieces.ofParticle);
    EXPECT_EQ(grown.pieces.colliderStart, anew.pieces.colliderStart);
    EXPECT_EQ(grown.pieces.colliders, anew.pieces.colliders);
    EXPECT_EQ(grown.pieces.particleStart, anew.pieces.particleStart);
    EXPECT_EQ(grown.pieces.particles, anew.pieces.particles);
    EXPECT_EQ(grown.spokes.start, anew.spokes.start);
    EXPECT_EQ(grown.spokes.end, anew.spokes.end);
    EXPECT_EQ(grown.levelOfMoving, anew.levelOfMoving);
    EXPECT_EQ(grown.cellsOf, anew.cellsOf);
    EXPECT_EQ(grown.liveCells, anew.liveCells);
    EXPECT_GT(anew.watches.size(), 200u);
    EXPECT_EQ(candidatesOf(grown), candidatesOf(anew));
    EXPECT_EQ(pairsOf(grown), pairsOf(anew));
    for (std::uint32_t body = 0; body < atOnce.state.bodies.size(); ++body)
        EXPECT_TRUE(std::ranges::equal(grown.outlines.of(body), anew.outlines.of(body))) << body;
    for (std::uint32_t j = 0; j < atOnce.state.joints.size(); ++j)
        EXPECT_EQ(grown.outlines.outwardOf(j), anew.outlines.outwardOf(j)) << j;
}

/// Whatever else changed with it, everything is listed anew.
TEST(Listing, OnlyAddedBodiesAreTakenIn) {
    const auto takesIn = [](auto&& change) {
        Bodies bodies;
        addSome(bodies, 0, 30);
        bodies.refresh();
        addSome(bodies, 30, 31);
        change(bodies);
        return detail::listAdded(bodies.state);
    };
    const auto nothing = [](Bodies& b) { b.state.structure.stale = b.state.work.stale = false; };
    EXPECT_TRUE(takesIn(nothing));
    EXPECT_FALSE(takesIn([&](Bodies& b) {
        b.add(square, Point(50, 0), BodyKind::fixed);
        nothing(b);
    }));
    EXPECT_FALSE(takesIn([&](Bodies& b) {
        b.state.broad.bodiesChanged();
        addSome(b, 31, 32);
        nothing(b);
    }));
    EXPECT_FALSE(takesIn([&](Bodies& b) {
        nothing(b);
        b.state.broad.pairsStale = true;
    }));
    EXPECT_FALSE(takesIn([](Bodies& b) { b.state.work.stale = true; }));
}

/// A rain in which the grid grows goes on, to the bit, as one in which it is made anew each time.
TEST(Listing, HowBodiesAreTakenInChangesNothing) {
    World grown({.sleeping = false}), anew({.sleeping = false});
    BodyId ground;
    for (auto* world : {&grown, &anew})
        ground = world->add(shapes::ground({.points = {{-4, 20}, {-4, 0}, {4, 0}, {4, 20}}})).id();
    for (int i = 0; i < 800; ++i) {
        const Pose pose{{-3 + 1.2 * (i / 10 % 6), 8.0 + i / 60 % 3}, 0.3 * i};
        for (auto* world : {&grown, &anew}) {
            if (i % 10 == 0) {
                if (i % 30 == 0) world->add(shapes::box(), pose);
                if (i % 30 == 10) world->add(shapes::blob({.radius = Real(0.45)}), pose);
                if (i % 30 == 20) world->add(shapes::ball({.radius = Real(0.3)}), pose);
            }
        }
        anew.setFilter(ground, {});  // which lists everything anew
        grown.step();
        anew.step();
        ASSERT_EQ(grown.hash(), anew.hash()) << i;
    }
    EXPECT_GT(grown.statistics().contacts, 20u);
    EXPECT_LT(grown.statistics().broadPhases, anew.statistics().broadPhases);
}

}  // namespace
}  // namespace sulfur
