// Solver bodies: from the predicted motion of particles and rigid components, and back.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <utility>

#include "bodies/driven.hpp"
#include "contacts/looks.hpp"
#include "contacts/stages.hpp"
#include "core/pieces.hpp"
#include "core/settings.hpp"
#include "model/contact_core.hpp"
#include "model/slow_speeds.hpp"
#include "model/state.hpp"
#include "rigid/cluster_motion.hpp"
#include "rigid/grip.hpp"
#include "shape/bends.hpp"

namespace sulfur::detail {

namespace {

using tuned::farthestFromReference;
using tuned::largestTurn;
constexpr Real refreshWithin = Real(tuned::refreshWithin);
constexpr Real pushRate = Real(tuned::recoveryRate);
constexpr Real pushSpeed = Real(tuned::recoverySpeed);
constexpr Real mostShare = Real(tuned::recoveryShare);

// How much a thread does in a microsecond, about; see piecesOf().
constexpr std::size_t moversInMicrosecond = 30, sweptInMicrosecond = 8;
/// Blocks whose marks are in one word, and how many words are refreshed in a microsecond.
constexpr std::size_t marks = 64, wordsInMicrosecond = 1;

/// The angle whose sine is s, for small ones: its series.
double smallAngle(double s) {
    const double q = s * s;
    return s * (1 + q * (1.0 / 6 + q * (3.0 / 40 + q * (15.0 / 336))));
}

/// Where and how a mover is, its masses, and how it moves in this step. (Numbers, not vectors, so
/// that all of it stays in registers.)
struct Seen {
    double x = 0, y = 0, cosine = 1, sine = 0;
    Real wayX = 0, wayY = 0, turn = 0;
    Real inverseMass = 0, inverseInertia = 0;
};
inline Seen lookAt(const Cluster& c) {
    return {c.centre[0],
            c.centre[1],
            c.heading[0],
            c.heading[1],
            c.displacement[0],
            c.displacement[1],
            static_cast<Real>(c.angle),
            c.inverseMass,
            c.inverseInertia};
}
[[gnu::noinline]] Seen lookAtParticle(const State& state, std::uint32_t i) {
    Seen seen;
    seen.x = state.particles.position[i][0];
    seen.y = state.particles.position[i][1];
    seen.wayX = state.particles.displacement[i][0];
    seen.wayY = state.particles.displacement[i][1];
    seen.inverseMass = state.particles.inverseMass[i];
    // Its corners rub at their surface, which turns with it.
    const BodyRecord& body = state.bodies[state.particles.body[i]];
    if (body.kind == BodyKind::kinematic) {
        seen.turn = static_cast<Real>(turnOf(state, body));
        if (body.frame != none) {  // all of it stands on this mover
            const Point heading = headingOfWhole(state, body);
            seen.cosine = heading[0];
            seen.sine = heading[1];
        }
    }
    return seen;
}
inline Seen lookAtMover(const State& state, bool isCluster, std::uint32_t i) {
    return isCluster ? lookAt(state.clusters.list[i]) : lookAtParticle(state, i);
}

/// A body takes up where a mover is. Returns whether it has got a new reference.
inline bool takePose(SolverBody& body, Reference& r, const Seen& seen) {
    const double c = r.cosine * seen.cosine + r.sine * seen.sine;
    const double turn = smallAngle(r.cosine * seen.sine - r.sine * seen.cosine);
    const double x = seen.x - r.x, y = seen.y - r.y;
    body.inverseMass = seen.inverseMass;
    body.inverseInertia = seen.inverseInertia;
    if (!(std::abs(x) + std::abs(y) < farthestFromReference) || std::abs(turn) > largestTurn ||
        c < 0) {
        r = {seen.x, seen.y, seen.cosine, seen.sine};
        body.x = body.y = body.turn = 0;
        return true;
    }
    body.x = static_cast<Real>(x);
    body.y = static_cast<Real>(y);
    body.turn = static_cast<Real>(turn);
    return false;
}

/// m, that any of a mover's surface goes at most.
inline Real lengthOf(Real reach, Real x, Real y, Real turn) {
    return std::abs(x) + std::abs(y) + reach * std::abs(turn);
}
inline Real lengthOf(const Movers& movers, std::uint32_t m, Real x, Real y, Real turn) {
    return lengthOf(movers.reach[m], x, y, turn);
}

/// Odometers of chunks whose corners move by themselves go as far as the farthest of these.
template <class Length>
void noteStrips(const ContactCore& core, std::vector<double>& odometers, Length&& lengthOfMover) {
    for (const auto c : core.awakeStrips) {
        const Chunk& chunk = core.shapes.chunks[c];
        Real most = 0;
        for (auto u = chunk.firstUse; u < chunk.firstUse + chunk.uses; ++u)
            most = std::max(most, lengthOfMover(core.shapes.uses[u].mover));
        odometers[chunk.frame] = core.movers.odometer[chunk.frame] + static_cast<double>(most);
    }
}

/// Whether somebody of a block has moved so far that its rows are refreshed.
bool hasMoved(const std::uint8_t* moved, const ManifoldBlock& r) {
    for (std::size_t l = 0; l < rowLanes; ++l)
        if ((moved[r.a[l]] | moved[r.b[l]]) != 0) return true;
    return false;
}
bool hasMoved(const std::uint8_t* moved, const TouchBlock& r) {
    for (std::size_t l = 0; l < rowLanes; ++l)
        if ((moved[r.p[l]] | moved[r.a[l]] | moved[r.b[l]]) != 0) return true;
    return false;
}

/// Impulses and ways are kept for steps of one length.
void scaleImpulses(ContactCore& core, double step) {
    const double before = std::exchange(core.lastStep, step);
    if (before == step || before == 0) return;
    const Real share = static_cast<Real>(step / before * (step / before));
    const auto scale = [&](Lane& lane) {
        for (Real& value : lane) value *= share;
    };
    for (ManifoldList& list : core.rows.manifolds)
        for (ManifoldBlock& block : list.blocks) {
            scale(block.rubbing);
            for (ManifoldPoint& point : block.points) scale(point.pressing);
        }
    for (TouchList& list : core.rows.touches)
        for (TouchBlock& block : list.blocks) {
            scale(block.pressing);
            scale(block.rubbing);
        }
    for (SolverBody& body : core.movers.bodies) {
        body.vx *= share;
        body.vy *= share;
        body.spin *= share;
    }
    const Real longer = static_cast<Real>(step / before);
    for (BodyWay& way : core.ways) {
        way.x *= longer;
        way.y *= longer;
        way.turn *= longer;
    }
}

/// Whether a network takes back most of what rows give: one sees only where it goes without both.
bool isOfNetwork(const State& state, bool isCluster, std::uint32_t i) {
    const Trees& trees = state.trees;
    const auto tree = isCluster ? trees.ofCluster[i] : trees.ofParticle[i];
    return tree != none && trees.list[tree].network != none;
}

/// Of the awake movers from `first` to `last`. Returns how far the farthest goes without rows, m.
Real takeMotionOf(State& state, std::size_t first, std::size_t last) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    // (Local, because a byte that is written may alias any member.)
    std::uint8_t* const moved = core.moved.data();
    double* const aheads = core.ahead.data();
    Motion3* const placed = core.placed.data();
    const bool withNetworks = !state.trees.factors.empty();
    Real farthest = 0;
    for (std::size_t k = first; k < last; ++k) {
        const auto m = core.awakeMovers[k];
        const Seen seen = lookAtMover(state, core.awakeIsCluster[k] != 0, core.awakeDense[k]);
        SolverBody& body = movers.bodies[m];
        const bool anew = takePose(body, movers.references[m], seen);
        placed[m] = {body.x, body.y, body.turn};
        // What rows gave in the last step is with what they begin in this one.
        Motion3 goes{seen.wayX + body.vx, seen.wayY + body.vy, seen.turn + body.spin};
        if (withNetworks && isOfNetwork(state, core.awakeIsCluster[k] != 0, core.awakeDense[k]))
            goes = {seen.wayX, seen.wayY, seen.turn};
        movers.predictions[m] = {seen.wayX, seen.wayY, seen.turn, 0, goes.x, goes.y, goes.turn, 0};
        const Real reach = movers.reach[m];
        farthest = std::max(farthest, lengthOf(reach, seen.wayX, seen.wayY, seen.turn));
        const double ahead =
            movers.odometer[m] + static_cast<double>(lengthOf(reach, goes.x, goes.y, goes.turn));
        aheads[m] = ahead;
        if (!anew && ahead < movers.refreshAt[m]) continue;
        movers.refreshAt[m] = ahead + static_cast<double>(refreshWithin * movers.fineness[m]);
        moved[m] = 1;
    }
    return farthest;
}

}  // namespace

