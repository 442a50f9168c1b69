// The ten machines of the gallery, which scripts of clicks have built: each does what it is for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

struct Machine {
    explicit Machine(const char* name) {
        document().open(std::filesystem::path(SULFURCHAMBER_SCENES) /
                        (std::string(name) + ".json"));
    }
    Document& document() { return bench.document(); }
    sulfur::World& world() { return document().world(); }
    BodyId body(const char* id) {
        const BodyId found = document().bodyOf(id);
        if (!found) throw std::runtime_error(std::string("no body ") + id);
        return found;
    }
    Point centre(const char* id) { return world().centreOfMass(body(id)); }
    void hold(const char* key, bool down = true) { bench.controls().hold(key, down); }
    void run(double seconds) {
        const int ticks = static_cast<int>(std::lround(seconds * world().settings().tickRate));
        for (int i = 0; i < ticks; ++i) bench.tick();
    }
    sulfur::MechanismInfo info(const std::string& id) {
        const auto& all = document().scene().mechanisms;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].id == id) return world().info(document().made().at(i).id);
        throw std::runtime_error("no mechanism " + id);
    }

    Workbench bench;
};

TEST(Machines, TheRopeBridgeBearsFiveCrates) {
    Machine bridge("rope-bridge");
    bridge.run(8);
    int crates = 0;
    for (const BodyId body : bridge.world().bodies()) {
        if (bridge.world().name(body).substr(0, 3) != "box") continue;
        ++crates;
        const Point at = bridge.world().centreOfMass(body);
        EXPECT_GT(at.y(), 1.4) << "it lies on the planks, high above the floor";
        EXPECT_LT(std::abs(at.x()), 3);
        EXPECT_LT(bridge.world().meanVelocity(body).norm(), 0.3f);
    }
    EXPECT_EQ(crates, 5);
}

TEST(Machines, TheRopeBridgeRestsWithinTenSeconds) {
    Machine bridge("rope-bridge");
    bridge.run(10);
    EXPECT_TRUE(bridge.world().asleep(bridge.body("rope")));
    for (const BodyId body : bridge.world().bodies())
        for (const auto particle : bridge.world().particles(body))
            EXPECT_LT(bridge.world().velocity(particle).norm(), 0.05f) << bridge.world().name(body);
}

TEST(Machines, TheCatapultThrowsBeyondTenMetres) {
    Machine catapult("catapult");
    catapult.run(1);
    EXPECT_LT(catapult.centre("ball").x(), -2) << "the ball waits in its cup";
    catapult.hold("Right");
    double highest = 0;
    for (int i = 0; i < 60 && catapult.centre("ball").y() > 0.3; ++i) {
        catapult.run(0.05);
        highest = std::max(highest, catapult.centre("ball").y());
    }
    EXPECT_GT(highest, 4);
    EXPECT_GT(catapult.centre("ball").x(), 10);
    EXPECT_LT(std::abs(catapult.centre("box").x() + 0.4), 0.5) << "its frame stands";
}

TEST(Machines, TheTrebuchetThrowsWhenItsCableIsCut) {
    Machine trebuchet("trebuchet");
    trebuchet.run(1);
    EXPECT_LT(trebuchet.centre("ball").x(), -3) << "the cable holds the beam";
    trebuchet.bench.setTool(ToolKind::cut);
    trebuchet.bench.press({.position = {-4.5, 1.5}});
    trebuchet.bench.move({.position = {-4, 1.5}});
    trebuchet.bench.release({.position = {-3.5, 1.5}});
    double farthest = -4;
    for (int i = 0; i < 80 && trebuchet.centre("ball").y() > 0.3; ++i) {
        trebuchet.run(0.05);
        farthest = std::max(farthest, trebuchet.centre("ball").x());
    }
    EXPECT_GT(farthest, 8);
}

TEST(Machines, TheCarDrivesFiveMetresOverItsBumpAndBack) {
    Machine car("car");
    car.run(1);
    const Point start = car.centre("car");
    car.hold("Right");
    car.run(3);
    EXPECT_GT(car.centre("car").x(), start.x() + 5);
    EXPECT_LT(std::abs(car.world().pose(car.body("car")).angle), 0.5) << "it stands on its wheels";
    car.hold("Right", false);
    car.hold("Left");
    const double far = car.centre("car").x();
    car.run(4);
    EXPECT_LT(car.centre("car").x(), far + 3);
    EXPECT_LT(car.world().meanVelocity(car.body("car")).x(), 0);
}

