#include <algorithm>
#include <atlax/audio.hpp>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <cmath>
#include <string>

#include "audio_impl.hpp"

namespace atlax {

using detail::within;

namespace {

constexpr int lowestRate = 8'000;
constexpr int highestRate = 192'000;
/// Pieces that fade out at the same time; more are cut.
constexpr std::size_t mostMusic = 3;

void requireSound(std::size_t samples, int rate) {
    if (samples == 0) throw Error("a sound without samples cannot be made");
    if (rate < lowestRate || rate > highestRate)
        throw Error("a sample rate of " + std::to_string(rate) + " Hz is outside of " +
                    std::to_string(lowestRate) + " to " + std::to_string(highestRate));
}

std::size_t index(Bus bus) {
    return std::min(static_cast<std::size_t>(bus), busCount - 1);
}

}  // namespace

float Curve::operator()(float quantity) const {
    const float width = fromHigh - fromLow;
    if (!std::isfinite(quantity) || width == 0) return toLow;
    return toLow + (toHigh - toLow) * std::clamp((quantity - fromLow) / width, 0.0f, 1.0f);
}

double Sound::seconds() const {
    return object_ ? object_->seconds() : 0;
}

Music::Music(std::vector<std::byte> oggFile, const std::string& name) {
    auto data = std::make_shared<detail::MusicData>();
    data->bytes = std::move(oggFile);
    data->name = name;
    detail::MusicDecoder decoder(data);
    const int channels = decoder.channels();
    if (decoder.streams() != 1)
        throw Error(name + ": this music is of several streams in one file");
    if (channels < 1 || channels > 2)
        throw Error(name + ": this music has " + std::to_string(channels) +
                    " channels, where one or two are allowed");
    if (decoder.rate() < lowestRate || decoder.rate() > highestRate)
        throw Error(name + ": the sample rate of this music, " + std::to_string(decoder.rate()) +
                    " Hz, is outside of " + std::to_string(lowestRate) + " to " +
                    std::to_string(highestRate));
    data->channels = channels;
    data->rate = decoder.rate();
    data->seconds = decoder.seconds();
    data_ = std::move(data);
}

double Music::seconds() const {
    return data_ ? data_->seconds : 0;
}

Audio::Audio() : implementation_(std::make_unique<Implementation>()) {
    implementation_->openDevice();
}

Audio::~Audio() {
    implementation_->closeDevice();
}

bool Audio::available() const {
    return implementation_->device != nullptr;
}

std::vector<std::string> Audio::devices() const {
    return detail::audioDeviceNames();
}

bool Audio::setDevice(const std::string& name) {
    auto& self = *implementation_;
    for (auto& slot : self.slots) self.goOn(slot, 0);
    self.deviceName = name;
    self.openDevice();
    if (self.device == nullptr) return false;
    const auto names = devices();
    return name.empty() || std::find(names.begin(), names.end(), name) != names.end();
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
    object->samples.assign(samples.begin(), samples.end());
    object->rate = sampleRate;
    // Now, so that the first time it is played does not take longer than others.
    if (implementation_->device != nullptr) object->bufferOn(implementation_->device);
    return Sound(std::move(object));
}

Voice Audio::play(const Sound& sound, const PlayOptions& options) {
    auto& self = *implementation_;
    if (!sound.valid()) return {};
    auto* slot = self.choose(options.priority);
    if (slot == nullptr) return {};
    self.release(*slot);
    slot->sound = sound.object_;
    slot->options = options;
    slot->options.bus = static_cast<Bus>(index(options.bus));
    slot->now = {options.gain, options.pitch, options.pan};
    slot->started = ++self.plays;
    slot->position = 0;
    slot->paused = false;
    slot->ended = false;
    if (++self.generations == 0) ++self.generations;
    slot->generation = self.generations;
    self.applyParameters(*slot);
    self.startSource(*slot);
    return {static_cast<std::uint32_t>(slot - self.slots.data()), slot->generation};
}

void Audio::stop(Voice voice) {
    if (auto* slot = implementation_->find(voice)) implementation_->release(*slot);
}

void Audio::stopAll() {
    for (auto& slot : implementation_->slots) implementation_->release(slot);
}

bool Audio::playing(Voice voice) const {
    return implementation_->find(voice) != nullptr;
}

void Audio::setGain(Voice voice, float gain) {
    auto* slot = implementation_->find(voice);
    if (slot == nullptr) return;
    slot->now.gain = gain;
    implementation_->applyParameters(*slot);
}

void Audio::setPitch(Voice voice, float pitch) {
    auto* slot = implementation_->find(voice);
    if (slot == nullptr) return;
    slot->now.pitch = pitch;
    implementation_->applyParameters(*slot);
}

void Audio::setPan(Voice voice, float pan) {
    auto* slot = implementation_->find(voice);
    if (slot == nullptr) return;
    slot->now.pan = pan;
    implementation_->applyParameters(*slot);
}

void Audio::setPosition(Voice voice, Vec2 position) {
    auto* slot = implementation_->find(voice);
    if (slot == nullptr || !slot->options.placement) return;
    slot->options.placement->position = position;
    implementation_->applyParameters(*slot);
}

void Audio::follow(Voice voice, std::function<VoiceParameters()> source) {
    if (auto* slot = implementation_->find(voice)) slot->followed = std::move(source);
}

std::optional<VoiceParameters> Audio::heard(Voice voice) const {
    const auto* slot = implementation_->find(voice);
    if (slot == nullptr) return {};
    return slot->heard;
}

void Audio::setListener(Vec2 position) {
    implementation_->listener = position;
}

void Audio::playMusic(const Music& music, const MusicOptions& options) {
    auto& self = *implementation_;
    if (!music.valid()) return;
    const float fade = within(options.fadeSeconds, 0, 60, 1);
    if (!self.music.empty() && !self.music.back().leaving() &&
        self.music.back().data() == music.data_.get())
        return;
    stopMusic(fade);
    while (self.music.size() >= mostMusic) {
        self.music.front().detach(self.device != nullptr);
        self.music.pop_front();
    }
    self.music.emplace_back(music.data_,
                            MusicOptions{within(options.gain, 0, 1, 0), fade, options.loop});
    if (self.device != nullptr) self.music.back().attach();
}

void Audio::stopMusic(float fadeSeconds) {
    for (auto& stream : implementation_->music) stream.fadeTo(0, within(fadeSeconds, 0, 60, 1));
}

bool Audio::musicPlaying() const {
    const auto& music = implementation_->music;
    return !music.empty() && !music.back().leaving() && !music.back().over();
}

double Audio::musicSeconds() const {
    return musicPlaying() ? implementation_->music.back().position() : 0;
}

void Audio::setMasterVolume(float volume) {
    implementation_->master = within(volume, 0, 1, 0);
    if (available()) alListenerf(AL_GAIN, implementation_->master);
}

float Audio::masterVolume() const {
    return implementation_->master;
}

void Audio::setBusVolume(Bus bus, float volume) {
    auto& self = *implementation_;
    self.volumes[index(bus)] = within(volume, 0, 1, 0);
    for (auto& slot : self.slots)
        if (slot.options.bus == bus && self.busy(slot)) self.applyParameters(slot);
}

float Audio::busVolume(Bus bus) const {
    return implementation_->volumes[index(bus)];
}

void Audio::addDucking(const Ducking& rule) {
    Ducking safe = rule;
    safe.gain = within(rule.gain, 0, 1, 1);
    safe.attackSeconds = within(rule.attackSeconds, 0, 10, 0.1f);
    safe.releaseSeconds = within(rule.releaseSeconds, 0, 10, 0.5f);
    implementation_->rules.push_back({safe, 1});
}

void Audio::setPaused(bool paused) {
    auto& self = *implementation_;
    for (auto& slot : self.slots) {
        if (slot.paused == paused || !self.busy(slot)) continue;
        slot.paused = paused;
        if (slot.source == 0) continue;
        paused ? alSourcePause(slot.source) : alSourcePlay(slot.source);
    }
}

}  // namespace atlax
