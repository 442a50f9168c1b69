// Plans: shared blueprints, what is changed for some, and what the world makes of it.
#include <gtest/gtest.h>

#include "model/workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::Real;
using sulfur::shapes::BoxOptions;

BodyId add(Document& document, const std::string& name, const sulfur::scene::Generator& recipe,
           Point at) {
    document.edit("Add " + name, [&] { document.add(name, recipe, {.position = at}); });
    return document.world().bodies().back();
}

void heavier(sulfur::scene::Prefab& prefab) {
    std::get<BoxOptions>(prefab.generator).mass = 7;
    rebuild(prefab);
}

TEST(Plan, EqualBodiesShareABlueprint) {
    Document document;
    for (int i = 0; i < 5; ++i) add(document, "box", BoxOptions{}, {i * 2.0, 1});
    add(document, "box", BoxOptions{.mass = 2}, {0, 5});
    EXPECT_EQ(document.scene().blueprints.size(), 3u);
    EXPECT_EQ(document.scene().bodies[5].id, "box5");
    EXPECT_EQ(document.scene().bodies[5].blueprint, "box");
    EXPECT_EQ(document.scene().bodies[6].blueprint, "box2");
}

TEST(Plan, AChangeOfSomeLeavesTheOthersAsTheyWere) {
    Document document;
    for (int i = 0; i < 3; ++i) add(document, "box", BoxOptions{}, {i * 2.0, 1});
    const auto bodies = document.world().bodies();
    const std::vector<BodyId> two(bodies.begin() + 1, bodies.begin() + 3);
    document.edit("Heavier", [&] { document.change(two, heavier); });
    const auto& world = document.world();
    EXPECT_NEAR(static_cast<double>(world.mass(document.bodyOf("box"))), 7, 1e-5);
    EXPECT_NEAR(static_cast<double>(world.mass(document.bodyOf("box2"))), 7, 1e-5);
    EXPECT_NEAR(static_cast<double>(world.mass(document.bodyOf("box3"))), 1, 1e-5);
    EXPECT_EQ(document.scene().blueprints.size(), 3u);
    document.edit("All", [&] { document.change(document.world().bodies().subspan(1), heavier); });
    EXPECT_NEAR(static_cast<double>(world.mass(document.bodyOf("box3"))), 7, 1e-5);
}

TEST(Plan, AChangeInARunningWorldActsAtOnceAndIsInThePlan) {
    Document document;
    add(document, "box", BoxOptions{}, {0, 3});
    for (int i = 0; i < 100; ++i) document.tick();
    const BodyId box = document.bodyOf("box");
    const auto place = document.world().centreOfMass(box);
    const auto velocity = document.world().meanVelocity(box);
    document.edit("Heavier", [&] { document.change({&box, 1}, heavier); });
    EXPECT_NEAR(static_cast<double>(document.world().mass(box)), 7, 1e-5);
    EXPECT_EQ(document.world().centreOfMass(box), place) << "it moves on as it did";
    EXPECT_EQ(document.world().meanVelocity(box), velocity);
    document.reset();
    EXPECT_NEAR(static_cast<double>(document.world().mass(document.bodyOf("box"))), 7, 1e-5);
    EXPECT_NEAR(document.world().centreOfMass(document.bodyOf("box")).y(), 3, 1e-6);
}

TEST(Plan, AnotherSizeInARunningWorldKeepsPlaceSpeedAndTies) {
    Document document;
    const BodyId box = add(document, "box", BoxOptions{}, {0, 3});
    const BodyId ball = add(document, "ball", sulfur::shapes::BallOptions{}, {1.5, 3});
    document.edit("Tie", [&] {
        document.connect(document.world().particles(box)[1], document.world().particles(ball)[0]);
    });
    for (int i = 0; i < 100; ++i) document.tick();
    const BodyId now = document.bodyOf("box");
    const auto velocity = document.world().meanVelocity(now);
    document.edit("Wider", [&] {
        document.change({&now, 1}, [](sulfur::scene::Prefab& prefab) {
            std::get<BoxOptions>(prefab.generator).size = {Real(1.2), 1};
            rebuild(prefab);
        });
    });
    const BodyId wider = document.bodyOf("box");
    ASSERT_TRUE(wider);
    EXPECT_NEAR(document.world().bounds(wider).high.x() - document.world().bounds(wider).low.x(),
                1.2, 1e-3);
    EXPECT_LT((document.world().meanVelocity(wider) - velocity).norm(), 1e-3f);
    EXPECT_EQ(document.world().connections().size(), 1u);
    document.undo();
    EXPECT_EQ(document.bodyOf("box"), now);
}

