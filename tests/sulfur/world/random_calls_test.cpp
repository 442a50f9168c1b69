// Whoever calls World in any order, with good and bad arguments, finds a sound world afterwards.
// The caller is in calls/; the fuzz target `api` runs it too.
#include <cstdlib>

#include "calls/caller.hpp"
#include "helpers.hpp"

namespace sulfur {
namespace {

using test::Caller;
using test::Calls;

#ifdef __SANITIZE_ADDRESS__
constexpr int manyCalls = 12000;  // every one of them costs some ten times as much
#else
constexpr int manyCalls = 100000;
#endif

TEST(RandomCalls, KeepTheInvariants) {
    int refused = 0, accepted = 0, broken = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Caller caller(seed, true);
        for (int i = 0; i < manyCalls / 5; ++i) {
            caller.call();
            if (i % 20 == 0) caller.check();
            ASSERT_FALSE(HasFailure()) << "seed " << seed << ", call " << i;
        }
        refused += caller.refused();
        accepted += caller.accepted();
        broken += caller.broken();
    }
    EXPECT_GT(refused, manyCalls / 20);
    EXPECT_GT(accepted, manyCalls / 2);
    EXPECT_GT(broken, manyCalls / 500);
}

/// What falls, breaks and vanishes is never faster than a fall through the room makes it, and what
/// starts inside of other things is only pushed out.
TEST(RandomCalls, BreakingAndRemovingGivesNoEnergy) {
    const double deepest =
        std::sqrt(2 * 9.81 * 12);  // m/s: from the highest place made to the floor
    int broken = 0;
    // In the last five, what contacts held between taut links and what stands fast once flew off.
    std::vector<std::uint64_t> seeds{31, 32, 33, 1449, 1463, 1502, 1745, 1936};
    const char* more = std::getenv("SEEDS");  // how many more, from 1010 on
    for (int i = 0; more && i < std::atoi(more); ++i)
        seeds.push_back(1010 + static_cast<std::uint64_t>(i));
    for (const std::uint64_t seed : seeds) {
        Caller caller(seed, false, Calls::harmless);
        for (int i = 0; i < 1500; ++i) {
            caller.call();
            const World& world = caller.world();
            for (const BodyId body : world.bodies()) {
                if (world.centreOfMass(body)[1] < -1) continue;  // fell off the room
                ASSERT_LT(static_cast<double>(world.meanVelocity(body).norm()), deepest)
                    << "seed " << seed << ", call " << i << ", " << world.particles(body).size()
                    << " particles";
            }
        }
        caller.check();
        broken += caller.broken();
    }
    EXPECT_GT(broken, 10);
}

/// Neither a second run nor questions in between change anything.
TEST(RandomCalls, GiveTheSameHashAgain) {
    for (std::uint64_t seed = 11; seed <= 12; ++seed) {
        Caller first(seed, false), again(seed, false), asked(seed, true);
        for (int i = 0; i < manyCalls / 50; ++i) {
            for (Caller* caller : {&first, &again, &asked}) caller->call();
            ASSERT_EQ(first.world().hash(), again.world().hash()) << seed << ", call " << i;
            ASSERT_EQ(first.world().hash(), asked.world().hash()) << seed << ", call " << i;
        }
    }
}

/// What was restored goes on as if nothing had been saved, whatever was going on.
TEST(RandomCalls, ASnapshotGoesOnTheSameWay) {
    Caller caller(21, false);
    for (int i = 0; i < manyCalls / 25; ++i) {
        caller.call();
        if (i % 200 != 0) continue;
        const auto other = caller.twin(false);
        ASSERT_EQ(other->world().hash(), caller.world().hash()) << "call " << i;
        for (int k = 0; k < 5; ++k) {
            caller.step();
            other->step();
            ASSERT_EQ(other->world().hash(), caller.world().hash())
                << "call " << i << ", tick " << k;
        }
    }
}

/// What the fuzz target `api` does, with bytes of this test's own.
TEST(RandomCalls, ATwinGoesOnTheSameWay) {
    test::Random random(5);
    int calls = 0;
    for (int run = 0; run < manyCalls / 500; ++run) {
        std::vector<std::uint8_t> bytes(2000);
        for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.bits() >> 56);
        SCOPED_TRACE("run " + std::to_string(run));
        ASSERT_NO_THROW(calls +=
                        test::callBesideATwin(std::make_unique<test::ByteNumbers>(bytes), 1000));
    }
    EXPECT_GT(calls, manyCalls / 10);
}

}  // namespace
}  // namespace sulfur
