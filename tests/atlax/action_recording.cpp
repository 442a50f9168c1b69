#include <gtest/gtest.h>

#include <atlax/action_recording.hpp>
#include <atlax/error.hpp>
#include <random>

namespace {

using namespace atlax;

std::vector<ActionState> randomStates(std::size_t count) {
    std::mt19937 random(17);
    std::vector<ActionState> out;
    ActionState state;
    for (std::size_t i = 0; i < count; ++i) {
        state.pressed.reset();
        state.released.reset();
        if (random() % 4 == 0) {
            const auto a = random() % maxActions;
            state.values[a] = static_cast<std::uint8_t>(random());
            state.presses[a] = static_cast<std::uint8_t>(random() % 3);
            state.down[a] = random() % 2 == 0;
            state.pressed[random() % maxActions] = true;
            state.released[random() % maxActions] = true;
        }
        if (random() % 16 == 0) state.pointerX = static_cast<std::int16_t>(random());
        if (random() % 16 == 0) state.pointerY = static_cast<std::int16_t>(random());
        out.push_back(state);
    }
    return out;
}

ActionRecording recordingOf(const std::vector<ActionState>& states) {
    ActionRecording out;
    for (const ActionState& s : states) out.append(s);
    return out;
}

TEST(ActionRecording, whatWasAppendedComesBack) {
    const auto states = randomStates(5000);
    const auto bytes = recordingOf(states).encode();
    const ActionRecording read = ActionRecording::decode(bytes, 5000);
    EXPECT_EQ(read.ticks(), 5000u);
    EXPECT_EQ(read.encode(), bytes);
    ActionPlayback playback(read);
    for (const ActionState& s : states) ASSERT_EQ(playback.next(), s);
    EXPECT_TRUE(playback.done());
    EXPECT_EQ(playback.next(), ActionState{});
}

TEST(ActionRecording, aDecodedOneCanBeContinued) {
    const auto states = randomStates(400);
    ActionRecording recording =
        ActionRecording::decode(recordingOf({states.begin(), states.begin() + 200}).encode(), 1000);
    for (std::size_t i = 200; i < states.size(); ++i) recording.append(states[i]);
    EXPECT_EQ(recording.encode(), recordingOf(states).encode());
}

TEST(ActionRecording, holdingCostsNothing) {
    ActionState held;
    held.down[3] = true;
    held.values[3] = 255;
    ActionRecording recording;
    for (int i = 0; i < 1'000'000; ++i) recording.append(held);
    EXPECT_LT(recording.encode().size(), 20u);
    EXPECT_EQ(ActionRecording::decode(ActionRecording().encode(), 0).ticks(), 0u);
}

TEST(ActionRecording, otherBytesAreRefusedOrRead) {
    const auto bytes = recordingOf(randomStates(300)).encode();
    EXPECT_THROW(ActionRecording::decode(bytes, 299), Error);
    EXPECT_THROW(ActionRecording::decode({}, 10), Error);
    std::mt19937 random(23);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        auto bad = bytes;
        bad[random() % bad.size()] ^= static_cast<std::byte>(1u << random() % 8);
        if (random() % 3 == 0) bad.resize(random() % bad.size());
        try {
            const auto read = ActionRecording::decode(bad, 100'000);
            ActionPlayback playback(read);
            for (std::uint64_t t = 0; t < read.ticks(); ++t) playback.next();
            EXPECT_TRUE(playback.done());
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 500);
}

}  // namespace
