// The programs as a user starts them: output, exit status, files.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atlax/image.hpp>
#include <cstdio>
#include <set>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

struct Outcome {
    int status = -1;
    std::string output;  ///< both streams
};

Outcome run(const std::string& command) {
    // Without a display and without sound: that is where these must work.
    const std::string whole = "env -u DISPLAY -u WAYLAND_DISPLAY " + command + " 2>&1";
    Outcome outcome;
    FILE* pipe = popen(whole.c_str(), "r");
    if (pipe == nullptr) return outcome;
    std::array<char, 4096> buffer{};
    while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        outcome.output.append(buffer.data(), read);
    }
    const int status = pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return outcome;
}

std::string quoted(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

const std::string game = std::string("'") + QUAOAR_PROGRAM + "' ";
const std::string solver = std::string("'") + QUAOAR_SOLVER + "' ";

std::filesystem::path coldWake() {
    return levelsFolder() / "01-cold-wake.json";
}

/// One sentence on one line, nothing else.
void expectOneSentence(const Outcome& outcome) {
    EXPECT_NE(outcome.status, 0);
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    EXPECT_EQ(outcome.output.find("quaoar"), 0u) << outcome.output;
}

TEST(Program, HelpAndVersion) {
    for (const std::string& program : {game, solver}) {
        EXPECT_EQ(run(program + "--help").status, 0);
        const Outcome version = run(program + "--version");
        EXPECT_EQ(version.status, 0);
        EXPECT_NE(version.output.find("."), std::string::npos);
    }
    const Outcome help = run(game + "--help");
    for (const char* option : {"--level", "--headless", "--verify", "--screenshot", "--at",
                               "--replay", "--record", "--play"}) {
        EXPECT_NE(help.output.find(option), std::string::npos) << option;
    }
}

TEST(Program, VerifiesTheFirstLevelTwiceWithTheSameHash) {
    const std::string command = game + "--headless --verify " + quoted(coldWake());
    const Outcome first = run(command), second = run(command);
    EXPECT_EQ(first.status, 0) << first.output;
    EXPECT_NE(first.output.find("01-cold-wake  finished  "), std::string::npos) << first.output;
    EXPECT_EQ(first.output, second.output);
}

TEST(Program, ALevelWithoutProofIsNotFinished) {
    const Folder folder("proofless");
    std::filesystem::copy_file(coldWake(), folder / "x.json");
    const Outcome outcome =
        run(game + "--headless --verify " + quoted(folder / "x.json") + " " + quoted(coldWake()));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.output.find("x  not finished"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("01-cold-wake  finished"), std::string::npos);
}

TEST(Program, AProofThatStopsEarlyIsNotFinished) {
    const Folder folder("early");
    std::filesystem::copy_file(coldWake(), folder / "01-cold-wake.json");
    const auto level = firstLevel();
    Recording recording(*level);
    for (int n = 0; n < 300; ++n) recording.append(fireAt(0, 1));
    recording.write(folder / "01-cold-wake.proof");
    const Outcome outcome =
        run(game + "--headless --verify " + quoted(folder / "01-cold-wake.json"));
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.output.find("not finished"), std::string::npos) << outcome.output;
}

TEST(Program, BrokenLevelsAreRefusedAndNothingIsWritten) {
    const Folder folder("broken");
    const std::string good = readText(coldWake());
    const std::string texts[] = {
        "", good.substr(0, good.size() / 2), replaced(good, "1.2, 0.25", "NaN, 0.25"),
        replaced(good, "\"killDepth\": -4", "\"killDepth\": []"), std::string(10u << 20, ' ')};
    for (const std::string& text : texts) {
        writeText(folder / "bad.json", text);
        const std::string level = quoted(folder / "bad.json");
        expectOneSentence(run(game + "--headless --verify " + level));
        expectOneSentence(run(game + "--screenshot " + quoted(folder / "bad.png") + " --level " +
                              level + " --at 1"));
        expectOneSentence(
            run(game + "--level " + level + " --record " + quoted(folder / "bad.rec")));
        expectOneSentence(run(solver + level));
    }
    std::set<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        left.insert(entry.path().filename().string());
    }
    EXPECT_EQ(left, std::set<std::string>{"bad.json"});
}

