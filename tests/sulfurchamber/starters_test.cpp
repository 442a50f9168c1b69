// Each template that comes with the program stands and works when it is placed in an empty scene
// and played for ten seconds.
#include <gtest/gtest.h>

#include <algorithm>
#include <atlax/files.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "model/instances.hpp"
#include "model/library.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;

constexpr double pi = 3.14159265358979;

/// A template in an empty scene, which knows its parts by their names.
class Stage {
public:
    explicit Stage(const std::string& name) {
        Library library({SULFURCHAMBER_TEMPLATES}, {});
        library.rescan();
        const LibraryEntry* entry = library.find(name);
        if (entry == nullptr) throw std::runtime_error("there is no template " + name);
        made = Library::load(*entry);
        document.edit("Place", [&] { placeTemplate(document, made, {0, 0}); });
        ids = sulfurchamber::instancesOf(document.scene()).at(0).ids;
    }

    sulfur::World& world() { return document.world(); }
    /// Null when it broke.
    BodyId part(const std::string& name) { return document.bodyOf(ids.at(name)); }
    Point place(const std::string& name) { return world().centreOfMass(part(name)); }
    double angle(const std::string& name) { return world().pose(part(name)).angle; }
    std::size_t joints() {
        std::size_t count = world().connections().size() + world().mechanisms().size();
        for (const BodyId body : world().bodies()) count += world().joints(body).size();
        return count;
    }
    void play(double seconds, const std::function<void()>& each = {}) {
        const int ticks = static_cast<int>(seconds * world().settings().tickRate);
        for (int i = 0; i < ticks; ++i) {
            document.tick();
            if (each) each();
        }
    }
    double fastest() {
        double most = 0;
        for (const BodyId body : world().bodies())
            for (const auto particle : world().particles(body))
                most = std::max(most, static_cast<double>(world().velocity(particle).norm()));
        return most;
    }

    Template made;
    Document document;
    std::map<std::string, std::string> ids;
};

// --- every one of them -----------------------------------------------------------------------

