// What sweeps cannot solve, brakes: a tree or network, and what presses on it, go on as one.
#include <algorithm>
#include <array>
#include <memory_resource>
#include <vector>

#include "contacts/touch_rows.hpp"
#include "rigid/grip.hpp"
#include "trees/tree_solver.hpp"

namespace sulfur::detail {

namespace {

struct Part {
    std::uint32_t cluster, particle;
    Vec2 predicted{0, 0};  // m, of a particle
};
using Parts = std::pmr::vector<Part>;

/// Movers that press on a tree and are no nodes of it, in order.
std::pmr::vector<std::uint32_t> pressing(State& state, std::span<const std::uint32_t> trees,
                                         std::span<const std::uint32_t> touches) {
    const auto isNode = [&](std::uint32_t particle) {
        const auto of = state.trees.of(state.particles.cluster[particle], particle);
        return of != none && std::find(trees.begin(), trees.end(), of) != trees.end();
    };
    std::pmr::vector<std::uint32_t> movers(&state.arena);
    for (const auto touch : touches) {
        const TouchView t = viewOfTouch(state, touch);
        if (!(t.pressing > 0 || t.gap < std::min(t.gapBefore, Real(0)))) continue;
        for (std::size_t k = 0; k < 3; ++k)
            if (!isNode(t.particles[k]) && state.core.denseOfMover[t.movers[k]] != none)
                movers.push_back(t.movers[k]);
    }
    std::sort(movers.begin(), movers.end());
    movers.erase(std::unique(movers.begin(), movers.end()), movers.end());
    return movers;
}

/// Nodes of a tree, and what presses on them.
Parts partsOf(State& state, std::span<const std::uint32_t> trees,
              std::span<const std::uint32_t> touches) {
    Parts parts(&state.arena);
    for (const auto t : trees)
        for (auto i = state.trees.list[t].first; i < state.trees.list[t].last; ++i) {
            const TreeNode& n = state.trees.nodes[i];
            parts.push_back({n.cluster, n.particle, state.trees.predicted[i]});
        }
    const double h = static_cast<double>(state.h);
    for (const auto m : pressing(state, trees, touches)) {
        const auto dense = state.core.denseOfMover[m];
        if (state.core.moverIsCluster[m] != 0)
            parts.push_back({dense, none});
        else
            parts.push_back({none, dense, (h * state.particles.velocity[dense]).cast<Real>()});
    }
    return parts;
}

/// Whether they move with more energy than when the sweeps began.
bool gain(const State& state, const Parts& parts) {
    double gained = 0;  // kg m^2, in units of the step's length
    const auto add = [&](Real inverseMass, double before, double now) {
        if (inverseMass > 0) gained += (now - before) / static_cast<double>(inverseMass);
    };
    const auto square = [](const Vec2& way) { return static_cast<double>(way.squaredNorm()); };
    for (const auto& [cluster, particle, predicted] : parts) {
        if (cluster != none) {
            const Cluster& c = state.clusters.list[cluster];
            add(c.inverseMass, square(c.predicted), square(c.displacement));
            add(c.inverseInertia, c.predictedAngle * c.predictedAngle, c.angle * c.angle);
        } else if (particle != none) {
            add(state.particles.inverseMass[particle], square(predicted),
                square(state.particles.displacement[particle]));
        }
    }
    return gained > 0;
}

/// The motion (m, in this step) of all parts as one: that of what stands fast or is driven, else
/// the one that keeps their momentum.
Vec2 commonWay(const State& state, const Parts& parts) {
    Point momentum(0, 0), standing(0, 0);
    double mass = 0, fixed = 0;
    for (const auto& [cluster, particle, predicted] : parts) {
        const bool isCluster = cluster != none;
        if (!isCluster && particle == none) {
            ++fixed;  // what an attachment holds to stands fast here
            continue;
        }
        const Point way = (isCluster ? state.clusters.list[cluster].displacement
                                     : state.particles.displacement[particle])
                              .cast<double>();
        const auto w = static_cast<double>(isCluster ? state.clusters.list[cluster].inverseMass
                                                     : state.particles.inverseMass[particle]);
        (w > 0 ? momentum : standing) += w > 0 ? Point(way / w) : way;
        (w > 0 ? mass : fixed) += w > 0 ? 1 / w : 1;
    }
    return (fixed > 0 ? Point(standing / fixed) : Point(momentum / mass)).cast<Real>();
}

}  // namespace

bool brake(State& state, std::span<const std::uint32_t> trees,
           std::span<const std::uint32_t> touches, Brake when) {
    const Parts parts = partsOf(state, trees, touches);
    if (when == Brake::ifItGains && !gain(state, parts)) return false;
    const Vec2 way = commonWay(state, parts);
    for (const auto& [cluster, particle, predicted] : parts) {
        if (cluster != none) {
            Cluster& c = state.clusters.list[cluster];
            if (c.inverseMass > 0) c.displacement = way;
            if (c.inverseInertia > 0) turnBy(c, -c.angle);
        } else if (particle != none && state.particles.inverseMass[particle] > 0) {
            state.particles.displacement[particle] = way;
        }
    }
    for (const auto touch : touches) {
        const TouchView t = viewOfTouch(state, touch);
        pressFromOutside(state, touch, -t.pressing, -t.rubbing, {true, true, true});
    }
    // What other rows have pushed and not moved yet is not to come on top of it.
    Movers& movers = state.core.movers;
    for (const auto& [cluster, particle, predicted] : parts) {
        if (cluster == none && particle == none) continue;
        const auto m =
            cluster != none ? moverOfCluster(state, cluster) : moverOfParticle(state, particle);
        if (m == none) continue;
        const SolverBody& body = movers.bodies[m];
        movers.given[m] = {body.vx, body.vy, body.spin};
    }
    return true;
}

}  // namespace sulfur::detail
