// Looking at a pair: which corners are near which sides, and what follows for its rows.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "collision/materials.hpp"
#include "contacts/contact_core.hpp"
#include "contacts/encounters.hpp"
#include "contacts/pair_table.hpp"
#include "narrow_phase/convex.hpp"
#include "narrow_phase/loose.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

namespace {

/// How surfaces meet.
struct Surface {
    Real staticFriction = 0, kineticFriction = 0, restitution = 0;
    Real speed = 0;  // m/s along the tangent
};

std::uint32_t denseJoint(const State& state, std::uint32_t slot) {
    return slot == none ? none : state.jointSlots.denseOf(slot);
}

Real mean(Real a, Real b) {
    return a == b ? a : std::sqrt(a * b);
}

Surface surfaceOf(const State& state, std::uint32_t corner, std::uint32_t bodyA, std::uint32_t side,
                  std::uint32_t bodyB) {
    const Shapes& shapes = state.core.shapes;
    const Material& a = surfaceOf(state, denseJoint(state, shapes.corners[corner].surface),
                                  state.bodySlots.denseOf(bodyA));
    const Material& b = surfaceOf(state, denseJoint(state, shapes.sides[side].joint),
                                  state.bodySlots.denseOf(bodyB));
    Surface s;
    s.staticFriction = mean(a.staticFriction, b.staticFriction);
    s.kineticFriction = mean(a.kineticFriction, b.kineticFriction);
    s.restitution = std::max(a.restitution, b.restitution);
    s.speed = a.surfaceSpeed + b.surfaceSpeed;
    return s;
}

// --- manifolds --------------------------------------------------------------------------------

/// What one point of a row is about: particles of corner and side.
std::array<std::uint32_t, 3> particlesOf(const Shapes& shapes, std::uint32_t corner,
                                         std::uint32_t side) {
    const Side& s = shapes.sides[side];
    return {shapes.corners[corner].particle, shapes.corners[s.a].particle,
            shapes.corners[s.b].particle};
}

struct OldPoint {
    std::array<std::uint32_t, 3> particles{none, none, none};
    Real pressing = 0;  // kg m
    bool taken = false;
};

/// Of a row about the same particles that went in this step.
const Heir* findHeir(const ContactCore& core, const std::array<std::uint32_t, 3>& particles) {
    for (const Heir& heir : core.heirs)
        if (heir.particles == particles) return &heir;
    return nullptr;
}
void leave(ContactCore& core, const std::array<std::uint32_t, 3>& particles, Real pressing,
           Real rubbing) {
    if (core.keepsHeirs && (pressing != 0 || rubbing != 0))
        core.heirs.push_back({particles, pressing, rubbing});
}

class ManifoldLook {
public:
    ManifoldLook(State& state, std::uint32_t pair)
        : state_(state),
          core_(state.core),
          index_(pair),
          pair_(core_.pairs[pair]),
          a_(core_.shapes.chunks[pair_.a]),
          b_(core_.shapes.chunks[pair_.b]) {}

    void run() {
        const Real thickness = a_.radius + b_.radius;
        const Real near = thickness / 2 + 2 * closing();
        const Manifold m = findManifold(core_.movers, core_.shapes, a_, b_, near);
        if (m.count == 0) {
            dropRows(state_, index_);
            const Real slack = std::max(m.gap - thickness / 4, thickness / 4);
            watchPair(state_, index_,
                      core_.movers.odometer[a_.frame] + core_.movers.odometer[b_.frame] +
                          static_cast<double>(slack));
            return;
        }
        const bool isNew = !pair_.row;
        if (isNew) {
            pair_.row = core_.rows.addManifold(core_.movers, index_, a_.frame, b_.frame);
            if (std::exchange(pair_.keptPressing, 0))
                core_.rows.setPressing(core_.rows.manifolds, pair_.row);
        }
        setPoints(m, isNew);
        setShape(m);
        core_.rows.markManifold(pair_.row);
        // From now on the refresh tells.
        watchPair(state_, index_, 1e300);
    }

private:
    /// m, how far the surfaces may come towards each other in this step.
    Real closing() const {
        const Movers& movers = core_.movers;
        const Motion3 a = motionNow(movers, a_.frame), b = motionNow(movers, b_.frame);
        return std::abs(a.x - b.x) + std::abs(a.y - b.y) +
               movers.reach[a_.frame] * std::abs(a.turn) +
               movers.reach[b_.frame] * std::abs(b.turn);
    }

