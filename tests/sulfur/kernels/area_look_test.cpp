// The kernel that looks at triangles gives the bits of plain functions, whatever instructions it
// uses.
#include "kernels/area_look.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sulfur/sulfur.hpp>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

class AreaLook : public testing::TestWithParam<detail::Instructions> {
protected:
    void SetUp() override { detail::useKernelsUpTo(GetParam()); }
    void TearDown() override { detail::useKernelsUpTo(detail::Instructions::avx512); }
};

/// Particles far from the origin, and three blocks of triangles between them.
struct Net {
    explicit Net(test::Random& random) {
        for (std::size_t i = 0; i < 40; ++i) {
            position.emplace_back(1000 + random.uniform(-1, 1), random.uniform(-1, 1));
            displacement.emplace_back(static_cast<Real>(random.uniform(-0.1, 0.1)),
                                      static_cast<Real>(random.uniform(-0.1, 0.1)));
        }
        for (auto* corners : {&a, &b, &c})
            for (std::size_t i = 0; i < 24; ++i)
                corners->push_back(2 * static_cast<std::uint32_t>(random.below(40)));
        for (std::size_t i = 0; i < 24; ++i)
            rest.push_back(static_cast<Real>(random.uniform(0, 1)));
    }

    Real areaAhead(std::size_t i) const {
        const auto way = [&](std::uint32_t to) {
            return Vec2((position[to / 2] - position[a[i] / 2]).cast<Real>() +
                        (displacement[to / 2] - displacement[a[i] / 2]));
        };
        return cross(way(b[i]), way(c[i]));
    }

    std::vector<Point> position;
    std::vector<Vec2> displacement;
    std::vector<std::uint32_t> a, b, c;
    std::vector<Real> rest;
    std::vector<std::uint8_t> flat = std::vector<std::uint8_t>(3, 0xff);
};

TEST_P(AreaLook, FindsThoseThatAreFlat) {
    test::Random random(7);
    for (int round = 0; round < 100; ++round) {
        Net net(random);
        detail::areaKernels().look(
            {net.position.data()->data(), net.displacement.data()->data(), net.a.data(),
             net.b.data(), net.c.data(), net.rest.data(), net.flat.data()},
            Real(0.3), 1, 3);
        EXPECT_EQ(net.flat[0], 0xff);
        for (std::size_t i = 8; i < 24; ++i)
            EXPECT_EQ((net.flat[i / 8] >> i % 8 & 1) != 0,
                      net.areaAhead(i) < Real(0.3) * net.rest[i]);
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, AreaLook,
                         testing::Values(detail::Instructions::baseline,
                                         detail::Instructions::avx512));

/// Jellies that fall onto each other and are pressed flat by what lies on them.
std::uint64_t hashOfAHeap(detail::Instructions most, std::uint32_t& pressed) {
    detail::useKernelsUpTo(most);
    World world;
    world.add(shapes::floor({-5, 0}, {5, 0}));
    const Blueprint plan =
        shapes::jelly({.columns = 4, .rows = 4, .mass = 1, .stiffness = 100, .damping = 1});
    for (int i = 0; i < 7; ++i) world.add(plan, {.position = {0.1 * i, 1 + 1.2 * i}});
    for (int i = 0; i < 600; ++i) {
        world.step();
        pressed = std::max(pressed, world.statistics().pressedTriangles);
    }
    detail::useKernelsUpTo(detail::Instructions::avx512);
    return world.hash();
}

TEST(AreasInLanes, SameBitsWithAnyInstructions) {
    std::uint32_t pressed = 0;
    EXPECT_EQ(hashOfAHeap(detail::Instructions::avx512, pressed),
              hashOfAHeap(detail::Instructions::baseline, pressed));
    EXPECT_GT(pressed, 10u);
}

}  // namespace
}  // namespace sulfur
