// A row for each corner that is near a side.
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "contacts/encounters.hpp"
#include "contacts/looks.hpp"
#include "contacts/pair_table.hpp"
#include "core/settings.hpp"
#include "model/state.hpp"
#include "narrow_phase/loose.hpp"

namespace sulfur::detail {

namespace {

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
        auto& known = core_.knownSides;
        known.clear();
        for (auto t = pair_.firstTouch; t != none; t = core_.touches[t].next) {
            Touch& touch = core_.touches[t];
            touch.seen = 0;
            if (touch.end == 0) known.push_back({touch.corner, touch.side, touch.outward});
        }
        LooseLook& look = core_.looseLook;
        lookLoosely(state_, a_, b_, known, look);
        if (look.near.size() > 1 && isCrowdOfRows()) keepNearest(look.near);
        fresh_.clear();
        for (const Nearness& n : look.near) see(n);
        dropUnseen();
        if (a_.uses == 1 && b_.uses == 1) return watchApart(state_, index_, look.slack);
        watchPair(state_, index_,
                  core_.movers.odometer[a_.frame] + core_.movers.odometer[b_.frame] +
                      static_cast<double>(look.slack));
    }

private:
    bool isCrowdOfRows() const {
        return core_.rows.size() >
               tuned::crowdedRows * (core_.awakeMovers.size() + tuned::fewMovers);
    }
    static void keepNearest(std::vector<Nearness>& near) {
        const auto place = [](const Nearness& n) {
            return std::tuple(n.far, n.corner, n.side, n.end);
        };
        near.front() = *std::min_element(
            near.begin(), near.end(),
            [&](const Nearness& a, const Nearness& b) { return place(a) < place(b); });
        near.resize(1);
    }

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
        // An end may be thicker than its side, by a joint to another body.
        const Real radius = touch.end == 0 ? side.radius : (touch.end == 1 ? a : b).radius;
        const Real bent = touch.end == 0 ? arcRadius(side) : 0;
        shape.thickness[lane] = corner.radius + radius;
        shape.cornerX[lane] = corner.x;
        shape.cornerY[lane] = corner.y;
        shape.aX[lane] = a.x;
        shape.aY[lane] = a.y;
        shape.bX[lane] = b.x;
        shape.bY[lane] = b.y;
        shape.sameBody[lane] = same ? Real(1) : Real(0);
        const SolverBody& moves = core_.movers.bodies[corner.mover];
        const bool isPoint = moves.inverseMass > 0 && moves.inverseInertia == 0 &&
                             core_.moverIsCluster[corner.mover] == 0;
        shape.free[lane] = isPoint ? Real(1) : Real(0);
        shape.share[lane] = corner.radius / shape.thickness[lane];
        shape.outward[lane] = static_cast<Real>(touch.outward);
        shape.endShare[lane] = touch.end == 2 ? Real(1) : Real(0);
        const Real endless = Real(1e18);
        shape.low[lane] = touch.end == 2 ? Real(1) : touch.end == 1 ? -endless : Real(0);
        shape.high[lane] = touch.end == 1 ? Real(0) : touch.end == 2 ? endless : Real(1);
        if (bent > 0) {
            shape.aX[lane] = side.offset;
            shape.aY[lane] = side.middle;
            shape.bX[lane] = side.offset + side.outX;
            shape.bY[lane] = side.middle + side.outY;
            shape.endShare[lane] = bent;
            shape.high[lane] = std::hypot(b.x - a.x, b.y - a.y) / (2 * bent);
            shape.low[lane] = -shape.high[lane];
        }
        // (By the side, because the corner may be the centre of an arc.)
        const bool ofA = touch.side - b_.firstSide < b_.sides;
        const Chunk &own = ofA ? a_ : b_, &other = ofA ? b_ : a_;
        const Surfaces surface = surfacesOf(state_, touch.corner, own.body, touch.side, other.body);
        block.staticFriction[lane] = surface.staticFriction;
        block.kineticFriction[lane] = surface.kineticFriction;
        block.slip[lane] = -surface.speed * state_.h;
        shape.rolling[lane] = static_cast<float>(surface.rolling);
        core_.rows.markTouch(touch.row);
        pair_.drag = surface.drag;
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

private:
    State& state_;
    ContactCore& core_;
    std::uint32_t index_;
    Pair& pair_;
    const Chunk &a_, &b_;
    std::pmr::vector<std::uint32_t> fresh_{&state_.arena};
};

}  // namespace

void lookAtTouches(State& state, std::uint32_t pair) {
    TouchLook(state, pair).run();
}

void dropTouch(ContactCore& core, std::uint32_t t) {
    const Touch touch = core.touches[t];
    const auto particles = particlesOf(core.shapes, touch.corner, touch.side);
    if (touch.row) {
        const TouchBlock& block = core.rows.touch(touch.row);
        const auto lane = RowGraph::laneOf(touch.row);
        leaveToHeirs(core, particles, block.pressing[lane], block.rubbing[lane]);
        if (core.rows.pressing(core.rows.touches, touch.row))
            addPressing(core, core.pairs[touch.pair].encounter, -1);
        const auto moved = core.rows.removeTouch(core.movers, touch.row);
        if (moved != none) core.touches[moved].row = touch.row;
    } else {
        leaveToHeirs(core, particles, touch.pressing, touch.rubbing);
        if (touch.keptPressing) addPressing(core, core.pairs[touch.pair].encounter, -1);
    }
    core.touches[t] = {};
    core.freeTouches.push_back(t);
}

}  // namespace sulfur::detail
