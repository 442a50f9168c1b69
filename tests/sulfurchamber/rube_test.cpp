// Scenes of R.U.B.E.: what their bodies and joints become, and that they move as they should.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atlax/files.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "model/file_kind.hpp"
#include "model/rube.hpp"
#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
namespace scene = sulfur::scene;

const std::string head =
    R"({"allowSleep": true, "autoClearForces": true, "gravity": {"x": 0, "y": -9.81}, )";

RubeScene imported(const std::string& rest) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("sulfurchamber-rube-test-" + std::to_string(getpid()) + ".json");
    atlax::writeFileAtomic(file, head + rest);
    EXPECT_EQ(kindOfFile(file), FileKind::rube);
    RubeScene made = readRube(file);
    std::filesystem::remove(file);
    return made;
}

std::string polygon(const char* xs, const char* ys, const char* more = "") {
    return std::string(R"({"density": 2, "friction": 0.3, "restitution": 0.5, )") + more +
           R"("polygon": {"vertices": {"x": [)" + xs + R"(], "y": [)" + ys + "]}}}";
}

std::string box(const char* more = "") {
    return polygon("-0.5, 0.5, 0.5, -0.5", "-0.5, -0.5, 0.5, 0.5", more);
}

void letFall(Workbench& bench, double seconds) {
    const int rate = bench.document().world().settings().tickRate;
    for (int i = 0; i < static_cast<int>(seconds * rate); ++i) bench.tick();
}

TEST(Rube, ABoxFallsOnAChain) {
    RubeScene made = imported(
        R"("body": [{"name": "crate", "type": 2, "position": {"x": 1, "y": 3}, "angle": 0.1,
            "linearVelocity": {"x": 0.5, "y": 0}, "fixture": [)" +
        box() + R"(]},
            {"name": "ground", "type": 0, "position": 0, "fixture": [{"friction": 0.9,
             "chain": {"vertices": {"x": [-9, 0, 9], "y": [0, 0, 0]}}}]}]})");
    EXPECT_TRUE(made.leftOut.empty());
    const auto& crate = *made.scene.body("crate");
    EXPECT_EQ(crate.pose.position, Point(1, 3));
    EXPECT_DOUBLE_EQ(crate.pose.angle, 0.1);
    EXPECT_EQ(crate.velocity.x(), 0.5f);
    const auto& plan = made.scene.prefab(crate.blueprint)->blueprint;
    EXPECT_NEAR(plan.material.kineticFriction, 0.3, 1e-6);
    EXPECT_NEAR(plan.material.restitution, 0.5, 1e-6);
    Workbench bench;
    bench.document().adopt(std::move(made.scene));
    const auto id = bench.document().bodyOf("crate");
    EXPECT_NEAR(bench.document().world().mass(id), 2, 1e-3) << "two kg/m^2";
    EXPECT_NEAR(bench.document().world().gravity().y(), -9.81, 1e-5);
    letFall(bench, 6);
    EXPECT_NEAR(bench.document().world().centreOfMass(id).y(), 0.51, 0.02);
}

// A rod hinged at its end: 2 pi sqrt(2 l / (3 g)) with its thickness.
TEST(Rube, AHingedRodSwingsWithItsPeriod) {
    RubeScene made = imported(
        R"("body": [{"name": "frame", "type": 0, "position": {"x": 0, "y": 5}, "fixture": [)" +
        box() + R"(]}, {"name": "rod", "type": 2, "position": {"x": 0, "y": 4}, "fixture": [)" +
        polygon("-0.05, 0.05, 0.05, -0.05", "-1, -1, 1, 1") + R"(]}],
          "joint": [{"type": "revolute", "bodyA": 0, "bodyB": 1, "anchorA": 0,
                     "anchorB": {"x": 0, "y": 1}, "refAngle": 0, "collideConnected": false}]})");
    ASSERT_EQ(made.scene.mechanisms.size(), 1u);
    const auto& hinge = std::get<scene::Hinge>(made.scene.mechanisms[0].spec);
    EXPECT_EQ(hinge.at, Point(0, 5));
    made.scene.body("rod")->velocity = {0.05f, 0};
    Workbench bench;
    bench.document().adopt(std::move(made.scene));
    auto& world = bench.document().world();
    const auto rod = bench.document().bodyOf("rod");
    std::vector<double> crossings;
    double before = 0;
    for (int i = 0; i < 5 * world.settings().tickRate; ++i) {
        bench.tick();
        const double x = world.centreOfMass(rod).x();
        if (before < 0 && x >= 0) crossings.push_back(world.time());
        before = x;
    }
    ASSERT_GE(crossings.size(), 2u);
    const double exact = 2 * std::numbers::pi * std::sqrt(4.01 / 3 / 9.81);
    EXPECT_NEAR(crossings[1] - crossings[0], exact, 0.03 * exact);
}

TEST(Rube, FixturesOfOneBodyHoldTogetherAndDoNotTouch) {
    RubeScene made = imported(
        R"("body": [{"name": "hammer", "type": 2, "position": {"x": 0, "y": 9}, "fixture": [)" +
        box() + "," + polygon("0.5, 2, 2, 0.5", "-0.1, -0.1, 0.1, 0.1") + R"(]}]})");
    ASSERT_EQ(made.scene.bodies.size(), 2u);
    EXPECT_EQ(made.scene.bodies[1].id, "hammer2");
    ASSERT_EQ(made.scene.mechanisms.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<scene::Weld>(made.scene.mechanisms[0].spec));
    ASSERT_EQ(made.scene.vetoes.size(), 1u);
    Workbench bench;
    bench.document().adopt(std::move(made.scene));
    const auto distance = [&] {
        const auto& world = bench.document().world();
        return (world.centreOfMass(bench.document().bodyOf("hammer")) -
                world.centreOfMass(bench.document().bodyOf("hammer2")))
            .norm();
    };
    const double first = distance();
    letFall(bench, 1);
    EXPECT_NEAR(distance(), first, 1e-3);
}

