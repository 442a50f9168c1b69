
#include <algorithm>

#include "helpers.hpp"
#include "queries/nearby.hpp"
#include "shape/outline.hpp"

namespace sulfur {
namespace {

using detail::encloses;
using detail::RimEdge;
using detail::State;

/// As much of a world as outlines are made from, at rest where the blueprints say.
State stateOf(const std::vector<Blueprint>& plans) {
    State state;
    for (const Blueprint& plan : plans) {
        const auto body = static_cast<std::uint32_t>(state.bodies.size());
        const auto first = static_cast<std::uint32_t>(state.particles.size());
        detail::BodyRecord& record = state.bodies.emplace_back();
        record.id = state.bodySlots.insert(body);
        record.kind = plan.kind;
        record.firstParticle = first;
        record.particles.resize(plan.particles.size());
        for (const ParticleSpec& p : plan.particles) {
            state.particles.position.push_back(p.position.cast<double>());
            state.particles.rest.push_back(p.position);
            state.particles.body.push_back(body);
        }
        for (const JointSpec& j : plan.joints) {
            const auto index = static_cast<std::uint32_t>(state.joints.a.size());
            record.joints.push_back(state.jointSlots.insert(index));
            state.joints.a.push_back(first + j.a);
            state.joints.b.push_back(first + j.b);
            state.joints.radius.push_back(j.radius);
            state.joints.bend.push_back({j.bend});
            state.joints.body.push_back(body);
        }
    }
    return state;
}

std::vector<RimEdge> outlineOf(const State& state, std::uint32_t body = 0) {
    std::vector<RimEdge> edges;
    for (const auto& loop : findOutlines(state, body))
        edges.insert(edges.end(), loop.begin(), loop.end());
    return edges;
}

std::size_t edgesOf(const State& state, std::uint32_t body = 0) {
    return outlineOf(state, body).size();
}

/// +1 where the outside is to the right of a joint's way, -1 where it is to the left.
int outwardOf(const State& state, std::uint32_t joint) {
    for (const RimEdge& edge : outlineOf(state, state.joints.body[joint]))
        if (edge.joint == joint) return state.joints.a[joint] == edge.from ? 1 : -1;
    return 0;
}

/// Every edge's way agrees with the side that its joint tells, and the edges close.
void expectSound(const State& state, std::uint32_t body = 0) {
    std::vector<std::uint32_t> from, to;
    for (const RimEdge& edge : outlineOf(state, body)) {
        const bool along = state.joints.a[edge.joint] == edge.from;
        EXPECT_EQ(along ? state.joints.b[edge.joint] : state.joints.a[edge.joint], edge.to);
        from.push_back(edge.from);
        to.push_back(edge.to);
    }
    std::sort(from.begin(), from.end());
    std::sort(to.begin(), to.end());
    EXPECT_EQ(from, to);
}

Blueprint turnedRound(Blueprint plan) {
    for (JointSpec& joint : plan.joints) std::swap(joint.a, joint.b);
    return plan;
}

TEST(Outlines, ABoxHasItsFourSides) {
    const State state = stateOf({shapes::box({.size = {2, 1}})});
    EXPECT_EQ(edgesOf(state), 4u);
    expectSound(state);
    for (std::uint32_t j = 0; j < 4; ++j) EXPECT_EQ(outwardOf(state, j), 1);
    for (std::uint32_t j = 4; j < state.joints.a.size(); ++j) EXPECT_EQ(outwardOf(state, j), 0);
    EXPECT_TRUE(encloses(state, 0, {0.9, -0.4}));
    EXPECT_FALSE(encloses(state, 0, {1.1, 0}));
    EXPECT_FALSE(encloses(state, 0, {0, 0.6}));
}

TEST(Outlines, TheWindingOfTheJointsOfADynamicBodyDoesNotMatter) {
    const State state = stateOf({turnedRound(shapes::box())});
    EXPECT_EQ(edgesOf(state), 4u);
    expectSound(state);
    EXPECT_EQ(outwardOf(state, 0), -1);
    EXPECT_TRUE(encloses(state, 0, {0, 0}));
}

TEST(Outlines, AConcavePolygonKeepsItsNotch) {
    for (const bool reversed : {false, true}) {
        std::vector<Vec2> points{{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};
        if (reversed) std::reverse(points.begin(), points.end());
        const State state = stateOf({shapes::polygon({.points = points})});
        EXPECT_EQ(edgesOf(state), 5u);
        expectSound(state);
        const Point core = state.particles.position.back();
        const auto inside = [&](double x, double y) {
            // The blueprint's frame has its origin somewhere: compare relative to a corner.
            const Point corner = state.particles.position[reversed ? 4 : 0];
            return encloses(state, 0, corner + Point(x, y));
        };
        EXPECT_TRUE(core.allFinite());
        EXPECT_TRUE(inside(0.5, 1.5));
        EXPECT_TRUE(inside(3.4, 1.5));
        EXPECT_TRUE(inside(2, 0.5));
        EXPECT_FALSE(inside(2, 1.5));
        EXPECT_FALSE(inside(-0.5, 1));
    }
}

TEST(Outlines, OfALatticeOnlyTheBorderBounds) {
    const Blueprint wall = shapes::wall({.columns = 4, .rows = 3});
    const State state = stateOf({wall});
    EXPECT_EQ(edgesOf(state), 14u);
    expectSound(state);
    EXPECT_TRUE(encloses(state, 0, {0, 0}));
}

/// What a breaking wall leaves: a bite out of the border, and a piece that hangs by one capsule.
TEST(Outlines, FollowABreak) {
    Blueprint wall = shapes::wall({.size = {4, 1}, .columns = 4, .rows = 1});
    const auto joins = [](const JointSpec& j, std::uint32_t a, std::uint32_t b) {
        return std::minmax(j.a, j.b) == std::minmax(a, b);
    };
    std::erase_if(wall.joints, [&](const JointSpec& j) { return joins(j, 0, 1); });
    const State bitten = stateOf({wall});
    EXPECT_EQ(edgesOf(bitten), 8u) << "the first cell is open, its left and top sides hang";
    expectSound(bitten);
    const double cell = (wall.particles[1].position - wall.particles[0].position).norm();
    EXPECT_FALSE(encloses(bitten, 0, {-1.5 * cell, 0}));
    EXPECT_TRUE(encloses(bitten, 0, {-0.5 * cell, 0}));
    EXPECT_TRUE(encloses(bitten, 0, {1.5 * cell, 0}));
}

TEST(Outlines, LinesHaveNone) {
    const std::vector<Blueprint> lines{shapes::rope(),
                                       shapes::chain(),
                                       shapes::bridge(),
                                       shapes::floor({0, 0}, {3, 0}),
                                       shapes::ground({.points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}}}),
                                       shapes::ball()};
    const State state = stateOf(lines);
    for (std::uint32_t body = 0; body < lines.size(); ++body) {
        EXPECT_EQ(edgesOf(state, body), 0u) << lines[body].name;
        EXPECT_FALSE(encloses(state, body, {0.5, 0.5}));
    }
    for (std::uint32_t j = 0; j < state.joints.a.size(); ++j) EXPECT_EQ(outwardOf(state, j), 0);
}

TEST(Outlines, RoundOnesAreClosed) {
    const State state = stateOf({shapes::wheel({.segments = 16}), shapes::blob({.segments = 9}),
                                 shapes::jelly({.columns = 4, .rows = 5})});
    const std::size_t expected[] = {16, 9, 14};
    for (std::uint32_t body = 0; body < 3; ++body) {
        EXPECT_EQ(edgesOf(state, body), expected[body]);
        expectSound(state, body);
        EXPECT_TRUE(encloses(state, body, {0.1, 0.05}));
    }
}

/// Four rods fold and turn over; one diagonal more holds two of their corners apart, a second one
/// all of them.
TEST(Outlines, ADynamicLoopIsSolidInsideOfItsTriangles) {
    Blueprint frame;
    for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
        frame.particles.push_back({.position = p});
    for (std::uint32_t i = 0; i < 4; ++i)
        frame.joints.push_back({.a = i, .b = (i + 1) % 4, .radius = Real(0.02)});
    Blueprint braced = frame;
    braced.joints.push_back({.a = 0, .b = 2});
    const State state = stateOf({frame, braced});
    EXPECT_EQ(edgesOf(state, 0), 0u);
    EXPECT_FALSE(encloses(state, 0, {0.5, 0.5}));
    EXPECT_EQ(edgesOf(state, 1), 4u);
    expectSound(state, 1);
    EXPECT_TRUE(encloses(state, 1, {0.5, 0.4}));
}

/// The ground is to the right of a drawn line: round a room counter-clockwise, round an island
/// clockwise. What is braced is solid whatever its winding.
TEST(Outlines, TheWindingOfFixedLinesTellsRoomsFromIslands) {
    const std::vector<Vec2> room{{-4, 0}, {4, 0}, {4, 3}, {-4, 3}};
    const std::vector<Vec2> island(room.rbegin(), room.rend());
    for (const BodyKind kind : {BodyKind::fixed, BodyKind::kinematic}) {
        std::vector<Blueprint> plans{shapes::ground({.points = room, .closed = true}),
                                     shapes::ground({.points = island, .closed = true}),
                                     shapes::box(), turnedRound(shapes::box())};
        for (Blueprint& plan : plans) plan.kind = kind;
        const State state = stateOf(plans);
        EXPECT_FALSE(encloses(state, 0, {0, 1}));
        EXPECT_EQ(edgesOf(state, 0), 0u);
        EXPECT_TRUE(encloses(state, 1, {0, 1}));
        expectSound(state, 1);
        EXPECT_TRUE(encloses(state, 2, {0, 0}));
        EXPECT_TRUE(encloses(state, 3, {0, 0}));
    }
}

/// A ledge in a room does not brace it; a loop of which one side was drawn the other way is open.
TEST(Outlines, RoomsStayRooms) {
    Blueprint room = shapes::ground({.points = {{-4, 0}, {4, 0}, {4, 3}, {-4, 3}}, .closed = true});
    room.particles.push_back({.position = {-2, 1}});
    room.joints.push_back({.a = 0, .b = 4, .radius = Real(0.05)});
    EXPECT_EQ(edgesOf(stateOf({room})), 0u);
    Blueprint mixed = turnedRound(room);
    std::swap(mixed.joints[0].a, mixed.joints[0].b);
    EXPECT_EQ(edgesOf(stateOf({mixed})), 0u);
}

/// Two squares and a bridge between them, and a third square beside: three loops, one body.
TEST(Outlines, ABodyMayHaveSeveralLoops) {
    Blueprint plan;
    for (const Real x : {Real(0), Real(3), Real(6)})
        for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
            plan.particles.push_back({.position = corner + Vec2(x, 0)});
    for (std::uint32_t first : {0u, 4u, 8u})
        for (std::uint32_t i = 0; i < 4; ++i)
            plan.joints.push_back({.a = first + i, .b = first + (i + 1) % 4, .radius = Real(0.05)});
    for (std::uint32_t first : {0u, 4u, 8u}) plan.joints.push_back({.a = first, .b = first + 2});
    plan.joints.push_back({.a = 2, .b = 7, .radius = Real(0.05)});
    const State state = stateOf({shapes::rope(), plan});
    EXPECT_EQ(edgesOf(state, 1), 12u);
    expectSound(state, 1);
    EXPECT_EQ(outwardOf(state, static_cast<std::uint32_t>(state.joints.a.size()) - 1), 0);
    for (const double x : {0.5, 3.5, 6.5}) EXPECT_TRUE(encloses(state, 1, {x, 0.5}));
    for (const double x : {-0.5, 2.0, 5.0, 7.5}) EXPECT_FALSE(encloses(state, 1, {x, 0.5}));
}

/// Capsules on each other, twice the same one, and one of no length at rest.
TEST(Outlines, CoveredCapsulesDoNotOpenALoop) {
    Blueprint plan;
    plan.particles = {{},
                      {.position = {1, 0}},
                      {.position = {2, 0}},
                      {.position = {2, 1}},
                      {.position = {0, 1}},
                      {.position = {0, 1}}};
    const auto capsule = [&](std::uint32_t a, std::uint32_t b) {
        plan.joints.push_back({.a = a, .b = b, .radius = Real(0.05)});
    };
    for (std::uint32_t i = 0; i < 5; ++i) capsule(i, (i + 1) % 5);
    capsule(0, 2);
    capsule(3, 2);
    capsule(4, 5);
    for (const std::uint32_t braced : {0u, 1u}) plan.joints.push_back({.a = braced, .b = 3});
    const State state = stateOf({plan});
    EXPECT_EQ(edgesOf(state), 5u);
    expectSound(state);
    EXPECT_TRUE(encloses(state, 0, {1, 0.5}));
}

/// Rays through corners and along edges count each crossing once: a fine grid of points against
/// the inequalities of a tilted square and of an upright one.
TEST(Outlines, EnclosesIsExactAtTheHeightOfCorners) {
    Blueprint diamond = shapes::box(), square = shapes::box();
    const Vec2 tilted[] = {{0, -2}, {2, 0}, {0, 2}, {-2, 0}};
    const Vec2 upright[] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
    for (std::size_t i = 0; i < 4; ++i) {
        diamond.particles[i].position = tilted[i];
        square.particles[i].position = upright[i];
    }
    const State state = stateOf({diamond, square});
    for (int i = -10; i <= 10; ++i) {
        for (int k = -10; k <= 10; ++k) {
            const Point p(0.25 * i, 0.25 * k);
            const double sum = std::abs(p[0]) + std::abs(p[1]);
            const double most = std::max(std::abs(p[0]), std::abs(p[1]));
            if (sum != 2) {
                EXPECT_EQ(encloses(state, 0, p), sum < 2) << p.transpose();
            }
            if (most != 2) {
                EXPECT_EQ(encloses(state, 1, p), most < 2) << p.transpose();
            }
        }
    }
}

/// The sides come from the blueprint, the place from now: a body bent and turned keeps them.
TEST(Outlines, FollowTheBodyWhereItIs) {
    State state = stateOf({shapes::box({.size = {2, 2}})});
    for (Point& p : state.particles.position) p = Point(1e6, -2e6) + Point(-p[1], p[0]);
    EXPECT_TRUE(encloses(state, 0, {1e6 + 0.9, -2e6}));
    EXPECT_FALSE(encloses(state, 0, {0, 0}));
    EXPECT_EQ(outwardOf(state, 0), 1);
}

}  // namespace
}  // namespace sulfur
