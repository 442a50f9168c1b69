// Restitution: a disc that falls and bounces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr double fall = 2, discRadius = 0.25;  // m
constexpr std::size_t counted = 5;

/// How high something rises, m: a low rebound lasts two or three ticks of 60 Hz. Symplectic Euler
/// keeps this energy, and not that of the same velocity at the end of the step.
double reach(const World& world, double height, double speed) {
    const double step =
        1 / (static_cast<double>(world.settings().tickRate) * world.statistics().substeps);
    return height + speed * speed / (2 * standardGravity) - speed * step / 2;
}

/// The heights of the first rebounds of a disc, above its place on the floor, m.
std::vector<double> heights(double restitution, const Setup& setup) {
    World world(still(setup, standardGravity));
    const Material material{.restitution = real(restitution)};
    addFloor(world, 5, material);
    const Body disc = world.add(shapes::ball({.radius = real(discRadius), .material = material}),
                                {.position = Point(0, fall + discRadius)});
    std::vector<double> found;
    double before = fall, top = 0;
    bool rising = false;
    const auto most = static_cast<int>(20 * world.settings().tickRate);
    for (int i = 0; i < most && found.size() < counted; ++i) {
        world.step();
        const double height = world.position(disc.front()).y() - discRadius;
        if (height > before) {
            if (!rising) top = 0;
            rising = true;
            const double speed = static_cast<double>(world.velocity(disc.front()).y());
            top = std::max(top, reach(world, height, speed));
        } else if (rising) {
            rising = false;
            // A rebound is not what a disc at rest trembles by.
            if (top > 1e-5) found.push_back(top);
        }
        before = height;
    }
    keepPicture(setup, fmt::format("rebound-{:g}", restitution), world);
    return found;
}

}  // namespace

Rows rebounds(const Setup& setup) {
    Rows rows;
    for (const double e : {0.5, 0.9}) {
        std::vector<double> found = heights(e, setup);
        found.resize(counted, std::numeric_limits<double>::quiet_NaN());
        for (std::size_t n = 1; n <= counted; ++n) {
            const double expected = fall * std::pow(e, 2 * static_cast<double>(n));
            rows.push_back(atMost(
                fmt::format("disc dropped from {:g} m, restitution {:g}: height of rebound {} "
                            "(error, share)",
                            fall, e, n),
                std::abs(found[n - 1] / expected - 1), 3e-3));
        }
    }
    return rows;
}

}  // namespace sulfur::lab
