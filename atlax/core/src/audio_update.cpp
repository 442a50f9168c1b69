#include <algorithm>
#include <atlax/log.hpp>
#include <cmath>

#include "audio_impl.hpp"

namespace atlax {

namespace {

/// Asking for a device may take some milliseconds.
constexpr double retrySeconds = 5;
constexpr double longestStep = 1;
constexpr float inaudible = 0.001f;

}  // namespace

void Audio::Implementation::makeSources() {
    alGetError();
    for (Slot& slot : slots) {
        alGenSources(1, &slot.source);
        if (alGetError() != AL_NO_ERROR) {
            slot.source = 0;  // a device with fewer voices
            break;
        }
        alSourcei(slot.source, AL_SOURCE_RELATIVE, AL_TRUE);
        alSourcef(slot.source, AL_ROLLOFF_FACTOR, 0);
        alSourcef(slot.source, AL_MAX_GAIN, 4);
    }
}

/// The wanted device, else the system's choice, else none.
void Audio::Implementation::openDevice() {
    closeDevice();
    auto opened =
        std::make_shared<detail::AudioDevice>(deviceName.empty() ? nullptr : deviceName.c_str());
    if (!opened->valid() && !deviceName.empty())
        opened = std::make_shared<detail::AudioDevice>(nullptr);
    untilRetry = retrySeconds;
    if (!opened->valid()) {
        if (!saidMissing) log(LogLevel::Warning, "no sound device: the program goes on in silence");
        saidMissing = true;
        return;
    }
    device = std::move(opened);
    if (saidMissing) log(LogLevel::Info, "sound device: " + device->name());
    saidMissing = false;
    alListenerf(AL_GAIN, master);
    // Music first: it has one source, of which a small device may have few.
    for (auto& stream : music) stream.attach();
    makeSources();
    for (Slot& slot : slots)
        if (!slot.ended) startSource(slot);
}

void Audio::Implementation::closeDevice() {
    if (device == nullptr) return;
    for (auto& stream : music) stream.detach(true);
    for (Slot& slot : slots) {
        if (slot.source == 0) continue;
        if (!busy(slot)) slot.ended = true;
        alSourceStop(slot.source);
        alSourcei(slot.source, AL_BUFFER, 0);
        alDeleteSources(1, &slot.source);
        slot.source = 0;
    }
    device.reset();
}

void Audio::Implementation::careForDevice(double seconds) {
    if (device != nullptr) {
        if (device->connected()) return;
        log(LogLevel::Warning, "the sound device is gone");
        // A source of a lost device has stopped wherever it was: that is not its end.
        for (auto& stream : music) stream.detach(true);
        for (Slot& slot : slots) {
            if (slot.source != 0) alDeleteSources(1, &slot.source);
            slot.source = 0;
        }
        device.reset();
        saidMissing = false;
        openDevice();
        return;
    }
    untilRetry -= seconds;
    if (untilRetry <= 0) openDevice();
}

float Audio::Implementation::ducked(Bus bus) const {
    float level = 1;
    for (const DuckingRule& r : rules)
        if (r.rule.target == bus) level = std::min(level, r.level);
    return level;
}

bool Audio::Implementation::audible(Bus bus) const {
    if (bus == Bus::Music)
        for (const auto& stream : music)
            if (!stream.over()) return true;
    return std::any_of(slots.begin(), slots.end(), [&](const Slot& slot) {
        return slot.options.bus == bus && !slot.paused && slot.heard.gain > inaudible && busy(slot);
    });
}

void Audio::Implementation::updateDucking(double seconds) {
    for (DuckingRule& r : rules) {
        const float goal = audible(r.rule.trigger) ? r.rule.gain : 1.0f;
        const float time = goal < r.level ? r.rule.attackSeconds : r.rule.releaseSeconds;
        const float step =
            time > inaudible ? static_cast<float>(seconds) * (1 - r.rule.gain) / time : 1.0f;
        r.level = goal < r.level ? std::max(r.level - step, goal) : std::min(r.level + step, goal);
    }
}

void Audio::Implementation::updateMusic(double seconds) {
    for (auto it = music.begin(); it != music.end();) {
        it->update(seconds, volumeOf(Bus::Music));
        if (!it->over()) {
            ++it;
            continue;
        }
        it->detach(device != nullptr);
        it = music.erase(it);
    }
}

void Audio::update(double seconds) {
    auto& self = *implementation_;
    const double step = std::isfinite(seconds) ? std::clamp(seconds, 0.0, longestStep) : 0.0;
    // Where a voice is must be known before its device may be found gone.
    for (auto& slot : self.slots) {
        const bool lost = self.device != nullptr && !self.device->connected();
        if (lost) break;
        self.goOn(slot, step);
    }
    self.careForDevice(step);
    self.updateDucking(step);
    self.updateMusic(step);
}

}  // namespace atlax
