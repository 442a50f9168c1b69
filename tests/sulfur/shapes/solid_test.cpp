// Ready-made shapes have mass, centre, moment of inertia and outer size of the solid that they
// stand for, and rigid ones are rigid.
#include <Eigen/LU>
#include <functional>

#include "helpers.hpp"

namespace sulfur {
namespace {

/// What a shape is compared with.
struct Moments {
    double mass = 0;
    Point centre{0, 0};
    double inertia = 0;  // about the centre
};

Moments momentsOf(const Blueprint& plan) {
    Moments m;
    for (const auto& p : plan.particles) {
        m.mass += static_cast<double>(p.mass);
        m.centre += static_cast<double>(p.mass) * p.position.cast<double>();
    }
    m.centre /= m.mass;
    for (const auto& p : plan.particles)
        m.inertia +=
            static_cast<double>(p.mass) * (p.position.cast<double>() - m.centre).squaredNorm();
    return m;
}

/// A solid of uniform density by brute force: small squares whose middle is inside, in a grid that
/// is turned, so that no edge of a shape runs along their middles.
Moments integrate(const std::function<bool(const Point&)>& inside, double reach, double mass) {
    constexpr int steps = 1500;
    const double wide = 1.5 * reach, cell = 2 * wide / steps;
    const Point along(std::cos(0.31), std::sin(0.31)), up(-along.y(), along.x());
    double count = 0, second = 0;
    Point first(0, 0);
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
            const Point p = (cell * (i + 0.5) - wide) * along + (cell * (k + 0.5) - wide) * up;
            if (!inside(p)) continue;
            ++count;
            first += p;
            second += p.squaredNorm() + cell * cell / 6;  // each square has inertia of its own
        }
    }
    const Point centre = first / count;
    return {mass, centre, mass * (second / count - centre.squaredNorm())};
}

std::function<bool(const Point&)> rectangle(Vec2 size) {
    return [size](const Point& p) {
        return std::abs(p.x()) < static_cast<double>(size.x()) / 2 &&
               std::abs(p.y()) < static_cast<double>(size.y()) / 2;
    };
}

std::function<bool(const Point&)> disc(double radius) {
    return [radius](const Point& p) { return p.norm() < radius; };
}

/// Even-odd rule.
std::function<bool(const Point&)> outline(const std::vector<Vec2>& points) {
    return [points](const Point& p) {
        bool in = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point a = points[i].cast<double>();
            const Point b = points[(i + 1) % points.size()].cast<double>();
            if ((a.y() > p.y()) == (b.y() > p.y())) continue;
            if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) in = !in;
        }
        return in;
    };
}

void expectSolid(const Blueprint& plan, const Moments& solid) {
    const Moments is = momentsOf(plan);
    const double size = std::sqrt(solid.inertia / solid.mass);
    EXPECT_NEAR(is.mass / solid.mass, 1, 1e-5);
    EXPECT_NEAR((is.centre - solid.centre).norm() / size, 0, 1e-3);
    EXPECT_NEAR(is.inertia / solid.inertia, 1, 1e-3);
    for (const auto& p : plan.particles) EXPECT_GT(static_cast<double>(p.mass), 1e-4 * solid.mass);
}

/// The rectangle around all capsules and discs.
struct Extent {
    Vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
};

Extent extentOf(const Blueprint& plan) {
    Extent extent;
    for (const auto& j : plan.joints) {
        if (j.radius == 0) continue;
        for (const auto i : {j.a, j.b}) {
            const Vec2 margin(j.radius, j.radius);
            extent.low = extent.low.cwiseMin(plan.particles[i].position - margin);
            extent.high = extent.high.cwiseMax(plan.particles[i].position + margin);
        }
    }
    return extent;
}

void expectOuterSize(const Blueprint& plan, Vec2 size) {
    const Extent extent = extentOf(plan);
    EXPECT_NEAR((extent.high - extent.low - size).norm(), 0, 1e-5);
    EXPECT_NEAR((extent.high + extent.low).norm(), 0, 1e-5);
    // Structural particles stay inside as well.
    for (const auto& p : plan.particles)
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_LE(std::abs(p.position[axis]), size[axis] / 2 + Real(1e-6));
}

