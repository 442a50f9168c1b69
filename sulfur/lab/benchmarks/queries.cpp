// What a query costs, in worlds of different sizes: it should follow what it covers, not them.
#include <benchmark/benchmark.h>

#include <cmath>
#include <sulfur/sulfur.hpp>

#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

/// Crates of half a metre on a square lattice of 2 m, in no gravity, so that nothing moves.
class Yard {
public:
    explicit Yard(std::int64_t crates)
        : side_(static_cast<int>(std::lround(std::sqrt(static_cast<double>(crates))))) {
        const Blueprint crate = shapes::box({.size = vec2(0.5, 0.5)});
        for (int i = 0; i < side_ * side_; ++i)
            world_.add(crate, {.position = {2.0 * (i % side_), 2.0 * (i / side_)}});
        world_.step();
    }

    World& world() { return world_; }
    /// A place in the yard, another one each time (a lattice of the golden ratio: no clumps).
    Point place() {
        ++count_;
        const double x = 0.6180339887 * count_, y = 0.7548776662 * count_;
        return 2.0 * side_ * Point(x - std::floor(x), y - std::floor(y));
    }

private:
    World world_{still({}, 0)};
    int side_;
    double count_ = 0;
};

/// Runs `ask(yard, place)` over and over. Arguments: crates.
template <class Ask>
void query(benchmark::State& state, Ask&& ask) {
    Yard yard(state.range(0));
    for (auto tick : state) {
        static_cast<void>(tick);
        benchmark::DoNotOptimize(ask(yard.world(), yard.place()));
    }
}

const auto ray = [](World& world, const Point& from) {
    return world.castSegment(from, from + Point(10, 3));
};
const auto longRay = [](World& world, const Point& from) {
    return world.castRay(from - Point(5e5, 0), vec2(1, 0), 1e6);
};
const auto allHits = [](World& world, const Point& from) {
    return world.castAll(from, from + Point(10, 3));
};
const auto movedBox = [](World& world, const Point& from) {
    return world.castShape(QueryShape::box(from, vec2(0.4, 0.4), 0.3), {10, 3});
};
const auto closest = [](World& world, const Point& from) { return world.closestPoint(from, 10); };
const auto pointed = [](World& world, const Point& from) { return world.bodiesAt(from); };
const auto region = [](World& world, const Point& from) { return world.overlapCircle(from, 3); };

BENCHMARK_CAPTURE(query, ray, ray)->ArgName("crates")->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(query, longRay, longRay)->ArgName("crates")->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(query, allHits, allHits)->ArgName("crates")->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(query, movedBox, movedBox)->ArgName("crates")->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(query, closest, closest)->ArgName("crates")->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(query, pointed, pointed)->ArgName("crates")->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(query, region, region)->ArgName("crates")->Arg(100)->Arg(10000);

}  // namespace

}  // namespace sulfur::lab
