// What the machine itself can do, to hold the other figures against: how fast numbers come from
// memory and from the caches, and how many roots and divisions a core finishes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace sulfur::lab {

namespace {

/// a = b + s c, the triad of the STREAM benchmark: three streams, of which one is written.
/// Argument: kilobytes in all three.
void triad(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0)) * 1024 / (3 * sizeof(double));
    std::vector<double> a(count, 0), b(count, 1), c(count, 2);
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 0.5 * c[i];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() *
                            static_cast<std::int64_t>(3 * count * sizeof(double)));
}
// In the first cache, in the second, and far beyond.
BENCHMARK(triad)->ArgName("kB")->Arg(24)->Arg(1024)->Arg(384 * 1024);

/// Applies `function` to numbers in the first cache that do not wait for each other.
template <class Scalar, class Function>
void independent(benchmark::State& state, Function&& function) {
    std::vector<Scalar> in(1024), out(1024);
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = static_cast<Scalar>(1 + i);
    for (auto _ : state) {
        for (std::size_t i = 0; i < in.size(); ++i) out[i] = function(in[i]);
        benchmark::DoNotOptimize(out.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(in.size()));
}

template <class Scalar>
void squareRoot(benchmark::State& state) {
    independent<Scalar>(state, [](Scalar x) { return std::sqrt(x); });
}
template <class Scalar>
void division(benchmark::State& state) {
    independent<Scalar>(state, [](Scalar x) { return 1 / x; });
}
BENCHMARK_TEMPLATE(squareRoot, float);
BENCHMARK_TEMPLATE(squareRoot, double);
BENCHMARK_TEMPLATE(division, float);
BENCHMARK_TEMPLATE(division, double);

}  // namespace

}  // namespace sulfur::lab