    void setPoints(const Manifold& m, bool isNew) {
        ManifoldBlock& block = core_.rows.manifold(pair_.row);
        const auto lane = RowGraph::laneOf(pair_.row);
        std::array<OldPoint, 2> old;
        Real rubbing = isNew ? pair_.kept[2] : block.rubbing[lane];
        for (std::size_t k = 0; k < 2; ++k)
            old[k] = {pair_.features[k], isNew ? pair_.kept[k] : block.points[k].pressing[lane],
                      false};
        for (int k = 0; k < m.count; ++k)
            wanted_[static_cast<std::size_t>(k)] = keyOf(m.features[static_cast<std::size_t>(k)]);
        if (!isNew && pair_.features == wanted_) return;
        if (isNew)
            block.rubbing[lane] = rubbing;
        else
            for (int k = 0; k < 2; ++k)
                RowGraph::pressManifold(core_.movers, block, lane, k,
                                        -block.points[k].pressing[lane]);
        pair_.kept = {};
        for (int k = 0; k < 2; ++k) setPoint(m, k, old, block, lane);
    }

    static constexpr std::array<std::uint32_t, 3> noFeature{none, none, none};
    std::array<std::uint32_t, 3> keyOf(const Feature& f) const {
        return particlesOf(core_.shapes, f.corner, f.side);
    }

    void setPoint(const Manifold& m, int k, std::array<OldPoint, 2>& old, ManifoldBlock& block,
                  std::uint32_t lane) {
        ManifoldPoint& p = block.points[k];
        ManifoldFeature& f = core_.rows.manifoldShape(pair_.row).features[k];
        const auto index = static_cast<std::size_t>(k);
        // The refresh turns what a point has from no direction at all to the right one.
        p.pressing[lane] = p.normalX[lane] = p.normalY[lane] = 0;
        p.normalArmA[lane] = p.normalArmB[lane] = 0;
        pair_.features[index] = wanted_[index];
        if (k >= m.count) {
            f.owner[lane] = 0;
            return;
        }
        const Feature& feature = m.features[index];
        const Corner& corner = core_.shapes.corners[feature.corner];
        const Side& side = core_.shapes.sides[feature.side];
        f.cornerX[lane] = corner.x;
        f.cornerY[lane] = corner.y;
        f.outX[lane] = side.outX;
        f.outY[lane] = side.outY;
        f.offset[lane] = side.offset;
        f.middle[lane] = side.middle;
        f.half[lane] = side.half;
        f.owner[lane] = feature.cornerIsB ? Real(1) : Real(-1);
        const Chunk &own = feature.cornerIsB ? b_ : a_, &other = feature.cornerIsB ? a_ : b_;
        f.share[lane] = own.radius / (own.radius + other.radius);
        const Surface surface =
            surfaceOf(state_, feature.corner, own.body, feature.side, other.body);
        block.staticFriction[lane] = surface.staticFriction;
        block.kineticFriction[lane] = surface.kineticFriction;
        block.slip[lane] = -surface.speed * state_.h;
        pair_.restitution = surface.restitution;
        p.pressing[lane] = inherited(wanted_[index], old, block, lane);
    }

    /// The impulse of the same feature, or of one that is no more.
    Real inherited(const std::array<std::uint32_t, 3>& key, std::array<OldPoint, 2>& old,
                   ManifoldBlock& block, std::uint32_t lane) {
        for (OldPoint& o : old)
            if (!o.taken && o.particles == key) {
                o.taken = true;
                return o.pressing;
            }
        if (const Heir* heir = findHeir(core_, key)) {
            block.rubbing[lane] += heir->rubbing;
            return heir->pressing;
        }
        for (OldPoint& o : old)
            if (!o.taken && o.particles != noFeature && o.particles != wanted_[0] &&
                o.particles != wanted_[1]) {
                o.taken = true;
                return o.pressing;
            }
        return 0;
    }

    void setShape(const Manifold& m) {
        ManifoldShape& shape = core_.rows.manifoldShape(pair_.row);
        const auto lane = RowGraph::laneOf(pair_.row);
        shape.thickness[lane] = a_.radius + b_.radius;
        shape.lookX[lane] = m.x;
        shape.lookY[lane] = m.y;
        shape.lookCosine[lane] = m.cosine;
        shape.lookSine[lane] = m.sine;
        shape.reach[lane] = core_.movers.reach[b_.frame];
        shape.margin[lane] = m.margin;
    }

    State& state_;
    ContactCore& core_;
    std::uint32_t index_;
    Pair& pair_;
    const Chunk &a_, &b_;
    std::array<std::array<std::uint32_t, 3>, 2> wanted_{noFeature, noFeature};
};

// --- touches -----------------------------------------------------------------------------------

class TouchLook {
public:
    TouchLook(State& state, std::uint32_t pair)
        : state_(state),
          core_(state.core),
          index_(pair),
          pair_(core_.pairs[pair]),
          a_(core_.shapes.chunks[pair_.a]),
          b_(core_.shapes.chunks[pair_.b]) {}

