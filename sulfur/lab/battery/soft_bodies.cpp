#include "battery/soft_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

Rows freeSoftBody(long ticks, const Setup& setup) {
    World world(still(setup, 0));
    const Body body = world.add(lattice({.stiffness = 400}));
    spin(world, body, 2);
    Random random(7);
    for (const ParticleId id : body.particles())
        world.setVelocity(
            id, world.velocity(id) + vec2(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)));
    const Point centre = world.centreOfMass(body);
    double radius = 0;
    for (const ParticleId id : body.particles())
        radius = std::max(radius, (world.position(id) - centre).norm());
    world.step();
    const Motion first = motionOf(world, body.particles());
    double fastest = first.fastest, linear = 0, angular = 0;
    for (long i = 1; i < ticks; ++i) {
        world.step();
        // A drift shows as well in one tick of a hundred; to look costs more than to step.
        if (i % 101 != 0 && i + 1 != ticks) continue;
        const Motion now = motionOf(world, body.particles());
        fastest = worst(fastest, now.fastest);
        linear = worst(linear, (now.momentum - first.momentum).norm());
        angular = worst(angular, std::abs(now.angularMomentum - first.angularMomentum));
    }
    const double scale = first.mass * fastest;
    const std::string name = fmt::format("free soft body, {} ticks: ", ticks);
    return {atMost(name + "drift of momentum (share of m v_max)", linear / scale,
                   doubleBuild ? 1e-12 : 1e-6),
            atMost(name + "drift of angular momentum (share of m v_max r)",
                   angular / (scale * radius), doubleBuild ? 1e-9 : 1e-4)};
}

namespace {

/// With its first particle pinned at the origin, the rest to the right and above.
Blueprint randomPlan(const RandomLattice& o, Random& random) {
    Blueprint plan = lattice({.columns = 5, .rows = 4, .cell = 0.2, .stiffness = o.stiffness});
    for (ParticleSpec& p : plan.particles)
        p.mass = real(0.1 * std::pow(o.massRatio, -random.uniform(0, 1)));
    plan.particles.front().pinned = true;
    std::erase_if(plan.joints, [&](const JointSpec&) { return random.uniform(0, 1) < 0.25; });
    return plan;
}

}  // namespace

namespace {

/// Energy is known at the ends of steps, so that it is measured in a world whose ticks are steps.
RandomLatticeResult releaseInSteps(const RandomLattice& options, const Setup& setup) {
    World world(still(setup, standardGravity));
    Random random(options.seed);
    const Body body = world.add(randomPlan(options, random));
    double budget = 0;  // J above the lowest place that each particle reaches unstretched
    for (const ParticleId id : body.particles()) {
        if (world.info(id).pinned) continue;
        const Vec v(random.uniform(-1, 1), random.uniform(-1, 1));
        world.setVelocity(id, v.cast<Real>());
        const Point x = world.position(id);
        budget += static_cast<double>(world.info(id).mass) *
                  (v.squaredNorm() / 2 + standardGravity * (x.y() + x.norm()));
    }
    const double start = world.energy();  // at rest length: no joint is stretched
    EnergyMeter meter;
    double gain = -1;
    for (int second = 0; second < std::lround(options.seconds); ++second) {
        double sum = 0;
        long count = 0;
        for (int tick = 0; tick < setup.tickRate; ++tick) {
            world.step();
            const auto energy = meter.add(world, body);
            if (!energy) continue;
            sum += *energy;
            ++count;
        }
        gain = worst(gain, (sum / static_cast<double>(count) - start) / budget);
    }
    return {allFinite(world, body.particles()), gain};
}

/// Whether the lattice stays finite in a world whose ticks are several steps.
bool staysFinite(const RandomLattice& options, const Setup& setup) {
    World world(still(setup, standardGravity));
    Random random(options.seed);
    const Body body = world.add(randomPlan(options, random));
    for (const ParticleId id : body.particles()) {
        if (world.info(id).pinned) continue;
        const Vec v(random.uniform(-1, 1), random.uniform(-1, 1));
        world.setVelocity(id, v.cast<Real>());
    }
    run(world, options.seconds);
    return allFinite(world, body.particles());
}

}  // namespace