TEST(Rube, JointsBecomeMechanisms) {
    const std::string circle = R"({"density": 1, "circle": {"center": 0, "radius": 0.5}})";
    RubeScene made = imported(
        R"("body": [{"type": 2, "name": "car", "position": {"x": 0, "y": 2}, "fixture": [)" +
        box() + R"(]}, {"type": 2, "name": "wheel", "position": {"x": 0, "y": 1}, "fixture": [)" +
        circle + R"(]}, {"type": 2, "name": "load", "position": {"x": 3, "y": 2}, "fixture": [)" +
        box() +
        R"(]}], "joint": [
         {"type": "wheel", "bodyA": 0, "bodyB": 1, "anchorA": {"x": 0, "y": -1}, "anchorB": 0,
          "localAxisA": {"x": 0, "y": 1}, "springFrequency": 2, "springDampingRatio": 0.5,
          "enableMotor": true, "motorSpeed": -4, "maxMotorTorque": 6},
         {"type": "distance", "bodyA": 0, "bodyB": 2, "anchorA": 0, "anchorB": 0, "length": 3},
         {"type": "rope", "bodyA": 0, "bodyB": 2, "anchorA": 0, "anchorB": 0, "maxLength": 4},
         {"type": "prismatic", "bodyA": 0, "bodyB": 2, "anchorA": 0, "anchorB": 0,
          "localAxisA": {"x": 1, "y": 0}, "enableLimit": true, "lowerLimit": 1, "upperLimit": 5},
         {"type": "friction", "bodyA": 0, "bodyB": 2, "anchorA": 0, "anchorB": 0}],
         "image": [{"file": "a.png"}]})");
    ASSERT_EQ(made.scene.mechanisms.size(), 4u);
    const auto& wheel = std::get<scene::Wheel>(made.scene.mechanisms[0].spec);
    EXPECT_EQ(wheel.at, Point(0, 1));
    EXPECT_EQ(wheel.options.motor.motorSpeed, -4);
    EXPECT_EQ(wheel.options.motor.motorMax, 6);
    const double disc = std::numbers::pi / 4;
    const double reduced = 2 * disc / (2 + disc), w = 4 * std::numbers::pi;
    EXPECT_NEAR(wheel.options.spring.stiffness, reduced * w * w, 0.5);
    EXPECT_NEAR(wheel.options.spring.damping, reduced * w, 0.05);
    const auto& rod = std::get<scene::Distance>(made.scene.mechanisms[1].spec).options.drive;
    EXPECT_EQ(rod.lower, 3);
    EXPECT_EQ(rod.upper, 3);
    const auto& rope = std::get<scene::Distance>(made.scene.mechanisms[2].spec).options.drive;
    EXPECT_TRUE(std::isinf(rope.lower));
    EXPECT_EQ(rope.upper, 4);
    const auto& slider = std::get<scene::Slider>(made.scene.mechanisms[3].spec);
    EXPECT_NEAR(slider.options.value, 3, 1e-9);
    EXPECT_EQ(slider.options.drive.upper, 5);
    EXPECT_EQ(made.leftOut, (std::vector<std::string>{"joints of the kind “friction”", "images"}));
    const auto again = scene::parse(scene::format(made.scene), "again");
    EXPECT_EQ(again.mechanisms.size(), 4u) << "it can be saved";
    Workbench bench;
    bench.document().adopt(std::move(made.scene));
    letFall(bench, 0.5);
}

TEST(Rube, WhatHasNoDensityHasAKilogram) {
    const auto mass = [](const std::string& body, const std::string& fixtures) {
        RubeScene made = imported(R"("body": [{"type": 2, "name": "b", )" + body +
                                  R"("fixture": [)" + fixtures + "]}]}");
        Workbench bench;
        bench.document().adopt(std::move(made.scene));
        return bench.document().world().mass(bench.document().bodyOf("b"));
    };
    const std::string light = R"({"circle": {"center": 0, "radius": 0.5}})";
    EXPECT_NEAR(mass("", light), 1, 1e-6);
    EXPECT_LT(mass(R"("massData-mass": 2, )", light + "," + box()), 0.01);
}

// The exporter may write floats as their bits.
TEST(Rube, NumbersMayBeBits) {
    RubeScene made = imported(
        R"("body": [{"type": 2, "name": "b", "position": {"x": "3F800000", "y": "C0200000"},
            "fixture": [)" +
        box() + "]}]}");
    EXPECT_EQ(made.scene.body("b")->pose.position, Point(1, -2.5));
}

TEST(Rube, WhatIsWrongIsToldWithItsPlace) {
    const auto wrong = [](const std::string& rest, const std::string& part) {
        try {
            imported(rest);
            ADD_FAILURE() << "not refused: " << rest;
        } catch (const scene::ReadError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    wrong(R"("body": [{"type": 2, "position": {"x": "zz800000", "y": 0}}]})", "is no number");
    wrong(R"("joint": [{"type": "weld", "bodyA": 7, "bodyB": 0}]})", "is the place of no body");
}

}  // namespace
}  // namespace sulfurchamber