void takeMotion(State& state) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    scaleImpulses(core, static_cast<double>(state.h));
    core.ahead = movers.odometer;
    core.moved.assign(movers.size(), 0);
    core.placed.resize(movers.size());
    core.farthest = mostInPieces(
        state.tasks, core.awakeMovers.size(), moversInMicrosecond,
        [&](std::size_t first, std::size_t last) { return takeMotionOf(state, first, last); });
    noteStrips(core, core.ahead, [&](std::uint32_t m) {
        const Prediction& p = movers.predictions[m];
        return lengthOf(movers, m, p.goesX, p.goesY, p.turn);
    });
}

namespace {

/// What rows give each mover is summed anew in every step: what was added and taken away again
/// would leave roundings.
void beginSums(ContactCore& core) {
    for (const auto m : core.awakeMovers) {
        SolverBody& body = core.movers.bodies[m];
        body.vx = body.vy = body.spin = 0;
    }
}

std::uint32_t pairOf(const ContactCore&, const ManifoldShape& shape, std::uint32_t lane) {
    return shape.pair[lane];
}
std::uint32_t pairOf(const ContactCore& core, const TouchShape& shape, std::uint32_t lane) {
    return core.touches[shape.touch[lane]].pair;
}

/// Refreshes the blocks of a list of one colour that are marked, or of which somebody has moved,
/// and notes the pairs that must be looked at again. `give`: what blocks do that need no refresh,
/// or nullptr, when only marked ones are refreshed.
template <class List, class Refresh, class Give>
void refreshList(State& state, List& list, std::uint32_t colour, Refresh refresh, Give give) {
    ContactCore& core = state.core;
    SolverBody* bodies = core.movers.bodies.data();
    const PoseView poses{core.movers.references.data(), core.movers.predictions.data()};
    const std::uint8_t* const moved = core.moved.data();
    const auto refreshBlock = [&](std::size_t k, std::vector<std::uint32_t>& again) {
        std::uint64_t& dirty = list.dirty[k / marks];
        const std::uint64_t bit = std::uint64_t{1} << k % marks;
        const bool marked = (dirty & bit) != 0;
        if (!marked && !(give && hasMoved(moved, list.blocks[k]))) {
            if (give) give(bodies, list.blocks[k]);
            return;
        }
        dirty &= ~bit;
        auto lanes = refresh(bodies, poses, list.blocks[k], list.shapes[k]);
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
            if (lane < RowGraph::rowsIn(list, colour, k))
                again.push_back(pairOf(core, list.shapes[k], lane));
        }
    };
    // Rows of the last colour may have bodies in common.
    Tasks* const tasks = colour == RowGraph::overflow ? nullptr : state.tasks;
    const std::size_t blocks = list.blocks.size(), words = (blocks + marks - 1) / marks;
    core.findInPieces(tasks, words, wordsInMicrosecond, marks * rowLanes, core.again,
                      [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& again) {
                          for (auto k = first * marks; k < std::min(last * marks, blocks); ++k)
                              refreshBlock(k, again);
                      });
}

}  // namespace

