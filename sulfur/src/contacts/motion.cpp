// Solver bodies: from the predicted motion of particles and rigid components, and back.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "contacts/contact_core.hpp"
#include "contacts/pair_table.hpp"
#include "contacts/stages.hpp"
#include "core/pieces.hpp"
#include "rigid/grip.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// m and rad, from its reference, beyond which a body gets a new one.
constexpr double farthestFromReference = 0.5, largestTurn = 0.1;

/// How far a body may go before its rows are refreshed, in its least thickness.
const Real refreshWithin = std::getenv("SULFUR_EPS") ? std::atof(std::getenv("SULFUR_EPS")) : 0.25;

void renewReference(Movers& movers, std::uint32_t m, const Point& at, const Point& heading) {
    movers.reference[m] = at;
    movers.referenceHeading[m] = heading;
    movers.heading[m] = {static_cast<Real>(heading[0]), static_cast<Real>(heading[1])};
    movers.refreshAt[m] = -1;
}

/// The angle whose sine is s, for small ones: its series.
double smallAngle(double s) {
    const double q = s * s;
    return s * (1 + q * (1.0 / 6 + q * (3.0 / 40 + q * (15.0 / 336))));
}

void takePose(Movers& movers, std::uint32_t m, const Point& at, const Point& heading) {
    const Point& reference = movers.referenceHeading[m];
    const double s = reference[0] * heading[1] - reference[1] * heading[0];
    const double c = reference[0] * heading[0] + reference[1] * heading[1];
    const Point way = at - movers.reference[m];
    SolverBody& body = movers.bodies[m];
    if (!(std::abs(way[0]) + std::abs(way[1]) < farthestFromReference) || std::abs(s) > largestTurn ||
        c < 0) {
        renewReference(movers, m, at, heading);
        body.x = body.y = body.turn = 0;
        return;
    }
    body.x = static_cast<Real>(way[0]);
    body.y = static_cast<Real>(way[1]);
    body.turn = static_cast<Real>(smallAngle(s));
}

Real stepOf(const Movers& movers, std::uint32_t m) {
    const SolverBody& body = movers.bodies[m];
    return std::abs(body.vx) + std::abs(body.vy) + movers.reach[m] * std::abs(body.spin);
}

void markRows(ContactCore& core, std::uint32_t m) {
    for (auto u = core.movers.firstUse[m]; u != none; u = core.shapes.uses[u].next)
        for (auto at = core.shapes.chunks[core.shapes.uses[u].chunk].firstPair; at != none;) {
            const Pair& pair = core.pairs[at / 2];
            if (pair.row) core.rows.markManifold(pair.row);
            for (auto t = pair.firstTouch; t != none; t = core.touches[t].next)
                core.rows.markTouch(core.touches[t].row);
            at = pair.next[at % 2];
        }
}

bool isFixedChunk(const State& state, const Chunk& chunk) {
    return state.bodies[state.bodySlots.denseOf(chunk.body)].kind == BodyKind::fixed;
}

}  // namespace

void takeMotion(State& state) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    core.ahead.resize(movers.size());
    core.taken.resize(movers.size());
    std::copy(movers.odometer.begin(), movers.odometer.end(), core.ahead.begin());
    for (std::size_t k = 0; k < core.awakeMovers.size(); ++k) {
        const auto m = core.awakeMovers[k];
        const auto i = core.awakeDense[k];
        SolverBody& body = movers.bodies[m];
        Motion3& predicted = core.taken[m];
        if (core.awakeIsCluster[k]) {
            const Cluster& c = state.clusters.list[i];
            takePose(movers, m, c.centre, c.heading);
            predicted = {c.displacement[0], c.displacement[1], static_cast<Real>(c.angle)};
            body.inverseMass = c.inverseMass;
            body.inverseInertia = c.inverseInertia;
        } else {
            const Particles& p = state.particles;
            takePose(movers, m, p.position[i], Point(1, 0));
            predicted = {p.displacement[i][0], p.displacement[i][1], 0};
            body.inverseMass = p.inverseMass[i];
            body.inverseInertia = 0;
        }
        // All that rows give from here on, warm starts too, is what they have in the next step.
        const Motion3 warm = std::exchange(movers.warm[m], {});
        body.vx = predicted.x + warm.x;
        body.vy = predicted.y + warm.y;
        body.spin = predicted.turn + warm.turn;
        core.ahead[m] = movers.odometer[m] + static_cast<double>(stepOf(movers, m));
        if (core.ahead[m] < movers.refreshAt[m]) continue;
        movers.refreshAt[m] =
            core.ahead[m] + static_cast<double>(refreshWithin * movers.fineness[m]);
        markRows(core, m);
    }
    for (const auto c : core.awakeStrips) {
        const Chunk& chunk = core.shapes.chunks[c];
        Real most = 0;
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            most = std::max(most, stepOf(movers, core.shapes.uses[u].mover));
        core.ahead[chunk.frame] = movers.odometer[chunk.frame] + static_cast<double>(most);
    }
}