/// Freedoms of motion that no rigid joint resists to first order; 3 for a rigid body.
long freedoms(const Blueprint& plan) {
    const auto n = static_cast<Eigen::Index>(plan.particles.size());
    Eigen::MatrixXd lengths =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(plan.joints.size()), 2 * n);
    for (Eigen::Index row = 0; row < lengths.rows(); ++row) {
        const auto& j = plan.joints[static_cast<std::size_t>(row)];
        if (j.stiffness != infinite) continue;
        const Point along = (plan.particles[j.b].position - plan.particles[j.a].position)
                                .cast<double>()
                                .normalized();
        lengths.block<1, 2>(row, 2 * j.a) = -along.transpose();
        lengths.block<1, 2>(row, 2 * j.b) = along.transpose();
    }
    Eigen::FullPivLU<Eigen::MatrixXd> lu(lengths);
    lu.setThreshold(1e-6);
    return 2 * static_cast<long>(n) - static_cast<long>(lu.rank());
}

TEST(SolidShapes, Box) {
    // The last three have capsules so thick that the corners are too near to the middle.
    const std::pair<Vec2, Real> cases[] = {
        {{1, 1}, Real(0.02)},         {{2, 0.5f}, Real(0.02)},    {{0.3f, 0.4f}, Real(0.02)},
        {{2, 0.05f}, Real(0.02)},     {{0.1f, 0.1f}, Real(0.02)}, {{0.06f, 0.06f}, Real(0.02)},
        {{0.05f, 0.09f}, Real(0.02)}, {{1, 1.4f}, Real(0.49)},
    };
    for (const auto& [size, radius] : cases) {
        SCOPED_TRACE(size.transpose());
        const Blueprint plan = shapes::box({.size = size, .mass = 3, .radius = radius});
        const double reach = static_cast<double>(size.maxCoeff()) / 2;
        expectSolid(plan, integrate(rectangle(size), reach, 3));
        expectOuterSize(plan, size);
        EXPECT_EQ(freedoms(plan), 3);
    }
}

/// Radii, some of which leave the corners so near to the middle that they nearly do by themselves.
std::vector<double> radiiOf(const Point& size) {
    std::vector<double> radii;
    for (const double share : {0.02, 0.3, 0.5, 0.7, 0.8, 0.9, 0.98})
        radii.push_back(share * size.minCoeff() / 2);
    for (const double share : {0.979, 0.981, 0.99, 0.999, 1.0, 1.001}) {
        // Where |size / 2 - radius|^2 share is the radius of gyration, squared.
        const double corner2 = size.squaredNorm() / 12 / share, sum = size.sum();
        const double radius =
            (sum - std::sqrt(sum * sum - 2 * size.squaredNorm() + 8 * corner2)) / 4;
        if (radius < 0.99 * size.minCoeff() / 2) radii.push_back(radius);
    }
    return radii;
}

TEST(SolidShapes, BoxOfAnySizeHasMassesThatAWorldTakes) {
    int ends = 0, both = 0;
    for (double length = 1e-3; length < 1.1e3; length *= 2.3)
        for (double ratio = 1; ratio < 1.1e4; ratio *= 1.13)
            for (const Point& size : {Point(length, length / ratio), Point(length / ratio, length)})
                for (const double radius : radiiOf(size)) {
                    const Blueprint plan = shapes::box({.size = size.cast<Real>(),
                                                        .mass = 2,
                                                        .radius = static_cast<Real>(radius)});
                    const Moments m = momentsOf(plan);
                    const double inertia = 2 * size.squaredNorm() / 12;
                    ASSERT_NEAR(m.mass, 2, 2e-6) << size.transpose() << ", " << radius;
                    ASSERT_NEAR(m.inertia / inertia, 1, 2e-5) << size.transpose() << ", " << radius;
                    ends += plan.particles.size() == 6;
                    both += plan.particles.size() == 7;
                    World world;
                    world.add(plan);
                }
    EXPECT_GT(ends, 300);
    EXPECT_GT(both, 300) << "corners that nearly do by themselves";
}

TEST(SolidShapes, BoxWhoseCornersNearlyDoByThemselves) {
    // What was refused once for a particle whose mass is negative.
    for (const Vec2& size : {Vec2(0.0951f, 0.0946f), Vec2(0.0986f, 0.0931f), Vec2(0.1086f, 0.0516f),
                             Vec2(0.0676f, 0.1101f)}) {
        SCOPED_TRACE(size.transpose());
        const Blueprint plan = shapes::box({.size = size, .mass = 40});
        EXPECT_EQ(plan.particles.size(), 7u);
        expectSolid(plan, integrate(rectangle(size), static_cast<double>(size.maxCoeff()) / 2, 40));
        expectOuterSize(plan, size);
        EXPECT_EQ(freedoms(plan), 3);
    }
}

TEST(SolidShapes, PlainBoxHasTheInertiaOfItsCorners) {
    const Moments m = momentsOf(shapes::box({.mass = 2, .solidInertia = false}));
    EXPECT_NEAR(m.inertia, 2 * 2 * 0.48 * 0.48, 1e-5);
}

