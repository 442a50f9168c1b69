#include <algorithm>
#include <atlax/log.hpp>
#include <cmath>
#include <tuple>

#include "audio_impl.hpp"

namespace atlax {

namespace detail {

float within(float value, float low, float high, float otherwise) {
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

SoundObject::~SoundObject() {
    if (buffer != 0 && !device.expired()) alDeleteBuffers(1, &buffer);
}

ALuint SoundObject::bufferOn(const std::shared_ptr<AudioDevice>& on) {
    if (buffer != 0 && device.lock() == on) return buffer;
    alGetError();
    alGenBuffers(1, &buffer);
    device = on;
    alBufferData(buffer, AL_FORMAT_MONO16, samples.data(),
                 static_cast<ALsizei>(samples.size() * sizeof(samples[0])), rate);
    if (alGetError() != AL_NO_ERROR) {
        log(LogLevel::Warning, "the sound device has no room for a sound");
        if (buffer != 0) alDeleteBuffers(1, &buffer);
        buffer = 0;
    }
    return buffer;
}

}  // namespace detail

using detail::within;

namespace {

/// How loud a placed sound is: 1/distance, pulled down so that it reaches nothing at the end.
float attenuation(const Placement& placement, float distance) {
    const float full = within(placement.full, 0.01f, 1e6f, 1);
    const float silent = std::max(within(placement.silent, 0.02f, 1e7f, 40), full * 1.01f);
    if (distance <= full) return 1;
    if (!(distance < silent)) return 0;
    const float end = full / silent;
    return (full / distance - end) / (1 - end);
}

/// A place on the half circle in front of the listener, at distance 1, so that the loudness stays.
void placeSource(ALuint source, float pan) {
    alSource3f(source, AL_POSITION, pan, 0, -std::sqrt(std::max(1 - pan * pan, 0.0f)));
}

VoiceParameters safe(const VoiceParameters& p) {
    return {within(p.gain, 0, 4, 0), within(p.pitch, 0.05f, 8, 1), within(p.pan, -1, 1, 0)};
}

}  // namespace

bool Audio::Implementation::busy(const Slot& slot) const {
    if (slot.sound == nullptr || slot.ended) return false;
    if (slot.source == 0 || slot.paused) return true;
    ALint state = AL_STOPPED;
    alGetSourcei(slot.source, AL_SOURCE_STATE, &state);
    if (state == AL_PLAYING || state == AL_PAUSED) return true;
    // All sources of a lost device have stopped, but their voices will go on with the next one.
    return device != nullptr && !device->connected();
}

Audio::Implementation::Slot* Audio::Implementation::find(Voice voice) {
    if (voice.generation == 0 || voice.slot >= slots.size()) return nullptr;
    Slot& slot = slots[voice.slot];
    return slot.generation == voice.generation && busy(slot) ? &slot : nullptr;
}

/// A free slot, else the one that is missed least, else none.
Audio::Implementation::Slot* Audio::Implementation::choose(int priority) {
    const auto rank = [](const Slot& s) {
        return std::tuple(s.options.priority, s.options.loop, s.started);
    };
    Slot* least = nullptr;
    for (Slot& slot : slots) {
        if (!busy(slot)) return &slot;
        const bool same = slot.options.priority == priority;
        if (slot.options.priority > priority || (same && slot.options.loop)) continue;
        if (least == nullptr || rank(slot) < rank(*least)) least = &slot;
    }
    return least;
}

void Audio::Implementation::release(Slot& slot) {
    if (slot.source != 0) {
        alSourceStop(slot.source);
        alSourcei(slot.source, AL_BUFFER, 0);
    }
    slot.sound.reset();
    slot.followed = nullptr;
    slot.generation = 0;
}

/// Begins, or goes on, where the voice is.
void Audio::Implementation::startSource(Slot& slot) {
    if (slot.source == 0 || slot.sound == nullptr) return;
    const ALuint buffer = slot.sound->bufferOn(device);
    if (buffer == 0) return;
    alSourcei(slot.source, AL_BUFFER, static_cast<ALint>(buffer));
    alSourcei(slot.source, AL_LOOPING, slot.options.loop ? AL_TRUE : AL_FALSE);
    applyParameters(slot);
    if (slot.position > 0) alSourcef(slot.source, AL_SEC_OFFSET, static_cast<float>(slot.position));
    if (!slot.paused) alSourcePlay(slot.source);
}

void Audio::Implementation::applyParameters(Slot& slot) {
    slot.heard = safe(slot.now);
    if (slot.options.placement) {
        const Placement& placement = *slot.options.placement;
        const Vec2 way = placement.position - listener;
        const float distance = length(way);
        slot.heard.gain *= std::isfinite(distance) ? attenuation(placement, distance) : 0.0f;
        // Beyond the near field the direction decides; within it the sound is in the middle.
        const float side = way.x / std::max(distance, within(placement.full, 0.01f, 1e6f, 1));
        slot.heard.pan = within(slot.heard.pan + side, -1, 1, 0);
    }
    slot.heard.gain *= volumeOf(slot.options.bus);
    if (slot.source == 0) return;
    alSourcef(slot.source, AL_GAIN, slot.heard.gain);
    alSourcef(slot.source, AL_PITCH, slot.heard.pitch);
    placeSource(slot.source, slot.heard.pan);
}

/// Smoothly, because steps of a gain click.
void Audio::Implementation::follow(Slot& slot, double seconds) {
    if (!slot.followed) return;
    try {
        constexpr double timeConstant = 0.02;
        const VoiceParameters goal = safe(slot.followed());
        const auto part = static_cast<float>(1 - std::exp(-seconds / timeConstant));
        slot.now = safe(slot.now);
        slot.now.gain += part * (goal.gain - slot.now.gain);
        slot.now.pitch += part * (goal.pitch - slot.now.pitch);
        slot.now.pan += part * (goal.pan - slot.now.pan);
    } catch (const std::exception& error) {
        log(LogLevel::Error, std::string("a voice follows no longer: ") + error.what());
        slot.followed = nullptr;
    }
}

void Audio::Implementation::goOn(Slot& slot, double seconds) {
    if (slot.sound == nullptr) return;
    follow(slot, seconds);
    if (!slot.paused) {
        if (slot.source != 0) {
            ALfloat position = 0;
            alGetSourcef(slot.source, AL_SEC_OFFSET, &position);
            slot.position = static_cast<double>(position);
        } else {
            slot.position += seconds * static_cast<double>(slot.heard.pitch);
            const double length = slot.sound->seconds();
            if (slot.options.loop)
                slot.position = std::fmod(slot.position, length);
            else if (slot.position >= length)
                slot.ended = true;
        }
    }
    if (busy(slot))
        applyParameters(slot);
    else
        release(slot);
}

}  // namespace atlax
