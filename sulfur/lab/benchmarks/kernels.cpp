// Inner loops alone, without what surrounds them in a tick: nanoseconds of a contact or of a
// particle in one sweep.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "kernels/contact_sweep.hpp"
#include "kernels/particle_motion.hpp"

namespace sulfur::lab {

namespace {

using detail::ContactBlock;
using detail::contactLanes;
using detail::Mover;
using detail::SweepReal;

constexpr const char* perItem = "ns/item";

void countItems(benchmark::State& state, std::size_t items) {
    state.counters[perItem] = benchmark::Counter(
        static_cast<double>(items) * static_cast<double>(state.iterations()) * 1e-9,
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Contacts between rigid components in a row, in blocks of one colour, with friction.
struct Blocks {
    explicit Blocks(std::size_t contacts) : movers(contacts + 1), blocks(contacts / contactLanes) {
        std::minstd_rand random(3);
        std::uniform_real_distribution<SweepReal> unit(-1, 1);
        for (Mover& m : movers) m = {.x = unit(random), .y = unit(random), .mass = 1, .inertia = 6};
        movers[0] = {};
        for (std::size_t i = 0; i < blocks.size() * contactLanes; ++i) {
            ContactBlock& b = blocks[i / contactLanes];
            const std::size_t lane = i % contactLanes;
            b.particle[lane] = static_cast<std::uint32_t>(i + 1);
            b.a[lane] = 0;
            b.shareA[lane] = 1;
            b.normalY[lane] = 1;
            b.armX[lane] = SweepReal(0.5) * unit(random);
            b.armY[lane] = SweepReal(-0.5);
            b.normalMass[lane] = b.tangentMass[lane] = SweepReal(0.5);
            b.friction[lane] = SweepReal(0.6);
        }
    }
    std::vector<Mover> movers;
    std::vector<ContactBlock> blocks;
};

void contactKernel(benchmark::State& state) {
    Blocks scene(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        detail::contactKernels().solveTwo(scene.movers.data(), scene.blocks.data(),
                                          scene.blocks.size());
        benchmark::ClobberMemory();
    }
    countItems(state, scene.blocks.size() * contactLanes);
}
BENCHMARK(contactKernel)->ArgName("contacts")->Arg(1024)->Arg(16384);

void particleKernels(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    std::vector<double> position(2 * count), velocity(2 * count), force(2 * count);
    std::vector<SweepReal> displacement(2 * count), inverseMass(count, 1);
    const detail::MotionView view{position.data(), velocity.data(), force.data(),
                                  displacement.data(), inverseMass.data()};
    const detail::Kick kick{0, -9.81, 1, 0.002, 0.002, 2000};
    for (auto _ : state) {
        detail::motionKernels().predict(view, kick, 0, count);
        detail::motionKernels().takeUp(view, kick, 0, count);
        detail::motionKernels().move(view, 1e9, 0, count);
        benchmark::ClobberMemory();
    }
    countItems(state, count);
}
BENCHMARK(particleKernels)->ArgName("particles")->Arg(1024)->Arg(16384);

}  // namespace

}  // namespace sulfur::lab
