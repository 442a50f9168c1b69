// Whatever a shared replay holds, it is read or refused with RecordingError; what was read is no
// longer than was allowed and is shared the same way again. The first byte chooses whether the rest
// is the text or what is compressed in it, which no mutation of the text would reach.
#include <cstdlib>
#include <string>

#include "share.hpp"

namespace {

void require(bool truth) {
    if (!truth) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::span rest(reinterpret_cast<const std::byte*>(data) + 1, size - 1);
    quaoar::Recording recording;
    try {
        recording = data[0] % 8 == 0 ? quaoar::parseShareText(std::string_view(
                                           reinterpret_cast<const char*>(rest.data()), rest.size()))
                                     : quaoar::parseShareBytes(rest);
    } catch (const quaoar::RecordingError&) {
        return 0;
    }
    // From here on an error is a finding.
    require(recording.ticks() <= quaoar::Recording::maxTicks);
    const std::string once = quaoar::shareText(recording);
    require(quaoar::parseShareText(once).format() == recording.format());
    return 0;
}
