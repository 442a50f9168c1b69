#pragma once

#include <al.h>

#include <array>
#include <atlax/audio.hpp>

#include "music_decoder.hpp"

namespace atlax::detail {

/// One piece of music on its way to the device, or in silence where there is none.
class MusicStream {
public:
    MusicStream(std::shared_ptr<const MusicData> data, const MusicOptions& options);
    ~MusicStream();
    MusicStream(const MusicStream&) = delete;
    MusicStream& operator=(const MusicStream&) = delete;

    /// Makes source and buffers on the current device, and goes on where the music is.
    void attach();
    /// Gives them up; with a device that is gone they are gone already.
    void detach(bool deviceThere);

    void fadeTo(float goal, float seconds);
    /// By so many seconds, at the given volume of the bus.
    void update(double seconds, float volume);

    /// It came to its end or has faded out.
    bool over() const { return ended_ || (goal_ <= 0 && fade_ <= 0); }
    bool leaving() const { return goal_ <= 0; }
    double position() const;
    const MusicData* data() const { return data_.get(); }

private:
    static constexpr std::size_t bufferCount = 4;
    static constexpr double bufferSeconds = 0.2;

    bool fill(ALuint buffer);
    void feed();

    std::shared_ptr<const MusicData> data_;
    MusicDecoder decoder_;
    MusicOptions options_;
    std::vector<std::int16_t> samples_;
    ALuint source_ = 0;
    std::array<ALuint, bufferCount> buffers_{};
    std::array<double, bufferCount> lengths_{};  ///< seconds that each buffer holds
    double position_ = 0;                        ///< of what the device has finished, seconds
    bool drained_ = false;                       ///< nothing is left to decode
    bool ended_ = false;
    float fade_ = 0;
    float goal_ = 1;
    float fadeSpeed_ = 1;  ///< per second
};

}  // namespace atlax::detail
