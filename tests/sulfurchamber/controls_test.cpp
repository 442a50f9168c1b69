// Keys that drive things, and how rewinding comes back to what they did.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "model/fitting_properties.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Drive;
using sulfur::Point;

// A wheel with a motor on keys, a load on a winch, and a ball with a thruster.
const std::string driven = R"({"format": "sulfur-scene", "version": 1, "blueprints": {
  "post": {"kind": "fixed", "particles": [{"position": [0, 0]}]},
  "wheel": {"shape": "wheel", "radius": 0.5},
  "load": {"shape": "box", "size": [0.5, 0.5]},
  "ball": {"shape": "ball", "radius": 0.25},
  "floor": {"kind": "fixed", "shape": "ground", "points": [[-10, 0], [10, 0]]}},
  "bodies": [{"id": "floor", "blueprint": "floor"},
             {"id": "post", "blueprint": "post", "position": [0, 3]},
             {"id": "wheel", "blueprint": "wheel", "position": [0, 3]},
             {"id": "beam", "blueprint": "post", "position": [3, 4]},
             {"id": "load", "blueprint": "load", "position": [3, 2]},
             {"id": "ball", "blueprint": "ball", "position": [-3, 0.3]}],
  "mechanisms": [
    {"type": "hinge", "id": "motor", "a": "post", "b": "wheel", "at": [0, 3],
     "drive": {"motorSpeed": 4, "motorMax": 50},
     "keys": {"forward": "Right", "back": "A", "brake": 0.5}},
    {"type": "distance", "id": "winch", "a": "beam", "b": "load", "atA": [3, 4], "atB": [3, 2],
     "drive": {"lower": 0.5, "upper": 2, "motorSpeed": -0.5, "motorMax": 100},
     "keys": {"forward": "Up", "back": "Down"}}],
  "devices": [
    {"type": "thruster", "body": "ball", "at": [0.1, 0], "force": [0, 25],
     "keys": {"forward": "T", "back": ""}},
    {"type": "siren", "loud": true}]})";

std::filesystem::path textFile(const std::string& text, const std::string& name) {
    const auto file = std::filesystem::path(testing::TempDir()) / ("controls_" + name);
    std::ofstream(file) << text;
    return file;
}

struct Cab {
    Cab() { document().open(textFile(driven, "driven.json")); }
    Document& document() { return bench.document(); }
    sulfur::World& world() { return document().world(); }
    sulfur::MechanismInfo info(std::size_t i) { return world().info(document().made().at(i).id); }
    void hold(const char* key, bool on = true) { bench.controls().hold(key, on); }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds * 500)); ++i) bench.tick();
    }

    Workbench bench;
};

TEST(Controls, AMotorTurnsWhileItsKeyIsHeldAndBrakesAfterwards) {
    Cab cab;
    cab.run(0.5);
    EXPECT_NEAR(cab.info(0).speed, 0, 1e-3) << "no key is held";
    cab.hold("Right");
    cab.run(0.5);
    EXPECT_NEAR(cab.info(0).speed, 4, 0.05);
    cab.hold("Right", false);
    cab.run(0.5);
    EXPECT_NEAR(cab.info(0).speed, 0, 1e-2) << "its brake holds it";
    cab.hold("A");
    cab.run(0.5);
    EXPECT_NEAR(cab.info(0).speed, -4, 0.05);
    EXPECT_FALSE(cab.document().modified()) << "keys are no edits";
}

TEST(Controls, AWinchWindsInAndOutAndElseIsACable) {
    Cab cab;
    cab.run(0.5);
    EXPECT_NEAR(cab.info(1).value, 2, 1e-3);
    cab.hold("Up");
    cab.run(2);
    cab.hold("Up", false);
    EXPECT_NEAR(cab.info(1).value, 1, 0.02);
    cab.run(1);
    EXPECT_NEAR(cab.info(1).value, 1, 0.03) << "it stays there";
    cab.hold("Down");
    cab.run(8);
    cab.hold("Down", false);
    EXPECT_NEAR(cab.world().centreOfMass(cab.document().bodyOf("load")).y(), 0.3, 0.05)
        << "it lies on the floor, which nothing pushes it into";
    EXPECT_LT(std::abs(static_cast<double>(cab.info(1).force)), 1);
}

TEST(Controls, ATargetIsWhereAKeyTakesAMotor) {
    const Drive plan{.motorSpeed = 2, .motorMax = 10, .motorTarget = sulfur::Real(1.5)};
    const sulfur::MechanismInfo now;
    const DriveKeys keys{"Right", "Left", 0};
    EXPECT_EQ(*drivenBy(plan, keys, 1, now, 0.002).motorTarget, sulfur::Real(1.5));
    EXPECT_EQ(*drivenBy(plan, keys, -1, now, 0.002).motorTarget, sulfur::Real(-1.5));
    EXPECT_EQ(*drivenBy(plan, keys, 0, now, 0.002).motorTarget, sulfur::Real(0));
}

