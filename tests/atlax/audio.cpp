#include <alext.h>
#include <gtest/gtest.h>
#include <vorbis/vorbisenc.h>

#include <atlax/audio.hpp>
#include <atlax/error.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

#include "audio_device.hpp"

namespace {

using namespace atlax;

std::vector<float> tone(int samples) {
    std::vector<float> out(static_cast<std::size_t>(samples));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = 0.5f * std::sin(static_cast<float>(i) * 0.06f);
    return out;
}

/// A tone of so many seconds as an Ogg Vorbis file.
std::vector<std::byte> oggTone(double seconds, float hertz, int channels = 2, int serial = 1) {
    constexpr int rate = 44'100;
    std::vector<std::byte> out;
    vorbis_info info;
    vorbis_info_init(&info);
    vorbis_encode_init_vbr(&info, channels, rate, 0.3f);
    vorbis_comment comment;
    vorbis_comment_init(&comment);
    vorbis_dsp_state dsp;
    vorbis_analysis_init(&dsp, &info);
    vorbis_block block;
    vorbis_block_init(&dsp, &block);
    ogg_stream_state stream;
    ogg_stream_init(&stream, serial);
    ogg_page page;
    const auto add = [&](const unsigned char* data, long size) {
        const auto* bytes = reinterpret_cast<const std::byte*>(data);
        out.insert(out.end(), bytes, bytes + size);
    };
    const auto addPage = [&] {
        add(page.header, page.header_len);
        add(page.body, page.body_len);
    };
    ogg_packet packets[3];
    vorbis_analysis_headerout(&dsp, &comment, &packets[0], &packets[1], &packets[2]);
    for (auto& packet : packets) ogg_stream_packetin(&stream, &packet);
    while (ogg_stream_flush(&stream, &page) != 0) addPage();
    const int total = static_cast<int>(seconds * rate);
    for (int at = 0, piece = 0; piece != 0 || at == 0 || at <= total; at += 1024) {
        piece = std::min(1024, total - at);
        if (piece > 0) {
            float** buffer = vorbis_analysis_buffer(&dsp, piece);
            for (int i = 0; i < piece; ++i)
                for (int c = 0; c < channels; ++c)
                    buffer[c][i] =
                        0.5f * std::sin(6.2831853f * hertz * static_cast<float>(at + i) / rate);
        }
        vorbis_analysis_wrote(&dsp, std::max(piece, 0));
        while (vorbis_analysis_blockout(&dsp, &block) == 1) {
            vorbis_analysis(&block, nullptr);
            vorbis_bitrate_addblock(&block);
            ogg_packet packet;
            while (vorbis_bitrate_flushpacket(&dsp, &packet) != 0) {
                ogg_stream_packetin(&stream, &packet);
                while (ogg_stream_pageout(&stream, &page) != 0) addPage();
            }
        }
        if (piece <= 0) break;
    }
    while (ogg_stream_flush(&stream, &page) != 0) addPage();
    ogg_stream_clear(&stream);
    vorbis_block_clear(&block);
    vorbis_dsp_clear(&dsp);
    vorbis_comment_clear(&comment);
    vorbis_info_clear(&info);
    return out;
}

/// OpenAL Soft reads once in a process which drivers it may use, when anybody first opens a device:
/// that may be a test of another file.
[[maybe_unused]] const bool driverIsChosen = ::setenv("ALSOFT_DRIVERS", "null", 1) == 0;

/// "null" is a device that plays into nothing; with "none" there is no device at all.
class AudioTest : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        const bool none = std::strcmp(GetParam(), "none") == 0;
        if (none) detail::audioDriver().open = [](const char*) -> ALCdevice* { return nullptr; };
    }
    void TearDown() override { detail::audioDriver() = before_; }

private:
    detail::AudioDriver before_ = detail::audioDriver();
};

