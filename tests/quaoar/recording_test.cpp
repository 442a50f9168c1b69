// Recordings: what goes in comes out, and damage is refused with its line.
#include <gtest/gtest.h>
#include <unistd.h>

#include "helpers.hpp"

namespace quaoar::test {
namespace {

Recording sample() {
    Recording recording(*room());
    TickInput input = fireAt(0.3, 1);
    for (int n = 0; n < 70; ++n) recording.append(input);
    input.reelIn = true;
    input.push = -127;
    for (int n = 0; n < 30; ++n) recording.append(input);
    input.restart = true;
    recording.append(input);
    recording.finalHash = 0xfedcba9876543210u;
    return recording;
}

std::string refusalOf(const std::string& text) {
    try {
        Recording::parse(text, "a.proof");
    } catch (const RecordingError& error) {
        return error.what();
    }
    ADD_FAILURE() << "was not refused:\n" << text.substr(0, 600);
    return "";
}

TEST(Recording, RunsOfEqualInputsAreOneLine) {
    const Recording recording = sample();
    EXPECT_EQ(recording.ticks(), 101u);
    EXPECT_EQ(recording.runs().size(), 3u);
}

TEST(Recording, WhatIsWrittenIsRead) {
    const Folder folder("round");
    const Recording recording = sample();
    recording.write(folder / "a.proof");
    const Recording read = Recording::read(folder / "a.proof");
    EXPECT_EQ(read.runs(), recording.runs());
    EXPECT_EQ(read.ticks(), recording.ticks());
    EXPECT_EQ(read.levelId, "room");
    EXPECT_EQ(read.levelHash, recording.levelHash);
    EXPECT_EQ(read.finalHash, recording.finalHash);
    EXPECT_EQ(read.format(), recording.format());
}

TEST(Recording, EveryTruncationIsRefused) {
    const std::string text = sample().format();
    for (std::size_t length = 0; length < text.size(); ++length) {
        const std::string message = refusalOf(text.substr(0, length));
        EXPECT_EQ(message.find("a.proof:"), 0u) << message;
    }
}

TEST(Recording, DamageIsRefusedWithItsLine) {
    const std::string text = sample().format();
    EXPECT_NE(refusalOf(replaced(text, "recording 1", "recording 9")).find("a.proof:1:"),
              std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "numbers ", "numbers x")).find("a.proof:5:"),
              std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "ticks 101", "ticks 99999999999")).find("a.proof:6:"),
              std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "\n70 ", "\n-70 ")).find("a.proof:9:"), std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "\n70 ", "\n0 ")).find("a.proof:9:"), std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "\n70 ", "\n71 ")).find("longer"), std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "\n70 ", "\n69 ")).find("shorter"), std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "\n70 ", "\n1 70 ")).find("a.proof:9:"), std::string::npos);
    EXPECT_NE(refusalOf(replaced(text, "fedcba", "fedxba")).find("a.proof:7:"), std::string::npos);
    EXPECT_NE(refusalOf(text + "more\n").find("after"), std::string::npos);
    EXPECT_NE(refusalOf(std::string(1000, '\0')).find("a.proof:1:"), std::string::npos);
}

TEST(Recording, HugeFilesAreRefusedUnread) {
    const Folder folder("huge");
    writeText(folder / "a.proof", std::string(Recording::maxBytes + 1, '\n'));
    EXPECT_THROW(Recording::read(folder / "a.proof"), RecordingError);
    EXPECT_THROW(Recording::read(folder / "missing.proof"), RecordingError);
}

TEST(Recording, AReplayIsTheRun) {
    const auto level = firstLevel();
    Session session(level);
    Recording recording(*level);
    for (int n = 0; n < 1500; ++n) {
        TickInput input = fireAt(0.2 + 0.001 * n, 1);
        input.fire = n % 300 > 30;
        input.reelIn = n % 300 > 150;
        session.tick(input);
        recording.append(input);
    }
    recording.finalHash = session.hash();
    const Verdict verdict = verify(level, recording);
    EXPECT_TRUE(verdict.sameAsRecorded);
    EXPECT_FALSE(verdict.finished);
    EXPECT_EQ(verdict.ticks, 1500u);
    recording.finalHash ^= 1;
    EXPECT_FALSE(verify(level, recording).sameAsRecorded);
}

TEST(Recording, PlaybackHandsOutEveryTickThenNothing) {
    const auto recording = std::make_shared<const Recording>(sample());
    Playback playback(recording);
    std::uint64_t ticks = 0;
    Recording copy(*room());
    while (!playback.done()) {
        copy.append(playback.next());
        ++ticks;
    }
    EXPECT_EQ(ticks, recording->ticks());
    EXPECT_EQ(copy.runs(), recording->runs());
    EXPECT_FALSE(playback.next().fire);
}

TEST(Recording, AnotherLevelIsRefused) {
    const Recording recording = sample();
    EXPECT_THROW(verify(firstLevel(), recording), RecordingError);
    const auto changed = room(roomText + "\n");
    EXPECT_THROW(verify(changed, recording), RecordingError);
}

}  // namespace
}  // namespace quaoar::test
