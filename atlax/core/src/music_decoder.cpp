#include "music_decoder.hpp"

#include <algorithm>
#include <atlax/error.hpp>
#include <cstdio>
#include <cstring>

namespace atlax::detail {

std::size_t MusicDecoder::readBytes(void* to, std::size_t size, std::size_t count, void* self) {
    auto& decoder = *static_cast<MusicDecoder*>(self);
    const auto& bytes = decoder.data_->bytes;
    if (size == 0) return 0;
    const std::size_t items = std::min(count, (bytes.size() - decoder.at_) / size);
    if (items > 0) std::memcpy(to, bytes.data() + decoder.at_, items * size);
    decoder.at_ += items * size;
    return items;
}

int MusicDecoder::seekBytes(void* self, ogg_int64_t offset, int from) {
    auto& decoder = *static_cast<MusicDecoder*>(self);
    const auto size = static_cast<ogg_int64_t>(decoder.data_->bytes.size());
    const auto now = static_cast<ogg_int64_t>(decoder.at_);
    const ogg_int64_t goal = offset + (from == SEEK_SET ? 0 : from == SEEK_CUR ? now : size);
    if (goal < 0 || goal > size) return -1;
    decoder.at_ = static_cast<std::size_t>(goal);
    return 0;
}

long MusicDecoder::tellBytes(void* self) {
    return static_cast<long>(static_cast<MusicDecoder*>(self)->at_);
}

MusicDecoder::MusicDecoder(std::shared_ptr<const MusicData> data) : data_(std::move(data)) {
    const ov_callbacks callbacks{readBytes, seekBytes, nullptr, tellBytes};
    if (ov_open_callbacks(this, &file_, nullptr, 0, callbacks) != 0)
        throw Error(data_->name + ": is no Ogg Vorbis file");
}

MusicDecoder::~MusicDecoder() {
    ov_clear(&file_);
}

int MusicDecoder::channels() const {
    return file_.vi != nullptr ? file_.vi->channels : 0;
}

int MusicDecoder::rate() const {
    return file_.vi != nullptr ? static_cast<int>(file_.vi->rate) : 0;
}

int MusicDecoder::streams() const {
    return file_.links;
}

double MusicDecoder::seconds() {
    return std::max(ov_time_total(&file_, -1), 0.0);
}

std::size_t MusicDecoder::read(std::span<std::int16_t> out, bool loop) {
    std::size_t done = 0;
    bool rewound = false;
    while (done < out.size()) {
        const auto room = static_cast<int>((out.size() - done) * sizeof(std::int16_t));
        int stream = 0;
        const long got =
            ov_read(&file_, reinterpret_cast<char*>(out.data() + done), room, 0, 2, 1, &stream);
        if (got == OV_HOLE) continue;  // a damaged page: the next one goes on
        if (got > 0) {
            done += static_cast<std::size_t>(got) / sizeof(std::int16_t);
            rewound = false;
            continue;
        }
        // Twice at the end without a sample between them would go on for ever.
        if (got < 0 || !loop || rewound || !seek(0)) break;
        rewound = true;
    }
    return done;
}

bool MusicDecoder::seek(double seconds) {
    return ov_time_seek(&file_, seconds) == 0;
}

}  // namespace atlax::detail
