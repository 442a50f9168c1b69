// Whatever a scene or a blueprint file holds, it is read or refused with ReadError; what was read
// is written the same way again and again, and a world can be made of it that moves and stays
// sound.
#include <cstdlib>

#include "samples.hpp"
#include "texts.hpp"

namespace {

namespace scene = sulfur::scene;

constexpr std::size_t mostParticles = 2000;  // whose ticks are waited for

void require(bool truth) {
    if (!truth) std::abort();
}

std::size_t particlesOf(const scene::Scene& read) {
    std::size_t sum = 0;
    for (const scene::Placement& body : read.bodies)
        sum += blueprintOf(read, body).particles.size();
    return sum;
}

void live(const scene::Scene& read) {
    sulfur::World world(read.settings);
    const auto instance = instantiate(read, world);
    require(world.validate().empty());
    for (int i = 0; i < 3; ++i) world.step();
    require(world.validate().empty());
    // What was captured can be read again.
    const std::string text = format(capture(world, read, instance));
    scene::parse(text, "captured");
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    return mutateText(data, size, most, seed, scene::testing::fullScene);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const std::string once = format(scene::parseBlueprint(text, "fuzz"));
        require(format(scene::parseBlueprint(once, "again")) == once);
    } catch (const scene::ReadError&) {
    }
    scene::Scene read;
    try {
        read = scene::parse(text, "fuzz");
    } catch (const scene::ReadError&) {
        return 0;
    }
    // From here on an error is a finding.
    const std::string once = format(read);
    require(format(scene::parse(once, "again")) == once);
    if (particlesOf(read) <= mostParticles) live(read);
    return 0;
}
