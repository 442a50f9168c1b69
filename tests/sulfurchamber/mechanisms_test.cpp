// Mechanisms of a scene in the sandbox: kept, carried along, copied, and gone with their bodies.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Pose;
using sulfur::scene::Hinge;
using sulfur::scene::Slider;

constexpr double quarter = 3.14159265358979 / 2;

// A door on a post with limits, a wagon on a rail, and a gear between both.
const std::string works = R"({"format": "sulfur-scene", "version": 1, "blueprints": {
  "post": {"kind": "fixed", "particles": [{"position": [0, 0]}, {"position": [0, 1]}],
           "joints": [{"a": 0, "b": 1}]},
  "beam": {"shape": "box", "size": [1, 0.2]}},
  "bodies": [{"id": "post", "blueprint": "post"},
             {"id": "door", "blueprint": "beam", "position": [0.5, 0]},
             {"id": "wagon", "blueprint": "beam", "position": [3, 2]}],
  "mechanisms": [
    {"type": "hinge", "id": "swing", "a": "post", "b": "door", "at": [0, 0],
     "drive": {"lower": -2, "upper": 1}, "oiled": true},
    {"type": "slider", "id": "rail", "a": "post", "b": "wagon", "at": [3, 2], "axis": [1, 0],
     "turns": false, "drive": {"lower": -1, "upper": 1}},
    {"type": "gear", "first": "swing", "second": "rail", "ratio": 0.5}]})";

std::filesystem::path fileOf(const std::string& text, const std::string& name) {
    // Tests run side by side, each in a process of its own.
    const auto file = std::filesystem::path(testing::TempDir()) /
                      ("sulfurchamber_" + std::to_string(getpid()) + name);
    std::ofstream(file) << text;
    return file;
}

struct Opened {
    Opened() { document().open(fileOf(works, "works.json")); }
    Document& document() { return bench.document(); }
    BodyId body(const char* id) { return document().bodyOf(id); }
    const Hinge& hinge(std::size_t i = 0) {
        return std::get<Hinge>(document().scene().mechanisms.at(i).spec);
    }
    const Slider& slider() { return std::get<Slider>(document().scene().mechanisms.at(1).spec); }
    sulfur::MechanismInfo info(std::size_t i) {
        const auto& world = document().world();
        return world.info(world.mechanisms().at(i));
    }

    Workbench bench;
};

TEST(MechanismsOfDocuments, AreKeptWhenASceneIsOpenedAndSaved) {
    Opened opened;
    EXPECT_EQ(opened.document().world().mechanisms().size(), 3u);
    const std::string text = opened.document().text();
    EXPECT_NE(text.find("\"oiled\": true"), std::string::npos);
    const auto file = fileOf("", "works-saved.json");
    for (int i = 0; i < 100; ++i) opened.document().tick();
    opened.document().save(file);
    Document again;
    again.open(file);
    EXPECT_EQ(again.text(), text);
    opened.document().reset();
    EXPECT_EQ(again.world().hash(), opened.document().world().hash());
}

TEST(MechanismsOfDocuments, GoOnInASavedMoment) {
    Opened opened;
    for (int i = 0; i < 100; ++i) opened.document().tick();
    const double value = opened.info(0).value;
    ASSERT_GT(std::abs(value), 0.01);
    const auto file = fileOf("", "works-moment.json");
    opened.document().saveMoment(file);
    Document again;
    again.open(file);
    const auto& world = again.world();
    ASSERT_EQ(world.mechanisms().size(), 3u);
    EXPECT_EQ(world.bodies().size(), opened.document().world().bodies().size());
    EXPECT_NEAR(world.info(world.mechanisms()[0]).value, value, 1e-6);
}