TEST(Plan, WhatIsMovedInAMomentStandsThereInThePlan) {
    Document document;
    add(document, "box", BoxOptions{}, {0, 3});
    for (int i = 0; i < 800; ++i) document.tick();
    const BodyId box = document.bodyOf("box");
    document.edit("Move", [&] { document.translate({&box, 1}, {2, 1}); });
    const Point there = document.world().centreOfMass(box);
    document.reset();
    EXPECT_LT((document.world().centreOfMass(document.bodyOf("box")) - there).norm(), 1e-4);
    EXPECT_FALSE(document.scene().body("box")->state) << "a rigid body needs but its pose";
}

TEST(Plan, PiecesAndRainAreOfTheMomentAlone) {
    Workbench bench;
    Document& document = bench.document();
    document.edit("Add", [&] {
        document.add("wall", sulfur::shapes::WallOptions{.strength = 50}, {.position = {0, 6}});
    });
    const std::string plan = document.text();
    bench.setRain(20);
    for (int i = 0; i < 1500; ++i) bench.tick();
    bench.setRain(0);
    EXPECT_FALSE(document.bodyOf("wall")) << "it has broken";
    EXPECT_EQ(document.text(), plan);
    const auto moment = document.momentScene();
    EXPECT_EQ(moment.bodies.size(), document.world().bodies().size());
    bench.selectAll();
    bench.deleteSelection();
    EXPECT_TRUE(document.world().bodies().empty());
    document.reset();
    EXPECT_TRUE(document.bodyOf("wall")) << "pieces were erased, not the wall of the plan";
}

TEST(Plan, FactorsAreInTheNumbersOfTheFile) {
    Document document;
    add(document, "jelly", sulfur::shapes::JellyOptions{.stiffness = 400}, {0, 2});
    Constants constants;
    constants.elasticity = 2;
    constants.friction = Real(0.5);
    document.setConstants(constants);
    Document again;
    again.adopt(sulfur::scene::parse(document.text(), "a test"));
    EXPECT_EQ(again.world().hash(), document.world().hash());
    EXPECT_EQ(again.constants().elasticity, 1);
    constants.elasticity = constants.friction = 1;
    document.setConstants(constants);
    EXPECT_FALSE(document.scene().prefab("jelly")->generator.index() == 0)
        << "the plan keeps its recipe";
}

TEST(Plan, FourThousandBoxesCanBeSavedAndMoreAreRefused) {
    Workbench bench;
    bench.dropBoxes(4000);
    const auto file = std::filesystem::path(testing::TempDir()) / "sulfurchamber_many.json";
    bench.document().save(file);
    EXPECT_LT(std::filesystem::file_size(file), 600'000u);
    Document again;
    again.open(file);
    EXPECT_EQ(again.world().bodies().size(), 4001u);
    for (int i = 0; i < 3; ++i) bench.tick();
    bench.document().saveMoment(file);
    again.open(file);
    EXPECT_EQ(again.world().bodies().size(), 4001u);
    std::filesystem::remove(file);

    bench.document().reset();
    const std::string before = bench.document().text();
    EXPECT_THROW(bench.dropBoxes(1000), std::runtime_error);
    EXPECT_EQ(bench.document().text(), before);
}

TEST(Plan, WhatHasLeftIsCountedBroughtBackAndDeleted) {
    Workbench bench;
    Document& document = bench.document();
    add(document, "box", BoxOptions{}, {0, 3});
    add(document, "ball", sulfur::shapes::BallOptions{}, {30, 3});
    EXPECT_TRUE(bench.strays().empty());
    for (int i = 0; i < 500 * 6; ++i) bench.tick();
    ASSERT_EQ(bench.strays().size(), 1u) << "the ball fell beside the floor";
    bench.bringBackStrays();
    EXPECT_TRUE(bench.strays().empty());
    EXPECT_NEAR(document.world().centreOfMass(document.bodyOf("ball")).y(), 3, 1e-6);
    for (int i = 0; i < 500 * 6; ++i) bench.tick();
    bench.deleteStrays();
    EXPECT_TRUE(bench.strays().empty());
    EXPECT_FALSE(document.plan().contains("ball"));
    document.undo();
    EXPECT_EQ(bench.strays().size(), 1u);
}

}  // namespace
}  // namespace sulfurchamber
