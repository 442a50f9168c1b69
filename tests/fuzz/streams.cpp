// Whatever a compressed stream or a recording of actions holds, it is read or refused with
// atlax::Error, and never becomes larger than was allowed.
#include <atlax/action_recording.hpp>
#include <atlax/compression.hpp>
#include <atlax/error.hpp>
#include <cstdlib>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

constexpr std::size_t mostBytes = 1u << 20;
constexpr std::uint64_t mostTicks = 10'000;

void playRecording(std::span<const std::byte> bytes) {
    const auto recording = atlax::ActionRecording::decode(bytes, mostTicks);
    atlax::ActionPlayback playback(recording);
    atlax::ActionRecording again;
    while (!playback.done()) again.append(playback.next());
    if (again.ticks() != recording.ticks()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
    try {
        playRecording(bytes);
    } catch (const atlax::Error&) {
    }
    try {
        const auto unpacked = atlax::decompress(bytes, mostBytes);
        if (unpacked.size() > mostBytes) std::abort();
        playRecording(unpacked);
    } catch (const atlax::Error&) {
    }
    return 0;
}

/// Bytes alone would hardly ever become a recording, so some inputs are made as one, compressed or
/// not.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned int seed) {
    std::minstd_rand random(seed);
    if (size > 4 && random() % 8 != 0) return LLVMFuzzerMutate(data, size, maxSize);
    atlax::ActionRecording recording;
    atlax::ActionState state;
    for (unsigned tick = random() % 50; tick > 0; --tick) {
        state.values[random() % atlax::maxActions] = static_cast<std::uint8_t>(random());
        state.pressed = random() % 16;
        state.pointerX = static_cast<std::int16_t>(random() % 4);
        recording.append(state);
    }
    auto made = recording.encode();
    if (random() % 2 == 0) made = atlax::compress(made);
    if (made.size() > maxSize) return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data, made.data(), made.size());
    return made.size();
}
