// Whatever a replay or a proof holds, it is read or refused with RecordingError; what was read is
// written the same way again, is no longer than was allowed, and can be played.
#include <cstdlib>

#include "helpers.hpp"
#include "texts.hpp"

namespace {

void require(bool truth) {
    if (!truth) std::abort();
}

std::string sample() {
    quaoar::Recording recording(*quaoar::test::room());
    quaoar::TickInput input;
    for (int n = 0; n < 30; ++n) {
        input.aimX = static_cast<std::int16_t>(1000 * n);
        input.fire = n % 10 < 7;
        input.restart = n == 20;
        recording.append(input);
        recording.append(input);
    }
    return recording.format();
}

void play(const quaoar::Recording& recording) {
    static const auto level = quaoar::test::room();
    quaoar::Session session(level);
    quaoar::Playback playback(std::make_shared<const quaoar::Recording>(recording));
    for (int tick = 0; tick < 100 && !playback.done(); ++tick) session.tick(playback.next());
    require(session.world().validate().empty());
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    static const std::string text = sample();
    return mutateText(data, size, most, seed, text);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    quaoar::Recording recording;
    try {
        recording = quaoar::Recording::parse(
            std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    } catch (const quaoar::RecordingError&) {
        return 0;
    }
    // From here on an error is a finding.
    require(recording.ticks() <= quaoar::Recording::maxTicks);
    const std::string once = recording.format();
    require(quaoar::Recording::parse(once, "again").format() == once);
    play(recording);
    return 0;
}
