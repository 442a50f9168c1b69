// What becomes of a body of which somebody moves a single particle by hand, and of what is pulled
// farther than it reaches.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "helpers.hpp"

namespace sulfur {
namespace {

constexpr int rates[] = {60, 500};

/// m, of the farthest particle from the centre of mass.
double extentOf(const World& world, const Body& body) {
    const Point centre = world.centreOfMass(body);
    double extent = 0;
    for (const ParticleId p : body.particles())
        extent = std::max(extent, (world.position(p) - centre).norm());
    return extent;
}

std::vector<std::pair<std::string, Blueprint>> readyMadeBodies() {
    return {{"box", shapes::box()},
            {"soft box", shapes::box({.stiffness = Real(1e4)})},
            {"stiff box", shapes::box({.stiffness = Real(1e7)})},
            {"wheel", shapes::wheel()},
            {"wheel with stiff spokes", shapes::wheel({.spokeStiffness = Real(3e5)})},
            {"wheel with braked spokes",
             shapes::wheel({.spokeStiffness = Real(3e5), .spokeDamping = 10})},
            {"wheel with very stiff spokes", shapes::wheel({.spokeStiffness = Real(3e7)})},
            {"jelly", shapes::jelly()},
            {"stiff jelly", shapes::jelly({.stiffness = Real(1e6)})},
            {"blob", shapes::blob()},
            {"rope", shapes::rope()},
            {"elastic rope", shapes::rope({.stiffness = Real(1e4)})},
            {"chain", shapes::chain()},
            {"bridge", shapes::bridge()},
            {"cloth", shapes::cloth()},
            {"wall", shapes::wall()}};
}

TEST(DisplacedParts, OfReadyMadeBodiesComeTogetherAgain) {
    for (const auto& [name, plan] : readyMadeBodies())
        for (const int rate : rates)
            for (const double way : {0.1, 1.0, 10.0})
                for (const int which : {0, 1}) {
                    World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
                    const Body body = world.add(plan);
                    world.step();
                    const double extent = extentOf(world, body);
                    const ParticleId part = body[which == 0 ? 1 : body.size() / 2];
                    world.setPosition(part, world.position(part) + Point(way, 0.3 * way));
                    double farthest = 0;
                    for (int i = 0; i < 3 * rate; ++i) {
                        world.step();
                        farthest = std::max(farthest, extentOf(world, body));
                    }
                    const std::string what = name + " at " + std::to_string(rate) + " Hz, part " +
                                             std::to_string(which) + " by " + std::to_string(way);
                    EXPECT_LT(farthest, extent + 1.1 * way + 0.4) << what;
                    EXPECT_LT(extentOf(world, body), 1.5 * extent + way / 3) << what;
                }
}

/// A force that stands for a whole step lets the energy of a spring waver about its mean.
TEST(DisplacedParts, OfSpringsGainNoEnergy) {
    const std::pair<std::string, Blueprint> plans[] = {
        {"wheel", shapes::wheel({.spokeStiffness = Real(3e5)})},
        {"rope of 1e3 N/m", shapes::rope({.stiffness = Real(1e3)})},
        {"rope of 1e4 N/m", shapes::rope({.stiffness = Real(1e4)})},
        {"rope of 1e6 N/m", shapes::rope({.stiffness = Real(1e6)})}};
    for (const auto& [name, plan] : plans)
        for (const int rate : rates)
            for (const double way : {0.01, 0.1, 1.0}) {
                World world({.gravity = {0, 0}, .tickRate = rate, .sleeping = false});
                const Body body = world.add(plan);
                world.step();
                const ParticleId part = body.front();
                world.setPosition(part, world.position(part) + Point(way, 0.3 * way));
                const double put = world.energy();
                double most = 0;
                for (int i = 0; i < 2 * rate; ++i) {
                    world.step();
                    most = std::max(most, world.energy());
                }
                EXPECT_LT(most, 1.2 * put + 1e-3)
                    << name << " at " << rate << " Hz, by " << way << " m";
            }
}

/// Straight, stretched evenly and at rest.
void expectTaut(World& world, const Body& body, const std::string& what) {
    double least = 1e9, most = 0, fastest = 0;
    for (std::size_t i = 0; i + 1 < body.size(); ++i) {
        const double length = (world.position(body[i]) - world.position(body[i + 1])).norm();
        const double stretch =
            length / static_cast<double>(world.info(body.joints()[i]).restLength);
        least = std::min(least, stretch);
        most = std::max(most, stretch);
        fastest = std::max(fastest, static_cast<double>(world.velocity(body[i]).norm()));
        EXPECT_NEAR(world.position(body[i])[1], 0, 3e-3) << what;  // it has a weight
    }
    EXPECT_LT(most / least, 1.01) << what;
    EXPECT_LT(fastest, 1e-2) << what;
}

TEST(DisplacedParts, WhatIsPulledFartherThanItReachesIsTautAndRests) {
    for (const int rate : {60, 500, 2000})
        for (const double beyond : {0.2, 4.0}) {
            World world({.tickRate = rate, .sleeping = false});
            const Body rope = world.add(shapes::rope({.from = {-1, 0},
                                                      .to = {1, 0},
                                                      .links = 20,
                                                      .slack = Real(0),
                                                      .pinFirst = true,
                                                      .pinLast = true}));
            const Body bridge = world.add(shapes::bridge(), {.position = {10, 0}});
            world.step();
            for (const Body& body : {rope, bridge})
                world.setPosition(body.back(), world.position(body.back()) + Point(beyond, 0));
            for (int i = 0; i < 3 * rate; ++i) world.step();
            const std::string what =
                std::to_string(beyond) + " m at " + std::to_string(rate) + " Hz";
            expectTaut(world, rope, "rope by " + what);
            expectTaut(world, bridge, "bridge by " + what);
        }
}

}  // namespace
}  // namespace sulfur
