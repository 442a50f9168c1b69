// Random play that looks for what must never be.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "helpers.hpp"
#include "solve.hpp"
#include "wander.hpp"

namespace quaoar::test {
namespace {

std::shared_ptr<const Level> firstLevel() {
    return std::make_shared<const Level>(
        readLevel(std::filesystem::path(QUAOAR_TEST_LEVELS) / "01-cold-wake.json"));
}

Recording firstProof() {
    return Recording::read(std::filesystem::path(QUAOAR_TEST_LEVELS) / "01-cold-wake.proof");
}

TEST(Wander, PlaysFromAllOverTheProofAndFindsNothingWrong) {
    WanderOptions options;
    options.seconds = 40;
    options.trip = 4;
    const WanderReport report = wander(firstLevel(), firstProof(), options);
    EXPECT_EQ(report.trips, 10);
    EXPECT_NEAR(report.simulated, 40, 0.01);
    for (const WanderFault& fault : report.faults) ADD_FAILURE() << fault.what;
}

TEST(Wander, TheSameWhateverTheThreads) {
    WanderOptions options;
    options.seconds = 12;
    options.trip = 2;
    const auto level = firstLevel();
    const auto proof = firstProof();
    const WanderReport one = wander(level, proof, options);
    options.jobs = 2;
    const WanderReport two = wander(level, proof, options);
    EXPECT_EQ(one.deaths, two.deaths);
    EXPECT_EQ(one.finishes, two.finishes);
    EXPECT_DOUBLE_EQ(one.simulated, two.simulated);
}

TEST(Wander, AHeroOutOfTheWorldIsAFaultWithItsInputs) {
    Session session(firstLevel());
    EXPECT_EQ(faultOf(session, true), "");
    auto& world = session.world();
    sulfur::Pose pose = world.pose(session.hero());
    pose.position.y() += 60;
    world.setPose(session.hero(), pose);
    EXPECT_NE(faultOf(session, false).find("out of the world"), std::string::npos);
}

TEST(Wander, AHeroWhoIsTornApartIsAFault) {
    Session session(firstLevel());
    auto& world = session.world();
    const auto particles = world.particles(session.hero());
    world.setPosition(particles.front(), session.heroPosition() + sulfur::Point(0, 5));
    EXPECT_NE(faultOf(session, false).find("torn apart"), std::string::npos);
}

TEST(Wander, AProofOfAnotherLevelIsRefused) {
    EXPECT_THROW(wander(room(), firstProof(), {}), RecordingError);
}

}  // namespace
}  // namespace quaoar::test
