// Ready-made blueprints that are rectangular lattices: jelly, cloth, wall.
#include <algorithm>
#include <cmath>
#include <sulfur/shapes.hpp>

#include "core/error_checks.hpp"
#include "parts.hpp"
#include "solid.hpp"

namespace sulfur::shapes {

using detail::Bracing;
using detail::join;
using detail::requirePositive;
using detail::requireRange;

namespace {

struct Lattice {
    Vec2 size{1, 1};            // m, outer
    std::uint32_t columns = 2;  // particles
    std::uint32_t rows = 2;     // particles
    Real mass = 1;              // kg
    Real radius = 0;            // m, of the capsules
    bool outlineOnly = true;    // whether only the outline is made of capsules
    bool diagonals = true;
    Bracing bracing = {};

    std::uint32_t at(std::uint32_t column, std::uint32_t row) const {
        return row * columns + column;
    }
    bool atEdge(std::uint32_t column, std::uint32_t row) const {
        return column == 0 || row == 0 || column + 1 == columns || row + 1 == rows;
    }
};

void addParticles(Blueprint& plan, const Lattice& lattice) {
    const Vec2 inner = lattice.size - 2 * Vec2(lattice.radius, lattice.radius);
    for (std::uint32_t row = 0; row < lattice.rows; ++row) {
        for (std::uint32_t column = 0; column < lattice.columns; ++column) {
            const Vec2 way(static_cast<Real>(column) / static_cast<Real>(lattice.columns - 1),
                           static_cast<Real>(row) / static_cast<Real>(lattice.rows - 1));
            plan.particles.push_back({.position = inner.cwiseProduct(way) - inner / 2});
        }
    }
}

void addJoints(Blueprint& plan, const Lattice& l) {
    const auto add = [&](std::uint32_t a, std::uint32_t b, bool outline) {
        join(plan, a, b, outline || !l.outlineOnly ? l.radius : 0, l.bracing);
    };
    for (std::uint32_t row = 0; row < l.rows; ++row) {
        for (std::uint32_t column = 0; column < l.columns; ++column) {
            const bool hasRight = column + 1 < l.columns;
            const bool hasUp = row + 1 < l.rows;
            if (hasRight)
                add(l.at(column, row), l.at(column + 1, row), row == 0 || row + 1 == l.rows);
            if (hasUp)
                add(l.at(column, row), l.at(column, row + 1),
                    column == 0 || column + 1 == l.columns);
            if (!l.diagonals || !hasRight || !hasUp) continue;
            join(plan, l.at(column, row), l.at(column + 1, row + 1), 0, l.bracing);
            join(plan, l.at(column + 1, row), l.at(column, row + 1), 0, l.bracing);
        }
    }
}

/// A way to spread the mass of 1 kg over the lattice, symmetric, so that its centre is the middle.
struct Spread {
    std::vector<double> weights;  // their sum is 1, or 0 for a core in the middle alone
    double gyration2 = 0;         // m^2, about the middle
};

template <class Weight>
Spread spreadBy(const Blueprint& plan, const Lattice& lattice, Weight&& weight) {
    Spread spread;
    double sum = 0;
    for (std::uint32_t row = 0; row < lattice.rows; ++row) {
        for (std::uint32_t column = 0; column < lattice.columns; ++column) {
            const double w = weight(column, row);
            spread.weights.push_back(w);
            sum += w;
            spread.gyration2 +=
                w * plan.particles[lattice.at(column, row)].position.cast<double>().squaredNorm();
        }
    }
    for (double& w : spread.weights) w /= sum;
    spread.gyration2 /= sum;
    return spread;
}

/// To each particle the part of the area that is nearest to it.
Spread tributaryAreas(const Blueprint& plan, const Lattice& l) {
    return spreadBy(plan, l, [&](std::uint32_t column, std::uint32_t row) {
        return (column == 0 || column + 1 == l.columns ? 0.5 : 1) *
               (row == 0 || row + 1 == l.rows ? 0.5 : 1);
    });
}

/// All to the particles nearest to the middle, or to a core there when they are too far from it.
Spread innermost(const Blueprint& plan, const Lattice& l, double gyration2) {
    Spread spread = spreadBy(plan, l, [&](std::uint32_t column, std::uint32_t row) {
        const auto middle = [](std::uint32_t i, std::uint32_t count) {
            return i == (count - 1) / 2 || i == count / 2;
        };
        return middle(column, l.columns) && middle(row, l.rows) ? 1.0 : 0.0;
    });
    if (spread.gyration2 > gyration2 / 2) return {std::vector<double>(spread.weights.size(), 0), 0};
    return spread;
}

/// All to the outline, or to the corners when the outline is too near to the middle.
Spread outermost(const Blueprint& plan, const Lattice& l, double gyration2) {
    Spread outline = spreadBy(plan, l, [&](std::uint32_t column, std::uint32_t row) {
        return l.atEdge(column, row) ? 1.0 : 0.0;
    });
    if (outline.gyration2 > gyration2 * 1.05) return outline;
    return spreadBy(plan, l, [&](std::uint32_t column, std::uint32_t row) {
        return (column == 0 || column + 1 == l.columns) && (row == 0 || row + 1 == l.rows) ? 1.0
                                                                                           : 0.0;
    });
}

/// A particle in the middle, held by the particles around it.
void addCore(Blueprint& plan, const Lattice& l, double mass) {
    const auto core = static_cast<std::uint32_t>(plan.particles.size());
    plan.particles.push_back({.mass = static_cast<Real>(mass)});
    const auto around = [](std::uint32_t i, std::uint32_t count) {
        return 2 * i + 3 >= count && 2 * i <= count + 1;
    };
    for (std::uint32_t row = 0; row < l.rows; ++row)
        for (std::uint32_t column = 0; column < l.columns; ++column)
            if (around(column, l.columns) && around(row, l.rows))
                join(plan, l.at(column, row), core, 0, l.bracing);
}

/// The tributary areas have a little too much inertia because they are lumped, or too little
/// because the capsules reach farther than the particles: blended with a spread that errs the
/// other way, both exact in mass and centre, they have the solid's.
void addMasses(Blueprint& plan, const Lattice& lattice) {
    const auto solid = detail::solidRectangle(lattice.size, lattice.mass);
    const double wanted = solid.gyration2();
    const Spread usual = tributaryAreas(plan, lattice);
    const Spread other = usual.gyration2 > wanted ? innermost(plan, lattice, wanted)
                                                  : outermost(plan, lattice, wanted);
    const double part = (wanted - usual.gyration2) / (other.gyration2 - usual.gyration2);
    if (!(part >= 0 && part < 0.95)) detail::refuseThickness("radius", lattice.radius);
    double given = 0;
    for (std::size_t i = 0; i < usual.weights.size(); ++i) {
        const double weight = (1 - part) * usual.weights[i] + part * other.weights[i];
        plan.particles[i].mass = static_cast<Real>(solid.mass * weight);
        given += weight;
    }
    if (given < 1 - 1e-9) addCore(plan, lattice, solid.mass * (1 - given));
}

Blueprint latticeOf(const Lattice& lattice, const char* name, const Material& material) {
    requirePositive(static_cast<double>(lattice.mass), "mass");
    detail::requireOuterSize(lattice.size, lattice.radius);
    Blueprint plan;
    plan.name = name;
    plan.material = material;
    addParticles(plan, lattice);
    addJoints(plan, lattice);
    addMasses(plan, lattice);
    return plan;
}

std::uint32_t counted(int count) {
    return static_cast<std::uint32_t>(count);
}

}  // namespace

Blueprint jelly(const JellyOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    requireRange(options.columns, 2, 1000, "columns");
    requireRange(options.rows, 2, 1000, "rows");
    Blueprint plan = latticeOf({.size = options.size,
                                .columns = counted(options.columns),
                                .rows = counted(options.rows),
                                .mass = options.mass,
                                .radius = options.radius,
                                .bracing = {options.stiffness, options.damping, options.strength}},
                               "jelly", options.material);
    plan.validate();
    return plan;
}

Blueprint cloth(const ClothOptions& options) {
    requireRange(static_cast<double>(options.radius), 0, 1e6, "radius");
    requireRange(options.columns, 3, 1000, "columns");
    requireRange(options.rows, 3, 1000, "rows");
    Blueprint plan = latticeOf({.size = options.size,
                                .columns = counted(options.columns),
                                .rows = counted(options.rows),
                                .mass = options.mass,
                                .radius = options.radius,
                                .outlineOnly = false,
                                .diagonals = options.diagonals,
                                .bracing = {options.stiffness, options.damping, options.strength}},
                               "cloth", options.material);
    const auto columns = counted(options.columns), rows = counted(options.rows);
    plan.particles[(rows - 1) * columns].pinned = options.pinCorners;
    plan.particles[rows * columns - 1].pinned = options.pinCorners;
    plan.validate();
    return plan;
}

Blueprint wall(const WallOptions& options) {
    requirePositive(static_cast<double>(options.radius), "radius");
    requireRange(options.columns, 1, 999, "columns");
    requireRange(options.rows, 1, 999, "rows");
    const auto columns = counted(options.columns) + 1;
    Blueprint plan = latticeOf({.size = options.size,
                                .columns = columns,
                                .rows = counted(options.rows) + 1,
                                .mass = options.mass,
                                .radius = options.radius,
                                .outlineOnly = false,
                                .bracing = {options.stiffness, options.damping, options.strength}},
                               "wall", options.material);
    for (std::uint32_t i = 0; i < columns; ++i) plan.particles[i].pinned = options.pinBottom;
    plan.validate();
    return plan;
}

}  // namespace sulfur::shapes
