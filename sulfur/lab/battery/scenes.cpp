#include "battery/scenes.hpp"

#include <cmath>

namespace sulfur::lab {

WorldSettings still(const Setup& setup, double gravity) {
    return {.gravity = vec2(0, -gravity),
            .airFriction = 0,
            .tickRate = setup.tickRate,
            .sleeping = false,
            .sweeps = setup.sweeps};
}

void run(World& world, double seconds) {
    const auto ticks = std::lround(seconds * world.settings().tickRate);
    for (long i = 0; i < ticks; ++i) world.step();
}

Blueprint ghost(std::string name) {
    Blueprint body;
    body.name = std::move(name);
    body.filter.mask = 0;
    return body;
}

Blueprint chain(const ChainOptions& options) {
    Blueprint body = ghost("chain");
    for (std::size_t i = 0; i < options.places.size(); ++i) {
        const bool last = i + 1 == options.places.size();
        body.particles.push_back({.position = options.places[i].cast<Real>(),
                                  .mass = real(options.masses[i]),
                                  .pinned = i == 0 || (last && options.pinLast)});
    }
    for (std::size_t j = 0; j < options.lengths.size(); ++j) {
        const auto a = static_cast<std::uint32_t>(j);
        const bool rigid = options.stiffness.empty();
        body.joints.push_back({.a = a,
                               .b = a + 1,
                               .stiffness = rigid ? infinite : real(options.stiffness[j]),
                               .damping = rigid ? 0 : real(options.damping),
                               .restLength = real(options.lengths[j])});
    }
    return body;
}

Blueprint lattice(const LatticeOptions& o) {
    Blueprint body = ghost("lattice");
    for (int row = 0; row < o.rows; ++row)
        for (int column = 0; column < o.columns; ++column)
            body.particles.push_back(
                {.position = vec2(o.cell * column, o.cell * row), .mass = real(o.mass)});
    const auto join = [&](int a, int b) {
        body.joints.push_back({.a = static_cast<std::uint32_t>(a),
                               .b = static_cast<std::uint32_t>(b),
                               .stiffness = real(o.stiffness),
                               .damping = real(o.damping)});
    };
    for (int row = 0; row < o.rows; ++row) {
        for (int column = 0; column < o.columns; ++column) {
            const int here = row * o.columns + column, above = here + o.columns;
            if (column + 1 < o.columns) join(here, here + 1);
            if (row + 1 < o.rows) join(here, above);
            if (column + 1 == o.columns || row + 1 == o.rows) continue;
            join(here, above + 1);
            join(here + 1, above);
        }
    }
    return body;
}

Blueprint net(const NetOptions& o) {
    Blueprint plan;
    for (std::uint32_t i = 0; i < o.side * o.side; ++i) {
        const bool middle = i == o.side / 2 * o.side + o.side / 2;
        plan.particles.push_back({.position = vec2(0.1 * (i % o.side), -0.1 * (i / o.side)),
                                  .mass = real(middle ? 0.01 * o.load : 0.01),
                                  .pinned = i == 0 || (o.secondCorner && i + 1 == o.side)});
    }
    for (std::uint32_t i = 0; i < o.side * o.side; ++i) {
        if (i % o.side + 1 < o.side) plan.joints.push_back({.a = i, .b = i + 1});
        if (i + o.side < o.side * o.side) plan.joints.push_back({.a = i, .b = i + o.side});
    }
    return plan;
}

double Random::uniform(double low, double high) {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * static_cast<double>(z >> 11) / 9007199254740992.0;
}

}  // namespace sulfur::lab
