#include "battery/random_worlds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "battery/random/laws.hpp"

namespace sulfur::lab {

namespace {

SeedRange seedsOf(const Setup& setup) {
    return setup.seeds.value_or(SeedRange{1, setup.quick ? 50u : 1000u});
}

}  // namespace

Rows randomWorlds(const Setup& setup) {
    const SeedRange seeds = seedsOf(setup);
    const std::vector<Law> laws = allLaws();
    std::vector<int> broken(lawCount, 0);
    Rows failing;
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
        std::vector<Breach> breaches = judge(sceneOf(seed), laws);
        for (const Breach& breach : breaches) {
            ++broken[static_cast<std::size_t>(breach.law)];
            failing.push_back(atMost(
                fmt::format("seed {}: {}, from tick {}", seed, name(breach.law), breach.tick),
                breach.measured, breach.bound));
        }
    }
    Rows rows;
    for (const Law law : laws)
        rows.push_back(atMost(fmt::format("seeds {} to {} that break the law: {}", seeds.first,
                                          seeds.last, name(law)),
                              broken[static_cast<std::size_t>(law)], 0));
    rows.insert(rows.end(), failing.begin(), failing.end());
    return rows;
}

std::string shrunkWorlds(const Setup& setup) {
    const SeedRange seeds = seedsOf(setup);
    std::string out;
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
        const Scene scene = sceneOf(seed);
        for (const Breach& breach : judge(scene, allLaws())) {
            const Scene small = shrink(scene, breach.law);
            for (const Breach& left : judge(small, {breach.law}))
                out += fmt::format("\n// Seed {}, law {}: {:.3g} at tick {}, at most {:.3g}.\n",
                                   seed, name(left.law), left.measured, left.tick, left.bound);
            out += asCode(small);
        }
    }
    return out.empty() ? "No seed breaks a law.\n" : out;
}

}  // namespace sulfur::lab