TEST_P(AudioTest, everyCallWorksWithOrWithoutADevice) {
    Audio audio;
    const Sound sound = audio.createSound(tone(44'100), 44'100);
    EXPECT_NEAR(sound.seconds(), 1, 1e-9);
    const Voice voice = audio.play(sound, {.gain = 0.5f, .pitch = 1.5f, .pan = -1, .loop = true});
    EXPECT_EQ(audio.available(), std::string(GetParam()) == "null");
    EXPECT_TRUE(audio.playing(voice));
    audio.setGain(voice, 0.1f);
    audio.setPitch(voice, 2);
    audio.setPan(voice, 0.3f);
    audio.setMasterVolume(0.25f);
    EXPECT_EQ(audio.masterVolume(), 0.25f);
    audio.setPaused(true);
    EXPECT_TRUE(audio.playing(voice)) << "held is not over";
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
    EXPECT_TRUE(other.playing(other.play(sound)));
    EXPECT_GT(sound.seconds(), 0);
}

TEST_P(AudioTest, voicesAndMusicEndWhenTheyShould) {
    Audio audio;
    const Voice once = audio.play(audio.createSound(tone(2205), 44'100), {.pitch = 0.5f});
    const Voice loop = audio.play(audio.createSound(tone(2205), 44'100), {.loop = true});
    audio.playMusic(Music(oggTone(0.3, 440), "short.ogg"), {.fadeSeconds = 0, .loop = false});
    EXPECT_TRUE(audio.musicPlaying());
    audio.update(0.01);
    EXPECT_TRUE(audio.playing(once));
    // A device plays in real time.
    for (int i = 0; i < 200 && (audio.playing(once) || audio.musicPlaying()); ++i) {
        if (audio.available()) {
            const timespec pause{0, 10'000'000};
            ::nanosleep(&pause, nullptr);
        }
        audio.update(0.01);
    }
    EXPECT_FALSE(audio.playing(once));
    EXPECT_FALSE(audio.musicPlaying());
    EXPECT_TRUE(audio.playing(loop));
}

TEST_P(AudioTest, aVoiceIsTakenOverByPriorityAndAge) {
    Audio audio;
    const Sound sound = audio.createSound(tone(20 * 44'100), 44'100);
    const Voice loop = audio.play(sound, {.loop = true});
    const Voice important = audio.play(sound, {.priority = 2});
    const Voice oldest = audio.play(sound);
    for (std::size_t i = 3; i < Audio::maxVoices; ++i) audio.play(sound);
    EXPECT_TRUE(audio.playing(oldest));
    EXPECT_EQ(audio.play(sound, {.priority = -1}), Voice{}) << "all others are more important";
    const Voice newest = audio.play(sound);
    EXPECT_FALSE(audio.playing(oldest));
    EXPECT_TRUE(audio.playing(newest));
    for (std::size_t i = 0; i < 2 * Audio::maxVoices; ++i) audio.play(sound);
    EXPECT_TRUE(audio.playing(loop));
    EXPECT_TRUE(audio.playing(important));
    for (std::size_t i = 0; i < Audio::maxVoices; ++i) audio.play(sound, {.priority = 1});
    EXPECT_FALSE(audio.playing(loop)) << "but not against a higher priority";
    EXPECT_TRUE(audio.playing(important));
    audio.setGain(oldest, 0);  // stale: must not touch the voice that took its place
}

TEST_P(AudioTest, busesScaleAndDuck) {
    Audio audio;
    const Sound sound = audio.createSound(tone(20 * 44'100), 44'100);
    const Voice effect = audio.play(sound, {.gain = 0.8f});
    const Voice wind = audio.play(sound, {.gain = 0.5f, .loop = true, .bus = Bus::Ambience});
    audio.setBusVolume(Bus::Ambience, 0.5f);
    EXPECT_FLOAT_EQ(audio.heard(wind)->gain, 0.25f);
    EXPECT_FLOAT_EQ(audio.heard(effect)->gain, 0.8f);
    audio.addDucking({.trigger = Bus::Interface,
                      .target = Bus::Ambience,
                      .gain = 0.2f,
                      .attackSeconds = 0.1f,
                      .releaseSeconds = 0.4f});
    const Voice speech = audio.play(sound, {.bus = Bus::Interface});
    for (int i = 0; i < 5; ++i) audio.update(0.01);
    EXPECT_GT(audio.heard(wind)->gain, 0.06f) << "not at once";
    for (int i = 0; i < 10; ++i) audio.update(0.01);
    EXPECT_NEAR(audio.heard(wind)->gain, 0.05f, 1e-4f);
    audio.stop(speech);
    for (int i = 0; i < 20; ++i) audio.update(0.01);
    EXPECT_NEAR(audio.heard(wind)->gain, 0.15f, 0.02f) << "half of the way back";
    for (int i = 0; i < 25; ++i) audio.update(0.01);
    EXPECT_NEAR(audio.heard(wind)->gain, 0.25f, 1e-4f);
    EXPECT_FALSE(audio.heard(speech).has_value());
}

TEST_P(AudioTest, distanceLowersAndSidesPan) {
    Audio audio;
    const Sound sound = audio.createSound(tone(20 * 44'100), 44'100);
    const Voice voice = audio.play(sound, {.placement = Placement{{0, 0}, 2, 20}});
    const auto at = [&](Vec2 position) {
        audio.setPosition(voice, position);
        return *audio.heard(voice);
    };
    EXPECT_FLOAT_EQ(at({0, 0}).gain, 1);
    EXPECT_FLOAT_EQ(at({0, 2}).gain, 1);
    EXPECT_NEAR(at({0, 4}).gain, (0.5f - 0.1f) / 0.9f, 1e-5f);
    EXPECT_EQ(at({20, 0}).gain, 0);
    EXPECT_EQ(at({1e30f, 0}).gain, 0);
    EXPECT_EQ(at({std::nanf(""), 0}).gain, 0);
    float last = 1;
    for (float x = 2; x < 22; x += 0.25f) {
        const float gain = at({x, 0}).gain;
        EXPECT_LE(gain, last);
        last = gain;
    }
    EXPECT_FLOAT_EQ(at({-10, 0}).pan, -1);
    EXPECT_NEAR(at({0, 10}).pan, 0, 1e-6f);
    audio.setListener({-20, 0});
    EXPECT_FLOAT_EQ(at({-10, 0}).pan, 1) << "it is to the right of the listener now";
}

TEST_P(AudioTest, parametersFollowPhysics) {
    Audio audio;
    const Voice voice =
        audio.play(audio.createSound(tone(20 * 44'100), 44'100), {.gain = 0, .loop = true});
    float tension = 0;
    const Curve pitch{0, 200, 0.5f, 2};
    audio.follow(voice, [&] { return VoiceParameters{.gain = 1, .pitch = pitch(tension)}; });
    for (int i = 0; i < 50; ++i) audio.update(0.01);
    EXPECT_NEAR(audio.heard(voice)->pitch, 0.5f, 1e-3f);
    EXPECT_NEAR(audio.heard(voice)->gain, 1, 1e-3f);
    tension = 200;
    audio.update(0.01);
    EXPECT_GT(audio.heard(voice)->pitch, 0.9f);
    EXPECT_LT(audio.heard(voice)->pitch, 1.6f) << "smoothly";
    for (int i = 0; i < 50; ++i) audio.update(0.01);
    EXPECT_NEAR(audio.heard(voice)->pitch, 2, 1e-3f);
    audio.follow(voice, []() -> VoiceParameters { throw Error("the rope is gone"); });
    audio.update(0.01);
    audio.update(0.01);
    EXPECT_TRUE(audio.playing(voice));
    EXPECT_NEAR(audio.heard(voice)->pitch, 2, 1e-3f);
}

TEST(Curve, isLevelOutside) {
    const Curve curve{10, 20, 1, 3};
    EXPECT_EQ(curve(0), 1);
    EXPECT_EQ(curve(15), 2);
    EXPECT_EQ(curve(99), 3);
    EXPECT_EQ(curve(std::nanf("")), 1);
    EXPECT_EQ((Curve{5, 5, 1, 2}(5)), 1);
}

INSTANTIATE_TEST_SUITE_P(Drivers, AudioTest, testing::Values("null", "none"));

TEST(Music, onlyOggVorbisIsTaken) {
    EXPECT_NEAR(Music(oggTone(1.5, 440), "good.ogg").seconds(), 1.5, 0.01);
    const auto refused = [](std::vector<std::byte> bytes) {
        try {
            const Music music(std::move(bytes), "bad.ogg");
        } catch (const Error& error) {
            return std::string(error.what()).starts_with("bad.ogg: ");
        }
        return false;
    };
    EXPECT_TRUE(refused({}));
    EXPECT_TRUE(refused(std::vector<std::byte>(1000)));
    EXPECT_TRUE(refused(oggTone(0.5, 440, 3)));
    auto twice = oggTone(0.2, 440);
    const auto again = oggTone(0.2, 440, 2, 2);
    twice.insert(twice.end(), again.begin(), again.end());
    EXPECT_TRUE(refused(twice));
    auto cut = oggTone(8, 440);
    cut.resize(cut.size() * 3 / 4);
    EXPECT_NO_THROW(Music(cut, "cut.ogg")) << "a shorter piece is one too";
}

/// Renders what would be heard, so that a test can listen: ALC_SOFT_loopback.
class Listening : public testing::Test {
protected:
    void SetUp() override {
        const auto open = reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(
            alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
        render_ = reinterpret_cast<LPALCRENDERSAMPLESSOFT>(
            alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
        if (open == nullptr || render_ == nullptr) GTEST_SKIP() << "OpenAL cannot render here";
        detail::AudioDriver& driver = detail::audioDriver();
        driver.open = [this, open](const char*) {
            ++opened;
            device_ = there ? open(nullptr) : nullptr;
            return device_;
        };
        driver.connected = [this](ALCdevice* device) { return there && device == device_; };
        driver.attributes = {ALC_FORMAT_CHANNELS_SOFT,
                             ALC_STEREO_SOFT,
                             ALC_FORMAT_TYPE_SOFT,
                             ALC_FLOAT_SOFT,
                             ALC_FREQUENCY,
                             rate,
                             0};
    }
    void TearDown() override { detail::audioDriver() = before_; }

    struct Loudness {
        double left = 0, right = 0;  ///< root mean square
        double both() const { return std::hypot(left, right); }
    };

    Loudness listen(double seconds) {
        std::vector<float> samples(2 * static_cast<std::size_t>(seconds * rate));
        render_(device_, samples.data(), static_cast<ALCsizei>(samples.size() / 2));
        Loudness out;
        for (std::size_t i = 0; i < samples.size(); i += 2) {
            out.left += static_cast<double>(samples[i] * samples[i]);
            out.right += static_cast<double>(samples[i + 1] * samples[i + 1]);
        }
        const double count = static_cast<double>(samples.size()) / 2;
        return {std::sqrt(out.left / count), std::sqrt(out.right / count)};
    }

    static constexpr int rate = 48'000;
    bool there = true;  ///< whether a device is plugged in
    int opened = 0;

private:
    LPALCRENDERSAMPLESSOFT render_ = nullptr;
    ALCdevice* device_ = nullptr;
    detail::AudioDriver before_ = detail::audioDriver();
};

TEST_F(Listening, gainPanAndBusesAreHeard) {
    Audio audio;
    const Sound sound = audio.createSound(tone(44'100), 44'100);
    const Voice voice = audio.play(sound, {.pan = -1, .loop = true});
    const Loudness left = listen(0.2);
    EXPECT_GT(left.left, 0.1);
    EXPECT_GT(left.left, 4 * left.right);
    audio.setPan(voice, 1);
    listen(0.1);
    const Loudness right = listen(0.2);
    EXPECT_GT(right.right, 4 * right.left);
    audio.setBusVolume(Bus::Effects, 0.5f);
    listen(0.1);
    EXPECT_NEAR(listen(0.2).both() / right.both(), 0.5, 0.02);
    audio.setMasterVolume(0);
    listen(0.1);
    EXPECT_LT(listen(0.2).both(), 1e-4);
}

TEST_F(Listening, musicCrossFadesWithoutADip) {
    Audio audio;
    const Music first(oggTone(3, 440), "first.ogg"), second(oggTone(3, 660), "second.ogg");
    const auto step = [&] {
        audio.update(0.02);
        return listen(0.02).both();
    };
    audio.playMusic(first, {.fadeSeconds = 0});
    for (int i = 0; i < 20; ++i) step();
    const double full = step();
    EXPECT_GT(full, 0.2);
    EXPECT_NEAR(audio.musicSeconds(), 0.4, 0.25);
    audio.playMusic(first, {});
    EXPECT_GT(audio.musicSeconds(), 0.1) << "it plays already";
    audio.playMusic(second, {.fadeSeconds = 1});
    double least = full, most = 0;
    for (int i = 0; i < 60; ++i) {
        const double now = step();
        least = std::min(least, now);
        most = std::max(most, now);
    }
    EXPECT_GT(least, 0.7 * full);
    EXPECT_LT(most, 1.5 * full);
    // Longer than it lasts: it loops.
    double quietest = full;
    for (int i = 0; i < 200; ++i) quietest = std::min(quietest, step());
    EXPECT_GT(quietest, 0.6 * full);
    audio.stopMusic(0.1f);
    for (int i = 0; i < 10; ++i) step();
    EXPECT_LT(step(), 1e-3);
    EXPECT_FALSE(audio.musicPlaying());
}

TEST_F(Listening, aProgramThatWasAwayHearsItsMusicAgain) {
    Audio audio;
    audio.playMusic(Music(oggTone(5, 440), "long.ogg"), {.fadeSeconds = 0});
    audio.update(0.02);
    listen(2);  // all that was queued has run out
    EXPECT_LT(listen(0.05).both(), 1e-3);
    audio.update(1);
    EXPECT_GT(listen(0.05).both(), 0.1);
}

TEST_F(Listening, aLostDeviceComesBackAndEverythingGoesOn) {
    Audio audio;
    const Sound sound = audio.createSound(tone(44'100), 44'100);
    const Voice loop = audio.play(sound, {.gain = 0.5f, .loop = true});
    const Voice once = audio.play(audio.createSound(tone(44'100 * 4), 44'100), {.gain = 0.1f});
    audio.playMusic(Music(oggTone(8, 440), "long.ogg"), {.fadeSeconds = 0});
    const auto steps = [&](int count) {
        for (int i = 0; i < count; ++i) {
            audio.update(0.05);
            if (audio.available()) listen(0.05);
        }
    };
    steps(20);
    const double before = listen(0.05).both();
    const double position = audio.musicSeconds();
    there = false;
    EXPECT_TRUE(audio.playing(loop)) << "also before anybody has noticed";
    steps(20);
    EXPECT_FALSE(audio.available());
    EXPECT_TRUE(audio.playing(loop));
    EXPECT_TRUE(audio.playing(once));
    EXPECT_TRUE(audio.musicPlaying());
    audio.setGain(loop, 0.5f);
    there = true;
    const int attempts = opened;
    steps(120);
    EXPECT_TRUE(audio.available());
    EXPECT_LE(opened - attempts, 2) << "not in every frame";
    EXPECT_GT(audio.musicSeconds(), position + 3);
    EXPECT_GT(listen(0.05).both(), 0.5 * before);
    EXPECT_TRUE(audio.playing(loop));
    EXPECT_FALSE(audio.playing(once)) << "its time was over meanwhile";
}

TEST_F(Listening, aChangedDeviceTakesOver) {
    Audio audio;
    const Voice loop =
        audio.play(audio.createSound(tone(44'100), 44'100), {.gain = 0.5f, .loop = true});
    audio.update(0.05);
    listen(0.1);
    EXPECT_FALSE(audio.setDevice("no such device")) << "the system's choice is used";
    EXPECT_EQ(opened, 2);
    audio.update(0.05);
    EXPECT_TRUE(audio.playing(loop));
    EXPECT_GT(listen(0.1).both(), 0.05);
    EXPECT_TRUE(audio.setDevice(""));
    EXPECT_GT(listen(0.1).both(), 0.05);
}

TEST_F(Listening, aDeviceThatIsPluggedInLaterIsUsed) {
    there = false;
    Audio audio;
    const Voice loop = audio.play(audio.createSound(tone(44'100), 44'100), {.loop = true});
    for (int i = 0; i < 10; ++i) audio.update(0.5);
    EXPECT_FALSE(audio.available());
    there = true;
    for (int i = 0; i < 12; ++i) audio.update(0.5);
    EXPECT_TRUE(audio.available());
    EXPECT_TRUE(audio.playing(loop));
    EXPECT_GT(listen(0.1).both(), 0.1);
}

TEST_F(Listening, aPauseHoldsAlsoThroughALoss) {
    Audio audio;
    const Voice voice = audio.play(audio.createSound(tone(44'100), 44'100));
    audio.update(0.05);
    listen(0.1);
    audio.setPaused(true);
    there = false;
    for (int i = 0; i < 10; ++i) audio.update(0.5);
    there = true;
    for (int i = 0; i < 12; ++i) audio.update(0.5);
    EXPECT_TRUE(audio.playing(voice));
    EXPECT_LT(listen(0.1).both(), 1e-4);
    audio.setPaused(false);
    EXPECT_GT(listen(0.1).both(), 0.1);
}

}  // namespace
