#pragma once

#include <vorbis/vorbisfile.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace atlax::detail {

struct MusicData {
    std::vector<std::byte> bytes;
    std::string name;
    int channels = 0;
    int rate = 0;
    double seconds = 0;
};

/// Decodes Ogg Vorbis in memory from any place on.
class MusicDecoder {
public:
    /// Throws Error when the bytes are no Ogg Vorbis.
    explicit MusicDecoder(std::shared_ptr<const MusicData> data);
    ~MusicDecoder();
    MusicDecoder(const MusicDecoder&) = delete;
    MusicDecoder& operator=(const MusicDecoder&) = delete;

    int channels() const;
    int rate() const;
    int streams() const;
    double seconds();

    /// Fills `out` with interleaved samples and returns how many; fewer only at the end, or where
    /// nothing more can be decoded. With `loop` the beginning follows the end.
    std::size_t read(std::span<std::int16_t> out, bool loop);
    /// False when that is not possible.
    bool seek(double seconds);

private:
    static std::size_t readBytes(void* to, std::size_t size, std::size_t count, void* self);
    static int seekBytes(void* self, ogg_int64_t offset, int from);
    static long tellBytes(void* self);

    std::shared_ptr<const MusicData> data_;
    std::size_t at_ = 0;
    OggVorbis_File file_{};
};

}  // namespace atlax::detail