TEST(MechanismsOfDocuments, AreCarriedAlongWithTheirBodies) {
    Opened opened;
    auto& document = opened.document();
    const BodyId door = opened.body("door");
    document.edit("Turn", [&] { document.place(door, {.position = {0, 0.5}, .angle = quarter}); });
    EXPECT_NEAR((opened.hinge().at - Point(0, 0)).norm(), 0, 1e-6);
    EXPECT_NEAR(opened.hinge().options.value, quarter, 1e-6);
    EXPECT_NEAR(opened.info(0).value, quarter, 1e-6) << "the limits stay where they were";
    const BodyId wagon = opened.body("wagon");
    document.edit("Move", [&] { document.translate({&wagon, 1}, {0.25, 0}); });
    EXPECT_NEAR((opened.slider().at - Point(3.25, 2)).norm(), 0, 1e-6);
    EXPECT_NEAR(opened.info(1).value, 0.25, 1e-6);
    // All together: nothing is another value.
    opened.bench.selectAll();
    opened.bench.nudge({2, 1});
    EXPECT_NEAR((opened.hinge().at - Point(2, 1)).norm(), 0, 1e-6);
    EXPECT_NEAR(opened.info(0).value, quarter, 1e-6);
    EXPECT_NEAR(opened.info(1).value, 0.25, 1e-6);
    opened.bench.turn(quarter);
    EXPECT_NEAR(opened.info(0).value, quarter, 1e-5);
    EXPECT_NEAR(static_cast<double>(opened.slider().axis.y()), 1, 1e-5);
    EXPECT_NEAR(opened.info(1).value, 0.25, 1e-5);
}

TEST(MechanismsOfDocuments, AreScaledAndMirroredWithAll) {
    Opened opened;
    opened.bench.selectAll();
    const double before = (opened.slider().at - opened.hinge().at).norm();
    opened.bench.scale(2);
    EXPECT_NEAR((opened.slider().at - opened.hinge().at).norm(), 2 * before, 1e-4);
    EXPECT_NEAR(static_cast<double>(opened.slider().options.drive.upper), 2, 1e-5);
    EXPECT_NEAR(static_cast<double>(opened.hinge().options.drive.upper), 1, 1e-5);
    const double side = opened.slider().at.x() - opened.hinge().at.x();
    opened.bench.mirror();
    EXPECT_NEAR(opened.slider().at.x() - opened.hinge().at.x(), -side, 1e-4);
    EXPECT_NEAR(static_cast<double>(opened.hinge().options.drive.upper), 2, 1e-5);
    EXPECT_NEAR(static_cast<double>(opened.hinge().options.drive.lower), -1, 1e-5);
    EXPECT_EQ(opened.document().world().mechanisms().size(), 3u);
}

TEST(MechanismsOfDocuments, AreCopiedBetweenWhatIsCopied) {
    for (const bool moved : {false, true}) {
        Opened opened;
        for (int i = 0; moved && i < 50; ++i) opened.document().tick();
        opened.bench.select({opened.body("post"), opened.body("door")});
        opened.bench.paste(opened.bench.copy(), {10, 0});
        EXPECT_EQ(opened.document().scene().bodies.size(), 5u);
        ASSERT_EQ(opened.document().scene().mechanisms.size(), 4u) << "no rail, and no gear";
        EXPECT_EQ(opened.document().world().mechanisms().size(), 4u);
        EXPECT_NEAR((opened.hinge(3).at - Point(10, 0)).norm(), 0, 1e-3);
        EXPECT_NE(opened.hinge(3).b, "door");
        opened.bench.select({opened.body("post"), opened.body("door"), opened.body("wagon")});
        opened.bench.paste(opened.bench.copy(), {0, 20});
        const auto& mechanisms = opened.document().scene().mechanisms;
        ASSERT_EQ(mechanisms.size(), 7u);
        const auto& gear = std::get<sulfur::scene::Gear>(mechanisms[6].spec);
        EXPECT_EQ(gear.first, mechanisms[4].id);
        EXPECT_NE(gear.first, "swing");
    }
}

TEST(MechanismsOfDocuments, AreRenamedAndRemovedWithTheirBodies) {
    Opened opened;
    auto& document = opened.document();
    document.edit("Rename", [&] { document.rename(opened.body("door"), "gate"); });
    EXPECT_EQ(opened.hinge().b, "gate");
    const BodyId gate = opened.body("gate");
    document.edit("Remove", [&] { document.remove({&gate, 1}); });
    ASSERT_EQ(document.scene().mechanisms.size(), 1u) << "the gear has lost a part";
    EXPECT_EQ(document.scene().mechanisms[0].id, "rail");
    EXPECT_EQ(document.world().mechanisms().size(), 1u);
    document.undo();
    EXPECT_EQ(document.world().mechanisms().size(), 3u);
}

