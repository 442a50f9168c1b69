// Inner loops alone, without what surrounds them in a tick: nanoseconds of a particle, a joint, a
// link of a chain, or a rigid component, each time that one is gone through.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "kernels/chain_lanes.hpp"
#include "kernels/cluster_motion.hpp"
#include "kernels/joint_force.hpp"
#include "kernels/particle_motion.hpp"

namespace sulfur::lab {

namespace {

using detail::SweepReal;

constexpr const char* perItem = "ns/item";

void countItems(benchmark::State& state, std::size_t items) {
    state.counters[perItem] = benchmark::Counter(
        static_cast<double>(items) * static_cast<double>(state.iterations()) * 1e-9,
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

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

/// Squares of four particles with six joints, in batches of the same joint of each.
struct Squares {
    explicit Squares(std::size_t count) : count_(count) {
        constexpr double places[4][2] = {{0, 0}, {1.001, 0}, {1, 0.999}, {0, 1}};
        for (std::size_t i = 0; i < count; ++i)
            for (const auto& [x, y] : places) {
                position.push_back(2 * static_cast<double>(i) + x);
                position.push_back(y);
            }
        velocity.resize(position.size(), 0.01);
        force.resize(position.size());
        displacement.resize(position.size(), SweepReal(1e-5));
        constexpr std::uint32_t ends[6][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}};
        for (std::uint32_t j = 0; j < 6; ++j)
            for (std::uint32_t i = 0; i < count; ++i) {
                joint.push_back(static_cast<std::uint32_t>(joint.size()));
                a.push_back(2 * (4 * i + ends[j][0]));
                b.push_back(2 * (4 * i + ends[j][1]));
                length.push_back(j < 4 ? SweepReal(1) : SweepReal(1.41421356));
            }
        for (auto* list :
             {&pull, &startX, &startY, &directionX, &directionY, &whips, &lambda, &gain, &rest})
            list->resize(joints());
        mass.resize(joints(), 1);
        stiffness.resize(joints(), 100);
        damping.resize(joints(), SweepReal(0.1));
        hk.resize(joints(), 4);
        hb.resize(joints(), SweepReal(0.1));
    }

    std::size_t joints() const { return 6 * count_; }

    detail::ForceView forces() {
        return {position.data(), velocity.data(), force.data(),  pull.data(),      joint.data(),
                a.data(),        b.data(),        length.data(), stiffness.data(), damping.data()};
    }
    detail::StartView start() {
        return {position.data(),   pull.data(),       joint.data(),
                a.data(),          b.data(),          mass.data(),
                mass.data(),       length.data(),     hk.data(),
                hb.data(),         startX.data(),     startY.data(),
                directionX.data(), directionY.data(), whips.data(),
                lambda.data(),     gain.data(),       rest.data(),
                SweepReal(0.002),  SweepReal(0.5),    0.01};
    }
    detail::SweepView sweep() {
        return {displacement.data(), a.data(),     b.data(),    startX.data(), startY.data(),
                mass.data(),         mass.data(),  rest.data(), lambda.data(), directionX.data(),
                directionY.data(),   whips.data(), hk.data(),   hb.data(),     gain.data()};
    }
    /// Calls f(first, count) for each batch.
    template <class Function>
    void forEachBatch(Function&& f) {
        for (std::size_t first = 0; first < joints(); first += count_) f(first, count_);
    }

    std::vector<double> position, velocity, force;
    std::vector<SweepReal> displacement, length, pull, startX, startY, directionX, directionY,
        whips, lambda, gain, rest, mass, stiffness, damping, hk, hb;
    std::vector<std::uint32_t> joint, a, b;

private:
    std::size_t count_;
};

void jointForceKernels(benchmark::State& state) {
    Squares scene(static_cast<std::size_t>(state.range(0)));
    const auto add =
        state.range(1) != 0 ? detail::forceKernels().damped : detail::forceKernels().elastic;
    for (auto _ : state) {
        scene.forEachBatch(
            [&](std::size_t first, std::size_t count) { add(scene.forces(), first, count); });
        benchmark::ClobberMemory();
    }
    countItems(state, scene.joints());
}
BENCHMARK(jointForceKernels)->ArgNames({"squares", "damped"})->ArgsProduct({{256}, {0, 1}});

void jointSweepKernels(benchmark::State& state) {
    Squares scene(static_cast<std::size_t>(state.range(0)));
    const bool rigid = state.range(1) != 0;
    const detail::SweepKernels& kernels = detail::sweepKernels();
    scene.forEachBatch([&](std::size_t first, std::size_t count) {
        (rigid ? kernels.startRigid : kernels.startImplicit)(scene.start(), first, count);
    });
    for (auto _ : state) {
        scene.forEachBatch([&](std::size_t first, std::size_t count) {
            (rigid ? kernels.rigid : kernels.implicit)(scene.sweep(), first, count);
        });
        benchmark::ClobberMemory();
    }
    countItems(state, scene.joints());
}
BENCHMARK(jointSweepKernels)->ArgNames({"squares", "rigid"})->ArgsProduct({{256}, {0, 1}});

/// Rigid components of four particles: displacements of all, angles, and where all then are.
void clusterKernels(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    constexpr std::uint32_t members = 4;
    std::vector<double> position(2 * members * count), velocity(position), force(position),
        places(position.size(), 0.5), half(count, 0.001), x(count, 1), y(count, 0);
    std::vector<SweepReal> displacement(position.size()), arm(position.size()), sine(count),
        versine(count);
    std::vector<std::uint32_t> particles(members * count);
    std::vector<detail::ClusterPose> poses;
    std::vector<detail::ClusterWay> ways;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t first = members * i, last = first + members;
        for (auto p = first; p < last; ++p) particles[p] = p;
        poses.push_back({first, last, 2.0 * i, 1, 1, 0, 2.0 * i, 1, 1, 0, 0.1, 0.1, 0.1});
        ways.push_back({first, last, SweepReal(0.01), 0, SweepReal(0.001), 0});
    }
    const detail::MemberView view{position.data(),     velocity.data(), force.data(),
                                  displacement.data(), arm.data(),      particles.data(),
                                  places.data()};
    const detail::ClusterKernels& kernels = detail::clusterKernels();
    for (auto _ : state) {
        for (std::size_t k = 0; k < count; k += detail::clusterBlock) {
            kernels.sines(&half[k], &sine[k], &versine[k], detail::clusterBlock);
            kernels.spread(view, &ways[k], detail::clusterBlock);
            kernels.turn(&half[k], &x[k], &y[k], detail::clusterBlock);
            kernels.place(view, &poses[k], detail::clusterBlock, 1e9);
        }
        benchmark::ClobberMemory();
    }
    countItems(state, count);
}
BENCHMARK(clusterKernels)->ArgName("crates")->Arg(256);

/// Chains of rigid links, side by side, that hang a little aside: one step of a tick. With
/// `passes` 1 a Newton pass is all of it.
struct Chains {
    static constexpr std::size_t lanes = detail::chainLanes;