RandomLatticeResult releaseLattice(const RandomLattice& options, const Setup& setup) {
    const Setup steps = setup.ofSteps();
    RandomLatticeResult result = releaseInSteps(options, steps);
    if (steps.tickRate != setup.tickRate) result.finite &= staysFinite(options, setup);
    return result;
}

RandomLattices RandomLattices::all() {
    return {.stiffness = {0, 1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, static_cast<double>(infinite)},
            .massRatios = {1, 1e3, 1e6},
            .rates = {60, 120, 500, 2000, 10000}};
}

Rows randomLattices(const RandomLattices& options, const Setup& setup) {
    Rows rows;
    int broken = 0;
    const auto measure = [&](int rate, double stiffness, double ratio) {
        double largest = -1;
        for (int seed = 1; seed <= options.seeds; ++seed) {
            const auto result = releaseLattice({.stiffness = stiffness,
                                                .massRatio = ratio,
                                                .seconds = options.seconds,
                                                .seed = static_cast<std::uint64_t>(seed)},
                                               {rate, setup.sweeps});
            broken += result.finite ? 0 : 1;
            largest = worst(largest, result.energyGain);
        }
        rows.push_back(atMost(fmt::format("random lattice at {} Hz, k = {:g} N/m, mass ratio "
                                          "{:g}, {:g} s: gain of energy (share)",
                                          rate, stiffness, ratio, options.seconds),
                              largest, 0.1));
    };
    for (const int rate : options.rates)
        for (const double ratio : options.massRatios)
            for (const double k : options.stiffness) measure(rate, k, ratio);
    rows.push_back(atMost("random lattices: runs that are not finite", broken, 0));
    return rows;
}

namespace {

/// Share of the triangles of a lattice's cells that are the wrong way round.
double insideOut(const World& world, std::span<const ParticleId> particles, std::size_t columns) {
    int wrong = 0, all = 0;
    const auto at = [&](std::size_t i) { return world.position(particles[i]); };
    for (std::size_t i = 0; i + columns + 1 < particles.size(); ++i) {
        if ((i + 1) % columns == 0) continue;
        const Point a = at(i), b = at(i + 1), c = at(i + columns), d = at(i + columns + 1);
        for (const double area : {cross(b - a, d - a), cross(d - a, c - a)}) {
            ++all;
            wrong += area > 0 ? 0 : 1;
        }
    }
    return static_cast<double>(wrong) / all;
}

}  // namespace

Rows scrambledLattice(double disorder, std::uint64_t seed, const Setup& setup) {
    constexpr double cell = 0.25, seconds = 30;
    // Of a lattice that folds over itself the flaps turn about their folds, which axial dampers do
    // not brake: it keeps some millimetres a second, for ever.
    const double rest = disorder > 0.5 ? 2e-2 : 1e-3;
    constexpr int columns = 5;
    World world(still(setup, 0));
    const Body body = world.add(lattice(
        {.columns = columns, .rows = columns, .cell = cell, .stiffness = 400, .damping = 1}));
    Random random(seed);
    const double reach = disorder * cell;
    for (const ParticleId id : body.particles())
        world.setPosition(id, world.position(id) + Point(random.uniform(-reach, reach),
                                                         random.uniform(-reach, reach)));
    run(world, seconds);
    const Motion last = motionOf(world, body.particles());
    const double speed = std::sqrt(2 * last.spinKinetic / last.mass);
    const std::string name =
        fmt::format("lattice scrambled by {:g} cells (seed {}), {:g} s: ", disorder, seed, seconds);
    Rows rows{atMost(name + "not finite", allFinite(world, body.particles()) ? 0 : 1, 0),
              atMost(name + "mean speed about its centre (m/s)", speed, rest)};
    if (disorder <= 0.5)
        rows.push_back(atMost(name + "cells inside out (share)",
                              insideOut(world, body.particles(), columns), 0));
    return rows;
}

}  // namespace sulfur::lab