void updateBoxes(State& state) {
    ContactCore& core = state.core;
    const auto renew = [&](std::uint32_t index) {
        Chunk& chunk = core.shapes.chunks[index];
        const double step = core.ahead[chunk.frame] - core.movers.odometer[chunk.frame];
        std::array<double, 2> low{1e300, 1e300}, high{-1e300, -1e300};
        for (auto k = chunk.firstCorner; k < chunk.firstCorner + chunk.corners; ++k) {
            const Corner& corner = core.shapes.corners[k];
            const SolverBody& body = core.movers.bodies[corner.mover];
            const Heading& h = core.movers.heading[corner.mover];
            const Real cosine = h.cosine - h.sine * body.turn, sine = h.sine + h.cosine * body.turn;
            const Point& from = core.movers.reference[corner.mover];
            const double at[2] = {
                from[0] + static_cast<double>(body.x + cosine * corner.x - sine * corner.y),
                from[1] + static_cast<double>(body.y + sine * corner.x + cosine * corner.y)};
            for (std::size_t axis = 0; axis < 2; ++axis) {
                low[axis] = std::min(low[axis], at[axis]);
                high[axis] = std::max(high[axis], at[axis]);
            }
        }
        // The turn to first order is wrong by half its square times the reach: a hundredth of it.
        const double extent = std::max(high[0] - low[0], high[1] - low[1]) +
                              2 * static_cast<double>(chunk.radius);
        const double room = isFixedChunk(state, chunk) ? 0 : 0.1 * extent + 6 * step;
        const double around = static_cast<double>(chunk.radius) + room + 0.01 * extent;
        core.grid.remove(core.shapes.chunks, index);
        chunk.low = {low[0] - around, low[1] - around};
        chunk.high = {high[0] + around, high[1] + around};
        chunk.leaveAt = core.movers.odometer[chunk.frame] + room;
        core.grid.insert(core.shapes.chunks, index);
        updatePairs(state, index);
    };
    for (const auto c : core.newChunks) renew(c);
    core.newChunks.clear();
    for (const auto c : core.awakeChunks)
        if (core.ahead[core.shapes.chunks[c].frame] >= core.shapes.chunks[c].leaveAt) renew(c);
}

void lookAtPairs(State& state) {
    ContactCore& core = state.core;
    // A look may move watches about: those that are due are listed first.
    core.again.clear();
    for (const Watch2& w : core.watches)
        if (core.ahead[w.a] + core.ahead[w.b] >= w.limit) core.again.push_back(w.pair);
    for (const auto pair : core.again) lookAtPair(state, pair);
    core.heirs.clear();
}

void refreshRows(State& state) {
    ContactCore& core = state.core;
    const RowKernels& kernels = rowKernels();
    SolverBody* bodies = core.movers.bodies.data();
    const PoseView poses{core.movers.reference.data()->data(), core.movers.heading.data()};
    const auto refresh = [&](auto& list, auto&& kernel, auto&& tell) {
        for (std::size_t w = 0; w < list.dirty.size(); ++w)
            for (auto set = std::exchange(list.dirty[w], 0); set != 0; set &= set - 1) {
                const auto k = 64 * w + static_cast<std::size_t>(std::countr_zero(set));
                for (auto lanes = kernel(bodies, poses, list.blocks[k], list.shapes[k]); lanes != 0;
                     lanes &= lanes - 1)
                    tell(list, k, static_cast<std::uint32_t>(std::countr_zero(lanes)));
            }
    };
    for (int round = 0; round < 2; ++round) {
        core.again.clear();
        for (std::uint32_t c = 0; c < RowGraph::colours; ++c) {
            const auto rowsIn = [c](const auto& list, std::size_t block) {
                return c == RowGraph::overflow ? 1 : list.rows - static_cast<std::uint32_t>(
                                                                     block * rowLanes);
            };
            refresh(core.rows.manifolds[c], kernels.refreshManifolds,
                    [&](auto& list, std::size_t k, std::uint32_t lane) {
                        if (lane < rowsIn(list, k)) core.again.push_back(list.shapes[k].pair[lane]);
                    });
            refresh(core.rows.touches[c], kernels.refreshTouches,
                    [&](auto& list, std::size_t k, std::uint32_t lane) {
                        if (lane < rowsIn(list, k))
                            core.again.push_back(core.touches[list.shapes[k].touch[lane]].pair);
                    });
        }
        if (core.again.empty() || round == 1) break;
        std::sort(core.again.begin(), core.again.end());
        core.again.erase(std::unique(core.again.begin(), core.again.end()), core.again.end());
        for (const auto pair : core.again) lookAtPair(state, pair);
    }
}

