#include "helpers.hpp"

namespace sulfur {
namespace {

TEST(Shapes, PaperBoxHasFourParticlesAndSixJoints) {
    const Blueprint plan = shapes::box({.solidInertia = false});
    EXPECT_EQ(plan.particles.size(), 4u);
    EXPECT_EQ(plan.joints.size(), 6u);
    for (const auto& p : plan.particles) EXPECT_EQ(p.mass, Real(0.25));
}

/// Particle i is corner i, by the radius further inside, and joint i the side to the next corner.
void expectCorners(const Blueprint& plan, const std::vector<Vec2>& corners) {
    const auto count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        EXPECT_LT((plan.particles[i].position - corners[i]).norm(), 1e-6) << i;
        EXPECT_EQ(plan.joints[i].a, i);
        EXPECT_EQ(plan.joints[i].b, (i + 1) % count);
    }
}

TEST(Shapes, CornersOfABoxGoAnticlockwiseFromTheLowerLeft) {
    for (const bool solid : {false, true})
        expectCorners(shapes::box({.size = {2, 1}, .radius = Real(0.1), .solidInertia = solid}),
                      {{Real(-0.9), Real(-0.4)},
                       {Real(0.9), Real(-0.4)},
                       {Real(0.9), Real(0.4)},
                       {Real(-0.9), Real(0.4)}});
}

TEST(Shapes, CornersOfAPolygonComeAsTheyAreGiven) {
    expectCorners(
        shapes::polygon({.points = {{0, 0}, {2, 0}, {2, 1}, {0, 1}}, .radius = Real(0.1)}),
        {{Real(0.1), Real(0.1)},
         {Real(1.9), Real(0.1)},
         {Real(1.9), Real(0.9)},
         {Real(0.1), Real(0.9)}});
    expectCorners(
        shapes::polygon({.points = {{2, 1}, {2, 0}, {0, 0}, {0, 1}}, .radius = Real(0.1)}),
        {{Real(1.9), Real(0.9)},
         {Real(1.9), Real(0.1)},
         {Real(0.1), Real(0.1)},
         {Real(0.1), Real(0.9)}});
}

TEST(Shapes, RopeRunsFromEndToEnd) {
    const Blueprint plan = shapes::rope({.from = {1, 2}, .to = {1, 0}, .links = 40, .mass = 2});
    EXPECT_EQ(plan.particles.size(), 41u);
    EXPECT_EQ(plan.joints.size(), 40u);
    EXPECT_EQ(plan.particles.front().position, Vec2(1, 2));
    EXPECT_EQ(plan.particles.back().position, Vec2(1, 0));
    EXPECT_NEAR(plan.mass(), 2, 1e-5);
    EXPECT_NEAR(*plan.joints[7].restLength, 0.05, 1e-7);
}

TEST(Shapes, GroundClosesAndHasOuterThickness) {
    const Blueprint open = shapes::ground({.points = {{0, 0}, {1, 0}, {1, 1}}});
    const Blueprint closed = shapes::ground({.points = {{0, 0}, {1, 0}, {1, 1}}, .closed = true});
    EXPECT_EQ(open.joints.size(), 2u);
    EXPECT_EQ(closed.joints.size(), 3u);
    EXPECT_EQ(open.kind, BodyKind::fixed);
}

/// What is drawn between two pins hangs a little, however it is turned.
TEST(Shapes, RopeBetweenTwoPinsHasSlack) {
    for (const Vec2& to : {Vec2(4, 0), Vec2(-4, 1), Vec2(0, 3), Vec2(0, -3)}) {
        const Blueprint plan = shapes::rope({.to = to, .pinFirst = true, .pinLast = true});
        const double way = static_cast<double>(to.norm());
        Point down = Point(to.y(), -to.x()) / way;
        if (down[1] > 0 || (down[1] == 0 && down[0] < 0)) down = -down;
        double length = 0, sag = 0;
        for (std::size_t i = 0; i + 1 < plan.particles.size(); ++i) {
            const Vec2 link = plan.particles[i + 1].position - plan.particles[i].position;
            EXPECT_NEAR(link.norm(), *plan.joints[i].restLength, 1e-6);
            length += static_cast<double>(link.norm());
            sag = std::max(sag, down.dot(plan.particles[i].position.cast<double>()));
        }
        EXPECT_NEAR(length, 1.02 * way, 1e-5 * way);
        EXPECT_NEAR(sag, way * std::sqrt(3 * 0.02 / 8), 2e-3 * way);
        EXPECT_LT((plan.particles.back().position - to).norm(), 1e-6);
    }
    const auto isStraight = [](const shapes::RopeOptions& options) {
        const Blueprint plan = shapes::rope(options);
        return plan.particles[plan.particles.size() / 2].position[1] == 0;
    };
    EXPECT_TRUE(isStraight({.to = {4, 0}}));
    EXPECT_TRUE(isStraight({.to = {4, 0}, .pinFirst = true}));
    EXPECT_TRUE(isStraight({.to = {4, 0}, .slack = Real(0), .pinFirst = true, .pinLast = true}));
    EXPECT_TRUE(isStraight({.to = {4, 0}, .links = 1, .pinFirst = true, .pinLast = true}));
    EXPECT_FALSE(isStraight({.to = {4, 0}, .slack = Real(0.5)}));
    EXPECT_THROW(shapes::rope({.slack = Real(-0.1)}), Error);
    EXPECT_THROW(shapes::rope({.links = 1, .slack = Real(0.1)}), Error);
}

/// Slack up to ten times the way, which is nearly a circle.
TEST(Shapes, RopeMayBeMuchLongerThanTheWay) {
    for (const Real slack : {Real(1e-4), Real(0.5), Real(3), Real(10)}) {
        const Blueprint plan = shapes::rope({.to = {1, 0}, .links = 40, .slack = slack});
        for (std::size_t i = 0; i + 1 < plan.particles.size(); ++i) {
            const Vec2 link = plan.particles[i + 1].position - plan.particles[i].position;
            const Real wanted = (1 + slack) / 40;
            EXPECT_NEAR(link.norm(), wanted, 1e-4 * static_cast<double>(wanted)) << slack;
        }
        EXPECT_LT((plan.particles.back().position - Vec2(1, 0)).norm(), 1e-5);
    }
}

TEST(Shapes, ChainIsARopeOfHeavyRigidLinks) {
    const Blueprint plan = shapes::chain({.from = {0, 0}, .to = {3, 0}, .pinFirst = true});
    EXPECT_EQ(plan.joints.size(), 25u);
    EXPECT_TRUE(plan.particles.front().pinned);
    EXPECT_FALSE(plan.particles.back().pinned);
    EXPECT_NEAR(plan.mass(), 6, 1e-5);
    for (const auto& link : plan.joints) EXPECT_EQ(link.stiffness, infinite);
}

TEST(Shapes, BridgeHangsBetweenTwoPins) {
    const Blueprint plan = shapes::bridge({.planks = 10, .sag = Real(0.4), .mass = 20});
    ASSERT_EQ(plan.particles.size(), 11u);
    EXPECT_EQ(plan.joints.size(), 10u);
    EXPECT_EQ(plan.particles.front().position, Vec2(-2, 0));
    EXPECT_EQ(plan.particles.back().position, Vec2(2, 0));
    EXPECT_NEAR(plan.particles[5].position.y(), -0.4, 1e-6);
    for (std::size_t i = 0; i < 11; ++i) {
        EXPECT_EQ(plan.particles[i].pinned, i == 0 || i == 10);
        EXPECT_EQ(plan.particles[i].mass, i == 0 || i == 10 ? 1 : 2);
    }
    // It hangs: neither end moves, and the middle stays about where it was.
    World world;
    const Body body = world.add(plan);
    test::run(world, 5);
    EXPECT_EQ(world.position(body.front()), Point(-2, 0));
    EXPECT_NEAR(world.position(body[5]).y(), -0.4, 0.1);
}

TEST(Shapes, ClothAndWallArePinnedWhereAsked) {
    const Blueprint cloth = shapes::cloth({.columns = 4, .rows = 3});
    for (std::size_t i = 0; i < cloth.particles.size(); ++i)
        EXPECT_EQ(cloth.particles[i].pinned, i == 8 || i == 11) << i;
    EXPECT_EQ(cloth.joints.size(), 17u);
    for (const auto& joint : cloth.joints) EXPECT_GT(joint.radius, 0);
    const auto braced = shapes::cloth({.columns = 4, .rows = 3, .diagonals = true});
    EXPECT_EQ(braced.joints.size(), 29u);
    const Blueprint wall = shapes::wall({.columns = 3, .rows = 2, .pinBottom = true});
    for (std::size_t i = 0; i < wall.particles.size(); ++i)
        EXPECT_EQ(wall.particles[i].pinned, i < 4) << i;
}

TEST(Shapes, AWallFallsApartUnderAHeavyBlow) {
    World world;
    world.add(shapes::floor({-20, -0.05f}, {20, -0.05f}));
    const Body wall = world.add(shapes::wall({.pinBottom = true}), {.position = {0, 0.55}});
    test::run(world, 0.5);
    EXPECT_EQ(world.joints(wall).size(), shapes::wall().joints.size());  // it carries itself
    const Body shot = world.add(shapes::ball({.mass = 50}), {.position = {-3, 0.7}});
    world.setVelocity(shot, {30, 0});
    test::run(world, 0.5);
    EXPECT_LT(world.joints(wall).size(), shapes::wall().joints.size());
    EXPECT_EQ(world.validate(), "");
}

TEST(Shapes, RefuseImpossibleSizes) {
    EXPECT_THROW(shapes::box({.size = {0.01, 1}}), Error);
    EXPECT_THROW(shapes::box({.mass = 0}), Error);
    EXPECT_THROW(shapes::ball({.radius = -1}), Error);
    EXPECT_THROW(shapes::rope({.from = {1, 1}, .to = {1, 1}}), Error);
    EXPECT_THROW(shapes::rope({.links = -3}), Error);
    EXPECT_THROW(shapes::jelly({.columns = 1}), Error);
    EXPECT_THROW(shapes::jelly({.size = {0.1f, 0.1f}}), Error);
    EXPECT_THROW(shapes::blob({.segments = 2}), Error);
    EXPECT_THROW(shapes::blob({.skinRadius = Real(0.2)}), Error);
    EXPECT_THROW(shapes::wheel({.segments = 2}), Error);
    EXPECT_THROW(shapes::wheel({.rimRadius = Real(0.2)}), Error);
    EXPECT_THROW(shapes::wheel({.mass = -1}), Error);
    EXPECT_THROW(shapes::chain({.from = {1, 1}, .to = {1, 1}}), Error);
    EXPECT_THROW(shapes::bridge({.planks = 0}), Error);
    EXPECT_THROW(shapes::bridge({.sag = -1}), Error);
    EXPECT_THROW(shapes::cloth({.columns = 2}), Error);
    EXPECT_THROW(shapes::cloth({.radius = -1}), Error);
    EXPECT_THROW(shapes::wall({.rows = 0}), Error);
    EXPECT_THROW(shapes::wall({.strength = -1}), Error);
    EXPECT_THROW(shapes::ground({.points = {{0, 0}}}), Error);
    EXPECT_THROW(shapes::floor({0, 0}, {0, 0}), Error);
}

TEST(Shapes, RefuseImpossiblePolygons) {
    const auto refused = [](std::vector<Vec2> points, const char* reason, Real radius = 0.01f) {
        try {
            shapes::polygon({.points = std::move(points), .radius = radius});
            ADD_FAILURE() << "accepted: " << reason;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
    };
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    refused({{0, 0}, {1, 0}}, "3 to 200");
    refused({{0, 0}, {1, 0}, {nan, 1}}, "finite");
    refused({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, "no extent");
    refused({{0, 0}, {1, 0}, {2, 0}}, "no extent");
    refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "touch");
    refused({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "narrowest", 0.6f);
    // A waist that is thinner than the capsules.
    refused({{0, 0}, {2, 0}, {2, 1}, {1, 0.01f}, {0, 1}}, "narrowest", 0.05f);
    refused({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "inertia", 0.3f);
}

}  // namespace
}  // namespace sulfur
