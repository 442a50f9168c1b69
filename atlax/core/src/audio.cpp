#include <al.h>
#include <alc.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <atlax/audio.hpp>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace atlax {

namespace {

constexpr std::size_t voiceCount = 32;
constexpr int lowestRate = 8'000;
constexpr int highestRate = 192'000;

void requireSound(std::size_t samples, int rate) {
    if (samples == 0) throw Error("a sound without samples cannot be made");
    if (rate < lowestRate || rate > highestRate)
        throw Error("a sample rate of " + std::to_string(rate) + " Hz is outside of " +
                    std::to_string(lowestRate) + " to " + std::to_string(highestRate));
}

float within(float value, float low, float high, float otherwise) {
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

float safeGain(float gain) {
    return within(gain, 0, 4, 0);
}
float safePitch(float pitch) {
    return within(pitch, 0.05f, 8, 1);
}

void ignoreAlsaMessage(const char*, int, const char*, int, const char*, ...) {}

/// A missing device is reported by the log in one line; the libraries below would write ten more to
/// standard error. ALSA is asked through the loader, since only OpenAL needs it.
void quietLibraries() {
    ::setenv("ALSOFT_LOGLEVEL", "0", 0);
    void* alsa = ::dlopen("libasound.so.2", RTLD_LAZY);
    if (alsa == nullptr) return;
    using Handler = void (*)(const char*, int, const char*, int, const char*, ...);
    using SetHandler = int (*)(Handler);
    auto* set = reinterpret_cast<SetHandler>(::dlsym(alsa, "snd_lib_error_set_handler"));  // NOLINT
    if (set != nullptr) set(ignoreAlsaMessage);
}

/// A place on the half circle in front of the listener, at distance 1, so that the loudness stays.
void placeSource(ALuint source, float pan) {
    const float x = within(pan, -1, 1, 0);
    alSource3f(source, AL_POSITION, x, 0, -std::sqrt(std::max(1 - x * x, 0.0f)));
}

}  // namespace

namespace detail {

/// Lives on after its Audio, then without a buffer.
struct AudioDevice {
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;

    AudioDevice() {
        quietLibraries();
        device = alcOpenDevice(nullptr);
        if (device == nullptr) return;
        context = alcCreateContext(device, nullptr);
        if (context != nullptr && alcMakeContextCurrent(context) == ALC_TRUE) return;
        close();
    }
    ~AudioDevice() { close(); }
    AudioDevice(const AudioDevice&) = delete;
    AudioDevice& operator=(const AudioDevice&) = delete;

    void close() {
        if (context != nullptr) {
            alcMakeContextCurrent(nullptr);
            alcDestroyContext(context);
        }
        if (device != nullptr) alcCloseDevice(device);
        context = nullptr;
        device = nullptr;
    }
};

struct SoundObject {
    std::weak_ptr<AudioDevice> device;
    ALuint buffer = 0;
    double seconds = 0;

    SoundObject() = default;
    ~SoundObject() {
        if (buffer != 0 && !device.expired()) alDeleteBuffers(1, &buffer);
    }
    SoundObject(const SoundObject&) = delete;
    SoundObject& operator=(const SoundObject&) = delete;
};

}  // namespace detail

struct Audio::Implementation {
    struct Slot {
        ALuint source = 0;
        std::uint32_t generation = 0;
        std::uint64_t started = 0;
        bool loop = false;
        std::shared_ptr<detail::SoundObject> sound;  ///< a buffer must outlive its playing
    };

    std::shared_ptr<detail::AudioDevice> device = std::make_shared<detail::AudioDevice>();
    std::array<Slot, voiceCount> slots;
    std::size_t usable = 0;
    std::uint64_t plays = 0;
    std::uint32_t generations = 0;
    float master = 1;

    bool available() const { return device->context != nullptr; }

    void makeSources() {
        alGetError();
        for (Slot& slot : slots) {
            alGenSources(1, &slot.source);
            if (alGetError() != AL_NO_ERROR) break;  // a device with fewer voices
            ++usable;
            alSourcei(slot.source, AL_SOURCE_RELATIVE, AL_TRUE);
            alSourcef(slot.source, AL_ROLLOFF_FACTOR, 0);
            alSourcef(slot.source, AL_MAX_GAIN, 4);
        }
    }

    bool busy(const Slot& slot) const {
        if (slot.sound == nullptr) return false;
        ALint state = AL_STOPPED;
        alGetSourcei(slot.source, AL_SOURCE_STATE, &state);
        return state == AL_PLAYING || state == AL_PAUSED;
    }

    void release(Slot& slot) {
        alSourceStop(slot.source);
        alSourcei(slot.source, AL_BUFFER, 0);
        slot.sound.reset();
        slot.generation = 0;
    }