TEST(Program, UnknownFilesAndOptionsAreRefused) {
    expectOneSentence(run(game + "--headless --verify /nonexistent.json"));
    expectOneSentence(run(game + "--level /nonexistent.json"));
    expectOneSentence(run(game + "--play /nonexistent.proof"));
    EXPECT_NE(run(game + "--headless").status, 0);
    EXPECT_NE(run(game + "--at 3").status, 0);
    EXPECT_NE(run(game + "--jump").status, 0);
    const Folder folder("size");
    expectOneSentence(run(game + "--screenshot " + quoted(folder / "a.png") + " --size 9x9"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(Program, TheSolverNamesWhatItDoesNotKnow) {
    const Outcome option = run(solver + "--foo");
    EXPECT_NE(option.status, 0);
    EXPECT_NE(option.output.find("--foo"), std::string::npos) << option.output;
    expectOneSentence(run(solver));
    expectOneSentence(run(solver + "/nonexistent.json"));
}

TEST(Program, TheSolverTellsWhatACheckFound) {
    const Outcome good =
        run(solver + quoted(coldWake()) + " --check " + quoted(proofOf(coldWake())));
    EXPECT_EQ(good.status, 0) << good.output;
    EXPECT_NE(good.output.find("is finished after"), std::string::npos) << good.output;
    const Outcome row = run(solver + "--table " + quoted(coldWake()));
    EXPECT_EQ(row.status, 0) << row.output;
    EXPECT_NE(row.output.find("survival"), std::string::npos) << row.output;
    EXPECT_NE(row.output.find("01-cold-wake"), std::string::npos) << row.output;
}

TEST(Program, AScreenshotIsAPicture) {
    const Folder folder("picture");
    const Outcome outcome =
        run(game + "--screenshot " + quoted(folder / "a.png") + " --level " + quoted(coldWake()) +
            " --at 2.5 --replay " + quoted(proofOf(coldWake())) + " --size 640x360");
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    const atlax::Image image = atlax::loadImage(folder / "a.png");
    EXPECT_EQ(image.size(), (atlax::PixelSize{640, 360}));
    std::set<std::array<std::uint8_t, 4>> colours;
    int amber = 0, bright = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto p = image.pixel(x, y);
            colours.insert(p);
            amber += p[0] > 200 && p[1] > 110 && p[1] < 200 && p[2] < 110 ? 1 : 0;
            bright += p[0] > 200 && p[1] > 220 && p[2] > 230 ? 1 : 0;
        }
    }
    EXPECT_GT(colours.size(), 1000u) << "sky, ice and lights have many shades";
    EXPECT_GT(amber, 40) << "the hero is amber";
    EXPECT_GT(bright, 300) << "snow and text are bright";
}

TEST(Program, TheSolverFindsAWayThroughASmallRoom) {
    const Folder folder("solve");
    writeText(folder / "room.json", roomText);
    const Outcome solved = run(solver + quoted(folder / "room.json") + " --tries 2 --practice 0");
    EXPECT_EQ(solved.status, 0) << solved.output;
    const Outcome verified = run(game + "--headless --verify " + quoted(folder / "room.json"));
    EXPECT_EQ(verified.status, 0) << verified.output;
    EXPECT_NE(verified.output.find("room  finished"), std::string::npos) << verified.output;
    // What has been measured stays when somebody only wants a quicker proof.
    const auto way = folder / "room.way";
    const std::string measured =
        replaced(replaced(readText(way), "survival 0.0", "survival 50.0"), "games 0", "games 8");
    writeText(way, measured);
    const Outcome again = run(solver + quoted(folder / "room.json") + " --practice 0");
    EXPECT_EQ(again.status, 0) << again.output;
    EXPECT_EQ(readText(way), measured);
    // Games alone change nothing, unless what they have shown is to be kept.
    const std::string games = solver + quoted(folder / "room.json") + " --bot 3";
    EXPECT_EQ(run(games).status, 0);
    EXPECT_EQ(readText(way), measured);
    EXPECT_EQ(run(games + " --keep").status, 0);
    EXPECT_NE(readText(way).find("\ngames 3\n"), std::string::npos) << readText(way);
    EXPECT_NE(run(solver + quoted(folder / "room.json") + " --keep").status, 0);
    // A proof that finishes with another hash, as after a change of the physics, gets that hash.
    const auto proof = folder / "room.proof";
    const std::string proven = readText(proof);
    Recording other = Recording::read(proof);
    other.finalHash ^= 1;
    other.write(proof);
    EXPECT_NE(readText(proof), proven);
    const Outcome repaired = run(solver + quoted(folder / "room.json") + " --repair");
    EXPECT_EQ(repaired.status, 0) << repaired.output;
    EXPECT_NE(repaired.output.find("finishes as before"), std::string::npos) << repaired.output;
    EXPECT_EQ(readText(proof), proven);
    EXPECT_NE(readText(way).find("\ngames 0\n"), std::string::npos) << "it was measured before";
}

TEST(Program, TheSolverGivesUpHonestly) {
    const Folder folder("walled");
    // The exit lies behind a wall.
    writeText(folder / "room.json",
              replaced(replaced(roomText, "\"bodies\": [",
                                "\"bodies\": [\n    {\"id\": \"wall\", \"blueprint\": \"wall\"},"),
                       "\"box\": {",
                       "\"wall\": {\"shape\": \"ground\", \"kind\": \"fixed\", "
                       "\"points\": [[2, 0], [2, 3]]},\n    \"box\": {"));
    const Outcome outcome = run(solver + quoted(folder / "room.json"));
    expectOneSentence(outcome);
    EXPECT_NE(outcome.output.find("no free space leads"), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "room.proof"));
}

}  // namespace
}  // namespace quaoar::test
