// Whatever a level file holds, it is read or refused with ReadError; what was read can be played.
#include <cstdlib>

#include "helpers.hpp"
#include "texts.hpp"

namespace {

constexpr std::size_t mostParticles = 2000;  // whose ticks are waited for

/// A hand that shoots, reels, swings and begins again.
quaoar::TickInput inputAt(int tick) {
    quaoar::TickInput input;
    input.aimX = static_cast<std::int16_t>(32767 - 900 * tick);
    input.aimY = 30000;
    input.fire = tick % 50 < 40;
    input.reelIn = tick % 3 == 0;
    input.push = static_cast<std::int8_t>(tick - 64);
    input.restart = tick == 60;
    return input;
}

void play(const std::shared_ptr<const quaoar::Level>& level) {
    quaoar::Session session(level);
    std::size_t particles = 0;
    for (const sulfur::BodyId body : session.world().bodies())
        particles += session.world().particles(body).size();
    if (particles > mostParticles) return;
    for (int tick = 0; tick < 70; ++tick) session.tick(inputAt(tick));
    if (!session.world().validate().empty()) std::abort();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    return mutateText(data, size, most, seed, quaoar::test::everythingText);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::shared_ptr<const quaoar::Level> level;
    try {
        level = quaoar::test::room(std::string(reinterpret_cast<const char*>(data), size));
    } catch (const sulfur::scene::ReadError&) {
        return 0;
    }
    // From here on an error is a finding.
    play(level);
    return 0;
}