TEST(MechanismsOfDocuments, FollowWhatIsMovedInAMoment) {
    Opened opened;
    auto& document = opened.document();
    for (int i = 0; i < 200; ++i) document.tick();
    const double value = opened.info(0).value;
    const BodyId door = opened.body("door");
    document.edit("Move", [&] { document.translate({&door, 1}, {0.5, 0}); });
    document.reset();
    EXPECT_NEAR(opened.info(0).value, value, 1e-4) << "as far from its limits as it was";
    EXPECT_NEAR((opened.hinge().at - Point(0.5, 0)).norm(), 0, 1e-3);
}

// A saved moment begins where its states say, not at the poses that it has kept.
TEST(MechanismsOfDocuments, KeepTheirLimitsWhenASavedMomentIsChangedInAMoment) {
    Opened opened;
    for (int i = 0; i < 500 && std::abs(opened.info(0).value) < 0.2; ++i) opened.document().tick();
    const auto file = fileOf("", "works-begun.json");
    opened.document().saveMoment(file);
    opened.document().open(file);
    auto& document = opened.document();
    ASSERT_TRUE(document.plan().body("door").state);
    ASSERT_GT(std::abs(opened.hinge().options.value), 0.1);
    for (int i = 0; i < 20; ++i) document.tick();
    const double value = opened.info(0).value;
    const BodyId door = opened.body("door");
    document.edit("Move", [&] { document.translate({&door, 1}, {0.5, 0}); });
    document.reset();
    EXPECT_NEAR(opened.info(0).value, value, 1e-4);
    EXPECT_NEAR((opened.hinge().at - Point(0.5, 0)).norm(), 0, 1e-3);
}

TEST(MechanismsOfDocuments, AreWhereTheirBodiesHaveFallenToBeforeAMomentWasSaved) {
    const std::string pair = R"({"format": "sulfur-scene", "version": 1, "blueprints": {
      "beam": {"shape": "box", "size": [1, 0.2]}},
      "bodies": [{"id": "left", "blueprint": "beam", "position": [-0.5, 0]},
                 {"id": "right", "blueprint": "beam", "position": [0.5, 0]}],
      "mechanisms": [{"type": "hinge", "a": "left", "b": "right", "at": [0, 0]}]})";
    Opened opened;
    auto& document = opened.document();
    document.open(fileOf(pair, "pair.json"));
    while (document.world().pose(opened.body("left")).position.y() > -5) document.tick();
    const auto file = fileOf("", "pair-fallen.json");
    document.saveMoment(file);
    document.open(file);
    document.tick();
    const Point at = opened.info(0).pointB;
    ASSERT_LT(at.y(), -5);
    const BodyId left = opened.body("left"), right = opened.body("right");
    const std::array<BodyId, 2> both{left, right};
    document.edit("Move", [&] { document.translate(both, {1, 0}); });
    document.reset();
    EXPECT_NEAR((opened.hinge().at - at - Point(1, 0)).norm(), 0, 1e-3);
}

TEST(MechanismsOfDocuments, KeepTheirLimitsWhenOneBodyIsMirroredOrScaled) {
    Opened opened;
    auto& document = opened.document();
    const BodyId door = opened.body("door");
    constexpr double turn = 0.4;
    document.edit("Turn", [&] {
        document.place(door,
                       {.position = {0.5 * std::cos(turn), 0.5 * std::sin(turn)}, .angle = turn});
    });
    ASSERT_NEAR(opened.hinge().options.value, turn, 1e-6);
    opened.bench.select({door});
    opened.bench.mirror();
    EXPECT_NEAR(opened.hinge().options.value, -turn, 1e-5) << "the frame has turned back";
    const BodyId wagon = opened.body("wagon");
    document.edit("Move", [&] { document.translate({&wagon, 1}, {0.25, 0}); });
    opened.bench.select({wagon});
    const Point at = opened.slider().at;
    opened.bench.scale(2);
    const double way = opened.slider().at.x() - at.x();
    EXPECT_NEAR(opened.slider().options.value, 0.25 + way, 1e-5);
    EXPECT_EQ(std::get<sulfur::scene::Gear>(document.scene().mechanisms[2].spec).ratio,
              sulfur::Real(0.5));
}

TEST(MechanismsOfDocuments, GearsBetweenAnglesAndWaysAreMirroredAndScaled) {
    Opened opened;
    const auto ratio = [&] {
        return static_cast<double>(
            std::get<sulfur::scene::Gear>(opened.document().scene().mechanisms[2].spec).ratio);
    };
    opened.bench.selectAll();
    opened.bench.mirror();
    EXPECT_NEAR(ratio(), -0.5, 1e-6);
    opened.bench.mirror();
    EXPECT_NEAR(ratio(), 0.5, 1e-6);
    opened.bench.scale(2);
    EXPECT_NEAR(ratio(), 0.25, 1e-6) << "the same turn moves the wagon twice as far";
}