    void run() {
        static thread_local LooseLook look;
        lookLoosely(state_, a_, b_, look);
        for (auto t = pair_.firstTouch; t != none; t = core_.touches[t].next)
            core_.touches[t].seen = 0;
        fresh_.clear();
        for (const Nearness& n : look.near) see(n);
        dropUnseen();
        watchPair(state_, index_,
                  core_.movers.odometer[a_.frame] + core_.movers.odometer[b_.frame] +
                      static_cast<double>(look.slack));
    }

private:
    void see(const Nearness& n) {
        for (auto t = pair_.firstTouch; t != none; t = core_.touches[t].next) {
            Touch& touch = core_.touches[t];
            if (touch.corner != n.corner || touch.side != n.side || touch.end != n.end) continue;
            touch.seen = 1;
            if (!touch.row) enter(touch, t);
            core_.rows.markTouch(touch.row);
            return;
        }
        add(n);
    }

    void add(const Nearness& n) {
        std::uint32_t slot;
        if (core_.freeTouches.empty()) {
            slot = static_cast<std::uint32_t>(core_.touches.size());
            core_.touches.emplace_back();
        } else {
            slot = core_.freeTouches.back();
            core_.freeTouches.pop_back();
        }
        Touch& touch = core_.touches[slot];
        touch = {index_, n.corner, n.side, n.end, pair_.firstTouch, n.outward, {}, 1};
        if (const Heir* heir = findHeir(core_, particlesOf(core_.shapes, n.corner, n.side))) {
            touch.pressing = heir->pressing;
            touch.rubbing = heir->rubbing;
        }
        pair_.firstTouch = slot;
        fresh_.push_back(slot);
        enter(touch, slot);
    }

    /// Gives a touch its row, with the impulses that it has.
    void enter(Touch& touch, std::uint32_t slot) {
        const Side& side = core_.shapes.sides[touch.side];
        const Corner &corner = core_.shapes.corners[touch.corner],
                     &a = core_.shapes.corners[side.a], &b = core_.shapes.corners[side.b];
        const bool same = a.mover == b.mover;
        touch.row =
            core_.rows.addTouch(core_.movers, slot, corner.mover, a.mover, same ? 0 : b.mover);
        if (std::exchange(touch.keptPressing, 0))
            core_.rows.setPressing(core_.rows.touches, touch.row);
        setRow(touch, corner, a, b, side, same);
    }

    void setRow(const Touch& touch, const Corner& corner, const Corner& a, const Corner& b,
                const Side& side, bool same) {
        TouchBlock& block = core_.rows.touch(touch.row);
        TouchShape& shape = core_.rows.touchShape(touch.row);
        const auto lane = RowGraph::laneOf(touch.row);
        shape.thickness[lane] = corner.radius + side.radius;
        shape.cornerX[lane] = corner.x;
        shape.cornerY[lane] = corner.y;
        shape.aX[lane] = a.x;
        shape.aY[lane] = a.y;
        shape.bX[lane] = b.x;
        shape.bY[lane] = b.y;
        shape.sameBody[lane] = same ? Real(1) : Real(0);
        shape.free[lane] = core_.movers.bodies[corner.mover].inverseInertia > 0 ? Real(0) : Real(1);
        shape.share[lane] = corner.radius / shape.thickness[lane];
        shape.outward[lane] = static_cast<Real>(touch.outward);
        const Real endless = Real(1e18);
        shape.low[lane] = touch.end == 2 ? Real(1) : touch.end == 1 ? -endless : Real(0);
        shape.high[lane] = touch.end == 1 ? Real(0) : touch.end == 2 ? endless : Real(1);
        const bool ofA =
            touch.corner >= a_.firstCorner && touch.corner < a_.firstCorner + a_.corners;
        const Chunk &own = ofA ? a_ : b_, &other = ofA ? b_ : a_;
        const Surface surface = surfaceOf(state_, touch.corner, own.body, touch.side, other.body);
        block.staticFriction[lane] = surface.staticFriction;
        block.kineticFriction[lane] = surface.kineticFriction;
        block.slip[lane] = -surface.speed * state_.h;
        core_.rows.markTouch(touch.row);
        pair_.restitution = surface.restitution;
        block.pressing[lane] = touch.pressing;
        block.rubbing[lane] = touch.rubbing;
    }

    /// A touch that went leaves its impulses to one that came for the same corner, or the same
    /// side.
    void dropUnseen() {
        for (auto t = pair_.firstTouch; t != none; t = core_.touches[t].next) {
            Touch& old = core_.touches[t];
            if (old.seen) continue;
            for (auto& slot : fresh_) {
                if (slot == none) continue;
                const Touch& heir = core_.touches[slot];
                if (heir.corner != old.corner && heir.side != old.side) continue;
                give(old, heir);
                slot = none;
                break;
            }
        }
        for (auto* link = &pair_.firstTouch; *link != none;) {
            const auto t = *link;
            if (core_.touches[t].seen) {
                link = &core_.touches[t].next;
                continue;
            }
            *link = core_.touches[t].next;
            dropTouch(core_, t);
        }
    }

