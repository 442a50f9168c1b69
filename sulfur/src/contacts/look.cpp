// Looking at pairs: which of them are due, and what follows for their rows.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "contacts/encounters.hpp"
#include "contacts/looks.hpp"
#include "contacts/pair_table.hpp"
#include "contacts/stages.hpp"
#include "core/pieces.hpp"
#include "core/settings.hpp"
#include "model/state.hpp"
#include "narrow_phase/convex.hpp"
#include "narrow_phase/loose.hpp"
#include "shape/materials.hpp"

namespace sulfur::detail {

namespace {

std::uint32_t denseJoint(const State& state, std::uint32_t slot) {
    return slot == none ? none : state.jointSlots.denseOf(slot);
}

Real mean(Real a, Real b) {
    return a == b ? a : std::sqrt(a * b);
}

}  // namespace

Surfaces surfacesOf(const State& state, std::uint32_t corner, std::uint32_t bodyA,
                    std::uint32_t side, std::uint32_t bodyB) {
    const Shapes& shapes = state.core.shapes;
    const Material& a = surfaceOf(state, denseJoint(state, shapes.corners[corner].surface),
                                  state.bodySlots.denseOf(bodyA));
    const Material& b = surfaceOf(state, denseJoint(state, shapes.sides[side].joint),
                                  state.bodySlots.denseOf(bodyB));
    Surfaces s;
    s.staticFriction = mean(a.staticFriction, b.staticFriction);
    s.kineticFriction = mean(a.kineticFriction, b.kineticFriction);
    s.restitution = std::max(a.restitution, b.restitution);
    s.rolling = std::max(a.rollingResistance, b.rollingResistance);
    s.speed = a.surfaceSpeed + b.surfaceSpeed;
    if (state.settings.friction == Friction::sliding) {
        s.drag = s.kineticFriction;
        s.staticFriction = s.kineticFriction = 0;
    }
    return s;
}

std::array<std::uint32_t, 3> particlesOf(const Shapes& shapes, std::uint32_t corner,
                                         std::uint32_t side) {
    const Side& s = shapes.sides[side];
    return {shapes.corners[corner].particle, shapes.corners[s.a].particle,
            shapes.corners[s.b].particle};
}

const Heir* findHeir(const ContactCore& core, const std::array<std::uint32_t, 3>& particles) {
    for (const Heir& heir : core.heirs)
        if (heir.particles == particles) return &heir;
    return nullptr;
}
void leaveToHeirs(ContactCore& core, const std::array<std::uint32_t, 3>& particles, Real pressing,
                  Real rubbing) {
    if (core.keepsHeirs && (pressing != 0 || rubbing != 0))
        core.heirs.push_back({particles, pressing, rubbing});
}

namespace {

/// The body of a chunk, if it sleeps.
std::uint32_t sleeperOf(const State& state, std::uint32_t chunk) {
    const auto slot = state.core.shapes.chunks[chunk].body;
    return state.bodies[state.bodySlots.denseOf(slot)].asleep ? slot : none;
}

constexpr Real unforeseen = Real(tuned::unforeseen);
/// How many watches a thread asks in a microsecond, about; see piecesOf().
constexpr std::size_t watchesInMicrosecond = 150;

/// What somebody comes near to wakes before it is touched: it never stands in for a wall. What
/// wakes takes part from the next step on. Who is moved by nobody but the caller may rest near it.
void wakeIfNear(State& state, std::uint32_t index, std::uint32_t sleeper) {
    ContactCore& core = state.core;
    const Pair& pair = core.pairs[index];
    const Chunk &a = core.shapes.chunks[pair.a], &b = core.shapes.chunks[pair.b];
    const double odometers = core.movers.odometer[a.frame] + core.movers.odometer[b.frame];
    const Real moving = static_cast<Real>(core.ahead[a.frame] + core.ahead[b.frame] - odometers);
    const Real least = unforeseen * (a.radius + b.radius);
    Real gap = 0;
    if (pair.isManifold) {
        gap = findManifold(core.movers, core.shapes, a, b, moving).gap;
    } else {
        core.knownSides.clear();
        lookLoosely(state, a, b, core.knownSides, core.looseLook);
        gap = core.looseLook.gap;
    }
    const bool near = gap <= 2 * moving + least;
    const Real slack = std::max(gap - moving - least, least / 2);
    const auto other = a.body == sleeper ? b.body : a.body;
    const bool isDynamic = state.bodies[state.bodySlots.denseOf(other)].kind == BodyKind::dynamic;
    const bool wakes = near && (isDynamic || moving > 0);
    if (wakes) core.toWake.push_back(sleeper);
    // Who wakes is looked at again when it is awake.
    watchPair(state, index, wakes ? -1 : odometers + static_cast<double>(slack));
}

}  // namespace

namespace {

/// Its rows and its limit become what they are now.
void lookAtPair(State& state, std::uint32_t pair, const ForeseenManifold& foreseen) {
    const Pair& p = state.core.pairs[pair];
    if (const auto rowless = state.core.encounters[p.encounter].rowless; rowless != 0) {
        dropRows(state, pair);
        return watchPair(state, pair, rowless == Encounter::letPass ? PairWatch::farAway : -1);
    }
    for (const auto chunk : {p.a, p.b})
        if (const auto sleeper = sleeperOf(state, chunk); sleeper != none)
            return wakeIfNear(state, pair, sleeper);
    ++state.statistics.looks;
    if (state.core.pairs[pair].isManifold)
        lookAtManifold(state, pair, foreseen);
    else
        lookAtTouches(state, pair);
}

ForeseenManifold foresee(const State& state, std::uint32_t index) {
    const ContactCore& core = state.core;
    const Pair& pair = core.pairs[index];
    if (!pair.isManifold || core.encounters[pair.encounter].rowless != 0 ||
        sleeperOf(state, pair.a) != none || sleeperOf(state, pair.b) != none)
        return {};
    const auto motionOfChunk = [&](std::uint32_t chunk) {
        return motionNow(core.movers, core.shapes.chunks[chunk].frame);
    };
    return {true, motionOfChunk(pair.a), motionOfChunk(pair.b), manifoldOf(core, pair)};
}

/// Looks at pairs one after the other, because rows come and go. What takes long, the geometry of
/// convex chunks, lent threads find for all of them before.
void lookAtAll(State& state, const std::uint32_t* pairs, std::size_t count) {
    constexpr std::size_t looksInMicrosecond = 1;
    std::pmr::vector<ForeseenManifold> foreseen(&state.arena);
    if (piecesOf(state.tasks, count, looksInMicrosecond) > 1) {
        foreseen.resize(count);
        inPieces(state.tasks, count, looksInMicrosecond, [&](std::size_t first, std::size_t last) {
            for (auto i = first; i < last; ++i) foreseen[i] = foresee(state, pairs[i]);
        });
    }
    for (std::size_t i = 0; i < count; ++i)
        lookAtPair(state, pairs[i], foreseen.empty() ? ForeseenManifold{} : foreseen[i]);
}

}  // namespace

void lookAtListed(State& state) {
    ContactCore& core = state.core;
    auto& listed = core.again;
    const std::size_t most =
        tuned::lookedPairs * std::size_t{state.work.awakeParticles + tuned::fewMovers};
    const auto price = std::accumulate(
        listed.begin(), listed.end(), std::size_t{0},
        [&](std::size_t sum, std::uint32_t pair) { return sum + priceOf(core, core.pairs[pair]); });
    if (price > most) {
        const auto first = static_cast<std::ptrdiff_t>(stepNumber(state) * most % listed.size());
        std::rotate(listed.begin(), listed.begin() + first, listed.end());
    }
    std::size_t count = 0;
    for (std::size_t spent = 0; count < listed.size() && spent < most; ++count)
        spent += priceOf(core, core.pairs[listed[count]]);
    lookAtAll(state, listed.data(), count);
}

void lookAtPairs(State& state) {
    ContactCore& core = state.core;
    // A look may move watches about: those that are due are listed first.
    core.newRows = 0;
    core.again.clear();
    core.findInPieces(
        state.tasks, core.watches.size(), watchesInMicrosecond, 1, core.again,
        [&core](std::size_t first, std::size_t last, std::vector<std::uint32_t>& due) {
            const double* const ahead = core.ahead.data();
            PairWatch* const end = core.watches.data() + last;
            for (PairWatch* w = core.watches.data() + first; w != end; ++w)
                if (!(ahead[w->a] + ahead[w->b] < w->limit) && isDue(core, *w))
                    due.push_back(w->pair);
        });
    lookAtListed(state);
    core.heirs.clear();
}

void keepRows(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    Pair& pair = core.pairs[index];
    if (pair.row) {
        const ManifoldBlock& block = core.rows.manifold(pair.row);
        const auto lane = RowGraph::laneOf(pair.row);
        for (std::size_t k = 0; k < 2; ++k) {
            pair.kept[k] = block.points[k].pressing[lane];
            const Real owner = core.rows.manifoldShape(pair.row).features[k].owner[lane];
            pair.keptNormal[2 * k] = owner * block.points[k].normalX[lane];
            pair.keptNormal[2 * k + 1] = owner * block.points[k].normalY[lane];
        }
        pair.kept[2] = block.rubbing[lane];
        pair.keptPressing = core.rows.pressing(core.rows.manifolds, pair.row);
        const auto place = std::exchange(pair.row, {});
        const auto moved = core.rows.removeManifold(core.movers, place);
        if (moved != none) core.pairs[moved].row = place;
    }
    for (auto t = pair.firstTouch; t != none; t = core.touches[t].next) {
        Touch& touch = core.touches[t];
        if (!touch.row) continue;
        const TouchBlock& block = core.rows.touch(touch.row);
        const auto lane = RowGraph::laneOf(touch.row);
        touch.pressing = block.pressing[lane];
        touch.rubbing = block.rubbing[lane];
        touch.normalX = block.normalX[lane];
        touch.normalY = block.normalY[lane];
        touch.keptPressing = core.rows.pressing(core.rows.touches, touch.row);
        const auto place = std::exchange(touch.row, {});
        const auto moved = core.rows.removeTouch(core.movers, place);
        if (moved != none) core.touches[moved].row = place;
    }
}

void dropRows(State& state, std::uint32_t index) {
    ContactCore& core = state.core;
    Pair& pair = core.pairs[index];
    if (pair.row) {
        const auto place = pair.row;
        const ManifoldBlock& block = core.rows.manifold(place);
        const auto lane = RowGraph::laneOf(place);
        for (std::size_t k = 0; k < 2; ++k)
            leaveToHeirs(core, pair.features[k], block.points[k].pressing[lane],
                         k == 0 ? block.rubbing[lane] : Real(0));
        if (core.rows.pressing(core.rows.manifolds, place)) addPressing(core, pair.encounter, -1);
        pair.row = {};
        const auto moved = core.rows.removeManifold(core.movers, place);
        if (moved != none) core.pairs[moved].row = place;
    } else {
        for (std::size_t k = 0; k < 2; ++k)
            leaveToHeirs(core, pair.features[k], pair.kept[k], k == 0 ? pair.kept[2] : Real(0));
        if (pair.keptPressing) addPressing(core, pair.encounter, -1);
    }
    pair.keptPressing = 0;
    for (auto& f : pair.features) f = {none, none, none};
    pair.kept = {};
    while (pair.firstTouch != none) {
        const auto t = pair.firstTouch;
        pair.firstTouch = core.touches[t].next;
        dropTouch(core, t);
    }
}

}  // namespace sulfur::detail
