#include "model/box_grid.hpp"

#include <algorithm>
#include <cmath>

#include "helpers.hpp"

namespace sulfur {
namespace {

using detail::BoxGrid;
using detail::Chunk;

/// Boxes of sizes from 1 mm to 1 km, most of them small.
std::vector<Chunk> scatter(test::Random& random, int count) {
    std::vector<Chunk> chunks(static_cast<std::size_t>(count));
    for (Chunk& c : chunks) {
        const double size = std::pow(10.0, random.uniform(-3, 3));
        for (std::size_t axis = 0; axis < 2; ++axis) {
            c.low[axis] = random.uniform(-5, 5) * size;
            c.high[axis] = c.low[axis] + random.uniform(0, size);
        }
    }
    return chunks;
}

bool meets(const Chunk& c, const std::array<double, 2>& low, const std::array<double, 2>& high) {
    return c.low[0] <= high[0] && low[0] <= c.high[0] && c.low[1] <= high[1] && low[1] <= c.high[1];
}

/// Whether a disc meets a box on its way, by many places on it.
bool isOnWay(const Chunk& c, const Point& from, const Point& way, double radius) {
    constexpr int places = 20000;
    for (int k = 0; k <= places; ++k) {
        const Point p = from + k / double{places} * way;
        if (c.low[0] - radius <= p[0] && p[0] <= c.high[0] + radius && c.low[1] - radius <= p[1] &&
            p[1] <= c.high[1] + radius)
            return true;
    }
    return false;
}

TEST(BoxGrid, FindsAllThatABoxMeetsAndNothingElse) {
    test::Random random(5);
    std::vector<Chunk> chunks = scatter(random, 600);
    BoxGrid grid;
    for (std::uint32_t c = 0; c < chunks.size(); ++c) grid.insert(chunks, c);
    // Some go, some come back elsewhere.
    std::vector<bool> in(chunks.size(), true);
    for (std::uint32_t c = 0; c < chunks.size(); c += 3) {
        grid.remove(chunks, c);
        in[c] = c % 2 == 0;
        if (!in[c]) continue;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            chunks[c].low[axis] += 1;
            chunks[c].high[axis] += 1;
        }
        grid.insert(chunks, c);
    }
    for (int trial = 0; trial < 500; ++trial) {
        const double size = std::pow(10.0, random.uniform(-3, 3));
        const std::array low{random.uniform(-5, 5) * size, random.uniform(-5, 5) * size};
        const std::array high{low[0] + random.uniform(0, size), low[1] + random.uniform(0, size)};
        std::vector<std::uint32_t> found, expected;
        grid.forEachIn(chunks, low, high, [&](std::uint32_t c) { found.push_back(c); });
        for (std::uint32_t c = 0; c < chunks.size(); ++c)
            if (in[c] && meets(chunks[c], low, high)) expected.push_back(c);
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected) << trial;
    }
}

TEST(BoxGrid, FindsAllOnAWay) {
    test::Random random(6);
    std::vector<Chunk> chunks = scatter(random, 300);
    BoxGrid grid;
    for (std::uint32_t c = 0; c < chunks.size(); ++c) grid.insert(chunks, c);
    std::size_t hits = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const double size = std::pow(10.0, random.uniform(-2, 4));
        const Point from(random.uniform(-1, 1) * size, random.uniform(-1, 1) * size);
        Point way(random.uniform(-1, 1) * size, random.uniform(-1, 1) * size);
        if (trial % 5 == 0) way[trial % 2] = 0;
        const double radius = trial % 3 == 0 ? 0 : std::pow(10.0, random.uniform(-3, 1));
        std::vector<std::uint32_t> found;
        const double enough = 1;
        grid.forEachAlong(chunks, from, way, radius, enough,
                          [&](std::uint32_t c) { found.push_back(c); });
        std::sort(found.begin(), found.end());
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << trial;
        for (std::uint32_t c = 0; c < chunks.size(); ++c)
            if (isOnWay(chunks[c], from, way, radius)) {
                EXPECT_TRUE(std::binary_search(found.begin(), found.end(), c)) << trial;
                ++hits;
            }
    }
    EXPECT_GT(hits, 500u);
}

/// What begins beyond what is known already is not visited.
TEST(BoxGrid, StopsWhereNothingInterests) {
    std::vector<Chunk> chunks(1000);
    BoxGrid grid;
    for (std::uint32_t c = 0; c < chunks.size(); ++c) {
        chunks[c].low = {static_cast<double>(c), 0};
        chunks[c].high = {c + 0.5, 0.5};
        grid.insert(chunks, c);
    }
    double enough = 1;
    int visits = 0;
    grid.forEachAlong(chunks, Point(-1, 0.2), Point(1000, 0), 0, enough, [&](std::uint32_t c) {
        ++visits;
        enough = std::min(enough, (c + 1) / 1000.0);
    });
    EXPECT_LE(visits, 8);
    EXPECT_NEAR(enough, 0.001, 1e-12);
}

}  // namespace
}  // namespace sulfur
