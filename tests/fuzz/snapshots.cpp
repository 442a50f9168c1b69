// Whatever is handed to World::restore, it becomes the world that the bytes say or is refused with
// Error{badSnapshot} and changes nothing. The bytes are edits of a snapshot of a small world.
//
// What was edited and has its old seal is refused. A forged seal only promises that reading ends
// well: rows, pairs and lists name each other by numbers that nobody checks, so that such a world
// makes no ticks here.
#include <cstdlib>
#include <cstring>
#include <sulfur/sulfur.hpp>

#include "calls/numbers.hpp"
#include "core/archive.hpp"
#include "decisions.hpp"

namespace {

using namespace sulfur;

void require(bool truth) {
    if (!truth) std::abort();
}

/// Some of everything, in motion or at rest.
Snapshot sample(int ticks) {
    World world({.tellPersisting = true});
    world.add(shapes::floor({-9, 0}, {9, 0}));
    const Body crate = world.add(shapes::box({.strength = 100}), {.position = {0, 0.6}});
    const Body ball = world.add(shapes::ball(), {.position = {0.2, 1.5}});
    world.add(shapes::jelly({.columns = 3, .rows = 3}), {.position = {2, 0.7}});
    const Body rope =
        world.add(shapes::rope({.from = {-3, 3}, .to = {-1, 3}, .links = 5, .pinFirst = true}));
    world.attach(rope.back(), crate, {0, Real(0.4)});
    world.connect(ball.front(), crate.front(), {.stiffness = 100});
    Blueprint zone = shapes::box();
    zone.kind = BodyKind::fixed;
    zone.sensor = true;
    zone.skin = Skin{.texture = "zone", .uv = std::vector<Vec2>(zone.particles.size(), Vec2{0, 0})};
    world.setCollision(world.add(zone, {.position = {0, 1}}), ball, false);
    world.add(WindField{.zone = CircleZone{{0, 1}, 2}, .velocity = {1, 0}});
    if (ticks < 100) world.grab(ball.front(), {0, 3});
    for (int i = 0; i < ticks; ++i) world.step();
    return world.snapshot();
}

void edit(Snapshot& bytes, const Snapshot& other, test::Numbers& numbers) {
    const std::size_t at = numbers.below(bytes.size());
    const auto part = [&](std::size_t most) {
        return std::min(bytes.size() - at, numbers.below(most) + 1);
    };
    switch (numbers.below(6)) {
        case 0:
            bytes[at] = static_cast<std::byte>(numbers.below(256));
            return;
        case 1: {  // an index or a count
            constexpr std::uint32_t odd[] = {0, 1, 2, 0xffffffff, 0x7fffffff, 1000, 0x7fc00000};
            const std::uint32_t word = odd[numbers.below(std::size(odd))];
            const std::size_t aligned = at / 4 * 4;
            std::memcpy(bytes.data() + aligned, &word,
                        std::min(bytes.size() - aligned, sizeof word));
            return;
        }
        case 2:
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), numbers.below(64),
                         std::byte{});
            return;
        case 3:
            bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                        bytes.begin() + static_cast<std::ptrdiff_t>(at + part(64)));
            return;
        case 4:
            bytes.resize(at + 1);
            return;
        default:  // as another world has it there
            if (at < other.size())
                std::memcpy(bytes.data() + at, other.data() + at,
                            std::min(part(64), other.size() - at));
    }
}

/// Forges the seal, so that what is behind it is reached.
void seal(Snapshot& bytes) {
    std::uint64_t seal = 0;
    if (bytes.size() < sizeof seal) return;
    const std::size_t count = bytes.size() - sizeof seal;
    detail::Hasher hasher;
    hasher.bytes(bytes.data(), count);
    seal = hasher.result;
    std::memcpy(bytes.data() + count, &seal, sizeof seal);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
    return mutateDecisions(data, size, most, seed, 60);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Snapshot samples[] = {sample(0), sample(1), sample(30), sample(500)};
    test::ByteNumbers numbers(std::span(data, size));
    const Snapshot& first = samples[numbers.below(std::size(samples))];
    const Snapshot& other = samples[numbers.below(std::size(samples))];
    const bool sealed = numbers.below(4) != 0;
    Snapshot bytes = first;
    for (int edits = 0; edits < 20 && !numbers.done(); ++edits) edit(bytes, other, numbers);
    if (sealed) seal(bytes);
    World world;
    world.add(shapes::box());
    world.step();
    const auto before = world.hash();
    try {
        world.restore(bytes);
    } catch (const Error& error) {
        require(error.code() == ErrorCode::badSnapshot && world.hash() == before);
        return 0;
    }
    require(world.validate().empty());
    require(world.snapshot() == bytes);
    if (bytes != first) {
        require(sealed);
        return 0;
    }
    for (int i = 0; i < 10; ++i) world.step();
    require(world.validate().empty());
    return 0;
}