TEST(SolidShapes, BlobAndWheel) {
    const Moments solid = integrate(disc(0.6), 0.6, 2);
    for (const int segments : {4, 8, 12, 40}) {
        for (const Real skin : {Real(0.01), Real(0.1)}) {
            const Blueprint blob = shapes::blob(
                {.radius = Real(0.6), .segments = segments, .mass = 2, .skinRadius = skin});
            expectSolid(blob, solid);
            expectOuterSize(blob, {1.2f, 1.2f});
            const Blueprint wheel = shapes::wheel(
                {.radius = Real(0.6), .segments = segments, .mass = 2, .rimRadius = skin});
            expectSolid(wheel, solid);
            expectOuterSize(wheel, {1.2f, 1.2f});
            EXPECT_EQ(freedoms(wheel), 3);
        }
    }
    EXPECT_EQ(freedoms(shapes::wheel({.segments = 3})), 3);
    EXPECT_GT(freedoms(shapes::wheel({.spokeStiffness = 3000})), 3);
}

TEST(SolidShapes, Jelly) {
    for (const Vec2& size : {Vec2(1, 1), Vec2(0.6f, 0.46f), Vec2(3, 0.2f)}) {
        for (const auto& [columns, rows] :
             {std::pair(2, 2), {2, 3}, {3, 3}, {5, 4}, {4, 4}, {2, 9}, {9, 2}, {12, 12}, {30, 3}}) {
            SCOPED_TRACE(std::to_string(columns) + " x " + std::to_string(rows));
            const Blueprint plan =
                shapes::jelly({.size = size, .columns = columns, .rows = rows, .mass = 4});
            expectSolid(plan, integrate(rectangle(size), static_cast<double>(size.x()) / 2, 4));
            expectOuterSize(plan, size);
            Blueprint rigid = plan;
            for (auto& joint : rigid.joints) joint.stiffness = infinite;
            EXPECT_EQ(freedoms(rigid), 3);
        }
    }
}

TEST(SolidShapes, ClothAndWall) {
    const Vec2 size(2, 1.5f);
    const Moments solid = integrate(rectangle(size), 1, 7);
    for (const auto& [columns, rows] : {std::pair(3, 3), {4, 3}, {7, 5}, {12, 12}}) {
        SCOPED_TRACE(std::to_string(columns) + " x " + std::to_string(rows));
        const Blueprint cloth =
            shapes::cloth({.size = size, .columns = columns, .rows = rows, .mass = 7});
        expectSolid(cloth, solid);
        expectOuterSize(cloth, size);
        const Blueprint wall =
            shapes::wall({.size = size, .columns = columns - 2, .rows = rows - 1, .mass = 7});
        expectSolid(wall, solid);
        expectOuterSize(wall, size);
        EXPECT_EQ(freedoms(wall), 3);
    }
}

struct NamedPolygon {
    const char* name;
    std::vector<Vec2> points;
    Real radius = Real(0.02);
};

std::vector<NamedPolygon> polygons() {
    std::vector<Vec2> star, many;
    for (int i = 0; i < 10; ++i) {
        const double angle = 0.628318530718 * i, r = i % 2 == 0 ? 1.0 : 0.45;
        star.emplace_back(Point(r * std::cos(angle), r * std::sin(angle)).cast<Real>());
    }
    for (int i = 0; i < 60; ++i) {
        const double angle = 0.104719755 * i;
        many.emplace_back(Point(1.2 * std::cos(angle) + 0.5, 0.7 * std::sin(angle)).cast<Real>());
    }
    return {
        {"triangle", {{0, 0}, {1, 0.1f}, {0.3f, 0.8f}}},
        {"clockwise", {{0, 1}, {1, 1}, {1, 0}, {0, 0}}},
        {"thick", {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}, Real(0.15)},
        {"flat corners",
         {{0, 0}, {0.5f, 0}, {1, 0}, {1, 0.5f}, {1, 1}, {0.5f, 1}, {0, 1}, {0, 0.5f}}},
        {"L", {{0, 0}, {1, 0}, {1, 0.3f}, {0.3f, 0.3f}, {0.3f, 1.2f}, {0, 1.2f}}},
        {"U",
         {{0, 0}, {1.5f, 0}, {1.5f, 1}, {1.2f, 1}, {1.2f, 0.3f}, {0.3f, 0.3f}, {0.3f, 1}, {0, 1}}},
        {"arrow", {{0, 0}, {1, 0.5f}, {0, 1}, {0.4f, 0.5f}}},
        {"star", star},
        {"ellipse away from the origin", many},
    };
}