TEST(Controls, RewindingComesBackToTheBitAndBranches) {
    Cab cab;
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 1500; ++i) {
        if (i == 100) cab.hold("Right");
        if (i == 250) cab.hold("T");
        if (i == 300) cab.hold("Up");
        if (i == 600) cab.hold("T", false);
        if (i == 900) cab.hold("Up", false);
        if (i == 1000) cab.hold("Right", false);
        if (i == 1100) cab.hold("Down");
        cab.bench.tick();
        hashes.push_back(cab.world().hash());
    }
    EXPECT_GT(cab.world().centreOfMass(cab.document().bodyOf("ball")).norm(), 3.3)
        << "the thruster has thrown the ball";
    const auto line = cab.document().timeline().line();
    for (const std::uint64_t tick : {1500u, 260u, 720u, 1u, 1101u, 905u, 1499u}) {
        ASSERT_TRUE(cab.document().goTo({line, tick}));
        EXPECT_EQ(cab.world().hash(), hashes[tick - 1]) << tick;
    }
    // Going on with other keys is another future; the first stays.
    cab.bench.controls().release();
    ASSERT_TRUE(cab.document().goTo({line, 400}));
    cab.run(1);
    const auto branch = cab.document().timeline().line();
    EXPECT_NE(branch, line);
    const auto other = cab.world().hash();
    EXPECT_NE(other, hashes[899]);
    ASSERT_TRUE(cab.document().goTo({line, 1200}));
    EXPECT_EQ(cab.world().hash(), hashes[1199]);
    ASSERT_TRUE(cab.document().goTo({branch, 900}));
    EXPECT_EQ(cab.world().hash(), other);
}

TEST(Controls, KeysAndDevicesAreKeptInTheFile) {
    Cab cab;
    EXPECT_EQ(keysOf(cab.document().scene().mechanisms[0]), (DriveKeys{"Right", "A", 0.5}));
    const FittingRef thruster{FittingRef::Kind::thruster, 0};
    cab.document().edit("Change", [&] {
        setFittingKeys(cab.document(), thruster, {"Y", "Z", 0});
        setFittingKeys(cab.document(), {FittingRef::Kind::mechanism, 1}, {"", "", 0});
    });
    const auto file = textFile("", "saved.json");
    cab.document().save(file);
    Document again;
    again.open(file);
    EXPECT_EQ(again.thrusters()[0].keys, (DriveKeys{"Y", "Z", 0}));
    EXPECT_FALSE(keysOf(again.scene().mechanisms[1]).any());
    EXPECT_TRUE(keysOf(again.scene().mechanisms[0]).any());
    EXPECT_NE(again.text().find("\"siren\""), std::string::npos) << "what is unknown stays";
    // Also of a moment, where time has passed.
    for (int i = 0; i < 100; ++i) cab.bench.tick();
    cab.document().saveMoment(file);
    again.open(file);
    EXPECT_EQ(keysOf(again.scene().mechanisms[0]), (DriveKeys{"Right", "A", 0.5}));
    EXPECT_EQ(again.thrusters().size(), 1u);
}

TEST(Controls, UnusableDevicesAreRefusedWithTheReason) {
    const auto refused = [](std::string from, const std::string& what, const std::string& with,
                            const std::string& reason) {
        from.replace(from.find(what), what.size(), with);
        Document document;
        try {
            document.open(textFile(from, "bad.json"));
            ADD_FAILURE() << with << " was taken";
        } catch (const sulfur::scene::ReadError& error) {
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
    };
    refused(driven, R"("body": "ball")", R"("body": "bull")", "allowed is the id of a body");
    refused(driven, R"("force": [0, 25])", R"("force": [0, 1e9])", "force");
    refused(driven, R"("forward": "T")", R"("forward": "Enter")", "allowed is a letter");
    Document document;
    EXPECT_THROW(
        document.edit(
            "Keys",
            [&] {
                setFittingKeys(document, {FittingRef::Kind::mechanism, 0}, {"Enter", "", 0});
            }),
        std::exception);
}

TEST(Controls, OnlyKeysThatDriveSomethingAreAnsweredTo) {
    Cab cab;
    for (const char* key : {"Right", "A", "Up", "Down", "T"})
        EXPECT_TRUE(answersTo(cab.document(), key)) << key;
    for (const char* key : {"Left", "B", "V"}) EXPECT_FALSE(answersTo(cab.document(), key)) << key;
    cab.hold("Space");
    EXPECT_TRUE(cab.bench.controls().held().empty());
}

}  // namespace
}  // namespace sulfurchamber
