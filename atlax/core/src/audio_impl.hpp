#pragma once

#include <array>
#include <atlax/audio.hpp>
#include <list>

#include "audio_device.hpp"
#include "music_stream.hpp"

namespace atlax {

namespace detail {

/// Samples, and their copy on the device where they were last played.
struct SoundObject {
    std::vector<std::int16_t> samples;
    int rate = 0;
    std::weak_ptr<AudioDevice> device;
    ALuint buffer = 0;

    SoundObject() = default;
    ~SoundObject();
    SoundObject(const SoundObject&) = delete;
    SoundObject& operator=(const SoundObject&) = delete;

    double seconds() const { return static_cast<double>(samples.size()) / rate; }
    /// The buffer on this device; 0 when it has no room.
    ALuint bufferOn(const std::shared_ptr<AudioDevice>& on);
};

float within(float value, float low, float high, float otherwise);

}  // namespace detail

struct Audio::Implementation {
    struct Slot {
        ALuint source = 0;  ///< 0 without a device, or on one that has fewer sources
        std::uint32_t generation = 0;
        std::uint64_t started = 0;
        std::shared_ptr<detail::SoundObject> sound;  ///< a buffer must outlive its playing
        PlayOptions options;
        VoiceParameters now;    ///< of the options and what is followed
        VoiceParameters heard;  ///< what the device was told
        std::function<VoiceParameters()> followed;
        double position = 0;  ///< in the sound, seconds
        bool paused = false;
        bool ended = false;
    };

    struct DuckingRule {
        Ducking rule;
        float level = 1;
    };

    // In audio_voices.cpp: one voice.
    Slot* choose(int priority);
    Slot* find(Voice voice);
    void startSource(Slot& slot);
    void applyParameters(Slot& slot);
    void release(Slot& slot);
    bool busy(const Slot& slot) const;
    void goOn(Slot& slot, double seconds);
    void follow(Slot& slot, double seconds);

    // In audio_update.cpp: everything together.
    void openDevice();
    void closeDevice();
    void careForDevice(double seconds);
    void makeSources();
    void updateDucking(double seconds);
    void updateMusic(double seconds);
    bool audible(Bus bus) const;
    float volumeOf(Bus bus) const { return volumes[static_cast<std::size_t>(bus)] * ducked(bus); }
    float ducked(Bus bus) const;

    std::shared_ptr<detail::AudioDevice> device;
    std::string deviceName;  ///< wanted; empty for the system's choice
    double untilRetry = 0;
    bool saidMissing = false;

    std::array<Slot, maxVoices> slots;
    std::uint64_t plays = 0;
    std::uint32_t generations = 0;
    Vec2 listener;
    float master = 1;
    std::array<float, busCount> volumes{1, 1, 1, 1};
    std::vector<DuckingRule> rules;
    std::list<detail::MusicStream> music;  ///< the last one plays, those before fade out
};

}  // namespace atlax