TEST(Machines, TheWalkerWalksBothWays) {
    for (const auto& [key, way] : {std::pair{"Right", 1.0}, std::pair{"Left", -1.0}}) {
        Machine walker("walker");
        walker.run(1);
        const double start = walker.centre("body").x();
        EXPECT_NEAR(start, 0, 0.2) << "it stands without a key";
        walker.hold(key);
        walker.run(5);
        EXPECT_GT((walker.centre("body").x() - start) * way, 3);
        EXPECT_GT(walker.centre("body").y(), 1.4);
    }
}

TEST(Machines, TheCraneLiftsCarriesAndPutsDown) {
    Machine crane("crane");
    crane.run(1);
    const double low = crane.centre("crate").y();
    crane.hold("Up");
    crane.run(2.5);
    crane.hold("Up", false);
    EXPECT_GT(crane.centre("crate").y(), low + 1.5);
    crane.hold("Right");
    crane.run(2.8);
    crane.hold("Right", false);
    crane.run(3);
    EXPECT_GT(crane.centre("trolley").x(), 1.8);
    EXPECT_NEAR(crane.centre("crate").x(), crane.centre("trolley").x(), 0.6);
    crane.hold("Down");
    crane.run(4);
    crane.hold("Down", false);
    EXPECT_LT(crane.centre("crate").y(), 1.8) << "it is on the stone, or beside it";
}

TEST(Machines, TheJellyTowerStandsAndGivesWay) {
    Machine tower("jelly-tower");
    const double before = tower.centre("ball").y();
    tower.run(10);
    EXPECT_GT(tower.centre("ball").y(), 2.5);
    EXPECT_LT(tower.centre("ball").y(), before - 0.2);
    EXPECT_LT(std::abs(tower.centre("ball").x()), 0.5);
}

TEST(Machines, TheFlagStreamsInTheWindAndHangsWithoutIt) {
    Machine flag("flag");
    const auto reach = [&] { return flag.world().bounds(flag.body("cloth")).high.x(); };
    flag.run(4);
    EXPECT_GT(reach(), 0.5);
    flag.bench.chooseFitting(FittingRef{FittingRef::Kind::zone, 0});
    flag.bench.deleteSelection();
    flag.run(15);
    EXPECT_LT(reach(), -0.3);
}

TEST(Machines, TheClockKeepsItsPeriodAndItsHandsTheirRatio) {
    Machine clock("pendulum-clock");
    const auto& world = clock.world();
    const BodyId rod = clock.body("box"), bob = clock.body("ball");
    const Point pivot = clock.info("hinge").pointB;
    double inertia = 0, moment = 0;
    for (const BodyId body : {rod, bob}) {
        const auto mass = static_cast<double>(world.mass(body));
        const Point off = world.centreOfMass(body) - pivot;
        // A disc turns with the rod that it is welded to.
        const double own =
            body == bob ? mass * 0.4 * 0.4 / 2 : static_cast<double>(world.inertia(body));
        inertia += own + mass * off.squaredNorm();
        moment += mass * off.norm();
    }
    const double amplitude = 15 * std::numbers::pi / 180;
    const double period = 2 * std::numbers::pi * std::sqrt(inertia / (9.81 * moment)) *
                          (1 + amplitude * amplitude / 16);
    const double minute = clock.info("motor").value, hour = clock.info("hinge2").value;
    std::vector<double> passes;
    double before = world.centreOfMass(bob).x() - pivot.x();
    for (int i = 0; i < 500 * 30; ++i) {
        clock.bench.tick();
        const double now = world.centreOfMass(bob).x() - pivot.x();
        if (before < 0 && now >= 0) passes.push_back(world.time() - now / (now - before) / 500);
        before = now;
    }
    ASSERT_GT(passes.size(), 5u);
    for (std::size_t i = 1; i < passes.size(); ++i)
        EXPECT_NEAR(passes[i] - passes[i - 1], period, 0.01 * period) << i;
    const double turned = clock.info("motor").value - minute;
    EXPECT_NEAR(turned, -15, 0.3) << "half a radian a second";
    EXPECT_NEAR(clock.info("hinge2").value - hour, turned / 12, 0.02);
}

TEST(Machines, TheWreckingBallBreaksTheWall) {
    Machine yard("wrecking-ball");
    const auto joints = [&] {
        std::size_t count = 0;
        for (const BodyId body : yard.world().bodies())
            if (yard.world().name(body) == "wall") count += yard.world().joints(body).size();
        return count;
    };
    const std::size_t before = joints();
    yard.run(1);
    EXPECT_GE(joints() * 100, before * 95) << "the wall stands by itself";
    yard.run(4);
    EXPECT_LT(joints(), before * 9 / 10);
}

}  // namespace
}  // namespace sulfurchamber