void refreshRows(State& state) {
    ContactCore& core = state.core;
    const RowKernels& kernels = rowKernels();
    beginSums(core);
    for (const bool anew : {true, false}) {
        core.again.clear();
        for (const auto c : core.rows.inUse()) {
            refreshList(state, core.rows.manifolds[c], c, kernels.refreshManifolds[anew],
                        anew ? kernels.giveManifolds : nullptr);
            refreshList(state, core.rows.touches[c], c, kernels.refreshTouches[anew],
                        anew ? kernels.giveTouches : nullptr);
        }
        if (core.again.empty() || !anew) break;
        std::sort(core.again.begin(), core.again.end());
        core.again.erase(std::unique(core.again.begin(), core.again.end()), core.again.end());
        lookAtListed(state);
    }
}

namespace {

/// Sweeps the blocks of a list of one colour. No two of them push the same body, and what cannot be
/// pushed none of them writes.
template <class Block>
bool sweepList(Tasks* tasks, ContactCore& core, std::vector<Block>& blocks,
               bool (*sweep)(SolverBody*, const Prediction*, Block*, std::size_t,
                             const SweepSettings&),
               const SweepSettings& settings) {
    SolverBody* const bodies = core.movers.bodies.data();
    const Prediction* const predictions = core.movers.predictions.data();
    return anyInPieces(
        tasks, blocks.size(), sweptInMicrosecond, [&](std::size_t first, std::size_t last) {
            return sweep(bodies, predictions, blocks.data() + first, last - first, settings);
        });
}

}  // namespace