// --- discs with a state ----------------------------------------------------------------------

const std::string turning = R"({"format": "sulfur-scene", "version": 1,
  "settings": {"gravity": [0, 0]},
  "blueprints": {"disc": {"particles": [{"position": [0, 0], "radius": 0.5}]}},
  "bodies": [{"id": "disc", "blueprint": "disc", "angle": 0.3,
              "state": {"positions": [[1, 2]], "velocities": [[0, 0]], "angle": 0.8, "spin": 3}}]})";

TEST(DiscsOfDocuments, ArePastedInAMomentAsTheyTurn) {
    Workbench bench;
    Document& document = bench.document();
    document.open(fileOf(turning, "disc.json"));
    document.tick();
    const auto& world = document.world();
    const BodyId disc = document.bodyOf("disc");
    const double angle = world.angle(disc);
    ASSERT_GT(angle, 0.8);
    bench.select({disc});
    bench.paste(bench.copy(), {10, 2});
    const BodyId copy = document.bodyOf(document.scene().bodies.at(1).id);
    EXPECT_NEAR(world.angle(copy), angle, 1e-5);
    EXPECT_NEAR(world.angularVelocity(copy), 3, 1e-5);
}

TEST(DiscsOfDocuments, AreTurnedWithTheirState) {
    Workbench bench;
    Document& document = bench.document();
    document.open(fileOf(turning, "disc.json"));
    const BodyId disc = document.bodyOf("disc");
    document.edit("Turn", [&] { document.place(disc, {.position = {1, 2}, .angle = 1.1}); });
    EXPECT_NEAR(document.plan().body("disc").state->angle.value(), 1.1, 1e-6);
    document.tick();
    document.reset();
    EXPECT_NEAR(document.world().angle(document.bodyOf("disc")), 1.1, 1e-6);
}

// A bead on the third of five links of 1 m, which begin 2 m to the left of it.
const std::string wire = R"({"format": "sulfur-scene", "version": 1, "blueprints": {
  "wire": {"kind": "fixed",
           "particles": [{"position": [0, 0]}, {"position": [1, 0]}, {"position": [2, 0]},
                         {"position": [3, 0]}, {"position": [4, 0]}, {"position": [5, 0]}],
           "joints": [{"a": 0, "b": 1}, {"a": 1, "b": 2}, {"a": 2, "b": 3}, {"a": 3, "b": 4},
                      {"a": 4, "b": 5}]},
  "bead": {"shape": "ball", "radius": 0.1}},
  "bodies": [{"id": "wire", "blueprint": "wire"},
             {"id": "bead", "blueprint": "bead", "position": [2.5, 0]}],
  "mechanisms": [{"type": "slider", "id": "led", "a": "wire", "b": "bead", "at": [2.5, 0],
                  "rail": [0, 1, 2, 3, 4]}]})";

TEST(MechanismsOfDocuments, KeepWhatIsLeftOfARail) {
    Workbench bench;
    Document& document = bench.document();
    document.open(fileOf(wire, "wire.json"));
    const std::string before = document.text();
    const auto remove = [&](std::size_t joint) {
        document.edit("Cut", [&] {
            document.remove(document.world().joints(document.bodyOf("wire"))[joint]);
        });
    };
    const auto slider = [&] { return std::get<Slider>(document.scene().mechanisms.at(0).spec); };
    remove(0);
    EXPECT_EQ(slider().rail, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_NEAR(slider().options.value, 1, 1e-6) << "its value is what it was";
    const auto file = fileOf("", "wire-saved.json");
    document.save(file);
    Document again;
    again.open(file);
    const auto& world = again.world();
    EXPECT_NEAR(world.info(world.mechanisms().at(0)).value, 2.5, 1e-5);
    remove(3);
    EXPECT_EQ(slider().rail, (std::vector<std::uint32_t>{0, 1, 2}));
    remove(1);
    EXPECT_TRUE(document.scene().mechanisms.empty()) << "its own link has gone";
    for (int i = 0; i < 3; ++i) document.undo();
    EXPECT_EQ(document.text(), before);
}

}  // namespace
}  // namespace sulfurchamber
