#include "limit_search.hpp"

#include <algorithm>
#include <cmath>

namespace sulfur::lab {

bool survives(const Rope& rope, Integrator& integrator, double rate, const SearchOptions& options) {
    const double h = 1 / rate;
    const double limit = options.energyMargin * rope.budget();
    const auto ticks = static_cast<long>(std::ceil(options.seconds * rate));
    const auto settled = ticks - static_cast<long>(rate);
    const double restLimit = options.mustRest ? options.restShare * rope.budget() : limit;
    State state = rope.start();
    integrator.begin(rope, state, h);
    for (long tick = 0; tick < ticks; ++tick) {
        integrator.step(rope, state, h);
        // Written so that NaN, which compares as false with everything, is an explosion too.
        const double energy = rope.kineticEnergy(state);
        if (!(energy <= (tick < settled ? limit : restLimit))) return false;
    }
    for (const Vec& x : state.x)
        if (!x.allFinite()) return false;
    return true;
}

LimitFound findLimit(RopeConstants rope, const IntegratorEntry& entry, double rate,
                     const SearchOptions& options) {
    LimitFound found;
    const auto isStable = [&](double stiffness) {
        ++found.trials;
        rope.stiffness = stiffness;
        return survives(Rope(rope), *entry.make(), rate, options);
    };
    const double factor = entry.bounded ? 2 : 10;
    for (double k = options.lowest; !found.exploded; k = std::min(factor * k, options.highest)) {
        if (!isStable(k)) {
            found.exploded = k;
        } else {
            found.stable = k;
            if (k >= options.highest) return found;
        }
    }
    while (found.stable > 0 && *found.exploded - found.stable > options.resolution * found.stable) {
        const double middle = (found.stable + *found.exploded) / 2;
        if (isStable(middle)) {
            found.stable = middle;
        } else {
            found.exploded = middle;
        }
    }
    return found;
}

}  // namespace sulfur::lab
