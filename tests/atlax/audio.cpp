#include <gtest/gtest.h>

#include <atlax/audio.hpp>
#include <atlax/error.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace {

using namespace atlax;

std::vector<float> tone(int samples) {
    std::vector<float> out(static_cast<std::size_t>(samples));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = 0.5f * std::sin(static_cast<float>(i) * 0.06f);
    return out;
}

/// Each test decides which drivers OpenAL Soft may use; it reads them when a device is opened.
/// "null" is a device that plays into nothing; an unknown name leaves no device at all.
class AudioTest : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override { ::setenv("ALSOFT_DRIVERS", GetParam(), 1); }
};

TEST_P(AudioTest, everyCallWorksWithOrWithoutADevice) {
    Audio audio;
    const Sound sound = audio.createSound(tone(44'100), 44'100);
    EXPECT_NEAR(sound.seconds(), 1, 1e-9);
    const Voice voice = audio.play(sound, {.gain = 0.5f, .pitch = 1.5f, .pan = -1, .loop = true});
    EXPECT_EQ(audio.playing(voice), audio.available());
    audio.setGain(voice, 0.1f);
    audio.setPitch(voice, 2);
    audio.setPan(voice, 0.3f);
    audio.setMasterVolume(0.25f);
    EXPECT_EQ(audio.masterVolume(), 0.25f);
    audio.setPaused(true);
    EXPECT_EQ(audio.playing(voice), audio.available()) << "held is not over";
    audio.setPaused(false);
    audio.stop(voice);
    EXPECT_FALSE(audio.playing(voice));
    audio.stop(voice);
    audio.stopAll();
}

TEST_P(AudioTest, nonsenseDoesNoHarm) {
    Audio audio;
    const float nan = std::nanf("");
    std::vector<float> samples{nan, std::numeric_limits<float>::infinity(), -5, 5};
    const Sound sound = audio.createSound(samples, 8'000);
    audio.play(sound, {.gain = nan, .pitch = -3, .pan = nan});
    audio.setMasterVolume(nan);
    EXPECT_EQ(audio.masterVolume(), 0);
    EXPECT_EQ(audio.play(Sound(), {}), Voice{});
    EXPECT_FALSE(audio.playing({}));
    EXPECT_FALSE(audio.playing({1000, 7}));
    EXPECT_THROW(audio.createSound(std::span<const float>(), 44'100), Error);
    EXPECT_THROW(audio.createSound(samples, 10), Error);
}

TEST_P(AudioTest, soundsMayOutliveTheirAudio) {
    Sound sound;
    {
        Audio audio;
        sound = audio.createSound(tone(1000), 44'100);
        audio.play(sound);
    }
    Audio other;
    EXPECT_EQ(other.play(sound), Voice{}) << "it belongs to a device that is gone";
    EXPECT_GT(sound.seconds(), 0);
}

INSTANTIATE_TEST_SUITE_P(Drivers, AudioTest, testing::Values("null", "nosuchdriver"));

TEST(AudioVoices, theOldestOneIsTakenOverButNeverALoop) {
    ::setenv("ALSOFT_DRIVERS", "null", 1);
    Audio audio;
    ASSERT_TRUE(audio.available());
    const Sound sound = audio.createSound(tone(20 * 44'100), 44'100);
    const Voice loop = audio.play(sound, {.loop = true});
    const Voice oldest = audio.play(sound);
    for (int i = 0; i < 30; ++i) audio.play(sound);
    EXPECT_TRUE(audio.playing(oldest));
    const Voice newest = audio.play(sound);
    EXPECT_FALSE(audio.playing(oldest));
    EXPECT_TRUE(audio.playing(newest));
    EXPECT_TRUE(audio.playing(loop));
    audio.setGain(oldest, 0);  // stale: must not touch the voice that took its place
}

}  // namespace
