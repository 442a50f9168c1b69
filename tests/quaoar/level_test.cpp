// Level files: what is read, and how each kind of damage is refused.
#include <gtest/gtest.h>
#include <unistd.h>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

/// The message with which a text is refused; fails the test when it is not.
std::string refusal(const std::string& text) {
    try {
        parseLevel(text, "room.json");
    } catch (const sulfur::scene::ReadError& error) {
        return error.what();
    }
    ADD_FAILURE() << "was not refused:\n" << text.substr(0, 400);
    return "";
}

void expectRefusal(const std::string& from, const std::string& to,
                   std::initializer_list<const char*> parts) {
    const std::string message = refusal(replaced(roomText, from, to));
    for (const char* part : parts) {
        EXPECT_NE(message.find(part), std::string::npos) << "\"" << part << "\" in: " << message;
    }
}

TEST(LevelFile, TheFirstLevelIsRead) {
    const auto level = firstLevel();
    EXPECT_EQ(level->id, "01-cold-wake");
    EXPECT_EQ(level->name, "Cold Wake");
    EXPECT_EQ(level->number, 1);
    EXPECT_GT(level->exit.position.x() - level->spawn.x(), 15);
    EXPECT_GE(level->hints.size(), 3u);
    EXPECT_EQ(level->surface("bolt-1").look, Surface::Look::peg);
    EXPECT_TRUE(level->surface("cave").sticky);
    EXPECT_TRUE(sulfur::scene::unknownKeys(level->scene).empty());
}

TEST(LevelFile, MedalsFollowTheTimes) {
    const auto level = room();
    EXPECT_EQ(level->medalFor(5), Medal::gold);
    EXPECT_EQ(level->medalFor(5.1), Medal::silver);
    EXPECT_EQ(level->medalFor(20), Medal::bronze);
    EXPECT_EQ(level->medalFor(20.1), Medal::none);
}

TEST(LevelFile, TruncatedIsRefusedWithItsLine) {
    for (const std::size_t length :
         {std::size_t{1}, std::size_t{60}, roomText.size() / 2, roomText.size() - 4}) {
        const std::string message = refusal(roomText.substr(0, length));
        EXPECT_EQ(message.find("room.json:"), 0u) << message;
    }
}

TEST(LevelFile, NothingIsRefused) {
    EXPECT_NE(refusal("").find("room.json"), std::string::npos);
    EXPECT_NE(refusal(std::string(100, ' ')).find("room.json"), std::string::npos);
    EXPECT_NE(refusal(std::string(100, '\0')).find("room.json"), std::string::npos);
}

TEST(LevelFile, TenMegabytesOfNothingAreRefused) {
    const Folder folder("big");
    for (const char byte : {' ', '\0'}) {
        writeText(folder / "big.json", std::string(10u << 20, byte));
        try {
            readLevel(folder / "big.json");
            FAIL() << "was not refused";
        } catch (const sulfur::scene::ReadError& error) {
            EXPECT_NE(std::string(error.what()).find("big.json"), std::string::npos);
        }
    }
}

TEST(LevelFile, NotANumberIsRefusedWithItsLine) {
    expectRefusal("[0, 0.3]", "[NaN, 0.3]", {"room.json:7"});
    expectRefusal("[0, 0.3]", "[1e400, 0.3]", {"room.json:7"});
    expectRefusal("\"mass\": 1", "\"mass\": NaN", {"room.json:16"});
}

TEST(LevelFile, WrongTypesAreRefusedWithTheirLine) {
    expectRefusal("\"killDepth\": -3", "\"killDepth\": \"deep\"", {"room.json:10", "killDepth"});
    expectRefusal("\"number\": 1", "\"number\": 1.5", {"room.json:6", "number"});
    expectRefusal("\"name\": \"Room\"", "\"name\": 7", {"room.json:5", "name"});
    expectRefusal("{\"position\": [3.2, 0.3], \"radius\": 0.4}", "[3, 0]", {"room.json:8"});
}

TEST(LevelFile, UnknownJointIndexIsRefusedWithItsLine) {
    const std::string from = R"("box": {"shape": "box", "size": [0.4, 0.4], "mass": 1})";
    const std::string to =
        "\"box\": {\"particles\": [{\"position\": [0, 0], \"mass\": 1},\n"
        "  {\"position\": [1, 0], \"mass\": 1}],\n"
        "  \"joints\": [{\"a\": 0, \"b\": 7}]}";
    expectRefusal(from, to, {"room.json:18", "box", "7"});
}