TEST(SolidShapes, Polygon) {
    for (const auto& [name, points, radius] : polygons()) {
        SCOPED_TRACE(name);
        const Blueprint plan = shapes::polygon({.points = points, .mass = 3, .radius = radius});
        double reach = 0;
        for (const auto& point : points)
            reach = std::max(reach, static_cast<double>(point.cwiseAbs().maxCoeff()));
        expectSolid(plan, integrate(outline(points), reach, 3));
        EXPECT_EQ(freedoms(plan), 3);
        EXPECT_EQ(plan.particles.size(), points.size() + 1);
        // The capsules' outer sides lie on the edges: their axes at the distance of the radius.
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 edge = (points[(i + 1) % points.size()] - points[i]).normalized();
            for (const auto k : {i, (i + 1) % points.size()}) {
                const Vec2 apart = plan.particles[k].position - points[i];
                EXPECT_NEAR(std::abs(cross(edge, apart)), radius, 1e-5);
            }
            EXPECT_TRUE(outline(points)(plan.particles[i].position.cast<double>()));
        }
    }
}

/// What is at most `radius` from the outline of the first `count` particles, or inside of it.
std::function<bool(const Point&)> rounded(const Blueprint& plan, std::size_t count, double radius) {
    std::vector<Vec2> inner;
    for (std::size_t i = 0; i < count; ++i) inner.push_back(plan.particles[i].position);
    return [inner, radius, inside = outline(inner)](const Point& p) {
        if (inside(p)) return true;
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const Point a = inner[i].cast<double>();
            const Point along = inner[(i + 1) % inner.size()].cast<double>() - a, v = p - a;
            const double share = std::clamp(v.dot(along) / along.squaredNorm(), 0.0, 1.0);
            if ((v - share * along).norm() < radius) return true;
        }
        return false;
    };
}

TEST(SolidShapes, RoundedBox) {
    for (const auto& [size, radius] : {std::pair(Vec2(1, 1), 0.1),
                                       {Vec2(1, 1), 0.21},
                                       {Vec2(1, 1), 0.3},
                                       {Vec2(1, 1), 0.49},
                                       {Vec2(2, 1), 0.49},
                                       {Vec2(3, 0.4f), 0.15},
                                       {Vec2(0.2f, 0.6f), 0.09}}) {
        SCOPED_TRACE(std::to_string(size.x()) + ", " + std::to_string(radius));
        const Blueprint plan = shapes::box(
            {.size = size, .mass = 3, .radius = static_cast<Real>(radius), .rounded = true});
        const double reach = static_cast<double>(size.maxCoeff()) / 2;
        expectSolid(plan, integrate(rounded(plan, 4, radius), reach, 3));
        expectOuterSize(plan, size);
        EXPECT_EQ(freedoms(plan), 3);
    }
}

TEST(SolidShapes, RoundedPolygon) {
    for (const auto& [name, points, thin] : polygons()) {
        SCOPED_TRACE(name);
        for (const double share : {0.3, 1.0}) {
            const double radius = share * (points.size() > 20 ? 0.35 : 0.1);
            const Blueprint plan = shapes::polygon({.points = points,
                                                    .mass = 3,
                                                    .radius = static_cast<Real>(radius),
                                                    .rounded = true});
            double reach = 0;
            for (const auto& point : points)
                reach = std::max(reach, static_cast<double>(point.cwiseAbs().maxCoeff()));
            expectSolid(plan, integrate(rounded(plan, points.size(), radius), reach, 3));
            EXPECT_EQ(freedoms(plan), 3);
        }
    }
    EXPECT_THROW(shapes::polygon({.points = {{0, 0}, {1, 0.5f}, {0, 1}, {0.4f, 0.5f}},
                                  .radius = Real(0.15),
                                  .rounded = true}),
                 Error);
    // A square as thick as fits is nearly a disc.
    const Blueprint round = shapes::polygon({.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                             .mass = 2,
                                             .radius = Real(0.495),
                                             .rounded = true});
    EXPECT_NEAR(momentsOf(round).inertia, 2 * 0.25 / 2, 3e-3);
    EXPECT_EQ(round.particles.size(), 9u);
}

TEST(SolidShapes, SoftPolygonKeepsItsShapeAtRest) {
    World world{{.gravity = {0, 0}}};
    const auto plan = shapes::polygon({.points = polygons()[5].points, .stiffness = 500});
    const Body body = world.add(plan);
    test::run(world, 1);
    for (std::size_t i = 0; i < body.size(); ++i)
        EXPECT_NEAR((world.position(body[i]) - plan.particles[i].position.cast<double>()).norm(), 0,
                    1e-4);
}

}  // namespace
}  // namespace sulfur