    void give(const Touch& from, const Touch& to) {
        if (!from.row) return;
        const TouchBlock& old = core_.rows.touch(from.row);
        TouchBlock& block = core_.rows.touch(to.row);
        const auto f = RowGraph::laneOf(from.row), t = RowGraph::laneOf(to.row);
        // The refresh turns what the row has from no direction at all to the right one.
        block.pressing[t] = old.pressing[f];
        block.rubbing[t] = old.rubbing[f];
    }

public:
    static void dropTouch(ContactCore& core, std::uint32_t t) {
        const Touch touch = core.touches[t];
        const auto particles = particlesOf(core.shapes, touch.corner, touch.side);
        if (touch.row) {
            const TouchBlock& block = core.rows.touch(touch.row);
            const auto lane = RowGraph::laneOf(touch.row);
            leave(core, particles, block.pressing[lane], block.rubbing[lane]);
            if (core.rows.pressing(core.rows.touches, touch.row))
                addPressing(core, core.pairs[touch.pair].encounter, -1);
            const auto moved = core.rows.removeTouch(core.movers, touch.row);
            if (moved != none) core.touches[moved].row = touch.row;
        } else {
            leave(core, particles, touch.pressing, touch.rubbing);
            if (touch.keptPressing) addPressing(core, core.pairs[touch.pair].encounter, -1);
        }
        core.touches[t] = {};
        core.freeTouches.push_back(t);
    }

private:
    State& state_;
    ContactCore& core_;
    std::uint32_t index_;
    Pair& pair_;
    const Chunk &a_, &b_;
    std::vector<std::uint32_t> fresh_;
};

}  // namespace

namespace {

/// The body of a chunk, if it sleeps.
std::uint32_t sleeperOf(const State& state, std::uint32_t chunk) {
    const auto slot = state.core.shapes.chunks[chunk].body;
    return state.bodies[state.bodySlots.denseOf(slot)].asleep ? slot : none;
}

/// What somebody comes near to wakes before it is touched: it never stands in for a wall.
void wakeIfNear(State& state, std::uint32_t index, std::uint32_t sleeper) {
    ContactCore& core = state.core;
    const Pair& pair = core.pairs[index];
    const Chunk &a = core.shapes.chunks[pair.a], &b = core.shapes.chunks[pair.b];
    const double odometers = core.movers.odometer[a.frame] + core.movers.odometer[b.frame];
    const auto moving = core.ahead[a.frame] + core.ahead[b.frame] - odometers;
    const Real thickness = a.radius + b.radius;
    Real slack = 0;
    bool near = false;
    if (pair.isManifold) {
        const Real reach = thickness / 2 + 2 * static_cast<Real>(moving);
        const Manifold m = findManifold(core.movers, core.shapes, a, b, reach);
        near = m.count > 0;
        slack = std::max(m.gap - thickness / 4, thickness / 4);
    } else {
        static thread_local LooseLook look;
        lookLoosely(state, a, b, look);
        near = !look.near.empty();
        slack = look.slack;
    }
    if (near) core.toWake.push_back(sleeper);
    watchPair(state, index, odometers + static_cast<double>(slack));
}

}  // namespace

void lookAtPair(State& state, std::uint32_t pair) {
    const Pair& p = state.core.pairs[pair];
    for (const auto chunk : {p.a, p.b})
        if (const auto sleeper = sleeperOf(state, chunk); sleeper != none)
            return wakeIfNear(state, pair, sleeper);
    ++state.statistics.plannedContacts;
    if (state.core.pairs[pair].isManifold)
        ManifoldLook(state, pair).run();
    else
        TouchLook(state, pair).run();
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
            leave(core, pair.features[k], block.points[k].pressing[lane],
                  k == 0 ? block.rubbing[lane] : Real(0));
        if (core.rows.pressing(core.rows.manifolds, place)) addPressing(core, pair.encounter, -1);
        pair.row = {};
        const auto moved = core.rows.removeManifold(core.movers, place);
        if (moved != none) core.pairs[moved].row = place;
    } else {
        for (std::size_t k = 0; k < 2; ++k)
            leave(core, pair.features[k], pair.kept[k], k == 0 ? pair.kept[2] : Real(0));
        if (pair.keptPressing) addPressing(core, pair.encounter, -1);
    }
    pair.keptPressing = 0;
    for (auto& f : pair.features) f = {none, none, none};
    pair.kept = {};
    while (pair.firstTouch != none) {
        const auto t = pair.firstTouch;
        pair.firstTouch = core.touches[t].next;
        TouchLook::dropTouch(core, t);
    }
}

}  // namespace sulfur::detail