    explicit Chains(std::size_t count)
        : nodes(count), scratch(nodes * detail::chainScratch + detail::chainAlignment) {
        for (std::uint32_t i = 0; i < nodes; ++i)
            for (std::uint32_t k = 0; k < lanes; ++k) {
                const auto p = static_cast<std::uint32_t>(k * nodes + i);
                particles.push_back(p);
                joints.push_back(p);
                inverseMass.push_back(i == 0 ? 0 : 1);
                rest.push_back(1);
                share.push_back(1);
            }
        for (std::uint32_t k = 0; k < lanes; ++k) {
            firsts.push_back(static_cast<std::uint32_t>(k * nodes));
            for (std::size_t i = 0; i < nodes; ++i) {
                position.push_back(0.6 * static_cast<double>(i) + 3.0 * k);
                position.push_back(-0.8 * static_cast<double>(i));
            }
        }
        velocity.resize(position.size(), 0);
        force.resize(position.size(), 0);
        displacement.resize(position.size(), 0);
        predicted.resize(position.size(), 0);
        tension.resize(nodes * lanes, 0);
        lambda.resize(nodes * lanes, 0);
    }

    void step(int passes) {
        const detail::ChainView view{position.data(),     velocity.data(), force.data(),
                                     displacement.data(), tension.data(),  lambda.data(),
                                     predicted.data()};
        detail::ChainRules rules{};
        rules.gravityY = -9.81;
        rules.tick = 0.002;
        rules.maxSpeed = rules.maxForce = 1e12;
        rules.closingSpeed = 5;
        rules.smallStretch = 1e-3;
        rules.tolerance = passes == 1 ? 1e9 : 1e-8;
        rules.worthwhile = 0.1;
        rules.redundant = 1e-12;
        rules.mostPasses = 8;
        rules.mostFactored = 4;
        rules.mostWhip = rules.mostTurn = rules.calmWhip = rules.calmTurn = 1e9;
        detail::ChainBatch batch{};
        batch.nodes = nodes;
        batch.particles = particles.data();
        batch.joints = joints.data();
        batch.inverseMass = inverseMass.data();
        batch.rest = rest.data();
        batch.share = share.data();
        batch.firsts = firsts.data();
        for (double& last : batch.lastStep) last = rules.tick;
        batch.heldRoot = true;
        batch.steps = 1;
        batch.lanes = (1u << lanes) - 1;
        void* at = scratch.data();
        std::size_t room = scratch.size();
        std::align(detail::chainAlignment, nodes * detail::chainScratch, at, room);
        std::fill(velocity.begin(), velocity.end(), 0.0);
        benchmark::DoNotOptimize(detail::chainKernels().step(view, rules, batch, at));
    }

    std::size_t nodes;
    std::vector<double> position, velocity, force, inverseMass, rest, share;
    std::vector<SweepReal> displacement, tension, lambda, predicted;
    std::vector<std::uint32_t> particles, joints, firsts;
    std::vector<std::byte> scratch;
};

void chainKernel(benchmark::State& state) {
    Chains scene(41);
    for (auto _ : state) {
        scene.step(static_cast<int>(state.range(0)));
        benchmark::ClobberMemory();
    }
    countItems(state, 40 * Chains::lanes);
}
BENCHMARK(chainKernel)->ArgName("passes")->Arg(1)->Arg(8);

}  // namespace

}  // namespace sulfur::lab