TEST(LevelFile, MissingAndUnknownMembersAreRefused) {
    expectRefusal("\"killDepth\": -3,\n", "", {"room.json:4", "killDepth"});
    expectRefusal("\"killDepth\"", "\"kilDepth\"", {"room.json:10", "kilDepth", "allowed"});
    expectRefusal("\"level\"", "\"levle\"", {"room.json", "level"});
}

TEST(LevelFile, PlacesOutsideOfTheLevelAreRefused) {
    expectRefusal("[0, 0.3]", "[0, 30]", {"room.json:7", "bounds"});
    expectRefusal("[3.2, 0.3]", "[32, 0.3]", {"room.json:8", "bounds"});
    expectRefusal("\"killDepth\": -3", "\"killDepth\": 1", {"room.json:10", "spawn"});
}

TEST(LevelFile, MedalsOutOfOrderAreRefused) {
    expectRefusal("\"gold\": 5", "\"gold\": 50", {"room.json:11", "gold <= silver"});
}

TEST(LevelFile, SurfacesOfUnknownBodiesAreRefused) {
    expectRefusal("\"killDepth\": -3,",
                  "\"killDepth\": -3, \"surfaces\": {\"wall\": {\"sticky\": false}},",
                  {"room.json:10", "wall"});
    expectRefusal("\"killDepth\": -3,",
                  "\"killDepth\": -3, \"surfaces\": {\"room\": {\"look\": \"wood\"}},",
                  {"room.json:10", "wood", "mirror"});
}

TEST(LevelFile, AnotherTickRateIsRefused) {
    expectRefusal("\"version\": 1,", "\"version\": 1, \"world\": {\"tickRate\": 240},",
                  {"room.json", "500"});
}

TEST(LevelFile, ColoursAreChecked) {
    const std::string theme = "\"killDepth\": -3, \"theme\": {\"ice\": \"#12345\"},";
    expectRefusal("\"killDepth\": -3,", theme, {"room.json:10", "#rrggbb"});
}

/// What readLevel says to a text.
std::string checked(const std::string& text) {
    const Folder folder("checked");
    writeText(folder / "room.json", text);
    try {
        readLevel(folder / "room.json");
    } catch (const sulfur::scene::ReadError& error) {
        return error.what();
    }
    return "";
}

TEST(LevelFile, SpawnAndExitInRockAreRefused) {
    EXPECT_EQ(checked(roomText), "");
    const std::string deep = checked(replaced(roomText, "[0, 0.3]", "[0, 0.03]"));
    EXPECT_NE(deep.find("room.json: object \"spawn\": lies in \"room\""), std::string::npos)
        << deep;
    const std::string block = replaced(
        replaced(roomText, "\"box\": {",
                 "\"block\": {\"shape\": \"ground\", \"kind\": \"fixed\", \"closed\": true, "
                 "\"points\": [[-1, 1], [1, 1], [1, -1], [-1, -1]]},\n    \"box\": {"),
        "\"bodies\": [",
        "\"bodies\": [\n    {\"id\": \"block\", \"blueprint\": \"block\", \"position\": [3, 1]},");
    const std::string exit = checked(block);
    EXPECT_NE(exit.find("\"exit\": lies in \"block\""), std::string::npos) << exit;
    // The same outline the other way round is a chamber, which nobody can enter.
    const std::string chamber = checked(replaced(block, "[[-1, 1], [1, 1], [1, -1], [-1, -1]]",
                                                 "[[-1, 1], [-1, -1], [1, -1], [1, 1]]"));
    EXPECT_NE(chamber.find("\"exit\": lies within the closed outline of \"block\""),
              std::string::npos)
        << chamber;
}

TEST(LevelFile, AMissingFileIsNamed) {
    try {
        readLevel("/nonexistent/level.json");
        FAIL() << "was not refused";
    } catch (const sulfur::scene::ReadError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find("/nonexistent/level.json"), 0u) << message;
        EXPECT_EQ(message.rfind("/nonexistent/level.json"), 0u) << "named twice: " << message;
    }
}

}  // namespace
}  // namespace quaoar::test
