#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace atlax {

namespace detail {
struct SoundObject;
}

/// Samples in the sound system, made by Audio::createSound. A cheap handle that may outlive the
/// Audio.
class Sound {
public:
    Sound() = default;
    bool valid() const { return object_ != nullptr; }
    /// Length at pitch 1, seconds.
    double seconds() const;

private:
    friend class Audio;
    explicit Sound(std::shared_ptr<detail::SoundObject> object) : object_(std::move(object)) {}
    std::shared_ptr<detail::SoundObject> object_;
};

struct PlayOptions {
    float gain = 1;   ///< 0..4, times the master volume
    float pitch = 1;  ///< 0.05..8: playing speed
    float pan = 0;    ///< -1 left, 1 right
    bool loop = false;
};

/// One sound being played. Stale voices (finished, stopped, taken over) are harmless: every call
/// with one does nothing.
struct Voice {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0;  ///< 0 is no voice
    bool operator==(const Voice&) const = default;
};

/// The sound device (OpenAL Soft). Where there is none, everything works and nothing is heard: that
/// is said in the log once and is never an error. One object and one thread per program.
class Audio {
public:
    Audio();
    ~Audio();
    Audio(const Audio&) = delete;
    Audio& operator=(const Audio&) = delete;

    /// Whether there is a device.
    bool available() const;

    /// Mono samples from -1 to 1 (others are clipped, those that are not finite are silent), at
    /// 8,000 to 192,000 per second. The samples are copied. Throws Error for an empty sound or a
    /// rate outside of that.
    Sound createSound(std::span<const float> samples, int sampleRate);
    Sound createSound(std::span<const std::int16_t> samples, int sampleRate);

    /// Starts a sound. When all 32 voices are busy, the oldest that does not loop is taken over.
    Voice play(const Sound& sound, const PlayOptions& options = {});
    void stop(Voice voice);
    void stopAll();
    bool playing(Voice voice) const;
    void setGain(Voice voice, float gain);
    void setPitch(Voice voice, float pitch);
    void setPan(Voice voice, float pan);

    /// 0..1, for everything.
    void setMasterVolume(float volume);
    float masterVolume() const;

    /// Holds everything that is playing now, and lets it go on. What is started meanwhile (a menu's
    /// click) is heard.
    void setPaused(bool paused);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace atlax
