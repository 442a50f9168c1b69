// The kernels that find where candidates meet give the bits of the plain functions, whatever
// instructions they use.
#include "kernels/meeting_lanes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sulfur/sulfur.hpp>

#include "collision/meeting.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

using detail::MeetingBlock;

class MeetingLanes : public testing::TestWithParam<detail::Instructions> {
protected:
    void SetUp() override { detail::useKernelsUpTo(GetParam()); }
    void TearDown() override { detail::useKernelsUpTo(detail::Instructions::avx512); }
};

/// Places all round the capsule and near to it, now and then one on its axis or beside its end.
MeetingBlock makeBlock(test::Random& random) {
    MeetingBlock block{};
    const auto number = [&](double size) { return static_cast<Real>(random.uniform(-size, size)); };
    for (std::size_t i = 0; i < detail::meetingLanes; ++i) {
        block.x[i] = number(2);
        block.y[i] = number(1);
        block.endX[i] = number(2);
        block.endY[i] = random.below(4) == 0 ? 0 : number(1);
        if (random.below(8) == 0) block.y[i] = block.endY[i] = 0;
        if (random.below(8) == 0) block.endX[i] = block.endY[i] = 0;
        for (auto* move :
             {block.moveX, block.moveY, block.moveAX, block.moveAY, block.moveBX, block.moveBY})
            move[i] = number(0.02);
        block.reach[i] = Real(0.3);
    }
    return block;
}

TEST_P(MeetingLanes, MeetAsOneByOne) {
    test::Random random(7);
    int far = 0, beside = 0;
    for (int round = 0; round < 500; ++round) {
        std::array<MeetingBlock, 3> blocks{makeBlock(random), makeBlock(random), makeBlock(random)};
        detail::meetingKernels().meet(blocks.data(), blocks.size());
        for (const MeetingBlock& b : blocks)
            for (std::size_t i = 0; i < detail::meetingLanes; ++i) {
                const detail::Local l{{b.x[i], b.y[i]},
                                      {b.endX[i], b.endY[i]},
                                      {b.moveX[i], b.moveY[i]},
                                      {b.moveAX[i], b.moveAY[i]},
                                      {b.moveBX[i], b.moveBY[i]}};
                const detail::Look look = detail::lookAt(l, b.reach[i]);
                ASSERT_EQ(b.along[i], look.along);
                ASSERT_EQ(b.travel[i], look.travel);
                ASSERT_EQ(b.far[i] != 0, look.far);
                far += look.far ? 1 : 0;
                if (detail::isEnd(look.along)) continue;
                ++beside;
                const detail::Meeting m = detail::meetSide(l, look.along);
                ASSERT_EQ(b.normalX[i], m.normal[0]);
                ASSERT_EQ(b.normalY[i], m.normal[1]);
                ASSERT_EQ(b.distance[i], m.distance);
                const Vec2 moved = l.dp - (1 - look.along) * l.da - look.along * l.db;
                ASSERT_EQ(b.movedX[i], moved[0]);
                ASSERT_EQ(b.movedY[i], moved[1]);
                ASSERT_EQ(b.closing[i], m.normal.dot(moved));
            }
    }
    EXPECT_GT(far, 1000);
    EXPECT_GT(beside, 1000);
}

TEST_P(MeetingLanes, AreGatheredAsOneByOne) {
    test::Random random(8);
    detail::Particles particles;
    for (int i = 0; i < 50; ++i) {
        particles.position.emplace_back(random.uniform(-1e4, 1e4), random.uniform(-1, 1));
        particles.displacement.emplace_back(static_cast<Real>(random.uniform(-1, 1)),
                                            static_cast<Real>(random.uniform(-1, 1)));
    }
    const auto& x = particles.position;
    std::array<MeetingBlock, 3> blocks{};
    for (MeetingBlock& b : blocks)
        for (auto* list : {b.particle, b.a, b.b})
            for (std::size_t i = 0; i < detail::meetingLanes; ++i)
                list[i] = static_cast<std::uint32_t>(random.below(50));
    detail::meetingKernels().gather({x.data()->data(), particles.displacement.data()->data()},
                                    blocks.data(), blocks.size());
    for (const MeetingBlock& b : blocks)
        for (std::size_t i = 0; i < detail::meetingLanes; ++i) {
            const detail::Local l = detail::localise(particles, b.particle[i], b.a[i], b.b[i]);
            ASSERT_EQ(Vec2(b.x[i], b.y[i]), l.p);
            ASSERT_EQ(Vec2(b.endX[i], b.endY[i]), l.b);
            ASSERT_EQ(Vec2(b.moveX[i], b.moveY[i]), l.dp);
            ASSERT_EQ(Vec2(b.moveAX[i], b.moveAY[i]), l.da);
            ASSERT_EQ(Vec2(b.moveBX[i], b.moveBY[i]), l.db);
            const Point end = x[b.b[i]] - x[b.a[i]], p = x[b.particle[i]] - x[b.a[i]];
            ASSERT_EQ(b.beside[i], end[0] * p[1] - end[1] * p[0]);
        }
}

INSTANTIATE_TEST_SUITE_P(Kernels, MeetingLanes,
                         testing::Values(detail::Instructions::baseline,
                                         detail::Instructions::avx512));

}  // namespace
}  // namespace sulfur
