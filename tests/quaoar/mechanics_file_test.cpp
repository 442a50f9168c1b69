// The mechanics of level files: what is read, and how each mistake is refused.
#include <gtest/gtest.h>
#include <unistd.h>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

const std::string lifted = withBody(
    roomText, "lift", R"("shape": "box", "size": [1, 0.2], "kind": "kinematic")", "[1, 0.5]");

void expectRefused(const std::string& members, std::initializer_list<const char*> parts) {
    try {
        parseLevel(roomWith(members, lifted), "room.json");
        ADD_FAILURE() << "was not refused: " << members;
    } catch (const sulfur::scene::ReadError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("room.json:1"), std::string::npos) << message;  // 10, or 11
        for (const char* part : parts) {
            EXPECT_NE(message.find(part), std::string::npos) << "\"" << part << "\" in " << message;
        }
    }
}

TEST(MechanicsFile, AllOfItIsRead) {
    const auto level = room(roomWith(R"(
      "countdown": 60, "speedLimit": 14, "reach": 5,
      "checkpoints": [{"id": "half", "position": [0, 1], "radius": 0.7}],
      "pickups": [{"id": "spark", "position": [1, 1], "hidden": true}],
      "zones": [{"id": "a", "min": [0, 0], "max": [1, 1], "gravity": [0, 1], "needs": "open",
                 "wind": {"velocity": [1, 2], "drag": 5}, "liquid": {"density": 70, "drag": 1},
                 "deadly": true, "pulse": {"period": 3, "on": 1, "phase": 2}}],
      "movers": [{"body": "lift", "path": [[1, 2], [2, 2]], "turn": 1, "spin": 2, "seconds": 3,
                  "secondsBack": 1, "pauseStart": 0.5, "pauseEnd": 0.25, "phase": 0.125,
                  "mode": "door", "ease": false, "needs": "dead"}],
      "switches": [{"id": "s", "position": [2, 0.2], "size": [1, 0.4], "by": "any", "weight": 2,
                    "mode": "toggle", "signal": "open"}],
      "monsters": [{"body": "box-1", "behaviour": "flee", "target": "rope", "range": 4, "speed": 2,
                    "flies": true, "between": [-1, 1], "toughness": 3, "onDefeat": "dead"}],
      "surfaces": {"box-1": {"sticky": false, "deadly": true, "cuts": true, "crumbles": 0.5}})",
                                     lifted));
    EXPECT_EQ(level->countdown, 60.0);
    EXPECT_EQ(level->speedLimit, sulfur::Real(14));
    EXPECT_EQ(level->reach, sulfur::Real(5));
    ASSERT_EQ(level->checkpoints.size(), 1u);
    EXPECT_EQ(level->checkpoints[0].id, "half");
    EXPECT_EQ(level->checkpoints[0].radius, 0.7);
    ASSERT_EQ(level->pickups.size(), 1u);
    EXPECT_TRUE(level->pickups[0].hidden);

    ASSERT_EQ(level->zones.size(), 1u);
    const Zone& zone = level->zones[0];
    EXPECT_EQ(zone.gravity, sulfur::Vec2(0, 1));
    EXPECT_EQ(zone.wind->velocity, sulfur::Vec2(1, 2));
    EXPECT_EQ(zone.wind->drag, sulfur::Real(5));
    EXPECT_EQ(zone.liquid->density, sulfur::Real(70));
    EXPECT_TRUE(zone.deadly);
    EXPECT_EQ(zone.pulse->phase, 2);
    EXPECT_EQ(zone.needs, "open");

    ASSERT_EQ(level->movers.size(), 1u);
    const Mover& mover = level->movers[0];
    EXPECT_EQ(mover.path.size(), 2u);
    EXPECT_EQ(mover.mode, Mover::Mode::door);
    EXPECT_EQ(mover.secondsBack, 1);
    EXPECT_EQ(mover.pauseEnd, 0.25);
    EXPECT_FALSE(mover.ease);

    ASSERT_EQ(level->switches.size(), 1u);
    EXPECT_EQ(level->switches[0].mode, Switch::Mode::toggle);
    EXPECT_EQ(level->switches[0].weight, 2);
    ASSERT_EQ(level->monsters.size(), 1u);
    EXPECT_EQ(level->monsters[0].behaviour, Monster::Behaviour::flee);
    EXPECT_EQ(level->monsters[0].target, Monster::Target::rope);
    EXPECT_EQ(level->monsters[0].to, 1);
    EXPECT_EQ(level->surface("box-1").crumbles, 0.5);
    EXPECT_TRUE(level->surface("box-1").deadly);
    EXPECT_TRUE(level->surface("box-1").cuts);
    EXPECT_EQ(level->signals, (std::vector<std::string>{"dead", "open"}));
    EXPECT_EQ(level->signal("open"), 1u);
    EXPECT_EQ(level->signal("shut"), std::nullopt);
}

TEST(MechanicsFile, RespawnsAreRead) {
    const auto level = room(roomWith(R"("respawns": [{"body": "box-1", "every": 2, "phase": 1}])"));
    ASSERT_EQ(level->respawns.size(), 1u);
    EXPECT_EQ(level->respawns[0].every, 2);
    EXPECT_EQ(level->respawns[0].phase, 1);
}