void sweepRows(State& state, bool last) {
    ContactCore& core = state.core;
    const RowKernels& kernels = rowKernels();
    SolverBody* bodies = core.movers.bodies.data();
    // At 500 Hz a fifth of an overlap goes in a step, and what rubs keeps its place.
    const Real rate = 100 * state.h, fastest = 2 * state.h;
    static const Real holdShare = std::getenv("SULFUR_HOLD") ? std::atof(std::getenv("SULFUR_HOLD")) : 0.2;
    static const Real pushShare = std::getenv("SULFUR_PUSH") ? std::atof(std::getenv("SULFUR_PUSH")) : 0.2;
    const Real creep = state.settings.gravity.norm() * state.h * state.h / 4;
    const SweepSettings push{creep, std::min(rate, pushShare), fastest, std::min(rate, holdShare)};
    for (std::uint32_t c = RowGraph::colours; c-- > 0;) {
        ManifoldList& manifolds = core.rows.manifolds[c];
        TouchList& touches = core.rows.touches[c];
        if (last) {
            kernels.pushManifolds(bodies, manifolds.blocks.data(), manifolds.blocks.size(), push);
            kernels.pushTouches(bodies, touches.blocks.data(), touches.blocks.size(), push);
        } else {
            kernels.sweepManifolds(bodies, manifolds.blocks.data(), manifolds.blocks.size(), push);
            kernels.sweepTouches(bodies, touches.blocks.data(), touches.blocks.size(), push);
        }
    }
}

namespace {

Motion3 motionOf(const State& state, bool isCluster, std::uint32_t i) {
    if (!isCluster) {
        const Vec2& d = state.particles.displacement[i];
        return {d[0], d[1], 0};
    }
    const Cluster& c = state.clusters.list[i];
    return {c.displacement[0], c.displacement[1], static_cast<Real>(c.angle)};
}

}  // namespace

void giveMotion(State& state) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    for (std::size_t k = 0; k < core.awakeMovers.size(); ++k) {
        const auto m = core.awakeMovers[k];
        const auto i = core.awakeDense[k];
        const SolverBody& body = movers.bodies[m];
        const Motion3& taken = core.taken[m];
        const Motion3 given{body.vx - taken.x, body.vy - taken.y, body.spin - taken.turn};
        Motion3& warm = movers.warm[m];
        warm = {warm.x + given.x, warm.y + given.y, warm.turn + given.turn};
        if (core.awakeIsCluster[k]) {
            Cluster& c = state.clusters.list[i];
            c.displacement += Vec2(given.x, given.y);
            if (given.turn == 0) continue;
            c.angle += static_cast<double>(given.turn);
            updateTurn(c);
        } else if (body.inverseMass > 0) {
            state.particles.displacement[i] += Vec2(given.x, given.y);
        }
    }
}

void takeMotionAgain(State& state) {
    ContactCore& core = state.core;
    for (std::size_t k = 0; k < core.awakeMovers.size(); ++k) {
        const auto m = core.awakeMovers[k];
        SolverBody& body = core.movers.bodies[m];
        const Motion3 now = core.taken[m] =
            motionOf(state, core.awakeIsCluster[k] != 0, core.awakeDense[k]);
        body.vx = now.x;
        body.vy = now.y;
        body.spin = now.turn;
    }
}

void endMotion(State& state) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    for (std::size_t k = 0; k < core.awakeMovers.size(); ++k) {
        const auto m = core.awakeMovers[k];
        const auto i = core.awakeDense[k];
        const SolverBody& body = movers.bodies[m];
        if (core.awakeIsCluster[k]) {
            Cluster& c = state.clusters.list[i];
            const Point way = c.centre - movers.reference[m];
            const Point& reference = movers.referenceHeading[m];
            const double s = reference[0] * c.heading[1] - reference[1] * c.heading[0];
            c.shift += Vec2(body.x - static_cast<Real>(way[0]), body.y - static_cast<Real>(way[1]));
            c.twist += static_cast<double>(body.turn - static_cast<Real>(smallAngle(s)));
        } else if (body.inverseMass > 0) {
            Particles& p = state.particles;
            const Point way = p.position[i] - movers.reference[m];
            p.shift[i] +=
                Vec2(body.x - static_cast<Real>(way[0]), body.y - static_cast<Real>(way[1]));
        }
        movers.odometer[m] += static_cast<double>(stepOf(movers, m));
    }
    for (const auto c : core.awakeStrips) {
        const Chunk& chunk = core.shapes.chunks[c];
        Real most = 0;
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            most = std::max(most, stepOf(movers, core.shapes.uses[u].mover));
        movers.odometer[chunk.frame] += static_cast<double>(most);
    }
}

}  // namespace sulfur::detail