std::vector<std::string> starterNames() {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(SULFURCHAMBER_TEMPLATES))
        if (file.path().extension() == ".json") names.push_back(file.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class Starters : public testing::TestWithParam<std::string> {};

TEST_P(Starters, StandsForTenSeconds) {
    const Template made = readTemplate(sulfur::scene::read(
        std::filesystem::path(SULFURCHAMBER_TEMPLATES) / (GetParam() + ".json")));
    EXPECT_FALSE(made.scene.description.empty());
    EXPECT_NE(made.category, "Other");
    Stage stage(made.name());
    EXPECT_EQ(overrideCount(stage.document, made.name()), 0u);
    const std::size_t joints = stage.joints();
    double fastest = 0;
    stage.play(10, [&] { fastest = std::max(fastest, stage.fastest()); });
    EXPECT_EQ(stage.world().validate(), "");
    EXPECT_LT(fastest, 25);
    EXPECT_TRUE(made.name() == "Wrecking Ball" || stage.joints() == joints) << "something broke";
    for (const auto& [part, id] : stage.ids) {
        const BodyId body = stage.document.bodyOf(id);
        if (!body) continue;
        EXPECT_GT(stage.world().bounds(body).low.y(), -0.05) << part << " is in the floor";
        EXPECT_LT(std::abs(stage.world().centreOfMass(body).x()), 30) << part;
    }
}

// Byte for byte, when its file is edited.
TEST_P(Starters, IsAsTheProgramSavesIt) {
    const auto file = std::filesystem::path(SULFURCHAMBER_TEMPLATES) / (GetParam() + ".json");
    Document document;
    document.open(file);
    EXPECT_EQ(document.text(), atlax::readFile(file, 1 << 22));
}

INSTANTIATE_TEST_SUITE_P(All, Starters, testing::ValuesIn(starterNames()), [](const auto& one) {
    std::string name = one.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(StarterSet, IsLargeAndKnowsItsCategories) {
    EXPECT_GE(starterNames().size(), 25u);
    std::map<std::string, int> categories;
    Library library({SULFURCHAMBER_TEMPLATES}, {});
    library.rescan();
    for (const auto& entry : library.entries()) ++categories[entry.category];
    for (const char* one : {"Creatures", "Vehicles", "Machines", "Ropes", "Structures", "Toys"})
        EXPECT_GE(categories[one], 2) << one;
    EXPECT_EQ(categories.size(), 6u);
}

// --- as they are named -----------------------------------------------------------------------

TEST(StarterSet, CreaturesKeepTheirShape) {
    for (const char* name : {"Pip", "Cubby", "Ghost"}) {
        Stage stage(name);
        const auto body = stage.world().bodies().back();
        const auto before = stage.world().bounds(body);
        // Dropped from two metres, they are themselves again.
        for (const auto particle : stage.world().particles(body))
            stage.world().setPosition(particle, stage.world().position(particle) + Point(0, 2));
        stage.play(10);
        const auto after = stage.world().bounds(body);
        EXPECT_NEAR(after.high.y() - after.low.y(), before.high.y() - before.low.y(),
                    0.08 * (before.high.y() - before.low.y()))
            << name;
        EXPECT_LT(stage.fastest(), 0.2) << name;
    }
}

TEST(StarterSet, CaterpillarHoldsTogether) {
    Stage stage("Caterpillar");
    stage.play(10);
    EXPECT_NEAR((stage.place("head") - stage.place("tail")).norm(), 1.6, 0.25);
}

TEST(StarterSet, RagdollFallsAndItsJointsHold) {
    Stage stage("Ragdoll");
    double widest = 0;
    stage.play(10, [&] {
        for (const auto mechanism : stage.world().mechanisms()) {
            const auto info = stage.world().info(mechanism);
            widest = std::max(widest, (info.pointA - info.pointB).norm());
        }
    });
    EXPECT_LT(widest, 0.01);
    EXPECT_LT(stage.place("head").y(), 0.7);
    EXPECT_LT(stage.fastest(), 0.3);
}

TEST(StarterSet, WalkerWalksToTheRight) {
    Stage stage("Walker");
    const double before = stage.place("body").x();
    stage.play(10);
    EXPECT_GT(stage.place("body").x(), before + 1);
    EXPECT_LT(std::abs(std::remainder(stage.angle("body"), 2 * pi)), 0.4) << "it fell over";
}

TEST(StarterSet, CarAndTruckDriveToTheRight) {
    Stage car("Car");
    car.play(10);
    EXPECT_GT(car.place("chassis").x(), 6);
    EXPECT_LT(std::abs(car.angle("chassis")), 0.15);
    Stage truck("Truck");
    truck.play(10);
    EXPECT_GT(truck.place("cab").x(), 5);
    for (const char* box : {"box1", "box2", "box3"})
        EXPECT_GT(truck.place(box).y(), 0.7) << "it lost " << box;
}

TEST(StarterSet, CartRollsWhenItIsPushedAndStandsOtherwise) {
    Stage still("Cart");
    still.play(5);
    EXPECT_NEAR(still.place("bed").x(), 0, 0.02);
    Stage pushed("Cart");
    pushed.play(0.5);
    for (const auto& [part, id] : pushed.ids)
        pushed.world().setVelocity(pushed.document.bodyOf(id), sulfur::Vec2(1.5f, 0));
    pushed.play(4);
    EXPECT_GT(pushed.place("bed").x(), 2);
}

TEST(StarterSet, CatapultAndTrebuchetThrowFar) {
    Stage catapult("Catapult");
    double highest = 0;
    catapult.play(10, [&] { highest = std::max(highest, catapult.place("stone").y()); });
    EXPECT_GT(catapult.place("stone").x(), 4);
    EXPECT_GT(highest, 2.2);
    EXPECT_LT(std::abs(catapult.place("base").x()), 1);
    Stage trebuchet("Trebuchet");
    double far = 0;
    trebuchet.play(10, [&] { far = std::max(far, trebuchet.place("stone").x()); });
    EXPECT_GT(far, 6);
    EXPECT_LT(std::abs(trebuchet.place("frame").x()), 1);
}

TEST(StarterSet, CraneLiftsItsLoad) {
    Stage stage("Crane");
    const double before = stage.place("load").y();
    stage.play(10);
    EXPECT_GT(stage.place("load").y(), before + 1.5);
}

TEST(StarterSet, SeesawTipsToTheHeavySide) {
    Stage stage("Seesaw");
    stage.play(4);
    EXPECT_LT(stage.angle("plank"), -0.2);
    EXPECT_GT(stage.place("light").y(), stage.place("heavy").y() + 0.3);
}

TEST(StarterSet, GearsTurnOneToTwo) {
    Stage stage("Gear Pair");
    const double large = stage.angle("large"), small = stage.angle("small");
    double turnedLarge = 0, turnedSmall = 0, lastLarge = large, lastSmall = small;
    stage.play(10, [&] {
        turnedLarge += std::remainder(stage.angle("large") - lastLarge, 2 * pi);
        turnedSmall += std::remainder(stage.angle("small") - lastSmall, 2 * pi);
        lastLarge = stage.angle("large");
        lastSmall = stage.angle("small");
    });
    EXPECT_NEAR(turnedLarge, -12, 0.3);
    EXPECT_NEAR(turnedSmall, -2 * turnedLarge, 0.05);
}

TEST(StarterSet, PendulumClockKeepsItsPeriod) {
    Stage stage("Pendulum Clock");
    std::vector<double> crossings;
    double last = stage.angle("pendulum");
    const double hand = stage.angle("hand");
    double turned = 0, lastHand = hand, widest = 0;
    stage.play(10, [&] {
        const double now = std::remainder(stage.angle("pendulum"), 2 * pi);
        if (last < 0 && now >= 0) crossings.push_back(stage.world().time());
        last = now;
        turned += std::remainder(stage.angle("hand") - lastHand, 2 * pi);
        lastHand = stage.angle("hand");
        if (stage.world().time() > 8) widest = std::max(widest, std::abs(now));
    });
    ASSERT_GE(crossings.size(), 4u);
    const double period =
        (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    EXPECT_NEAR(period, 2.0, 0.02);
    EXPECT_GT(widest, 0.14) << "it has lost its swing";
    EXPECT_NEAR(turned, -2 * pi / 6, 0.02);
}

TEST(StarterSet, WindmillTurnsAndTheSwingSwings) {
    Stage mill("Windmill");
    double turned = 0, last = mill.angle("sails");
    mill.play(10, [&] {
        turned += std::remainder(mill.angle("sails") - last, 2 * pi);
        last = mill.angle("sails");
    });
    EXPECT_NEAR(turned, -13, 1.5);
    Stage swing("Swing");
    double left = 0, right = 0;
    swing.play(10, [&] {
        left = std::min(left, swing.place("seat").x());
        right = std::max(right, swing.place("seat").x());
    });
    EXPECT_LT(left, -0.4);
    EXPECT_GT(right, 0.4);
}

TEST(StarterSet, WreckingBallBreaksTheWall) {
    Stage stage("Wrecking Ball");
    const std::size_t joints = stage.joints();
    stage.play(3);
    EXPECT_LT(stage.joints() + 5, joints);
}

TEST(StarterSet, CradlePassesTheBlowOn) {
    Stage stage("Newton's Cradle");
    double last = 0, first = 0;
    stage.play(1.5, [&] {
        last = std::max(last, std::remainder(stage.angle("ball5"), 2 * pi));
        if (last > 0.3) return;
        first = std::abs(std::remainder(stage.angle("ball1"), 2 * pi));
    });
    EXPECT_GT(last, 0.5);
    EXPECT_LT(first, 0.2);
}

TEST(StarterSet, BridgeBearsACarAndTheNetCatches) {
    Stage bridge("Bridge");
    bridge.play(2);
    bridge.document.edit("Load", [&] {
        bridge.document.add("crate", sulfur::shapes::BoxOptions{.size = {0.8f, 0.8f}, .mass = 40},
                            {.position = {0, 1.4}});
    });
    const std::size_t joints = bridge.joints();
    bridge.play(8);
    EXPECT_EQ(bridge.joints(), joints);
    EXPECT_GT(bridge.world().centreOfMass(bridge.document.bodyOf("crate")).y(), 0.7);
    Stage net("Net");
    net.play(10);
    EXPECT_GT(net.place("ball").y(), 0.5);
    EXPECT_LT(std::abs(net.place("ball").x()), 1.2);
    Stage trampoline("Trampoline");
    double bottom = 9, top = 0;
    trampoline.play(3, [&] {
        const double y = trampoline.place("ball").y();
        if (trampoline.world().time() < 1) bottom = std::min(bottom, y);
        if (trampoline.world().time() > 1) top = std::max(top, y);
    });
    EXPECT_LT(bottom, 1);
    EXPECT_GT(top, 1.4) << "it throws the ball up again";
}

TEST(StarterSet, WhatHangsHangs) {
    Stage chain("Chain");
    chain.play(10);
    EXPECT_NEAR(chain.place("weight").x(), 0, 0.1);
    EXPECT_GT(chain.world().bounds(chain.part("weight")).low.y(), 0.2);
    Stage flag("Flag");
    flag.play(10);
    EXPECT_GT(flag.place("cloth").y(), 1.0);
    EXPECT_GT(flag.place("cloth").x(), -0.9);
    Stage ladder("Rope Ladder");
    const auto before = ladder.world().bounds(ladder.part("ladder"));
    ladder.play(10);
    const auto after = ladder.world().bounds(ladder.part("ladder"));
    EXPECT_NEAR(after.low.y(), before.low.y(), 0.1);
}

TEST(StarterSet, StructuresStandAndDominoesFall) {
    for (const char* name : {"Tower", "Crate Pile", "Snowman", "Wall"}) {
        Stage stage(name);
        std::map<std::string, Point> before;
        for (const auto& [part, id] : stage.ids) before[part] = stage.place(part);
        stage.play(10);
        for (const auto& [part, id] : stage.ids) {
            ASSERT_TRUE(stage.part(part)) << part;
            EXPECT_LT((stage.place(part) - before[part]).norm(), 0.08) << name << ", " << part;
        }
    }
    Stage dominoes("Dominoes");
    dominoes.play(10);
    EXPECT_LT(dominoes.angle("domino14"), -1);
    Stage skittles("Skittles");
    skittles.play(5);
    int fallen = 0;
    for (int i = 1; i <= 5; ++i)
        if (std::abs(std::remainder(skittles.angle("pin" + std::to_string(i)), 2 * pi)) > 0.7)
            ++fallen;
    EXPECT_GE(fallen, 3);
}

TEST(StarterSet, TheJellyBallBouncesAndTheTreeKeepsItsCrown) {
    Stage ball("Jelly Ball");
    for (const auto particle : ball.world().particles(ball.part("ball")))
        ball.world().setPosition(particle, ball.world().position(particle) + Point(0, 2));
    double top = 0;
    bool down = false;
    ball.play(3, [&] {
        const double y = ball.place("ball").y();
        down = down || y < 0.6;
        if (down) top = std::max(top, y);
    });
    EXPECT_GT(top, 1.0);
    Stage tree("Tree");
    tree.play(10);
    EXPECT_GT(tree.place("leaves3").y(), 2.0);
    EXPECT_GT(tree.place("leaves1").y(), 1.3);
}

}  // namespace
}  // namespace sulfurchamber
