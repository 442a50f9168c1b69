// Lattices: what one joint costs in a sweep.
#include <limits>

#include "battery/scenes.hpp"
#include "stepping.hpp"

namespace sulfur::lab {

namespace {

/// A square lattice hung from its upper corners, gently shaken.
void hungLattice(benchmark::State& state, const Blueprint& plan, int side, int sweeps,
                 std::initializer_list<Stage> stages) {
    World world(still({.sweeps = sweeps}, standardGravity));
    const Body body = world.add(plan);
    const auto n = static_cast<std::size_t>(side);
    world.setPinned(body[n * (n - 1)], true);
    world.setPinned(body[n * n - 1], true);
    Random random(1);
    for (const ParticleId id : body.particles())
        if (!world.info(id).pinned)
            world.setVelocity(id, vec2(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)));
    stepAndCount(state, world, {"joint", static_cast<double>(plan.joints.size()) * sweeps},
                 state.range(2) != 0, stages);
}

Blueprint square(int side, double stiffness) {
    return lattice(
        {.columns = side, .rows = side, .cell = 0.1, .mass = 0.1, .stiffness = stiffness});
}

/// Springs that are soft enough to be explicit: no sweeps, so the time is that of a tick.
/// Arguments: particles a side; sweeps; whether profiling is on.
void explicitLattice(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    hungLattice(state, square(side, 100), side, static_cast<int>(state.range(1)), {Stage::forces});
}
BENCHMARK(explicitLattice)
    ->ArgNames({"side", "sweeps", "profiling"})
    ->ArgsProduct({{30}, {1}, {0, 1}});

/// Springs stiff enough to be implicit; the time is that of one joint in one sweep.
void implicitLattice(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    hungLattice(state, square(side, 1e6), side, static_cast<int>(state.range(1)),
                {Stage::constraints});
}
BENCHMARK(implicitLattice)
    ->ArgNames({"side", "sweeps", "profiling"})
    ->ArgsProduct({{30}, {1, 4, 16}, {0, 1}});

/// A cloth of rigid joints without diagonals, so that it is no rigid body.
void rigidMesh(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    Blueprint plan = square(side, std::numeric_limits<double>::infinity());
    std::erase_if(plan.joints, [side](const JointSpec& joint) {
        return joint.a / static_cast<unsigned>(side) != joint.b / static_cast<unsigned>(side) &&
               joint.a % static_cast<unsigned>(side) != joint.b % static_cast<unsigned>(side);
    });
    hungLattice(state, plan, side, static_cast<int>(state.range(1)), {Stage::constraints});
}
BENCHMARK(rigidMesh)
    ->ArgNames({"side", "sweeps", "profiling"})
    ->ArgsProduct({{30}, {1, 4, 16}, {0, 1}});

}  // namespace

}  // namespace sulfur::lab
