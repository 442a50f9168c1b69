#include "music_stream.hpp"

#include <algorithm>
#include <cmath>

namespace atlax::detail {

MusicStream::MusicStream(std::shared_ptr<const MusicData> data, const MusicOptions& options)
    : data_(std::move(data)), decoder_(data_), options_(options) {
    const auto frames = static_cast<std::size_t>(bufferSeconds * data_->rate);
    samples_.resize(frames * static_cast<std::size_t>(data_->channels));
    fadeTo(1, options.fadeSeconds);
}

MusicStream::~MusicStream() = default;

void MusicStream::attach() {
    alGetError();
    alGenSources(1, &source_);
    if (alGetError() != AL_NO_ERROR) {
        source_ = 0;  // a device with fewer voices: it goes on in silence
        return;
    }
    alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    alSourcei(source_, AL_SOURCE_RELATIVE, AL_TRUE);
    alSourcef(source_, AL_ROLLOFF_FACTOR, 0);
    drained_ = !decoder_.seek(position());
    for (const ALuint buffer : buffers_)
        if (fill(buffer)) alSourceQueueBuffers(source_, 1, &buffer);
    alSourcef(source_, AL_GAIN, 0);
    alSourcePlay(source_);
}

void MusicStream::detach(bool deviceThere) {
    if (source_ != 0 && deviceThere) {
        alSourceStop(source_);
        alSourcei(source_, AL_BUFFER, 0);
        alDeleteSources(1, &source_);
        alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    }
    source_ = 0;
    position_ = position();
}

void MusicStream::fadeTo(float goal, float seconds) {
    goal_ = goal;
    fadeSpeed_ = seconds > 0.001f ? 1 / seconds : 1000;
    if (seconds <= 0.001f) fade_ = goal;
}

double MusicStream::position() const {
    if (!options_.loop || data_->seconds <= 0) return std::min(position_, data_->seconds);
    return std::fmod(position_, data_->seconds);
}

bool MusicStream::fill(ALuint buffer) {
    if (drained_) return false;
    const std::size_t got = decoder_.read(samples_, options_.loop);
    drained_ = got < samples_.size();
    if (got == 0) return false;
    const ALenum format = data_->channels == 2 ? AL_FORMAT_STEREO16 : AL_FORMAT_MONO16;
    alBufferData(buffer, format, samples_.data(), static_cast<ALsizei>(got * sizeof(samples_[0])),
                 data_->rate);
    const auto index = std::find(buffers_.begin(), buffers_.end(), buffer) - buffers_.begin();
    lengths_[static_cast<std::size_t>(index)] =
        static_cast<double>(got) / data_->channels / data_->rate;
    return true;
}

/// Takes back what was played, and queues what comes next.
void MusicStream::feed() {
    ALint done = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &done);
    for (; done > 0; --done) {
        ALuint buffer = 0;
        alSourceUnqueueBuffers(source_, 1, &buffer);
        const auto found = std::find(buffers_.begin(), buffers_.end(), buffer);
        if (found == buffers_.end()) return;
        position_ += lengths_[static_cast<std::size_t>(found - buffers_.begin())];
        if (fill(buffer)) alSourceQueueBuffers(source_, 1, &buffer);
    }
    ALint queued = 0, state = AL_STOPPED;
    alGetSourcei(source_, AL_BUFFERS_QUEUED, &queued);
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (queued == 0 && drained_) ended_ = true;
    // It had nothing to play because the program was away for too long.
    if (queued > 0 && state != AL_PLAYING) alSourcePlay(source_);
}

void MusicStream::update(double seconds, float volume) {
    const float step = fadeSpeed_ * static_cast<float>(seconds);
    fade_ = fade_ < goal_ ? std::min(fade_ + step, goal_) : std::max(fade_ - step, goal_);
    if (source_ == 0) {
        position_ += seconds;
        if (!options_.loop && position_ >= data_->seconds) ended_ = true;
        return;
    }
    feed();
    // Of equal power, so that a cross-fade of two pieces has no dip in the middle.
    constexpr float quarterTurn = 1.57079633f;
    alSourcef(source_, AL_GAIN, std::sin(fade_ * quarterTurn) * options_.gain * volume);
}

}  // namespace atlax::detail