TEST(MechanicsFile, WhatIsNotGivenHasItsDefault) {
    const auto level = room(roomWith(
        R"("movers": [{"body": "lift", "path": [[1, 2]], "seconds": 3}],
           "zones": [{"id": "a", "min": [0, 0], "max": [1, 1], "liquid": {}}])",
        lifted));
    EXPECT_EQ(level->movers[0].mode, Mover::Mode::pingpong);
    EXPECT_EQ(level->movers[0].secondsBack, 3);  // as long as the way there
    EXPECT_TRUE(level->movers[0].ease);
    EXPECT_EQ(level->zones[0].liquid->density, Zone::Liquid().density);
    EXPECT_FALSE(level->zones[0].pulse.has_value());
    EXPECT_TRUE(level->signals.empty());
    EXPECT_FALSE(level->countdown.has_value());
}

TEST(MechanicsFile, AStarNamesAllThatBeginSo) {
    const auto level =
        room(roomWith(R"("surfaces": {"b*": {"sticky": false}, "box*": {"cuts": true},
        "room": {"deadly": true}})"));
    EXPECT_TRUE(level->surface("box-1").cuts);  // the longest counts
    EXPECT_TRUE(level->surface("box-1").sticky);
    EXPECT_FALSE(level->surface("barrel").sticky);
    EXPECT_TRUE(level->surface("room").deadly);
    EXPECT_FALSE(level->surface("roomy").deadly);
    expectRefused(R"("surfaces": {"sn*": {"sticky": false}})", {"sn*", "star"});
}

TEST(MechanicsFile, BodiesMustBeThereAndOfTheRightKind) {
    expectRefused(R"("movers": [{"body": "lorry", "spin": 1}])", {"lorry", "bodies"});
    expectRefused(R"("movers": [{"body": "box-1", "spin": 1}])", {"box-1", "kinematic"});
    expectRefused(R"("monsters": [{"body": "lift", "behaviour": "hang"}])", {"lift", "dynamic"});
    expectRefused(R"("respawns": [{"body": "room", "every": 1}])", {"room", "dynamic"});
    expectRefused(R"("movers": [{"body": "lift", "spin": 1}, {"body": "lift", "spin": 2}])",
                  {"lift", "twice"});
}

TEST(MechanicsFile, IdsAreUnique) {
    expectRefused(
        R"("checkpoints": [{"id": "a", "position": [0, 1]}, {"id": "a", "position": [1, 1]}])",
        {"\"a\"", "taken"});
    expectRefused(R"("pickups": [{"id": "", "position": [0, 1]}])", {"id"});
}

TEST(MechanicsFile, PlacesLieWithinTheLevel) {
    expectRefused(R"("checkpoints": [{"id": "a", "position": [0, 40]}])", {"bounds"});
    expectRefused(R"("pickups": [{"id": "a", "position": [40, 0]}])", {"bounds"});
    expectRefused(
        R"("switches": [{"id": "a", "position": [40, 0], "size": [1, 1], "signal": "x"}])",
        {"bounds"});
}

TEST(MechanicsFile, SignalsMustComeFromSomewhere) {
    expectRefused(R"("movers": [{"body": "lift", "spin": 1, "needs": "open"}])",
                  {"needs", "nothing turns on"});
    expectRefused(
        R"("switches": [{"id": "a", "position": [0, 1], "size": [1, 1], "signal": "shut"}],
"zones": [{"id": "z", "min": [0, 0], "max": [1, 1], "deadly": true, "needs": "open"}])",
        {"nothing turns on", "shut"});
    try {
        parseLevel(replaced(roomText, "\"radius\": 0.4}", "\"radius\": 0.4, \"needs\": \"key\"}"),
                   "room.json");
        FAIL() << "was not refused";
    } catch (const sulfur::scene::ReadError& error) {
        EXPECT_NE(std::string(error.what()).find("room.json:8"), std::string::npos) << error.what();
    }
}

TEST(MechanicsFile, NonsenseIsRefused) {
    expectRefused(R"("zones": [{"id": "z", "min": [0, 0], "max": [1, 1]}])", {"does nothing"});
    expectRefused(R"("zones": [{"id": "z", "min": [1, 0], "max": [1, 1], "deadly": true}])",
                  {"max", "min"});
    expectRefused(R"("zones": [{"id": "z", "min": [0, 0], "max": [1, 1], "deadly": true,
"pulse": {"period": 1, "on": 2}}])",
                  {});
    expectRefused(R"("movers": [{"body": "lift"}])", {"does not move"});
    expectRefused(R"("movers": [{"body": "lift", "path": [[1, 2]]}])", {"seconds"});
    expectRefused(R"("movers": [{"body": "lift", "spin": 1, "mode": "door"}])", {"signal"});
    expectRefused(R"("movers": [{"body": "lift", "turn": 1, "seconds": 1, "mode": "loop"}])",
                  {"go round"});
    expectRefused(R"("monsters": [{"body": "box-1", "behaviour": "patrol"}])", {"between"});
    expectRefused(R"("monsters": [{"body": "box-1", "behaviour": "patrol", "between": [1, 0]}])",
                  {"right"});
    expectRefused(
        R"("switches": [{"id": "a", "position": [0, 1], "size": [1, 1], "by": "me", "signal": "x"}])",
        {"nobody"});
    expectRefused(
        R"("switches": [{"id": "a", "position": [0, 1], "size": [1, 1], "weight": 1, "signal": "x"}])",
        {"weight", "any"});
    expectRefused(
        R"("switches": [{"id": "a", "position": [0, 1], "size": [1, 1], "mode": "once", "lasts": 1, "signal": "x"}])",
        {"lasts", "hold"});
    expectRefused(R"("surfaces": {"box-1": {"crumbles": -1}})", {"crumbles"});
    expectRefused(R"("countdown": 0)", {"countdown"});
    expectRefused(R"("checkpoints": [{"id": "a", "position": [0, 1], "size": 3}])",
                  {"size", "allowed"});
}

}  // namespace
}  // namespace quaoar::test
