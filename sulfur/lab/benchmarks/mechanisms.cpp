// Mechanisms: what a hinge costs, and its drive.
#include "stepping.hpp"

namespace sulfur::lab {

namespace {

/// A thousand bars that turn about fixed points, far from each other. Argument: whether each has a
/// motor and two limits.
void hinges(benchmark::State& state) {
    constexpr int count = 1000;
    World world({.gravity = {0, 0}, .sleeping = false});
    HingeOptions options;
    if (state.range(0) != 0) options.drive = {.lower = -1e6, .upper = 1e6, .motorMax = 10};
    options.drive.motorSpeed = 1;
    for (int i = 0; i < count; ++i) {
        const Point at(3.0 * i, 0);
        const Body frame =
            world.add({.kind = BodyKind::fixed, .particles = {{}}}, {.position = at});
        const Body bar =
            world.add(shapes::box({.size = {1, Real(0.2)}}), {.position = at + Point(0.48, 0)});
        world.hinge(frame, bar, at, options);
    }
    stepAndCount(state, world, {"hinge", count}, false, {});
}
BENCHMARK(hinges)->ArgNames({"motor"})->Arg(0)->Arg(1);

}  // namespace

}  // namespace sulfur::lab
