#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <atlax/vec.hpp>

namespace atlax {

namespace detail {
struct SoundObject;
struct MusicData;
}  // namespace detail

/// A short sound, made by Audio::createSound: a cheap handle to samples that it owns together with
/// its copies. It may outlive the Audio and be played by another one. Main thread.
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

/// A piece of music that is decoded while it plays: a cheap handle to the bytes of an Ogg Vorbis
/// file, which it owns together with its copies.
class Music {
public:
    Music() = default;
    /// Throws Error with `name` and the reason unless the bytes are one Ogg Vorbis stream of one or
    /// two channels at 8,000 to 192,000 Hz. Any thread.
    Music(std::vector<std::byte> oggFile, const std::string& name);
    bool valid() const { return data_ != nullptr; }
    /// Length, seconds.
    double seconds() const;

private:
    friend class Audio;
    std::shared_ptr<const detail::MusicData> data_;
};

/// Groups of sounds with a volume each.
enum class Bus : std::uint8_t { Effects = 0, Music, Interface, Ambience };
inline constexpr std::size_t busCount = 4;

/// Where a sound comes from, in the units of the world (metres). Its loudness falls from the
/// listener's `full` to `silent` distance, by 1/distance at first and to nothing at the end; to the
/// side it is heard on that side.
struct Placement {
    Vec2 position{};
    float full = 3;     ///< up to here nothing is lost; more than 0
    float silent = 40;  ///< from here on nothing is heard; more than `full`
};

struct PlayOptions {
    float gain = 1;   ///< 0..4, times the volumes of bus and master
    float pitch = 1;  ///< 0.05..8: playing speed
    float pan = 0;    ///< -1 left, 1 right
    bool loop = false;
    Bus bus = Bus::Effects;
    int priority = 0;  ///< a voice is taken over only by one of its own priority or more
    std::optional<Placement> placement = {};  ///< else heard everywhere alike
};

/// One sound being played. Stale voices (finished, stopped, taken over) are harmless: every call
/// with one does nothing.
struct Voice {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0;  ///< 0 is no voice
    bool operator==(const Voice&) const = default;
};

/// What can be changed while a voice plays; ranges as in PlayOptions.
struct VoiceParameters {
    float gain = 1;
    float pitch = 1;
    float pan = 0;
};

/// A straight line between two points, level outside of them: from a quantity of the simulation to
/// a parameter of a voice, as from tension in newtons to pitch.
struct Curve {
    float fromLow = 0, fromHigh = 1;  ///< of the quantity; different from each other
    float toLow = 0, toHigh = 1;      ///< of the parameter
    float operator()(float quantity) const;
};

struct MusicOptions {
    float gain = 1;         ///< 0..1
    float fadeSeconds = 1;  ///< until it is fully there, and what played before is gone; 0..60
    bool loop = true;
};

/// Lowers one bus while something is heard on another: music under speech.
struct Ducking {
    Bus trigger = Bus::Interface;
    Bus target = Bus::Music;
    float gain = 0.3f;            ///< of the target meanwhile, 0..1
    float attackSeconds = 0.1f;   ///< to get there, 0..10
    float releaseSeconds = 0.5f;  ///< and back, 0..10
};

/// The sound device (OpenAL Soft), voices, buses and music.
///
/// Where there is no device, everything works alike and nothing is heard: voices go on in silence
/// and end when they would have. A device that is lost (unplugged, its server gone) is noticed by
/// update(), and one that can be had is opened, at first at once and then every few seconds; what
/// was playing goes on there. All that is said in the log and never an error.
///
/// Owns the device and all voices. One object at a time, in one thread. Numbers out of range are
/// clamped, those that are not finite count as 0 for a gain and as the default otherwise.
class Audio {
public:
    static constexpr std::size_t maxVoices = 64;

    Audio();
    ~Audio();
    Audio(const Audio&) = delete;
    Audio& operator=(const Audio&) = delete;

    /// Lets fades, followed quantities, ducking, music and the care for the device go on by so many
    /// seconds of real time (0..1; more counts as 1). The backends call it once per frame; music
    /// stutters when it is called less than twice a second.
    void update(double seconds);

    /// Whether there is a device at the moment.
    bool available() const;
    /// Names of the devices that could be used; empty where the system tells none.
    std::vector<std::string> devices() const;
    /// Goes over to the device of this name, or to the system's choice when it is empty; what is
    /// playing goes on there. Where it cannot be opened, the system's choice is used, and false
    /// returned.
    bool setDevice(const std::string& name);

    /// Mono samples from -1 to 1 (others are clipped, those that are not finite are silent), at
    /// 8,000 to 192,000 per second. The samples are copied. Throws Error for an empty sound or a
    /// rate outside of that.
    Sound createSound(std::span<const float> samples, int sampleRate);
    Sound createSound(std::span<const std::int16_t> samples, int sampleRate);

    /// Starts a sound. When all voices are busy, one of the lowest priority is taken over, first of
    /// those that do not loop, the oldest of them; none when all have a higher priority, or the
    /// same and loop.
    Voice play(const Sound& sound, const PlayOptions& options = {});
    void stop(Voice voice);
    void stopAll();
    bool playing(Voice voice) const;
    void setGain(Voice voice, float gain);
    void setPitch(Voice voice, float pitch);
    void setPan(Voice voice, float pan);
    /// Moves a voice that was started with a placement.
    void setPosition(Voice voice, Vec2 position);
    /// Asks `source` for the voice's parameters in each update(), and goes there smoothly, within
    /// about 50 ms; a null function ends it. The function lives until the voice ends; when it
    /// throws, that is logged and the voice follows no longer.
    void follow(Voice voice, std::function<VoiceParameters()> source);
    /// What a voice sounds like now: gain after distance, bus and ducking but before the master
    /// volume. Nothing for a stale voice.
    std::optional<VoiceParameters> heard(Voice voice) const;

    /// From where placed sounds are heard.
    void setListener(Vec2 position);

    /// Starts music, fading it in, and fades out what played before. A piece that is already
    /// playing goes on instead.
    void playMusic(const Music& music, const MusicOptions& options = {});
    void stopMusic(float fadeSeconds = 1);
    /// Whether music is playing that is not fading out.
    bool musicPlaying() const;
    /// Position in that music, seconds; 0 without.
    double musicSeconds() const;

    /// 0..1, for everything.
    void setMasterVolume(float volume);
    float masterVolume() const;
    /// 0..1, for a bus.
    void setBusVolume(Bus bus, float volume);
    float busVolume(Bus bus) const;
    /// Adds a rule; where several lower a bus, the lowest counts.
    void addDucking(const Ducking& rule);

    /// Holds every voice that is playing now, and lets it go on. What is started meanwhile (a
    /// menu's click) is heard, and music plays on.
    void setPaused(bool paused);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace atlax