    /// A free slot, else the oldest that does not loop, else none.
    Slot* choose() {
        Slot* oldest = nullptr;
        for (std::size_t i = 0; i < usable; ++i) {
            if (!busy(slots[i])) return &slots[i];
            if (!slots[i].loop && (oldest == nullptr || slots[i].started < oldest->started))
                oldest = &slots[i];
        }
        return oldest;
    }

    Slot* find(Voice voice) {
        if (voice.generation == 0 || voice.slot >= usable) return nullptr;
        Slot& slot = slots[voice.slot];
        return slot.generation == voice.generation && busy(slot) ? &slot : nullptr;
    }
};

double Sound::seconds() const {
    return object_ ? object_->seconds : 0;
}

Audio::Audio() : implementation_(std::make_unique<Implementation>()) {
    if (implementation_->available())
        implementation_->makeSources();
    else
        log(LogLevel::Warning, "no sound device: the program goes on in silence");
}

Audio::~Audio() {
    auto& self = *implementation_;
    for (std::size_t i = 0; i < self.usable; ++i) {
        self.release(self.slots[i]);
        alDeleteSources(1, &self.slots[i].source);
    }
}

bool Audio::available() const {
    return implementation_->available();
}

Sound Audio::createSound(std::span<const float> samples, int sampleRate) {
    std::vector<std::int16_t> converted(samples.size());
    std::transform(samples.begin(), samples.end(), converted.begin(), [](float v) {
        return static_cast<std::int16_t>(std::lround(within(v, -1, 1, 0) * 32767.0f));
    });
    return createSound(std::span<const std::int16_t>(converted), sampleRate);
}

Sound Audio::createSound(std::span<const std::int16_t> samples, int sampleRate) {
    requireSound(samples.size(), sampleRate);
    auto object = std::make_shared<detail::SoundObject>();
    object->seconds = static_cast<double>(samples.size()) / sampleRate;
    if (implementation_->available()) {
        alGetError();
        alGenBuffers(1, &object->buffer);
        object->device = implementation_->device;
        alBufferData(object->buffer, AL_FORMAT_MONO16, samples.data(),
                     static_cast<ALsizei>(samples.size_bytes()), sampleRate);
        if (alGetError() != AL_NO_ERROR) log(LogLevel::Warning, "a sound could not be stored");
    }
    return Sound(std::move(object));
}

Voice Audio::play(const Sound& sound, const PlayOptions& options) {
    auto& self = *implementation_;
    if (!sound.valid() || sound.object_->buffer == 0) return {};
    if (sound.object_->device.lock() != self.device) return {};
    auto* slot = self.choose();
    if (slot == nullptr) return {};
    self.release(*slot);
    slot->sound = sound.object_;
    slot->loop = options.loop;
    slot->started = ++self.plays;
    if (++self.generations == 0) ++self.generations;
    slot->generation = self.generations;
    alSourcei(slot->source, AL_BUFFER, static_cast<ALint>(sound.object_->buffer));
    alSourcei(slot->source, AL_LOOPING, options.loop ? AL_TRUE : AL_FALSE);
    alSourcef(slot->source, AL_GAIN, safeGain(options.gain));
    alSourcef(slot->source, AL_PITCH, safePitch(options.pitch));
    placeSource(slot->source, options.pan);
    alSourcePlay(slot->source);
    return {static_cast<std::uint32_t>(slot - self.slots.data()), slot->generation};
}

void Audio::stop(Voice voice) {
    if (auto* slot = implementation_->find(voice)) implementation_->release(*slot);
}

void Audio::stopAll() {
    for (std::size_t i = 0; i < implementation_->usable; ++i)
        implementation_->release(implementation_->slots[i]);
}

bool Audio::playing(Voice voice) const {
    return implementation_->find(voice) != nullptr;
}

void Audio::setGain(Voice voice, float gain) {
    if (auto* slot = implementation_->find(voice)) alSourcef(slot->source, AL_GAIN, safeGain(gain));
}

void Audio::setPitch(Voice voice, float pitch) {
    if (auto* slot = implementation_->find(voice))
        alSourcef(slot->source, AL_PITCH, safePitch(pitch));
}

void Audio::setPan(Voice voice, float pan) {
    if (auto* slot = implementation_->find(voice)) placeSource(slot->source, pan);
}

void Audio::setMasterVolume(float volume) {
    implementation_->master = within(volume, 0, 1, 0);
    if (available()) alListenerf(AL_GAIN, implementation_->master);
}

float Audio::masterVolume() const {
    return implementation_->master;
}

void Audio::setPaused(bool paused) {
    auto& self = *implementation_;
    for (std::size_t i = 0; i < self.usable; ++i) {
        auto& slot = self.slots[i];
        if (!self.busy(slot)) continue;
        ALint state = AL_STOPPED;
        alGetSourcei(slot.source, AL_SOURCE_STATE, &state);
        if (paused && state == AL_PLAYING) alSourcePause(slot.source);
        if (!paused && state == AL_PAUSED) alSourcePlay(slot.source);
    }
}

}  // namespace atlax