bool sweepRows(State& state, int number, SweepKind kind) {
    ContactCore& core = state.core;
    const RowKernels& kernels = rowKernels();
    if (number == 1) core.stirred.assign(core.movers.size(), 0);
    core.sweep = static_cast<std::uint8_t>(number);
    const SlowSpeeds slow = slowSpeedsOf(state.settings);
    const SweepSettings settings{slow.creep * state.h,
                                 std::min(pushRate * state.h, mostShare),
                                 slow.settledChange * state.h,
                                 core.stirred.data(),
                                 core.sweep,
                                 kind};
    bool any = false;
    // From the last colour, so that the first rows of each body, on which it rests, are solved
    // last.
    for (auto left = core.rows.inUse().bits(); left != 0;) {
        const auto c = static_cast<std::uint32_t>(std::bit_width(left)) - 1;
        left ^= std::uint64_t{1} << c;
        // Rows of the last colour may have bodies in common.
        Tasks* const tasks = c == RowGraph::overflow ? nullptr : state.tasks;
        any |=
            sweepList(tasks, core, core.rows.manifolds[c].blocks, kernels.sweepManifolds, settings);
        any |= sweepList(tasks, core, core.rows.touches[c].blocks, kernels.sweepTouches, settings);
    }
    return any;
}

namespace {

/// What rows have given a body since it last told. What rounding keeps back is given the next time,
/// so that no momentum is lost.
inline void giveTo(Vec2& displacement, const Motion3& more, Motion3& given) {
    // (Written at once, because it is soon read at once.)
    const Vec2 before = displacement, now = before + Vec2(more.x, more.y);
    displacement = now;
    given.x += now[0] - before[0];
    given.y += now[1] - before[1];
}
inline bool isNothing(const Motion3& m) {
    return std::abs(m.x) + std::abs(m.y) + std::abs(m.turn) == 0;
}
inline Motion3 moreThan(const Motion3& given, const SolverBody& body) {
    return {body.vx - given.x, body.vy - given.y, body.spin - given.turn};
}

/// A rigid component takes that up. `turns`: somebody asks for sines.
inline void give(Cluster& c, const SolverBody& body, Motion3& given, bool turns) {
    const Motion3 more = moreThan(given, body);
    if (isNothing(more)) return;
    giveTo(c.displacement, more, given);
    if (more.turn == 0) return;
    given.turn = body.spin;
    c.angle += static_cast<double>(more.turn);
    if (turns) updateTurn(c);
}
void give(State& state, bool isCluster, std::uint32_t i, std::uint32_t m, bool turns) {
    const SolverBody& body = state.core.movers.bodies[m];
    Motion3& given = state.core.movers.given[m];
    if (isCluster) return give(state.clusters.list[i], body, given, turns);
    const Motion3 more = moreThan(given, body);
    if (isNothing(more)) return;
    if (body.inverseMass > 0) giveTo(state.particles.displacement[i], more, given);
}

}  // namespace

void giveMotion(State& state) {
    const bool turns = !onlyContactsAsk(state);
    const ContactCore& core = state.core;
    for (const auto m : core.tied)
        give(state, core.moverIsCluster[m] != 0, core.denseOfMover[m], m, turns);
}

void takeMotionOfTied(State& state, int number) {
    ContactCore& core = state.core;
    const Real settled = slowSpeedsOf(state.settings).settledChange * state.h;
    for (const auto m : core.tied) {
        const Seen seen = lookAtMover(state, core.moverIsCluster[m] != 0, core.denseOfMover[m]);
        const Motion3& given = core.movers.given[m];
        Prediction& prediction = core.movers.predictions[m];
        const Motion3 now{seen.wayX - given.x, seen.wayY - given.y, seen.turn - given.turn};
        const Real changed = lengthOf(core.movers, m, now.x - prediction.vx, now.y - prediction.vy,
                                      now.turn - prediction.spin);
        // What does not change how surfaces part is left for later.
        if (number > 1 && changed <= settled) continue;
        prediction.vx = now.x;
        prediction.vy = now.y;
        prediction.spin = now.turn;
        if (number > 1) core.stirred[m] = static_cast<std::uint8_t>(number - 1);
    }
}

void takeMotionAgain(State& state) {
    ContactCore& core = state.core;
    for (std::size_t k = 0; k < core.awakeMovers.size(); ++k) {
        const auto m = core.awakeMovers[k];
        const Seen seen = lookAtMover(state, core.awakeIsCluster[k] != 0, core.awakeDense[k]);
        const Motion3& given = core.movers.given[m];
        Prediction& prediction = core.movers.predictions[m];
        prediction.vx = seen.wayX - given.x;
        prediction.vy = seen.wayY - given.y;
        prediction.spin = seen.turn - given.turn;
    }
}

namespace {

/// What the first sweep has moved apart goes to the state, no faster than a limit.
void pushOut(State& state, std::size_t k, const Motion3& motion, Real restingPush) {
    Vec2 pushed(motion.x, motion.y);
    Real turned = motion.turn;
    ContactCore& core = state.core;
    const auto m = core.awakeMovers[k];
    const auto i = core.awakeDense[k];
    const Real most = pushSpeed * state.h, around = core.movers.reach[m] * std::abs(turned);
    if (std::abs(pushed[0]) + std::abs(pushed[1]) + around > most) {
        const Real within = std::min<Real>(most / (pushed.norm() + around), 1);
        pushed *= within;
        turned *= within;
    }
    core.movers.odometer[m] +=
        static_cast<double>(lengthOf(core.movers, m, pushed[0], pushed[1], turned));
    if (core.awakeIsCluster[k] != 0) {
        state.clusters.list[i].shift += pushed;
        state.clusters.list[i].twist += static_cast<double>(turned);
    } else if (core.movers.bodies[m].inverseMass > 0) {
        state.particles.position[i] += pushed.cast<double>();
    }
    // What is pushed apart does not rest. (Several of one body may say so at once.)
    const Real rests = restingPush * state.h;
    if (state.settings.sleeping && pushed.squaredNorm() > rests * rests)
        std::atomic_ref(state.bodies[state.bodySlots.denseOf(core.movers.body[m])].restingTime)
            .store(-state.h, std::memory_order_relaxed);
}

/// Of the awake movers from `first` to `last`.
void endMotionOf(State& state, std::size_t first, std::size_t last) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    const bool asked = !onlyContactsAsk(state);
    const Real restingPush = slowSpeedsOf(state.settings).restingPush;
    for (std::size_t k = first; k < last; ++k) {
        const auto m = core.awakeMovers[k];
        const bool isCluster = core.awakeIsCluster[k] != 0;
        give(state, isCluster, core.awakeDense[k], m, asked);
        const Seen seen = lookAtMover(state, isCluster, core.awakeDense[k]);
        const Real reach = movers.reach[m];
        const Real length = lengthOf(reach, seen.wayX, seen.wayY, seen.turn);
        core.ways[m] = {seen.wayX, seen.wayY, seen.turn, reach * std::abs(seen.turn)};
        core.lengths[m] = length;
        movers.odometer[m] += static_cast<double>(length);
        // What the next step begins with is given anew, with what has been kept back.
        const SolverBody& body = movers.bodies[m];
        Motion3& given = movers.given[m];
        given = {given.x - body.vx, given.y - body.vy, given.turn - body.spin};
        const Motion3& placed = core.placed[m];
        const Motion3 pushed{body.x - placed.x, body.y - placed.y, body.turn - placed.turn};
        if (!isNothing(pushed)) pushOut(state, k, pushed, restingPush);
    }
}

}  // namespace

void endMotion(State& state) {
    ContactCore& core = state.core;
    Movers& movers = core.movers;
    core.ways.assign(movers.size(), {});
    core.lengths.assign(movers.size(), 0);
    inPieces(state.tasks, core.awakeMovers.size(), moversInMicrosecond,
             [&](std::size_t first, std::size_t last) { endMotionOf(state, first, last); });
    noteStrips(core, movers.odometer, [&](std::uint32_t m) { return core.lengths[m]; });
}

}  // namespace sulfur::detail
